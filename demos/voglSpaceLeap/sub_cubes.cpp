#include "sub_cubes.h"

#include "voxel_range.h"

#include <algorithm>
#include <cstdlib>

namespace {

int channelsOf(voExternalFormatType format)
{
    switch (format) {
    case voExternalFormatTypeScope::LUMINANCE_ALPHA: return 2;
    case voExternalFormatTypeScope::RGBA: return 4;
    default: return 1;
    }
}

/// Voxels of the volume that textures read in one sub-cube, on one axis.
struct Reach
{
    int first, count;
};

Reach reachOf(int cube, int cubeSize, int volumeSize)
{
    const int first = std::max(cube * cubeSize - 1, 0);
    const int last = int(std::min((cube + 1LL) * cubeSize, volumeSize - 1LL));
    return {first, last - first + 1};
}

/// The voxels of some slices.
class Layer
{
public:
    explicit Layer(const VoglSource& source) : source_(source), channels_(channelsOf(source.diskFormat)) {}

    void read(const Reach& slices)
    {
        const int origin[3] = {0, 0, slices.first};
        const int size[3] = {source_.size[0], source_.size[1], slices.count};
        // Eight bytes are the largest channel.
        values_.resize(std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]) *
                       std::size_t(channels_));
        if (source_.readBrick(values_.data(), origin, size)) std::exit(1);
        slices_ = slices.count;
    }

    vo::ValueRange range(const Reach& columns, const Reach& rows) const
    {
        vo::ValueRange range;
        for (int z = 0; z < slices_; ++z)
            for (int y = rows.first; y < rows.first + rows.count; ++y) {
                const std::size_t row = std::size_t(z) * std::size_t(source_.size[1]) + std::size_t(y);
                const std::size_t voxel = row * std::size_t(source_.size[0]) + std::size_t(columns.first);
                vo::growRange(range, source_.dataType, values_.data(), voxel * std::size_t(channels_),
                              std::size_t(columns.count) * std::size_t(channels_));
            }
        return range;
    }

private:
    const VoglSource& source_;
    int channels_;
    int slices_ = 0;
    std::vector<double> values_;
};

/// Whether all of a box is needed and not yet taken.
bool isFree(const SubCubes& cubes, const std::vector<char>& free, const SubCubeBox& box)
{
    for (int z = box.lower[2]; z < box.upper[2]; ++z)
        for (int y = box.lower[1]; y < box.upper[1]; ++y)
            for (int x = box.lower[0]; x < box.upper[0]; ++x)
                if (!free[cubes.index(x, y, z)]) return false;
    return true;
}

void take(const SubCubes& cubes, const SubCubeBox& box, std::vector<char>& free)
{
    for (int z = box.lower[2]; z < box.upper[2]; ++z)
        for (int y = box.lower[1]; y < box.upper[1]; ++y)
            for (int x = box.lower[0]; x < box.upper[0]; ++x)
                free[cubes.index(x, y, z)] = 0;
}

SubCubeBox grown(const SubCubes& cubes, const std::vector<char>& free, SubCubeBox box)
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        while (box.upper[axis] < cubes.count[axis]) {
            SubCubeBox next = box;
            next.lower[axis] = box.upper[axis];
            next.upper[axis] = box.upper[axis] + 1;
            if (!isFree(cubes, free, next)) break;
            box.upper[axis]++;
        }
    return box;
}

} // namespace

SubCubes findSubCubes(const VoglSource& source, int size, double low, double high)
{
    SubCubes cubes;
    cubes.size = size;
    for (std::size_t i = 0; i < 3; ++i)
        cubes.count[i] = (source.size[i] - 1) / size + 1;
    Layer layer(source);
    for (int z = 0; z < cubes.count[2]; ++z) {
        layer.read(reachOf(z, size, source.size[2]));
        for (int y = 0; y < cubes.count[1]; ++y)
            for (int x = 0; x < cubes.count[0]; ++x) {
                const vo::ValueRange range =
                    layer.range(reachOf(x, size, source.size[0]), reachOf(y, size, source.size[1]));
                cubes.needed.push_back(range.low <= high && range.high >= low);
            }
    }
    return cubes;
}

std::vector<SubCubeBox> separate(const SubCubes& cubes)
{
    std::vector<SubCubeBox> boxes;
    for (int z = 0; z < cubes.count[2]; ++z)
        for (int y = 0; y < cubes.count[1]; ++y)
            for (int x = 0; x < cubes.count[0]; ++x)
                if (cubes.needed[cubes.index(x, y, z)]) boxes.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
    return boxes;
}

std::vector<SubCubeBox> coalesce(const SubCubes& cubes)
{
    std::vector<SubCubeBox> boxes;
    std::vector<char> free = cubes.needed;
    for (int z = 0; z < cubes.count[2]; ++z)
        for (int y = 0; y < cubes.count[1]; ++y)
            for (int x = 0; x < cubes.count[0]; ++x) {
                if (!free[cubes.index(x, y, z)]) continue;
                boxes.push_back(grown(cubes, free, {{x, y, z}, {x + 1, y + 1, z + 1}}));
                take(cubes, boxes.back(), free);
            }
    return boxes;
}
