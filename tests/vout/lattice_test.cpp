// Lattices, by closed forms of their warps and by what holds of their tetrahedra.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/GeometryActions.h>
#include <vo/utLattice.h>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace {

using namespace vo::test;
using glm::dvec3;
using glm::ivec3;

const float kLower[3] = {2, -3, 1}, kUpper[3] = {14, 5, 21};
const dvec3 kMiddle(8, 1, 11), kSize(12, 8, 20);
constexpr double kDegree = std::numbers::pi / 180;

dvec3 vertexOf(const voutLattice& lattice, int vertex)
{
    float p[3] = {NAN, NAN, NAN};
    lattice.getVertex(vertex, p);
    return {p[0], p[1], p[2]};
}

dvec3 voxelOf(const voutLattice& lattice, int vertex)
{
    float p[3] = {NAN, NAN, NAN};
    lattice.getVoxelCoordinates(vertex, p);
    return {p[0], p[1], p[2]};
}

/// Where a point of the volume belongs.
using Map = std::function<dvec3(const dvec3&)>;

void expectEachAt(const voutLattice& lattice, const Map& map, double tolerance = 2e-5)
{
    ASSERT_GT(lattice.getVertexCount(), 0);
    for (int vertex = 0; vertex < lattice.getVertexCount(); ++vertex) {
        const dvec3 found = vertexOf(lattice, vertex), expected = map(voxelOf(lattice, vertex));
        ASSERT_LE(glm::distance(found, expected), tolerance)
            << vertex << ": (" << found.x << ", " << found.y << ", " << found.z << ") instead of ("
            << expected.x << ", " << expected.y << ", " << expected.z << ")";
    }
    expectNoError();
}

/// The farthest that the middles of tetrahedra lie from where they belong.
double largestError(voutLattice& lattice, const Map& map)
{
    const Tetras tetras = taken(lattice.tessellate());
    double largest = 0;
    for (const auto& corners : tetras.corners) {
        dvec3 voxel(0), position(0);
        for (const int corner : corners) {
            const std::vector<float>& r = tetras.records[std::size_t(corner)];
            voxel += 0.25 * dvec3(r[0], r[1], r[2]);
            position += 0.25 * dvec3(r[3], r[4], r[5]);
        }
        largest = std::max(largest, glm::distance(position, map(voxel)));
    }
    return largest;
}

TEST(VoutLattice, unmovedIsTheBoxByEverySplit)
{
    for (const int split : {5, 6, 24}) {
        voutLattice lattice(3, 2, 4, kLower, kUpper);
        lattice.setTetrasPerHexa(split);
        EXPECT_EQ(lattice.getTetrasPerHexa(), split);
        const Tetras tetras = taken(lattice.tessellate());
        EXPECT_EQ(tetras.corners.size(), std::size_t(3 * 2 * 4 * split));
        ASSERT_EQ(tetras.values, 6);
        for (const std::vector<float>& record : tetras.records)
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(record[i], record[3 + i]);
        expectSolid(tetras, 12 * 8 * 20, 2 * (12 * 8 + 8 * 20 + 20 * 12));
        EXPECT_EQ(lattice.countInverted(), 0);
        EXPECT_EQ(lattice.countFlat(), 0);
    }
    expectNoError();
}

TEST(VoutLattice, verticesAreNumberedAlongXThenYThenZ)
{
    voutLattice lattice(3, 2, 4, kLower, kUpper);
    int nx = 0, ny = 0, nz = 0;
    lattice.getSizes(nx, ny, nz);
    EXPECT_EQ(ivec3(nx, ny, nz), ivec3(3, 2, 4));
    ASSERT_EQ(lattice.getVertexCount(), 4 * 3 * 5);
    const Tetras tetras = taken(lattice.tessellate());
    int number = 0;
    for (int k = 0; k <= 4; ++k)
        for (int j = 0; j <= 2; ++j)
            for (int i = 0; i <= 3; ++i, ++number) {
                EXPECT_EQ(lattice.getVertexIndex(i, j, k), number);
                const dvec3 place(2 + 4 * i, -3 + 4 * j, 1 + 5 * k);
                EXPECT_EQ(voxelOf(lattice, number), place);
                EXPECT_EQ(vertexOf(lattice, number), place);
                EXPECT_EQ(tetras.position(number), place);
            }
}

