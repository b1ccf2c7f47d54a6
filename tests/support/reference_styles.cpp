#include "support/reference_styles.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace vo::test {

namespace {

using glm::dvec3;
using glm::dvec4;

std::vector<std::pair<std::shared_ptr<const Style>, ReferenceStyle>>& knownStyles()
{
    static std::vector<std::pair<std::shared_ptr<const Style>, ReferenceStyle>> known;
    return known;
}

double texelValue(const VoxelTexture& texture, int x, int y, int z, int component)
{
    const auto index = (static_cast<std::size_t>(z) * static_cast<std::size_t>(texture.size.y) +
                        static_cast<std::size_t>(y)) *
                           static_cast<std::size_t>(texture.size.x) +
                       static_cast<std::size_t>(x);
    const std::byte* at = texture.texels.data() + (index * static_cast<std::size_t>(texture.components) +
                                                   static_cast<std::size_t>(component)) *
                                                      bytesOf(texture.kind);
    if (texture.kind == TexelKind::uint8) return static_cast<double>(std::to_integer<int>(*at)) / 255.0;
    if (texture.kind == TexelKind::uint16) {
        std::uint16_t value = 0;
        std::memcpy(&value, at, sizeof value);
        return static_cast<double>(value) / 65535.0;
    }
    float value = 0.0f;
    std::memcpy(&value, at, sizeof value);
    return static_cast<double>(value);
}

int wrapped(int texel, int size, bool repeats)
{
    return repeats ? ((texel % size) + size) % size : std::clamp(texel, 0, size - 1);
}

struct Weighted
{
    int texel;
    double weight;
};

/// The texels that count at a place along one axis: two, or the nearest. No list: they are asked for many
/// times a sample, and what is allocated is checked under sanitizers.
struct TexelWeights
{
    std::array<Weighted, 2> texels;
    int count;

    const Weighted* begin() const { return texels.data(); }
    const Weighted* end() const { return texels.data() + count; }
};

TexelWeights weightsAlong(const VoxelTexture& texture, const TextureReading& reading, int axis, double place)
{
    const int size = texture.size[axis];
    const bool repeats = reading.repeats[static_cast<std::size_t>(axis)];
    if (reading.nearest)
        return {{{{wrapped(static_cast<int>(std::floor(place * size)), size, repeats), 1.0}, {}}}, 1};
    const double at = place * size - 0.5;
    const int low = static_cast<int>(std::floor(at));
    const double above = at - low;
    return {{{{wrapped(low, size, repeats), 1.0 - above}, {wrapped(low + 1, size, repeats), above}}}, 2};
}

double valueOf(const VoxelTexture& voxels, const dvec3& place)
{
    const dvec4 texel = referenceTexel(voxels, place);
    return voxels.components < 3 ? texel.r : (texel.r + texel.g + texel.b) / 3.0;
}

dvec3 normalFor(const TexturePointer& normals, const ReferenceSample& sample)
{
    if (!normals || normals->components < 3) return sample.n;
    return referenceNormal(referenceTexel(*normals, sample.place));
}

/// x^y with 0^0 = 1.
double power(double base, double exponent)
{
    return exponent == 0.0 ? 1.0 : base <= 0.0 ? 0.0 : std::pow(base, exponent);
}

dvec3 toLight(const StyleLight& light, const dvec3& position)
{
    if (light.kind == StyleLight::Kind::directional) return -dvec3(light.direction);
    const dvec3 way = dvec3(light.position) - position;
    return glm::length(way) > 0.0 ? glm::normalize(way) : dvec3(0.0);
}

double shineOf(const StyleLight& light, const dvec3& position)
{
    if (light.kind == StyleLight::Kind::directional) return 1.0;
    const double d = glm::distance(dvec3(light.position), position);
    if (d > static_cast<double>(light.radius)) return 0.0;
    const dvec3 a(light.attenuation);
    const double attenuation = 1.0 / std::max(a.x + a.y * d + a.z * d * d, 1.0);
    if (light.kind == StyleLight::Kind::point) return attenuation;
    const double cosine = glm::dot(-toLight(light, position), dvec3(light.direction));
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0));
    const double cutOff = static_cast<double>(light.cutOffAngle);
    const double beam = static_cast<double>(light.beamWidth);
    if (angle >= cutOff) return 0.0;
    return angle <= beam ? attenuation : attenuation * (angle - cutOff) / (beam - cutOff);
}

