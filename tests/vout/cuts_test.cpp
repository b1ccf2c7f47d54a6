// Cuts of sets, by closed forms of what is left and by what holds of tetrahedra.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/utSolidActions.h>
#include <vo/utSolids.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace {

using namespace vo::test;
using glm::dvec3;
using Plane = std::array<float, 4>;
using Set = std::unique_ptr<voIndexedTetraSet>;

double distanceTo(const Plane& plane, const dvec3& p)
{
    return double(plane[0]) * p.x + double(plane[1]) * p.y + double(plane[2]) * p.z + double(plane[3]);
}

Tetras insideOf(voIndexedTetraSet* set, const std::vector<Plane>& planes)
{
    return taken(
        voutSolidActions::inside(set, planes.empty() ? nullptr : planes[0].data(), int(planes.size())));
}

Tetras outsideOf(voIndexedTetraSet* set, const std::vector<Plane>& planes)
{
    return taken(
        voutSolidActions::outside(set, planes.empty() ? nullptr : planes[0].data(), int(planes.size())));
}

struct Measure
{
    double volume;
    double area;
};

/// What planes that meet in `corner` leave of a convex body: seen from there, the faces on the planes add
/// nothing to the volume, and the one face of a single plane is what closes the surface.
Measure measureInside(const Surface& body, const std::vector<Plane>& planes, const dvec3& corner)
{
    Measure sum{0, 0};
    dvec3 open(0);
    for (std::vector<dvec3> polygon : body.polygons) {
        for (const Plane& plane : planes) {
            std::vector<dvec3> left;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
                const double da = distanceTo(plane, a), db = distanceTo(plane, b);
                if (da >= 0) left.push_back(a);
                if ((da < 0) != (db < 0) && da != 0 && db != 0) left.push_back(a + da / (da - db) * (b - a));
            }
            polygon = left;
        }
        dvec3 twofold(0);
        for (std::size_t i = 2; i < polygon.size(); ++i)
            twofold += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
        // A face on the plane is the closing one.
        if (polygon.size() < 3 ||
            (planes.size() == 1 && std::abs(glm::dot(twofold, polygon[0] - corner)) == 0 &&
             distanceTo(planes[0], polygon[0]) == 0 && distanceTo(planes[0], polygon[1]) == 0 &&
             distanceTo(planes[0], polygon[2]) == 0))
            continue;
        sum.volume += glm::dot(twofold, polygon[0] - corner) / 6;
        sum.area += glm::length(twofold) / 2;
        open += twofold;
    }
    sum.area += glm::length(open) / 2;
    return sum;
}

/// A grid of boxes from (0, 0, 0).
Set boxes(int nx, int ny, int nz, int split, float size = 1)
{
    voutBox box(0, 0, 0, size * float(nx), size * float(ny), size * float(nz), nx, ny, nz);
    box.setTetrasPerHexa(split);
    return Set(box.tessellate());
}

Tetras copyOf(voIndexedTetraSet* set)
{
    const voVertexData& vertices = *set->getVertexData();
    const voIndices& indices = *set->getIndices();
    return taken(new voIndexedTetraSet(vertices.getDataPtr(), vertices.getCount(),
                                       vertices.getValuesPerVertex(), indices.getDataPtr(),
                                       indices.getCount()));
}

/// The tetrahedra in any order, the corners of each in any.
std::multiset<std::set<int>> unordered(const Tetras& tetras)
{
    std::multiset<std::set<int>> sets;
    for (const auto& corners : tetras.corners)
        sets.emplace(corners.begin(), corners.end());
    return sets;
}

