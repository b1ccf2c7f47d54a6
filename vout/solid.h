#pragma once

#include "vout/split_cells.h"

namespace vo {

/// Cells on vertices in double precision.
struct Solid
{
    std::vector<glm::dvec3> vertices;
    std::vector<Cells> parts;
    HexaSplit split = HexaSplit::five;

    int add(const glm::dvec3& vertex)
    {
        vertices.push_back(vertex);
        return static_cast<int>(vertices.size()) - 1;
    }
};

/// The solid's tetrahedra on vertices in floats. Throws CallerError where floats do not tell its vertices apart.
TetraMesh tessellated(const Solid& solid);

// Checks of parameters, by name; they throw CallerError.
void requireFinite(const char* name, const glm::dvec3& point);
void requirePositive(const char* name, double length);
void requireAtLeast(const char* name, int number, int least);

} // namespace vo