// Hue in turns, saturation, value.
dvec3 hsvOf(const dvec3& c)
{
    const double value = std::max({c.r, c.g, c.b});
    const double range = value - std::min({c.r, c.g, c.b});
    if (range == 0.0) return {0.0, 0.0, value};
    const double sixth = value == c.r   ? (c.g - c.b) / range
                         : value == c.g ? 2.0 + (c.b - c.r) / range
                                        : 4.0 + (c.r - c.g) / range;
    return {sixth < 0.0 ? sixth / 6.0 + 1.0 : sixth / 6.0, range / value, value};
}

dvec3 rgbOf(const dvec3& hsv)
{
    const double hue = (hsv.x - std::floor(hsv.x)) * 6.0;
    const int sector = std::min(static_cast<int>(hue), 5);
    const double f = hue - sector;
    const double v = hsv.z;
    const double p = v * (1.0 - hsv.y);
    const double q = v * (1.0 - hsv.y * f);
    const double t = v * (1.0 - hsv.y * (1.0 - f));
    const std::array<dvec3, 6> colors{dvec3(v, t, p), dvec3(q, v, p), dvec3(p, v, t),
                                      dvec3(p, q, v), dvec3(t, p, v), dvec3(v, p, q)};
    return colors.at(static_cast<std::size_t>(sector));
}

dvec4 mixedInHsv(const dvec4& from, const dvec4& to, double part)
{
    dvec3 a = hsvOf(dvec3(from));
    dvec3 b = hsvOf(dvec3(to));
    if (a.y == 0.0) a.x = b.x;
    if (b.y == 0.0) b.x = a.x;
    double turn = b.x - a.x;
    turn -= turn > 0.5 ? 1.0 : turn < -0.5 ? -1.0 : 0.0;
    const dvec3 hsv(a.x + turn * part, a.y + (b.y - a.y) * part, a.z + (b.z - a.z) * part);
    return {rgbOf(hsv), from.a + (to.a - from.a) * part};
}

void step(const OpacityMap& style, const StyleSurroundings&, ReferenceSample& sample)
{
    if (!style.transferFunction) {
        referenceFirstColor(style.voxelComponents, sample);
        if (style.opaqueAtZero) sample.Ov = 1.0 - sample.Ov;
        return;
    }
    const VoxelTexture& function = *style.transferFunction;
    dvec3 place(0.0);
    for (int axis = 0; axis < std::min(style.voxelComponents, 3); ++axis)
        place[axis] = std::clamp(sample.voxel[axis], 0.0, 1.0);
    const dvec4 texel = referenceTexel(function, place, {{}, function.nearest});
    switch (function.components) {
    case 1: sample.Cv = dvec3(texel.r), sample.Ov = 1.0; break;
    case 2: sample.Cv = dvec3(texel.r), sample.Ov = texel.g; break;
    case 3: sample.Cv = dvec3(texel), sample.Ov = 1.0; break;
    default: sample.Cv = dvec3(texel), sample.Ov = texel.a;
    }
    if (style.voxelComponents == 4) sample.Ov *= sample.voxel.a;
}

void step(const BoundaryEnhancement& style, const StyleSurroundings&, ReferenceSample& sample)
{
    const double kgc = static_cast<double>(style.retainedOpacity);
    const double kgs = static_cast<double>(style.boundaryOpacity);
    const double kge = static_cast<double>(style.opacityFactor);
    sample.Ov = std::min(1.0, sample.Ov * (kgc + kgs * power(sample.gradient, kge)));
}

void step(const Cartoon& style, const StyleSurroundings&, ReferenceSample& sample)
{
    const dvec3 n = normalFor(style.surfaceNormals, sample);
    const double cosine = glm::dot(n, sample.V);
    sample.Cv = dvec3(0.0);
    if (n == dvec3(0.0) || cosine < 0.0) {
        sample.Ov = 0.0;
        return;
    }
    const double width = std::numbers::pi / 2 / style.colorSteps;
    const double angle = std::acos(std::min(cosine, 1.0));
    const int part = std::min(static_cast<int>(angle / width), style.colorSteps - 1);
    const dvec4 facing(style.orthogonalColor);
    const dvec4 rim(style.parallelColor);
    const double middle = (part + 0.5) * width / (std::numbers::pi / 2);
    const dvec4 color = part == 0                      ? facing
                        : part == style.colorSteps - 1 ? rim
                                                       : mixedInHsv(facing, rim, middle);
    sample.Cv = dvec3(color);
    sample.Ov *= color.a;
}

void step(const EdgeEnhancement& style, const StyleSurroundings&, ReferenceSample& sample)
{
    const dvec3 n = normalFor(style.surfaceNormals, sample);
    const double cosine = std::abs(glm::dot(n, sample.V));
    if (n == dvec3(0.0) || cosine >= std::cos(static_cast<double>(style.gradientThreshold))) return;
    sample.Cv = sample.Cv * cosine + dvec3(style.edgeColor) * (1.0 - cosine);
}

