#include "picture.h"

#include "volume_io/volume_io.h"

#include <algorithm>
#include <cmath>

namespace vo {

std::vector<std::uint8_t> roundedColors(std::span<const float> pixels)
{
    std::vector<std::uint8_t> colors;
    colors.reserve(pixels.size() / 4 * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i % 4 == 3) continue;
        const float value = std::isnan(pixels[i]) ? 0 : std::clamp(pixels[i], 0.0f, 1.0f);
        colors.push_back(std::uint8_t(std::lround(255 * value)));
    }
    return colors;
}

Result<void> writePicture(const std::string& path, int width, int height, std::span<const float> pixels)
{
    return writePng(path, width, height, 3, roundedColors(pixels), RowOrder::bottomFirst);
}

} // namespace vo