TEST(VoutLattice, movedVertexTakesItsVoxelAlong)
{
    for (const int split : {5, 6, 24}) {
        voutLattice lattice(3, 2, 4, kLower, kUpper);
        lattice.setTetrasPerHexa(split);
        const int vertex = lattice.getVertexIndex(1, 1, 2);
        const float position[3] = {6.5f, 2, 12};
        lattice.setVertex(vertex, position);
        EXPECT_EQ(vertexOf(lattice, vertex), dvec3(6.5, 2, 12));
        EXPECT_EQ(voxelOf(lattice, vertex), dvec3(6, 1, 11));
        const Tetras tetras = taken(lattice.tessellate());
        const std::vector<float> record{6, 1, 11, 6.5f, 2, 12};
        EXPECT_EQ(tetras.records[std::size_t(vertex)], record);
        // Inside, so that the solid stays what it is.
        expectSolid(tetras, 12 * 8 * 20, 2 * (12 * 8 + 8 * 20 + 20 * 12));
        lattice.reset();
        expectEachAt(
            lattice, [](const dvec3& p) { return p; }, 0);
    }
}

/// A warp of the library beside what it should be, from the box's middle in units of the spacing.
struct WarpCase
{
    const char* name;
    std::function<void(voutLattice&)> warp;
    Map moved;
    /// Of the volume that it leaves, in those units; 0: not known.
    double volume = 0;
};

const dvec3 kSpacing(1, 1.5, 0.5), kMeasured = kSize * kSpacing;

dvec3 turned(double x, double y, double angle)
{
    return {std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, 0};
}

std::vector<WarpCase> warpCases()
{
    const double whole = kMeasured.x * kMeasured.y * kMeasured.z;
    const auto twistZ = [](const dvec3& p) {
        const dvec3 t = turned(p.x, p.y, 80 * kDegree * p.z / 10);
        return dvec3(t.x, t.y, p.z);
    };
    const auto twistX = [](const dvec3& p) {
        const dvec3 t = turned(p.y, p.z, -50 * kDegree * p.x / 12);
        return dvec3(p.x, t.x, t.y);
    };
    // The arc of x turns in the plane of x and z, about a point at a distance of its radius along z.
    const auto bendX = [](const dvec3& p) {
        const double radius = 12 / (70 * kDegree);
        const dvec3 t = turned(0, p.z - radius, p.x / radius);
        return dvec3(t.x, p.y, radius + t.y);
    };
    const auto taper = [](const dvec3& p) {
        const double s = (p.y + 6) / 12 * 0.4 + (6 - p.y) / 12;
        return dvec3(p.x * s, p.y, p.z * s);
    };
    // Depth along z, from 3 to 9; directions along x; the third axis, y, stays.
    const auto sector = [](const dvec3& p) {
        const double r = 3 + (p.z + 5) * 0.6, a = p.x / 12 * 100 * kDegree;
        return dvec3(r * std::sin(a), p.y, r * std::cos(a));
    };
    const auto fan = [sector](const dvec3& p) { return sector(p) - dvec3(0, 0, 3 + 5); };
    const auto swung = [](const dvec3& p) {
        const double r = 4 + p.x + 6, a = p.y / 12 * 60 * kDegree, e = p.z / 10 * 40 * kDegree;
        return r * dvec3(std::cos(a) * std::cos(e), std::sin(a), std::cos(a) * std::sin(e)) -
               dvec3(4 + 6, 0, 0);
    };
    return {
        {"twistZ", [](voutLattice& l) { l.twist(2, 80); }, twistZ, whole},
        {"twistX", [](voutLattice& l) { l.twist(0, -50); }, twistX, whole},
        {"bendX", [](voutLattice& l) { l.bend(0, 2, 70); }, bendX, whole},
        {"noBend", [](voutLattice& l) { l.bend(0, 2, 0); }, [](const dvec3& p) { return p; }, whole},
        {"taperY", [](voutLattice& l) { l.taper(1, 0.4f); }, taper, whole * (1 + 0.4 + 0.16) / 3},
        {"fan", [](voutLattice& l) { l.fan(2, 0, 100, 3, 9); }, fan, 100 * kDegree / 2 * (81 - 9) * 12},
        {"swungFan", [](voutLattice& l) { l.fan(0, 1, 60, 4, 16, 40); }, swung,
         40 * kDegree * 2 * std::sin(30 * kDegree) * (16 * 16 * 16 - 4 * 4 * 4) / 3.0},
        {"cylinder", [](voutLattice& l) { l.cylinder(2, 0, 3, 9, 100); }, sector,
         100 * kDegree / 2 * (81 - 9) * 12},
        {"bendOfATwist",
         [](voutLattice& l) {
             l.twist(2, 80);
             l.bend(0, 2, 70);
         },
         [=](const dvec3& p) { return bendX(twistZ(p)); }, whole},
    };
}

