#pragma once

#include "appearance/cell_range_store.h"
#include "core/box.h"
#include "draw/context_record.h"
#include "geometry/box_union.h"
#include "geometry/kept_tetras.h"
#include "lookup/visible_values.h"
#include "polygonize/camera.h"
#include "polygonize/slice_occupied.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vo {

struct FrameRequest;

/// How far it is from each cell of a volume, kCellSide voxels wide, to the next in which something may be
/// seen.
struct EmptyCells
{
    static constexpr int kFarthest = 31;
    VoxelSize count;
    std::vector<std::uint8_t> distance; ///< in cells along the axis that is farthest, 0: in it; x fastest
    std::uint64_t serial = 0;           ///< others have another
};

/// Leaves out of a frame what cannot be seen: cells of the volume in which every sample has an opacity of
/// exactly 0 under the active table. Keeps the slices while nothing changes; the ranges of voxels are in the
/// context's store.
class SpaceLeaping
{
public:
    /// The box round tetrahedra that fill boxes with nothing to be seen between them, as tetrahedra, borrowed
    /// until the next call; nothing when that cannot be told, or is not so. Only for states in which a
    /// fragment without opacity changes nothing.
    std::optional<TetraView> boxAround(ContextRecord& context, const FrameRequest& request);

    /// The slices of a frame, far to near in each brick; nullptr when they cannot be told (the volume is not
    /// in its place, or not a box; the texture has opacity everywhere) or are nearly all of them. Only for
    /// states in which a fragment without opacity changes nothing.
    const OccupiedSlices* slices(ContextRecord& context, const FrameRequest& request, const Camera& camera);

    /// The box that the tetrahedra fill; nullptr when they fill none, or not in the volume's place.
    const Box* domain(const FrameRequest& request);
    /// nullptr when that cannot be told, or more than a part `mostOccupied` of the cells has something. Only
    /// for states in which a fragment without opacity changes nothing.
    const EmptyCells* emptyCells(ContextRecord& context, const FrameRequest& request, double mostOccupied);

    void invalidate() { sliced_ = false; }
    /// Whether the last slices are those of the frame before.
    bool kept() const { return kept_; }
    int samples() const { return planes_.count; }
    /// Of the last slices; others have another.
    std::uint64_t serial() const { return serial_; }

private:
    struct KnownBrick
    {
        CellRangeKey key;
        std::shared_ptr<const CellRanges> ranges;
    };

    bool costsLess(const ContextRecord& context) const;
    bool findDomain(const TetraView& tetras);
    bool findUnion(const TetraView& tetras);
    bool showsOutsideUnion() const;
    bool findRanges(CellRangeStore& store, const FrameRequest& request, VoxelComponent component);
    bool findOccupied(ContextRecord& context, const FrameRequest& request);
    void markOccupied(const VisibleValues& visible);
    void joinCells();

    KeptTetras domainTetras_;
    std::optional<Box> domain_; ///< that the tetrahedra fill

    KeptTetras unionTetras_;
    std::optional<BoxUnion> union_;
    std::vector<float> aroundRecords_; ///< of its bounds
    bool unionShowsAll_ = false;       ///< in cells_ of unionCells_
    std::uint64_t unionCells_ = 0;

    std::vector<KnownBrick> bricks_;
    bool rangesChanged_ = false;
    std::uint64_t keyTables_[2] = {0, 0};
    OccupiedCells cells_;           ///< kCellSide wide
    std::uint64_t cellsSerial_ = 0; ///< others have another
    OccupiedCells blocks_;          ///< of kCellsPerBlock cells a side
    EmptyCells empty_;              ///< serial 0: not those of cells_
    bool pays_ = false;
    int framesToPass_ = 0; ///< before it is tried again whether less is drawn

    bool sliced_ = false;
    std::uint64_t serial_ = 0;
    bool kept_ = false;
    std::vector<Box> keyBoxes_;
    PlaneFamily planes_;
    OccupiedSlicer slicer_;
    OccupiedSlices slices_;
};

} // namespace vo
