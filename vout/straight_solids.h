#pragma once

#include "vout/solid.h"

namespace vo {

// Solids with straight sides; check() and solidOf() as in round_solids.h.

struct BoxGrid
{
    glm::dvec3 corner;
    glm::dvec3 size;
    std::array<int, 3> cells;
    HexaSplit split = HexaSplit::five;
};
void check(const BoxGrid& box);
Solid solidOf(const BoxGrid& box);

struct Extrusion
{
    std::vector<glm::dvec3> polygon;
    glm::dvec3 line;
};
void check(const Extrusion& extrusion);
Solid solidOf(const Extrusion& extrusion);

} // namespace vo