voutLattice* warped(const WarpCase& c, int boxes)
{
    auto* lattice = new voutLattice(boxes, boxes, boxes, kLower, kUpper);
    const float spacing[3] = {1, 1.5f, 0.5f};
    lattice->setSpacing(spacing);
    c.warp(*lattice);
    return lattice;
}

Map mapOf(const WarpCase& c)
{
    return [&c](const dvec3& p) { return c.moved((p - kMiddle) * kSpacing) / kSpacing + kMiddle; };
}

TEST(VoutLatticeWarps, moveVerticesByTheirClosedForms)
{
    for (const WarpCase& c : warpCases()) {
        SCOPED_TRACE(c.name);
        const std::unique_ptr<voutLattice> lattice(warped(c, 5));
        expectEachAt(*lattice, mapOf(c));
    }
}

TEST(VoutLatticeWarps, errorFallsWithTheSquareOfTheBoxes)
{
    for (const WarpCase& c : warpCases())
        for (const int split : {5, 6, 24}) {
            SCOPED_TRACE(testing::Message() << c.name << ", " << split);
            const std::unique_ptr<voutLattice> coarse(warped(c, 6)), fine(warped(c, 12));
            for (voutLattice* lattice : {coarse.get(), fine.get()})
                lattice->setTetrasPerHexa(split);
            const double coarseError = largestError(*coarse, mapOf(c));
            const double fineError = largestError(*fine, mapOf(c));
            if (std::getenv("VO_TEST_PRINT"))
                std::printf("%s %d: %g %g\n", c.name, split, coarseError, fineError);
            if (std::string(c.name) == "noBend") {
                EXPECT_LT(coarseError, 1e-5);
                continue;
            }
            EXPECT_GT(coarseError, 0.01);
            EXPECT_LT(fineError, coarseError / 3);
        }
}

TEST(VoutLatticeWarps, leaveSolidsWithTheVolumesOfClosedForms)
{
    for (const WarpCase& c : warpCases()) {
        SCOPED_TRACE(c.name);
        const std::unique_ptr<voutLattice> coarse(warped(c, 4)), fine(warped(c, 16));
        const Tetras tetras = taken(coarse->tessellate());
        EXPECT_EQ(wrongHandedness(tetras), "");
        EXPECT_EQ(unmatchedFaces(tetras), "");
        EXPECT_EQ(overlaps(tetras), "");
        const double unit = kSpacing.x * kSpacing.y * kSpacing.z;
        EXPECT_NEAR(volumeOf(taken(fine->tessellate())) * unit, c.volume, 0.006 * c.volume);
        EXPECT_EQ(fine->countInverted(), 0);
        EXPECT_EQ(fine->countFlat(), 0);
    }
}

