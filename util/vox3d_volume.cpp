#include "vox3d_volume.h"

#include "utility.h"
#include "volume_view/lookup_file.h"
#include "volume_view/lookup_ramp.h"
#include "vox3d_values.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <set>
#include <sstream>

namespace vo {
namespace {

namespace fs = std::filesystem;

constexpr const char* kProgram = "vox3d";
/// The whole angle that a viewpoint sees.
constexpr double kFieldOfView = 0.6;
constexpr int kLeastTexels = 256, kMostTexels = 16384;
constexpr int kMostSegments = 4096;
/// Of the tables of all segments together.
constexpr int kMostTexelsOfSegments = 1 << 21;

using Color = std::array<double, 3>;

std::string urlOf(const fs::path& path)
{
    static constexpr char kDigits[] = "0123456789ABCDEF";
    std::string url;
    for (const char letter : path.generic_string()) {
        const auto code = static_cast<unsigned char>(letter);
        if (code > ' ' && code < 0x7f &&
            std::string_view("%#?:\"<>\\").find(letter) == std::string_view::npos)
            url += letter;
        else
            url += {'%', kDigits[code / 16], kDigits[code % 16]};
    }
    return url;
}

voDataType dataTypeOf(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: break;
    case ChannelType::int8: return voDataTypeScope::BYTE;
    case ChannelType::uint16: return voDataTypeScope::UNSIGNED_SHORT;
    case ChannelType::int16: return voDataTypeScope::SHORT;
    case ChannelType::float32: return voDataTypeScope::FLOAT;
    }
    return voDataTypeScope::UNSIGNED_BYTE;
}

/// A transfer function: red, green, blue and alpha, from the value 0 of the scene to 1.
using Table = std::vector<float>;

/// Of one of so many tables.
int texelsFor(const VolumeValues& values, double width, int tables)
{
    const double wanted = 256 * (values.scene.high - values.scene.low) / width;
    const int most = std::min(kMostTexels, kMostTexelsOfSegments / tables);
    int texels = kLeastTexels;
    while (texels < wanted && 2 * texels <= most)
        texels *= 2;
    return texels;
}

Table rampTable(const VolumeValues& values, const Vox3dOptions::Ramp& ramp, double opacity, int tables)
{
    const double range = values.scene.high - values.scene.low;
    const int texels = texelsFor(values, ramp.width, tables);
    const double half = range / texels / 2;
    return rampEntries({ramp.center, ramp.width, opacity}, values.scene.low + half, values.scene.high - half,
                       texels, 4);
}

/// A table from a file, spread over all values of 8 bits, or over those that are there.
Table fileTable(const VolumeValues& values, const LookupFile& file, bool isByte, int tables)
{
    const ValueRange range = isByte ? values.scene : values.seen;
    const int texels = texelsFor(values, std::max(range.high - range.low, 1e-30), tables);
    Table table;
    for (int i = 0; i < texels; ++i) {
        const double value = values.scene.low + (values.scene.high - values.scene.low) * (i + 0.5) / texels;
        const double place =
            std::clamp((value - range.low) / std::max(range.high - range.low, 1e-30), 0.0, 1.0) *
            (LookupFile::kEntries - 1);
        const auto below = static_cast<std::size_t>(std::min(std::floor(place), LookupFile::kEntries - 2.0));
        for (std::size_t c = 0; c < 4; ++c)
            table.push_back(
                static_cast<float>(std::lerp(double(file.rgba[4 * below + c]),
                                             double(file.rgba[4 * below + 4 + c]), place - double(below))));
    }
    return table;
}

double fraction(double number)
{
    return number - std::floor(number);
}

/// Of a segment, by its number alone. Hues are a golden section of the circle apart, so that numbers that
/// follow each other look unlike; saturation and brightness go through their ranges as evenly, so that up to
/// kMostSegments no two are the same.
Color segmentColor(int number)
{
    const double hue = 6 * fraction(number * 0.6180339887498949);
    const double saturation = 0.4 + 0.6 * fraction(number * 0.7548776662466927);
    const double brightness = 0.6 + 0.4 * fraction(number * 0.5698402909980532);
    Color color;
    for (std::size_t c = 0; c < 3; ++c) {
        const double turned = std::fmod(hue + 2.0 * (3 - double(c)), 6.0);
        const double pure = std::clamp(std::abs(turned - 3) - 1, 0.0, 1.0);
        color[c] = brightness * (1 - saturation + saturation * pure);
    }
    return color;
}

/// Makes the nodes of one volume.
class SceneMaker
{
public:
    SceneMaker(voX3DScene& scene, const Vox3dOptions& options, const VolumeValues& values)
        : scene_(scene), options_(options), values_(values),
          style_(options.style.empty() ? "opacity" : options.style)
    {
    }

