#include "polygonize/polygonize.h"

#include "cuts.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>

using namespace scenes;
using cuts::Cut, cuts::cutUp, cuts::expectAreasOfSections, cuts::forViews, cuts::kSize, cuts::sectionOf;

namespace {

constexpr double kUlp = 1.0 / (1 << 18); // of a float in [32, 64)

void expectFacesInPlaneAndBox(const Cut& cut, std::span<const vo::Box> boxes)
{
    const double length = glm::length(cut.planes.normal);
    for (const Face& face : cut.faces.all) {
        ASSERT_GE(face.count(), 3);
        const vo::Box& box = boxes[static_cast<std::size_t>(face.brick)];
        for (int i = 0; i < face.count(); ++i) {
            const glm::dvec3 p = face.point(i);
            EXPECT_NE(p, face.point((i + 1) % face.count()));
            EXPECT_LE(std::abs(glm::dot(cut.planes.normal, p) - cut.planes.offset(face.sample)) / length,
                      4 * kUlp);
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(p[axis], box.lower[axis] - 4 * kUlp);
                EXPECT_LE(p[axis], box.upper[axis] + 4 * kUlp);
            }
        }
    }
}

/// Sides are closed unless they lie on the outer boundary.
void expectClosedSeams(const Faces& faces, const vo::Box& hull)
{
    EXPECT_GT(
        cuts::expectClosedSeams(faces, [&](const Face&, const glm::dvec3& a,
                                           const glm::dvec3& b) { return !cuts::liesInFace(hull, a, b); }),
        0);
}

struct NamedSet
{
    const char* name;
    TetraSet set;
};

/// Sets that reach beyond the clip boxes on every side.
std::vector<NamedSet> coveringSets()
{
    return {{"cube", cube(kSize)},
            {"one large tetrahedron", largeTetra(kSize)},
            {"jittered lattice", jitteredLattice(5, -6.0, kSize + 6.0, 0.12, 7)}};
}

/// Calls check(set, boxes) for these sets and one, eight and 27 bricks.
template <class Check>
void forSetsAndBricks(const Check& check)
{
    for (const NamedSet& each : coveringSets())
        for (const int perAxis : {1, 2, 3}) {
            SCOPED_TRACE(testing::Message() << each.name << ", bricks per axis " << perAxis);
            check(each.set, bricks(perAxis, kSize));
        }
}

} // namespace

TEST(Polygonize, facesSumToCrossSectionForAnySetAndBricks)
{
    forSetsAndBricks([](const TetraSet& set, std::span<const vo::Box> boxes) {
        forViews(3, 11, [&](const vo::Camera& view) {
            expectAreasOfSections(cutUp(set, boxes, view, everyVoxel()), set, hull(boxes), 3);
        });
    });
}

TEST(Polygonize, facesOfSetInsideBricksSumToItsOwnCrossSection)
{
    const TetraSet set = jitteredLattice(4, 6.0, kSize - 5.0, 0.14, 3);
    const std::vector<vo::Box> boxes = bricks(3, kSize);
    forViews(3, 12, [&](const vo::Camera& view) {
        expectAreasOfSections(cutUp(set, boxes, view, everyVoxel()), set, hull(boxes), 2);
    });
}

TEST(Polygonize, coveredBoxGivesClosedFormOfItsCrossSection)
{
    for (const NamedSet& each : coveringSets()) {
        SCOPED_TRACE(each.name);
        const std::vector<vo::Box> boxes = bricks(3, kSize);
        forViews(6, 13, [&](const vo::Camera& view) {
            const Cut cut = cutUp(each.set, boxes, view, everyVoxel());
            if (glm::min(std::abs(cut.planes.normal.x),
                         std::min(std::abs(cut.planes.normal.y), std::abs(cut.planes.normal.z))) < 0.05)
                return; // the closed form divides by their product
            const std::vector<double> areas = cut.faces.areas(cut.planes.count);
            for (int k = 0; k < cut.planes.count; ++k) {
                const double area = exact::boxSectionArea(hull(boxes), sectionOf(cut.planes, k));
                EXPECT_NEAR(areas[static_cast<std::size_t>(k)], area, 1e-5 * area + 1e-6 * kSize * kSize);
            }
        });
    }
}

