#pragma once

#include <glm/vec4.hpp>

#include <cstddef>
#include <vector>

namespace vo {

/// A convex polygon while it is being cut: records of doubles, `values` each, the position last.
struct CutPolygon
{
    int values = 3;
    int voxelColumn = 0; ///< where the three coordinates begin that boxes speak of
    int count = 0;
    std::vector<double> data; ///< at least count * values long

    double* record(int i)
    {
        return data.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(values);
    }
    const double* record(int i) const
    {
        return data.data() + static_cast<std::size_t>(i) * static_cast<std::size_t>(values);
    }
    const double* position(int i) const { return record(i) + values - 3; }
    const double* voxel(int i) const { return record(i) + voxelColumn; }

    /// Makes it empty, with room for what a box leaves of a slice. Boxes speak of the positions unless a
    /// column is given.
    void clear(int valuesPerRecord, int voxels = -1);
    /// Appends a record that is not one of this polygon's own.
    void push(const double* record);
    /// Appends a record and returns where the caller is to write it.
    double* grow();
    /// Takes the last record away again if its position is that of the one before.
    void dropRepeat();
    /// Takes the last record away while its position is that of the first; empties a polygon of fewer than 3.
    void close();
};

/// The point of an edge at which a distance that is linear along it is zero; `fromDistance` and `toDistance`
/// have different signs, or one of them is zero. The same bits whichever end comes first.
void cutEdge(const double* from, const double* to, double fromDistance, double toDistance, int values,
             double* out);

/// Cuts a tetrahedron of four records with a plane given by the signed distances of its vertices (>= 0 is in
/// front, so a vertex on the plane counts as in front). `out` gets 0, 3 or 4 records in order round the
/// polygon: counterclockwise seen from behind the plane when dot(v1 - v0, cross(v2 - v0, v3 - v0)) > 0.
void sliceTetra(const double* const vertices[4], const double distances[4], int values, CutPolygon& out,
                int voxelColumn = -1);
/// The same, where a bit for each vertex says which are in front.
void sliceTetra(const double* const vertices[4], const double distances[4], unsigned inFront, int values,
                CutPolygon& out, int voxelColumn);

} // namespace vo