    Result<VolumeScene> make()
    {
        if (!options_.lutFile.empty()) {
            auto read = readLookupFile(options_.lutFile);
            if (!read) return read.failure();
            file_ = *read;
        }
        voxels_ = imageTexture(options_.input, values_);
        std::vector<voX3DNode> roots{navigation(), viewpoint()};
        if (hasLight()) roots.push_back(light());
        if (auto volume = makeVolume()) {
            roots.push_back(*volume);
        } else {
            return volume.failure();
        }
        scene_.setRoots(roots.data(), static_cast<int>(roots.size()));
        tellOfIdleOptions();
        const std::string why = whyNothingIsSeen();
        if (why.empty()) return VolumeScene::seen;
        warn(kProgram, why + ": nothing is seen");
        return VolumeScene::toldEmpty;
    }

private:
    bool is(const char* style) const { return style_ == style; }
    bool isOld() const { return scene_.getEdition() == voX3DScope::PROPOSAL_2005; }
    bool hasLight() const { return is("tone") || is("shaded") || is("iso") || is("composed"); }
    bool hasColors() const { return values_.channels > 1; }

    /// Colours of the file are drawn as they are, and a projection shows values.
    bool hasTable() const { return !hasColors() && !is("projection") && !is("iso"); }

    void tellOfIdleOptions() const
    {
        const std::string style = "with -style " + style_;
        const std::string reason = is("projection")           ? style
                                   : hasColors()              ? "on voxels that have colours"
                                   : options_.lutFile.empty() ? ""
                                   : is("iso")                ? style
                                                              : "beside -lutFile";
        if (options_.lut && !is("iso") && !reason.empty())
            warn(kProgram, "option -lut: changes nothing " + reason);
        if (file_ && !hasTable()) warn(kProgram, "option -lutFile: changes nothing " + reason);
        if (hasLabels() && hasColors() && !is("cartoon") && !is("tone"))
            warn(kProgram, "option -labels: gives no colours to voxels that have colours, and hides those of "
                           "the number 0");
    }

    /// In the file's own values, which the scene's messages do not know.
    std::string whyNothingIsSeen() const
    {
        const auto& [low, high] = values_.seen;
        const std::string found = low < high ? "values from " + numberText(low) + " to " + numberText(high)
                                             : "the value " + numberText(low) + " alone";
        if (is("iso")) {
            const double at = surfaceAt();
            if (low < at && at <= high) return "";
            return options_.lut
                       ? "option -lut: expected a center that voxels are below and above, found " +
                             numberText(at) + " for " + options_.input + " with " + found
                       : options_.input + ": expected values below and above a surface, found " + found;
        }
        if (!hasTable() || !options_.labels.empty() || !isClear(table())) return "";
        if (file_)
            return options_.lutFile + ": expected opacities above 0 for voxels of " + options_.input +
                   ", found none for " + found;
        return options_.lut ? "option -lut: expected values that become opaque from below " +
                                  numberText(high) + " on, found them clear up to " +
                                  numberText(options_.lut->center - options_.lut->width / 2) + ", and " +
                                  options_.input + " with " + found
                            : options_.input + ": expected values that differ, found " + found;
    }