void step(const SilhouetteEnhancement& style, const StyleSurroundings&, ReferenceSample& sample)
{
    const dvec3 n = normalFor(style.surfaceNormals, sample);
    const double cosine = n == dvec3(0.0) ? 1.0 : std::abs(glm::dot(n, sample.V));
    const double ksc = static_cast<double>(style.retainedOpacity);
    const double kss = static_cast<double>(style.boundaryOpacity);
    const double rim = power(1.0 - cosine, static_cast<double>(style.sharpness));
    sample.Ov = std::min(1.0, sample.Ov * (ksc + kss * rim));
}

void step(const ToneMapped& style, const StyleSurroundings& surroundings, ReferenceSample& sample)
{
    const dvec3 n = normalFor(style.surfaceNormals, sample);
    dvec3 sum(0.0);
    for (const StyleLight& light : surroundings.lights) {
        const double cc = (1.0 + glm::dot(toLight(light, sample.position), n)) * 0.5;
        sum += cc * dvec3(style.warmColor) + (1.0 - cc) * dvec3(style.coolColor);
    }
    sample.Cv = glm::min(sum, dvec3(1.0));
}

/// Of textures that the style has, else as it is known of the sample.
std::vector<double> throughOf(const Shaded& style, const ReferenceSample& sample)
{
    if (!style.shadows) return {};
    const auto& [textures, box] = style.shadowTextures;
    if (textures.empty()) return sample.lightThrough;
    const dvec3 place = (sample.position - dvec3(box.low)) / dvec3(box.sides);
    std::vector<double> through;
    for (const TexturePointer& texture : textures)
        for (int c = 0; c < texture->components; ++c)
            through.push_back(referenceTexel(*texture, place)[c]);
    return through;
}

void step(const Shaded& style, const StyleSurroundings& surroundings, ReferenceSample& sample)
{
    const dvec3 diffuse = style.hasMaterial ? dvec3(style.diffuse) : sample.Cv;
    sample.Ov *= 1.0 - static_cast<double>(style.transparency);
    sample.Cv = diffuse;
    if (!style.lighting) return;
    const ReferenceMaterial material{diffuse, dvec3(style.emissive), dvec3(style.specular),
                                     static_cast<double>(style.ambientIntensity),
                                     static_cast<double>(style.shininess)};
    sample.Cv = referenceLit(material, surroundings.lights, sample.position,
                             normalFor(style.surfaceNormals, sample), sample.V, throughOf(style, sample));
}

double blendWeight(Blended::Weight function, float constant, const TexturePointer& table, double Ov,
                   double Ob, double first, double second)
{
    switch (function) {
    case Blended::Weight::constant: return static_cast<double>(constant);
    case Blended::Weight::alpha0: return Ov;
    case Blended::Weight::alpha1: return Ob;
    case Blended::Weight::oneMinusAlpha0: return 1.0 - Ov;
    case Blended::Weight::oneMinusAlpha1: return 1.0 - Ob;
    case Blended::Weight::table: break;
    }
    if (!table) return static_cast<double>(constant);
    return referenceTexel(*table, {first, second, 0.0}, {{}, table->nearest}).r;
}

void step(const Blended& style, const StyleSurroundings& surroundings, ReferenceSample& sample)
{
    if (!style.voxels) return;
    const VoxelTexture& voxels = *style.voxels;
    ReferenceSample other = sample;
    other.voxel = referenceTexel(voxels, sample.place);
    const dvec3 size(style.dimensions);
    const glm::dmat3 placeFromLocal(dvec3(1.0 / size.x, 0, 0), dvec3(0, 1.0 / size.y, 0),
                                    dvec3(0, 0, 1.0 / size.z));
    setNormal(referenceGradient(voxels, size, sample.place, placeFromLocal), other);
    referenceFirstColor(voxels.components, other);
    referenceChain(style.chain, surroundings, other);
    const double Ov = sample.Ov;
    const double Ob = other.Ov;
    const double w1 = blendWeight(style.weightFunction1, style.weightConstant1, style.weightTransferFunction1,
                                  Ov, Ob, Ov, Ob);
    const double w2 = blendWeight(style.weightFunction2, style.weightConstant2, style.weightTransferFunction2,
                                  Ov, Ob, Ob, Ov);
    sample.Cv = glm::clamp(sample.Cv * w1 + other.Cv * w2, dvec3(0.0), dvec3(1.0));
    sample.Ov = std::clamp(Ov * w1 + Ob * w2, 0.0, 1.0);
}

} // namespace