TEST(Polygonize, facesLieInTheirPlaneAndTheirClipBox)
{
    forSetsAndBricks([](const TetraSet& set, std::span<const vo::Box> boxes) {
        forViews(4, 14, [&](const vo::Camera& view) {
            expectFacesInPlaneAndBox(cutUp(set, boxes, view, everyVoxel()), boxes);
        });
    });
}

TEST(Polygonize, seamVerticesAreEqualBitForBit)
{
    forSetsAndBricks([](const TetraSet& set, std::span<const vo::Box> boxes) {
        if (set.view().tetraCount() == 1 && boxes.size() == 1) return; // no seam
        forViews(4, 15, [&](const vo::Camera& view) {
            expectClosedSeams(cutUp(set, boxes, view, everyVoxel()).faces, hull(boxes));
        });
    });
}

TEST(Polygonize, seamsCloseWhenDepthIsStretched)
{
    const TetraSet set = jitteredLattice(5, -6.0, kSize + 6.0, 0.12, 8);
    const std::vector<vo::Box> boxes = bricks(3, kSize);
    std::mt19937 random(16);
    for (int i = 0; i < 4; ++i) {
        const glm::dmat4 model = gl_matrices::translate({0, 0, -150}) * randomRotation(random) *
                                 gl_matrices::scale({1.0, 0.6, 2.7}) *
                                 gl_matrices::translate(glm::dvec3(-24));
        const vo::Camera view = vo::findCamera(model, gl_matrices::frustum(-9, 14, -7, 12, 20, 400)).value();
        vo::SamplingRequest request;
        request.period = glm::dvec3(1.0, 0.7, 2.0);
        request.maxSamples = 400;
        const Cut cut = cutUp(set, boxes, view, request);
        expectClosedSeams(cut.faces, hull(boxes));
        expectFacesInPlaneAndBox(cut, boxes);
        expectAreasOfSections(cut, set, hull(boxes), 7);
    }
}

TEST(Polygonize, facesRunCounterclockwiseForTheViewer)
{
    TetraSet mirrored = cube(kSize);
    for (std::size_t i = 0; i < mirrored.indices.size(); i += 8)
        std::swap(mirrored.indices[i], mirrored.indices[i + 1]);
    for (const TetraSet& set : {cube(kSize), mirrored, largeTetra(kSize)})
        forViews(3, 17, [&](const vo::Camera& view) {
            for (const Face& face : cutUp(set, bricks(2, kSize), view, everyVoxel()).faces.all)
                EXPECT_LE(glm::dot(face.area(), view.depthNormal), 1e-4);
        });
}

TEST(Polygonize, valuesFollowTheLinearFunctionTheyCameFrom)
{
    for (const int count : {3, 4, 7, 61}) {
        const TetraSet set = jitteredLattice(3, -5.0, kSize + 5.0, 0.1, 21).withValues(count);
        forViews(1, 18, [&](const vo::Camera& view) {
            const Cut cut = cutUp(set, bricks(2, kSize), view, everyVoxel());
            ASSERT_FALSE(cut.faces.all.empty());
            for (const Face& face : cut.faces.all)
                for (int i = 0; i < face.count(); ++i)
                    for (int j = 0; j < count; ++j) {
                        const double expected = linear(j, face.point(i));
                        ASSERT_NEAR(face.position(i)[j - count], expected, 1e-5 * std::abs(expected));
                    }
        });
    }
}

