#include "vout/geodesic_solids.h"

#include "legacy/report.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace vo {

namespace {

using Triangle = std::array<int, 3>;

/// A unit sphere of triangles, counter-clockwise as seen from outside.
struct Sphere
{
    std::vector<glm::dvec3> vertices;
    std::vector<Triangle> triangles;
};

constexpr int kIcosahedronFaces = 20;
constexpr Triangle kIcosahedron[kIcosahedronFaces] = {
    {0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},   {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
    {3, 8, 9},  {4, 9, 5},  {2, 4, 11},  {6, 2, 10}, {8, 6, 7},   {9, 8, 1},
};

Sphere icosahedron()
{
    const double g = (1 + std::sqrt(5.0)) / 2; // golden ratio
    Sphere sphere{{{-1, g, 0},
                   {1, g, 0},
                   {-1, -g, 0},
                   {1, -g, 0},
                   {0, -1, g},
                   {0, 1, g},
                   {0, -1, -g},
                   {0, 1, -g},
                   {g, 0, -1},
                   {g, 0, 1},
                   {-g, 0, -1},
                   {-g, 0, 1}},
                  {std::begin(kIcosahedron), std::end(kIcosahedron)}};
    for (glm::dvec3& vertex : sphere.vertices)
        vertex = glm::normalize(vertex);
    return sphere;
}

/// Four triangles for each one; the middles of the edges are moved out to the sphere.
Sphere refined(const Sphere& coarse)
{
    Sphere fine{coarse.vertices, {}};
    fine.triangles.reserve(4 * coarse.triangles.size());
    std::unordered_map<std::uint64_t, int> middles; // an edge belongs to two triangles
    const auto middle = [&](int a, int b) {
        const auto edge = static_cast<std::uint64_t>(std::min(a, b)) << 32 | static_cast<std::uint64_t>(std::max(a, b));
        const auto [found, isNew] = middles.try_emplace(edge, static_cast<int>(fine.vertices.size()));
        if (isNew)
            fine.vertices.push_back(glm::normalize(fine.vertices[static_cast<std::size_t>(a)] +
                                                   fine.vertices[static_cast<std::size_t>(b)]));
        return found->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    return fine;
}

Sphere geodesicSphere(int level)
{
    Sphere sphere = icosahedron();
    for (int i = 0; i < level; ++i)
        sphere = refined(sphere);
    return sphere;
}

void checkLevel(int level, int tetrasEach)
{
    requireAtLeast("the level", level, 0);
    constexpr int kMostLevel = 24; // of triangles that 64 bits number
    requireCountable(std::size_t(kIcosahedronFaces) << 2 * std::min(level, kMostLevel), tetrasEach);
}

void addSphere(Solid& solid, const Sphere& sphere, const glm::dvec3& center, double radius)
{
    for (const glm::dvec3& vertex : sphere.vertices)
        solid.add(center + radius * vertex);
}

} // namespace

void check(const GeodesicBall& ball)
{
    requireFinite("the centre", ball.center);
    requirePositive("the radius", ball.radius);
    checkLevel(ball.level, 1);
}

Solid solidOf(const GeodesicBall& ball)
{
    const Sphere sphere = geodesicSphere(ball.level);
    Solid solid;
    addSphere(solid, sphere, ball.center, ball.radius);
    const int center = solid.add(ball.center);
    Cells tetras{CellKind::tetra, {}};
    for (const auto& [a, b, c] : sphere.triangles)
        tetras.add({a, b, c, center});
    solid.parts = {tetras};
    return solid;
}

void check(const GeodesicShell& shell)
{
    requireFinite("the centre", shell.center);
    requirePositive("the inner radius", shell.innerRadius);
    requirePositive("the outer radius", shell.outerRadius);
    if (shell.innerRadius >= shell.outerRadius) badValue("the inner radius is not less than the outer one");
    checkLevel(shell.level, 3);
}

Solid solidOf(const GeodesicShell& shell)
{
    const Sphere sphere = geodesicSphere(shell.level);
    Solid solid;
    addSphere(solid, sphere, shell.center, shell.innerRadius);
    addSphere(solid, sphere, shell.center, shell.outerRadius);
    const auto outer = static_cast<int>(sphere.vertices.size());
    solid.parts = {prismsOn(sphere.triangles, outer)};
    return solid;
}

} // namespace vo
