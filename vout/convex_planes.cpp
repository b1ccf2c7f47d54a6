#include "vout/convex_planes.h"

#include "legacy/report.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

namespace vo {

namespace {

bool isFinite(const glm::dvec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// The smallest number of a vertex in the same place, by vertex.
std::vector<int> samePlaces(const TetraMesh& mesh)
{
    std::map<std::tuple<double, double, double>, int> first;
    std::vector<int> same;
    for (int vertex = 0; vertex < static_cast<int>(mesh.vertexCount()); ++vertex) {
        const glm::dvec3 p = isFinite(mesh.position(vertex)) ? mesh.position(vertex) : glm::dvec3(0);
        same.push_back(first.try_emplace({p.x, p.y, p.z}, vertex).first->second);
    }
    return same;
}

using Face = std::array<int, 3>;

/// Faces that belong to one tetrahedron only, counter-clockwise as seen from inside.
std::vector<Face> surfaceOf(const TetraMesh& mesh)
{
    const std::vector<int> same = samePlaces(mesh);
    std::map<Face, std::pair<Face, int>> faces; // by vertices in ascending order
    for (const auto& t : soundTetras(mesh))
        for (const Face& corners : {Face{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}) {
            Face face;
            for (std::size_t i = 0; i < 3; ++i)
                face[i] = same[static_cast<std::size_t>(t[static_cast<std::size_t>(corners[i])])];
            Face sorted = face;
            std::sort(sorted.begin(), sorted.end());
            ++faces.try_emplace(sorted, face, 0).first->second.second;
        }
    std::vector<Face> surface;
    for (const auto& [sorted, found] : faces)
        if (found.second == 1) surface.push_back(found.first);
    return surface;
}

struct SurfacePlane
{
    Face face;
    CutPlane plane;
    double area;
};

/// The largest faces first: their planes are the most exact.
std::vector<SurfacePlane> facePlanes(const TetraMesh& mesh)
{
    std::vector<SurfacePlane> planes;
    for (const Face& face : surfaceOf(mesh)) {
        const glm::dvec3 a = mesh.position(face[0]);
        const glm::dvec3 across = glm::cross(mesh.position(face[1]) - a, mesh.position(face[2]) - a);
        const double area = glm::length(across);
        if (area > 0) planes.push_back({face, {across / area, -glm::dot(across / area, a)}, area});
    }
    std::stable_sort(planes.begin(), planes.end(),
                     [](const SurfacePlane& a, const SurfacePlane& b) { return a.area > b.area; });
    return planes;
}

} // namespace

double snapDistance(const TetraMesh& mesh)
{
    double farthest = 0;
    for (const int vertex : mesh.tetras) {
        const glm::dvec3 p = glm::abs(mesh.position(vertex));
        if (isFinite(p)) farthest = std::max({farthest, p.x, p.y, p.z});
    }
    return std::ldexp(farthest, -20);
}

std::vector<CutPlane> planesRound(const TetraMesh& convex)
{
    // Planes of small faces of rounded corners are this far off on the other side of a flat one.
    const double tolerance = 4 * snapDistance(convex);
    const std::vector<SurfacePlane> faces = facePlanes(convex);
    if (faces.empty()) badValue("the convex set is empty");
    std::set<int> corners;
    for (const SurfacePlane& candidate : faces)
        corners.insert(candidate.face.begin(), candidate.face.end());
    std::vector<CutPlane> planes;
    for (const SurfacePlane& candidate : faces) {
        const bool isKnown = std::any_of(planes.begin(), planes.end(), [&](const CutPlane& plane) {
            return glm::dot(plane.inward, candidate.plane.inward) > 0 &&
                   std::all_of(candidate.face.begin(), candidate.face.end(), [&](int vertex) {
                       return std::abs(plane.distance(convex.position(vertex))) <= tolerance;
                   });
        });
        if (isKnown) continue;
        for (const int vertex : corners)
            if (candidate.plane.distance(convex.position(vertex)) < -tolerance)
                badValue("the set is not convex: vertex " + std::to_string(vertex) + " lies outside of the face " +
                         std::to_string(candidate.face[0]) + " " + std::to_string(candidate.face[1]) + " " +
                         std::to_string(candidate.face[2]));
        planes.push_back(candidate.plane);
    }
    return planes;
}

} // namespace vo
