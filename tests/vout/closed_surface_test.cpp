// Tetrahedra of closed surfaces, by what holds of them (tetra_checks.h), by closed forms of solids with flat
// sides, and by the distance from the surface that was given.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/utClosedSurface.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace {

using namespace vo::test;
using glm::dvec3;

constexpr double kPi = std::numbers::pi;

/// Triangles on vertices in floats, as they are handed over.
struct Triangles
{
    std::vector<float> vertices;
    std::vector<int> indices;

    int add(const dvec3& vertex)
    {
        for (int axis = 0; axis < 3; ++axis)
            vertices.push_back(static_cast<float>(vertex[axis]));
        return static_cast<int>(vertices.size() / 3) - 1;
    }
    void add(int a, int b, int c) { indices.insert(indices.end(), {a, b, c}); }
    void add(const Triangles& other)
    {
        const auto first = static_cast<int>(vertices.size() / 3);
        vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const int index : other.indices)
            indices.push_back(first + index);
    }
    dvec3 at(int vertex) const
    {
        const float* v = &vertices[static_cast<std::size_t>(3 * vertex)];
        return {v[0], v[1], v[2]};
    }
    std::array<dvec3, 3> triangle(std::size_t t) const
    {
        return {at(indices[3 * t]), at(indices[3 * t + 1]), at(indices[3 * t + 2])};
    }
    std::size_t count() const { return indices.size() / 3; }
    Surface surface() const
    {
        Surface polygons;
        for (std::size_t t = 0; t < count(); ++t) {
            const auto corners = triangle(t);
            polygons.polygons.emplace_back(corners.begin(), corners.end());
        }
        return polygons;
    }
    voutClosedSurface solid() const
    {
        return {vertices.data(), static_cast<int>(vertices.size() / 3), indices.data(),
                static_cast<int>(indices.size())};
    }
};

Triangles turnedRound(Triangles triangles)
{
    for (std::size_t t = 0; t < triangles.count(); ++t)
        std::swap(triangles.indices[3 * t], triangles.indices[3 * t + 1]);
    return triangles;
}

Triangles box(const dvec3& lower, const dvec3& upper)
{
    Triangles box;
    for (int corner = 0; corner < 8; ++corner)
        box.add(glm::mix(lower, upper, dvec3(corner & 1, corner >> 1 & 1, corner >> 2)));
    box.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    return box;
}

Triangles cube()
{
    return box(dvec3(0), dvec3(1));
}

/// A letter L, 0.4 thick.
Triangles letter()
{
    const double outline[6][2] = {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
    Triangles letter;
    for (const double z : {0.0, 0.4})
        for (const auto& [x, y] : outline)
            letter.add(dvec3(x, y, z));
    for (int i = 0; i < 6; ++i) {
        const int next = (i + 1) % 6;
        letter.add(i, next, next + 6);
        letter.add(i, next + 6, i + 6);
    }
    for (int i = 1; i < 5; ++i) {
        letter.add(0, i + 1, i);
        letter.add(6, 6 + i, 7 + i);
    }
    return letter;
}

Triangles ball(const dvec3& center, double radius, int slices = 24, int stacks = 12)
{
    Triangles ball;
    const auto at = [&](int stack, int slice) { return 1 + (stack - 1) * slices + slice % slices; };
    ball.add(center + dvec3(0, 0, radius));
    for (int i = 1; i < stacks; ++i)
        for (int j = 0; j < slices; ++j) {
            const double polar = kPi * i / stacks, turn = 2 * kPi * j / slices;
            ball.add(center + radius * dvec3(std::sin(polar) * std::cos(turn),
                                             std::sin(polar) * std::sin(turn), std::cos(polar)));
        }
    const int last = ball.add(center - dvec3(0, 0, radius));
    for (int j = 0; j < slices; ++j) {
        ball.add(0, at(1, j), at(1, j + 1));
        for (int i = 1; i + 1 < stacks; ++i) {
            ball.add(at(i, j), at(i + 1, j), at(i + 1, j + 1));
            ball.add(at(i, j), at(i + 1, j + 1), at(i, j + 1));
        }
        ball.add(last, at(stacks - 1, j + 1), at(stacks - 1, j));
    }
    return ball;
}

Triangles torus()
{
    const int around = 32, across = 14;
    Triangles torus;
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = 2 * kPi * i / around, v = 2 * kPi * j / across, r = 1 + 0.35 * std::cos(v);
            torus.add(dvec3(r * std::cos(u), r * std::sin(u), 0.35 * std::sin(v)));
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const int next = (i + 1) % around * across, own = i * across, up = (j + 1) % across;
            torus.add(own + j, next + j, next + up);
            torus.add(own + j, next + up, own + up);
        }
    return torus;
}

