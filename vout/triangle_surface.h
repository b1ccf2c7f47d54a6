#pragma once

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace vo {

/// Triangles, three vertex numbers each. Counter-clockwise as seen from outside where a surface was oriented.
struct TriangleSurface
{
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<int, 3>> triangles;

    /// By the divergence theorem; of a closed surface.
    double volume() const;
    double area() const;
    /// NaN without vertices.
    glm::dvec3 lower() const;
    glm::dvec3 upper() const;
};

/// Vertices of equal coordinates become one, those without triangles are left out.
TriangleSurface merged(const TriangleSurface& surface);

/// Turns triangles so that neighbours go round alike, as far as that is possible.
void alignNeighbours(TriangleSurface& surface);

/// Throws CallerError, with counts, unless the surface has triangles, all of them have an area, every edge
/// has two that go round alike, and it touches itself in no vertex. Vertices must be merged.
void requireClosed(const TriangleSurface& surface);

/// The smallest angle, in degrees, that two triangles of an edge have between them within the surface, and
/// without it where that is asked for. The surface is oriented and closed.
double sharpestAngle(const TriangleSurface& surface, bool alsoWithout);

/// The parts that share no vertex: a number from 0 for each triangle.
std::vector<int> componentsOf(const TriangleSurface& surface);

} // namespace vo
