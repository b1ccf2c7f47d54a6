#include "expect_error.h"
#include "face_scene.h"

#include <vo/Volumizer.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <limits>
#include <type_traits>

namespace {

using namespace vo::test;
using Mode = voSamplingModeScope;
using Space = voSamplingSpaceScope;
using Format = voInterleavedArrayTypeScope;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A cube of 16 voxels seen along -z by an orthographic camera; overlap 0, so that nothing is cut away.
struct PolygonizeTest : testing::Test
{
    explicit PolygonizeTest(int brickSize = 16)
        : volume(byteVolume(16, brickSize, voInterpolationTypeScope::_3D, 0)), cube(16),
          tetras(&cube.vertices[0][0], 8, 3, cube.indices, 20)
    {
    }

    int polygonize(FaceSets& faces, voSamplingMode mode = Mode::VIEWPORT_ALIGNED,
                   voSamplingSpace space = Space::OBJECT)
    {
        return voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(), Format::V3F, model,
                                             projection, mode, space, usePeriod ? period : NULL,
                                             faces.samples(), samples, faces);
    }

    std::unique_ptr<voBrickSetCollection> volume;
    CubeArrays cube;
    voIndexedTetraSet tetras;
    Matrix model = translation(-8, -8, -8);
    Matrix projection = ortho(16, -32, 32);
    float period[3] = {1, 1, 1};
    bool usePeriod = true;
    int samples = INT_MIN;
};

struct PolygonizeBricksTest : PolygonizeTest
{
    PolygonizeBricksTest() : PolygonizeTest(8) {}
};

double areaOf(const std::vector<std::array<float, 3>>& p)
{
    double sum[3] = {0, 0, 0};
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
        double a[3], b[3];
        for (std::size_t k = 0; k < 3; ++k) {
            a[k] = double(p[i][k]) - p[0][k];
            b[k] = double(p[i + 1][k]) - p[0][k];
        }
        for (int k = 0; k < 3; ++k)
            sum[k] += a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    }
    return 0.5 * std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

double areaOf(voIndexedFaceSet& faces)
{
    double area = 0;
    for (const auto& polygon : polygonsOf(faces))
        area += areaOf(polygon);
    return area;
}

TEST_F(PolygonizeTest, headOnGivesOnePlaneAVoxelFarthestFirst)
{
    FaceSets faces(1, 40);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 16);
    for (int s = 0; s < 16; ++s) {
        EXPECT_NEAR(areaOf(faces.at(0, s)), 256.0, 1e-3);
        for (const auto& polygon : polygonsOf(faces.at(0, s)))
            for (const auto& position : polygon)
                EXPECT_NEAR(position[2], s + 0.5f, 1e-5f);
    }
    for (int s = 16; s < 40; ++s)
        EXPECT_EQ(faces.at(0, s).getIndices()->getCount(), 0);
    expectNoError();
}

TEST_F(PolygonizeTest, diagonalTakesSquareRootOfThreeTimesAsMany)
{
    model = diagonalView() * model;
    FaceSets faces(1, 64);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, static_cast<int>(std::ceil(16 * std::sqrt(3.0) - 1e-6)));
}

TEST_F(PolygonizeTest, anisotropicPeriodCountsAlongTheView)
{
    period[2] = 0.5f;
    FaceSets faces(1, 64);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 32);
}

TEST_F(PolygonizeTest, sampleCountIsClampedAndSpacingWidens)
{
    FaceSets faces(1, 4);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 4);
    EXPECT_NEAR(polygonsOf(faces.at(0, 3))[0][0][2], 14.0f, 1e-5f);
}

TEST_F(PolygonizeTest, withoutPeriodExactlyMaxSamplesAreUsed)
{
    usePeriod = false;
    FaceSets faces(1, 23);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 23);
}

TEST_F(PolygonizeTest, nineArgumentsGiveTheSamePolygons)
{
    model = rotation(33, 1, 2, 3) * model;
    FaceSets eleven(1, 40), nine(1, 40);
    EXPECT_EQ(polygonize(eleven), 0);
    int count = 40;
    EXPECT_EQ(voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(), model, projection,
                                            Mode::VIEWPORT_ALIGNED, Space::OBJECT, count, period, nine),
              0);
    EXPECT_EQ(count, samples);
    EXPECT_EQ(nine.contents(), eleven.contents());
    count = 17;
    EXPECT_EQ(voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(), model, projection,
                                            Mode::VIEWPORT_ALIGNED, Space::OBJECT, count, NULL, nine),
              0);
    EXPECT_EQ(count, 17);
}

TEST_F(PolygonizeBricksTest, twiceInARowGivesTheSame)
{
    model = rotation(25, 3, 1, 2) * model;
    FaceSets faces(8, 40);
    EXPECT_EQ(polygonize(faces), 0);
    const auto first = faces.contents();
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(faces.contents(), first);
    expectNoError();
}

TEST_F(PolygonizeTest, emptiesAllFaceSetsUpToMaxSamples)
{
    FaceSets faces(1, 40);
    model = diagonalView() * model;
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_GT(samples, 16);
    model = translation(-8, -8, -8);
    EXPECT_EQ(polygonize(faces), 0);
    for (int s = 16; s < 40; ++s)
        EXPECT_EQ(faces.at(0, s).getIndices()->getCount(), 0);
}

// FaceSets ends its rows with pointers that nobody may follow.
TEST_F(PolygonizeBricksTest, touchesNothingBeyondMaxSamplesAndBricks)
{
    FaceSets faces(8, 5);
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 5);
    usePeriod = false;
    EXPECT_EQ(polygonize(faces), 0);
    FaceSets one(8, 1);
    EXPECT_EQ(polygonize(one), 0);
    EXPECT_EQ(polygonize(one, Mode::AXIS_ALIGNED, Space::PRIMITIVE), 0);
    EXPECT_EQ(polygonize(one, Mode::VIEWPORT_ALIGNED, Space::VIEW_VOLUME), 0);
}

TEST_F(PolygonizeBricksTest, bricksShareTheAreaOfEachPlane)
{
    model = rotation(40, 1, 2, 0.5) * model;
    FaceSets bricked(8, 40);
    EXPECT_EQ(polygonize(bricked), 0);
    volume = byteVolume(16, 16, voInterpolationTypeScope::_3D, 0);
    FaceSets whole(1, 40);
    EXPECT_EQ(polygonize(whole), 0);
    for (int s = 0; s < samples; ++s) {
        double area = 0;
        for (int b = 0; b < 8; ++b)
            area += areaOf(bricked.at(b, s));
        EXPECT_NEAR(area, areaOf(whole.at(0, s)), 1e-3);
    }
}

TEST_F(PolygonizeTest, viewVolumeGoesFromZFarToZNear)
{
    projection = ortho(16, -4, 4);
    usePeriod = false;
    FaceSets faces(1, 9);
    EXPECT_EQ(polygonize(faces, Mode::VIEWPORT_ALIGNED, Space::VIEW_VOLUME), 0);
    EXPECT_EQ(samples, 9);
    for (int s = 0; s < 9; ++s)
        EXPECT_NEAR(polygonsOf(faces.at(0, s))[0][0][2], 4.0f + static_cast<float>(s), 1e-5f);
}

TEST_F(PolygonizeTest, primitiveSpaceSamplesEachTetrahedronOverItsOwnDepth)
{
    const float corners[] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 4, 0, 0, 8, 8, 0, 8, 0, 8, 8, 0, 0, 16};
    const int indices[] = {0, 1, 2, 3, 4, 5, 6, 7};
    voIndexedTetraSet two(corners, 8, 3, indices, 8);
    FaceSets faces(1, 20);
    EXPECT_EQ(voGeometryActions::polygonize(&two, volume->getCurrentBrickSet(), Format::V3F, model,
                                            projection, Mode::VIEWPORT_ALIGNED, Space::PRIMITIVE, period, 20,
                                            samples, faces),
              0);
    EXPECT_EQ(samples, 8);
    for (int s = 0; s < 8; ++s) {
        std::vector<float> depths;
        for (const auto& polygon : polygonsOf(faces.at(0, s)))
            depths.push_back(polygon[0][2]);
        std::sort(depths.begin(), depths.end());
        ASSERT_EQ(depths.size(), s < 4 ? 2u : 1u);
        EXPECT_NEAR(depths.back(), 8.5f + static_cast<float>(s), 1e-5f);
        if (s < 4) {
            EXPECT_NEAR(depths.front(), 0.5f + static_cast<float>(s), 1e-5f);
        }
    }
}

