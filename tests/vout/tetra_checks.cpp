#include "tetra_checks.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

namespace vo::test {

namespace {

using Face = std::array<int, 3>;

/// Counter-clockwise as seen from outside.
std::array<Face, 4> facesOf(const std::array<int, 4>& t)
{
    return {{{t[0], t[2], t[1]}, {t[0], t[1], t[3]}, {t[1], t[2], t[3]}, {t[2], t[0], t[3]}}};
}

/// The face turned so that its smallest vertex comes first.
Face turned(Face face)
{
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
}

std::multiset<Face> allFaces(const Tetras& tetras)
{
    std::multiset<Face> faces;
    for (const auto& tetra : tetras.corners)
        for (const Face& face : facesOf(tetra))
            faces.insert(turned(face));
    return faces;
}

Face otherSide(const Face& face)
{
    return {face[0], face[2], face[1]};
}

double sixfold(const Tetras& tetras, const std::array<int, 4>& t)
{
    const glm::dvec3 a = tetras.position(t[0]);
    return glm::dot(glm::cross(tetras.position(t[1]) - a, tetras.position(t[2]) - a),
                    tetras.position(t[3]) - a);
}

std::string named(const std::array<int, 4>& t)
{
    return "tetrahedron " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           " " + std::to_string(t[3]);
}

using Points = std::array<glm::dvec3, 4>;

bool isSeparating(const glm::dvec3& axis, const Points& a, const Points& b, double tolerance)
{
    const double length = glm::length(axis);
    if (length == 0) return false;
    std::array<double, 4> onA, onB;
    for (std::size_t i = 0; i < 4; ++i) {
        onA[i] = glm::dot(axis, a[i]) / length;
        onB[i] = glm::dot(axis, b[i]) / length;
    }
    const auto [lowA, highA] = std::minmax_element(onA.begin(), onA.end());
    const auto [lowB, highB] = std::minmax_element(onB.begin(), onB.end());
    return *highA <= *lowB + tolerance || *highB <= *lowA + tolerance;
}

/// Two convex bodies are apart when a plane along a face of one or along an edge of each is between them.
bool areApart(const Points& a, const Points& b, double tolerance)
{
    for (const Points* points : {&a, &b})
        for (const Face& face : facesOf({0, 1, 2, 3})) {
            const auto at = [&](std::size_t i) { return (*points)[static_cast<std::size_t>(face[i])]; };
            if (isSeparating(glm::cross(at(1) - at(0), at(2) - at(0)), a, b, tolerance)) return true;
        }
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t l = k + 1; l < 4; ++l)
                    if (isSeparating(glm::cross(a[j] - a[i], b[l] - b[k]), a, b, tolerance)) return true;
    return false;
}

} // namespace

std::vector<Face> boundaryFaces(const Tetras& tetras)
{
    const std::multiset<Face> faces = allFaces(tetras);
    std::vector<Face> outer;
    for (const Face& face : faces)
        if (!faces.contains(otherSide(face))) outer.push_back(face);
    return outer;
}

glm::dvec3 Tetras::position(int vertex) const
{
    const std::vector<float>& record = records[static_cast<std::size_t>(vertex)];
    const float* p = record.data() + record.size() - 3;
    return {p[0], p[1], p[2]};
}

void Tetras::append(const Tetras& other)
{
    // Vertices of equal records are the same.
    std::map<std::vector<float>, int> known;
    for (std::size_t i = 0; i < records.size(); ++i)
        known.emplace(records[i], static_cast<int>(i));
    for (std::array<int, 4> tetra : other.corners) {
        for (int& corner : tetra) {
            const std::vector<float>& record = other.records[static_cast<std::size_t>(corner)];
            const auto [found, isNew] = known.try_emplace(record, static_cast<int>(records.size()));
            if (isNew) records.push_back(record);
            corner = found->second;
        }
        corners.push_back(tetra);
    }
}

Tetras taken(voIndexedTetraSet* set)
{
    EXPECT_NE(set, nullptr);
    if (!set) return {};
    const std::unique_ptr<voIndexedTetraSet> owned(set);
    Tetras tetras;
    tetras.values = set->getVertexData()->getValuesPerVertex();
    for (int i = 0; i < set->getVertexData()->getCount(); ++i) {
        const float* record = (*set->getVertexData())[i];
        tetras.records.emplace_back(record, record + tetras.values);
    }
    const voIndices& indices = *set->getIndices();
    EXPECT_EQ(indices.getCount() % 4, 0);
    for (int i = 0; i + 3 < indices.getCount(); i += 4) {
        tetras.corners.push_back({indices[i], indices[i + 1], indices[i + 2], indices[i + 3]});
        for (const int corner : tetras.corners.back())
            EXPECT_TRUE(corner >= 0 && corner < set->getVertexData()->getCount()) << corner;
    }
    return tetras;
}

double volumeOf(const Tetras& tetras)
{
    double sum = 0;
    for (const auto& tetra : tetras.corners)
        sum += sixfold(tetras, tetra);
    return sum / 6;
}