std::shared_ptr<const Style> styleWithReference(const ReferenceStyle& fields)
{
    const auto style = std::visit([](const auto& each) { return makeStyle(each); }, fields);
    knownStyles().emplace_back(style, fields);
    return style;
}

void referenceFirstColor(int components, ReferenceSample& sample)
{
    const dvec4& voxel = sample.voxel;
    sample.Cv = components < 3 ? dvec3(voxel.r) : dvec3(voxel);
    sample.Ov = components == 1   ? voxel.r
                : components == 2 ? voxel.g
                : components == 3 ? (voxel.r + voxel.g + voxel.b) / 3.0
                                  : voxel.a;
}

void referenceStep(const ReferenceStyle& style, const StyleSurroundings& surroundings,
                   ReferenceSample& sample)
{
    std::visit([&](const auto& fields) { step(fields, surroundings, sample); }, style);
}

void referenceChain(const StyleChain& chain, const StyleSurroundings& surroundings, ReferenceSample& sample)
{
    for (const auto& style : chain) {
        const auto& known = knownStyles();
        const auto found =
            std::find_if(known.begin(), known.end(), [&](const auto& each) { return each.first == style; });
        if (found == known.end()) throw std::invalid_argument("a style that styleWithReference did not make");
        referenceStep(found->second, surroundings, sample);
    }
}

dvec4 referenceTexel(const VoxelTexture& texture, const dvec3& place)
{
    return referenceTexel(texture, place, {texture.repeats, texture.nearest});
}

dvec4 referenceTexel(const VoxelTexture& texture, const dvec3& place, const TextureReading& reading)
{
    dvec4 sum(0.0);
    const TexelWeights along = weightsAlong(texture, reading, 0, place.x);
    const TexelWeights across = weightsAlong(texture, reading, 1, place.y);
    for (const Weighted& z : weightsAlong(texture, reading, 2, place.z))
        for (const Weighted& y : across)
            for (const Weighted& x : along)
                for (int c = 0; c < texture.components; ++c)
                    sum[c] +=
                        x.weight * y.weight * z.weight * texelValue(texture, x.texel, y.texel, z.texel, c);
    return sum;
}

dvec3 referenceNormal(const dvec4& texel)
{
    const dvec3 direction = 2.0 * dvec3(texel) - 1.0;
    return glm::length(direction) < 0.01 ? dvec3(0.0) : glm::normalize(direction);
}

dvec3 referenceGradient(const VoxelTexture& voxels, const dvec3& dimensions, const dvec3& place,
                        const glm::dmat3& placeFromLocal)
{
    dvec3 perPlace(0.0);
    double shortest = dimensions.x / voxels.size.x;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 voxel(0.0);
        voxel[axis] = 1.0 / voxels.size[axis];
        perPlace[axis] =
            (valueOf(voxels, place + voxel) - valueOf(voxels, place - voxel)) / 2.0 / voxel[axis];
        shortest = std::min(shortest, dimensions[axis] / voxels.size[axis]);
    }
    return shortest * (glm::transpose(placeFromLocal) * perPlace);
}

void setNormal(const dvec3& gradient, ReferenceSample& sample)
{
    sample.gradient = glm::length(gradient);
    sample.n = sample.gradient < 1e-6 ? dvec3(0.0) : -gradient / sample.gradient;
}

dvec3 referenceLit(const ReferenceMaterial& material, const std::vector<StyleLight>& lights,
                   const dvec3& position, const dvec3& n, const dvec3& V, const std::vector<double>& through)
{
    dvec3 sum = material.emissive;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const StyleLight& light = lights[i];
        const double T = i < through.size() ? through[i] : 1.0;
        const dvec3 L = toLight(light, position);
        const dvec3 between = L + V;
        const dvec3 H = glm::length(between) > 0.0 ? glm::normalize(between) : dvec3(0.0);
        const double nH = glm::dot(n, H);
        const double I = static_cast<double>(light.intensity);
        const double Ia = static_cast<double>(light.ambientIntensity);
        const dvec3 ambient = Ia * material.ambientIntensity * material.diffuse;
        const dvec3 diffuse = I * std::max(glm::dot(n, L), 0.0) * material.diffuse;
        const double highlight = nH > 0.0 ? std::pow(nH, 128.0 * material.shininess) : 0.0;
        sum += shineOf(light, position) * dvec3(light.color) *
               (ambient + T * (diffuse + I * highlight * material.specular));
    }
    return glm::min(sum, dvec3(1.0));
}

dvec3 referenceWayTo(const StyleLight& light, const dvec3& position)
{
    return toLight(light, position);
}

} // namespace vo::test
