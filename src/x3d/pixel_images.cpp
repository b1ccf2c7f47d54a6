#include "x3d/pixel_images.h"

#include "x3d/node_values.h"

namespace vo {
namespace {

/// The components of a pixel, the first in its highest byte.
std::vector<std::byte> unpacked(const std::vector<std::int32_t>& image, std::size_t first, int components)
{
    std::vector<std::byte> texels;
    texels.reserve((image.size() - first) * static_cast<std::size_t>(components));
    for (std::size_t i = first; i < image.size(); ++i)
        for (int shift = 8 * (components - 1); shift >= 0; shift -= 8)
            texels.push_back(static_cast<std::byte>(static_cast<std::uint32_t>(image[i]) >> shift));
    return texels;
}

} // namespace

TextureResult pixelImage(const Node& node)
{
    const auto& image = integersOf(node, "image");
    const bool isFlat = isOf(&node, "PixelTexture");
    const std::size_t sizes = isFlat ? 3 : 4;
    if (image.size() <= sizes) return {nullptr, "expected pixels, found none"};
    auto texture = std::make_shared<VoxelTexture>();
    texture->components = isFlat ? image[2] : image[0];
    texture->size = isFlat ? VoxelSize{image[0], image[1], 1} : VoxelSize{image[1], image[2], image[3]};
    if (texture->components < 1) return {nullptr, "expected 1 to 4 components, found 0"};
    texture->texels = unpacked(image, sizes, texture->components);
    return {std::move(texture), ""};
}

} // namespace vo
