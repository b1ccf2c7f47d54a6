#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

/// Cross-sections computed another way than the library does: in the plane's own two coordinates, by
/// half-planes, in extended precision; and for a box from its closed form.
namespace exact {

using Real = long double;
using Point3 = glm::vec<3, Real>;
using Point2 = glm::vec<2, Real>;

/// The plane dot(normal, p) = offset with unit normal, and two directions in it.
struct Section
{
    Section(const glm::dvec3& normal, double offset)
    {
        const Real length = glm::length(Point3(normal));
        n = Point3(normal) / length;
        origin = n * (offset / length);
        const Point3 other = std::abs(n.x) < 0.6L ? Point3(1, 0, 0) : Point3(0, 1, 0);
        u = glm::normalize(glm::cross(n, other));
        v = glm::cross(n, u);
    }

    Point3 n, origin, u, v;
};

using Outline = std::vector<Point2>;

inline Outline square(Real half)
{
    return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

/// What is left where dot(normal, p) >= offset.
inline Outline clip(const Outline& outline, const Section& section, const Point3& normal, Real offset)
{
    const Point2 slope(glm::dot(normal, section.u), glm::dot(normal, section.v));
    const Real constant = glm::dot(normal, section.origin) - offset;
    Outline result;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point2& a = outline[i];
        const Point2& b = outline[(i + 1) % outline.size()];
        const Real da = glm::dot(slope, a) + constant;
        const Real db = glm::dot(slope, b) + constant;
        if (da >= 0) result.push_back(a);
        if ((da < 0) != (db < 0)) result.push_back(a + (b - a) * (da / (da - db)));
    }
    return result;
}

inline Real area(const Outline& outline)
{
    Real sum = 0;
    for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
        const Point2 a = outline[i] - outline[0];
        const Point2 b = outline[i + 1] - outline[0];
        sum += (a.x * b.y - a.y * b.x) / 2;
    }
    return std::abs(sum);
}

inline Outline clipToBox(Outline outline, const Section& section, const vo::Box& box)
{
    for (int axis = 0; axis < 3; ++axis) {
        Point3 normal(0);
        normal[axis] = 1;
        outline = clip(outline, section, normal, box.lower[axis]);
        outline = clip(outline, section, -normal, -static_cast<Real>(box.upper[axis]));
    }
    return outline;
}

inline Outline clipToTetra(Outline outline, const Section& section, const std::array<Point3, 4>& p)
{
    for (std::size_t i = 0; i < 4; ++i) {
        const Point3 &a = p[(i + 1) % 4], &b = p[(i + 2) % 4], &c = p[(i + 3) % 4];
        Point3 normal = glm::cross(b - a, c - a);
        const Real side = glm::dot(normal, p[i] - a);
        if (side == 0) return {};
        if (side < 0) normal = -normal;
        outline = clip(outline, section, normal, glm::dot(normal, a));
    }
    return outline;
}

/// Area of the plane inside both the tetrahedra and the box.
inline double sectionArea(const vo::TetraView& tetras, const vo::Box& box, const Section& section)
{
    Real sum = 0;
    for (int tetra = 0; tetra < tetras.tetraCount(); ++tetra) {
        std::array<Point3, 4> corners;
        Real low = HUGE_VALL, high = -HUGE_VALL;
        for (std::size_t i = 0; i < 4; ++i) {
            corners[i] = Point3(tetras.position(tetras.indices[static_cast<std::size_t>(tetra) * 4 + i]));
            const Real t = glm::dot(section.n, corners[i] - section.origin);
            low = std::min(low, t);
            high = std::max(high, t);
        }
        if (low > 0 || high < 0) continue;
        sum += area(clipToTetra(clipToBox(square(1e4L), section, box), section, corners));
    }
    return static_cast<double>(sum);
}

/// Area of the plane inside a box, by inclusion and exclusion over its corners. No component of the normal is
/// zero.
inline double boxSectionArea(const vo::Box& box, const Section& section)
{
    const Point3 n = glm::abs(section.n);
    Real sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        Point3 p;
        Real sign = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const bool far = (corner >> axis) & 1;
            if (far) sign = -sign;
            p[axis] = far == (section.n[axis] > 0) ? box.upper[axis] : box.lower[axis];
        }
        const Real below = glm::dot(section.n, section.origin - p);
        if (below > 0) sum += sign * below * below;
    }
    return static_cast<double>(std::max(Real(0), sum / (2 * n.x * n.y * n.z)));
}

} // namespace exact
