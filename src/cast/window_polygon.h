#pragma once

#include "cast/cast_request.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <vector>

namespace vo {

/// A vertex of a polygon in object space, with values that change linearly in it.
struct PolygonVertex
{
    static constexpr int kValues = 7; ///< three voxel coordinates, red, green, blue, alpha

    glm::dvec3 position{0.0};
    std::array<double, kValues> values{};
};

/// The same in the window: pixels from the left and the bottom, window depth, and 1 / clip w, which is above
/// 0.
struct WindowVertex
{
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
    double inverseW = 1.0;
    std::array<double, PolygonVertex::kValues> values{};
};

/// From object space to the window of a request, inside the view volume and the request's clip planes.
class WindowProjection
{
public:
    explicit WindowProjection(const CastRequest& request);

    bool perspective() const { return perspective_; }

    /// The part of a convex polygon that is seen, `seen` being empty when there is none. Edges are cut from
    /// the same end whichever polygon they are of. `polygon` is used up.
    void project(std::vector<PolygonVertex>& polygon, std::vector<WindowVertex>& seen);

private:
    bool isInside(const PolygonVertex& vertex, const glm::dvec4& clip) const;
    void cut(std::vector<PolygonVertex>& polygon);
    WindowVertex toWindow(const PolygonVertex& vertex, const glm::dvec4& clip) const;

    glm::dmat4 clipFromObject_;
    std::vector<glm::dvec4> halfSpaces_; ///< object space, dot(h, (p, 1)) >= 0 inside
    std::size_t callersPlanes_ = 0;      ///< the last so many
    bool perspective_ = false;
    double width_, height_, nearDepth_, farDepth_;
    std::vector<glm::dvec4> clip_;
    std::vector<PolygonVertex> scratch_;
    std::vector<double> distances_;
};

} // namespace vo
