#include "defaults.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vo {

std::array<float, 3> voxelScale(const Options& options, const std::array<double, 3>& spacing)
{
    const double finest = *std::ranges::min_element(spacing);
    std::array<float, 3> scale{};
    for (std::size_t i = 0; i < 3; ++i)
        scale[i] = float(options.scale ? (*options.scale)[i] : spacing[i] / finest);
    return scale;
}

double samplingPlaneCount(const Options& options, const std::array<double, 3>& size,
                          const std::array<float, 3>& scale, double margin)
{
    double diagonal = 0;
    for (std::size_t i = 0; i < 3; ++i)
        diagonal = std::hypot(diagonal, size[i] * double(scale[i]));
    return std::ceil(1.02 * margin * diagonal / options.sampling) + 1;
}

std::string planeOptionsGiven(const Options& options, bool withBricks)
{
    std::string names;
    int count = 0;
    const auto add = [&](bool given, const char* name) {
        if (!given) return;
        names += (count++ ? " and " : "") + std::string(name);
    };
    add(options.sampling != 1, "-sampling");
    add(options.scale.has_value(), "-scale");
    add(withBricks && options.bricks, "-bricks");
    if (count == 0) return "volume: ";
    return (count == 1 ? "option " : "options ") + names + ": ";
}

ValueRange dataRange(const Options& options, const ValueRange& seen, const ValueRange& full, bool isByte)
{
    if (options.dataRange) return {options.dataRange->low, options.dataRange->high};
    return !isByte && seen.low < seen.high ? seen : full;
}

bool hasTable(const Options& options)
{
    return options.lut || !options.lutFile.empty();
}

bool inColor(const Options& options, bool tableHasColors)
{
    return options.color.value_or(tableHasColors);
}

std::int64_t brickSizeFor(std::int64_t size, int bricks, int overlap)
{
    return (size + std::int64_t(bricks - 1) * overlap + bricks - 1) / bricks;
}

Result<void> checkBricks(const Options& options, const std::array<std::int64_t, 3>& volume,
                         const std::array<std::int64_t, 3>& brick)
{
    // Bricks of no more voxels than they share would never get through the volume.
    for (const std::int64_t size : brick)
        if (size > 1 && size <= options.overlap)
            return Failure{"option -overlap: expected fewer voxels than a brick has on each side (" +
                           std::to_string(size) + "), found '" + std::to_string(options.overlap) + "'"};
    const double count = brickCount(options, volume, brick);
    if (!options.bricks || count <= kMostBricks) return {};
    char found[400];
    std::snprintf(found, sizeof found, "option -bricks: expected at most %.0f bricks, found %.0f",
                  kMostBricks, count);
    return Failure{found};
}

double brickCount(const Options& options, const std::array<std::int64_t, 3>& volume,
                  const std::array<std::int64_t, 3>& brick)
{
    std::array<double, 3> along{};
    for (std::size_t i = 0; i < 3; ++i) {
        const double step = double(std::max<std::int64_t>(brick[i] - options.overlap, 1));
        along[i] = std::max(std::ceil(double(volume[i] - options.overlap) / step), 1.0);
    }
    if (options.textureDimensions == 3) return along[0] * along[1] * along[2];
    double most = 0;
    for (std::size_t i = 0; i < 3; ++i)
        most = std::max(most, double(volume[i]) * along[(i + 1) % 3] * along[(i + 2) % 3]);
    return most;
}

std::string withoutEffect(const Options& options)
{
    if (options.shells && options.perspective == 0)
        return "option -shells: without effect, expected -perspective beside it, found none";
    return "";
}

std::vector<float> tableEntries(const LookupFile& table, int components)
{
    if (components == 4) return {table.rgba.begin(), table.rgba.end()};
    std::vector<float> entries;
    for (std::size_t i = 0; i < table.rgba.size(); i += 4) {
        const float* rgba = &table.rgba[i];
        entries.insert(entries.end(), {0.30f * rgba[0] + 0.59f * rgba[1] + 0.11f * rgba[2], rgba[3]});
    }
    return entries;
}

} // namespace vo