TEST_F(PolygonizeTest, axisAlignedPlanesStayWhileTheAxisStays)
{
    FaceSets straight(1, 40), turned(1, 40);
    EXPECT_EQ(polygonize(straight, Mode::AXIS_ALIGNED), 0);
    model = rotation(20, 0, 1, 0) * model;
    EXPECT_EQ(polygonize(turned, Mode::AXIS_ALIGNED), 0);
    EXPECT_EQ(samples, 16);
    EXPECT_EQ(turned.contents(), straight.contents());
    model = rotation(60, 0, 1, 0) * model;
    EXPECT_EQ(polygonize(turned, Mode::AXIS_ALIGNED), 0);
    const auto farthest = polygonsOf(turned.at(0, 0));
    ASSERT_FALSE(farthest.empty());
    for (const auto& position : farthest[0])
        EXPECT_NEAR(position[0], 15.5f, 1e-5f); // looking along x now, farthest first
}

TEST_F(PolygonizeTest, everyValueOfARecordIsInterpolated)
{
    std::vector<float> records;
    for (const auto& corner : cube.vertices)
        records.insert(records.end(), {corner[0], corner[1], corner[2], corner[0] / 16, corner[1] / 16,
                                       corner[2] / 16, 1, corner[0], corner[1], corner[2]});
    voIndexedTetraSet colored(records.data(), 8, 10, cube.indices, 20);
    model = rotation(50, 1, 1, 0) * model;
    FaceSets faces(1, 40, 10);
    EXPECT_EQ(voGeometryActions::polygonize(&colored, volume->getCurrentBrickSet(), Format::T3F_C4F_V3F,
                                            model, projection, Mode::DEFAULT, Space::DEFAULT, period, 40,
                                            samples, faces),
              0);
    ASSERT_GT(faces.vertices().getCount(), 100);
    for (int i = 0; i < faces.vertices().getCount(); ++i) {
        const float* r = faces.vertices()[i];
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(r[axis], r[7 + axis], 1e-4f);
            EXPECT_NEAR(r[3 + axis], r[7 + axis] / 16, 1e-5f);
        }
        EXPECT_NEAR(r[6], 1.0f, 1e-6f);
    }
}

TEST_F(PolygonizeBricksTest, fullVertexStorageGivesAShorterValidResult)
{
    model = rotation(30, 1, 1, 1) * model;
    for (const int room : {0, 2, 3, 50, 500}) {
        FaceSets faces(8, 40, 3, room);
        EXPECT_NE(polygonize(faces), 0);
        expectError(voErrorTypeScope::OUT_OF_MEMORY, "full");
        EXPECT_GT(samples, 0);
        EXPECT_LE(faces.vertices().getCount(), room);
        for (int b = 0; b < 8; ++b)
            for (int s = 0; s < 40; ++s)
                for (const auto& polygon : polygonsOf(faces.at(b, s)))
                    EXPECT_GE(polygon.size(), 3u);
        expectNoError();
    }
}

TEST_F(PolygonizeTest, faceSetsWithTheirOwnVerticesGrow)
{
    voIndexedFaceSet own(0, 3, 0);
    voIndexedFaceSet* row[] = {&own};
    voIndexedFaceSet** sets[] = {row};
    EXPECT_EQ(voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(), Format::V3F, model,
                                            projection, Mode::DEFAULT, Space::DEFAULT, period, 1, samples,
                                            sets),
              0);
    EXPECT_NEAR(areaOf(own), 256.0, 1e-3);
}

TEST_F(PolygonizeTest, degenerateTetrahedraAreIgnored)
{
    CubeArrays flat(16);
    for (auto& corner : flat.vertices)
        corner[0] = 3;
    voIndexedTetraSet nothing(&flat.vertices[0][0], 8, 3, flat.indices, 20);
    FaceSets faces(1, 40);
    EXPECT_EQ(voGeometryActions::polygonize(&nothing, volume->getCurrentBrickSet(), Format::V3F, model,
                                            projection, Mode::DEFAULT, Space::DEFAULT, period, 40, samples,
                                            faces),
              0);
    double area = 0;
    for (int s = 0; s < samples; ++s)
        area += areaOf(faces.at(0, s));
    EXPECT_EQ(area, 0);
}

TEST_F(PolygonizeTest, emptyTetraSetGivesNoFaces)
{
    voIndexedTetraSet nothing(0, 3, 0);
    FaceSets faces(1, 4);
    EXPECT_EQ(voGeometryActions::polygonize(&nothing, volume->getCurrentBrickSet(), Format::V3F, model,
                                            projection, Mode::DEFAULT, Space::DEFAULT, period, 4, samples,
                                            faces),
              0);
    EXPECT_EQ(faces.vertices().getCount(), 0);
}

TEST_F(PolygonizeTest, sphericalSurfacesAreShellsRoundTheEye)
{
    // The eye 24 before the middle of the cube, 16 from its front, sqrt(32^2 + 2 * 8^2) from its farthest
    // corners.
    model = translation(-8, -8, -8 - 24);
    projection = frustum(1, 1, 100);
    const float eye[3] = {8, 8, 32};
    FaceSets faces(1, 64);
    EXPECT_EQ(polygonize(faces, Mode::SPHERICAL), 0);
    const double farthest = std::sqrt(32.0 * 32 + 2 * 8 * 8), step = (farthest - 16) / 18;
    ASSERT_EQ(samples, 18);
    for (int k = 0; k < samples; ++k) {
        const double radius = farthest - (k + 0.5) * step;
        EXPECT_GT(polygonsOf(faces.at(0, k)).size(), 0u);
        for (const auto& polygon : polygonsOf(faces.at(0, k)))
            for (const auto& p : polygon)
                EXPECT_NEAR(std::hypot(p[0] - eye[0], p[1] - eye[1], p[2] - eye[2]), radius, 0.021 * step);
    }
    FaceSets few(1, 5);
    usePeriod = false;
    EXPECT_EQ(polygonize(few, Mode::SPHERICAL, Space::VIEW_VOLUME), 0);
    EXPECT_EQ(samples, 5);
    expectNoError();
}

TEST_F(PolygonizeTest, sphericalSurfacesOfAnOrthographicViewAreItsPlanes)
{
    model = diagonalView() * translation(-8, -8, -8);
    FaceSets planes(1, 64), shells(1, 64);
    EXPECT_EQ(polygonize(planes, Mode::VIEWPORT_ALIGNED), 0);
    const int count = samples;
    EXPECT_EQ(polygonize(shells, Mode::SPHERICAL), 0);
    EXPECT_EQ(samples, count);
    EXPECT_EQ(shells.contents(), planes.contents());
}

TEST_F(PolygonizeTest, badArgumentsAreNamedAndNothingIsEmptied)
{
    FaceSets faces(1, 4);
    EXPECT_EQ(polygonize(faces), 0);
    const auto before = faces.contents();
    const Matrix goodModel = model;
    voBrickSet* const bricks = volume->getCurrentBrickSet();

    for (const GLdouble value : {std::nan(""), HUGE_VAL, 0.0}) {
        std::fill_n(model.m, 16, value);
        EXPECT_NE(polygonize(faces), 0);
        expectBadValue("singular");
    }
    model = goodModel;
    for (const float value : {0.0f, -1.0f, kNaN, HUGE_VALF}) {
        period[1] = value;
        EXPECT_NE(polygonize(faces), 0);
        expectBadValue("samplingPeriod[1]");
    }
    period[1] = 1;
    for (const int mode : {-2, 4, INT_MAX}) {
        EXPECT_NE(polygonize(faces, static_cast<voSamplingMode>(mode)), 0);
        expectBadEnum("voSamplingMode");
        EXPECT_NE(polygonize(faces, Mode::DEFAULT, static_cast<voSamplingSpace>(mode)), 0);
        expectBadEnum("voSamplingSpace");
    }
    const auto call = [&](voIndexedTetraSet* t, voBrickSet* b, GLdouble* m, GLdouble* p, int most,
                          voIndexedFaceSet*** f) {
        return voGeometryActions::polygonize(t, b, Format::V3F, m, p, Mode::DEFAULT, Space::DEFAULT, period,
                                             most, samples, f);
    };
    EXPECT_NE(call(NULL, bricks, model, projection, 4, faces), 0);
    expectBadValue("tetraSet is NULL");
    EXPECT_NE(call(&tetras, NULL, model, projection, 4, faces), 0);
    expectBadValue("brickSet is NULL");
    EXPECT_NE(call(&tetras, bricks, NULL, projection, 4, faces), 0);
    expectBadValue("matrix");
    EXPECT_NE(call(&tetras, bricks, model, NULL, 4, faces), 0);
    expectBadValue("matrix");
    EXPECT_NE(call(&tetras, bricks, model, projection, 4, NULL), 0);
    expectBadValue("polygonSet is NULL");
    for (const int most : {0, -1, INT_MIN}) {
        EXPECT_NE(call(&tetras, bricks, model, projection, most, faces), 0);
        expectBadValue("samples");
    }
    voIndexedFaceSet** noRows[] = {NULL};
    EXPECT_NE(call(&tetras, bricks, model, projection, 4, noRows), 0);
    expectBadValue("polygonSet[0] is NULL");
    voIndexedFaceSet* noSets[] = {NULL};
    noRows[0] = noSets;
    EXPECT_NE(call(&tetras, bricks, model, projection, 1, noRows), 0);
    expectBadValue("polygonSet[0][0] is NULL");
    EXPECT_EQ(faces.contents(), before);
}

