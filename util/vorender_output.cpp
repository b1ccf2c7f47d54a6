#include "vorender_output.h"

#include "volume_view/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace vo {
namespace {

/// Red, green, blue and alpha of all pixels, rows from the bottom; what nothing was drawn into is 0.
std::vector<float> framePixels(int width, int height, const CastPicture& picture, bool isOver)
{
    std::vector<float> frame(std::size_t(width) * std::size_t(height) * 4, 0.0f);
    for (int y = 0; y < picture.height; ++y) {
        const float* from = &picture.rgbt[4 * std::size_t(y) * std::size_t(picture.width)];
        float* to = &frame[4 * (std::size_t(picture.y + y) * std::size_t(width) + std::size_t(picture.x))];
        for (int x = 0; x < picture.width; ++x, from += 4, to += 4) {
            for (int c = 0; c < 4; ++c)
                to[c] = std::isfinite(from[c]) ? from[c] : 0.0f;
            if (isOver) to[3] = 1.0f - from[3];
        }
    }
    return frame;
}

/// The rows of a picture from the top.
std::vector<float> fromTop(const std::vector<float>& rows, int height)
{
    std::vector<float> result(rows.size());
    const std::size_t length = rows.size() / std::size_t(height);
    for (std::size_t y = 0; y < std::size_t(height); ++y)
        std::copy_n(&rows[y * length], length, &result[(std::size_t(height) - 1 - y) * length]);
    return result;
}

} // namespace

Result<void> checkPictureName(const std::string& name, std::uintmax_t bytes,
                              const std::vector<std::string>& inputs)
{
    std::error_code none;
    for (const std::string& input : inputs)
        if (std::filesystem::equivalent(input, name, none))
            return Failure{name + ": expected an output that is no input, found the file " + input};
    if (!isRawName(name) || !std::filesystem::is_regular_file(name, none)) return {};
    const std::uintmax_t found = std::filesystem::file_size(name, none);
    if (found == bytes || found == 0) return {};
    return Failure{name + ": expected a new file, or one of " + std::to_string(bytes) +
                   " bytes to replace, found one of " + std::to_string(found)};
}

Result<void> writeFrame(const std::string& name, int width, int height, const CastPicture& picture,
                        bool isOver)
{
    const std::vector<float> pixels = framePixels(width, height, picture, isOver);
    if (!isRawName(name)) return writePicture(name, width, height, pixels);
    return writeBytes(name, std::as_bytes(std::span<const float>(fromTop(pixels, height))));
}

Result<void> writeDepths(const std::string& name, int width, int height, const std::vector<float>& depths)
{
    if (isRawName(name))
        return writeBytes(name, std::as_bytes(std::span<const float>(fromTop(depths, height))));
    std::vector<std::uint16_t> values;
    values.reserve(depths.size());
    for (const float depth : depths)
        values.push_back(static_cast<std::uint16_t>(std::lround(65535 * std::clamp(depth, 0.0f, 1.0f))));
    return writeGreyPng(name, width, height, values, RowOrder::bottomFirst);
}

} // namespace vo