/// A horseshoe with thick ends that rise, as a lower jaw has them.
Triangles jaw()
{
    const int rings = 28, sides = 12;
    Triangles jaw;
    for (int i = 0; i <= rings; ++i) {
        const double t = 2.0 * i / rings - 1, turn = 0.62 * kPi * t, rise = 0.5 * std::pow(std::abs(t), 4);
        const dvec3 outwards(std::sin(turn), std::cos(turn), 0), middle = outwards + dvec3(0, 0, rise);
        const double width = 0.14 + 0.06 * t * t, height = 0.2 + 0.12 * t * t;
        for (int j = 0; j < sides; ++j) {
            const double side = 2 * kPi * j / sides;
            jaw.add(middle + width * std::cos(side) * outwards + dvec3(0, 0, height * std::sin(side)));
        }
    }
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sides; ++j) {
            const int a = i * sides + j, b = i * sides + (j + 1) % sides;
            jaw.add(a, b, b + sides);
            jaw.add(a, b + sides, a + sides);
        }
    for (int j = 1; j + 1 < sides; ++j) {
        jaw.add(0, j + 1, j);
        jaw.add(rings * sides, rings * sides + j, rings * sides + j + 1);
    }
    return jaw;
}

/// A turn about a random axis.
glm::dmat3 turn(unsigned seed)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto vector = [&] {
        const double x = normal(random), y = normal(random);
        return dvec3(x, y, normal(random));
    };
    const dvec3 a = glm::normalize(vector()), b = glm::normalize(glm::cross(a, vector()));
    return {a, b, glm::cross(a, b)};
}

Triangles turned(const Triangles& triangles, unsigned seed)
{
    const glm::dmat3 matrix = turn(seed);
    Triangles result;
    result.indices = triangles.indices;
    for (std::size_t v = 0; v < triangles.vertices.size() / 3; ++v)
        result.add(matrix * triangles.at(static_cast<int>(v)) + dvec3(3, -2, 5));
    return result;
}

/// The distance of a point from a triangle.
double distance(const dvec3& p, const std::array<dvec3, 3>& t)
{
    const dvec3 normal = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
    double nearest = std::abs(glm::dot(p - t[0], normal));
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 a = t[i], along = t[(i + 1) % 3] - a;
        if (glm::dot(glm::cross(along, p - a), normal) >= 0) continue;
        nearest = HUGE_VAL; // beside the triangle: one of its sides is nearest
        break;
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const dvec3 a = t[i], along = t[(i + 1) % 3] - a;
        const double share = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
        nearest = std::min(nearest, glm::length(p - a - share * along));
    }
    return nearest;
}

double distance(const dvec3& p, const Triangles& surface)
{
    double nearest = HUGE_VAL;
    for (std::size_t t = 0; t < surface.count(); ++t)
        nearest = std::min(nearest, distance(p, surface.triangle(t)));
    return nearest;
}

/// What is promised of every solid: good tetrahedra without gaps, on the surface and not away from it.
void expectFills(const Tetras& tetras, const Triangles& triangles, double facetDistance)
{
    EXPECT_EQ(wrongHandedness(tetras), "");
    EXPECT_EQ(unmatchedFaces(tetras), "");
    EXPECT_EQ(overlaps(tetras), "");
    EXPECT_GE(smallestDihedral(tetras), double(voutClosedSurface::getSmallestAngle()));
    const Surface surface = triangles.surface();
    EXPECT_NEAR(volumeOf(tetras), std::abs(surface.volume()), surface.area() * facetDistance);
    Surface outside;
    double fromVertices = 0, fromFaces = 0;
    for (const std::array<int, 3>& face : boundaryFaces(tetras)) {
        outside.polygons.push_back({});
        for (const int corner : face) {
            outside.polygons.back().push_back(tetras.position(corner));
            fromVertices = std::max(fromVertices, distance(tetras.position(corner), triangles));
        }
        const auto& corners = outside.polygons.back();
        fromFaces = std::max(fromFaces, distance((corners[0] + corners[1] + corners[2]) / 3.0, triangles));
    }
    EXPECT_LE(fromVertices, 2e-6);
    EXPECT_LE(fromFaces, facetDistance);
    EXPECT_NEAR(volumeOf(tetras) / outside.volume(), 1, 1e-6);
}

