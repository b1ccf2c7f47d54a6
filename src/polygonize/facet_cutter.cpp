#include "polygonize/facet_cutter.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

constexpr int kFaces = 4;

/// cutEdge, also where rounding left both ends on one side: then the nearer end.
void cutNearestEdge(const double* from, const double* to, double fromDistance, double toDistance, int values,
                    double* out)
{
    if ((fromDistance < 0.0) == (toDistance < 0.0))
        (std::abs(fromDistance) < std::abs(toDistance) ? fromDistance : toDistance) = 0.0;
    if (fromDistance == 0.0 && toDistance == 0.0) toDistance = 1.0;
    cutEdge(from, to, fromDistance, toDistance, values, out);
}

} // namespace

FacetTetra::FacetTetra(const TetraView& tetras, int tetra)
    : values_(tetras.valuesPerVertex), voxelColumn_(tetras.voxelColumn)
{
    for (std::size_t i = 0; i < 4; ++i) {
        const float* source = tetras.record(tetras.indices[static_cast<std::size_t>(tetra) * 4 + i]);
        for (int value = 0; value < values_; ++value)
            records_.push_back(static_cast<double>(source[value]) + 0.0); // -0 and 0 are one place
    }
    bounds_ = {position(0), position(0)};
    for (int i = 1; i < 4; ++i)
        bounds_ = {glm::min(bounds_.lower, position(i)), glm::max(bounds_.upper, position(i))};
    for (int face = 0; face < kFaces; ++face)
        makeFace(face);
}

void FacetTetra::makeFace(int opposite)
{
    Face& face = faces_[static_cast<std::size_t>(opposite)];
    int next = 0;
    for (std::size_t i = 0; i < 3; ++i, ++next) {
        if (next == opposite) ++next;
        face.corners[i] = next;
    }
    std::sort(face.corners.begin(), face.corners.end(), [&](int a, int b) {
        const glm::dvec3 p = position(a), q = position(b);
        return std::lexicographical_compare(&p.x, &p.x + 3, &q.x, &q.x + 3);
    });
    const glm::dvec3 a = position(face.corners[0]);
    face.origin = a;
    face.normal = glm::cross(position(face.corners[1]) - a, position(face.corners[2]) - a);
    const double height = glm::dot(face.normal, position(opposite) - a);
    face.sign = height < 0.0 ? -1.0 : 1.0;
    face.keeps = height > 0.0;
    heights_[static_cast<std::size_t>(opposite)] = std::abs(height);
    if (!(std::abs(height) > 0.0) || !std::isfinite(height)) flat_ = true;
}

glm::dvec3 FacetTetra::position(int corner) const
{
    const double* p = record(corner) + values_ - 3;
    return {p[0], p[1], p[2]};
}

std::array<double, 4> FacetTetra::distances(const glm::dvec3& point) const
{
    std::array<double, 4> result;
    for (std::size_t f = 0; f < kFaces; ++f)
        result[f] = faces_[f].sign * glm::dot(faces_[f].normal, point - faces_[f].origin);
    return result;
}

void FacetCutter::cut(const FacetTetra& tetra, std::span<const FacetCorner> facet, CutPolygon& out)
{
    out.clear(tetra.values_, tetra.voxelColumn_);
    polygon_.clear();
    for (std::size_t i = 0; i < facet.size(); ++i)
        polygon_.push_back({kFaces + static_cast<int>(i), facet[i].distances});
    for (int face = 0; face < kFaces && !polygon_.empty(); ++face)
        clip(tetra, face);

    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const int before = polygon_[(i > 0 ? i : polygon_.size()) - 1].line;
        if (before == polygon_[i].line) continue; // no length
        place(tetra, facet, before, polygon_[i].line, out.grow());
        out.dropRepeat();
    }
    out.close();
}