    /// Whether all values that voxels have, and those between, are clear in 8 bits.
    bool isClear(const Table& of) const
    {
        const double count = static_cast<double>(of.size() / 4);
        const double range = std::max(values_.scene.high - values_.scene.low, 1e-30);
        const auto place = [&](double value) { return (value - values_.scene.low) / range * count - 0.5; };
        const auto first =
            static_cast<std::size_t>(std::clamp(std::floor(place(values_.seen.low)), 0.0, count - 1));
        const auto last =
            static_cast<std::size_t>(std::clamp(std::ceil(place(values_.seen.high)), 0.0, count - 1));
        for (std::size_t i = first; i <= last; ++i)
            if (std::lround(255 * of[4 * i + 3]) > 0) return false;
        return true;
    }

    /// The value of the file that -style iso has a surface of.
    double surfaceAt() const { return options_.lut ? options_.lut->center : values_.threshold; }

    voX3DNode node(const char* type) { return scene_.createNode(type); }

    static void setColor(voX3DNode node, const char* field, const Color& color)
    {
        const float numbers[3] = {float(color[0]), float(color[1]), float(color[2])};
        node.setFloats(field, numbers, 3);
    }

    /// Of a file whose voxels the scene need not read again where they are at hand.
    voX3DNode imageTexture(const std::string& path, const VolumeValues& values)
    {
        voX3DNode texture = node("ImageTexture3D");
        const std::string url = urlOf(fs::absolute(path));
        const char* const text = url.c_str();
        texture.setStrings("url", &text, 1);
        if (values.voxels.bytes().empty()) return texture;
        int size[3];
        std::ranges::transform(values.size, size, [](std::int64_t each) { return static_cast<int>(each); });
        scene_.setReadVoxels(texture, values.voxels.bytes().data(), size, values.channels,
                             values.alphaAdded ? 3 : values.channels, dataTypeOf(values.type));
        return texture;
    }

    /// Volumes of one value look like surfaces where styles ask for normals, and like fog otherwise.
    Table table() const
    {
        if (file_) return fileTable(values_, *file_, values_.scene.high == 255, tables_);
        const bool isFog = is("opacity") || is("projection") || is("stipple") || is("boundary");
        Vox3dOptions::Ramp ramp{(values_.threshold + values_.high) / 2,
                                std::max(values_.high - values_.threshold, 1e-30)};
        if (!isFog) ramp = {values_.threshold, ramp.width / 4};
        if (options_.lut) ramp = *options_.lut;
        return rampTable(values_, ramp, isFog ? std::min(1.0, fogOpacity()) : 0.9, tables_);
    }

    /// Of a voxel of the highest values. A boundary is a small part of what lies on the way.
    double fogOpacity() const
    {
        const auto longest = double(*std::ranges::max_element(values_.size));
        return (is("boundary") ? 40 : 3) * sliceOpacity(1, longest);
    }

    voX3DNode transferFunction(const Color& tint)
    {
        Table of = table();
        for (std::size_t i = 0; i < of.size(); ++i)
            if (i % 4 < 3) of[i] *= static_cast<float>(tint[i % 4]);
        std::vector<int> image{static_cast<int>(of.size() / 4), 1, 4};
        for (std::size_t i = 0; i < of.size(); i += 4) {
            std::uint32_t pixel = 0;
            for (std::size_t c = 0; c < 4; ++c)
                pixel = pixel * 256 + static_cast<std::uint32_t>(std::lround(255 * of[i + c]));
            image.push_back(static_cast<int>(pixel));
        }
        voX3DNode texture = node("PixelTexture"), map = node("OpacityMapVolumeStyle");
        texture.setInts("image", image.data(), static_cast<int>(image.size()));
        texture.setInt("repeatS", 0);
        texture.setInt("repeatT", 0);
        map.setNode("transferFunction", texture);
        return map;
    }

