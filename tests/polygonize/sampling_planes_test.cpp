#include "polygonize/sampling_planes.h"

#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace scenes;
using vo::SamplingMode;
using vo::SamplingSpace;

namespace {

constexpr double kSize = 64.0;

vo::Camera orthographic(const glm::dvec3& direction)
{
    vo::Camera camera;
    camera.direction = camera.depthNormal = glm::normalize(direction);
    return camera;
}

vo::SamplingRequest across(int stackAxis, double period = 1.0, int maxSamples = 4096)
{
    vo::SamplingRequest request = everyVoxel(maxSamples);
    request.mode = SamplingMode::axisAligned;
    request.stackAxis = stackAxis;
    request.period = glm::dvec3(period);
    return request;
}

} // namespace

TEST(SamplingPlanes, unitPeriodGivesOnePlanePerVoxelHeadOn)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            glm::dvec3 direction(0.0);
            direction[axis] = side;
            const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic(direction), everyVoxel());
            EXPECT_EQ(planes.count, 64);
            EXPECT_EQ(planes.spacing, 1.0);
            EXPECT_EQ(planes.first, (side > 0 ? kSize : 0.0) - 0.5);
            EXPECT_EQ(planes.normal, direction);
        }
}

TEST(SamplingPlanes, unitPeriodGivesRootThreeTimesAsManyOnTheDiagonal)
{
    const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic({1, 1, 1}), everyVoxel());
    EXPECT_EQ(planes.count, 111); // ceil(64 * sqrt 3)
    EXPECT_DOUBLE_EQ(planes.spacing, kSize * std::sqrt(3.0) / 111);
    EXPECT_DOUBLE_EQ(planes.first, kSize * std::sqrt(3.0) - 0.5 * planes.spacing);
}

TEST(SamplingPlanes, headOnViewsInSinglePrecisionHaveOnePlaneAVoxel)
{
    using namespace gl_matrices;
    for (const glm::dvec3& size :
         {glm::dvec3(64), glm::dvec3(512, 512, 9), glm::dvec3(12, 2000, 7), glm::dvec3(2000)})
        for (const double x : {0, 90, 180, -90})
            for (const double z : {0, 90, 180, 270, -90}) {
                const double reach = glm::length(size);
                const glm::mat4 turn = rotateInFloats(x, {1, 0, 0}) * rotateInFloats(z, {0, 0, 1});
                const glm::mat4 model =
                    glm::mat4(translate({0, 0, -2 * reach})) * turn * glm::mat4(translate(-0.5 * size));
                for (const glm::mat4 projection :
                     {glm::mat4(ortho(-reach, reach, -reach, reach, reach, 3 * reach)),
                      glm::mat4(perspective(50, 1, reach, 3 * reach))}) {
                    const vo::Camera view = vo::findCamera(glm::dmat4(model), glm::dmat4(projection)).value();
                    const auto planes =
                        vo::samplingPlanes(cube(glm::dvec3(0), size).view(), view, everyVoxel());
                    const int axis = vo::closestAxis(view);
                    EXPECT_EQ(planes.count, size[axis]) << x << " " << z;
                    const double side = view.direction[axis];
                    EXPECT_NEAR(planes.spacing, 1.0, 1e-6);
                    EXPECT_NEAR(planes.first, (side > 0 ? size[axis] : 0.0) - 0.5, 1e-6 * size[axis]);
                }
            }
}

TEST(SamplingPlanes, periodsThatNoFloatIsDivideTheirLength)
{
    for (int n = 1; n <= 4000; ++n) {
        vo::SamplingRequest request = everyVoxel();
        request.period = glm::dvec3(double(1.0f / float(n)));
        ASSERT_EQ(vo::samplingPlanes(cube(1).view(), orthographic({0, 0, 1}), request).count, n);
        request.mode = SamplingMode::axisAligned;
        ASSERT_EQ(vo::samplingPlanes(cube(1).view(), orthographic({0, 0, 1}), request).count, n);
    }
}

TEST(SamplingPlanes, aHundredthOfAStepMoreGetsAPlaneMore)
{
    for (const int n : {1, 8, 500, 2000}) {
        const TetraSet set = cube(glm::dvec3(0), glm::dvec3(4000, 4000, n + 0.01));
        EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({0, 0, 1}), everyVoxel()).count, n + 1);
    }
}

TEST(SamplingPlanes, exactMultiplesOfTheStepGetNoPlaneMore)
{
    // 64 sqrt(3) long in steps of sqrt(3): rounding must not make it 65.
    vo::SamplingRequest request = everyVoxel();
    request.period = glm::dvec3(std::sqrt(3.0));
    for (const glm::dvec3& way : {glm::dvec3(1, 1, 1), glm::dvec3(-1, 1, 1), glm::dvec3(-1, -1, -1)})
        EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), orthographic(way), request).count, 64);
}

