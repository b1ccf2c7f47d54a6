#pragma once

#include "vout/tetra_mesh.h"

#include <glm/geometric.hpp>

#include <vector>

namespace vo {

/// The points p with dot(inward, p) + offset = 0; `inward` has length 1.
struct CutPlane
{
    glm::dvec3 inward;
    double offset;

    double distance(const glm::dvec3& point) const { return glm::dot(inward, point) + offset; }
};

/// Planes closer to a vertex than this go through it: a few units in the last place of the largest coordinate.
double snapDistance(const TetraMesh& mesh);

/// The planes round a convex mesh, coplanar faces once. Throws CallerError for one that is not.
std::vector<CutPlane> planesRound(const TetraMesh& convex);

} // namespace vo