    voX3DNode composed(const std::vector<voX3DNode>& styles)
    {
        voX3DNode list = node(isOld() ? "CompositeVolumeStyle" : "ComposedVolumeStyle");
        if (isOld()) list.setInt("ordered", 1);
        list.setNodes(isOld() ? "styles" : "renderStyle", styles.data(), static_cast<int>(styles.size()));
        return list;
    }

    /// The style that the options name, behind the colours of a tint.
    voX3DNode renderStyle(const Color& tint)
    {
        if (is("projection")) return node("ProjectionVolumeStyle");
        std::vector<voX3DNode> styles;
        if (!hasColors()) styles.push_back(transferFunction(tint));
        addNamed(styles, tint);
        if (styles.empty()) return node("OpacityMapVolumeStyle");
        return styles.size() == 1 ? styles.front() : composed(styles);
    }

    void addNamed(std::vector<voX3DNode>& styles, const Color& tint)
    {
        if (is("boundary")) styles.push_back(boundary());
        if (is("cartoon")) styles.push_back(cartoon(tint));
        if (is("edge") || is("composed")) styles.push_back(edge());
        if (is("silhouette") || is("composed")) styles.push_back(silhouette());
        if (is("tone")) styles.push_back(tone(tint));
        if (is("shaded") || is("composed")) styles.push_back(shaded());
        if (is("stipple")) styles.push_back(node("StippleVolumeStyle"));
        if (is("blended")) styles.push_back(blended());
    }

    voX3DNode boundary()
    {
        voX3DNode style = node("BoundaryEnhancementVolumeStyle");
        style.setFloat("retainedOpacity", 0.05f);
        style.setFloat("boundaryOpacity", 1);
        style.setFloat("opacityFactor", 1);
        return style;
    }

    voX3DNode edge()
    {
        voX3DNode style = node("EdgeEnhancementVolumeStyle");
        style.setFloat("gradientThreshold", 0.8f);
        return style;
    }

    voX3DNode silhouette()
    {
        voX3DNode style = node("SilhouetteEnhancementVolumeStyle");
        style.setFloat("silhouetteRetainedOpacity", is("composed") ? 0.5f : 0.02f);
        style.setFloat("silhouetteBoundaryOpacity", is("composed") ? 0.5f : 0.6f);
        style.setFloat("silhouetteSharpness", 3);
        return style;
    }

    bool hasLabels() const { return !options_.labels.empty(); }

    static void setOpaqueColor(voX3DNode style, const char* field, const Color& color)
    {
        const float numbers[4] = {float(color[0]), float(color[1]), float(color[2]), 1};
        style.setFloats(field, numbers, 4);
    }

    /// Its colours replace those of the voxels, so a label's tint is in them: where the voxels face the eye,
    /// and darker where they do not, which keeps its hue.
    voX3DNode cartoon(const Color& tint)
    {
        constexpr double kDark = 0.2;
        voX3DNode style = node("CartoonVolumeStyle");
        if (!hasLabels()) return style;
        setOpaqueColor(style, "orthogonalColor", tint);
        setOpaqueColor(style, "parallelColor", {kDark * tint[0], kDark * tint[1], kDark * tint[2]});
        return style;
    }

    /// Its colours, too, replace those of the voxels: labels have a part of their tint in both.
    voX3DNode tone(const Color& tint)
    {
        const double inCool = hasLabels() ? 0.4 : 0, inWarm = hasLabels() ? 0.7 : 0;
        Color cool{0.1, 0.15, 0.5}, warm{1, 0.85, 0.6};
        for (std::size_t c = 0; c < 3; ++c) {
            cool[c] = std::lerp(cool[c], tint[c] / 2, inCool);
            warm[c] = std::lerp(warm[c], tint[c], inWarm);
        }
        voX3DNode style = node("ToneMappedVolumeStyle");
        setOpaqueColor(style, "coolColor", cool);
        setOpaqueColor(style, "warmColor", warm);
        return style;
    }

