// Solids from a few numbers, by what holds of their tetrahedra (tetra_checks.h) and by facets from closed
// forms.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/utSolids.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <type_traits>

namespace {

using namespace vo::test;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Numbers of a test, always the same.
class Numbers
{
public:
    explicit Numbers(unsigned seed) : random_(seed) {}
    float real(double from, double to)
    {
        return static_cast<float>(std::uniform_real_distribution<double>(from, to)(random_));
    }
    int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

private:
    std::mt19937 random_;
};

template <typename Solid, typename... Arguments>
Tetras tetrasOf(Arguments... arguments)
{
    Solid solid(arguments...);
    voutGeometry& geometry = solid;
    const Tetras tetras = taken(geometry.tessellate());
    expectNoError();
    return tetras;
}

dvec3 onCircle(double angle, double radius, double z)
{
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

Surface moved(Surface surface, const dvec3& by)
{
    for (auto& polygon : surface.polygons)
        for (dvec3& p : polygon)
            p += by;
    return surface;
}

/// A solid of revolution about z of flat facets: its outline is (radius, z) from bottom to top. Radius 0 is a
/// point.
Surface revolved(const std::vector<std::array<double, 2>>& outline, int slices)
{
    Surface surface;
    for (int i = 0; i < slices; ++i) {
        const double a = 2 * kPi * i / slices, b = 2 * kPi * (i + 1) / slices;
        for (std::size_t j = 1; j < outline.size(); ++j) {
            const auto [r0, z0] = outline[j - 1];
            const auto [r1, z1] = outline[j];
            std::vector<dvec3> facet;
            if (r0 > 0) facet.push_back(onCircle(a, r0, z0));
            facet.push_back(onCircle(b, r0, z0));
            facet.push_back(onCircle(b, r1, z1));
            if (r1 > 0) facet.push_back(onCircle(a, r1, z1));
            surface.polygons.push_back(facet);
        }
    }
    return surface;
}

Surface ballSurface(double radius, int slices, int stacks)
{
    std::vector<std::array<double, 2>> outline;
    for (int stack = 0; stack <= stacks; ++stack) {
        const bool isPole = stack == 0 || stack == stacks;
        const double angle = kPi * stack / stacks;
        outline.push_back({isPole ? 0 : radius * std::sin(angle), -radius * std::cos(angle)});
    }
    return revolved(outline, slices);
}

/// The refined icosahedron: neighbours of the twelve corners are nearest to each other.
Surface geodesicSurface(double radius, int level)
{
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<dvec3> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double one : {-1.0, 1.0})
            for (const double golden : {-g, g}) {
                dvec3 p(0);
                p[axis] = one;
                p[(axis + 1) % 3] = golden;
                corners.push_back(p);
            }
    Surface surface;
    const auto near = [](const dvec3& a, const dvec3& b) { return glm::distance(a, b) < 2.1; };
    for (const dvec3& a : corners)
        for (const dvec3& b : corners)
            for (const dvec3& c : corners)
                if (&a < &b && &a < &c && &b != &c && near(a, b) && near(b, c) && near(c, a) &&
                    glm::dot(glm::cross(b - a, c - a), a) > 0)
                    surface.polygons.push_back({glm::normalize(a), glm::normalize(b), glm::normalize(c)});
    for (; level > 0; --level) {
        Surface finer;
        for (const auto& t : surface.polygons) {
            const dvec3 ab = glm::normalize(t[0] + t[1]), bc = glm::normalize(t[1] + t[2]),
                        ca = glm::normalize(t[2] + t[0]);
            finer.polygons.insert(finer.polygons.end(),
                                  {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
        }
        surface = finer;
    }
    for (auto& triangle : surface.polygons)
        for (dvec3& p : triangle)
            p *= radius;
    return surface;
}

void expectBoundaryAtDistance(const Tetras& tetras, const dvec3& center, double radius)
{
    for (const int vertex : boundaryVertices(tetras))
        EXPECT_NEAR(glm::distance(tetras.position(vertex), center) / radius, 1, 1e-6);
}

TEST(Surfaces, haveTheVolumesOfTheBooks)
{
    const double g = (1 + std::sqrt(5.0)) / 2, edge = 2 / std::sqrt(g * std::sqrt(5.0));
    EXPECT_NEAR(geodesicSurface(1, 0).volume(), 5 * (3 + std::sqrt(5.0)) / 12 * edge * edge * edge, 1e-12);
    EXPECT_NEAR(ballSurface(1, 400, 400).volume(), 4 * kPi / 3, 1e-3);
    EXPECT_NEAR(ballSurface(1, 4, 2).volume(), 4.0 / 3, 1e-12) << "an octahedron";
}

TEST(VoutSphere, isASolidOfTheFacetsOfSlicesAndStacks)
{
    Numbers numbers(1);
    for (int round = 0; round < 25; ++round) {
        const float radius = numbers.real(0.01, 500);
        const float x = radius * numbers.real(-1, 1), y = radius * numbers.real(-1, 1),
                    z = radius * numbers.real(-1, 1);
        const int slices = numbers.whole(3, 24), stacks = numbers.whole(2, 16);
        SCOPED_TRACE(std::to_string(slices) + " slices, " + std::to_string(stacks) + " stacks");
        const Tetras tetras = tetrasOf<voutSphere>(x, y, z, radius, slices, stacks);
        EXPECT_EQ(tetras.values, 3);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(2 * slices * (stacks - 1)));
        expectSolid(tetras, moved(ballSurface(radius, slices, stacks), {x, y, z}));
        expectBoundaryAtDistance(tetras, {x, y, z}, radius);
    }
}

TEST(VoutSphere, hasNoNeedlesButThoseOfItsPoles)
{
    // All slices share the edge from the centre to a pole; nothing is much thinner than they are there.
    for (const int slices : {12, 24, 32})
        for (const int stacks : {slices, slices / 2})
            EXPECT_GT(smallestDihedral(tetrasOf<voutSphere>(0.f, 0.f, 0.f, 1.f, slices, stacks)),
                      0.8 * 360 / slices);
}

TEST(VoutGeoSphere, isASolidOfTheFacetsOfARefinedIcosahedron)
{
    Numbers numbers(2);
    for (int level = 0; level <= 3; ++level) {
        const float radius = numbers.real(0.01, 500);
        const float x = radius * numbers.real(-1, 1), y = radius * numbers.real(-1, 1),
                    z = radius * numbers.real(-1, 1);
        const Tetras tetras = tetrasOf<voutGeoSphere>(x, y, z, radius, level);
        EXPECT_EQ(tetras.corners.size(), 20u << 2 * level);
        expectSolid(tetras, moved(geodesicSurface(radius, level), {x, y, z}));
        expectBoundaryAtDistance(tetras, {x, y, z}, radius);
    }
}

TEST(VoutGeoSphere, hasTetrahedraOfNearlyTheSameShape)
{
    for (int level = 0; level <= 4; ++level)
        EXPECT_GT(smallestDihedral(tetrasOf<voutGeoSphere>(1.f, 2.f, 3.f, 5.f, level)), 53) << level;
}

TEST(VoutShell, isASolidBetweenTwoBalls)
{
    Numbers numbers(3);
    for (int level = 0; level <= 2; ++level)
        for (const double part : {0.1, 0.5, 0.97}) {
            const float outer = numbers.real(1, 500),
                        inner = static_cast<float>(part * static_cast<double>(outer));
            const float x = outer * numbers.real(-0.3, 0.3), y = outer * numbers.real(-0.3, 0.3), z = 0;
            const Tetras tetras = tetrasOf<voutShell>(x, y, z, inner, outer, level);
            EXPECT_EQ(tetras.corners.size(), 60u << 2 * level);
            Surface surface = geodesicSurface(outer, level);
            for (std::vector<dvec3> triangle : geodesicSurface(inner, level).polygons) {
                std::reverse(triangle.begin(), triangle.end());
                surface.polygons.push_back(triangle);
            }
            expectSolid(tetras, moved(surface, {x, y, z}));
        }
}

TEST(VoutCylinder, isASolidOfItsFacets)
{
    Numbers numbers(4);
    for (int round = 0; round < 15; ++round) {
        const float radius = numbers.real(0.1, 50),
                    height = numbers.real(0.2, 3) * radius * (round % 3 ? 1.f : -1.f);
        const float x = radius * numbers.real(-1, 1), y = radius * numbers.real(-1, 1),
                    z = radius * numbers.real(-1, 1);
        const int slices = numbers.whole(3, 20), stacks = numbers.whole(1, 5);
        const Tetras tetras = tetrasOf<voutCylinder>(x, y, z, radius, height, slices, stacks);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * slices * stacks));
        const double r = radius, low = std::min(height, 0.f), high = std::max(height, 0.f);
        expectSolid(tetras, moved(revolved({{0, low}, {r, low}, {r, high}, {0, high}}, slices), {x, y, z}));
    }
}

