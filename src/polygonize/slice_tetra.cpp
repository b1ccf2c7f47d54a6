#include "polygonize/slice_tetra.h"

#include "polygonize/tetra_sections.h"

#include <algorithm>
#include <utility>

namespace vo {

namespace {

/// A slice has 4 vertices and each of the 6 planes of a box adds at most one.
constexpr int kUsualVertices = 12;

bool samePosition(const double* a, const double* b, int values)
{
    return std::equal(a + values - 3, a + values, b + values - 3);
}

/// By position, then by the rest: an order that does not depend on who asks.
bool comesBefore(const double* a, const double* b, int values)
{
    for (int i = values - 3; i < values; ++i)
        if (a[i] != b[i]) return a[i] < b[i];
    return std::lexicographical_compare(a, a + values - 3, b, b + values - 3);
}

} // namespace

void CutPolygon::clear(int valuesPerRecord, int voxels)
{
    values = valuesPerRecord;
    voxelColumn = voxels >= 0 ? voxels : values - 3;
    count = 0;
    const std::size_t usual = static_cast<std::size_t>(kUsualVertices) * static_cast<std::size_t>(values);
    if (data.size() < usual) data.resize(usual);
}

double* CutPolygon::grow()
{
    const std::size_t needed = static_cast<std::size_t>(count + 1) * static_cast<std::size_t>(values);
    if (data.size() < needed) data.resize(2 * needed);
    return record(count++);
}

void CutPolygon::push(const double* source)
{
    std::copy_n(source, values, grow());
}

void CutPolygon::dropRepeat()
{
    if (count > 1 && samePosition(record(count - 1), record(count - 2), values)) --count;
}

void CutPolygon::close()
{
    while (count > 1 && samePosition(record(count - 1), record(0), values))
        --count;
    if (count < 3) count = 0;
}

void cutEdge(const double* from, const double* to, double fromDistance, double toDistance, int values,
             double* out)
{
    if (comesBefore(to, from, values)) {
        std::swap(from, to);
        std::swap(fromDistance, toDistance);
    }
    const double s = fromDistance / (fromDistance - toDistance);
    if (s == 0.0 || s == 1.0) {
        std::copy_n(s == 0.0 ? from : to, values, out);
        return;
    }
    for (int i = 0; i < values; ++i)
        out[i] = from[i] + s * (to[i] - from[i]);
}

void sliceTetra(const double* const vertices[4], const double distances[4], int values, CutPolygon& out,
                int voxelColumn)
{
    unsigned inFront = 0;
    for (unsigned i = 0; i < 4; ++i)
        inFront |= (distances[i] >= 0.0 ? 1u : 0u) << i;
    sliceTetra(vertices, distances, inFront, values, out, voxelColumn);
}

void sliceTetra(const double* const vertices[4], const double distances[4], unsigned inFront, int values,
                CutPolygon& out, int voxelColumn)
{
    out.clear(values, voxelColumn);
    const TetraSection& section = kTetraSections[inFront];
    for (int i = 0; i < section.count; ++i) {
        const auto [front, behind] = section.edges[static_cast<std::size_t>(i)];
        cutEdge(vertices[front], vertices[behind], distances[front], distances[behind], values, out.grow());
        out.dropRepeat();
    }
    out.close();
}

} // namespace vo