TEST(VoutLatticeWarps, wholeTurnClosesTheTube)
{
    voutLattice lattice(8, 3, 2, kLower, kUpper);
    lattice.cylinder(1, 0, 0, 4);
    for (int k = 0; k <= 2; ++k)
        for (int j = 0; j <= 3; ++j) {
            const dvec3 first = vertexOf(lattice, lattice.getVertexIndex(0, j, k));
            const dvec3 last = vertexOf(lattice, lattice.getVertexIndex(8, j, k));
            EXPECT_LE(glm::distance(first, last), 2e-6);
            EXPECT_NEAR(glm::distance(first, dvec3(8, 1, first.z)), j * 4 / 3.0, 2e-6);
            EXPECT_LE(glm::distance(vertexOf(lattice, lattice.getVertexIndex(4, j, k)),
                                    dvec3(8, 1 + j * 4 / 3.0, first.z)),
                      2e-6);
        }
    // Boxes at the axis lose a face: what is left of them has a volume, and nothing is inside out.
    EXPECT_GT(lattice.countFlat(), 0);
    EXPECT_EQ(lattice.countInverted(), 0);
    const Tetras tetras = taken(lattice.tessellate());
    EXPECT_NEAR(volumeOf(tetras), 8 * 0.5 * 16 * std::sin(45 * kDegree) * 20, 1e-3);
}

void shear(float position[3], void* user)
{
    const float* amount = static_cast<const float*>(user);
    position[0] += *amount * position[2];
    position[1] = -position[1];
}

TEST(VoutLatticeWarps, ofTheCallersFunctionGetPositionsInVoxels)
{
    voutLattice lattice(4, 3, 2, kLower, kUpper);
    const float spacing[3] = {3, 4, 5};
    lattice.setSpacing(spacing);
    float amount = 0.25f;
    lattice.warp(shear, &amount);
    expectEachAt(lattice, [](const dvec3& p) { return dvec3(p.x + 0.25 * p.z, -p.y, p.z); });
    // A mirror turns everything inside out.
    EXPECT_EQ(lattice.countInverted(), 4 * 3 * 2 * 5);
    lattice.warp(shear, &amount); // on from there
    expectEachAt(lattice, [](const dvec3& p) { return p + dvec3(0.5 * p.z, 0, 0); });
    EXPECT_EQ(lattice.countInverted(), 0);
}

/// The three hat functions of one axis at a point, by their definition.
double hat(double at, int centre)
{
    return std::max(0.0, 1 - std::abs(at - centre));
}

TEST(VoutLatticeWarps, displacementsAreTrilinearAndConstantBeyondTheOutermostCentres)
{
    const int sizes[3] = {4, 1, 3};
    std::vector<float> vectors;
    std::mt19937 random(5);
    for (int i = 0; i < 4 * 1 * 3 * 3; ++i)
        vectors.push_back(float(random() % 1000) / 500 - 1);
    voutLattice lattice(7, 3, 9, kLower, kUpper);
    const float spacing[3] = {1, 1.5f, 0.5f};
    lattice.setSpacing(spacing);
    lattice.displace(vectors.data(), sizes, 2);
    expectEachAt(lattice, [&](const dvec3& p) {
        const dvec3 part = (p - kMiddle) / kSize + 0.5;
        const double x = std::clamp(part.x * 4 - 0.5, 0.0, 3.0), z = std::clamp(part.z * 3 - 0.5, 0.0, 2.0);
        dvec3 vector(0);
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 4; ++i) {
                const float* v = vectors.data() + 3 * (k * 4 + i);
                vector += hat(x, i) * hat(z, k) * dvec3(v[0], v[1], v[2]);
            }
        return p + 2.0 * vector / kSpacing;
    });
}

