#pragma once

#include "cast/cast_picture.h"
#include "cast/cast_request.h"

#include <cstddef>
#include <cstdint>
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

/// Why polygons of this request cannot be filled with the same result as by OpenGL; empty when they can.
std::string fillRefusal(const CastRequest& request);

/// Fills the clipped polygons of any set of tetrahedra: voxel coordinates, colours of vertices, many bricks.
/// Pixels whose centre is inside a polygon are its own, with vertices snapped to 1/256 pixel as rasterisers
/// do, so that neighbours share no pixel and leave none out.
void fillPolygons(const CastRequest& request, const FramePolygons& polygons, CastPicture& picture);

} // namespace vo
