#include "defaults.h"

#include <algorithm>
#include <cmath>

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
