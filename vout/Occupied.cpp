#include <vo/utOccupied.h>

#include "legacy/report.h"

#include "vout/block_tetras.h"
#include "vout/occupied_blocks.h"

#include <vo/AppearanceActions.h>

#include <algorithm>
#include <functional>
#include <string>

using vo::badValue;
using vo::BlockGrid;
using vo::BlockPlace;
using vo::guarded;
using vo::required;
using vo::ValueBounds;

struct voutOccupied::Private
{
    BlockGrid grid; ///< without blocks where the constructor failed
    bool merged = true;
    std::vector<vo::BlockBox> boxes;

    void takeBoxes() { boxes = merged ? vo::mergedBoxes(grid) : vo::separateBoxes(grid); }
};

namespace {

/// Whether something shows in a block of these values.
using Shows = std::function<bool(const ValueBounds&)>;

void mark(BlockGrid& grid, const std::vector<ValueBounds>& bounds, const Shows& shows)
{
    std::ranges::transform(bounds, grid.occupied.begin(), [&](const ValueBounds& values) -> std::uint8_t {
        return values.low <= values.high && shows(values);
    });
}

Shows showsByTable(const voLookupTable* table)
{
    if (!table) return [](const ValueBounds& values) { return values.low != 0 || values.high != 0; };
    return [table](const ValueBounds& values) {
        return table->isVisible(static_cast<float>(values.low), static_cast<float>(values.high)) == VO_TRUE;
    };
}

/// A table that was not loaded shows even an empty range, and has reported it.
bool isUsable(const voLookupTable* table)
{
    return !table || !table->isVisible(1, 0);
}

Shows showsFrom(double low, double high)
{
    if (!(low <= high)) badValue("values from " + std::to_string(low) + " to " + std::to_string(high));
    return [low, high](const ValueBounds& values) { return values.low <= high && values.high >= low; };
}

/// Its blocks, marked; none where the volume cannot be read, which is reported then.
BlockGrid blocksOf(voBrickSetCollection* volume, int blockSize, const Shows& shows)
{
    BlockPlace size{};
    required(volume, "volume").getCurrentBrickSet()->getVolumeSizes(size[0], size[1], size[2]);
    BlockGrid grid = BlockGrid::of(size, blockSize);
    std::vector<float> ranges(2 * grid.occupied.size());
    if (voAppearanceActions::volumeFindRanges(volume, grid.side, ranges.data()) != 0) return {};
    std::vector<ValueBounds> bounds;
    for (std::size_t i = 0; i < ranges.size(); i += 2)
        bounds.push_back({static_cast<double>(ranges[i]), static_cast<double>(ranges[i + 1])});
    mark(grid, bounds, shows);
    return grid;
}

BlockGrid blocksOf(const int* sizes, voutReadVoxels read, void* user, int blockSize, const Shows& shows)
{
    required(sizes, "sizes");
    if (!read) badValue("read is NULL");
    BlockGrid grid = BlockGrid::of({sizes[0], sizes[1], sizes[2]}, blockSize);
    mark(grid,
         vo::blockBounds(grid,
                         [&](const BlockPlace& origin, const BlockPlace& size, double* values) {
                             if (const int answer = read(origin.data(), size.data(), values, user))
                                 badValue("reading voxels answered " + std::to_string(answer));
                         }),
         shows);
    return grid;
}

bool isOpaqueWithoutTable(voBrickSetCollection* volume)
{
    return required(volume, "volume").getCurrentBrickSet()->getBrick(0)->getInternalFormat() ==
           voInternalFormatTypeScope::LUMINANCE8_EXT;
}

} // namespace

voutOccupied::voutOccupied(voBrickSetCollection* volume, voLookupTable* table, int blockSize) : d(new Private)
{
    guarded("voutOccupied", [&] {
        if (!isUsable(table)) return;
        const bool all = !table && isOpaqueWithoutTable(volume);
        d->grid = blocksOf(volume, blockSize, all ? [](const ValueBounds&) { return true; } : showsByTable(table));
        d->takeBoxes();
    });
}

voutOccupied::voutOccupied(voBrickSetCollection* volume, float low, float high, int blockSize) : d(new Private)
{
    guarded("voutOccupied", [&] {
        d->grid = blocksOf(volume, blockSize, showsFrom(static_cast<double>(low), static_cast<double>(high)));
        d->takeBoxes();
    });
}

voutOccupied::voutOccupied(const int sizes[3], voutReadVoxels read, void* user, voLookupTable* table, int blockSize)
    : d(new Private)
{
    guarded("voutOccupied", [&] {
        if (!isUsable(table)) return;
        d->grid = blocksOf(sizes, read, user, blockSize, showsByTable(table));
        d->takeBoxes();
    });
}

voutOccupied::voutOccupied(const int sizes[3], voutReadVoxels read, void* user, double low, double high, int blockSize)
    : d(new Private)
{
    guarded("voutOccupied", [&] {
        d->grid = blocksOf(sizes, read, user, blockSize, showsFrom(low, high));
        d->takeBoxes();
    });
}

voutOccupied::~voutOccupied()
{
    delete d;
}

void voutOccupied::getBlockCounts(int& nx, int& ny, int& nz) const
{
    nx = d->grid.count[0];
    ny = d->grid.count[1];
    nz = d->grid.count[2];
}

int voutOccupied::getBlockCount() const
{
    return static_cast<int>(d->grid.occupied.size());
}

int voutOccupied::getOccupiedCount() const
{
    return static_cast<int>(std::ranges::count(d->grid.occupied, 1));
}

voBool voutOccupied::isOccupied(int i, int j, int k) const
{
    const BlockPlace block{i, j, k};
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (block[axis] < 0 || block[axis] >= d->grid.count[axis]) return VO_FALSE;
    return d->grid.occupied[d->grid.index(block)] ? VO_TRUE : VO_FALSE;
}

void voutOccupied::setMerged(voBool merged)
{
    if (d->merged == (merged != VO_FALSE)) return;
    guarded("voutOccupied::setMerged", [&] {
        d->merged = merged != VO_FALSE;
        d->takeBoxes();
    });
}

voBool voutOccupied::getMerged() const
{
    return d->merged ? VO_TRUE : VO_FALSE;
}

int voutOccupied::getBoxCount() const
{
    return static_cast<int>(d->boxes.size());
}

void voutOccupied::getBox(int index, float lower[3], float upper[3]) const
{
    guarded("voutOccupied::getBox", [&] {
        required(lower, "lower");
        required(upper, "upper");
        if (index < 0 || index >= getBoxCount())
            badValue("box " + std::to_string(index) + " of " + std::to_string(getBoxCount()));
        const vo::BlockBox& box = d->boxes[static_cast<std::size_t>(index)];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lower[axis] = static_cast<float>(d->grid.voxel(axis, box.lower[axis]));
            upper[axis] = static_cast<float>(d->grid.voxel(axis, box.upper[axis]));
        }
    });
}

double voutOccupied::getCoveredFraction() const
{
    if (d->grid.occupied.empty()) return 0;
    const BlockPlace& size = d->grid.size;
    return vo::voxelCount(d->grid, d->boxes) / (static_cast<double>(size[0]) * size[1] * size[2]);
}

voIndexedTetraSet* voutOccupied::tessellate()
{
    std::unique_ptr<voIndexedTetraSet> tetras;
    guarded("voutOccupied::tessellate", [&] {
        if (d->grid.occupied.empty()) badValue("there is no volume");
        tetras = vo::tetraSet(vo::blockTetras(d->grid, d->boxes));
    });
    return tetras.release();
}
