#pragma once

#include "volume_io/volume_io.h"

#include <cstddef>
#include <span>

/// Opacities for volumes of colours whose file has none (VolumeDescription::alphaAdded), where slices are
/// blended over each other and no table brings opacities: opaque as they arrive, black voxels would hide what
/// lies behind.
namespace vo {

/// Sets alpha to the largest of red, green and blue, of voxels of four channels of a type. What is not a
/// number counts only where all three are none.
void setBrightnessAlpha(ChannelType type, std::span<std::byte> voxels);

} // namespace vo