TEST(VoutLatticeWarps, displacementsAreTakenWhereTheVerticesAre)
{
    const int sizes[3] = {12, 1, 1};
    std::vector<float> vectors;
    for (int i = 0; i < 12; ++i)
        vectors.insert(vectors.end(), {0, float(i), 0}); // y by x - 2.5
    voutLattice lattice(3, 1, 1, kLower, kUpper);
    float position[3] = {0, 0, 0};
    lattice.getVertex(0, position);
    position[0] = 7.25f;
    lattice.setVertex(0, position);
    lattice.displace(vectors.data(), sizes);
    EXPECT_LE(glm::distance(vertexOf(lattice, 0), dvec3(7.25, -3 + 4.75, 1)), 1e-6);
}

TEST(VoutLatticeWarps, fittedLieInTheSphereRoundTheBox)
{
    voutLattice unmoved(2, 3, 4, kLower, kUpper);
    unmoved.fit();
    expectEachAt(unmoved, [](const dvec3& p) { return p; });
    for (const WarpCase& c : warpCases()) {
        SCOPED_TRACE(c.name);
        const std::unique_ptr<voutLattice> lattice(warped(c, 5));
        const dvec3 a = vertexOf(*lattice, 0), b = vertexOf(*lattice, 100), e = vertexOf(*lattice, 215);
        lattice->fit();
        double farthest = 0;
        dvec3 least(HUGE_VAL), most(-HUGE_VAL);
        for (int vertex = 0; vertex < lattice->getVertexCount(); ++vertex) {
            const dvec3 p = (vertexOf(*lattice, vertex) - kMiddle) * kSpacing;
            farthest = std::max(farthest, glm::length(p));
            least = glm::min(least, p);
            most = glm::max(most, p);
        }
        EXPECT_NEAR(farthest, glm::length(kMeasured) / 2, 1e-5);
        EXPECT_LE(glm::length(least + most), 2e-5);
        // All by one scale.
        const dvec3 fa = vertexOf(*lattice, 0), fb = vertexOf(*lattice, 100), fe = vertexOf(*lattice, 215);
        const double scale = glm::distance(fa, fb) / glm::distance(a, b);
        EXPECT_LE(glm::distance(fe - fa, scale * (e - a)), 1e-4);
    }
}

TEST(VoutLatticeFolds, countTetrahedraThatAreInsideOutOrFlat)
{
    voutLattice lattice(2, 2, 2, kLower, kUpper);
    lattice.setTetrasPerHexa(24);
    const int middle = lattice.getVertexIndex(1, 1, 1);
    float position[3];
    lattice.getVertex(middle, position);
    position[0] = 2; // onto the face of the box: the faces there have moved half and a quarter as far
    lattice.setVertex(middle, position);
    const Tetras tetras = taken(lattice.tessellate());
    int inverted = 0, flat = 0;
    for (const auto& corners : tetras.corners) {
        const auto at = [&](std::size_t i) { return tetras.position(corners[i]); };
        const double volume = glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0));
        inverted += volume < -1e-4;
        flat += std::abs(volume) <= 1e-4;
    }
    EXPECT_EQ(lattice.countInverted(), inverted);
    EXPECT_EQ(lattice.countFlat(), flat);
    position[0] = -40;
    lattice.setVertex(middle, position);
    EXPECT_GT(lattice.countInverted(), 0);

    lattice.reset();
    lattice.taper(2, 0); // a pyramid: each of the upper boxes loses a face
    EXPECT_EQ(lattice.countInverted(), 0);
    EXPECT_GT(lattice.countFlat(), 0);
    lattice.reset();
    lattice.taper(2, -1); // both axes turn round: half a turn, not a mirror
    EXPECT_EQ(lattice.countInverted(), 0);
    expectNoError();
}

