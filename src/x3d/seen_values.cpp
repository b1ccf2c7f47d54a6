#include "x3d/seen_values.h"

#include "x3d/number_text.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace vo {
namespace {

constexpr VoxelRange kNone{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

std::string rangeText(const VoxelRange& range)
{
    return range.low < range.high ? numberText(range.low) + " to " + numberText(range.high)
                                  : numberText(range.low) + " alone";
}

bool isCrossed(const IsoSurfaces& surfaces, const VoxelRange& range)
{
    return std::ranges::any_of(surfaces.values,
                               [&](float value) { return range.low < value && value <= range.high; });
}

bool isClear(const StyleChain& chain, const VoxelRange& range)
{
    if (!std::ranges::all_of(chain, [](const auto& style) { return style->keepsClear(); })) return false;
    const bool beginsWithVoxel = chain.empty() || !chain.front()->replacesColor();
    return beginsWithVoxel ? range.high <= 0.0f : chain.front()->isClear(range.low, range.high);
}

/// Those of which firstColor() makes the opacity: the mean of three.
std::vector<int> opacityComponents(int components)
{
    return components == 3 ? std::vector{0, 1, 2} : std::vector{components - 1};
}

std::string whyAllIsClear(int components, const VoxelRange& range)
{
    const bool isOne = components == 1;
    return std::string("expected ") + (isOne ? "values" : "opacities") +
           " that its style shows, found voxels of " + (isOne ? "" : "the opacity ") + rangeText(range) +
           ", which it makes clear" +
           (!isOne && range.low >= 1.0f ? " by 1 - opacity, as the proposal of 2005 has it" : "");
}

std::string whyNoSurface(const IsoSurfaces& surfaces, const VoxelTexture& voxels, VoxelRanges& ranges)
{
    if (ranges.reach(voxels, 0, [&](const VoxelRange& range) { return isCrossed(surfaces, range); }))
        return "";
    constexpr std::size_t kMost = 8;
    std::string values;
    for (std::size_t i = 0; i < std::min(surfaces.values.size(), kMost); ++i) {
        if (i > 0) values += ' ';
        values += numberText(surfaces.values[i]);
    }
    if (surfaces.values.size() > kMost) values += " ...";
    return "expected voxels below and above a surface's value (" + values + "), found " +
           rangeText(ranges.of(voxels));
}

/// Takes every so many voxels into a range, until it is enough: whether it was.
bool grow(VoxelRange& range, const VoxelTexture& voxels, int component, std::size_t step,
          const std::function<bool(const VoxelRange&)>& isEnough)
{
    const auto components = static_cast<std::size_t>(voxels.components);
    for (std::size_t texel = 0; texel < voxels.size.count(); texel += step) {
        const float value = numberAt(voxels, texel * components + static_cast<std::size_t>(component));
        if (value >= range.low && value <= range.high) continue;
        range = {std::min(range.low, value), std::max(range.high, value)};
        if (isEnough(range)) return true;
    }
    return false;
}

} // namespace

VoxelRanges::Known& VoxelRanges::known(const VoxelTexture& voxels, int component)
{
    return ranges_.emplace(std::pair{voxels.serial, component}, Known{kNone}).first->second;
}

VoxelRange VoxelRanges::of(const VoxelTexture& voxels, int component)
{
    Known& found = known(voxels, component);
    if (found.isWhole) return found.range;
    grow(found.range, voxels, component, 1, [](const VoxelRange&) { return false; });
    found.isWhole = true;
    return found.range;
}

bool VoxelRanges::reach(const VoxelTexture& voxels, int component,
                        const std::function<bool(const VoxelRange&)>& isEnough)
{
    // A prime: more than one column, whatever the width is, but for its multiples.
    constexpr std::size_t kStep = 61;
    Known& found = known(voxels, component);
    if (found.range.low <= found.range.high && isEnough(found.range)) return true;
    if (!found.isWhole && grow(found.range, voxels, component, kStep, isEnough)) return true;
    return isEnough(of(voxels, component));
}

std::string whyNothingIsSeen(const StyledVolume& volume, VoxelRanges& ranges)
{
    const VoxelTexture& voxels = *volume.voxels;
    if (volume.surfaces) return whyNoSurface(*volume.surfaces, voxels, ranges);
    if (volume.projection || volume.stipple || volume.chains.empty()) return "";
    const auto isSeen = [&](const VoxelRange& range) {
        return std::ranges::any_of(volume.chains, [&](const auto& chain) { return !isClear(chain, range); });
    };
    for (const int component : opacityComponents(voxels.components))
        if (ranges.reach(voxels, component, isSeen)) return "";
    return whyAllIsClear(voxels.components, ranges.of(voxels, voxels.components - 1));
}

} // namespace vo