TEST_F(PolygonizeTest, tetrahedraThatPointOutsideAreBadValue)
{
    FaceSets faces(1, 4);
    for (const int bad : {8, -1, INT_MAX, INT_MIN}) {
        cube.indices[7] = bad;
        EXPECT_NE(polygonize(faces), 0);
        expectBadValue("vertex");
    }
    cube.indices[7] = 7;
    tetras.getIndices()->setCount(19);
    EXPECT_NE(polygonize(faces), 0);
    expectBadValue("multiple of 4");
    tetras.getIndices()->setCount(20);
    voIndexedTetraSet noPosition(2, 2, 0);
    EXPECT_NE(voGeometryActions::polygonize(&noPosition, volume->getCurrentBrickSet(), Format::V3F, model,
                                            projection, Mode::DEFAULT, Space::DEFAULT, period, 4, samples,
                                            faces),
              0);
    expectBadValue("position");
}

TEST_F(PolygonizeTest, faceSetsOfOtherRecordsAreBadValue)
{
    FaceSets faces(1, 4, 6);
    EXPECT_NE(polygonize(faces), 0);
    expectBadValue("6 values a record");
}

TEST_F(PolygonizeTest, verticesThatAreNoNumbersDoNoHarm)
{
    FaceSets faces(1, 40);
    for (const float value : {kNaN, HUGE_VALF, -HUGE_VALF, std::numeric_limits<float>::max()}) {
        cube.vertices[5][1] = value;
        polygonize(faces);
        EXPECT_GE(samples, 0);
        EXPECT_LE(samples, 40);
    }
}

TEST_F(PolygonizeTest, tinyPeriodIsClampedToMaxSamples)
{
    FaceSets faces(1, 7);
    period[0] = period[1] = period[2] = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(polygonize(faces), 0);
    EXPECT_EQ(samples, 7);
    EXPECT_EQ(polygonize(faces, Mode::AXIS_ALIGNED), 0);
    EXPECT_EQ(samples, 7);
    EXPECT_EQ(polygonize(faces, Mode::DEFAULT, Space::VIEW_VOLUME), 0);
    EXPECT_EQ(samples, 7);
}

TEST_F(PolygonizeTest, tetrahedraMayShareTheFaceSetsVertices)
{
    voVertexData vertices(1000, 3);
    std::copy_n(&cube.vertices[0][0], 24, vertices.getDataPtr());
    vertices.setCount(8);
    voIndices indices(20, cube.indices);
    voIndexedTetraSet set(&vertices, &indices);
    voIndexedFaceSet faces(&vertices, 0);
    voIndexedFaceSet* row[] = {&faces};
    voIndexedFaceSet** sets[] = {row};
    voGeometryActions::polygonize(&set, volume->getCurrentBrickSet(), Format::V3F, model, projection,
                                  Mode::DEFAULT, Space::DEFAULT, period, 1, samples, sets);
    EXPECT_LE(vertices.getCount(), 1000);
}

// voSamplingSurfaceSet and voSamplingPlaneSet.

struct SurfacesTest : PolygonizeBricksTest
{
    int polygonize(FaceSets& faces, voSamplingSurfaceSet& surfaces,
                   voInterleavedArrayType format = Format::V3F)
    {
        return voGeometryActions::polygonize(&tetras, volume->getCurrentBrickSet(), format, &surfaces,
                                             faces.samples(), samples, faces);
    }

    static double areaOfSample(FaceSets& faces, int sample)
    {
        double sum = 0;
        for (int b = 0; b < faces.bricks(); ++b)
            sum += areaOf(faces.at(b, sample));
        return sum;
    }
};

TEST_F(SurfacesTest, planeSetHoldsThePlanesThatPolygonizeUses)
{
    for (const bool perspective : {false, true})
        for (const auto& [mode, space] :
             {std::pair(Mode::VIEWPORT_ALIGNED, Space::OBJECT), std::pair(Mode::AXIS_ALIGNED, Space::OBJECT),
              std::pair(Mode::DEFAULT, Space::VIEW_VOLUME)}) {
            model = translation(0, 0, perspective ? -40 : 0) * diagonalView() * translation(-8, -8, -8);
            projection = perspective ? frustum(1, 1, 100) : ortho(16, -32, 32);
            FaceSets wanted(8, 128), faces(8, 128);
            EXPECT_EQ(PolygonizeTest::polygonize(wanted, mode, space), 0);
            const int count = samples;
            voSamplingPlaneSet planes(&tetras, volume->getCurrentBrickSet(), model, projection, mode, space,
                                      period, 128);
            EXPECT_EQ(planes.getSurfaceCount(), count);
            EXPECT_EQ(polygonize(faces, planes), 0);
            EXPECT_EQ(samples, count);
            EXPECT_GT(count, 15);
            EXPECT_EQ(faces.contents(), wanted.contents());
        }
    expectNoError();
}

TEST_F(SurfacesTest, planesCanBeSampledAndClippedOneByOne)
{
    model = diagonalView() * translation(-8, -8, -8);
    FaceSets wanted(8, 64);
    EXPECT_EQ(PolygonizeTest::polygonize(wanted), 0);
    voSamplingPlaneSet planes(&tetras, volume->getCurrentBrickSet(), model, projection, Mode::DEFAULT,
                              Space::DEFAULT, period, 64);
    voSamplingPlaneSetIterator next(&planes);
    int sample = 0;
    for (float* plane; (plane = next()); ++sample) {
        voIndexedFaceSet cut(0, 3, 0);
        for (int t = 0; t < 20; t += 4) {
            float corners[4][3];
            for (int i = 0; i < 4; ++i)
                std::copy_n(cube.vertices[cube.indices[t + i]], 3, corners[i]);
            voVertexData polygon(4, 3);
            EXPECT_EQ(voGeometryActions::sample(corners, plane, &polygon), 0);
            voBrickSetIterator bricks(volume->getCurrentBrickSet());
            for (voBrick* brick; polygon.getCount() && (brick = bricks());) {
                float lower[3], upper[3];
                brick->getClipBrickSizes(lower, upper);
                EXPECT_EQ(voGeometryActions::clip(&polygon, lower, upper, &cut), 0);
            }
        }
        EXPECT_NEAR(areaOf(cut), areaOfSample(wanted, sample), 1e-3);
        // Towards the viewer, who is at (1, 1, 1) times a lot.
        EXPECT_NEAR(plane[0] + plane[1] + plane[2], std::sqrt(3.0), 1e-5);
    }
    EXPECT_EQ(sample, samples);
    EXPECT_EQ(next(), static_cast<float*>(NULL));
    expectNoError();
}

TEST_F(SurfacesTest, planesGoOnTowardsTheViewer)
{
    float first[4] = {0, 0, 2, -5};
    voSamplingPlaneSet planes(first, 4, 3);
    ASSERT_EQ(planes.getSurfaceCount(), 3);
    FaceSets faces(8, 3);
    EXPECT_EQ(polygonize(faces, planes), 0);
    EXPECT_EQ(samples, 3);
    for (int k = 0; k < 3; ++k) {
        float plane[4];
        EXPECT_EQ(planes.getPlane(k, plane), 0);
        EXPECT_EQ(plane[2], 1.0f);
        EXPECT_NEAR(plane[3], -(2.5 + 4 * k), 1e-6);
        EXPECT_NEAR(areaOfSample(faces, k), 256, 1e-3);
        for (const auto& polygon : polygonsOf(faces.at(k == 0 ? 0 : 4, k)))
            for (const auto& p : polygon)
                EXPECT_EQ(p[2], float(2.5 + 4 * k));
    }
    voIndexedFaceSet facets(0, 3, 0);
    float lower[3] = {0, 0, 0}, upper[3] = {2, 3, 4};
    planes.getSurface(0, lower, upper, &facets);
    EXPECT_NEAR(areaOf(facets), 6, 1e-5);
    planes.getSurface(1, lower, upper, &facets);
    EXPECT_NEAR(areaOf(facets), 6, 1e-5);
    expectNoError();
}