TEST(SamplingPlanes, anisotropicPeriodsCombineAlongTheView)
{
    const glm::dvec3 period(1.0, 2.0, 0.5);
    vo::SamplingRequest request = everyVoxel();
    request.period = period;
    const TetraSet set = cube(kSize);
    EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({1, 0, 0}), request).count, 64);
    EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({0, 1, 0}), request).count, 32);
    EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({0, 0, -1}), request).count, 128);
    // Along d the period lattice is crossed every 1 / |d / period|.
    const glm::dvec3 d = glm::normalize(glm::dvec3(1, 2, 3));
    const double step = 1.0 / std::sqrt(d.x * d.x + d.y * d.y / 4 + d.z * d.z * 4);
    const double extent = kSize * (d.x + d.y + d.z);
    EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic(d), request).count,
              static_cast<int>(std::ceil(extent / step)));
}

TEST(SamplingPlanes, axisAlignedStepIsThePeriodAtAnyAngle)
{
    vo::SamplingRequest request = everyVoxel();
    request.mode = SamplingMode::axisAligned;
    request.period = glm::dvec3(1.0, 2.0, 0.5);
    const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic({0.3, -0.8, 0.4}), request);
    EXPECT_EQ(planes.normal, glm::dvec3(0, -1, 0));
    EXPECT_EQ(planes.count, 32);
    EXPECT_EQ(planes.spacing, 2.0);
    EXPECT_EQ(planes.first, -1.0);
}

TEST(SamplingPlanes, clampedCountWidensTheSpacing)
{
    const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic({0, 0, 1}), everyVoxel(10));
    EXPECT_EQ(planes.count, 10);
    EXPECT_DOUBLE_EQ(planes.spacing, 6.4);
    EXPECT_DOUBLE_EQ(planes.first, 60.8);
}

TEST(SamplingPlanes, withoutPeriodCountIsTheOneAskedFor)
{
    vo::SamplingRequest request;
    request.maxSamples = 17;
    const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic({0, 1, 1}), request);
    EXPECT_EQ(planes.count, 17);
    EXPECT_DOUBLE_EQ(planes.spacing, kSize * std::sqrt(2.0) / 17);
}

TEST(SamplingPlanes, tinyPeriodsClampWithoutOverflow)
{
    vo::SamplingRequest request = everyVoxel(1000);
    request.period = glm::dvec3(1e-300);
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), orthographic({0, 1, 1}), request).count, 1000);
    request.space = SamplingSpace::viewVolume;
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), camera(kSize, glm::dmat4(1), true), request).count,
              1000);
}

TEST(SamplingPlanes, onlyVerticesThatAreUsedCount)
{
    for (const double beyond : {1000.0, -1000.0}) {
        TetraSet set = cube(kSize);
        set.add(glm::dvec3(beyond));
        EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({0, 0, 1}), everyVoxel()).count, 64) << beyond;
    }
}

TEST(SamplingPlanes, verticesThatAreNotFiniteCountAsAbsent)
{
    TetraSet set = cube(kSize);
    const int bad = static_cast<int>(set.records.size() / 3);
    set.add({0, 0, HUGE_VAL});
    set.add({std::nan(""), 0, 1000});
    for (const int vertex : {0, 1, bad, bad + 1})
        set.indices.push_back(vertex);
    const auto planes = vo::samplingPlanes(set.view(), orthographic({0.1, 0.1, 1}), everyVoxel());
    const auto expected = vo::samplingPlanes(cube(kSize).view(), orthographic({0.1, 0.1, 1}), everyVoxel());
    EXPECT_EQ(planes.count, expected.count);
    EXPECT_EQ(planes.first, expected.first);
}

TEST(SamplingPlanes, perspectiveMeasuresAlongTheRayThroughTheCentre)
{
    // The set's centre lies 45 degrees aside: along the ray, planes of constant depth are sqrt(2) farther
    // apart.
    vo::Camera view;
    view.perspective = true;
    view.eye = {32.0 - 100.0, 32.0, 132.0};
    const auto planes = vo::samplingPlanes(cube(kSize).view(), view, everyVoxel());
    EXPECT_EQ(planes.count, static_cast<int>(std::ceil(kSize * std::sqrt(2.0))));
    EXPECT_NEAR(planes.normal.z, -std::sqrt(2.0), 1e-12);
    EXPECT_EQ(planes.normal.x, 0.0);
    EXPECT_NEAR(planes.first, -0.5 * planes.spacing, 1e-12);
}

