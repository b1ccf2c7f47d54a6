#include "frame/march_frame.h"

#include "frame/cast_frame.h"
#include "sort/brick_order.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace vo {

namespace {

// What a fragment that takes all samples of a brick costs, measured in Mesa's software, in fragments of
// polygons: for itself, and for each sample in cells that are empty or not. It has to save a tenth.
constexpr double kCostOfBrick = 7.0;
constexpr double kCostOfSample = 0.2;
constexpr double kMoreWhereOccupied = 1.25;
constexpr double kLeastGain = 0.9;

/// The part of the cells that may be occupied for that to cost less.
double mostOccupied(std::span<const Box> boxes, const SampleRamps& ramps)
{
    double thickness = 0.0;
    for (const Box& box : boxes) {
        const glm::dvec3 size = box.upper - box.lower;
        thickness += std::cbrt(size.x * size.y * size.z) / static_cast<double>(boxes.size());
    }
    const double step = glm::length(glm::dvec3(ramps.step[0].at, ramps.step[1].at, ramps.step[2].at));
    const double samples = thickness / step;
    return (kLeastGain - kCostOfSample - kCostOfBrick / samples) / kMoreWhereOccupied;
}

/// Polygons that frames have in common, or each tetrahedron for itself, are no planes of the view.
bool hasOwnPlanes(const FrameRequest& request)
{
    return request.threshold == 0.0 && request.sampling.space != SamplingSpace::primitive &&
           request.sampling.stackAxis < 0 && request.layout.color < 0;
}

/// State in which fragments without opacity may be left out, and all of a pixel be joined.
bool readJoinableState(ContextRecord& context, const FrameRequest& request, const DrawState& draw,
                       CompositingState& state)
{
    const bool unbounded = isUnbounded(context, request, draw);
    return clearFragmentsLeaveNoTrace(context) && !unbounded &&
           readCompositingState(context, draw, unbounded, state).empty() && !state.depthTest &&
           (state.blending.color == CastBlending::over || state.blending.color == CastBlending::alphaSum) &&
           state.viewport[2] > 0 && state.viewport[3] > 0;
}

bool fits(const ContextRecord& context, const VoxelSize& cells)
{
    return std::max({cells.x, cells.y, cells.z}) <= context.max3dSize;
}

using Corner = std::array<double, 3>;

std::set<Corner> lowerCorners(std::span<const Box> boxes)
{
    std::set<Corner> corners;
    for (const Box& box : boxes)
        corners.insert({box.lower.x, box.lower.y, box.lower.z});
    return corners;
}

/// For each axis whether another box begins where this one ends.
std::array<bool, 3> upperBelongsElsewhere(const Box& box, const std::set<Corner>& lowers)
{
    std::array<bool, 3> belongs{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Corner next{box.lower.x, box.lower.y, box.lower.z};
        next[axis] = box.upper[static_cast<int>(axis)];
        belongs[axis] = lowers.contains(next);
    }
    return belongs;
}

} // namespace

std::optional<MarchedFrame> marchedFrame(ContextRecord& context, const FrameRequest& request,
                                         const DrawState& draw, const Camera& camera, SpaceLeaping& leaping)
{
    if (!context.quirks.drawsOnProcessor || !hasOwnPlanes(request)) return {};
    MarchedFrame frame;
    if (!readJoinableState(context, request, draw, frame.state)) return {};
    const CastRequest rays = viewRequest(request, draw, frame.state);
    const RayFrame everywhere = rayFrame(rays, camera);
    const std::optional<SampleRamps> ramps = sampleRamps(everywhere);
    if (!ramps || !SampleMarch::canBound(*ramps)) return {};
    frame.ramps = *ramps;
    const Box* domain = leaping.domain(request);
    if (!domain) return {};
    const EmptyCells* cells = leaping.emptyCells(context, request, mostOccupied(request.clipBoxes, *ramps));
    if (!cells || !fits(context, cells->count)) return {};
    frame.cells = {kCellSide, cells->count, cells->distance, cells->serial};

    const std::set<Corner> lowers = lowerCorners(request.clipBoxes);
    for (const int brick : backToFront(request.clipBoxes, camera)) {
        const Box& box = request.clipBoxes[static_cast<std::size_t>(brick)];
        const FrameBrick& texture = request.bricks[static_cast<std::size_t>(brick)];
        MarchedBrick place{{glm::max(box.lower, domain->lower), glm::min(box.upper, domain->upper)},
                           upperBelongsElsewhere(box, lowers),
                           texture.origin,
                           texture.size};
        RayFrame seen = everywhere;
        boundByBox(rays, place.box, seen);
        frame.parts.push_back({brick, place, seen.pixels});
    }
    return frame;
}

} // namespace vo