/// Roofs over the cube, the ridge along y at x = 8, `slope` down to both sides, of two facets; then a plane
/// as it is.
struct Roofs : voSamplingSurfaceSet
{
    virtual int getSurfaceCount() const { return count; }
    virtual void getSurface(int surface, float lower[3], float upper[3], voIndexedFaceSet* facets)
    {
        asked.push_back(surface);
        box = {lower[0], lower[1], lower[2], upper[0], upper[1], upper[2]};
        const float ridge = float(4 + 3 * surface), eaves = ridge - 10 * slope;
        float left[] = {-2, -1, eaves, 8, -1, ridge, 8, 17, ridge, -2, 17, eaves};
        float right[] = {8, -1, ridge, 18, -1, eaves, 18, 17, eaves, 8, 17, ridge};
        facets->appendPoly(left, 4);
        facets->appendPoly(right, 4);
        if (!broken) return;
        float none[] = {0, 0, 0, kNaN, 0, 0, 1, 1, 1}, flat[] = {0, 0, 0, 1, 1, 1, 2, 2, 2};
        facets->appendPoly(none, 3);
        facets->appendPoly(flat, 3);
    }
    int count = 3;
    float slope = 0.25f;
    bool broken = false;
    std::vector<int> asked;
    std::array<float, 6> box{};
};

TEST_F(SurfacesTest, ownSurfacesAreCutToTetrahedraAndBricks)
{
    Roofs roofs;
    for (const bool broken : {false, true}) {
        roofs.broken = broken;
        roofs.asked.clear();
        FaceSets faces(8, 4);
        EXPECT_EQ(polygonize(faces, roofs), 0);
        EXPECT_EQ(samples, 3);
        EXPECT_EQ(roofs.asked, (std::vector<int>{0, 1, 2}));
        EXPECT_EQ(roofs.box, (std::array<float, 6>{0, 0, 0, 16, 16, 16}));
        for (int k = 0; k < 3; ++k) {
            EXPECT_NEAR(areaOfSample(faces, k), 256 * std::hypot(1.0, 0.25), 1e-3);
            for (int b = 0; b < 8; ++b)
                for (const auto& polygon : polygonsOf(faces.at(b, k)))
                    for (const auto& p : polygon)
                        EXPECT_NEAR(p[2], 4 + 3 * k - 0.25 * std::abs(p[0] - 8), 1e-5);
        }
        EXPECT_EQ(areaOfSample(faces, 3), 0.0);
    }
    expectNoError();
}

TEST_F(SurfacesTest, flatSurfacesInSharedFacesAreYieldedOnce)
{
    // The facets lie in z = 8, a seam of the bricks; then in faces that tetrahedra share.
    Roofs flat;
    flat.slope = 0;
    flat.count = 4;
    FaceSets faces(8, 4);
    EXPECT_EQ(polygonize(faces, flat), 0);
    for (int k = 0; k < 4; ++k)
        EXPECT_NEAR(areaOfSample(faces, k), 256, 1e-3);
    struct Diagonal : Roofs
    {
        virtual void getSurface(int, float*, float*, voIndexedFaceSet* facets)
        {
            // The plane through corners 0, 2, 5 of the cube, which two of its tetrahedra share as a face.
            float plane[] = {0, 0, 0, 16, 16, 0, 16, 0, 16};
            facets->appendPoly(plane, 3);
        }
    } diagonal;
    diagonal.count = 1;
    EXPECT_EQ(polygonize(faces, diagonal), 0);
    EXPECT_NEAR(areaOfSample(faces, 0), 256 * std::sqrt(3.0) / 2, 1e-3);
    expectNoError();
}

TEST_F(SurfacesTest, valuesOfRecordsAreInterpolatedOnOwnSurfaces)
{
    std::vector<float> records;
    for (const auto& p : cube.vertices)
        records.insert(records.end(), {2 * p[0] - p[1] + 3 * p[2], p[0], p[1], p[2]});
    voIndexedTetraSet set(records.data(), 8, 4, cube.indices, 20);
    FaceSets faces(8, 3, 4);
    Roofs roofs;
    EXPECT_EQ(voGeometryActions::polygonize(&set, volume->getCurrentBrickSet(), Format::USER_V3F, &roofs, 3,
                                            samples, faces),
              0);
    EXPECT_GT(faces.vertices().getCount(), 100);
    for (int i = 0; i < faces.vertices().getCount(); ++i) {
        const float* r = faces.vertices()[i];
        EXPECT_NEAR(r[0], 2 * r[1] - r[2] + 3 * r[3], 1e-4f);
    }
}

TEST_F(SurfacesTest, badSurfacesAreNamed)
{
    FaceSets faces(8, 2);
    Roofs roofs;
    EXPECT_NE(polygonize(faces, roofs), 0);
    expectBadValue("3 surfaces, there is room for 2");
    EXPECT_EQ(samples, 0);
    roofs.count = -1;
    EXPECT_NE(polygonize(faces, roofs), 0);
    expectBadValue("-1 surfaces");
    voBrickSet* set = volume->getCurrentBrickSet();
    EXPECT_NE(voGeometryActions::polygonize(&tetras, set, Format::V3F, NULL, 2, samples, faces), 0);
    expectBadValue("surfaces is NULL");
    roofs.count = 2;
    EXPECT_NE(voGeometryActions::polygonize(NULL, set, Format::V3F, &roofs, 2, samples, faces), 0);
    expectBadValue("tetraSet is NULL");
    EXPECT_NE(voGeometryActions::polygonize(&tetras, set, Format::V3F, &roofs, 2, samples, NULL), 0);
    expectBadValue("polygonSet is NULL");
    FaceSets small(8, 2, 3, 9);
    EXPECT_NE(polygonize(small, roofs), 0);
    expectError(voErrorTypeScope::OUT_OF_MEMORY, "full");

    float plane[4] = {0, 0, 0, 1}, good[4] = {1, 0, 0, 0};
    EXPECT_EQ(voSamplingPlaneSet(plane, 1, 2).getSurfaceCount(), 0);
    expectBadValue("planeEquation");
    EXPECT_EQ(voSamplingPlaneSet(NULL, 1, 2).getSurfaceCount(), 0);
    expectBadValue("planeEquation is NULL");
    for (const float spacing : {0.0f, -1.0f, kNaN, HUGE_VALF}) {
        EXPECT_EQ(voSamplingPlaneSet(good, spacing, 2).getSurfaceCount(), 0);
        expectBadValue("spacing");
    }
    EXPECT_EQ(voSamplingPlaneSet(good, 1, -2).getSurfaceCount(), 0);
    expectBadValue("-2 planes");
    const voSamplingPlaneSet planes(good, 1, 2);
    for (const int outside : {-1, 2, INT_MAX}) {
        EXPECT_NE(planes.getPlane(outside, plane), 0);
        expectBadValue("outside 0 to 1");
    }
    EXPECT_NE(planes.getPlane(0, NULL), 0);
    expectBadValue("NULL");
    projection = frustum(1, 1, 100);
    EXPECT_EQ(voSamplingPlaneSet(&tetras, set, model, projection, Mode::SPHERICAL, Space::OBJECT, period, 9)
                  .getSurfaceCount(),
              0);
    expectBadValue("SPHERICAL");
    EXPECT_EQ(voSamplingPlaneSet(&tetras, set, model, projection, Mode::DEFAULT, Space::PRIMITIVE, period, 9)
                  .getSurfaceCount(),
              0);
    expectBadValue("PRIMITIVE");
    EXPECT_FALSE(std::is_copy_constructible_v<voSamplingPlaneSet>);
    EXPECT_TRUE(std::is_abstract_v<voSamplingSurfaceSet>);
}

// polygonizeMPR.

struct ReformatTest : testing::Test
{
    explicit ReformatTest(voInterpolationType type = voInterpolationTypeScope::_3D)
        : volume(byteVolume(16, 8, type, 0)), set(volume->getCurrentBrickSet())
    {
    }

    /// Area of all parts in voxels, each times the mean of its corners' last colour channel.
    static double weightedArea(FaceSets& faces, int weight)
    {
        double sum = 0;
        for (int b = 0; b < faces.bricks(); ++b)
            for (voIndexedFaceSetIterator next(&faces.at(b, 0)); !next.doneP(); next.nextPrimitive()) {
                std::vector<std::array<float, 3>> corners;
                double weights = 0;
                while (const float* record = next.nextVertex()) {
                    const int values = faces.vertices().getValuesPerVertex();
                    corners.push_back({record[values - 3], record[values - 2], record[values - 1]});
                    weights += weight < 0 ? 1.0 : double(record[weight]);
                }
                sum += areaOf(corners) * weights / double(corners.size());
            }
        return sum;
    }

