#include "vout/closed_solid.h"

#include "geometry/cell_space.h"
#include "legacy/report.h"

#include "vout/solid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

namespace vo {

namespace {

/// More tetrahedra are not begun: they would take several GB.
constexpr double kMostTetras = 5e6;

std::string printed(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

void requireFeasible(const MeshSizes& sizes, double volume, double area)
{
    if (sizes.distance < 1e-3 * sizes.edge)
        badValue("the facet distance is " + printed(sizes.distance) +
                 ", less than a thousandth of the edge length " + printed(sizes.edge));
    const double edge = sizes.edge;
    const double estimate = std::max(8.5 * volume / (edge * edge * edge), area / (edge * edge));
    if (!(estimate <= kMostTetras))
        badValue("the edge length " + printed(edge) + " would make about " + printed(estimate) +
                 " tetrahedra; at most " + printed(kMostTetras) + " are made");
}

void requireRoundSurface(const Box& box, const ClosedSolid& solid)
{
    requireFinite("the box's lower corner", box.lower);
    requireFinite("the box's upper corner", box.upper);
    const glm::dvec3 below = solid.surface.lower() - box.lower, above = box.upper - solid.surface.upper();
    const double clearance = std::min({below.x, below.y, below.z, above.x, above.y, above.z});
    if (!(clearance > solid.sizes().distance))
        badValue("the surface comes as near as " + printed(clearance) +
                 " to the box (less than 0: it reaches out of it); more than the facet distance " +
                 printed(solid.sizes().distance) + " is needed");
}

TriangleSurface surfaceOf(const Box& box)
{
    TriangleSurface surface;
    for (int corner = 0; corner < 8; ++corner)
        surface.vertices.push_back(
            glm::mix(box.lower, box.upper, glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2)));
    surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                         {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return surface;
}

std::array<TetraMesh, 2> inFloats(const RegionMesh& mesh)
{
    std::array<TetraMesh, 2> regions;
    std::array<std::vector<int>, 2> numbers;
    for (std::vector<int>& known : numbers)
        known.assign(mesh.vertices.size(), -1);
    for (std::size_t t = 0; t < mesh.tetras.size(); ++t) {
        const auto region = static_cast<std::size_t>(mesh.regions[t]);
        TetraMesh& own = regions[region];
        for (const int corner : mesh.tetras[t]) {
            int& number = numbers[region][static_cast<std::size_t>(corner)];
            if (number < 0) {
                number = static_cast<int>(own.vertexCount());
                const glm::dvec3& v = mesh.vertices[static_cast<std::size_t>(corner)];
                for (int axis = 0; axis < 3; ++axis)
                    own.records.push_back(static_cast<float>(v[axis]));
            }
            own.tetras.push_back(number);
        }
    }
    return regions;
}

double volumeOf(const TetraMesh& mesh)
{
    double sum = 0;
    for (std::size_t t = 0; t < mesh.tetras.size(); t += 4) {
        const int* v = &mesh.tetras[t];
        sum +=
            sixfoldVolume(mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2]), mesh.position(v[3]));
    }
    return sum / 6;
}

/// Of the tetrahedron a, b, c, d; NaN or 0 where it is flat.
double smallestDihedral(const std::array<glm::dvec3, 4>& p)
{
    if (!(sixfoldVolume(p[0], p[1], p[2], p[3]) > 0)) return 0;
    static constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    std::array<glm::dvec3, 4> normals;
    for (std::size_t f = 0; f < 4; ++f) {
        const auto at = [&](int i) { return p[static_cast<std::size_t>(faces[f][i])]; };
        normals[f] = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    }
    double largestCosine = -1;
    for (std::size_t f = 0; f < 4; ++f)
        for (std::size_t g = f + 1; g < 4; ++g)
            largestCosine = std::max(largestCosine, -glm::dot(normals[f], normals[g]));
    return std::acos(std::clamp(largestCosine, -1.0, 1.0)) * 180 / std::numbers::pi;
}

/// What is wrong with a mesh, or an empty text.
std::string faultOf(const std::array<TetraMesh, 2>& regions, const ClosedSolid& solid,
                    const std::optional<Box>& box)
{
    for (const TetraMesh& mesh : regions)
        if (const double angle = smallestDihedral(mesh); !(angle >= kSmallestDihedral))
            return "the smallest angle between faces of a tetrahedron stayed " + printed(angle) +
                   " degrees; at least " + printed(kSmallestDihedral) + " are promised";
    const double wanted = solid.surface.volume(), found = volumeOf(regions[0]);
    if (!(std::abs(found - wanted) <= std::min(solid.surface.area() * solid.sizes().distance, 0.1 * wanted)))
        return "tetrahedra of this size fill a volume of " + printed(found) + " in place of " +
               printed(wanted);
    if (!box) return "";
    const glm::dvec3 size = box->upper - box->lower;
    const double both = found + volumeOf(regions[1]), whole = size.x * size.y * size.z;
    if (!(std::abs(both - whole) <= 1e-6 * whole))
        return "tetrahedra of this size fill " + printed(both) + " of the box, whose volume is " +
               printed(whole);
    return "";
}

} // namespace

