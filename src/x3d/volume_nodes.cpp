#include "x3d/volume_nodes.h"

#include "x3d/fixed_opacity.h"
#include "x3d/node_lights.h"
#include "x3d/node_values.h"
#include "x3d/plane_spacing.h"
#include "x3d/printable_word.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vo {
namespace {

constexpr std::size_t kMostSurfaces = 256;

double shortestEdge(const StyledVolume& volume)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis)
        shortest =
            std::min(shortest, static_cast<double>(volume.dimensions[axis]) / volume.voxels->size[axis]);
    return shortest;
}

} // namespace

ViewBox volumeBox(const Node& node)
{
    const glm::dvec3 half = glm::dvec3(vec3Of(node, "dimensions", glm::vec3(1.0f))) / 2.0;
    ViewBox box;
    if (half.x > 0.0 && half.y > 0.0 && half.z > 0.0) {
        box.add(-half);
        box.add(half);
    }
    return box;
}

std::optional<StyledVolume> VolumeNodes::of(const ShownNode& shown, const StyledScene& scene,
                                            const std::optional<double>& sampling)
{
    const Node& node = *shown.node;
    StyledVolume volume;
    volume.worldFromLocal = shown.worldFromLocal;
    volume.dimensions = vec3Of(node, "dimensions", glm::vec3(1.0f));
    if (volumeBox(node).isEmpty()) {
        messages_.warn(node, node.typeName() + ".dimensions: expected numbers above 0, found 0: not drawn");
        return {};
    }
    if (!fill(node, volume)) return {};
    if (reading_ == VoxelReading::whole) tellIfEmpty(node, volume);
    volume.clipPlanes = shown.clipPlanes;
    volume.unitLength = shortestEdge(volume);
    const PlaneSpacing planes = planeSpacing(scene, volume, sampling.value_or(usualSampling(volume)));
    volume.spacing = planes.distance;
    if (!planes.meetsVolume) messages_.warn(node, kPlanesMissVolume);
    light(shown, volume);
    if (reading_ == VoxelReading::whole) shadows_.add(volume, 0);
    return volume;
}

/// Values that voxels do not have were told of as they stand in the node.
void VolumeNodes::tellIfEmpty(const Node& node, const StyledVolume& volume)
{
    const auto isPossible = [](float value) { return value >= 0.0f && value <= 1.0f; };
    if (volume.surfaces && !std::ranges::all_of(volume.surfaces->values, isPossible)) return;
    if (const std::string why = whyNothingIsSeen(volume, ranges_); !why.empty())
        messages_.warn(node, node.typeName() + ": " + why + ": nothing of it is seen",
                       MessageTopic::nothingSeen);
}

void VolumeNodes::light(const ShownNode& shown, StyledVolume& volume)
{
    const glm::dmat4 localFromWorld = glm::inverse(shown.worldFromLocal);
    for (const StyleLight& each : shown.lights)
        volume.surroundings.lights.push_back(localLight(each, localFromWorld));
    limitLights(*shown.node, volume.surroundings.lights, messages_);
}

bool VolumeNodes::fill(const Node& node, StyledVolume& volume)
{
    if (isOf(&node, "SegmentedVolumeData")) return fillSegmented(node, volume);
    if (isOf(&node, "IsoSurfaceVolumeData")) return fillSurfaces(node, volume);
    return fillPlain(node, volume);
}

std::shared_ptr<const VoxelTexture> VolumeNodes::voxelsOf(const Node& node, const char* field)
{
    const Node* const texture = nodeOf(node, field);
    if (!texture && !scene_.lacksRefused(node, field))
        messages_.warn(node, node.typeName() + " has no " + field + ": not drawn");
    return textures_.of(texture);
}

