#pragma once

#include "volume_io/result.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vo {

/// Red, green and blue of pixels of four floats (red green blue alpha), each round(255 * clamp(value)); what
/// is not a number becomes 0.
std::vector<std::uint8_t> roundedColors(std::span<const float> pixels);

/// Writes an opaque PNG, beside its name and then renamed. `pixels`: width * height pixels of four floats,
/// rows from the bottom, as OpenGL delivers them.
Result<void> writePicture(const std::string& path, int width, int height, std::span<const float> pixels);

} // namespace vo
