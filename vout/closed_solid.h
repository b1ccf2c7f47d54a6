#pragma once

#include "vout/surface_mesher.h"
#include "vout/tetra_mesh.h"

#include <optional>

namespace vo {

/// No tetrahedron of a closed solid has a smaller dihedral angle, in degrees.
constexpr double kSmallestDihedral = 5;

/// What a closed surface bounds, and how fine its tetrahedra are.
struct ClosedSolid
{
    TriangleSurface surface; // oriented outwards, or empty
    std::optional<double> edge;
    std::optional<double> distance;
    double sharpAngle = 40;

    MeshSizes sizes() const;
};

/// The surface merged, checked and oriented. Throws CallerError.
TriangleSurface checkedSurface(const TriangleSurface& surface);

struct Box
{
    glm::dvec3 lower, upper;
};

/// Tetrahedra inside of the surface, and with a box those in the rest of it, on V3F records. Throws
/// CallerError.
std::array<TetraMesh, 2> tessellated(const ClosedSolid& solid, const std::optional<Box>& box);

/// The smallest angle between faces, in degrees; 0 or less for a tetrahedron that is flat or inside out.
double smallestDihedral(const TetraMesh& mesh);

} // namespace vo