    std::unique_ptr<voBrickSetCollection> volume;
    voBrickSet* set;
    float across[4] = {1, 1, 0, -16}; ///< from edge to edge of the cube
};

struct ReformatStackTest : ReformatTest
{
    ReformatStackTest() : ReformatTest(voInterpolationTypeScope::_2D) {}
};

TEST_F(ReformatTest, planeIsCutToBricksInEveryFormat)
{
    for (const voInterleavedArrayType format :
         {Format::DEFAULT, Format::V3F, Format::T3F_V3F, Format::C3F_V3F, Format::C4F_V3F,
          Format::T3F_C3F_V3F, Format::T3F_C4F_V3F}) {
        FaceSets faces(set->getBrickCount(), 1, format < 0 ? 3 : getValuesPerVertex(format));
        EXPECT_EQ(voGeometryActions::polygonizeMPR(across, set, faces, format), 0);
        EXPECT_NEAR(weightedArea(faces, -1), 16 * 16 * std::sqrt(2.0), 1e-3);
        const int values = faces.vertices().getValuesPerVertex();
        for (int i = 0; i < faces.vertices().getCount(); ++i) {
            const float* record = faces.vertices()[i];
            EXPECT_NEAR(record[values - 3] + record[values - 2], 16, 1e-5f);
            for (int axis = 0; hasTextureComponent(format) && axis < 3; ++axis)
                EXPECT_EQ(record[axis], record[values - 3 + axis]);
            for (int c = hasTextureComponent(format) ? 3 : 0; c < values - 3; ++c)
                EXPECT_EQ(record[c], 1.0f);
        }
    }
    expectNoError();
}

TEST_F(ReformatTest, faceSetsAreEmptiedFirst)
{
    FaceSets faces(set->getBrickCount(), 1);
    voGeometryActions::polygonizeMPR(across, set, faces, Format::V3F);
    const auto once = faces.contents();
    voGeometryActions::polygonizeMPR(across, set, faces, Format::V3F);
    EXPECT_EQ(faces.contents(), once);
    float outside[4] = {1, 0, 0, 1};
    EXPECT_EQ(voGeometryActions::polygonizeMPR(outside, set, faces, Format::V3F), 0);
    EXPECT_EQ(faces.vertices().getCount(), 0);
    expectNoError();
}

TEST_F(ReformatTest, polygonIsCutWithItsValues)
{
    // An L of 3 x 64 square voxels in the plane z = 8, which is a seam of the bricks.
    const float corners[6][2] = {{0, 0}, {16, 0}, {16, 8}, {8, 8}, {8, 16}, {0, 16}};
    voVertexData polygon(6, 4);
    for (int i = 0; i < 6; ++i) {
        const float record[] = {corners[i][0] + 2 * corners[i][1], corners[i][0], corners[i][1], 8};
        std::copy_n(record, 4, polygon[i]);
    }
    polygon.setCount(6);
    FaceSets faces(set->getBrickCount(), 1, 4);
    EXPECT_EQ(voGeometryActions::polygonizeMPR(&polygon, set, faces, Format::USER_V3F), 0);
    EXPECT_NEAR(weightedArea(faces, -1), 3 * 64, 1e-4);
    for (int i = 0; i < faces.vertices().getCount(); ++i)
        EXPECT_NEAR(faces.vertices()[i][0], faces.vertices()[i][1] + 2 * faces.vertices()[i][2], 1e-4f);
    expectNoError();
}

TEST_F(ReformatStackTest, weightsMakeEveryPartCountOnce)
{
    for (const voPlaneOrientation stack :
         {voPlaneOrientationScope::XY, voPlaneOrientationScope::XZ, voPlaneOrientationScope::YZ}) {
        volume->setCurrentBrickSet(stack);
        set = volume->getCurrentBrickSet();
        for (const voInterleavedArrayType format : {Format::C4F_V3F, Format::C3F_V3F, Format::T3F_C4F_V3F}) {
            FaceSets faces(set->getBrickCount(), 1, getValuesPerVertex(format));
            float straight[4] = {1, 0, 0, -5.25f};
            EXPECT_EQ(voGeometryActions::polygonizeMPR(straight, set, faces, format), 0);
            // Quadrilaterals whose weight is linear from one side to the other.
            EXPECT_NEAR(weightedArea(faces, hasTextureComponent(format) ? 3 : 0), 16 * 16, 1e-3);
            EXPECT_EQ(voGeometryActions::polygonizeMPR(across, set, faces, format), 0);
            EXPECT_NEAR(weightedArea(faces, faces.vertices().getValuesPerVertex() - 4),
                        16 * 16 * std::sqrt(2.0), 1e-3);
        }
    }
    expectNoError();
}

TEST_F(ReformatStackTest, formatWithoutColorsIsBadValue)
{
    for (const voInterleavedArrayType format : {Format::DEFAULT, Format::V3F, Format::T3F_V3F}) {
        FaceSets faces(set->getBrickCount(), 1, format == Format::T3F_V3F ? 6 : 3);
        EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, faces, format), 0);
        expectBadValue("colours");
    }
}

TEST_F(ReformatTest, badArgumentsAreNamedAndNothingIsEmptied)
{
    FaceSets faces(set->getBrickCount(), 1);
    voGeometryActions::polygonizeMPR(across, set, faces, Format::V3F);
    const auto before = faces.contents();
    float* noPlane = NULL;
    EXPECT_NE(voGeometryActions::polygonizeMPR(noPlane, set, faces, Format::V3F), 0);
    expectBadValue("planeEquation is NULL");
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, NULL, faces, Format::V3F), 0);
    expectBadValue("brickSet is NULL");
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, NULL, Format::V3F), 0);
    expectBadValue("polygonSet is NULL");
    for (const float bad : {0.0f, kNaN, HUGE_VALF}) {
        float plane[4] = {bad, 0, 0, 1};
        EXPECT_NE(voGeometryActions::polygonizeMPR(plane, set, faces, Format::V3F), 0);
        expectBadValue("planeEquation");
    }
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, faces, Format::USER_V3F), 0);
    expectBadValue("USER_V3F");
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, faces, Format::C4F_V3F), 0);
    expectBadValue("values a record");
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, faces, static_cast<voInterleavedArrayType>(7)),
              0);
    expectBadEnum("voInterleavedArrayType");
    voVertexData* noPolygon = NULL;
    EXPECT_NE(voGeometryActions::polygonizeMPR(noPolygon, set, faces, Format::V3F), 0);
    expectBadValue("polygon is NULL");
    voVertexData polygon(4, 6), crossing(5, 3);
    EXPECT_NE(voGeometryActions::polygonizeMPR(&polygon, set, faces, Format::V3F), 0);
    expectBadValue("values a record");
    for (int i = 0; i < 5; ++i) {
        crossing[i][0] = 8 + 4 * float(std::cos(i * 0.8 * M_PI));
        crossing[i][1] = 8 + 4 * float(std::sin(i * 0.8 * M_PI));
    }
    crossing.setCount(5);
    EXPECT_NE(voGeometryActions::polygonizeMPR(&crossing, set, faces, Format::V3F), 0);
    expectBadValue("cross");
    EXPECT_EQ(faces.contents(), before);
    FaceSets small(set->getBrickCount(), 1, 3, 9);
    EXPECT_NE(voGeometryActions::polygonizeMPR(across, set, small, Format::V3F), 0);
    expectError(voErrorTypeScope::OUT_OF_MEMORY, "full");
    EXPECT_LE(small.vertices().getCount(), 9);
}

// sample and clip.

float kUnitTetra[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 4}};

TEST(SampleTest, givesNoneThreeOrFourVerticesInOrder)
{
    voVertexData polygon(4, 3);
    float away[4] = {0, 0, 1, -5};
    EXPECT_EQ(voGeometryActions::sample(kUnitTetra, away, &polygon), 0);
    EXPECT_EQ(polygon.getCount(), 0);
    float triangle[4] = {0, 0, 1, -2};
    EXPECT_EQ(voGeometryActions::sample(kUnitTetra, triangle, &polygon), 0);
    EXPECT_EQ(polygon.getCount(), 3);
    float square[4] = {1, 1, 0, -2}; // cuts four edges
    EXPECT_EQ(voGeometryActions::sample(kUnitTetra, square, &polygon), 0);
    ASSERT_EQ(polygon.getCount(), 4);
    // Convex order: the diagonals of the quadrilateral cross in its middle.
    std::vector<std::array<float, 3>> corners;
    for (int i = 0; i < 4; ++i)
        corners.push_back({polygon[i][0], polygon[i][1], polygon[i][2]});
    EXPECT_NEAR(areaOf(corners), 2.0 * 2.0 * std::sqrt(2.0), 1e-5);
    for (const auto& corner : corners)
        EXPECT_NEAR(corner[0] + corner[1], 2.0f, 1e-6f);
    expectNoError();
}

