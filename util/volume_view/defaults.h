#pragma once

#include "lookup_file.h"
#include "options.h"
#include "value_range.h"

#include <array>
#include <string>
#include <vector>

/// What a picture of a volume takes where the options leave it open: the same in all programs.
namespace vo {

constexpr double kMostSamplingPlanes = 65536;
/// Of those that -bricks asks for.
constexpr double kMostBricks = 4096;

/// Spacing of the voxels along x, y, z as the picture has it: that of -scale, else the file's, the
/// smallest 1.
std::array<float, 3> voxelScale(const Options& options, const std::array<double, 3>& spacing);

/// The most sampling planes that any view of a box of `size` voxels has. They are at most the diagonal of the
/// scaled box apart from each other; a view volume is a little deeper. `margin`: see Model.
double samplingPlaneCount(const Options& options, const std::array<double, 3>& size,
                          const std::array<float, 3>& scale, double margin = 1);

/// The options that the count of planes (and of bricks) comes from and that the user gave, to begin a message
/// with: "options -sampling and -scale: ".
std::string planeOptionsGiven(const Options& options, bool withBricks);

/// The values of the file that become the ends of the table: those of -dataRange, else those that the file
/// has
/// (`seen`); all values of an 8-bit type (`full`), which its files seldom leave unused, and of volumes of
/// several channels, of which nothing is seen.
ValueRange dataRange(const Options& options, const ValueRange& seen, const ValueRange& full, bool isByte);

/// Whether a table is asked for. Without one, volumes of several channels have their own colours and
/// opacities.
bool hasTable(const Options& options);

/// Whether a picture is in RGBA or in grey: -color and -monochrome, else whether the table has colours.
bool inColor(const Options& options, bool tableHasColors);

/// Voxels along a brick of which `bricks`, the last ones partly empty, cover `size` voxels.
std::int64_t brickSizeFor(std::int64_t size, int bricks, int overlap);

/// A failure for bricks that their overlap does not get through, `brick` voxels each, and for more bricks of
/// -bricks than programs take.
Result<void> checkBricks(const Options& options, const std::array<std::int64_t, 3>& volume,
                         const std::array<std::int64_t, 3>& brick);

/// Bricks of the largest set: all of the volume, or with 2D textures the slices of one of three directions.
double brickCount(const Options& options, const std::array<std::int64_t, 3>& volume,
                  const std::array<std::int64_t, 3>& brick);

/// What was asked for and changes nothing, a line; empty: nothing.
std::string withoutEffect(const Options& options);

/// A table's entries in 4 components (red, green, blue, alpha) or 2 (luminance, alpha).
std::vector<float> tableEntries(const LookupFile& table, int components);

} // namespace vo