    voX3DNode shaded()
    {
        voX3DNode style = node("ShadedVolumeStyle");
        style.setInt("lighting", 1);
        return style;
    }

    /// Opaque ivory, whatever the value is.
    voX3DNode surface()
    {
        const int image[4] = {1, 1, 3, 0xe6d9bf};
        voX3DNode texture = node("PixelTexture"), map = node("OpacityMapVolumeStyle");
        texture.setInts("image", image, 4);
        map.setNode("transferFunction", texture);
        return composed({map, shaded()});
    }

    /// Half the style's colours, half those of a cartoon of the same voxels.
    voX3DNode blended()
    {
        voX3DNode style = node("BlendedVolumeStyle");
        style.setNode("renderStyle", composed({transferFunction({1, 1, 1}), node("CartoonVolumeStyle")}));
        style.setNode("voxels", voxels_);
        return style;
    }

    void setDimensions(voX3DNode volume)
    {
        float numbers[3];
        for (std::size_t i = 0; i < 3; ++i)
            numbers[i] = static_cast<float>(extent(i));
        volume.setFloats("dimensions", numbers, 3);
    }

    double extent(std::size_t axis) const
    {
        return values_.spacing[axis] * static_cast<double>(values_.size[axis]);
    }

    Result<voX3DNode> makeVolume()
    {
        if (!options_.labels.empty()) return segmented();
        voX3DNode volume = node(is("iso") ? "IsoSurfaceVolumeData" : "VolumeData");
        setDimensions(volume);
        isOld() ? volume.setNodes("voxels", &voxels_, 1) : volume.setNode("voxels", voxels_);
        if (!is("iso")) {
            volume.setNode("renderStyle", renderStyle({1, 1, 1}));
            return volume;
        }
        const double range = std::max(values_.scene.high - values_.scene.low, 1e-30);
        const auto value = static_cast<float>((surfaceAt() - values_.scene.low) / range);
        volume.setFloats("surfaceValues", &value, 1);
        const voX3DNode style = surface();
        volume.setNodes("renderStyle", &style, 1);
        return volume;
    }

    Result<voX3DNode> segmented()
    {
        if (is("iso") || is("projection") || is("stipple"))
            return Failure{"option -labels: expected a style that segments have, found -style " + style_};
        const auto labels = lookAtLabels(kProgram, options_.labels, kMostSegments);
        if (!labels) return labels.failure();
        const VolumeValues* const numbers = &labels->values;
        if (numbers->size != values_.size)
            return Failure{options_.labels + ": expected " + sizeText(values_.size) + " voxels as in " +
                           options_.input + ", found " + sizeText(numbers->size)};
        if (numbers->fractions > 0)
            return Failure{options_.labels + ": expected whole numbers of segments, found " +
                           numberText(numbers->firstFraction) +
                           (numbers->fractions > 1
                                ? " and " + std::to_string(numbers->fractions - 1) + " more that are none"
                                : "")};
        if (numbers->seen.low < 0 || numbers->seen.high > kMostSegments)
            return Failure{options_.labels + ": expected numbers of segments from 0 to " +
                           std::to_string(kMostSegments) + ", found " +
                           std::to_string(int(numbers->seen.low)) + " to " +
                           std::to_string(int(numbers->seen.high))};
        return segmentedBy(*labels);
    }

    /// Segments of the numbers that are there; the others, and 0, are not drawn.
    voX3DNode segmentedBy(const LabelValues& labels)
    {
        std::vector<int> isThere = labels.isThere;
        isThere[0] = 0;
        tables_ = std::max(1, static_cast<int>(std::ranges::count(isThere, 1)));
        const auto count = static_cast<int>(isThere.size());
        const voX3DNode none = node("OpacityMapVolumeStyle");
        std::vector<voX3DNode> styles;
        for (int i = 0; i < count; ++i)
            styles.push_back(isThere[static_cast<std::size_t>(i)] ? renderStyle(segmentColor(i)) : none);
        voX3DNode volume = node("SegmentedVolumeData");
        setDimensions(volume);
        volume.setNode("voxels", voxels_);
        volume.setNode("segmentIdentifiers", imageTexture(options_.labels, labels.values));
        volume.setInts("segmentEnabled", isThere.data(), count);
        volume.setNodes("renderStyle", styles.data(), count);
        return volume;
    }