TEST(SampleTest, isAlsoAFreeFunctionAndAnAppearanceAction)
{
    voVertexData polygon(4, 3);
    float plane[4] = {0, 0, 1, -2};
    EXPECT_EQ(::sample(kUnitTetra, plane, &polygon), 0);
    EXPECT_EQ(polygon.getCount(), 3);
    EXPECT_EQ(voAppearanceActions::sample(kUnitTetra, plane, &polygon), 0);
    EXPECT_EQ(polygon.getCount(), 3);
}

TEST(SampleTest, writesThePositionOfLongerRecords)
{
    voVertexData polygon(4, 6);
    std::fill_n(polygon.getDataPtr(), 24, -7.0f);
    float plane[4] = {0, 0, 1, -2};
    EXPECT_EQ(voGeometryActions::sample(kUnitTetra, plane, &polygon), 0);
    EXPECT_EQ(polygon[0][0], -7.0f);
    EXPECT_EQ(polygon[0][5], 2.0f);
}

TEST(SampleTest, badArgumentsAreBadValue)
{
    voVertexData polygon(4, 3), small(3, 3), flat(4, 2);
    float plane[4] = {0, 0, 1, -2};
    EXPECT_NE(voGeometryActions::sample(NULL, plane, &polygon), 0);
    expectBadValue("NULL");
    EXPECT_NE(voGeometryActions::sample(kUnitTetra, NULL, &polygon), 0);
    expectBadValue("NULL");
    EXPECT_NE(voGeometryActions::sample(kUnitTetra, plane, NULL), 0);
    expectBadValue("NULL");
    for (voVertexData* bad : {&small, &flat}) {
        EXPECT_NE(voGeometryActions::sample(kUnitTetra, plane, bad), 0);
        expectBadValue("room for 4 records");
    }
    float strange[4][3] = {{kNaN, 0, 0}, {HUGE_VALF, 0, 0}, {0, -HUGE_VALF, 0}, {0, 0, kNaN}};
    voGeometryActions::sample(strange, plane, &polygon);
    EXPECT_LE(polygon.getCount(), 4);
}

TEST(SampleTest, degenerateInputGivesNoneOrThree)
{
    voVertexData polygon(4, 3);
    const auto count = [&](float tetra[4][3], std::array<float, 4> plane) {
        EXPECT_EQ(voGeometryActions::sample(tetra, plane.data(), &polygon), 0);
        return polygon.getCount();
    };
    EXPECT_EQ(count(kUnitTetra, {0, 0, -1, 0}), 3)
        << "a face, with nothing behind the plane but its own vertices";
    EXPECT_EQ(count(kUnitTetra, {0, 0, 1, 0}), 0) << "everything in front";
    EXPECT_EQ(count(kUnitTetra, {0, 0, 1, -4}), 0) << "a vertex";
    EXPECT_EQ(count(kUnitTetra, {-1, -1, 0, 0}), 0) << "an edge";
    EXPECT_EQ(count(kUnitTetra, {1, -1, 0, 0}), 3) << "through an edge";
    EXPECT_EQ(count(kUnitTetra, {0, 0, 0, 0}), 0);
    EXPECT_EQ(count(kUnitTetra, {0, 0, 0, -1}), 0);
    EXPECT_EQ(count(kUnitTetra, {kNaN, 0, 0, 0}), 0);
    float flat[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 0}};
    EXPECT_EQ(count(flat, {0, 0, 1, -1}), 0);
    float point[4][3] = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    EXPECT_EQ(count(point, {1, 0, 0, -1}), 0);
    expectNoError();
}

/// A square of records (x / 10, y / 10, 0, x, y, 0) over [0, 10]^2.
struct ClipTest : testing::Test
{
    ClipTest() : polygon(4, 6), faces(0, 6, 0)
    {
        const float corners[4][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
        for (int i = 0; i < 4; ++i) {
            const float record[] = {corners[i][0] / 10, corners[i][1] / 10, 0,
                                    corners[i][0],      corners[i][1],      0};
            std::copy_n(record, 6, polygon[i]);
        }
        polygon.setCount(4);
    }
    void expectInterpolated()
    {
        for (int i = 0; i < faces.getVertexData()->getCount(); ++i) {
            const float* r = (*faces.getVertexData())[i];
            EXPECT_NEAR(r[0], r[3] / 10, 1e-6f);
            EXPECT_NEAR(r[1], r[4] / 10, 1e-6f);
        }
    }
    voVertexData polygon;
    voIndexedFaceSet faces;
    float lower[3] = {2, 3, -1};
    float upper[3] = {5, 20, 1};
};

TEST_F(ClipTest, boxCutsAndInterpolatesAndAppends)
{
    EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, lower, upper, &faces), 0);
    EXPECT_NEAR(areaOf(faces), 3 * 7, 1e-5);
    expectInterpolated();
    EXPECT_EQ(voGeometryActions::clip(&polygon, lower, upper, &faces), 0);
    EXPECT_EQ(polygonsOf(faces).size(), 2u);
    EXPECT_EQ(::clip(&polygon, lower, upper, &faces), 0);
    EXPECT_EQ(voAppearanceActions::clip(&polygon, Format::C3F_V3F, lower, upper, &faces), 0);
    EXPECT_EQ(polygonsOf(faces).size(), 4u);
    EXPECT_NEAR(areaOf(faces), 4 * 3 * 7, 1e-4);
    expectNoError();
}

TEST_F(ClipTest, boxKeepsItsFacesAndDropsWhatIsOutside)
{
    float far[3] = {11, 11, 1}, farther[3] = {12, 12, 2};
    EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, far, farther, &faces), 0);
    EXPECT_EQ(polygonsOf(faces).size(), 0u);
    float onFace[3] = {0, 0, 0}, box[3] = {10, 10, 5};
    EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, onFace, box, &faces), 0);
    EXPECT_NEAR(areaOf(faces), 100, 1e-5);
}

TEST_F(ClipTest, halfSpacesKeepTheirPositiveSide)
{
    float planes[2][4] = {{1, 0, 0, -4}, {0, -1, 0, 5}};
    EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, &planes[0][0], 2, &faces), 0);
    EXPECT_NEAR(areaOf(faces), 6 * 5, 1e-5);
    const auto left = polygonsOf(faces);
    ASSERT_EQ(left.size(), 1u);
    for (const auto& corner : left[0]) {
        EXPECT_GE(corner[0], 4);
        EXPECT_LE(corner[1], 5);
    }
    expectInterpolated();
    EXPECT_EQ(voAppearanceActions::clip(&polygon, Format::C3F_V3F, &planes[0][0], 2, &faces), 0);
    EXPECT_EQ(polygonsOf(faces).size(), 2u);
    EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, static_cast<float*>(NULL), 0, &faces), 0);
    EXPECT_NEAR(areaOf(faces), 2 * 30 + 100, 1e-4);
}

TEST_F(ClipTest, polygonsOfManyVerticesAreCutToo)
{
    constexpr int kVertices = 5000;
    voVertexData round(kVertices, 3);
    for (int i = 0; i < kVertices; ++i) {
        round[i][0] = static_cast<float>(std::cos(2 * M_PI * i / kVertices));
        round[i][1] = static_cast<float>(std::sin(2 * M_PI * i / kVertices));
        round[i][2] = 0;
    }
    round.setCount(kVertices);
    voIndexedFaceSet disks(0, 3, 0);
    float corner[3] = {0, 0, 0}, box[3] = {1, 1, 1};
    EXPECT_EQ(voGeometryActions::clip(&round, corner, box, &disks), 0);
    EXPECT_NEAR(areaOf(disks), M_PI / 4, 1e-4);
}