TEST(VoutCone, isASolidOfItsFacets)
{
    Numbers numbers(5);
    for (int round = 0; round < 15; ++round) {
        const float radius = numbers.real(0.1, 50), height = numbers.real(0.2, 3) * radius;
        const float x = radius * numbers.real(-1, 1), y = radius * numbers.real(-1, 1),
                    z = radius * numbers.real(-1, 1);
        const int slices = numbers.whole(3, 20), stacks = numbers.whole(1, 5);
        const Tetras tetras = tetrasOf<voutCone>(x, y, z, radius, height, slices, stacks);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(slices * (3 * stacks - 2)));
        expectSolid(tetras, moved(revolved({{0, 0}, {radius, 0}, {0, height}}, slices), {x, y, z}));
    }
}

TEST(VoutCylinder, stretchesBetweenAnyTwoPointsAsDoesACone)
{
    Numbers numbers(6);
    for (int round = 0; round < 15; ++round) {
        const float from[3] = {numbers.real(-1, 1), numbers.real(-1, 1), numbers.real(-1, 1)};
        float to[3] = {numbers.real(-2, 2), numbers.real(-2, 2), numbers.real(-2, 2)};
        if (round < 6) { // along each axis, both ways
            std::copy(from, from + 3, to);
            to[round / 2] += round % 2 ? 2.f : -2.f;
        }
        const float radius = numbers.real(0.2, 2);
        const int slices = numbers.whole(3, 12);
        const double r = radius,
                     height = glm::distance(dvec3(from[0], from[1], from[2]), dvec3(to[0], to[1], to[2]));
        const Surface cylinder = revolved({{0, 0}, {r, 0}, {r, height}, {0, height}}, slices);
        const Tetras tetras = tetrasOf<voutCylinder>(from, to, radius, slices, 2);
        expectSolid(tetras, cylinder.volume(), cylinder.area());
        // The middles of both ends are where they were asked for.
        EXPECT_EQ(tetras.records.front(), std::vector<float>(from, from + 3));
        const Surface cone = revolved({{0, 0}, {r, 0}, {0, height}}, slices);
        const Tetras coneTetras = tetrasOf<voutCone>(from, to, radius, slices, 2);
        expectSolid(coneTetras, cone.volume(), cone.area());
        EXPECT_EQ(coneTetras.records.front(), std::vector<float>(from, from + 3));
        EXPECT_EQ(coneTetras.records.back(), std::vector<float>(to, to + 3));
    }
}