/// Both halves are solids, of the measures given, and together the whole.
void expectHalves(voIndexedTetraSet* set, const Plane& plane, const Surface& body)
{
    const Tetras whole = copyOf(set);
    Tetras in = insideOf(set, {plane}), out = outsideOf(set, {plane});
    expectNoError();
    const double length = std::hypot(double(plane[0]), double(plane[1]), double(plane[2]));
    const dvec3 onPlane = -double(plane[3]) / (length * length) * dvec3(plane[0], plane[1], plane[2]);
    const Measure inside = measureInside(body, {plane}, onPlane);
    const Measure outside = measureInside(body, {{-plane[0], -plane[1], -plane[2], -plane[3]}}, onPlane);
    for (const auto& [tetras, measure] : {std::pair(&in, inside), std::pair(&out, outside)}) {
        if (measure.volume < 1e-12 * body.volume()) {
            EXPECT_TRUE(tetras->corners.empty());
            continue;
        }
        expectSolid(*tetras, measure.volume, measure.area);
    }
    EXPECT_NEAR(volumeOf(in) + volumeOf(out), volumeOf(whole), 1e-9 * volumeOf(whole));
    in.append(out);
    expectSolid(in, body);
}

TEST(VoutCuts, planesThroughVerticesEdgesAndFacesOfIntegersCutExactly)
{
    std::mt19937 random(1);
    const auto corner = [&](int n) { return int(random() % unsigned(n + 1)); };
    int touched = 0;
    for (int round = 0; round < 60; ++round) {
        const int split = std::array{5, 6, 24}[std::size_t(round % 3)];
        const Set set = boxes(3, 2, 2, split);
        const dvec3 a(corner(3), corner(2), corner(2)), b(corner(3), corner(2), corner(2)),
            c(corner(3), corner(2), corner(2));
        const dvec3 across = glm::cross(b - a, c - a);
        if (glm::length(across) == 0) continue;
        const Plane plane{float(across.x), float(across.y), float(across.z), float(-glm::dot(across, a))};
        SCOPED_TRACE("round " + std::to_string(round));
        expectHalves(set.get(), plane, boxSurface(dvec3(0), {3, 0, 0}, {0, 2, 0}, {0, 0, 2}));
        for (const auto& record : insideOf(set.get(), {plane}).records)
            EXPECT_GE(distanceTo(plane, {record[0], record[1], record[2]}), -1e-5);
        if (std::abs(across.x) + std::abs(across.y) == 0 || std::abs(across.y) + std::abs(across.z) == 0)
            ++touched;
    }
    EXPECT_GT(touched, 3);
}

TEST(VoutCuts, whatAPlaneOnlyTouchesIsNotSplit)
{
    const Set set = boxes(2, 2, 2, 6);
    const Tetras whole = copyOf(set.get());
    for (const Plane& plane : {Plane{1, 0, 0, 0}, {0, 1, 0, 0}, {1, 1, 0, 0}, {1, 1, 1, 0}, {0, 0, -1, 2}}) {
        EXPECT_EQ(unordered(insideOf(set.get(), {plane})), unordered(whole));
        EXPECT_EQ(outsideOf(set.get(), {plane}).corners.size(), 0u);
        const Plane other{-plane[0], -plane[1], -plane[2], -plane[3]};
        EXPECT_EQ(insideOf(set.get(), {other}).corners.size(), 0u);
        EXPECT_EQ(unordered(outsideOf(set.get(), {other})), unordered(whole));
    }
    // Between the layers.
    EXPECT_EQ(insideOf(set.get(), {{0, 0, 1, -1}}).corners.size(), whole.corners.size() / 2);
}

TEST(VoutCuts, planesAnywhereCutExactly)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> number(-1, 1);
    for (int round = 0; round < 40; ++round) {
        const Set set = boxes(2, 2, 3, round % 2 ? 5 : 6, 8);
        Plane plane{number(random), number(random), number(random), 0};
        plane[3] = float(
            -distanceTo(plane, {8 + 6 * number(random), 8 + 6 * number(random), 12 + 9 * number(random)}));
        SCOPED_TRACE("round " + std::to_string(round));
        expectHalves(set.get(), plane, boxSurface(dvec3(0), {16, 0, 0}, {0, 16, 0}, {0, 0, 24}));
    }
}