TEST_F(ClipTest, degenerateInputGivesNothingOrItself)
{
    const auto left = [&](std::array<float, 4> plane) {
        faces.empty();
        EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, plane.data(), 1, &faces), 0);
        return areaOf(faces);
    };
    EXPECT_NEAR(left({0, 0, 0, 1}), 100, 1e-5);
    EXPECT_NEAR(left({0, 0, 0, 0}), 100, 1e-5);
    EXPECT_EQ(left({0, 0, 0, -1}), 0);
    EXPECT_NEAR(left({0, 0, 1, 0}), 100, 1e-5) << "in the plane";
    EXPECT_EQ(left({1, 0, 0, -10}), 0) << "an edge alone";
    EXPECT_EQ(left({1, 1, 0, -20}), 0) << "a corner alone";
    EXPECT_EQ(left({kNaN, 0, 0, 0}), 0);

    const auto inside = [&](std::array<float, 3> low, std::array<float, 3> high) {
        faces.empty();
        EXPECT_EQ(voGeometryActions::clip(&polygon, Format::C3F_V3F, low.data(), high.data(), &faces), 0);
        return areaOf(faces);
    };
    EXPECT_NEAR(inside({1, 1, 0}, {3, 3, 0}), 4, 1e-5) << "a box without thickness";
    EXPECT_EQ(inside({10, 0, -1}, {12, 10, 1}), 0) << "an edge alone";
    EXPECT_EQ(inside({4, 0, -1}, {4, 10, 1}), 0) << "a line";
    std::copy_n(polygon[0], 6, polygon[1]);
    EXPECT_NEAR(inside({0, 0, -1}, {10, 10, 1}), 50, 1e-5) << "a vertex twice";
    polygon.setCount(2);
    EXPECT_EQ(inside({0, 0, -1}, {10, 10, 1}), 0);
    polygon.setCount(0);
    EXPECT_EQ(inside({0, 0, -1}, {10, 10, 1}), 0);
    expectNoError();
}

TEST_F(ClipTest, badArgumentsAreBadValueAndAppendNothing)
{
    float plane[4] = {1, 0, 0, 0};
    EXPECT_NE(voGeometryActions::clip(NULL, Format::C3F_V3F, lower, upper, &faces), 0);
    expectBadValue("polygon is NULL");
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::C3F_V3F, NULL, upper, &faces), 0);
    expectBadValue("NULL");
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::C3F_V3F, lower, upper, NULL), 0);
    expectBadValue("faceSet is NULL");
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::T3F_C4F_V3F, lower, upper, &faces), 0);
    expectBadValue("10 values");
    EXPECT_NE(voGeometryActions::clip(&polygon, static_cast<voInterleavedArrayType>(9), lower, upper, &faces),
              0);
    expectBadEnum();
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::C3F_V3F, plane, -1, &faces), 0);
    expectBadValue("planeCount");
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::C3F_V3F, static_cast<float*>(NULL), 1, &faces), 0);
    expectBadValue("planes is NULL");
    voIndexedFaceSet other(0, 3, 0);
    EXPECT_NE(voGeometryActions::clip(&polygon, Format::C3F_V3F, lower, upper, &other), 0);
    expectBadValue("values a record");
    EXPECT_EQ(faces.getIndices()->getCount(), 0);
    float noBox[3] = {kNaN, kNaN, kNaN};
    voGeometryActions::clip(&polygon, Format::C3F_V3F, noBox, noBox, &faces);
    voGeometryActions::clip(&polygon, Format::C3F_V3F, upper, lower, &faces);
    EXPECT_EQ(polygonsOf(faces).size(), 0u);
}

// Viewing.

TEST(ViewTest, closestAxisFollowsTheView)
{
    Matrix projection = ortho(10, -10, 10), straight;
    Matrix alongY = rotation(80, 1, 0, 0), alongX = rotation(-80, 0, 1, 0);
    using O = voPlaneOrientationScope;
    EXPECT_EQ(voGeometryActions::findClosestAxisIndex(straight, projection, Mode::AXIS_ALIGNED), O::XY);
    EXPECT_EQ(voGeometryActions::findClosestAxisIndex(alongY, projection, Mode::AXIS_ALIGNED), O::XZ);
    EXPECT_EQ(findClosestAxisIndex(alongX, projection, Mode::AXIS_ALIGNED), O::YZ);
    for (const int mode : {Mode::DEFAULT, Mode::VIEWPORT_ALIGNED, Mode::SPHERICAL})
        EXPECT_EQ(findClosestAxisIndex(alongX, projection, mode), O::UNSPECIFIED);
    expectNoError();
    EXPECT_EQ(findClosestAxisIndex(alongX, projection, 77), O::UNSPECIFIED);
    expectBadEnum();
    EXPECT_EQ(findClosestAxisIndex(NULL, projection, Mode::AXIS_ALIGNED), O::UNSPECIFIED);
    expectBadValue();
}

TEST(ViewTest, orthographicCameraHasADirectionAndNoEye)
{
    Matrix projection = ortho(10, -10, 10), model = rotation(90, 0, 1, 0);
    double eye[3] = {7, 7, 7}, direction[4] = {};
    voGeometryActions::findCameraPosition(eye, direction, model, projection);
    EXPECT_EQ(eye[0], 7);
    EXPECT_EQ(direction[3], 0);
    EXPECT_NEAR(direction[0], 1, 1e-12);
    double same[3];
    voGeometryActions::findViewDirection(same, model, projection);
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_EQ(same[axis], direction[axis]);
}

TEST(ViewTest, perspectiveCameraHasAnEye)
{
    Matrix projection = frustum(1, 1, 100), model = translation(-1, -2, -3);
    double eye[3], direction[4];
    voGeometryActions::findCameraPosition(eye, direction, model, projection);
    EXPECT_NE(direction[3], 0);
    EXPECT_NEAR(eye[0], 1, 1e-9);
    EXPECT_NEAR(eye[1], 2, 1e-9);
    EXPECT_NEAR(eye[2], 3, 1e-9);
    EXPECT_NEAR(direction[2], -1, 1e-12);
    voGeometryActions::findCameraPosition(NULL, direction, model, projection);
    voGeometryActions::findCameraPosition(eye, NULL, model, projection);
    expectNoError();
}

TEST(ViewTest, singularMatricesAreBadValue)
{
    Matrix zero, projection = ortho(10, -10, 10);
    std::fill_n(zero.m, 16, 0.0);
    double eye[3] = {7, 7, 7}, direction[4] = {5, 5, 5, 5};
    voGeometryActions::findCameraPosition(eye, direction, zero, projection);
    expectBadValue("singular");
    EXPECT_EQ(eye[0], 7);
    EXPECT_EQ(direction[0], 5);
    voGeometryActions::findViewDirection(direction, zero, projection);
    expectBadValue("singular");
    EXPECT_EQ(direction[0], 0);
    EXPECT_EQ(direction[2], 1);
    voGeometryActions::findViewDirection(NULL, projection, projection);
    expectBadValue("NULL");
    voGeometryActions::findViewDirection(direction, NULL, NULL);
    expectBadValue("NULL");
}

// Sorting.

TEST(SortActionTest, orderIsAPermutationBackToFront)
{
    const auto volume = byteVolume(16, 8, voInterpolationTypeScope::_3D, 0);
    Matrix projection = ortho(16, -32, 32);
    for (const double angle : {10.0, 100.0, 190.0, 280.0}) {
        Matrix model = rotation(angle, 1, 0.3, 0.2) * translation(-8, -8, -8);
        const voSortAction order(volume->getCurrentBrickSet(), model, projection);
        std::vector<int> turn(8, -1); // by brick
        for (int i = 0; i < 8; ++i) {
            ASSERT_EQ(turn.at(static_cast<std::size_t>(order[i])), -1);
            turn[static_cast<std::size_t>(order[i])] = i;
        }
        // Of two neighbours the one on the viewer's side is drawn later.
        for (std::size_t brick = 0; brick < 8; ++brick)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (brick >> axis & 1) continue;
                const double towardsViewer = model.m[4 * axis + 2]; // eye z of the axis
                const int later = turn[brick | 1u << axis] - turn[brick];
                EXPECT_GT(later * towardsViewer, 0) << "angle " << angle << " brick " << brick;
            }
    }
    EXPECT_TRUE((std::is_same_v<voGeometryActions::voSortAction, voSortAction>));
}

TEST(SortActionTest, eyeInsideTheVolumeDrawsItsBrickLast)
{
    const auto volume = byteVolume(30, 10, voInterpolationTypeScope::_3D, 0);
    Matrix projection = frustum(1, 0.1, 100), model = translation(-15, -15, -15);
    const voSortAction order(volume->getCurrentBrickSet(), model, projection);
    EXPECT_EQ(order[26], 13);
}

TEST(SortActionTest, badArgumentsAreBadValue)
{
    const auto volume = byteVolume(16, 8, voInterpolationTypeScope::_3D, 0);
    Matrix zero, projection = ortho(16, -32, 32);
    std::fill_n(zero.m, 16, std::nan(""));
    const voSortAction order(volume->getCurrentBrickSet(), zero, projection);
    expectBadValue("singular");
    EXPECT_EQ(order[7], 7); // still a permutation
    for (const int i : {-1, 8, INT_MAX, INT_MIN}) {
        EXPECT_EQ(order[i], 0);
        expectBadValue();
    }
    const voSortAction none(NULL, projection, projection);
    expectBadValue("brickSet is NULL");
    EXPECT_EQ(none[0], 0);
    expectBadValue();
}