void FacetCutter::clip(const FacetTetra& tetra, int face)
{
    const auto f = static_cast<std::size_t>(face);
    clipped_.clear();
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
        const Vertex& a = polygon_[i];
        const Vertex& b = polygon_[i + 1 < polygon_.size() ? i + 1 : 0];
        const bool aInside = tetra.isInside(face, a.distances[f]);
        if (aInside) clipped_.push_back(a);
        if (aInside == tetra.isInside(face, b.distances[f])) continue;
        Vertex met{aInside ? face : a.line, {}};
        const double place = a.distances[f] / (a.distances[f] - b.distances[f]);
        for (std::size_t other = 0; other < kFaces; ++other)
            met.distances[other] = a.distances[other] + place * (b.distances[other] - a.distances[other]);
        met.distances[f] = 0.0;
        clipped_.push_back(met);
    }
    std::swap(polygon_, clipped_);
}

void FacetCutter::place(const FacetTetra& tetra, std::span<const FacetCorner> facet, int before, int line,
                        double* record)
{
    if (before < kFaces && line < kFaces)
        onTetraEdge(tetra, facet, before, line, record);
    else if (before < kFaces)
        onFacetEdge(tetra, facet, line - kFaces, before, record);
    else if (line < kFaces)
        onFacetEdge(tetra, facet, before - kFaces, line, record);
    else
        insideTetra(tetra, facet[static_cast<std::size_t>(line - kFaces)], record);
}

void FacetCutter::insideTetra(const FacetTetra& tetra, const FacetCorner& corner, double* record)
{
    const double* first = tetra.record(0);
    std::copy_n(first, tetra.values_, record);
    for (int i = 1; i < kFaces; ++i) {
        const double share =
            corner.distances[static_cast<std::size_t>(i)] / tetra.heights_[static_cast<std::size_t>(i)];
        for (int value = 0; value < tetra.values_; ++value)
            record[value] += share * (tetra.record(i)[value] - first[value]);
    }
    for (int axis = 0; axis < 3; ++axis)
        record[tetra.values_ - 3 + axis] = corner.position[axis];
}

void FacetCutter::onFacetEdge(const FacetTetra& tetra, std::span<const FacetCorner> facet, int edge,
                              int number, double* record)
{
    const auto f = static_cast<std::size_t>(number);
    const FacetCorner& from = facet[static_cast<std::size_t>(edge)];
    const FacetCorner& to = facet[(static_cast<std::size_t>(edge) + 1) % facet.size()];
    glm::dvec3 p;
    cutNearestEdge(&from.position.x, &to.position.x, from.distances[f], to.distances[f], 3, &p.x);

    // Its place in the face's triangle, the same from both sides of the face.
    const FacetTetra::Face& face = tetra.faces_[f];
    const glm::dvec3 a = face.origin;
    const glm::dvec3 ab = tetra.position(face.corners[1]) - a, ac = tetra.position(face.corners[2]) - a;
    const double size = glm::dot(face.normal, face.normal);
    const double towardsB = glm::dot(glm::cross(p - a, ac), face.normal) / size;
    const double towardsC = glm::dot(glm::cross(ab, p - a), face.normal) / size;
    const double* first = tetra.record(face.corners[0]);
    for (int value = 0; value < tetra.values_; ++value)
        record[value] = first[value] + towardsB * (tetra.record(face.corners[1])[value] - first[value]) +
                        towardsC * (tetra.record(face.corners[2])[value] - first[value]);
    for (int axis = 0; axis < 3; ++axis)
        record[tetra.values_ - 3 + axis] = p[axis];
}

void FacetCutter::onTetraEdge(const FacetTetra& tetra, std::span<const FacetCorner> facet, int face,
                              int other, double* record)
{
    std::array<int, 2> ends{};
    int found = 0;
    for (int corner = 0; corner < kFaces; ++corner)
        if (corner != face && corner != other) ends[static_cast<std::size_t>(found++)] = corner;
    const glm::dvec3 origin = facet[0].position;
    const glm::dvec3 normal =
        facet.size() == 3 ? glm::cross(facet[1].position - origin, facet[2].position - origin)
                          : glm::cross(facet[2].position - origin, facet.back().position - facet[1].position);
    const double from = glm::dot(normal, tetra.position(ends[0]) - origin);
    const double to = glm::dot(normal, tetra.position(ends[1]) - origin);
    cutNearestEdge(tetra.record(ends[0]), tetra.record(ends[1]), from, to, tetra.values_, record);
}

} // namespace vo