Tetras tetrasOf(const Triangles& triangles, double edge, double facetDistance)
{
    voutClosedSurface solid = triangles.solid();
    solid.setEdgeLength(static_cast<float>(edge));
    solid.setFacetDistance(static_cast<float>(facetDistance));
    expectNoError();
    voutGeometry& geometry = solid;
    const Tetras tetras = taken(geometry.tessellate());
    expectNoError();
    EXPECT_NEAR(solid.getVolume(), std::abs(triangles.surface().volume()), 1e-6 * solid.getVolume());
    return tetras;
}

struct Shape
{
    const char* name;
    Triangles triangles;
    double edge, distance;
};

std::vector<Shape> shapes()
{
    return {{"cube", cube(), 0.25, 0.02},
            {"letter", letter(), 0.2, 0.02},
            {"ball", ball(dvec3(0), 1), 0.35, 0.03},
            {"torus", torus(), 0.25, 0.025},
            {"jaw", jaw(), 0.16, 0.02}};
}

TEST(VoutClosedSurface, fillsEveryShapeWithGoodTetrahedra)
{
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        expectFills(tetrasOf(shape.triangles, shape.edge, shape.distance), shape.triangles, shape.distance);
    }
}

TEST(VoutClosedSurface, fillsThemTurnedAnyWay)
{
    unsigned seed = 1;
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        const Triangles triangles = turned(shape.triangles, ++seed);
        expectFills(tetrasOf(triangles, shape.edge, shape.distance), triangles, shape.distance);
    }
}

TEST(VoutClosedSurface, keepsSharpEdgesExactly)
{
    expectSolid(tetrasOf(cube(), 0.3, 0.03), boxSurface(dvec3(0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}));
    expectSolid(tetrasOf(letter(), 0.2, 0.02), letter().surface());
    const glm::dmat3 matrix = turn(7);
    expectSolid(tetrasOf(turned(cube(), 7), 0.3, 0.03),
                boxSurface(dvec3(3, -2, 5), matrix[0], matrix[1], matrix[2]));
}

TEST(VoutClosedSurface, roundsOffEdgesThatAreNotSharp)
{
    voutClosedSurface solid = cube().solid();
    solid.setEdgeLength(0.3f);
    solid.setSharpAngle(100);
    const Tetras tetras = taken(solid.tessellate());
    EXPECT_LT(volumeOf(tetras), 0.9999);
    EXPECT_GT(volumeOf(tetras), 0.9);
}

TEST(VoutClosedSurface, edgesAreAsLongAsWasAsked)
{
    std::vector<double> counts;
    for (const double edge : {0.3, 0.15}) {
        const Tetras tetras = tetrasOf(cube(), edge, 0.1 * edge);
        double longest = 0;
        for (const auto& t : tetras.corners)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < i; ++j)
                    longest = std::max(longest, glm::length(tetras.position(t[i]) - tetras.position(t[j])));
        EXPECT_LT(longest, 2 * edge);
        counts.push_back(static_cast<double>(tetras.corners.size()));
    }
    EXPECT_GT(counts[1], 4 * counts[0]);
    EXPECT_LT(counts[1], 16 * counts[0]);
}

TEST(VoutClosedSurface, hasASizeOfItsOwnAtFirst)
{
    const Triangles shape = cube();
    voutClosedSurface solid = shape.solid();
    EXPECT_FLOAT_EQ(solid.getEdgeLength(), static_cast<float>(std::sqrt(3.0) / 20));
    EXPECT_FLOAT_EQ(solid.getFacetDistance(), static_cast<float>(std::sqrt(3.0) / 400));
    EXPECT_EQ(solid.getSharpAngle(), 40);
    EXPECT_EQ(solid.getVolume(), 1);
    float lower[3], upper[3];
    solid.getBounds(lower, upper);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(lower[axis], 0);
        EXPECT_EQ(upper[axis], 1);
    }
    solid.setEdgeLength(0.5f);
    EXPECT_FLOAT_EQ(solid.getFacetDistance(), 0.025f);
    expectNoError();
}