double areaOf(const Tetras& tetras)
{
    double sum = 0;
    for (const Face& face : boundaryFaces(tetras)) {
        const glm::dvec3 a = tetras.position(face[0]);
        sum += glm::length(glm::cross(tetras.position(face[1]) - a, tetras.position(face[2]) - a)) / 2;
    }
    return sum;
}

double smallestDihedral(const Tetras& tetras)
{
    double smallest = 180;
    for (const auto& tetra : tetras.corners) {
        std::array<glm::dvec3, 4> normals;
        const auto faces = facesOf(tetra);
        for (std::size_t f = 0; f < 4; ++f) {
            const glm::dvec3 a = tetras.position(faces[f][0]);
            normals[f] = glm::normalize(
                glm::cross(tetras.position(faces[f][1]) - a, tetras.position(faces[f][2]) - a));
        }
        for (std::size_t f = 0; f < 4; ++f)
            for (std::size_t g = f + 1; g < 4; ++g) {
                const double cosine = std::clamp(-glm::dot(normals[f], normals[g]), -1.0, 1.0);
                smallest = std::min(smallest, std::acos(cosine) * 180 / std::numbers::pi);
            }
    }
    return smallest;
}

std::vector<int> boundaryVertices(const Tetras& tetras)
{
    std::set<int> vertices;
    for (const Face& face : boundaryFaces(tetras))
        vertices.insert(face.begin(), face.end());
    return {vertices.begin(), vertices.end()};
}

std::string wrongHandedness(const Tetras& tetras)
{
    for (const auto& tetra : tetras.corners)
        if (!(sixfold(tetras, tetra) > 0)) return named(tetra) + " has no positive volume";
    return "";
}

std::string unmatchedFaces(const Tetras& tetras)
{
    const std::multiset<Face> faces = allFaces(tetras);
    for (const Face& face : faces)
        if (faces.count(face) > 1)
            return "a face of vertex " + std::to_string(face[0]) + " has two tetrahedra on one side";
    return "";
}

std::string overlaps(const Tetras& tetras)
{
    struct Placed
    {
        Points points;
        glm::dvec3 lower, upper;
        const std::array<int, 4>* tetra;
    };
    std::vector<Placed> placed;
    double size = 0;
    for (const auto& tetra : tetras.corners) {
        Placed p{{}, glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL), &tetra};
        for (std::size_t i = 0; i < 4; ++i) {
            p.points[i] = tetras.position(tetra[i]);
            p.lower = glm::min(p.lower, p.points[i]);
            p.upper = glm::max(p.upper, p.points[i]);
        }
        size = std::max(size, glm::length(p.upper - p.lower));
        placed.push_back(p);
    }
    std::sort(placed.begin(), placed.end(),
              [](const Placed& a, const Placed& b) { return a.lower.x < b.lower.x; });
    for (std::size_t i = 0; i < placed.size(); ++i)
        for (std::size_t j = i + 1; j < placed.size() && placed[j].lower.x < placed[i].upper.x; ++j)
            if (placed[j].lower.y < placed[i].upper.y && placed[i].lower.y < placed[j].upper.y &&
                placed[j].lower.z < placed[i].upper.z && placed[i].lower.z < placed[j].upper.z &&
                !areApart(placed[i].points, placed[j].points, 1e-9 * size))
                return named(*placed[i].tetra) + " overlaps " + named(*placed[j].tetra);
    return "";
}

double Surface::volume() const
{
    double sixfoldSum = 0;
    for (const auto& polygon : polygons)
        for (std::size_t i = 2; i < polygon.size(); ++i)
            sixfoldSum += glm::dot(polygon[0], glm::cross(polygon[i - 1], polygon[i]));
    return sixfoldSum / 6;
}

double Surface::area() const
{
    double sum = 0;
    for (const auto& polygon : polygons) {
        glm::dvec3 twofold(0);
        for (std::size_t i = 2; i < polygon.size(); ++i)
            twofold += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
        sum += glm::length(twofold) / 2;
    }
    return sum;
}

Surface boxSurface(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 far = corner + a + b + c;
    Surface surface;
    for (const auto& [u, v] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
        surface.polygons.push_back({corner, corner + v, corner + u + v, corner + u});
        surface.polygons.push_back({far, far - u, far - u - v, far - v});
    }
    return surface;
}

void expectSolid(const Tetras& tetras, double volume, double area)
{
    EXPECT_EQ(wrongHandedness(tetras), "");
    EXPECT_EQ(unmatchedFaces(tetras), "");
    EXPECT_EQ(overlaps(tetras), "");
    EXPECT_NEAR(volumeOf(tetras) / volume, 1, 1e-6);
    EXPECT_NEAR(areaOf(tetras) / area, 1, 1e-6);
}

void expectSolid(const Tetras& tetras, const Surface& surface)
{
    expectSolid(tetras, surface.volume(), surface.area());
}

} // namespace vo::test