TEST(Polygonize, areaTimesSpacingConvergesToTheVolume)
{
    const std::vector<vo::Box> boxes = bricks(3, kSize);
    const double volume = std::pow(kSize - 1.0, 3);
    forViews(2, 19, [&](const vo::Camera& view) {
        double previous = 1.0;
        for (const int samples : {32, 128, 512}) {
            vo::SamplingRequest request;
            request.maxSamples = samples;
            const Cut cut = cutUp(cube(kSize), boxes, view, request);
            EXPECT_EQ(cut.planes.count, samples);
            const std::vector<double> areas = cut.faces.areas(samples);
            // Offsets are lengths along the view, the distance between planes is shorter.
            const double distance = cut.planes.spacing / glm::length(cut.planes.normal);
            const double sum = std::accumulate(areas.begin(), areas.end(), 0.0) * distance;
            const double error = std::abs(sum / volume - 1.0);
            EXPECT_LT(error, std::min(previous, 20.0 / samples / samples + 1e-6));
            previous = error + 1e-6;
        }
    });
}

TEST(Polygonize, planeThroughSharedFaceYieldsItOnce)
{
    // A plane through the layers of a lattice meets nothing but shared faces.
    const TetraSet set = jitteredLattice(4, 0.0, 64.0, 0.0, 1);
    const std::vector<vo::Box> boxes{{glm::dvec3(-1), glm::dvec3(65)}};
    for (const glm::dvec3& eye : {glm::dvec3(0, 0, 1), glm::dvec3(0, 0, -1), glm::dvec3(1, 0, 0),
                                  glm::dvec3(-1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0)}) {
        const glm::dvec3 up = std::abs(eye.y) > 0.5 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
        const vo::Camera view = vo::findCamera(gl_matrices::lookAt(32.0 + 100.0 * eye, glm::dvec3(32), up),
                                               gl_matrices::ortho(-50, 50, -50, 50, 68, 132))
                                    .value();
        vo::SamplingRequest request = everyVoxel();
        request.mode = vo::SamplingMode::axisAligned;
        request.space = vo::SamplingSpace::viewVolume;
        request.period = glm::dvec3(16.0);
        const Cut cut = cutUp(set, boxes, view, request);
        ASSERT_EQ(cut.planes.count, 5);
        for (const double area : cut.faces.areas(5))
            EXPECT_EQ(area, 64.0 * 64.0);
        EXPECT_EQ(cut.faces.all.size(), 5u * 2u * 16u); // two triangles a cell, each once
    }
}

TEST(Polygonize, planesThroughVerticesAndEdgesLoseNothing)
{
    // Diagonal planes of a regular lattice pass through its vertices and along its edges.
    const TetraSet set = jitteredLattice(4, 0.0, 32.0, 0.0, 1);
    const std::vector<vo::Box> boxes{{glm::dvec3(-1), glm::dvec3(33)}};
    vo::Camera view;
    for (const glm::dvec3& along : {glm::dvec3(1, 1, 0), glm::dvec3(1, -1, 0), glm::dvec3(1, 1, 1),
                                    glm::dvec3(-1, 1, 1), glm::dvec3(0, 1, -1), glm::dvec3(2, 1, 0)}) {
        view.direction = view.depthNormal = glm::normalize(along);
        for (const int samples : {1, 2, 4, 8, 12}) {
            vo::SamplingRequest request;
            request.maxSamples = samples;
            const Cut cut = cutUp(set, boxes, view, request);
            const std::vector<double> areas = cut.faces.areas(samples);
            for (int k = 0; k < samples; ++k) {
                // Just beside the plane the section is as large, and no edge lies in it.
                exact::Section section = sectionOf(cut.planes, k);
                section.origin += section.n * 1e-9L;
                const double area = exact::sectionArea(set.view(), boxes[0], section);
                EXPECT_NEAR(areas[static_cast<std::size_t>(k)], area, 1e-5 * area);
            }
        }
    }
}