bool VolumeNodes::fillPlain(const Node& node, StyledVolume& volume)
{
    volume.voxels = voxelsOf(node, "voxels");
    if (!volume.voxels) return false;
    DrawnStyle style =
        styles_.of(nodeOf(node, "renderStyle"), node.edition(), {*volume.voxels, volume.dimensions});
    if (style.isSurface) {
        constexpr float kMiddle = 0.5f;
        volume.surfaces = IsoSurfaces{{kMiddle}, {style.chain}, 0.0f, nullptr};
    }
    volume.chains = {std::move(style.chain)};
    volume.projection = style.projection;
    volume.stipple = std::move(style.stipple);
    return style.isEnabled;
}

bool VolumeNodes::fillSegmented(const Node& node, StyledVolume& volume)
{
    Segments segments;
    const bool isOld = node.edition() == Edition::proposal2005;
    if (!(isOld ? takeSegmentedVoxels(node, volume, segments) : takeIdentifiers(node, volume, segments)))
        return false;
    const auto& renderStyles = nodesOf(node, "renderStyle");
    const auto& enabled = integersOf(node, "segmentEnabled");
    volume.chains.clear();
    if (!segments.identifiers) return addFirstSegment(node, volume);
    segments.beyond = addSegmentChain(nullptr, node, volume);
    segments.chainOf.resize(std::max(renderStyles.size(), enabled.size()), segments.beyond);
    std::map<const Node*, int> chainOfStyle;
    for (std::size_t id = 0; id < segments.chainOf.size(); ++id) {
        const bool isOn = id >= enabled.size() || enabled[id] != 0;
        if (isOn && id < renderStyles.size()) {
            const auto [found, isNew] = chainOfStyle.emplace(renderStyles[id], 0);
            if (isNew) found->second = addSegmentChain(renderStyles[id], node, volume);
            segments.chainOf[id] = found->second;
        } else if (!isOn)
            segments.chainOf[id] = -1;
    }
    volume.segments = std::move(segments);
    return true;
}

/// In which all voxels are where nothing numbers them; false where it is not drawn.
bool VolumeNodes::addFirstSegment(const Node& node, StyledVolume& volume)
{
    const auto& renderStyles = nodesOf(node, "renderStyle");
    const auto& enabled = integersOf(node, "segmentEnabled");
    if (!enabled.empty() && enabled[0] == 0) return false;
    return addSegmentChain(renderStyles.empty() ? nullptr : renderStyles[0], node, volume) >= 0;
}

/// The chain's number, or -1 where its style is not enabled.
int VolumeNodes::addSegmentChain(const Node* style, const Node& node, StyledVolume& volume)
{
    DrawnStyle drawn = styles_.of(style, node.edition(), {*volume.voxels, volume.dimensions});
    if (!drawn.isEnabled) return -1;
    if (drawn.projection || drawn.stipple)
        messages_.warn(*style, style->typeName() + " in SegmentedVolumeData: segments are drawn by samples");
    volume.chains.push_back(std::move(drawn.chain));
    return static_cast<int>(volume.chains.size()) - 1;
}

/// The proposal of 2005 has values and numbers of segments in one texture.
bool VolumeNodes::takeSegmentedVoxels(const Node& node, StyledVolume& volume, Segments& segments)
{
    const auto values = voxelsOf(node, "segmentedVoxels");
    if (!values) return false;
    if (values->components == 1) {
        messages_.warn(node, "expected 2, 3 or 4 components in segmentedVoxels, found 1: nothing is drawn");
        return false;
    }
    segments.component = values->components - 1;
    segments.identifiers = textures_.of(nodeOf(node, "segmentedVoxels"), TexelUse::identifiers);
    volume.voxels = textures_.firstComponents(values, segments.component);
    segments.scale = segments.identifiers->kind == TexelKind::uint16 ? 65535.0f : 255.0f;
    return true;
}