TEST(VoutCuts, planesAHairBesideVerticesLeaveSolids)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> number(-1, 1);
    const Surface body = boxSurface(dvec3(0), {3, 0, 0}, {0, 3, 0}, {0, 0, 3});
    for (int round = 0; round < 60; ++round) {
        const Set set = boxes(3, 3, 3, round % 2 ? 5 : 6);
        const dvec3 vertex(1 + int(random() % 2), 1 + int(random() % 2), 1 + int(random() % 2));
        Plane plane{number(random), number(random), number(random), 0};
        if (round % 3 == 0) plane[0] = 0; // along rows of vertices
        plane[3] = float(-distanceTo(plane, vertex)) + std::ldexp(number(random), -8 - round % 16);
        SCOPED_TRACE("round " + std::to_string(round));
        Tetras in = insideOf(set.get(), {plane});
        const Tetras out = outsideOf(set.get(), {plane});
        EXPECT_EQ(wrongHandedness(in) + wrongHandedness(out), "");
        in.append(out);
        expectSolid(in, body);
    }
}

TEST(VoutCuts, cornersOfThreePlanesAreExact)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> number(-1, 1);
    const Surface body = boxSurface(dvec3(0), {4, 0, 0}, {0, 4, 0}, {0, 0, 4});
    for (int round = 0; round < 30; ++round) {
        const Set set = boxes(2, 2, 2, round % 2 ? 5 : 6, 2);
        const dvec3 corner(2 + number(random), 2 + number(random), 2 + number(random));
        std::vector<Plane> planes;
        for (int i = 0; i < 3; ++i) {
            Plane plane{number(random), number(random), number(random), 0};
            plane[3] = float(-distanceTo(plane, corner));
            planes.push_back(plane);
        }
        SCOPED_TRACE("round " + std::to_string(round));
        Tetras in = insideOf(set.get(), planes);
        const Tetras out = outsideOf(set.get(), planes);
        const double volume = measureInside(body, planes, corner).volume;
        EXPECT_NEAR(volumeOf(in), volume, 1e-5);
        EXPECT_NEAR(volumeOf(in) + volumeOf(out), 64, 64e-9);
        EXPECT_EQ(wrongHandedness(in) + wrongHandedness(out), "");
        EXPECT_EQ(unmatchedFaces(in) + unmatchedFaces(out) + overlaps(in), "");
        in.append(out);
        expectSolid(in, body);
    }
}

TEST(VoutCuts, manyPlanesLeaveAConformingWhole)
{
    std::mt19937 random(9);
    std::uniform_real_distribution<float> number(-1, 1);
    for (int round = 0; round < 60; ++round) {
        const Set set = boxes(2, 2, 2, std::array{5, 6, 24}[std::size_t(round % 3)], 8);
        std::vector<Plane> planes;
        for (int i = 0; i < 2 + round % 9; ++i) {
            Plane plane{number(random), number(random), number(random), 0};
            if (round % 4 == 0) // through vertices and along rows of them
                for (float& value : plane)
                    value = std::round(2 * value);
            if (round % 5 == 0 && i > 0) // hardly apart in direction
                for (std::size_t axis = 0; axis < 3; ++axis)
                    plane[axis] = planes.back()[axis] + std::ldexp(number(random), round % 12 - 16);
            if (plane[0] == 0 && plane[1] == 0 && plane[2] == 0) plane[0] = 1;
            plane[3] = float(
                -distanceTo(plane, {8 + 6 * number(random), 8 + 6 * number(random), 8 + 6 * number(random)}));
            if (round % 4 == 0) plane[3] = std::round(plane[3]);
            planes.push_back(plane);
        }
        SCOPED_TRACE("round " + std::to_string(round));
        Tetras in = insideOf(set.get(), planes);
        const Tetras out = outsideOf(set.get(), planes);
        EXPECT_EQ(wrongHandedness(in) + wrongHandedness(out) + unmatchedFaces(in) + unmatchedFaces(out), "");
        EXPECT_NEAR(volumeOf(in) + volumeOf(out), 4096, 4096e-9);
        for (const Plane& plane : planes)
            for (int vertex = 0; vertex < int(in.records.size()); ++vertex)
                EXPECT_GE(distanceTo(plane, in.position(vertex)), -4e-5);
        in.append(out);
        EXPECT_EQ(unmatchedFaces(in), "");
        EXPECT_NEAR(areaOf(in), 6 * 256, 1e-3);
    }
}

