#include "style/voxel_texture.h"

#include <limits>

namespace vo {

bool isUsable(const VoxelTexture& texture)
{
    if (texture.components < 1 || texture.components > 4) return false;
    std::uint64_t count = static_cast<std::uint64_t>(texture.components) * bytesOf(texture.kind);
    for (const int axis : {0, 1, 2}) {
        if (texture.size[axis] < 1) return false;
        const auto size = static_cast<std::uint64_t>(texture.size[axis]);
        if (count > std::numeric_limits<std::uint64_t>::max() / size) return false;
        count *= size;
    }
    return texture.texels.size() >= count;
}

std::string sizeText(const VoxelSize& size)
{
    return std::to_string(size.x) + " x " + std::to_string(size.y) + " x " + std::to_string(size.z);
}

} // namespace vo