    static std::string numberText(double number)
    {
        char text[40];
        return {text, std::to_chars(text, text + sizeof text, static_cast<float>(number)).ptr};
    }

    /// The eye's axes in the world as a quaternion, for the same view as voglBasic has: by longitude about z
    /// after 90 + latitude about x.
    std::array<double, 4> eyeTurn() const
    {
        constexpr double kDegree = std::numbers::pi / 180;
        const double longitude = options_.view ? (*options_.view)[1] : values_.isOriented ? 180 : 0;
        const double latitude = options_.view ? (*options_.view)[0] : 0;
        const double z = longitude * kDegree / 2, x = (90 + latitude) * kDegree / 2;
        return {std::cos(z) * std::cos(x), std::cos(z) * std::sin(x), std::sin(z) * std::sin(x),
                std::sin(z) * std::cos(x)};
    }

    /// A vector of eye space in the world.
    static Color turned(const std::array<double, 4>& q, const Color& v)
    {
        const auto cross = [](const Color& a, const Color& b) {
            return Color{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
        };
        const Color axis{q[1], q[2], q[3]}, once = cross(axis, v), twice = cross(axis, once);
        Color to;
        for (std::size_t i = 0; i < 3; ++i)
            to[i] = v[i] + 2 * (q[0] * once[i] + twice[i]);
        return to;
    }

    /// From where all of the box is seen, in a picture of any proportions.
    double distance(const std::array<double, 4>& eye) const
    {
        const std::array<double, 4> back{eye[0], -eye[1], -eye[2], -eye[3]};
        const double slope = std::tan(kFieldOfView / 2) * 0.95;
        double most = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const Color at =
                turned(back, {extent(0) * (corner & 1 ? 0.5 : -0.5), extent(1) * (corner & 2 ? 0.5 : -0.5),
                              extent(2) * (corner & 4 ? 0.5 : -0.5)});
            most = std::max(most, at[2] + std::max(std::abs(at[0]), std::abs(at[1])) / slope);
        }
        return most;
    }

    voX3DNode viewpoint()
    {
        const auto q = eyeTurn();
        const double sine = std::hypot(q[1], q[2], q[3]);
        const double divisor = sine > 1e-12 ? sine : 1;
        const float orientation[4] = {float(q[1] / divisor), float(q[2] / divisor),
                                      float(sine > 1e-12 ? q[3] / divisor : 1),
                                      float(2 * std::atan2(sine, q[0]))};
        voX3DNode viewpoint = node("Viewpoint");
        viewpoint.setFloats("orientation", orientation, 4);
        setColor(viewpoint, "position", turned(q, {0, 0, distance(q)}));
        viewpoint.setFloat("fieldOfView", float(kFieldOfView));
        viewpoint.setString("description", "All");
        return viewpoint;
    }

    voX3DNode navigation()
    {
        voX3DNode info = node("NavigationInfo");
        if (hasLight()) info.setInt("headlight", 0);
        return info;
    }

    /// From the upper left behind the viewer.
    voX3DNode light()
    {
        voX3DNode sun = node("DirectionalLight");
        setColor(sun, "direction", turned(eyeTurn(), {0.5, -0.5, -0.7}));
        sun.setFloat("ambientIntensity", 0.3f);
        return sun;
    }