TEST(VoutCuts, boxesAreCutOutAndCutAway)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<float> number(0, 4);
    for (int round = 0; round < 30; ++round) {
        const Set set = boxes(2, 2, 2, round % 2 ? 5 : 24, 2);
        float lower[3], upper[3];
        double volume = 1;
        dvec3 size;
        for (int axis = 0; axis < 3; ++axis) {
            const bool whole = round % 3 == 0; // with faces on faces, and outside
            float a = number(random), b = number(random);
            if (whole) a = std::round(a), b = std::round(b);
            lower[axis] = std::min(a, b);
            upper[axis] = std::max(a, b) + (whole ? 1.0f : 0.1f);
            size[axis] = std::min(4.0, double(upper[axis])) - double(lower[axis]);
            volume *= std::max(size[axis], 0.0);
        }
        SCOPED_TRACE("round " + std::to_string(round));
        Tetras in = taken(voutSolidActions::inside(set.get(), lower, upper));
        const Tetras out = taken(voutSolidActions::outside(set.get(), lower, upper));
        expectNoError();
        if (volume == 0)
            EXPECT_TRUE(in.corners.empty());
        else
            expectSolid(in, volume, 2 * (size.x * size.y + size.y * size.z + size.z * size.x));
        EXPECT_NEAR(volumeOf(in) + volumeOf(out), 64, 64e-9);
        EXPECT_EQ(wrongHandedness(out) + unmatchedFaces(out) + overlaps(out), "");
        in.append(out);
        expectSolid(in, 64, 96);
    }
}

TEST(VoutCuts, aBallIsCutOutOfABoxAndABoxOutOfABall)
{
    const Set box = boxes(2, 2, 2, 5, 16);
    const Set ball(voutGeoSphere(15, 17, 16, 11, 2).tessellate());
    const Tetras round = copyOf(ball.get());
    const double volume = volumeOf(round), area = areaOf(round);
    Tetras in = taken(voutSolidActions::inside(box.get(), ball.get()));
    const Tetras out = taken(voutSolidActions::outside(box.get(), ball.get()));
    expectNoError();
    expectSolid(in, volume, area);
    expectSolid(out, 32 * 32 * 32 - volume, 6 * 32 * 32 + area);
    in.append(out);
    expectSolid(in, 32 * 32 * 32, 6 * 32 * 32);

    const Set die = boxes(1, 1, 1, 5, 16); // its corner (16, 16, 16) lies in the ball, three faces cut it
    Tetras left = taken(voutSolidActions::outside(ball.get(), die.get()));
    const Tetras cut = taken(voutSolidActions::inside(ball.get(), die.get()));
    EXPECT_GT(volumeOf(cut), 0.05 * volume);
    // New vertices on the ball are rounded to floats.
    EXPECT_NEAR(volumeOf(left) + volumeOf(cut), volume, area * std::ldexp(27, -24));
    left.append(cut);
    expectSolid(left, volume, area);
}