TEST(VoutClosedSurface, equalCallsGiveEqualSets)
{
    const Tetras first = tetrasOf(torus(), 0.3, 0.03), second = tetrasOf(torus(), 0.3, 0.03);
    EXPECT_EQ(first.records, second.records);
    EXPECT_EQ(first.corners, second.corners);
}

TEST(VoutClosedSurface, trianglesMayGoRoundEitherWay)
{
    const Triangles inverted = turnedRound(letter());
    expectFills(tetrasOf(inverted, 0.2, 0.02), letter(), 0.02);
}

TEST(VoutClosedSurface, verticesOfEqualCoordinatesAreOne)
{
    Triangles apart;
    for (const int index : cube().indices)
        apart.indices.push_back(apart.add(cube().at(index)));
    expectFills(tetrasOf(apart, 0.3, 0.03), cube(), 0.03);
}

TEST(VoutClosedSurface, aSurfaceWithinAnotherIsACavity)
{
    for (const bool isTurned : {false, true}) {
        Triangles hollow = cube();
        const Triangles core = box(dvec3(0.3), dvec3(0.7));
        hollow.add(isTurned ? turnedRound(core) : core);
        voutClosedSurface solid = hollow.solid();
        solid.setEdgeLength(0.25f);
        const Tetras tetras = taken(solid.tessellate());
        expectNoError();
        expectSolid(tetras, 1 - 0.064, 6 + 0.96);
        EXPECT_NEAR(solid.getVolume(), 1 - 0.064, 1e-6);
    }
}

TEST(VoutClosedSurface, everyPartIsFilledHoweverSmall)
{
    Triangles parts = ball(dvec3(0), 1);
    parts.add(ball(dvec3(3, 0, 0), 0.2));
    parts.add(ball(dvec3(0, -4, 1), 0.3));
    parts.add(box(dvec3(-3, -3, -3), dvec3(-2.5)));
    expectFills(tetrasOf(parts, 0.25, 0.02), parts, 0.02);
}

TEST(VoutClosedSurface, fillsABoxTogetherWithItsRest)
{
    unsigned seed = 20;
    for (const Shape& shape : shapes()) {
        SCOPED_TRACE(shape.name);
        const Triangles triangles = turned(shape.triangles, ++seed);
        voutClosedSurface solid = triangles.solid();
        solid.setEdgeLength(static_cast<float>(1.4 * shape.edge));
        solid.setFacetDistance(static_cast<float>(1.4 * shape.distance));
        float lower[3], upper[3];
        solid.getBounds(lower, upper);
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] -= 0.2f;
            upper[axis] += 0.3f;
        }
        voIndexedTetraSet *inside, *rest;
        ASSERT_EQ(solid.tessellateInBox(lower, upper, inside, rest), 0);
        expectNoError();
        const Tetras part = taken(inside), others = taken(rest);
        expectFills(part, triangles, 1.4 * shape.distance);
        EXPECT_GE(smallestDihedral(others), double(voutClosedSurface::getSmallestAngle()));
        Tetras both = part;
        both.append(others);
        const dvec3 corner(lower[0], lower[1], lower[2]), size = dvec3(upper[0], upper[1], upper[2]) - corner;
        expectSolid(both, boxSurface(corner, {size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}));
        EXPECT_EQ(both.records.size(),
                  part.records.size() + others.records.size() - boundaryVertices(part).size());
    }
}

TEST(VoutClosedSurface, theBoxLiesRoundTheSurface)
{
    voutClosedSurface solid = cube().solid();
    solid.setEdgeLength(0.5f);
    const float below[3] = {-1, -1, -1}, above[3] = {2, 2, 2}, through[3] = {2, 2, 0.5f}, on[3] = {2, 1, 2};
    for (const float* upper : {through, on, below}) {
        voIndexedTetraSet *inside, *rest;
        EXPECT_EQ(solid.tessellateInBox(below, upper, inside, rest), 1);
        expectBadValue("to the box");
        EXPECT_EQ(inside, nullptr);
        EXPECT_EQ(rest, nullptr);
    }
    voIndexedTetraSet *inside, *rest;
    EXPECT_EQ(solid.tessellateInBox(nullptr, above, inside, rest), 1);
    expectBadValue("lower is NULL");
}

// Surfaces that are none.

void expectRefused(const Triangles& triangles, const std::string& text)
{
    SCOPED_TRACE(text);
    voutClosedSurface solid = triangles.solid();
    expectBadValue(text);
    EXPECT_EQ(solid.getVolume(), 0);
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectBadValue("there is no surface");
}