    voX3DScene& scene_;
    const Vox3dOptions& options_;
    const VolumeValues& values_;
    std::string style_;
    std::optional<LookupFile> file_;
    voX3DNode voxels_;
    int tables_ = 1; ///< that the scene has
};

/// Calls a function with each node that has a url, once for each place.
void eachUrl(const voX3DNode& node, const std::function<void(voX3DNode)>& take)
{
    for (int i = 0; i < node.getFieldCount(); ++i) {
        const char* const field = node.getFieldName(i);
        const auto type = node.getFieldType(field);
        if (std::string_view(field) == "url" && node.getCount(field) > 0) take(node);
        if (type != voX3DScope::SF_NODE && type != voX3DScope::MF_NODE) continue;
        for (int k = 0; k < node.getCount(field); ++k)
            eachUrl(node.getNode(field, k), take);
    }
}

/// A volume that is larger or smaller than scenes can be has voxels of length 1.
void fitSpacing(const std::string& path, VolumeValues& values)
{
    constexpr double kLeast = 1e-15, kMost = 1e15;
    for (std::size_t i = 0; i < 3; ++i) {
        const double length = values.spacing[i] * static_cast<double>(values.size[i]);
        if (length >= kLeast && length <= kMost) continue;
        std::ostringstream text;
        text << path << ": expected edges from 1e-15 to 1e15 long, found voxels " << values.spacing[i]
             << " apart: taken as 1";
        warn(kProgram, text.str());
        values.spacing = {1, 1, 1};
        return;
    }
}

} // namespace

bool isScene(const std::string& path)
{
    char begin[64] = {};
    std::streamsize count = 0;
    // Opening a pipe would wait for whoever writes.
    if (std::error_code unknown; std::filesystem::is_regular_file(path, unknown)) {
        std::ifstream file(path, std::ios::binary);
        file.read(begin, sizeof begin);
        count = file.gcount();
    }
    std::string_view text(begin, static_cast<std::size_t>(count));
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())))
        text.remove_prefix(1);
    if (text.starts_with('<') || text.starts_with("#X3D") || text.starts_with("#VRML")) return true;
    const auto named = [&path](const char* ending) { return path.ends_with(ending); };
    return std::ranges::any_of(std::array{".x3d", ".x3dv", ".wrl", ".x3dz", ".x3dvz", ".x3d.gz", ".x3dv.gz"},
                               named);
}

Result<VolumeScene> makeVolumeScene(voX3DScene& scene, const Vox3dOptions& options)
{
    // Only the proposal of 2005 has points in place of voxels.
    const std::string empty = std::string("<X3D profile='Full' version='") +
                              (options.style == "stipple" ? "3.0" : "4.0") + "'><Scene/></X3D>";
    for (const std::string& path : {options.input, options.labels}) {
        if (!path.empty()) scene.allowFolder(fs::absolute(path).parent_path().c_str());
    }
    if (!scene.readText(empty.data(), empty.size(), options.input.c_str()))
        return Failure{options.input + ": " + scene.getMessage(0)};
    auto values = lookAtVolume(kProgram, options.input);
    if (!values) return values.failure();
    fitSpacing(options.input, *values);
    return SceneMaker(scene, options, *values).make();
}

std::set<std::string> makeUrlsRelative(voX3DScene& scene, const std::string& output)
{
    const fs::path folder = fs::absolute(output).parent_path();
    std::set<std::string> outside;
    for (int i = 0; i < scene.getRootCount(); ++i)
        eachUrl(scene.getRoot(i), [&](voX3DNode node) {
            const char* const path = node.getPath("url");
            if (!path) return;
            std::error_code none;
            const fs::path base = fs::canonical(folder, none);
            const fs::path relative = fs::path(path).lexically_relative(none ? folder : base);
            if (relative.empty()) return;
            if (*relative.begin() == "..") outside.insert(fs::path(path).parent_path().string());
            const std::string url = urlOf(relative);
            const char* const text = url.c_str();
            node.setStrings("url", &text, 1);
        });
    return outside;
}

} // namespace vo