TEST(VoutCuts, everyValueOfARecordIsInterpolated)
{
    // Values that are linear in space.
    const auto value = [](const dvec3& p, int i) {
        return 0.1 + 0.01 * i * p.x - 0.02 * p.y + 0.03 * (i - 3) * p.z;
    };
    const Set box = boxes(2, 3, 2, 5, 4);
    for (const int values : {3, 6, 7, 9, 10, 12}) {
        const int count = box->getVertexData()->getCount();
        voIndexedTetraSet set(count, values, box->getIndices()->getCount());
        for (int vertex = 0; vertex < count; ++vertex) {
            const float* p = (*box->getVertexData())[vertex];
            float* record = (*set.getVertexData())[vertex];
            for (int i = 0; i < values - 3; ++i)
                record[i] = float(value({p[0], p[1], p[2]}, i));
            std::copy_n(p, 3, record + values - 3);
        }
        std::copy_n(box->getIndices()->getDataPtr(), box->getIndices()->getCount(),
                    set.getIndices()->getDataPtr());
        set.getVertexData()->setCount(count);
        set.getIndices()->setCount(box->getIndices()->getCount());
        const std::vector<Plane> planes{{1, 0.3f, -0.2f, -3}, {-0.4f, 1, 0.5f, -2.5f}};
        const Tetras in = insideOf(&set, planes);
        EXPECT_EQ(in.values, values);
        EXPECT_GT(in.corners.size(), 20u);
        for (int vertex = 0; vertex < int(in.records.size()); ++vertex)
            for (int i = 0; i < values - 3; ++i)
                EXPECT_NEAR(double(in.records[std::size_t(vertex)][std::size_t(i)]),
                            value(in.position(vertex), i), 2e-6);
    }
}

TEST(VoutCuts, verticesAreSharedAndInUse)
{
    const Set set = boxes(3, 3, 3, 5);
    const Tetras in = insideOf(set.get(), {{0, 0, 1, -1.5f}}); // cuts 16 upright edges, and diagonals
    std::set<std::vector<float>> places(in.records.begin(), in.records.end());
    EXPECT_EQ(places.size(), in.records.size());
    std::set<int> used;
    for (const auto& corners : in.corners)
        used.insert(corners.begin(), corners.end());
    EXPECT_EQ(used.size(), in.records.size());
    EXPECT_EQ(std::count_if(in.records.begin(), in.records.end(), [](const auto& r) { return r[2] == 1.5f; }),
              16 + 4 * 3 * 2 + 0); // a diagonal of each upright square face
}

TEST(VoutCuts, foreignTetrahedraAreTurnedOrLeftOut)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float corners[] = {0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, nan, 0, 0, 1, 1, 0};
    const int indices[] = {0, 2, 1, 3, /* flat */ 0, 1, 2, 5, /* nowhere */ 0, 1, 2, 4};
    voIndexedTetraSet set(corners, 6, 3, indices, 12);
    const Tetras in = insideOf(&set, {{0, 0, -1, 1}});
    expectNoError();
    EXPECT_EQ(wrongHandedness(in), "");
    EXPECT_NEAR(volumeOf(in), 8.0 / 6 - 1.0 / 6, 1e-9);
}

