#include "frame/space_leaping.h"

#include "cast/empty_blocks.h"
#include "core/log.h"
#include "core/serial.h"
#include "frame/frame.h"
#include "geometry/convex_set.h"
#include "lookup/visible_values.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vo {

namespace {

/// Where more of the cells are occupied, the slices as they are cost no more.
constexpr double kMostOccupied = 0.75;
/// What a voxel's length of a triangle's edge costs beside a voxel's square of its area: rasterisers shade
/// whole blocks of pixels, 4 x 4 in Mesa's software, 2 x 2 in hardware, and drop those outside.
constexpr double kEdgeOnProcessor = 2.0;
constexpr double kEdgeOnGraphicsCard = 0.5;
/// Slices have to cost less than this part of what they cost whole.
constexpr double kLeastGain = 0.95;
/// Frames without a gain after which it is tried again: the view may have turned.
constexpr int kFramesToPass = 15;
/// Polygons leave out blocks: smaller ones have more edges than they save.
constexpr int kCellsPerBlock = 2;
/// Larger sets of tetrahedra are not asked whether they fill a box: it takes too long.
constexpr int kMostTetras = 4096;

/// What decides whether a sample is seen.
struct OpacityRule
{
    VoxelComponent component;
    VisibleValues visible;
};

/// Nothing: every sample may have an opacity.
std::optional<OpacityRule> opacityRule(const ContextRecord& context, TexelFormat texel)
{
    const TableSlot* pre = activeTable(context, TableKind::preInterpolation);
    const TableSlot* post = activeTable(context, TableKind::postInterpolation);
    if (pre && post) return {};
    if (pre) return OpacityRule{VoxelComponent::alpha, VisibleValues(pre->table)};
    const VisibleValues visible = post ? VisibleValues(post->table) : VisibleValues();
    switch (texel) {
    case TexelFormat::intensity: return OpacityRule{VoxelComponent::red, visible};
    case TexelFormat::luminance:
        if (post) return OpacityRule{VoxelComponent::red, visible};
        return {};
    case TexelFormat::luminanceAlpha:
    case TexelFormat::rgba: return OpacityRule{VoxelComponent::alpha, visible};
    case TexelFormat::rgb: return {};
    }
    return {};
}

/// The box that the tetrahedra fill, if they do.
std::optional<Box> filledBox(const TetraView& tetras)
{
    const std::optional<ConvexSet> set = convexSet(tetras);
    if (!set || set->planes.size() != 6) return {};
    for (const glm::dvec4& plane : set->planes)
        if (std::max({std::abs(plane.x), std::abs(plane.y), std::abs(plane.z)}) < 1.0 - 1e-12) return {};
    Box box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
    for (const int vertex : tetras.indices) {
        box.lower = glm::min(box.lower, tetras.position(vertex));
        box.upper = glm::max(box.upper, tetras.position(vertex));
    }
    return box;
}

/// Five tetrahedra that fill a box, by its corners: number 4 z + 2 y + x.
constexpr int kBoxTetras[] = {0, 6, 5, 3, 0, 6, 2, 3, 1, 5, 0, 3, 6, 5, 7, 3, 5, 6, 4, 0};

std::vector<float> cornersOf(const Box& box)
{
    std::vector<float> corners;
    for (int corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            corners.push_back(static_cast<float>(corner >> axis & 1 ? box.upper[axis] : box.lower[axis]));
    return corners;
}

/// The brick's lower corner, if its voxels lie one a unit from whole, positive coordinates on.
std::optional<VoxelOrigin> wholeOrigin(const FrameBrick& brick)
{
    for (int axis = 0; axis < 3; ++axis) {
        const float at = brick.origin[axis];
        if (!(at >= 0.0f) || at > 1e6f || at != std::floor(at)) return {};
        if (brick.size[axis] != static_cast<float>(brick.image.size[axis])) return {};
    }
    return VoxelOrigin{static_cast<int>(brick.origin.x), static_cast<int>(brick.origin.y),
                       static_cast<int>(brick.origin.z)};
}

/// The ranges of a brick, found only where the store has them not; nullptr without voxels.
std::shared_ptr<const CellRanges> keptRanges(CellRangeStore& store, const CellRangeKey& key,
                                             const TextureImage& image)
{
    std::shared_ptr<const CellRanges> ranges = store.find(key);
    if (ranges || image.voxels.empty()) return ranges;
    debug(2, "ranges of a brick's voxels found");
    ranges = std::make_shared<const CellRanges>(
        cellRanges(image.voxels, image.format, image.size, key.origin, key.component));
    store.keep(key, ranges);
    return ranges;
}

double occupiedPart(const OccupiedCells& cells)
{
    const auto occupied = std::accumulate(cells.occupied.begin(), cells.occupied.end(), std::size_t{0});
    return static_cast<double>(occupied) / static_cast<double>(cells.occupied.size());
}

bool samePlanes(const PlaneFamily& a, const PlaneFamily& b)
{
    return a.normal == b.normal && a.first == b.first && a.spacing == b.spacing && a.count == b.count;
}

} // namespace

std::optional<TetraView> SpaceLeaping::boxAround(ContextRecord& context, const FrameRequest& request)
{
    if (request.layout.texCoord >= 0 || request.layout.color >= 0 || request.tetras.valuesPerVertex != 3 ||
        request.sampling.space == SamplingSpace::primitive || request.bricks.empty())
        return {};
    if (!findUnion(request.tetras) || !findOccupied(context, request)) return {};
    if (unionCells_ != cellsSerial_) {
        unionCells_ = cellsSerial_;
        unionShowsAll_ = !showsOutsideUnion();
    }
    if (!unionShowsAll_) return {};
    TetraView around;
    around.records = aroundRecords_;
    around.indices = kBoxTetras;
    return around;
}

/// False too for boxes that leave nothing out.
bool SpaceLeaping::findUnion(const TetraView& tetras)
{
    if (!unionTetras_.renew(tetras)) return union_.has_value();
    unionCells_ = 0;
    union_ = boxUnion(tetras);
    if (union_ && std::ranges::find(union_->covered, 0) == union_->covered.end()) union_.reset();
    if (union_) aroundRecords_ = cornersOf(union_->bounds);
    return union_.has_value();
}

bool SpaceLeaping::showsOutsideUnion() const
{
    const std::uint8_t* occupied = cells_.occupied.data();
    for (int z = 0; z < cells_.count.z; ++z)
        for (int y = 0; y < cells_.count.y; ++y)
            for (int x = 0; x < cells_.count.x; ++x) {
                if (!*occupied++) continue;
                const glm::dvec3 lower = static_cast<double>(cells_.side) * glm::dvec3(x, y, z);
                if (!union_->covers({lower, lower + static_cast<double>(cells_.side)})) return true;
            }
    return false;
}

const OccupiedSlices* SpaceLeaping::slices(ContextRecord& context, const FrameRequest& request,
                                           const Camera& camera)
{
    kept_ = false;
    const bool planar = request.sampling.mode != SamplingMode::spherical || !camera.perspective;
    if (request.layout.color >= 0 || !planar || request.sampling.space == SamplingSpace::primitive ||
        request.threshold > 0.0 || request.bricks.empty())
        return nullptr;
    if (!domain(request) || !findOccupied(context, request) || !pays_) return nullptr;

    const PlaneFamily planes = samplingPlanes(request.tetras, camera, request.sampling);
    const auto sameBox = [](const Box& a, const Box& b) { return a.lower == b.lower && a.upper == b.upper; };
    kept_ =
        sliced_ && samePlanes(planes, planes_) && std::ranges::equal(keyBoxes_, request.clipBoxes, sameBox);
    if (kept_) return &slices_;
    if (framesToPass_ > 0) {
        --framesToPass_;
        return nullptr;
    }
    planes_ = planes;
    serial_ = newSerial();
    keyBoxes_.assign(request.clipBoxes.begin(), request.clipBoxes.end());
    sliced_ = slicer_.slice(*domain_, request.clipBoxes, blocks_, planes, slices_);
    if (sliced_ && costsLess(context)) return &slices_;
    sliced_ = false;
    framesToPass_ = kFramesToPass;
    return nullptr;
}

const Box* SpaceLeaping::domain(const FrameRequest& request)
{
    if (request.layout.texCoord >= 0 || !findDomain(request.tetras)) return nullptr;
    return &*domain_;
}

const EmptyCells* SpaceLeaping::emptyCells(ContextRecord& context, const FrameRequest& request,
                                           double mostOccupied)
{
    if (request.bricks.empty() || !findOccupied(context, request)) return nullptr;
    if (occupiedPart(cells_) > mostOccupied) return nullptr;
    if (empty_.serial != 0) return &empty_;
    empty_.count = cells_.count;
    empty_.distance.resize(cells_.occupied.size());
    std::ranges::transform(cells_.occupied, empty_.distance.begin(), [](std::uint8_t occupied) {
        return static_cast<std::uint8_t>(occupied ? 0 : EmptyCells::kFarthest);
    });
    findBlockDistances({empty_.count.x, empty_.count.y, empty_.count.z}, empty_.distance.data());
    empty_.serial = newSerial();
    return &empty_;
}

bool SpaceLeaping::costsLess(const ContextRecord& context) const
{
    const double edge = context.quirks.drawsOnProcessor ? kEdgeOnProcessor : kEdgeOnGraphicsCard;
    return slices_.area + edge * slices_.perimeter < kLeastGain * slices_.wholeArea;
}

bool SpaceLeaping::findDomain(const TetraView& tetras)
{
    if (tetras.valuesPerVertex != 3 || tetras.tetraCount() > kMostTetras) return false;
    if (!domainTetras_.renew(tetras)) return domain_.has_value();
    sliced_ = false;
    framesToPass_ = 0;
    domain_ = filledBox(tetras);
    return domain_.has_value();
}

/// The ranges of all bricks; false when one has no voxels to look at.
bool SpaceLeaping::findRanges(CellRangeStore& store, const FrameRequest& request, VoxelComponent component)
{
    rangesChanged_ = rangesChanged_ || bricks_.size() != request.bricks.size();
    bricks_.resize(request.bricks.size());
    for (std::size_t i = 0; i < bricks_.size(); ++i) {
        const FrameBrick& brick = request.bricks[i];
        const std::optional<VoxelOrigin> origin = wholeOrigin(brick);
        if (brick.image.twoDimensional || !origin) return false;
        const CellRangeKey key{brick.image.id, brick.image.version, component, *origin};
        KnownBrick& known = bricks_[i];
        if (known.ranges && known.key == key) continue;
        known = {key, keptRanges(store, key, brick.image)};
        if (!known.ranges) return false;
        rangesChanged_ = true;
    }
    return true;
}

bool SpaceLeaping::findOccupied(ContextRecord& context, const FrameRequest& request)
{
    const TexelFormat texel = request.bricks[0].image.texel;
    const auto sameTexel = [&](const FrameBrick& brick) { return brick.image.texel == texel; };
    if (!std::ranges::all_of(request.bricks, sameTexel)) return false;
    const std::optional<OpacityRule> rule = opacityRule(context, texel);
    if (!rule || !findRanges(context.cellRanges, request, rule->component)) return false;
    const auto serial = [&](TableKind kind) {
        const TableSlot* slot = activeTable(context, kind);
        return slot ? slot->serial : 0;
    };
    const std::uint64_t tables[2] = {serial(TableKind::preInterpolation),
                                     serial(TableKind::postInterpolation)};
    if (!rangesChanged_ && std::ranges::equal(tables, keyTables_)) return true;
    std::ranges::copy(tables, keyTables_);
    rangesChanged_ = false;
    sliced_ = false;
    framesToPass_ = 0;
    markOccupied(rule->visible);
    return true;
}

void SpaceLeaping::markOccupied(const VisibleValues& visible)
{
    cells_.side = kCellSide;
    cells_.count = {};
    for (const KnownBrick& brick : bricks_) {
        const CellRanges& r = *brick.ranges;
        cells_.count = {std::max(cells_.count.x, r.first.x + r.count.x),
                        std::max(cells_.count.y, r.first.y + r.count.y),
                        std::max(cells_.count.z, r.first.z + r.count.z)};
    }
    cells_.occupied.assign(cells_.count.count(), 0);
    for (const KnownBrick& brick : bricks_) {
        const CellRanges& r = *brick.ranges;
        std::size_t number = 0;
        for (int z = 0; z < r.count.z; ++z)
            for (int y = 0; y < r.count.y; ++y) {
                std::uint8_t* row =
                    cells_.occupied.data() +
                    (static_cast<std::size_t>(r.first.z + z) * static_cast<std::size_t>(cells_.count.y) +
                     static_cast<std::size_t>(r.first.y + y)) *
                        static_cast<std::size_t>(cells_.count.x) +
                    r.first.x;
                for (int x = 0; x < r.count.x; ++x, ++number)
                    row[x] |= visible.any(r.ranges[number].low, r.ranges[number].high);
            }
    }
    joinCells();
    cellsSerial_ = newSerial();
    empty_.serial = 0;
    pays_ = occupiedPart(blocks_) <= kMostOccupied;
}

/// A block is occupied where one of its cells is.
void SpaceLeaping::joinCells()
{
    const auto blocks = [](int cells) { return (cells + kCellsPerBlock - 1) / kCellsPerBlock; };
    blocks_.side = kCellsPerBlock * cells_.side;
    blocks_.count = {blocks(cells_.count.x), blocks(cells_.count.y), blocks(cells_.count.z)};
    blocks_.occupied.assign(blocks_.count.count(), 0);
    const std::uint8_t* cell = cells_.occupied.data();
    for (int z = 0; z < cells_.count.z; ++z)
        for (int y = 0; y < cells_.count.y; ++y) {
            std::uint8_t* row = blocks_.occupied.data() + (static_cast<std::size_t>(z / kCellsPerBlock) *
                                                               static_cast<std::size_t>(blocks_.count.y) +
                                                           static_cast<std::size_t>(y / kCellsPerBlock)) *
                                                              static_cast<std::size_t>(blocks_.count.x);
            for (int x = 0; x < cells_.count.x; ++x)
                row[x / kCellsPerBlock] |= *cell++;
        }
}

} // namespace vo