void collapse(float position[3], void*)
{
    position[0] = position[1] = position[2] = 7;
}

/// Onto a plane on which floats seldom lie.
void flatten(float position[3], void*)
{
    position[2] = 0.3f * position[0] + 0.7f * position[1] + 0.123f;
}

TEST(VoutLatticeFolds, roundingIsNoVolume)
{
    voutLattice lattice(5, 4, 3, kLower, kUpper);
    lattice.warp(flatten);
    EXPECT_EQ(lattice.countFlat(), 5 * 4 * 3 * 5);
    EXPECT_EQ(lattice.countInverted(), 0);
}

/// Slices of anything, without a context.
int countPolygons(voIndexedTetraSet& tetras)
{
    voBrickSetCollection bricks(16, 16, 24, 16, 16, 24, voPartialBrickTypeScope::AUGMENT, 1,
                                voInternalFormatTypeScope::INTENSITY8_EXT,
                                voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE,
                                voInterpolationTypeScope::_3D);
    bricks.setCurrentBrickSet(voPlaneOrientationScope::XY);
    constexpr int kPlanes = 64;
    voVertexData vertices(1000000, 6);
    std::vector<std::unique_ptr<voIndexedFaceSet>> sets;
    std::vector<voIndexedFaceSet*> row;
    for (int plane = 0; plane < kPlanes; ++plane) {
        sets.push_back(std::make_unique<voIndexedFaceSet>(&vertices, 0));
        row.push_back(sets.back().get());
    }
    voIndexedFaceSet** rows[] = {row.data()};
    GLdouble model[16] = {0.6, 0, 0.8, 0, 0, 1, 0, 0, -0.8, 0, 0.6, 0, 0, 0, 0, 1};
    GLdouble projection[16] = {0.01, 0, 0, 0, 0, 0.01, 0, 0, 0, 0, -0.01, 0, 0, 0, 0, 1};
    float period[3] = {1, 1, 1};
    int samples = 0;
    voGeometryActions::polygonize(&tetras, bricks.getCurrentBrickSet(), voInterleavedArrayTypeScope::T3F_V3F,
                                  model, projection, voSamplingModeScope::VIEWPORT_ALIGNED,
                                  voSamplingSpaceScope::OBJECT, period, kPlanes, samples, rows);
    int polygons = 0;
    for (int plane = 0; plane < samples; ++plane)
        for (voIndexedFaceSetIterator each(row[std::size_t(plane)]); !each.doneP(); each.nextPrimitive())
            ++polygons;
    return polygons;
}

TEST(VoutLatticeFolds, areSlicedLikeAnythingElse)
{
    std::mt19937 random(11);
    voutLattice lattice(4, 4, 4, kLower, kUpper);
    for (int vertex = 0; vertex < lattice.getVertexCount(); ++vertex) {
        float position[3];
        for (float& coordinate : position)
            coordinate = float(random() % 2000) / 100;
        lattice.setVertex(vertex, position);
    }
    EXPECT_GT(lattice.countInverted(), 50);
    std::unique_ptr<voIndexedTetraSet> folded(lattice.tessellate());
    ASSERT_NE(folded, nullptr);
    EXPECT_GT(countPolygons(*folded), 300);
    lattice.warp(collapse);
    EXPECT_EQ(lattice.countFlat(), 4 * 4 * 4 * 5);
    std::unique_ptr<voIndexedTetraSet> point(lattice.tessellate());
    ASSERT_NE(point, nullptr);
    EXPECT_EQ(countPolygons(*point), 0);
    expectNoError();
    lattice.fit();
    expectBadValue("at one point");
}