TEST(VoutCuts, wrongArgumentsAreRefused)
{
    const Set set = boxes(1, 1, 1, 5);
    const float plane[8] = {0, 0, 1, 0, 0, 0, 0, 1}, lower[3] = {0, 0, 0}, upper[3] = {1, 0, 1};
    EXPECT_EQ(voutSolidActions::inside(nullptr, plane, 1), nullptr);
    expectBadValue("set is NULL");
    EXPECT_EQ(voutSolidActions::inside(set.get(), static_cast<float*>(nullptr), 1), nullptr);
    expectBadValue("planes is NULL");
    EXPECT_EQ(voutSolidActions::inside(set.get(), plane, -1), nullptr);
    expectBadValue("-1 planes");
    EXPECT_EQ(voutSolidActions::outside(set.get(), plane, 2), nullptr);
    expectBadValue("voutSolidActions::outside: plane 1 has no direction");
    EXPECT_EQ(voutSolidActions::outside(set.get(), lower, upper), nullptr);
    expectBadValue("not above the lower one");
    EXPECT_EQ(voutSolidActions::outside(set.get(), static_cast<voIndexedTetraSet*>(nullptr)), nullptr);
    expectBadValue("convex is NULL");
    const Set ring(voutTorus(0, 0, 0, 3, 1, 8, 8).tessellate());
    EXPECT_EQ(voutSolidActions::inside(set.get(), ring.get()), nullptr);
    expectBadValue("not convex");
    const Set hollow(voutShell(0, 0, 0, 1, 2, 1).tessellate());
    EXPECT_EQ(voutSolidActions::inside(set.get(), hollow.get()), nullptr);
    expectBadValue("not convex");
    voIndexedTetraSet empty(4, 3, 4);
    EXPECT_EQ(voutSolidActions::inside(set.get(), &empty), nullptr);
    expectBadValue("empty");
    const int wrong[] = {0, 1, 2, 8};
    voIndexedTetraSet outside(set->getVertexData()->getDataPtr(), 8, 3, wrong, 4);
    EXPECT_EQ(voutSolidActions::inside(&outside, plane, 1), nullptr);
    expectBadValue("vertex 8 of 8");
    EXPECT_TRUE(taken(voutSolidActions::inside(&empty, plane, 1)).corners.empty());
    expectNoError();
}

TEST(VoutTransformed, verticesMoveAndVoxelsStay)
{
    const Set set = boxes(2, 1, 1, 5);
    const GLdouble matrix[16] = {0, 2, 0, 0, -1, 0, 0, 0, 0, 0, 3, 0, 5, 6, 7, 1};
    const Set moved(voutSolidActions::transformed(set.get(), voInterleavedArrayTypeScope::V3F, matrix));
    const Set again(voutSolidActions::transformed(moved.get(), voInterleavedArrayTypeScope::T3F_V3F, matrix));
    expectNoError();
    for (int vertex = 0; vertex < set->getVertexData()->getCount(); ++vertex) {
        const float* p = (*set->getVertexData())[vertex];
        const float* once = (*moved->getVertexData())[vertex];
        const float* twice = (*again->getVertexData())[vertex];
        const float place[3] = {5 - p[1], 6 + 2 * p[0], 7 + 3 * p[2]};
        const float next[3] = {5 - place[1], 6 + 2 * place[0], 7 + 3 * place[2]};
        for (int i = 0; i < 3; ++i) {
            EXPECT_EQ(once[i], p[i]);
            EXPECT_EQ(twice[i], p[i]);
            EXPECT_EQ(once[3 + i], place[i]);
            EXPECT_EQ(twice[3 + i], next[i]);
        }
    }
    const float colored[] = {0.1f, 0.2f, 0.3f, 0.4f, 1, 2, 3};
    const int none[] = {0, 0, 0, 0};
    voIndexedTetraSet point(colored, 1, 7, none, 4);
    const Set placed(voutSolidActions::transformed(&point, voInterleavedArrayTypeScope::C4F_V3F, matrix));
    const float expected[] = {1, 2, 3, 0.1f, 0.2f, 0.3f, 0.4f, 3, 8, 16};
    for (int i = 0; i < 10; ++i)
        EXPECT_EQ((*placed->getVertexData())[0][i], expected[i]);
}

TEST(VoutTransformed, matricesThatAreNoneAreRefused)
{
    const Set set = boxes(1, 1, 1, 5);
    GLdouble matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    const auto format = voInterleavedArrayTypeScope::V3F;
    EXPECT_EQ(voutSolidActions::transformed(set.get(), format, matrix), nullptr);
    expectBadValue("singular");
    matrix[10] = 1;
    matrix[3] = 0.5;
    EXPECT_EQ(voutSolidActions::transformed(set.get(), format, matrix), nullptr);
    expectBadValue("last row");
    matrix[3] = HUGE_VAL;
    EXPECT_EQ(voutSolidActions::transformed(set.get(), format, matrix), nullptr);
    expectBadValue("not finite");
    EXPECT_EQ(voutSolidActions::transformed(set.get(), format, nullptr), nullptr);
    expectBadValue("matrix is NULL");
    matrix[3] = 0;
    EXPECT_EQ(voutSolidActions::transformed(set.get(), voInterleavedArrayTypeScope::T3F_V3F, matrix),
              nullptr);
    expectBadValue("6 values a record, the set 3");
    EXPECT_EQ(voutSolidActions::transformed(set.get(), voInterleavedArrayTypeScope::USER_V3F, matrix),
              nullptr);
    expectBadValue("USER_V3F");
}