TEST(VoutTorus, isASolidOfItsFacets)
{
    Numbers numbers(7);
    for (int round = 0; round < 15; ++round) {
        const float radius = numbers.real(0.1, 50), tube = numbers.real(0.1, 0.95) * radius;
        const float x = radius * numbers.real(-1, 1), y = radius * numbers.real(-1, 1),
                    z = radius * numbers.real(-1, 1);
        const int slices = numbers.whole(3, 16), sides = numbers.whole(3, 9);
        const Tetras tetras = tetrasOf<voutTorus>(x, y, z, radius, tube, slices, sides);
        EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(3 * slices * sides));
        std::vector<std::array<double, 2>> outline;
        for (int side = 0; side <= sides; ++side) {
            const double angle = 2 * kPi * side / sides;
            outline.push_back({radius + tube * std::cos(angle), tube * std::sin(angle)});
        }
        const Surface surface = revolved(outline, slices);
        const double section = sides / 2.0 * tube * tube * std::sin(2 * kPi / sides);
        EXPECT_NEAR(surface.volume() / (slices * std::sin(2 * kPi / slices) * section * radius), 1, 1e-9);
        expectSolid(tetras, moved(surface, {x, y, z}));
    }
}

TEST(VoutBox, isASolidByEverySplit)
{
    Numbers numbers(8);
    for (int round = 0; round < 6; ++round) {
        const dvec3 corner(numbers.real(-2, 2), numbers.real(-2, 2), numbers.real(-2, 2));
        const dvec3 size(numbers.real(1, 9), numbers.real(1, 9), numbers.real(1, 9));
        const int columns = numbers.whole(1, 4), rows = numbers.whole(1, 3), layers = numbers.whole(1, 3);
        voutBox box(float(corner.x), float(corner.y), float(corner.z), float(size.x), float(size.y),
                    float(size.z), columns, rows, layers);
        for (const int split : {5, 6, 24}) {
            box.setTetrasPerHexa(split);
            EXPECT_EQ(box.getTetrasPerHexa(), split);
            const Tetras tetras = taken(box.tessellate());
            EXPECT_EQ(tetras.corners.size(), static_cast<std::size_t>(split * columns * rows * layers));
            expectSolid(tetras, boxSurface(corner, {size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}));
        }
        box.setTetrasPerHexa(7);
        expectBadValue("7 tetrahedra in a box");
        EXPECT_EQ(box.getTetrasPerHexa(), 24);
    }
    EXPECT_EQ(tetrasOf<voutBox>(0.f, 0.f, 0.f, 1.f, 1.f, 1.f).corners.size(), 5u);
}

