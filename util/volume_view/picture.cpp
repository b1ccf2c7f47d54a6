#include "picture.h"

#include "volume_io/volume_io.h"

#include <algorithm>

namespace vo {

std::vector<std::uint8_t> roundedColors(std::span<const float> pixels)
{
    std::vector<std::uint8_t> colors(pixels.size() / 4 * 3);
    for (std::size_t pixel = 0; pixel < pixels.size() / 4; ++pixel)
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const float value = pixels[4 * pixel + channel];
            const float scaled = value > 0.0f ? 255.0f * std::min(value, 1.0f) : 0.0f; // 0 for NaN too
            const int below = static_cast<int>(scaled);
            colors[3 * pixel + channel] =
                static_cast<std::uint8_t>(below + (scaled - static_cast<float>(below) >= 0.5f));
        }
    return colors;
}

Result<void> writePicture(const std::string& path, int width, int height, std::span<const float> pixels)
{
    return writePng(path, width, height, 3, roundedColors(pixels), RowOrder::bottomFirst);
}

} // namespace vo