TEST(SamplingPlanes, setBehindOrAsideOfTheEyeIsMeasuredAlongTheMiddleOfTheView)
{
    vo::Camera view;
    view.perspective = true;
    for (const glm::dvec3& eye :
         {glm::dvec3(32, 32, -100), glm::dvec3(32, 32, 32), glm::dvec3(1000, 32, 40)}) {
        view.eye = eye;
        const auto planes = vo::samplingPlanes(cube(kSize).view(), view, everyVoxel());
        EXPECT_EQ(planes.count, 64);
        EXPECT_EQ(planes.normal, glm::dvec3(0, 0, -1));
    }
}

TEST(SamplingPlanes, closestAxisPrefersTheLaterOneInTies)
{
    EXPECT_EQ(vo::closestAxis(orthographic({3, 2, 1})), 0);
    EXPECT_EQ(vo::closestAxis(orthographic({1, -3, 2})), 1);
    EXPECT_EQ(vo::closestAxis(orthographic({1, 2, -3})), 2);
    EXPECT_EQ(vo::closestAxis(orthographic({1, 1, 1})), 2);
    EXPECT_EQ(vo::closestAxis(orthographic({1 + 1e-15, 1, 1 - 1e-15})), 2);
    EXPECT_EQ(vo::closestAxis(orthographic({-1, 1, 0})), 1);
}

TEST(SamplingPlanes, viewVolumeHasPlanesOnBothEnds)
{
    vo::SamplingRequest request = everyVoxel();
    request.space = SamplingSpace::viewVolume;
    const vo::Camera view =
        vo::findCamera(gl_matrices::translate({0, 0, -200}), gl_matrices::perspective(40, 1, 100, 300.5))
            .value();
    const auto planes = vo::samplingPlanes(cube(glm::dvec3(-32), glm::dvec3(32)).view(), view, request);
    EXPECT_EQ(planes.count, 202);
    EXPECT_NEAR(planes.offset(0), 100.5, 1e-9);
    EXPECT_NEAR(planes.offset(planes.count - 1), -100.0, 1e-9);
    request.maxSamples = 3;
    EXPECT_NEAR(vo::samplingPlanes(cube(1).view(), view, request).offset(1), 0.25, 1.0);
    request.maxSamples = 1;
    EXPECT_EQ(vo::samplingPlanes(cube(1).view(), view, request).count, 1);
}

TEST(SamplingPlanes, viewVolumeEndsStayWhenTheSetLiesAside)
{
    vo::SamplingRequest request = everyVoxel();
    request.space = SamplingSpace::viewVolume;
    const vo::Camera view =
        vo::findCamera(gl_matrices::translate({60, 0, -90}), gl_matrices::perspective(90, 1, 50, 150))
            .value();
    const auto planes = vo::samplingPlanes(cube(glm::dvec3(-1), glm::dvec3(1)).view(), view, request);
    const double alongRay = std::hypot(60.0, 90.0) / 90.0; // lengths along the view to depths
    EXPECT_EQ(planes.count, 1 + static_cast<int>(std::ceil(100 * alongRay)));
    const auto depth = [&](int k) { return planes.offset(k) / glm::length(planes.normal); };
    EXPECT_NEAR(depth(0), view.farDepth, 1e-9);
    EXPECT_NEAR(depth(planes.count - 1), view.nearDepth, 1e-9);
}

TEST(SamplingPlanes, axisAlignedViewVolumeSpansTheFrustumsCorners)
{
    vo::SamplingRequest request = everyVoxel();
    request.mode = SamplingMode::axisAligned;
    request.space = SamplingSpace::viewVolume;
    request.period = glm::dvec3(1, 1, 4);
    const vo::Camera view = vo::findCamera(glm::dmat4(1), gl_matrices::frustum(-2, 2, -1, 1, 1, 41)).value();
    const auto planes = vo::samplingPlanes(cube(8).view(), view, request);
    EXPECT_EQ(planes.count, 11);
    EXPECT_NEAR(planes.first, 41, 1e-9);
    EXPECT_NEAR(planes.offset(10), 1, 1e-9);
}

TEST(SamplingPlanes, endlessViewVolumeHasNoPlanes)
{
    const glm::dmat4 endless = gl_matrices::rows({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, -1, -2}, {0, 0, -1, 0});
    const vo::Camera view = vo::findCamera(gl_matrices::translate({0, 0, -200}), endless).value();
    vo::SamplingRequest request = everyVoxel();
    EXPECT_GT(vo::samplingPlanes(cube(kSize).view(), view, request).count, 64) << "the set has its depth";
    request.space = SamplingSpace::viewVolume;
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), view, request).count, 0);
    request.mode = SamplingMode::axisAligned;
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), view, request).count, 0);
}