// Polygons along a line.

Tetras extruded(const std::vector<dvec3>& polygon, const dvec3& line)
{
    std::vector<float> coordinates;
    for (const dvec3& p : polygon)
        for (int axis = 0; axis < 3; ++axis)
            coordinates.push_back(static_cast<float>(p[axis]));
    const float along[3] = {float(line.x), float(line.y), float(line.z)};
    auto solid = std::make_unique<voutExtrusion>(coordinates.data(), static_cast<int>(polygon.size()), along);
    std::fill(coordinates.begin(), coordinates.end(), 0.0f); // it has a copy
    const Tetras tetras = taken(solid->tessellate());
    expectNoError();
    return tetras;
}

void expectExtrusion(const std::vector<dvec3>& polygon, const dvec3& line)
{
    Surface surface;
    std::vector<dvec3> top = polygon;
    for (dvec3& p : top)
        p += line;
    surface.polygons = {{polygon.rbegin(), polygon.rend()}, top};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const std::size_t j = (i + 1) % polygon.size();
        surface.polygons.push_back({polygon[i], polygon[j], top[j], top[i]});
    }
    const Tetras tetras = extruded(polygon, line);
    EXPECT_EQ(tetras.corners.size(), 3 * (polygon.size() - 2));
    expectSolid(tetras, std::abs(surface.volume()), surface.area());
}