// Drawing without a context, and what is not there yet.

struct DrawTest : PolygonizeTest
{
};

TEST_F(DrawTest, nothingIsDrawnWithoutAContext)
{
    voIndexedFaceSet faces(0, 3, 0);
    const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    faces.appendPoly(const_cast<float*>(corners), 3);
    voGeometryActions::draw(&faces, Format::V3F);
    expectUnsupported("no OpenGL context");
    voGeometryActions::draw(&faces, GL_LINE, Format::V3F);
    expectUnsupported("no OpenGL context");
    voGeometryActions::draw(&tetras, Format::V3F);
    expectUnsupported("no OpenGL context");
    voGeometryActions::draw(&tetras, GL_FILL, Format::V3F);
    expectUnsupported("no OpenGL context");
    voGeometryActions::draw(volume->getCurrentBrickSet()->getBrick(0));
    expectUnsupported("no OpenGL context");
    voGeometryActions::draw(volume->getCurrentBrickSet());
    expectUnsupported("no OpenGL context");
    EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::V3F, volume.get(), NULL, Space::OBJECT, period,
                                             voDecorationFlagsScope::ALL),
              0);
    expectUnsupported("no OpenGL context");
}

TEST_F(DrawTest, userRecordsAreForTheApplicationToDraw)
{
    voIndexedFaceSet faces(0, 3, 0);
    voGeometryActions::draw(&faces, Format::USER_V3F);
    expectUnsupported("USER_V3F");
    voGeometryActions::draw(&tetras, Format::USER_V3F);
    expectUnsupported("USER_V3F");
}

TEST_F(DrawTest, badArgumentsAreNamed)
{
    voIndexedFaceSet faces(0, 3, 0);
    voGeometryActions::draw(static_cast<voIndexedFaceSet*>(NULL), Format::V3F);
    expectBadValue("faceSet is NULL");
    voGeometryActions::draw(static_cast<voIndexedTetraSet*>(NULL), GL_LINE, Format::V3F);
    expectBadValue("tetraSet is NULL");
    voGeometryActions::draw(static_cast<voBrick*>(NULL));
    expectBadValue("brick is NULL");
    voGeometryActions::draw(static_cast<voBrickSet*>(NULL));
    expectBadValue("brickSet is NULL");
    voGeometryActions::draw(&faces, 0x1234, Format::V3F);
    expectBadEnum("mode");
    voGeometryActions::draw(&faces, Format::C4F_V3F);
    expectBadValue("7 values");
    voGeometryActions::draw(&faces, static_cast<voInterleavedArrayType>(50));
    expectBadEnum();
    EXPECT_NE(voGeometryActions::drawUtility(NULL, Format::V3F, volume.get(), NULL, Space::OBJECT, period,
                                             voDecorationFlagsScope::NONE),
              0);
    expectBadValue("tetraSet is NULL");
    EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::V3F, NULL, NULL, Space::OBJECT, period,
                                             voDecorationFlagsScope::NONE),
              0);
    expectBadValue("volume is NULL");
    EXPECT_NE(voGeometryActions::drawUtility(&tetras, Format::V3F, volume.get(), NULL, Space::OBJECT, period,
                                             static_cast<voDecorationFlags>(4)),
              0);
    expectBadEnum();
}

TEST_F(DrawTest, cacheKeepsItsSettingsInBounds)
{
    voDrawActionCache cache(&tetras, volume.get(), 512, Mode::VIEWPORT_ALIGNED, 3, 250000);
    cache.setThreshold(2);
    cache.setThreshold(0.5f);
    static_cast<voCache&>(cache).invalidate();
    expectNoError();
    for (const double degrees : {-1.0, std::nan("")}) {
        cache.setThreshold(degrees);
        expectBadValue("threshold");
    }
    voDrawActionCache none(NULL, NULL, -3, Mode::DEFAULT, -1, -1);
    expectBadValue("samples");
    voDrawActionCache spherical(&tetras, volume.get(), 1, Mode::SPHERICAL, 3, 1);
    expectNoError();
    voDrawActionCache outside(&tetras, volume.get(), 1, static_cast<voSamplingMode>(-7), 3, 1);
    expectBadEnum();
}

// findProjectedArea.

struct ProjectedAreaTest : testing::Test
{
    void add(std::vector<float> positions) { faces.appendPoly(positions.data(), int(positions.size()) / 3); }
    float area() { return voGeometryActions::findProjectedArea(&faces, model, projection, viewport); }

    voIndexedFaceSet faces{0, 3, 0};
    Matrix model, projection = ortho(4, -10, 10); // 8 x 8 units on 80 x 40 pixels
    GLint viewport[4] = {7, 9, 80, 40};
};

TEST_F(ProjectedAreaTest, orthographicAreaIsThatOfTheShadow)
{
    add({0, 0, 0, 2, 0, 1, 2, 1, 5, 0, 1, 4}); // slanted, over 2 x 1 units
    EXPECT_NEAR(area(), 2 * 1 * 10 * 5, 1e-3);
    add({0, 1, 0, 2, 1, 0, 2, 0, 0}); // half of it again, facing away
    EXPECT_NEAR(area(), 150, 1e-3);
    model = rotation(60, 0, 1, 0);
    faces.empty();
    add({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0});
    EXPECT_NEAR(area(), 4 * 0.5 * 50, 1e-3);
    model = rotation(90, 0, 1, 0);
    EXPECT_NEAR(area(), 0, 1e-3);
    expectNoError();
}

TEST_F(ProjectedAreaTest, onlyTheViewVolumeCounts)
{
    add({-100, -100, 0, 100, -100, 0, 0, 200, 0});
    EXPECT_NEAR(area(), 80 * 40, 1e-2);
    faces.empty();
    add({3, 3, 0, 5, 3, 0, 5, 5, 0, 3, 5, 0});
    EXPECT_NEAR(area(), 50, 1e-3);
    faces.empty();
    add({0, 0, 11, 1, 0, 11, 1, 1, 11}); // before the near plane
    add({0, 0, -11, 1, 0, -11, 1, 1, -11});
    add({5, 0, 0, 6, 0, 0, 6, 1, 0});
    EXPECT_EQ(area(), 0.0f);
    expectNoError();
}

TEST_F(ProjectedAreaTest, perspectiveAreaOfAFloorEndsAtTheNearPlane)
{
    // The floor y = -1 under an eye at 0, 2 wide, from 4 behind the eye to 8 ahead; near 1, far 100, 90
    // degrees.
    projection = frustum(1, 1, 100);
    add({-1, -1, 4, 1, -1, 4, 1, -1, -8, -1, -1, -8});
    // At distance z it is 2 / z wide at height -1 / z: from -1 (near plane) to -1 / 8, of a screen 2 x 2.
    const double trapezium = 0.5 * (2.0 + 2.0 / 8) * (1.0 - 1.0 / 8);
    EXPECT_NEAR(area(), trapezium * 40 * 20, 1e-2);
    faces.empty();
    add({-1, -1, 4, 1, -1, 4, 1, 1, 4}); // behind the eye
    EXPECT_EQ(area(), 0.0f);
    expectNoError();
}

TEST_F(ProjectedAreaTest, badInputDoesNoHarm)
{
    EXPECT_EQ(area(), 0.0f);
    add({0, 0, 0, kNaN, 0, 0, 1, 1, 0});
    add({0, 0, 0, HUGE_VALF, 0, 0, 1, 1, 0});
    EXPECT_EQ(area(), 0.0f);
    expectNoError();
    add({0, 0, 0, 1, 0, 0, 1, 1, 0});
    EXPECT_EQ(voGeometryActions::findProjectedArea(NULL, model, projection, viewport), 0.0f);
    expectBadValue("faceSet is NULL");
    EXPECT_EQ(voGeometryActions::findProjectedArea(&faces, NULL, projection, viewport), 0.0f);
    expectBadValue("matrix");
    EXPECT_EQ(voGeometryActions::findProjectedArea(&faces, model, projection, NULL), 0.0f);
    expectBadValue("viewport is NULL");
    viewport[3] = -1;
    EXPECT_EQ(area(), 0.0f);
    expectBadValue("80 x -1");
    viewport[3] = 40;
    std::fill_n(model.m, 16, 0.0);
    EXPECT_EQ(area(), 0.0f);
    expectBadValue("singular");
}

} // namespace