TEST(VoutClosedSurface, tellsHowManyEdgesAreOpen)
{
    Triangles open = cube();
    open.indices.resize(open.indices.size() - 3);
    expectRefused(open, "not closed: 3 edges have one triangle only");
    Triangles crowded = cube();
    crowded.add(0, 1, 7);
    expectRefused(crowded, "not closed: 1 edge has one triangle only, 2 edges have more than two triangles");
}

TEST(VoutClosedSurface, tellsWhereNeighboursGoRoundOppositeWays)
{
    Triangles mixed = cube();
    std::swap(mixed.indices[0], mixed.indices[1]);
    expectRefused(mixed, "not oriented: at 3 edges");
}

TEST(VoutClosedSurface, tellsWhatCrosses)
{
    Triangles crossing = cube();
    crossing.add(box(dvec3(0.5), dvec3(1.5)));
    expectRefused(crossing, "crosses itself: ");
    Triangles touching = cube();
    touching.add(box(dvec3(1), dvec3(2)));
    expectRefused(touching, "touches itself in 1 vertex");
}

TEST(VoutClosedSurface, tellsTrianglesWithoutArea)
{
    Triangles flat = cube();
    flat.add(0, 1, 1);
    expectRefused(flat, "1 triangle has no area");
    Triangles empty;
    voutClosedSurface none(nullptr, 4, empty.indices.data(), 12);
    expectBadValue("vertices is NULL");
}

TEST(VoutClosedSurface, refusesNumbersThatAreNone)
{
    Triangles wrong = cube();
    wrong.vertices[4] = std::numeric_limits<float>::quiet_NaN();
    expectRefused(wrong, "a vertex is ");
    wrong = cube();
    wrong.indices[5] = 8;
    expectRefused(wrong, "index 5 is 8, there are 8 vertices");
    wrong = cube();
    wrong.indices.pop_back();
    expectRefused(wrong, "35 indices are not three for each triangle");

    const Triangles shape = cube();
    voutClosedSurface solid = shape.solid();
    solid.setEdgeLength(-1);
    expectBadValue("the edge length is -1");
    solid.setFacetDistance(0);
    expectBadValue("the facet distance is 0");
    solid.setSharpAngle(190);
    expectBadValue("190");
    solid.setEdgeLength(1e-4f);
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectBadValue("tetrahedra; at most");
    solid.setEdgeLength(0.5f);
    solid.setFacetDistance(1e-4f);
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectBadValue("less than a thousandth");
}

TEST(VoutClosedSurface, aWedgeThatIsSharperThanPromisedIsUnsupported)
{
    Triangles wedge;
    for (const double z : {0.0, 0.4})
        for (const dvec3& corner : {dvec3(0), dvec3(1, 0, 0), dvec3(1, 0.06, 0)})
            wedge.add(corner + dvec3(0, 0, z));
    wedge.indices = {0, 2, 1, 3, 4, 5, 0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4, 2, 0, 3, 2, 3, 5};
    voutClosedSurface solid = wedge.solid();
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectUnsupported("an edge of 3.43363 degrees");
    const float lower[3] = {-1, -1, -1}, upper[3] = {2, 2, 2};
    voIndexedTetraSet *inside, *rest;
    EXPECT_EQ(solid.tessellateInBox(lower, upper, inside, rest), 1);
    expectUnsupported("an edge of 3.43363 degrees");
}

TEST(VoutClosedSurface, aSlitMattersOnlyToTheRestOfABox)
{
    // A box with a notch that is as sharp as that wedge.
    const double outline[5][2] = {{0, 0}, {1, 0}, {1, 0.44}, {0.2, 0.46}, {1, 0.48}};
    Triangles notched;
    for (const double z : {0.0, 0.4}) {
        for (const auto& [x, y] : outline)
            notched.add(dvec3(x, y, z));
        notched.add(dvec3(1, 1, z));
        notched.add(dvec3(0, 1, z));
    }
    for (int i = 0; i < 7; ++i) {
        const int next = (i + 1) % 7;
        notched.add(i, next, next + 7);
        notched.add(i, next + 7, i + 7);
    }
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 6}, {3, 4, 5}, {3, 5, 6}}) {
        notched.add(a, c, b);
        notched.add(7 + a, 7 + b, 7 + c);
    }
    voutClosedSurface solid = notched.solid();
    solid.setEdgeLength(0.2f);
    const Tetras tetras = taken(solid.tessellate());
    expectNoError();
    expectSolid(tetras, notched.surface());
    const float lower[3] = {-1, -1, -1}, upper[3] = {2, 2, 2};
    voIndexedTetraSet *inside, *rest;
    EXPECT_EQ(solid.tessellateInBox(lower, upper, inside, rest), 1);
    expectUnsupported("an edge of 2.86");
}