TEST(VoutExtrusion, takesConcavePolygonsRoundEitherWay)
{
    Numbers numbers(9);
    for (int round = 0; round < 30; ++round) {
        // A star about the origin, on a plane that leans.
        const int count = numbers.whole(3, 24);
        std::vector<dvec3> polygon;
        for (int i = 0; i < count; ++i) {
            dvec3 p = onCircle(2 * kPi * (i + static_cast<double>(numbers.real(-0.3, 0.3))) / count,
                               numbers.real(0.2, 2), 0);
            p.z = 0.3 * p.x - 0.2 * p.y;
            polygon.push_back(p);
        }
        if (round % 2) std::reverse(polygon.begin(), polygon.end());
        expectExtrusion(polygon, {numbers.real(-1, 1), numbers.real(-1, 1), numbers.real(0.5, 2)});
        expectExtrusion(polygon, {numbers.real(-1, 1), numbers.real(-1, 1), numbers.real(-2, -0.5)});
    }
}

TEST(VoutExtrusion, takesLettersWithPointsAlongTheirSides)
{
    const std::vector<dvec3> e{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {2, 2, 0}, {2, 3, 0},
                               {1, 3, 0}, {1, 4, 0}, {3, 4, 0}, {3, 5, 0}, {0, 5, 0}, {0, 3, 0}, {0, 1, 0}};
    expectExtrusion(e, {0, 0, 1});
    expectExtrusion(e, {1, 2, -3});
    std::vector<dvec3> comb;
    for (int tooth = 0; tooth < 12; ++tooth) {
        comb.push_back({2.0 * tooth, 0, 0});
        comb.push_back({2.0 * tooth + 1, 0, 0});
        comb.push_back({2.0 * tooth + 1, 10, 0});
        comb.push_back({2.0 * tooth + 2, 10, 0});
    }
    comb.push_back({24, 11, 0});
    comb.push_back({0, 11, 0});
    expectExtrusion(comb, {0, 0, 2});
}

TEST(VoutExtrusion, takesASpiral)
{
    std::vector<dvec3> spiral;
    for (int i = 0; i <= 60; ++i)
        spiral.push_back(onCircle(0.2 * i, 1 + 0.1 * i, 0));
    for (int i = 60; i >= 0; --i)
        spiral.push_back(onCircle(0.2 * i, 0.7 + 0.1 * i, 0));
    expectExtrusion(spiral, {0, 0, 3});
}

TEST(VoutExtrusion, takesPolygonsThatAreNotFlat)
{
    // The volume is that of its vector area along the line.
    std::vector<dvec3> polygon{{0, 0, 0.5}, {2, 0, -0.3}, {1, 0.5, 0.2}, {2, 2, 0}, {0, 2, 0.7}};
    const dvec3 line(0, 0, 3);
    const Tetras tetras = extruded(polygon, line);
    EXPECT_EQ(wrongHandedness(tetras), "");
    EXPECT_EQ(unmatchedFaces(tetras), "");
    EXPECT_EQ(overlaps(tetras), "");
    EXPECT_NEAR(volumeOf(tetras), 3 * 3, 1e-5);
}