TEST(VoutTaggedSet, unitesPartsAndTakesThemApart)
{
    const Set box = boxes(2, 2, 2, 5, 4), ball(voutGeoSphere(20, 20, 20, 3, 1).tessellate());
    voutTaggedSet both(3);
    EXPECT_EQ(both.append(box.get(), 7), 0);
    EXPECT_EQ(both.append(ball.get(), -1), 0);
    EXPECT_EQ(both.append(box.get(), 7), 0);
    const Tetras first = copyOf(box.get()), second = copyOf(ball.get());
    ASSERT_EQ(both.getTetraCount(), 2 * int(first.corners.size()) + int(second.corners.size()));
    EXPECT_EQ(both.getTag(0), 7);
    EXPECT_EQ(both.getTag(int(first.corners.size())), -1);
    EXPECT_EQ(both.getTag(both.getTetraCount() - 1), 7);
    EXPECT_TRUE(both.hasTag(-1) && both.hasTag(7) && !both.hasTag(0));
    const Tetras taken7 = taken(both.extract(7)), takenBall = taken(both.extract(-1));
    EXPECT_EQ(takenBall.records, second.records);
    EXPECT_EQ(takenBall.corners, second.corners);
    EXPECT_EQ(taken7.corners.size(), 2 * first.corners.size());
    EXPECT_NEAR(volumeOf(taken(both.tessellate())), 2 * 512 + volumeOf(second), 1e-9);
    EXPECT_TRUE(taken(both.extract(0)).corners.empty());
    EXPECT_EQ(both.mergeVertices(), box->getVertexData()->getCount());
    EXPECT_EQ(both.getVertexCount(), box->getVertexData()->getCount() + ball->getVertexData()->getCount());
    expectNoError();
}

TEST(VoutTaggedSet, partsOfAWholeFitWhenVerticesAreMerged)
{
    const Set box = boxes(2, 2, 2, 5, 8);
    const float lower[3] = {3, 2.5f, 5}, upper[3] = {12.25f, 11, 13};
    const Set in(voutSolidActions::inside(box.get(), lower, upper)),
        out(voutSolidActions::outside(box.get(), lower, upper));
    voutTaggedSet whole(3);
    whole.mergeVertices(); // of none yet, and of all to come
    whole.append(in.get(), 1);
    whole.append(out.get(), 2);
    expectSolid(taken(whole.tessellate()), 4096, 6 * 256);
    expectSolid(taken(whole.extract(1)), 9.25 * 8.5 * 8, 2 * (9.25 * 8.5 + 8.5 * 8 + 8 * 9.25));
    EXPECT_EQ(whole.getTetraCount(), (in->getIndices()->getCount() + out->getIndices()->getCount()) / 4);
}

TEST(VoutTaggedSet, wrongArgumentsAreRefused)
{
    const Set box = boxes(1, 1, 1, 5);
    voutTaggedSet none(2);
    expectBadValue("2 values");
    voutTaggedSet set(6);
    EXPECT_NE(set.append(box.get(), 0), 0);
    expectBadValue("3 values, those here have 6");
    EXPECT_NE(set.append(nullptr, 0), 0);
    expectBadValue("set is NULL");
    EXPECT_EQ(set.getTag(0), 0);
    expectBadValue("tetrahedron 0 of 0");
    EXPECT_TRUE(taken(set.tessellate()).corners.empty());
}

} // namespace