TEST(Polygonize, flatTetrahedraAreIgnored)
{
    TetraSet set = cube(kSize);
    const Cut plain =
        cutUp(set, bricks(2, kSize), camera(kSize, gl_matrices::rotate(30, {1, 2, 3}), false), everyVoxel());
    for (const int vertex : {0, 1, 2, 3, 5, 5, 5, 5, 0, 1, 1, 6, 0, 6, 6, 0})
        set.indices.push_back(vertex);
    const Cut more =
        cutUp(set, bricks(2, kSize), camera(kSize, gl_matrices::rotate(30, {1, 2, 3}), false), everyVoxel());
    ASSERT_EQ(more.faces.all.size(), plain.faces.all.size());
    for (std::size_t i = 0; i < plain.faces.all.size(); ++i)
        EXPECT_EQ(more.faces.all[i].records, plain.faces.all[i].records);
}

TEST(Polygonize, verticesThatAreNotFiniteSpoilTheirTetrahedraOnly)
{
    TetraSet set = cube(kSize);
    const std::size_t faces =
        cutUp(set, bricks(2, kSize), camera(kSize, glm::dmat4(1), false), everyVoxel()).faces.all.size();
    const float bad[]{std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                      -1e38f};
    set.records.insert(set.records.end(), std::begin(bad), std::end(bad));
    for (const int vertex : {0, 2, 5, 8})
        set.indices.push_back(vertex);
    EXPECT_EQ(
        cutUp(set, bricks(2, kSize), camera(kSize, glm::dmat4(1), false), everyVoxel()).faces.all.size(),
        faces);
}

TEST(Polygonize, hugeTetrahedraAreCutLikeOthers)
{
    const TetraSet set = largeTetra(1e6);
    vo::SamplingRequest request = everyVoxel(64);
    const Cut cut =
        cutUp(set, bricks(2, kSize), camera(kSize, gl_matrices::rotate(20, {1, 1, 0}), false), request);
    EXPECT_EQ(cut.planes.count, 64);
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    expectAreasOfSections(cut, set, hull(boxes));
}

TEST(Polygonize, headOnPlanesInFacesAndSeamsLoseNothing)
{
    for (const int perAxis : {1, 2, 3})
        for (const TetraSet& set : {cube(kSize), jitteredLattice(3, 0.0, kSize, 0.0, 1)})
            for (const double x : {0.0, 90.0, 180.0, 270.0})
                for (const double y : {0.0, 90.0, 180.0, 270.0})
                    for (const double noise : {0.0, 1e-16, -3e-16}) {
                        SCOPED_TRACE(testing::Message() << perAxis << " bricks, turned " << x << " " << y);
                        const glm::dmat4 turn = headOnTurn(x, y, noise);
                        const std::vector<vo::Box> boxes = bricks(perAxis, kSize);
                        const Cut cut = cutUp(set, boxes, camera(kSize, turn, false), everyVoxel());
                        ASSERT_EQ(cut.planes.count, kSize);
                        const std::vector<double> areas = cut.faces.areas(cut.planes.count);
                        for (int k = 0; k < cut.planes.count; ++k)
                            ASSERT_NEAR(areas[static_cast<std::size_t>(k)], 47.0 * 47.0, 1e-3)
                                << "plane " << k;
                    }
}

TEST(Polygonize, boxesKeepLowerFacesAndDropUpperOnesButTheVolumes)
{
    const std::vector<vo::Box> boxes = lattice({0.5, 8.5, 15.5}, {0.5, 15.5}, {0.5, 15.5});
    const Cut cut = cutUp(cube(16), boxes, parallelCamera({1, 0, 0}), everyVoxel());
    ASSERT_EQ(cut.planes.count, 16);
    for (const Face& face : cut.faces.all)
        EXPECT_EQ(face.brick, face.point(0).x < 8.5 ? 0 : 1);
    for (const double area : cut.faces.areas(16))
        EXPECT_EQ(area, 15.0 * 15.0);
}