TEST(VoutExtrusion, polygonsThatMeetThemselvesAreRefused)
{
    const auto expectRefused = [](const std::vector<float>& polygon, float x, float y, float z,
                                  const char* text) {
        const float line[3] = {x, y, z};
        voutExtrusion solid(polygon.data(), static_cast<int>(polygon.size() / 3), line);
        expectBadValue(text);
        EXPECT_EQ(solid.tessellate(), nullptr);
        expectBadValue(text);
    };
    expectRefused({0, 0, 0, 1, 1, 0, 1, 0, 0, 0, 1, 0}, 0, 0, 1, "after points 0 and 2 of the polygon meet");
    expectRefused({0, 0, 0, 4, 0, 0, 4, 4, 0, 2, 0, 0, 0, 4, 0}, 0, 0, 1, "meet"); // touches a side
    expectRefused({0, 0, 0, 4, 0, 0, 0, 0, 0, 0, 4, 0}, 0, 0, 1, "meet");          // goes back
    expectRefused({0, 0, 0, 4, 0, 0, 4, 4, 0, 0, 0, 0}, 0, 0, 1, "meet");          // closed by hand
    expectRefused({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0}, 0, 0, 1, "meet");          // has no area
    expectRefused({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, 1, 1, 0, "meet");          // nor along such a line
    expectRefused({0, 0, 0, 1, 0, 0, 1, 1, 0}, 0, 0, 0, "the line's length is 0");
    expectRefused({0, 0, 0, 1, 0, 0, 1, 1, 0}, 0, kNaN, 0, "the line is");
    expectRefused({0, 0, 0, 1, kNaN, 0, 1, 1, 0}, 0, 0, 1, "a point is");
    expectRefused({0, 0, 0, 1, 0, 0}, 0, 0, 1, "3 or more are needed");
}

TEST(VoutExtrusion, missingArraysAreRefused)
{
    const float polygon[9] = {0, 0, 0, 1, 0, 0, 1, 1, 0}, line[3] = {0, 0, 1};
    voutExtrusion noPolygon(nullptr, 3, line);
    expectBadValue("polygon is NULL");
    EXPECT_EQ(noPolygon.tessellate(), nullptr);
    expectBadValue();
    voutExtrusion noLine(polygon, 3, nullptr);
    expectBadValue("line is NULL");
    EXPECT_EQ(noLine.tessellate(), nullptr);
    expectBadValue();
    voutExtrusion negative(polygon, INT_MIN, line);
    expectBadValue("3 or more are needed");
}

// What every solid shares.

TEST(VoutSolids, giveANewSetEachTimeThatOutlivesThem)
{
    auto ball = std::make_unique<voutSphere>(0.f, 0.f, 0.f, 100.f, 32, 32);
    voIndexedTetraSet* first = ball->tessellate();
    voIndexedTetraSet* second = ball->tesselate();
    EXPECT_NE(first, second);
    ball.reset();
    const Tetras a = taken(first), b = taken(second);
    EXPECT_EQ(a.corners, b.corners);
    EXPECT_EQ(a.records, b.records);
    EXPECT_FALSE(std::is_copy_constructible_v<voutSphere>);
    EXPECT_FALSE(std::is_copy_assignable_v<voutExtrusion>);
}

template <typename Solid, typename... Arguments>
void expectRefused(const std::string& text, Arguments... arguments)
{
    SCOPED_TRACE(text);
    Solid solid(arguments...);
    expectBadValue(text);
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectBadValue(text);
    EXPECT_EQ(solid.tesselate(), nullptr);
    expectBadValue("::tessellate: ");
}

TEST(VoutSolids, numbersThatGiveNoneAreRefused)
{
    for (const float wrong : {0.f, -1.f, kNaN, kInfinity}) {
        expectRefused<voutSphere>("the radius is", 0.f, 0.f, 0.f, wrong, 8, 8);
        expectRefused<voutGeoSphere>("the radius is", 0.f, 0.f, 0.f, wrong, 1);
        expectRefused<voutShell>("the inner radius is", 0.f, 0.f, 0.f, wrong, 2.f, 1);
        expectRefused<voutShell>("radius is", 0.f, 0.f, 0.f, 1.f, wrong, 1);
        expectRefused<voutCylinder>("the radius is", 0.f, 0.f, 0.f, wrong, 1.f, 8, 8);
        expectRefused<voutCone>("the radius is", 0.f, 0.f, 0.f, wrong, 1.f, 8, 8);
        expectRefused<voutTorus>("the radius is", 0.f, 0.f, 0.f, wrong, 1.f, 8, 8);
        expectRefused<voutTorus>("the tube's radius is", 0.f, 0.f, 0.f, 1.f, wrong, 8, 8);
        expectRefused<voutBox>("the width is", 0.f, 0.f, 0.f, wrong, 1.f, 1.f);
        expectRefused<voutBox>("the height is", 0.f, 0.f, 0.f, 1.f, wrong, 1.f);
        expectRefused<voutBox>("the depth is", 0.f, 0.f, 0.f, 1.f, 1.f, wrong);
    }
    for (const float wrong : {kNaN, kInfinity}) {
        expectRefused<voutSphere>("the centre is", 0.f, wrong, 0.f, 1.f, 8, 8);
        expectRefused<voutGeoSphere>("the centre is", wrong, 0.f, 0.f, 1.f, 1);
        expectRefused<voutShell>("the centre is", 0.f, 0.f, wrong, 1.f, 2.f, 1);
        expectRefused<voutCylinder>("the base is", wrong, 0.f, 0.f, 1.f, 1.f, 8, 8);
        expectRefused<voutCylinder>("the top is", 0.f, 0.f, 0.f, 1.f, wrong, 8, 8);
        expectRefused<voutCone>("the base is", 0.f, wrong, 0.f, 1.f, 1.f, 8, 8);
        expectRefused<voutTorus>("the centre is", 0.f, 0.f, wrong, 2.f, 1.f, 8, 8);
        expectRefused<voutBox>("the corner is", wrong, 0.f, 0.f, 1.f, 1.f, 1.f);
    }
    expectRefused<voutShell>("not less than", 0.f, 0.f, 0.f, 2.f, 2.f, 1);
    expectRefused<voutTorus>("not less than", 0.f, 0.f, 0.f, 1.f, 1.f, 8, 8);
    expectRefused<voutCylinder>("the height is 0", 0.f, 0.f, 0.f, 1.f, 0.f, 8, 8);
    expectRefused<voutCone>("the height is 0", 0.f, 0.f, 0.f, 1.f, 0.f, 8, 8);
}

TEST(VoutSolids, tooFewPartsAreRefused)
{
    for (const int wrong : {2, 0, -1, INT_MIN}) {
        expectRefused<voutSphere>("slices: ", 0.f, 0.f, 0.f, 1.f, wrong, 8);
        expectRefused<voutCylinder>("slices: ", 0.f, 0.f, 0.f, 1.f, 1.f, wrong, 8);
        expectRefused<voutCone>("slices: ", 0.f, 0.f, 0.f, 1.f, 1.f, wrong, 8);
        expectRefused<voutTorus>("slices: ", 0.f, 0.f, 0.f, 2.f, 1.f, wrong, 8);
        expectRefused<voutTorus>("sides: ", 0.f, 0.f, 0.f, 2.f, 1.f, 8, wrong);
    }
    for (const int wrong : {0, -1, INT_MIN}) {
        expectRefused<voutSphere>("stacks: ", 0.f, 0.f, 0.f, 1.f, 8, wrong);
        expectRefused<voutCylinder>("stacks: ", 0.f, 0.f, 0.f, 1.f, 1.f, 8, wrong);
        expectRefused<voutCone>("stacks: ", 0.f, 0.f, 0.f, 1.f, 1.f, 8, wrong);
        expectRefused<voutBox>("columns: ", 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, wrong, 1, 1);
        expectRefused<voutBox>("rows: ", 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, 1, wrong, 1);
        expectRefused<voutBox>("layers: ", 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, 1, 1, wrong);
    }
    expectRefused<voutSphere>("stacks: 1, 2 or more", 0.f, 0.f, 0.f, 1.f, 8, 1);
    expectRefused<voutGeoSphere>("the level: -1", 0.f, 0.f, 0.f, 1.f, -1);
    expectRefused<voutShell>("the level: -1", 0.f, 0.f, 0.f, 1.f, 2.f, -1);
}

TEST(VoutSolids, moreThanCanBeNumberedAreRefusedBeforeMemoryIsAskedFor)
{
    const std::string text = "can be numbered";
    expectRefused<voutSphere>(text, 0.f, 0.f, 0.f, 1.f, INT_MAX, INT_MAX);
    expectRefused<voutSphere>(text, 0.f, 0.f, 0.f, 1.f, 65536, 65536); // 0 in 32 bits
    expectRefused<voutCylinder>(text, 0.f, 0.f, 0.f, 1.f, 1.f, INT_MAX, INT_MAX);
    expectRefused<voutCone>(text, 0.f, 0.f, 0.f, 1.f, 1.f, 65536, 65536);
    expectRefused<voutTorus>(text, 0.f, 0.f, 0.f, 2.f, 1.f, 65536, 65536);
    expectRefused<voutBox>(text, 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, INT_MAX, INT_MAX, INT_MAX);
    expectRefused<voutBox>(text, 0.f, 0.f, 0.f, 1.f, 1.f, 1.f, 4194304, 4194304, 1048576); // 0 in 64 bits
    for (const int level : {13, 16, 31, 32, INT_MAX})
        expectRefused<voutGeoSphere>(text, 0.f, 0.f, 0.f, 1.f, level);
    expectRefused<voutShell>(text, 0.f, 0.f, 0.f, 1.f, 2.f, 12);
}

TEST(VoutSolids, thoseThatFloatsCannotHoldAreRefused)
{
    const auto expectNone = [](voutGeometry&& solid, const char* text) {
        expectNoError();
        EXPECT_EQ(solid.tessellate(), nullptr);
        expectBadValue(text);
    };
    const char* const text = "floats do not tell its vertices apart";
    expectNone(voutSphere(1e9f, 0, 0, 1, 8, 8), text);
    expectNone(voutGeoSphere(0, 1e9f, 0, 1, 2), text);
    expectNone(voutShell(0, 0, 1e7f, 1, 1.1f, 1), text);
    expectNone(voutCylinder(1e9f, 0, 0, 1, 1, 8, 2), text);
    expectNone(voutCone(0, 1e9f, 0, 1, 1, 8, 2), text);
    expectNone(voutTorus(0, 0, 1e9f, 2, 1, 8, 8), text);
    expectNone(voutBox(1e9f, 0, 0, 1, 1, 1, 2, 2, 2), text);
    expectNone(voutSphere(3e38f, 0, 0, 3e38f, 8, 8), "farther than floats do");
    const float polygon[9] = {1e9f, 0, 0, 1.0001e9f, 0, 0, 1e9f, 1, 0}, line[3] = {0, 0, 1e-3f};
    EXPECT_GT(volumeOf(taken(voutExtrusion(polygon, 3, line).tessellate())), 0)
        << "thin, but floats can hold it";
}

TEST(VoutSolids, fineOnesAreNotTakenForFlat)
{
    const Tetras ball = tetrasOf<voutSphere>(0.f, 0.f, 0.f, 1.f, 400, 300);
    EXPECT_EQ(ball.corners.size(), 2u * 400 * 299);
    EXPECT_NEAR(volumeOf(ball) / ballSurface(1, 400, 300).volume(), 1, 1e-6);
}

TEST(VoutCylinder, missingPointsAreRefused)
{
    const float point[3] = {1, 2, 3};
    const float* missing = nullptr;
    voutCylinder noBase(missing, point, 1, 8, 1);
    expectBadValue("base is NULL");
    EXPECT_EQ(noBase.tessellate(), nullptr);
    expectBadValue();
    voutCylinder noTop(point, missing, 1, 8, 1);
    expectBadValue("top is NULL");
    voutCone noTip(point, missing, 1, 8, 1);
    expectBadValue("tip is NULL");
    EXPECT_EQ(noTip.tessellate(), nullptr);
    expectBadValue();
    voutCone noHeight(point, point, 1, 8, 1);
    expectBadValue("the height is 0");
}

} // namespace