TEST(SamplingPlanes, primitivePlanesFollowEachTetrahedron)
{
    TetraSet set = cube(glm::dvec3(0), glm::dvec3(10));
    const int first = static_cast<int>(set.records.size() / 3);
    for (const glm::dvec3& p :
         {glm::dvec3(0, 0, 100), glm::dvec3(4, 0, 100), glm::dvec3(0, 4, 101), glm::dvec3(1, 1, 104)})
        set.add(p);
    for (int i = 0; i < 4; ++i)
        set.indices.push_back(first + i);
    vo::SamplingRequest request = everyVoxel();
    request.space = SamplingSpace::primitive;
    const vo::Camera view = orthographic({0, 0, 1});
    const auto own = vo::primitivePlanes(set.view(), 5, view, request);
    EXPECT_EQ(own.count, 4);
    EXPECT_EQ(own.first, 103.5);
    const auto deepest = vo::samplingPlanes(set.view(), view, request);
    EXPECT_EQ(deepest.count, 10);
    EXPECT_EQ(deepest.first, 9.5);
}

TEST(SamplingPlanes, stacksAreSampledAtVoxelCentresWhateverTheGeometry)
{
    const TetraSet set = cube(glm::dvec3(1.2, 1.2, 3.3), glm::dvec3(60, 60, 9.4));
    const auto up = vo::samplingPlanes(set.view(), orthographic({0.2, 0.1, 1}), across(2));
    EXPECT_EQ(up.count, 6); // 3.5 to 8.5
    EXPECT_EQ(up.first, 8.5);
    EXPECT_EQ(up.spacing, 1.0);
    const auto down = vo::samplingPlanes(set.view(), orthographic({0.2, 0.1, -1}), across(2));
    EXPECT_EQ(down.count, 6);
    EXPECT_EQ(down.first, -3.5);
    const auto wide = vo::samplingPlanes(set.view(), orthographic({0.2, 0.1, 1}), across(2, 2.0));
    EXPECT_EQ(wide.count, 3); // 4.5, 6.5, 8.5
    EXPECT_EQ(wide.first, 8.5);
    const auto fine = vo::samplingPlanes(set.view(), orthographic({0.2, 0.1, 1}), across(2, 0.25));
    EXPECT_EQ(fine.first, 9.25);
    EXPECT_EQ(fine.count, 24); // 3.5 to 9.25
}

TEST(SamplingPlanes, stackPlanesAtTheEndsOfTheSetAreIncluded)
{
    const TetraSet set = cube(glm::dvec3(0.5), glm::dvec3(15.5));
    for (const double side : {-1.0, 1.0})
        EXPECT_EQ(vo::samplingPlanes(set.view(), orthographic({0, 0, side}), across(2)).count, 16);
}

TEST(SamplingPlanes, stackStepWidensByWholeMultiples)
{
    const auto planes = vo::samplingPlanes(cube(kSize).view(), orthographic({0, 0, 1}), across(2, 1.0, 30));
    EXPECT_EQ(planes.spacing, 3.0); // 64 centres, 32 with every other one, 22 with every third
    EXPECT_EQ(planes.count, 22);
    EXPECT_EQ(planes.first, 63.5);
    vo::SamplingRequest unspecified = across(2, 1.0, 32);
    unspecified.period.reset();
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), orthographic({0, 0, 1}), unspecified).count, 32);
    EXPECT_EQ(vo::samplingPlanes(cube(kSize).view(), orthographic({0, 0, 1}), across(2, 1.0, 1)).count, 1);
    EXPECT_LE(vo::samplingPlanes(cube(kSize).view(), orthographic({0, 0, 1}), across(2, 1e-300, 7)).count, 7);
}

TEST(SamplingPlanes, otherAxesOfAStackFollowTheGeometry)
{
    const auto planes = vo::samplingPlanes(cube(glm::dvec3(0.2), glm::dvec3(10.2)).view(),
                                           orthographic({0, 1, 0}), across(2));
    EXPECT_NEAR(planes.first, 9.7, 1e-6);
}

TEST(SamplingPlanes, emptyAndFlatSetsGiveAtMostOnePlane)
{
    const vo::Camera view = orthographic({0, 0, 1});
    const TetraSet flat = cube(glm::dvec3(0, 0, 7), glm::dvec3(9, 9, 7));
    for (const SamplingSpace space : {SamplingSpace::object, SamplingSpace::primitive}) {
        vo::SamplingRequest request = everyVoxel();
        request.space = space;
        EXPECT_EQ(vo::samplingPlanes(TetraSet{}.view(), view, request).count, 0);
        const auto planes = vo::samplingPlanes(flat.view(), view, request);
        EXPECT_EQ(planes.count, 1);
        EXPECT_EQ(planes.first, 7.0);
        EXPECT_GT(planes.spacing, 0.0);
        request.period.reset();
        EXPECT_EQ(vo::samplingPlanes(flat.view(), view, request).count, 1);
    }
    EXPECT_EQ(vo::samplingPlanes(flat.view(), view, across(2)).count, 0) << "7 is no voxel centre";
    EXPECT_EQ(vo::samplingPlanes(TetraSet{}.view(), view, across(2)).count, 0);
}
