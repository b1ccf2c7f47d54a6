#pragma once

#include "vout/solid.h"

namespace vo {

// Solids of refined icosahedra; check() and solidOf() as in round_solids.h.

struct GeodesicBall
{
    glm::dvec3 center;
    double radius;
    int level; ///< how many times each triangle is divided into four
};
void check(const GeodesicBall& ball);
Solid solidOf(const GeodesicBall& ball);

/// What lies between two of them.
struct GeodesicShell
{
    glm::dvec3 center;
    double innerRadius;
    double outerRadius;
    int level;
};
void check(const GeodesicShell& shell);
Solid solidOf(const GeodesicShell& shell);

} // namespace vo
