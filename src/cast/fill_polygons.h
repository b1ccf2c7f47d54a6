#pragma once

#include "cast/cast_picture.h"
#include "cast/cast_request.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace vo {

/// Triangles of one brick, back to front.
struct PolygonRun
{
    int brick;
    std::size_t first; ///< of the indices
    std::size_t count;
};

/// The polygons of a frame, made before: records of the request's layout, three indices a triangle, runs to
/// be drawn as they come, from the back.
struct FramePolygons
{
    std::span<const float> records;
    std::span<const std::uint32_t> indices;
    std::span<const PolygonRun> runs;
};

/// Fills the clipped polygons of any set of tetrahedra: voxel coordinates, colours of vertices, many bricks.
/// Pixels whose centre is inside a polygon are its own, with vertices snapped to 1/256 pixel as rasterisers
/// do, so that neighbours share no pixel and leave none out. Keeps voxels rearranged for sampling until they
/// change.
class PolygonFiller
{
public:
    PolygonFiller();
    ~PolygonFiller();
    PolygonFiller(const PolygonFiller&) = delete;
    PolygonFiller& operator=(const PolygonFiller&) = delete;

    /// The frame, into memory that `picture` keeps from call to call. Only for requests without fillRefusal.
    void fill(const CastRequest& request, const FramePolygons& polygons, CastPicture& picture);

    /// Lets go of what was kept of a brick.
    void forget(std::uint64_t brickId);
    /// Bytes kept.
    std::size_t bytes() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// Why polygons of this request cannot be filled with the same result as by OpenGL; empty when they can.
std::string fillRefusal(const CastRequest& request);

} // namespace vo