TEST(Polygonize, upperFaceWithoutNeighbourIsKept)
{
    std::vector<vo::Box> boxes = lattice({0.5, 8.5, 15.5}, {0.5, 8.5, 15.5}, {0.5, 15.5});
    boxes.pop_back(); // the one with both x and y above 8.5
    const Cut cut = cutUp(cube(16), boxes, parallelCamera({1, 0, 0}), everyVoxel());
    const std::vector<double> areas = cut.faces.areas(16);
    EXPECT_EQ(areas[7], 15.0 * 15.0) << "x = 8.5";
    EXPECT_EQ(areas[6], 8.0 * 15.0) << "x = 9.5";
}

TEST(Polygonize, equalBoxesEachReceiveTheFaces)
{
    std::vector<vo::Box> boxes = bricks(1, kSize);
    boxes.push_back(boxes[0]);
    const Cut cut = cutUp(cube(kSize), boxes, camera(kSize, glm::dmat4(1), false), everyVoxel());
    for (const double area : cut.faces.areas(cut.planes.count))
        EXPECT_NEAR(area, 2 * 47.0 * 47.0, 1e-3);
}

TEST(Polygonize, axisAlignedPlanesCrossTheAxis)
{
    std::mt19937 random(23);
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    for (int i = 0; i < 8; ++i) {
        const vo::Camera view = camera(kSize, randomRotation(random), i % 2);
        vo::SamplingRequest request = everyVoxel();
        request.mode = vo::SamplingMode::axisAligned;
        request.period = glm::dvec3(1.0, 0.5, 2.0);
        const Cut cut = cutUp(cube(kSize), boxes, view, request);
        const int axis = vo::closestAxis(view);
        EXPECT_EQ(cut.planes.count, static_cast<int>(kSize / (*request.period)[axis]));
        for (const Face& face : cut.faces.all)
            for (int v = 0; v < face.count(); ++v)
                EXPECT_EQ(face.point(v)[axis] * cut.planes.normal[axis], cut.planes.offset(face.sample));
        expectAreasOfSections(cut, cube(kSize), hull(boxes), 5);
        expectClosedSeams(cut.faces, hull(boxes));
    }
}

TEST(Polygonize, stackPlanesAtBothEndsOfTheSetAreDrawn)
{
    // A set that begins and ends on voxel centres: its first and last faces lie in planes.
    for (const double side : {1.0, -1.0}) {
        const vo::Camera view = parallelCamera({0, 0, side});
        const Cut cut = cutUp(cube(glm::dvec3(0.5), glm::dvec3(15.5)), bricks(1, 16), view, everySlice(2));
        ASSERT_EQ(cut.planes.count, 16);
        for (const double area : cut.faces.areas(16))
            EXPECT_EQ(area, 15.0 * 15.0);
        for (const Face& face : cut.faces.all)
            EXPECT_LE(glm::dot(face.area(), view.depthNormal), 0.0);
    }
}

TEST(Polygonize, sliceOfSingleLayerFillsItsFlatBox)
{
    const std::vector<vo::Box> boxes = lattice({0.5, 7.5}, {0.5, 3.5, 7.5}, {0.5, 0.5});
    const Cut cut =
        cutUp(cube(glm::dvec3(0), glm::dvec3(8, 8, 1)), boxes, parallelCamera({0, 0, -1}), everySlice(2));
    ASSERT_EQ(cut.planes.count, 1);
    EXPECT_EQ(cut.faces.areas(1)[0], 49.0);
}

TEST(Polygonize, viewVolumePlanesSpanTheFrustum)
{
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    std::mt19937 random(29);
    for (const bool perspective : {false, true}) {
        vo::SamplingRequest request = everyVoxel();
        request.space = vo::SamplingSpace::viewVolume;
        const Cut cut =
            cutUp(cube(kSize), boxes, camera(kSize, randomRotation(random), perspective), request);
        EXPECT_EQ(cut.planes.count, 3 * static_cast<int>(kSize) + 1);
        expectAreasOfSections(cut, cube(kSize), hull(boxes), 4);
        expectFacesInPlaneAndBox(cut, boxes);
    }
}

