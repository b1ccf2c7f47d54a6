#include "vout/box_lattice.h"

#include "geometry/cell_space.h"
#include "legacy/report.h"

#include <glm/common.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <string>

namespace vo {

namespace {

constexpr int kRecord = 6; ///< T3F_V3F

bool isHeldByFloats(const glm::dvec3& point)
{
    return std::isfinite(static_cast<float>(point.x)) && std::isfinite(static_cast<float>(point.y)) &&
           std::isfinite(static_cast<float>(point.z));
}

void requireHeldByFloats(const glm::dvec3& position)
{
    if (!isHeldByFloats(position)) badValue("a vertex would leave the range of floats");
}

/// The voxel coordinates of records are exchanged with their positions.
void exchangeHalves(TetraMesh& mesh)
{
    for (auto record = mesh.records.begin(); record != mesh.records.end(); record += kRecord)
        std::swap_ranges(record, record + 3, record + 3);
}

} // namespace

Lattice::Lattice(const glm::ivec3& boxes, const glm::dvec3& lower, const glm::dvec3& upper)
    : boxes_(boxes), lower_(lower), upper_(upper)
{
    double vertices = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (boxes[axis] < 1)
            badValue(std::to_string(boxes[axis]) + " boxes along an axis, at least 1 are needed");
        if (!(lower[axis] < upper[axis])) badValue("the upper end of the box is not above the lower one");
        vertices *= boxes[axis] + 1.0;
    }
    if (!isHeldByFloats(lower) || !isHeldByFloats(upper)) badValue("the box is not finite");
    // Up to 24 tetrahedra a box, and fewer boxes than vertices.
    if (vertices > INT_MAX / (24 * VO_TETRA_VERTICES)) badValue("there are more boxes than can be numbered");
    positions_.resize(static_cast<std::size_t>(vertices));
    reset();
}

glm::dvec3 Lattice::voxel(int vertex) const
{
    const int line = boxes_.x + 1, lines = boxes_.y + 1;
    const glm::dvec3 at(vertex % line, vertex / line % lines, vertex / line / lines);
    return glm::mix(lower_, upper_, at / glm::dvec3(boxes_));
}

void Lattice::moveTo(std::vector<glm::dvec3> positions)
{
    std::for_each(positions.begin(), positions.end(), requireHeldByFloats);
    positions_ = std::move(positions);
}

void Lattice::moveVertex(int vertex, const glm::dvec3& position)
{
    requireHeldByFloats(position);
    positions_[static_cast<std::size_t>(vertex)] = position;
}

void Lattice::reset()
{
    for (int vertex = 0; vertex < vertexCount(); ++vertex)
        positions_[static_cast<std::size_t>(vertex)] = voxel(vertex);
}

TetraMesh Lattice::tetras(HexaSplit split) const
{
    // Boxes are split where none can be out of shape: in the volume.
    TetraMesh mesh;
    mesh.values = kRecord;
    mesh.records.reserve(positions_.size() * kRecord);
    for (int vertex = 0; vertex < vertexCount(); ++vertex)
        for (const glm::dvec3& point : {positions_[static_cast<std::size_t>(vertex)], voxel(vertex)})
            for (int axis = 0; axis < 3; ++axis)
                mesh.records.push_back(static_cast<float>(point[axis]));
    splitCells(boxGrid(boxes_), split, mesh);
    exchangeHalves(mesh);
    return mesh;
}

FoldCount countFolds(const TetraMesh& mesh)
{
    FoldCount count;
    for (std::size_t first = 0; first < mesh.tetras.size(); first += VO_TETRA_VERTICES) {
        glm::dvec3 corner[VO_TETRA_VERTICES], farthest(0), extent(0);
        for (std::size_t i = 0; i < VO_TETRA_VERTICES; ++i) {
            corner[i] = mesh.position(mesh.tetras[first + i]);
            farthest = glm::max(farthest, glm::abs(corner[i]));
            extent = glm::max(extent, glm::abs(corner[i] - corner[0]));
        }
        const auto largest = [](const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); };
        const double noise = std::ldexp(largest(extent) * largest(extent) * largest(farthest), -22);
        const double volume = sixfoldVolume(corner[0], corner[1], corner[2], corner[3]);
        if (std::abs(volume) <= noise)
            ++count.flat;
        else if (volume < 0)
            ++count.inverted;
    }
    return count;
}

} // namespace vo