MeshSizes ClosedSolid::sizes() const
{
    const double length = edge.value_or(glm::length(surface.upper() - surface.lower()) / 20);
    return {length, distance.value_or(length / 20), sharpAngle};
}

TriangleSurface checkedSurface(const TriangleSurface& surface)
{
    for (const glm::dvec3& vertex : surface.vertices)
        requireFinite("a vertex", vertex);
    TriangleSurface checked = merged(surface);
    requireClosed(checked);
    if (const std::size_t pairs = countCrossings(checked))
        badValue("the surface crosses itself: " + std::to_string(pairs) +
                 (pairs == 1 ? " pair of triangles meets" : " pairs of triangles meet"));
    orientOutwards(checked);
    return checked;
}

double smallestDihedral(const TetraMesh& mesh)
{
    double smallest = 180;
    for (std::size_t t = 0; t < mesh.tetras.size(); t += 4) {
        std::array<glm::dvec3, 4> corners;
        for (std::size_t i = 0; i < 4; ++i)
            corners[i] = mesh.position(mesh.tetras[t + i]);
        smallest = std::min(smallest, smallestDihedral(corners));
    }
    return smallest;
}

std::array<TetraMesh, 2> tessellated(const ClosedSolid& solid, const std::optional<Box>& box)
{
    if (solid.surface.triangles.empty()) badValue("there is no surface");
    std::optional<TriangleSurface> round;
    if (box) {
        requireRoundSurface(*box, solid);
        round = surfaceOf(*box);
    }
    const TriangleSurface& outermost = round ? *round : solid.surface;
    requireFeasible(solid.sizes(), outermost.volume(), outermost.area());
    if (const double angle = sharpestAngle(solid.surface, box.has_value()); angle < kSmallestDihedral)
        unsupported("the surface has an edge of " + printed(angle) +
                    " degrees, and so would tetrahedra; at least " + printed(kSmallestDihedral) +
                    " are promised");
    // Another size makes other tetrahedra, where one size left some too flat.
    std::string fault;
    static constexpr double tries[][2] = {{1, 0.9}, {1, 0.8}, {0.9, 0.7}, {0.7, 0.6}, {0.5, 0.5}};
    for (const auto& [factor, clearanceShare] : tries) {
        MeshSizes sizes = solid.sizes();
        sizes.edge *= factor;
        sizes.distance *= factor;
        sizes.clearanceShare = clearanceShare;
        const auto regions = inFloats(meshInside(solid.surface, round ? &*round : nullptr, sizes));
        const std::string found = faultOf(regions, solid, box);
        if (found.empty()) return regions;
        if (fault.empty()) fault = found;
    }
    unsupported("with the edge length " + printed(solid.sizes().edge) + ": " + fault);
}

} // namespace vo
