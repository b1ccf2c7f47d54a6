#include "x3d/slice_atlas.h"

#include "x3d/node_values.h"

#include <algorithm>
#include <cstring>

namespace vo {
namespace {

/// From rows of pixels across all slices of a band to slices one after the other, in the same bytes.
void cutBand(std::byte* band, std::size_t bytes, std::size_t across, std::size_t sliceRowBytes)
{
    const std::vector<std::byte> rows(band, band + bytes);
    const std::size_t rowBytes = across * sliceRowBytes;
    std::byte* to = band;
    for (std::size_t slice = 0; slice < across; ++slice)
        for (std::size_t at = slice * sliceRowBytes; at < bytes; at += rowBytes, to += sliceRowBytes)
            std::memcpy(to, rows.data() + at, sliceRowBytes);
}

} // namespace

std::string atlasObjection(const Node& node)
{
    for (const char* const field : {"numberOfSlices", "slicesOverX", "slicesOverY"})
        if (const int count = integerOf(node, field); count < 1)
            return std::string("expected ") + field + " of at least 1, found " + std::to_string(count);
    const std::int64_t across = integerOf(node, "slicesOverX"), down = integerOf(node, "slicesOverY");
    const int slices = integerOf(node, "numberOfSlices");
    if (slices <= across * down) return "";
    return "expected numberOfSlices of at most slicesOverX * slicesOverY = " + std::to_string(across * down) +
           ", found " + std::to_string(slices);
}

TextureResult atlasSlices(const Node& node, std::shared_ptr<VoxelTexture> picture)
{
    const int across = integerOf(node, "slicesOverX"), down = integerOf(node, "slicesOverY");
    if (picture->size.x % across != 0 || picture->size.y % down != 0)
        return {nullptr, "expected a picture of " + std::to_string(across) + " x " + std::to_string(down) +
                             " slices of one size, found " + std::to_string(picture->size.x) + " x " +
                             std::to_string(picture->size.y) + " pixels"};
    picture->size = {picture->size.x / across, picture->size.y / down, integerOf(node, "numberOfSlices")};
    const std::size_t rowBytes = static_cast<std::size_t>(picture->size.x) *
                                 static_cast<std::size_t>(picture->components) * bytesOf(picture->kind);
    const std::size_t sliceBytes = rowBytes * static_cast<std::size_t>(picture->size.y);
    const std::size_t bandBytes = sliceBytes * static_cast<std::size_t>(across);
    for (std::size_t band = 0; across > 1 && band < picture->texels.size(); band += bandBytes)
        cutBand(picture->texels.data() + band, bandBytes, static_cast<std::size_t>(across), rowBytes);
    picture->texels.resize(sliceBytes * static_cast<std::size_t>(picture->size.z));
    return {std::move(picture), ""};
}

} // namespace vo