bool VolumeNodes::takeIdentifiers(const Node& node, StyledVolume& volume, Segments& segments)
{
    volume.voxels = voxelsOf(node, "voxels");
    if (!volume.voxels) return false;
    const Node* const identifiers = nodeOf(node, "segmentIdentifiers");
    const std::string consequence = "every voxel is of segment 0";
    if (!identifiers) messages_.warn(node, node.typeName() + " has no segmentIdentifiers: " + consequence);
    auto numbers = textures_.of(identifiers, TexelUse::identifiers);
    if (!numbers) return true;
    if (!(numbers->size == volume.voxels->size)) {
        const std::string_view url = stringOf(*identifiers, "url");
        std::string named = identifiers->typeName();
        if (!url.empty()) named.append(" ").append(quotedWord(url));
        messages_.warn(*identifiers, named + ": expected segmentIdentifiers of the voxels' size, " +
                                         sizeText(volume.voxels->size) + ", found " +
                                         sizeText(numbers->size) + ": ignored, " + consequence);
        return true;
    }
    segments.scale = numbers->kind == TexelKind::uint16 ? 65535.0f : 255.0f;
    segments.identifiers = std::move(numbers);
    return true;
}

bool VolumeNodes::fillSurfaces(const Node& node, StyledVolume& volume)
{
    volume.voxels = voxelsOf(node, "voxels");
    if (!volume.voxels) return false;
    IsoSurfaces surfaces;
    const auto& renderStyles = nodesOf(node, "renderStyle");
    for (const auto& [value, number] : surfaceValues(node, *volume.voxels)) {
        const Node* const style =
            renderStyles.empty() ? nullptr : renderStyles[std::min(number, renderStyles.size() - 1)];
        DrawnStyle drawn;
        if (style) drawn = styles_.of(style, node.edition(), {*volume.voxels, volume.dimensions});
        if (drawn.projection || drawn.stipple)
            messages_.warn(*style, style->typeName() + " in IsoSurfaceVolumeData: surfaces are drawn");
        if (!drawn.isEnabled) continue;
        drawn.chain.insert(drawn.chain.begin(), fixedOpacity(1.0f));
        surfaces.values.push_back(value);
        surfaces.chains.push_back(std::move(drawn.chain));
    }
    if (surfaces.values.empty()) return false;
    surfaces.surfaceTolerance = floatOf(node, "surfaceTolerance");
    surfaces.gradients = styles_.normals(node, nodeOf(node, "gradients"), *volume.voxels);
    volume.surfaces = std::move(surfaces);
    return true;
}

/// As they are listed, or, with a step, the value itself first and then those that the step adds, from the
/// smallest; brought into rising order, each value once.
std::vector<VolumeNodes::SurfaceValue> VolumeNodes::surfaceValues(const Node& node,
                                                                  const VoxelTexture& voxels)
{
    std::vector<SurfaceValue> surfaces;
    for (const float value : floatsOf(node, "surfaceValues"))
        surfaces.push_back({value, surfaces.size()});
    const double step = std::abs(static_cast<double>(floatOf(node, "contourStepSize")));
    if (surfaces.size() == 1 && step > 0.0 && reading_ == VoxelReading::whole)
        addContours(node, step, ranges_.of(voxels), surfaces);
    if (surfaces.size() > kMostSurfaces) {
        messages_.warn(node, "expected at most " + std::to_string(kMostSurfaces) + " surfaceValues, found " +
                                 std::to_string(surfaces.size()) + ": the first are drawn");
        surfaces.resize(kMostSurfaces);
    }
    std::ranges::stable_sort(surfaces, {}, &SurfaceValue::value);
    const auto sameValue = [](const SurfaceValue& a, const SurfaceValue& b) { return a.value == b.value; };
    surfaces.erase(std::unique(surfaces.begin(), surfaces.end(), sameValue), surfaces.end());
    return surfaces;
}

void VolumeNodes::addContours(const Node& node, double step, const VoxelRange& range,
                              std::vector<SurfaceValue>& surfaces)
{
    const double first = surfaces[0].value;
    const double below = std::ceil((range.low - first) / step),
                 above = std::floor((range.high - first) / step);
    if (!(above - below < static_cast<double>(kMostSurfaces)))
        return messages_.warn(node, "expected at most " + std::to_string(kMostSurfaces) +
                                        " surfaces by contourStepSize, found more: the step is left out");
    for (double k = below; k <= above; ++k)
        if (k != 0.0) surfaces.push_back({static_cast<float>(first + k * step), surfaces.size()});
}

} // namespace vo