TEST(Polygonize, primitivePlanesDivideEachTetrahedron)
{
    const TetraSet set = jitteredLattice(2, 2.0, kSize - 2.0, 0.1, 5);
    const std::vector<vo::Box> boxes = bricks(2, kSize);
    vo::SamplingRequest request = everyVoxel();
    request.space = vo::SamplingSpace::primitive;
    forViews(2, 31, [&](const vo::Camera& view) {
        const Cut cut = cutUp(set, boxes, view, request);
        std::vector<double> expected(static_cast<std::size_t>(cut.planes.count));
        int most = 0;
        for (int tetra = 0; tetra < set.view().tetraCount(); ++tetra) {
            const vo::PlaneFamily own = vo::primitivePlanes(set.view(), tetra, view, request);
            const vo::TetraView one{set.records, set.values,
                                    std::span(set.indices).subspan(static_cast<std::size_t>(tetra) * 4, 4)};
            most = std::max(most, own.count);
            for (int k = 0; k < own.count; ++k)
                expected[static_cast<std::size_t>(k)] +=
                    exact::sectionArea(one, hull(boxes), sectionOf(own, k));
        }
        EXPECT_EQ(cut.planes.count, most);
        const std::vector<double> areas = cut.faces.areas(cut.planes.count);
        for (std::size_t k = 0; k < areas.size(); ++k)
            EXPECT_NEAR(areas[k], expected[k], 1e-5 * expected[k] + 1e-6 * kSize * kSize);
    });
}

TEST(Polygonize, slicesTooSmallForSinglePrecisionAreDropped)
{
    TetraSet set;
    for (const glm::dvec3& p : {glm::dvec3(1000), glm::dvec3(1008, 1000, 1008), glm::dvec3(1000, 1008, 1008),
                                glm::dvec3(992, 992, 1008)})
        set.add(p);
    set.indices = {0, 1, 2, 3};
    vo::Camera view = parallelCamera({0, 0, 1});
    view.nearDepth = 1000 + 1e-6; // less than half a unit in the last place from the tip
    view.farDepth = 1004;
    vo::SamplingRequest request = everyVoxel(2);
    request.space = vo::SamplingSpace::viewVolume;
    const std::vector<vo::Box> boxes{{glm::dvec3(900), glm::dvec3(1100)}};
    const Cut cut = cutUp(set, boxes, view, request);
    ASSERT_EQ(cut.faces.all.size(), 1u);
    EXPECT_EQ(cut.faces.all[0].sample, 0);
}

TEST(Polygonize, verticesThatSinglePrecisionCannotTellApartAreOne)
{
    TetraSet set;
    for (const glm::dvec3& p : {glm::dvec3(1000, 1000, 1008), glm::dvec3(1008, 1000, 1000),
                                glm::dvec3(1000, 1008, 992), glm::dvec3(992, 992, 992)})
        set.add(p);
    set.indices = {0, 1, 2, 3};
    vo::Camera view = parallelCamera({0, 0, 1});
    view.nearDepth = 990;
    view.farDepth = 1000 - 1e-6; // cuts off the second vertex with an edge of a micron
    vo::SamplingRequest request = everyVoxel(1);
    request.space = vo::SamplingSpace::viewVolume;
    const std::vector<vo::Box> boxes{{glm::dvec3(900), glm::dvec3(1100)}};
    const Cut cut = cutUp(set, boxes, view, request);
    ASSERT_EQ(cut.faces.all.size(), 1u);
    EXPECT_EQ(cut.faces.all[0].count(), 3);
}

TEST(Polygonize, nothingToCutGivesNoFaces)
{
    const vo::Camera view = camera(kSize, glm::dmat4(1), true);
    const Cut noTetra = cutUp(TetraSet{}, bricks(2, kSize), view, everyVoxel());
    EXPECT_EQ(noTetra.planes.count, 0);
    EXPECT_TRUE(noTetra.faces.all.empty());
    const Cut noBrick = cutUp(cube(kSize), {}, view, everyVoxel());
    EXPECT_GT(noBrick.planes.count, 0);
    EXPECT_TRUE(noBrick.faces.all.empty());
    const Cut noDepth =
        cutUp(flatTetra(), bricks(2, kSize), camera(kSize, glm::dmat4(1), false), everyVoxel());
    EXPECT_EQ(noDepth.planes.count, 1);
    EXPECT_TRUE(noDepth.faces.all.empty());
}

