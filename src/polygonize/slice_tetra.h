#pragma once

#include <glm/vec4.hpp>

#include <vector>

namespace vo {

/// A convex polygon while it is being cut: records of doubles, `values` each, the position last.
struct CutPolygon
{
    int values = 3;
    int count = 0;
    std::vector<double> data; ///< at least count * values long

    double* record(int i) { return data.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(values); }
    const double* record(int i) const
    {
        return data.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(values);
    }
    void clear(int valuesPerRecord);
    void push(const double* record);
};

/// Cuts a tetrahedron of four records with a plane given by the signed distances of its vertices (>= 0 is in front,
/// so a vertex on the plane counts as in front). `out` gets 0, 3 or 4 records in order round the polygon.
void sliceTetra(const double* const vertices[4], const double distances[4], int values, CutPolygon& out);

} // namespace vo