TEST(VoutLatticeErrors, numbersThatMakeNoLatticeAreRefused)
{
    const float infinite[3] = {HUGE_VALF, 5, 21};
    const auto expectNone = [](int nx, int ny, int nz, const float* lower, const float* upper,
                               const char* why) {
        voutLattice lattice(nx, ny, nz, lower, upper);
        expectBadValue(why);
        EXPECT_EQ(lattice.getVertexCount(), 0);
        EXPECT_EQ(lattice.tessellate(), nullptr);
        expectBadValue("no lattice");
        EXPECT_EQ(lattice.countInverted(), -1);
        expectBadValue("no lattice");
        EXPECT_EQ(lattice.countFlat(), -1);
        EXPECT_EQ(lattice.getVertexIndex(0, 0, 0), -1);
        lattice.twist(2, 10);
        lattice.fit();
        lattice.warp(collapse);
        lattice.reset();
        expectBadValue("no lattice");
    };
    expectNone(0, 1, 1, kLower, kUpper, "boxes");
    expectNone(1, 1, -5, kLower, kUpper, "boxes");
    expectNone(1, 1, 1, kUpper, kLower, "not above");
    expectNone(1, 1, 1, kLower, infinite, "finite");
    expectNone(1, 1, 1, NULL, kUpper, "lower");
    expectNone(1, 1, 1, kLower, NULL, "upper");
    expectNone(100000, 100000, 100000, kLower, kUpper, "numbered");
    const int most = std::numeric_limits<int>::max();
    expectNone(most, most, most, kLower, kUpper, "numbered");
}

void toInfinity(float position[3], void*)
{
    position[1] = HUGE_VALF;
}

TEST(VoutLatticeErrors, wrongArgumentsMoveNothing)
{
    voutLattice lattice(2, 2, 2, kLower, kUpper);
    const std::function<void()> wrong[] = {
        [&] { lattice.twist(3, 10); },
        [&] { lattice.twist(-1, 10); },
        [&] { lattice.twist(0, NAN); },
        [&] { lattice.bend(1, 1, 10); },
        [&] { lattice.bend(1, 5, 10); },
        [&] { lattice.taper(7, 1); },
        [&] { lattice.taper(0, HUGE_VALF); },
        [&] { lattice.fan(0, 0, 60, 1, 2); },
        [&] { lattice.fan(0, 1, 60, 2, 1); },
        [&] { lattice.fan(0, 1, 60, -1, 1); },
        [&] { lattice.fan(0, 1, 60, 0, HUGE_VALF); },
        [&] { lattice.cylinder(0, 1, 1, 1); },
        [&] { lattice.warp(NULL); },
        [&] { lattice.warp(toInfinity); },
        [&] { lattice.setVertex(27, kLower); },
        [&] { lattice.setVertex(-1, kLower); },
        [&] { lattice.setVertex(0, NULL); },
        [&] {
            const float nowhere[3] = {0, NAN, 0};
            lattice.setVertex(0, nowhere);
        },
        [&] {
            const float spacing[3] = {1, 0, 1};
            lattice.setSpacing(spacing);
        },
        [&] { lattice.setTetrasPerHexa(7); },
        [&] {
            const int sizes[3] = {1, 0, 1};
            lattice.displace(kLower, sizes);
        },
        [&] {
            const int sizes[3] = {1, 1, 1};
            lattice.displace(NULL, sizes);
        },
        [&] {
            const int sizes[3] = {1, 1, 1};
            lattice.displace(kLower, sizes, NAN);
        },
        [&] { EXPECT_EQ(lattice.getVertexIndex(3, 0, 0), -1); },
        [&] { lattice.getVertex(0, NULL); },
    };
    int number = 0;
    for (const auto& call : wrong) {
        SCOPED_TRACE(number++);
        call();
        expectBadValue();
        expectEachAt(
            lattice, [](const dvec3& p) { return p; }, 0);
    }
    EXPECT_EQ(lattice.getTetrasPerHexa(), 5);
    float position[3] = {1, 2, 3};
    lattice.getVertex(99, position);
    expectBadValue("99 of 27");
    EXPECT_EQ(position[0], 1);
}

} // namespace
