#pragma once

#include "cast/cast_request.h"
#include "geometry/convex_set.h"
#include "polygonize/camera.h"

#include <glm/vec3.hpp>

#include <array>
#include <span>
#include <vector>

namespace vo {

/// A number that changes evenly over the picture: at + dx * x + dy * y for the pixel (x, y) of the viewport.
struct PixelRamp
{
    double at = 0.0;
    double dx = 0.0;
    double dy = 0.0;

    double operator()(double x, double y) const { return at + dx * x + dy * y; }
    friend PixelRamp operator+(const PixelRamp& a, const PixelRamp& b)
    {
        return {a.at + b.at, a.dx + b.dx, a.dy + b.dy};
    }
    friend PixelRamp operator*(double s, const PixelRamp& a) { return {s * a.at, s * a.dx, s * a.dy}; }
};

/// Points origin + t * direction that are kept: origin + t * direction <= slack, for numbers of both.
struct RayBound
{
    PixelRamp origin;
    PixelRamp direction;
    double slack = 0.0;
};

/// A rectangle of pixels, ends excluded.
struct PixelRectangle
{
    int left = 0, bottom = 0, right = 0, top = 0;

    int width() const { return right - left; }
    int height() const { return top - bottom; }
    bool empty() const { return left >= right || bottom >= top; }
};

/// The rays through the centres of all pixels, origin + t * direction in object space, and the places along
/// them where sampling planes or shells lie: sample j, from the nearest (0) to count - 1, at t = (nearest +
/// j * spacing) / along. Ranges of t are bounded by all of `bounds`.
struct RayFrame
{
    std::array<PixelRamp, 3> origin;
    std::array<PixelRamp, 3> direction;
    bool shells = false;
    PixelRamp nearest; ///< planes: offset of the nearest, less that of the origin. Shells: radius
    PixelRamp along;   ///< planes: change of the offset with t. Shells: length(direction / scale)
    glm::dvec3 scale{1.0};
    double spacing = 1.0;
    int count = 0;
    std::vector<RayBound> bounds;
    /// Clip coordinates z and w, for depths a pixel.
    RayBound clipZ, clipW;
    PixelRectangle pixels; ///< of which others see nothing

    /// Whether all rays have the same direction.
    bool isParallel() const;
};

/// The rays of a request's view, with those bounds that all of its parts share: the view volume and the clip
/// planes. `pixels` is the whole viewport.
RayFrame rayFrame(const CastRequest& request, const Camera& camera);

/// Adds bounds: a box in voxels, closed and with the tolerance that polygons have (docs/frames.md), and a
/// convex polyhedron. Shrinks `pixels` to where the box is seen.
void boundByBox(const CastRequest& request, const Box& box, RayFrame& frame);
void boundByConvexSet(const ConvexSet& set, RayFrame& frame);

} // namespace vo
