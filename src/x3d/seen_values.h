#pragma once

#include "style/styled_scene.h"

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>

namespace vo {

/// The least and the greatest value of voxels.
struct VoxelRange
{
    float low, high;
};

/// The ranges of a component of textures, each found once, whole or as far as it was enough.
class VoxelRanges
{
public:
    VoxelRange of(const VoxelTexture& voxels, int component = 0);
    /// Whether a range that holds no other values than these voxels' is enough: few voxels are looked at
    /// where it soon is. A range that is enough stays so as it grows.
    bool reach(const VoxelTexture& voxels, int component,
               const std::function<bool(const VoxelRange&)>& isEnough);

private:
    struct Known
    {
        VoxelRange range;
        bool isWhole = false;
    };

    Known& known(const VoxelTexture& voxels, int component);

    std::map<std::pair<std::uint64_t, int>, Known> ranges_; // by the texture's serial and component
};

/// What tells why no eye sees anything of a volume: values that no surface meets, or that all samples are
/// clear. "" where something may be seen, and of projections and stipples.
std::string whyNothingIsSeen(const StyledVolume& volume, VoxelRanges& ranges);

} // namespace vo