TEST(VoutClosedSurface, floatsFarFromTheOriginDoNotTellVerticesApart)
{
    const Triangles far = box(dvec3(1e7), dvec3(1e7 + 4));
    voutClosedSurface solid = far.solid();
    solid.setEdgeLength(0.8f);
    expectNoError();
    EXPECT_EQ(solid.tessellate(), nullptr);
    expectUnsupported("");
}

// Files.

class VoutClosedSurfaceFiles : public ::testing::Test
{
protected:
    void SetUp() override
    {
        const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  (std::string("closed_surface_") + test->name() + std::to_string(std::random_device()()));
        std::filesystem::create_directory(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string write(const std::string& name, const std::function<void(std::ostream&)>& print)
    {
        std::ofstream file(folder_ / name, std::ios::binary);
        print(file);
        return (folder_ / name).string();
    }

    std::filesystem::path folder_;
};

void printVertices(std::ostream& out, const Triangles& triangles, const char* before)
{
    for (std::size_t v = 0; v < triangles.vertices.size() / 3; ++v) {
        const dvec3 p = triangles.at(static_cast<int>(v));
        out << before << p.x << " " << p.y << " " << p.z << "\n";
    }
}

void printTriangles(std::ostream& out, const Triangles& triangles, const char* before, int first)
{
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3)
        out << before << triangles.indices[i] + first << " " << triangles.indices[i + 1] + first << " "
            << triangles.indices[i + 2] + first << "\n";
}

void printOff(std::ostream& out, const Triangles& triangles)
{
    out << "OFF\n" << triangles.vertices.size() / 3 << " " << triangles.count() << " 0\n";
    printVertices(out, triangles, "");
    printTriangles(out, triangles, "3 ", 0);
}

void printObj(std::ostream& out, const Triangles& triangles)
{
    printVertices(out, triangles, "v ");
    printTriangles(out, triangles, "f ", 1);
}

void printPly(std::ostream& out, const Triangles& triangles)
{
    out << "ply\nformat ascii 1.0\nelement vertex " << triangles.vertices.size() / 3
        << "\nproperty float x\nproperty float y\nproperty float z\nelement face " << triangles.count()
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    printVertices(out, triangles, "");
    printTriangles(out, triangles, "3 ", 0);
}

void printBinaryStl(std::ostream& out, const Triangles& triangles)
{
    const std::string header(80, ' ');
    const auto count = static_cast<std::uint32_t>(triangles.count());
    out << header;
    out.write(reinterpret_cast<const char*>(&count), 4);
    for (std::size_t t = 0; t < triangles.count(); ++t) {
        float values[12] = {0, 0, 0};
        for (std::size_t i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis)
                values[3 + 3 * i + static_cast<std::size_t>(axis)] =
                    static_cast<float>(triangles.triangle(t)[i][axis]);
        out.write(reinterpret_cast<const char*>(values), sizeof values);
        out.write("\0\0", 2);
    }
}

TEST_F(VoutClosedSurfaceFiles, areReadInFourFormats)
{
    using Print = void (*)(std::ostream&, const Triangles&);
    for (const auto& [name, print] :
         std::initializer_list<std::pair<const char*, Print>>{{"letter.off", printOff},
                                                              {"letter.obj", printObj},
                                                              {"letter.ply", printPly},
                                                              {"letter.stl", printBinaryStl}}) {
        SCOPED_TRACE(name);
        const Print own = print;
        const std::string file = write(name, [&](std::ostream& out) { own(out, letter()); });
        voutClosedSurface solid(file.c_str());
        expectNoError();
        EXPECT_NEAR(solid.getVolume(), letter().surface().volume(), 1e-7);
        solid.setEdgeLength(0.3f);
        expectSolid(taken(solid.tessellate()), letter().surface());
    }
}

TEST_F(VoutClosedSurfaceFiles, trianglesThatGoRoundOppositeWaysAreTurned)
{
    Triangles mixed = letter();
    for (std::size_t t = 0; t < mixed.count(); t += 3)
        std::swap(mixed.indices[3 * t], mixed.indices[3 * t + 1]);
    const std::string file = write("mixed.off", [&](std::ostream& out) { printOff(out, mixed); });
    voutClosedSurface solid(file.c_str());
    expectNoError();
    EXPECT_NEAR(solid.getVolume(), letter().surface().volume(), 1e-7);
}

TEST_F(VoutClosedSurfaceFiles, polygonsBecomeTriangles)
{
    const std::string file = write("cube.off", [&](std::ostream& out) {
        out << "OFF\n8 6 0\n";
        printVertices(out, cube(), "");
        out << "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    });
    voutClosedSurface solid(file.c_str());
    expectNoError();
    EXPECT_EQ(solid.getVolume(), 1);
}

TEST_F(VoutClosedSurfaceFiles, damagedOnesAreRefusedAndNamed)
{
    const auto refused = [](const std::string& file, const std::string& text) {
        SCOPED_TRACE(file);
        voutClosedSurface solid(file.c_str());
        EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
        const char* found = voError::getErrorString();
        ASSERT_NE(found, nullptr);
        EXPECT_NE(std::strstr(found, text.c_str()), nullptr) << found;
        EXPECT_EQ(solid.getVolume(), 0);
    };
    refused((folder_ / "absent.off").string(), "absent.off: cannot be opened");
    refused(folder_.string(), "expected a file, found a folder");
    refused(write("cube.txt", [](std::ostream& out) { printOff(out, cube()); }), "expected polygons in OFF");
    refused(write("empty.off", [](std::ostream&) {}), "expected polygons in OFF");
    refused(write("many.off", [](std::ostream& out) { out << "OFF\n4000000000 4000000000 0\n0 0 0\n"; }),
            "many.off");
    refused(write("claims.off", [](std::ostream& out) { out << "OFF # all\n50000000 50000000 0\n0 0 0\n"; }),
            "claims.off: cut off: its header has 50000000 vertices and 50000000 polygons, the file 36 bytes");
    const auto plyWithout = [&](const std::string& name, const std::string& line) {
        return write(name, [&](std::ostream& out) {
            std::ostringstream whole;
            printPly(whole, cube());
            std::istringstream lines(whole.str());
            for (std::string each; std::getline(lines, each);)
                if (each.rfind(line, 0) != 0) out << each << '\n';
        });
    };
    refused(plyWithout("parts.ply", "element vertex"),
            "parts.ply: damaged: its header has a property before");
    refused(plyWithout("endless.ply", "end_header"), "endless.ply: cut off: its header has no end");
    refused(write("outside.off",
                  [](std::ostream& out) {
                      out << "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 7\n3 0 1 2\n3 0 2 3\n3 1 2 3\n";
                  }),
            "outside.off");
    refused(write("minus.ply",
                  [](std::ostream& out) {
                      Triangles minus = cube();
                      minus.indices[4] = -1;
                      printPly(out, minus);
                  }),
            "minus.ply");
    refused(write("open.obj",
                  [](std::ostream& out) {
                      Triangles open = cube();
                      open.indices.resize(33);
                      printObj(out, open);
                  }),
            "3 edges have one triangle only");
    voutClosedSurface none(static_cast<const char*>(nullptr));
    expectBadValue("fileName is NULL");
}

TEST_F(VoutClosedSurfaceFiles, cutOffAnywhereTheyAreRefused)
{
    using Print = void (*)(std::ostream&, const Triangles&);
    for (const auto& [name, print] :
         std::initializer_list<std::pair<const char*, Print>>{{"cut.off", printOff},
                                                              {"cut.obj", printObj},
                                                              {"cut.ply", printPly},
                                                              {"cut.stl", printBinaryStl}}) {
        std::ostringstream whole;
        print(whole, cube());
        for (std::size_t length = 0; length + 4 < whole.str().size(); length += 7) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(length));
            const std::string file =
                write(name, [&](std::ostream& out) { out << whole.str().substr(0, length); });
            voutClosedSurface solid(file.c_str());
            EXPECT_EQ(voError::getErrorNumber(), voErrorTypeScope::BAD_VALUE);
            voError::getErrorString();
            EXPECT_EQ(solid.getVolume(), 0);
        }
    }
}

} // namespace