TEST(Polygonize, bricksCutVoxelCoordinatesWhereRecordsHaveThem)
{
    const TetraSet set = cube(kSize).withVoxels(cuts::turnedIntoUnitCube);
    vo::SamplingRequest request = everyVoxel();
    request.period = glm::dvec3(1 / kSize);
    const vo::Camera view = camera(1, gl_matrices::rotate(33, {1, 2, 0}), true);
    const vo::Box all{glm::vec3(0), glm::vec3(float(kSize))};
    const Cut whole = cutUp(set, {&all, 1}, view, request);
    const auto boxes = bricks(3, kSize);
    const Cut parts = cutUp(set, boxes, view, request);
    const std::vector<double> expected = whole.faces.areas(whole.planes.count);
    const std::vector<double> found = parts.faces.areas(parts.planes.count);
    // The boxes leave half a voxel out at each side.
    const double left = (kSize - 1) / kSize;
    double sumOfWhole = 0, sumOfParts = 0;
    for (std::size_t k = 0; k < expected.size(); ++k) {
        sumOfWhole += expected[k];
        sumOfParts += found[k];
    }
    EXPECT_GT(expected.size(), 40u);
    EXPECT_NEAR(sumOfParts / sumOfWhole, left * left * left, 0.002);
    std::set<int> used;
    for (const Face& face : parts.faces.all) {
        used.insert(face.brick);
        const vo::Box& box = boxes[std::size_t(face.brick)];
        for (std::size_t i = 0; i < face.records.size(); i += 6)
            for (int axis = 0; axis < 3; ++axis) {
                const double voxel = face.records[i + std::size_t(axis)];
                EXPECT_GE(voxel, box.lower[axis] - 4 * kUlp);
                EXPECT_LE(voxel, box.upper[axis] + 4 * kUlp);
                EXPECT_NEAR(voxel, kSize * double(face.records[i + 3 + std::size_t((axis + 1) % 3)]), 2e-5);
            }
    }
    EXPECT_EQ(used.size(), 27u);
}

TEST(Polygonize, sinkWithoutRoomStopsTheWork)
{
    struct Full : vo::FaceSink
    {
        int taken = 0, asked = 0;
        bool append(int, int, std::span<const float>) override
        {
            ++asked;
            return taken < 10 && ++taken;
        }
    } sink;
    vo::PolygonizeWorkspace workspace;
    const TetraSet set = cube(kSize);
    const auto result = vo::polygonize(set.view(), bricks(2, kSize), camera(kSize, glm::dmat4(1), false),
                                       everyVoxel(), workspace, sink);
    EXPECT_FALSE(result.complete);
    EXPECT_EQ(result.samples, kSize);
    EXPECT_EQ(sink.taken, 10);
    EXPECT_EQ(sink.asked, 11);
}

TEST(Polygonize, workspaceServesOtherSetsAndBoxes)
{
    vo::PolygonizeWorkspace shared;
    const vo::Camera view = camera(kSize, gl_matrices::rotate(33, {1, 2, 0}), true);
    for (const int values : {0, 5, 2})
        for (const int perAxis : {3, 1, 2, 2}) {
            const TetraSet set = cube(kSize).withValues(values);
            Faces faces(set.values);
            vo::polygonize(set.view(), bricks(perAxis, kSize), view, everyVoxel(), shared, faces);
            const Cut fresh = cutUp(set, bricks(perAxis, kSize), view, everyVoxel());
            ASSERT_EQ(faces.all.size(), fresh.faces.all.size());
            for (std::size_t i = 0; i < faces.all.size(); ++i)
                EXPECT_EQ(faces.all[i].records, fresh.faces.all[i].records);
        }
}
