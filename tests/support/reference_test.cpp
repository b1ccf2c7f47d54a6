#include "support/reference.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace vo::test;
using vo::VoxelSize;

/// Seen along -z, x to the right and y up, so many pixels for a voxel; the nearest voxels have the largest z.
Scene headOn(const Field& volume, int pixelsPerVoxel = 4)
{
    Scene scene;
    scene.volume = &volume;
    const VoxelSize& size = volume.size;
    scene.view.projection = ortho(0, size.x, 0, size.y, -size.z - 1.0, 1.0);
    scene.width = size.x * pixelsPerVoxel;
    scene.height = size.y * pixelsPerVoxel;
    return scene;
}

Scene seenFrom(const Field& volume, const Angles& angles, int pixels = 64)
{
    Scene scene;
    scene.volume = &volume;
    scene.view = orthographicView(angles, volume.size, pixels, pixels);
    scene.width = pixels;
    scene.height = pixels;
    return scene;
}

/// The guide's cube of five tetrahedra.
std::vector<Tetrahedron> fiveTetrahedra(const glm::dvec3& size)
{
    const auto corner = [&](int x, int y, int z) { return size * glm::dvec3(x, y, z); };
    return {{corner(0, 0, 0), corner(1, 1, 0), corner(1, 0, 1), corner(0, 1, 1)},
            {corner(1, 0, 0), corner(0, 0, 0), corner(1, 1, 0), corner(1, 0, 1)},
            {corner(0, 1, 0), corner(0, 0, 0), corner(1, 1, 0), corner(0, 1, 1)},
            {corner(0, 0, 1), corner(0, 0, 0), corner(1, 0, 1), corner(0, 1, 1)},
            {corner(1, 1, 1), corner(1, 1, 0), corner(1, 0, 1), corner(0, 1, 1)}};
}

double opacityOf(const Picture& picture, int x, int y)
{
    return picture.pixel(x, y)[3];
}

// ---- Planes

TEST(ReferencePlanes, headOnLieAtVoxelCentresFarthestFirst)
{
    const Field volume = constantField({8, 8, 16}, 0.5);
    const ReferencePlanes planes = referencePlanes(headOn(volume));
    ASSERT_EQ(planes.offsets.size(), 16u);
    EXPECT_NEAR(planes.normal.z, -1.0, 1e-12);
    for (std::size_t k = 0; k < 16; ++k)
        EXPECT_NEAR(planes.offsets[k], -(static_cast<double>(k) + 0.5), 1e-9);
}

TEST(ReferencePlanes, headOnInSinglePrecisionLieThereToo)
{
    const Field volume = constantField({512, 512, 16}, 0.5);
    Scene scene = headOn(volume, 1);
    for (const std::size_t entry : {2u, 6u}) // what x and y add to eye z
        scene.view.model[entry] += 1e-7;
    const ReferencePlanes planes = referencePlanes(scene);
    ASSERT_EQ(planes.offsets.size(), 16u);
    for (std::size_t k = 0; k < 16; ++k)
        EXPECT_NEAR(planes.offsets[k], -(static_cast<double>(k) + 0.5), 1e-9);
}

TEST(ReferencePlanes, diagonalViewTakesRootThreeTimesAsMany)
{
    const Field volume = constantField({16, 16, 16}, 0.5);
    const Scene scene = seenFrom(volume, {std::atan(std::sqrt(0.5)) * 180 / M_PI, 45});
    EXPECT_EQ(referencePlanes(scene).offsets.size(), 28u); // ceil(27.71)
}

TEST(ReferencePlanes, spacingIsMeasuredAlongTheLineOfSight)
{
    const Field volume = constantField({16, 24, 8}, 0.5);
    for (const Angles& angles : randomViews(10, 1)) {
        Scene scene = seenFrom(volume, angles);
        const glm::dvec3 period(0.5, 1.25, 2.0);
        scene.period = period;
        const ReferencePlanes planes = referencePlanes(scene);
        const glm::dvec3 d = planes.normal; // orthographic: both agree
        ASSERT_NEAR(glm::length(d), 1.0, 1e-12);
        const double step =
            1.0 / std::sqrt(std::pow(d.x / 0.5, 2) + std::pow(d.y / 1.25, 2) + std::pow(d.z / 2.0, 2));
        const double extent = 16 * std::abs(d.x) + 24 * std::abs(d.y) + 8 * std::abs(d.z);
        const double count = std::ceil(extent / step);
        ASSERT_EQ(static_cast<double>(planes.offsets.size()), count);
        const double centre = glm::dot(d, glm::dvec3(8, 12, 4));
        for (std::size_t k = 0; k < planes.offsets.size(); ++k)
            EXPECT_NEAR(planes.offsets[k],
                        centre + extent / 2 - (static_cast<double>(k) + 0.5) * extent / count, 1e-9);
    }
}

TEST(ReferencePlanes, inPerspectiveTheyStayParallelToTheScreen)
{
    const Field volume = constantField({16, 16, 16}, 0.5);
    Scene scene = seenFrom(volume, {20, 30});
    scene.view = perspectiveView({20, 30}, volume.size, 64, 64, 40);
    // The screen looks past the volume, so that the line of sight to its centre is oblique.
    scene.view.model = multiply(translation(4, 2, 0), scene.view.model);
    const ReferencePlanes planes = referencePlanes(scene);
    const Matrix& m = scene.view.model;
    const glm::dvec3 depth(-m[2], -m[6], -m[10]);
    EXPECT_NEAR(glm::length(glm::cross(glm::normalize(planes.normal), depth)), 0.0, 1e-12);
    // Offsets are lengths along the line from the eye to the centre.
    const glm::dvec3 eyeToCentre(4, 2, m[14] + 8 * (m[2] + m[6] + m[10]));
    const double cosine = -eyeToCentre.z / glm::length(eyeToCentre);
    EXPECT_NEAR(glm::length(planes.normal), 1.0 / cosine, 1e-9);
}

TEST(ReferencePlanes, atMostMaxSamplesSpreadOverTheSameExtent)
{
    const Field volume = constantField({8, 8, 16}, 0.5);
    Scene scene = headOn(volume);
    scene.maxSamples = 4;
    EXPECT_EQ(referencePlanes(scene).offsets.size(), 4u);
    EXPECT_NEAR(referencePlanes(scene).offsets[0], -2.0, 1e-9);
    scene.period.reset();
    scene.maxSamples = 32;
    EXPECT_EQ(referencePlanes(scene).offsets.size(), 32u);
    EXPECT_NEAR(referencePlanes(scene).offsets[31], -15.75, 1e-9);
}

TEST(ReferencePlanes, axisAlignedOnesFollowTheAxisNotTheView)
{
    const Field volume = constantField({8, 12, 16}, 0.5);
    for (const double longitude : {-40.0, -10.0, 0.0, 30.0}) {
        Scene scene = seenFrom(volume, {15, longitude});
        scene.planes = SamplingPlanes::axisAligned;
        scene.period = glm::dvec3(1, 0.5, 1);
        const ReferencePlanes planes = referencePlanes(scene);
        EXPECT_EQ(planes.normal, glm::dvec3(0, 1, 0)); // y points away from the viewer
        ASSERT_EQ(planes.offsets.size(), 24u);
        EXPECT_NEAR(planes.offsets[0], 11.75, 1e-9);
    }
}

TEST(ReferencePlanes, thoseOfStacksAreAnchoredAtVoxelCentres)
{
    const Field volume = constantField({8, 8, 16}, 0.5);
    Scene scene = headOn(volume);
    scene.planes = SamplingPlanes::axisAligned;
    scene.stackAxis = 2;
    EXPECT_EQ(referencePlanes(scene).offsets.size(), 16u);
    EXPECT_NEAR(referencePlanes(scene).offsets[0], -0.5, 1e-12);
    scene.period = glm::dvec3(3.0);
    EXPECT_EQ(referencePlanes(scene).offsets, (std::vector<double>{-0.5, -3.5, -6.5, -9.5, -12.5, -15.5}));
    scene.geometry = {{glm::dvec3(0, 0, 5), {8, 0, 5}, {0, 8, 5}, {0, 0, 10}}};
    EXPECT_EQ(referencePlanes(scene).offsets, (std::vector<double>{-6.5, -9.5}));
    scene.view.model = multiply(translation(0, 0, 8), multiply(scaling(1, 1, -1), translation(0, 0, -8)));
    EXPECT_EQ(referencePlanes(scene).offsets, (std::vector<double>{9.5, 6.5}));
}

// ---- Samples

TEST(ReferenceSample, linearFieldsAreExactAndClampedAtTheEdge)
{
    const glm::dvec3 gradient(0.02, 0.03, 0.01);
    const Field volume = rampField({9, 7, 11}, gradient, 0.1);
    const Scene scene = headOn(volume);
    std::mt19937 random(2);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 place(9.0 * random() / 4294967296.0, 7.0 * random() / 4294967296.0,
                               11.0 * random() / 4294967296.0);
        const glm::dvec3 clamped = glm::clamp(place, glm::dvec3(0.5), glm::dvec3(8.5, 6.5, 10.5));
        EXPECT_NEAR(referenceSample(scene, place)[0], 0.1 + glm::dot(gradient, clamped), 1e-7);
    }
}

TEST(ReferenceSample, stacksAreLinearInTheSliceAndConstantAcross)
{
    const glm::dvec3 gradient(0.02, 0.03, 0.01);
    const Field volume = rampField({9, 7, 11}, gradient);
    for (int axis = 0; axis < 3; ++axis) {
        Scene scene = headOn(volume);
        scene.stackAxis = axis;
        for (const double across : {2.0, 2.3, 2.5, 2.999}) {
            glm::dvec3 place(4.2, 3.3, 5.4);
            place[axis] = across;
            glm::dvec3 inSlice = place;
            inSlice[axis] = 2.5;
            EXPECT_NEAR(referenceSample(scene, place)[0], glm::dot(gradient, inSlice), 1e-7);
        }
    }
}

TEST(ReferenceSample, channelsSpreadAsOpenGLSpreadsThem)
{
    const Field one = constantField({2, 2, 2}, 0.25);
    const Field two = combined({one, constantField({2, 2, 2}, 0.5)});
    const Field four = combined({one, constantField({2, 2, 2}, 0.5), constantField({2, 2, 2}, 0.75), one});
    using Rgba = std::array<double, 4>;
    EXPECT_EQ(referenceSample(headOn(one), glm::dvec3(1)), (Rgba{0.25, 0.25, 0.25, 0.25}));
    EXPECT_EQ(referenceSample(headOn(two), glm::dvec3(1)), (Rgba{0.25, 0.25, 0.25, 0.5}));
    EXPECT_EQ(referenceSample(headOn(four), glm::dvec3(1)), (Rgba{0.25, 0.5, 0.75, 0.25}));
    Scene opaque = headOn(one);
    opaque.opaqueTexture = true;
    EXPECT_EQ(referenceSample(opaque, glm::dvec3(1)), (Rgba{0.25, 0.25, 0.25, 1.0}));
}

TEST(ReferenceSample, tablesApplyBeforeOrAfterInterpolation)
{
    const Field volume = axisRampField({2, 1, 1}, 0); // 0 and 1
    Scene scene = headOn(volume);
    scene.table = {0, 0, 0, 0, 1, 0.5f, 0.25f, 0.125f, 0, 0, 0, 1};
    scene.classification = Classification::postInterpolation;
    using Rgba = std::array<double, 4>;
    EXPECT_EQ(referenceSample(scene, {1.0, 0.5, 0.5}), (Rgba{1.0, 0.5, 0.25, 0.125}));
    EXPECT_EQ(referenceSample(scene, {0.75, 0.5, 0.5}), (Rgba{0.5, 0.25, 0.125, 0.0625}));
    scene.classification = Classification::preInterpolation;
    EXPECT_EQ(referenceSample(scene, {1.0, 0.5, 0.5}), (Rgba{0.0, 0.0, 0.0, 0.5}));
}

// ---- Pictures

TEST(ReferencePicture, constantVolumeHasTheOpacityOfItsLayers)
{
    for (const int overlap : {0, 1, 3})
        for (const double a : {0.02, 0.3, 0.9}) {
            const Field volume = constantField({8, 8, 16}, a);
            Scene scene = headOn(volume);
            scene.overlap = overlap;
            const Picture picture = referencePicture(scene);
            const int layers = 16 - std::max(0, overlap - 1);
            const double value = static_cast<double>(volume.values[0]);
            const double opacity = 1.0 - std::pow(1.0 - value, layers);
            const double* pixel = picture.pixel(16, 15);
            EXPECT_NEAR(pixel[3], opacity, 1e-12) << overlap;
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(pixel[c], value * opacity, 1e-12);
        }
}

TEST(ReferencePicture, planesOnTheClipBoxSurviveTheNoiseOfTheView)
{
    const Field volume = constantField({16, 16, 16}, 0.1);
    for (const Angles& angles :
         {Angles{0, 0}, {0, 90}, {0, 180}, {0, 270}, {90, 0}, {-90, 0}, {90, 90}, {360, 720}}) {
        Scene scene = seenFrom(volume, angles);
        scene.overlap = 1;
        EXPECT_NEAR(opacityOf(referencePicture(scene), 32, 32), 1.0 - std::pow(0.9, 16), 1e-6);
    }
}

TEST(ReferencePicture, perspectiveRayThroughTheMiddleMeetsEveryPlane)
{
    const Field volume = constantField({16, 16, 16}, 0.1);
    Scene scene = seenFrom(volume, {}, 65);
    scene.view = perspectiveView({}, volume.size, 65, 65, 30);
    const Picture picture = referencePicture(scene);
    EXPECT_NEAR(opacityOf(picture, 32, 32), 1.0 - std::pow(0.9, 16), 1e-6);
    EXPECT_EQ(opacityOf(picture, 0, 0), 0.0);
}

TEST(ReferencePicture, rampAcrossTheScreenIsExactInEveryColumn)
{
    const Field volume = axisRampField({16, 8, 8}, 0);
    const Picture picture = referencePicture(headOn(volume));
    for (int x = 0; x < picture.width; ++x) {
        const double value = std::clamp(((x + 0.5) / 4.0 - 0.5) / 15.0, 0.0, 1.0);
        EXPECT_NEAR(picture.pixel(x, 13)[0], value * (1.0 - std::pow(1.0 - value, 8)), 1e-7);
    }
}

TEST(ReferencePicture, rampInDepthIsBlendedBackToFront)
{
    const Field volume = axisRampField({4, 4, 16}, 2);
    double expected = 0.0;
    for (int z = 0; z < 16; ++z)
        expected = expected * (1.0 - z / 15.0) + z / 15.0 * z / 15.0;
    EXPECT_NEAR(referencePicture(headOn(volume)).pixel(8, 8)[0], expected, 1e-6);

    Scene fromBehind = headOn(volume);
    fromBehind.view.model = multiply(translation(0, 0, 16), scaling(1, 1, -1));
    expected = 0.0;
    for (int z = 15; z >= 0; --z)
        expected = expected * (1.0 - z / 15.0) + z / 15.0 * z / 15.0;
    EXPECT_NEAR(referencePicture(fromBehind).pixel(8, 8)[0], expected, 1e-6);
}

TEST(ReferencePicture, maximumOfABallIsItsValueWhereTheRayPassesTheCentre)
{
    const Field volume = ballField({33, 33, 33});
    Scene scene = headOn(volume, 3);
    scene.compositing = Compositing::max;
    const Picture picture = referencePicture(scene);
    EXPECT_EQ(picture.pixel(49, 49)[0], 1.0);
    for (int x = 0; x < picture.width; x += 7)
        for (int y = 0; y < picture.height; y += 5) {
            const double closest = std::hypot((x + 0.5) / 3 - 16.5, (y + 0.5) / 3 - 16.5);
            const double inward = std::max(0.0, 1.0 - closest / (16.5 * 0.9));
            EXPECT_NEAR(picture.pixel(x, y)[0], inward * inward * (3 - 2 * inward), 0.01);
            EXPECT_NEAR(opacityOf(picture, x, y), picture.pixel(x, y)[0], 1e-12);
        }
}

TEST(ReferencePicture, minimumAndSumReadTheBackground)
{
    const Field volume = axisRampField({4, 4, 5}, 2); // 0, 1/4, 1/2, 3/4, 1
    Scene scene = headOn(volume);
    scene.background = {1.0, 0.0, 0.5};
    scene.color = {1.0, 1.0, 1.0, 0.5};
    scene.compositing = Compositing::min;
    EXPECT_NEAR(referencePicture(scene).pixel(8, 8)[0], 0.0, 1e-12);
    scene.compositing = Compositing::sum;
    const Picture picture = referencePicture(scene);
    EXPECT_NEAR(picture.pixel(8, 8)[0], 3.5, 1e-6);
    EXPECT_NEAR(picture.pixel(8, 8)[1], 2.5, 1e-6);
    EXPECT_NEAR(opacityOf(picture, 8, 8), 1.25, 1e-6);
}

TEST(ReferencePicture, colorModulatesAndBackgroundShowsThrough)
{
    const Field volume = constantField({4, 4, 1}, 0.5);
    Scene scene = headOn(volume);
    scene.color = {1.0, 0.5, 0.25, 0.5};
    scene.background = {0.0, 0.0, 1.0};
    const Picture picture = referencePicture(scene);
    const double* pixel = picture.pixel(0, 0);
    EXPECT_NEAR(pixel[0], 0.25 * 0.5, 1e-12);
    EXPECT_NEAR(pixel[1], 0.25 * 0.25, 1e-12);
    EXPECT_NEAR(pixel[2], 0.25 * 0.125 + 0.75, 1e-12);
    EXPECT_NEAR(pixel[3], 0.25, 1e-12);
}

TEST(ReferencePicture, onlyWhatLiesBetweenNearAndFarIsDrawn)
{
    const Field volume = constantField({4, 4, 16}, 0.1);
    Scene scene = headOn(volume);
    scene.view.projection = ortho(0, 4, 0, 4, -10.0, -4.0); // z from 4 to 10
    EXPECT_NEAR(opacityOf(referencePicture(scene), 8, 8), 1.0 - std::pow(0.9, 6), 1e-6);
}

TEST(ReferencePicture, fiveTetrahedraShowTheWholeVolume)
{
    const Field volume = noiseField({16, 12, 8}, 3);
    for (const Angles& angles : randomViews(5, 4)) {
        Scene scene = seenFrom(volume, angles);
        const Picture whole = referencePicture(scene);
        scene.geometry = fiveTetrahedra({16, 12, 8});
        const Picture parts = referencePicture(scene);
        for (std::size_t i = 0; i < whole.rgba.size(); ++i) {
            if (!whole.unmasked[i / 4]) continue;
            ASSERT_NEAR(whole.rgba[i], parts.rgba[i], 1e-12);
        }
    }
}

TEST(ReferencePicture, oneTetrahedronCoversItsShadow)
{
    const Field volume = constantField({16, 16, 16}, 1.0);
    Scene scene = headOn(volume, 8);
    scene.geometry = {{glm::dvec3(0, 0, 0), {16, 0, 0}, {0, 16, 0}, {0, 0, 16}}};
    const Picture picture = referencePicture(scene);
    int drawn = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            drawn += opacityOf(picture, x, y) > 0.0;
    // Its slice at z = 1/2, the largest, is a triangle of side 15.5.
    EXPECT_NEAR(drawn / 64.0, 0.5 * 15.5 * 15.5, 2.0);
    EXPECT_GT(opacityOf(picture, 4, 4), 0.0);
    EXPECT_EQ(opacityOf(picture, 124, 124), 0.0);
}

TEST(ReferencePicture, letterReadsUprightFromInFront)
{
    const Field volume = letterFField({40, 40, 40});
    Scene scene = headOn(volume, 1);
    scene.view = {guideModel({0, 0}, volume.size), ortho(-20, 20, -20, 20, -40, 40)};
    scene.compositing = Compositing::max;
    const Picture picture = referencePicture(scene);
    const auto value = [&](int x, int y) { return picture.pixel(x, y)[0]; };
    EXPECT_NEAR(value(28, 31), 2.0 / 3.0, 1e-6); // upper bar: x to the right, z up, rows from the bottom
    EXPECT_LT(value(28, 8), 0.5);                // nothing but the letter behind, on z
    EXPECT_NEAR(value(10, 10), 2.0 / 3.0, 1e-6); // the stem is on the left
    EXPECT_EQ(value(36, 10), 0.0);
}

TEST(ReferencePicture, stacksShowTheirSlicesInPlace)
{
    const Field volume = axisRampField({4, 4, 5}, 2);
    Scene scene = headOn(volume);
    scene.planes = SamplingPlanes::axisAligned;
    scene.stackAxis = 2;
    scene.overlap = 1;
    scene.compositing = Compositing::sum;
    EXPECT_NEAR(referencePicture(scene).pixel(8, 8)[0], 2.5, 1e-6);
    // Slices at 0, 0.5 ... 4.5, but none on the nearest face; a plane between two slices shows the one above.
    scene.period = glm::dvec3(0.5);
    EXPECT_NEAR(referencePicture(scene).pixel(8, 8)[0], 0 + 0.5 + 1 + 1.5 + 2, 1e-6);
    // From behind, the face at 5 instead of that at 0.
    scene.view.model = multiply(translation(0, 0, 5), scaling(1, 1, -1));
    EXPECT_NEAR(referencePicture(scene).pixel(8, 8)[0], 0.5 + 1 + 1.5 + 2 + 1, 1e-6);
}

// ---- The mask

TEST(ReferenceMask, pixelsWithTheirCentreOnAnEdgeAreLeftOut)
{
    const Field volume = constantField({16, 16, 16}, 0.1);
    Scene scene = headOn(volume, 5);
    scene.overlap = 1; // the edge lies at 2.5 pixels, the centre of pixel 2
    const Picture picture = referencePicture(scene);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const bool inside = x >= 2 && x <= 77 && y >= 2 && y <= 77;
            const bool onEdge = inside && (x == 2 || x == 77 || y == 2 || y == 77);
            EXPECT_EQ(picture.isUnmasked(x, y), !onEdge) << x << ' ' << y;
        }
}

TEST(ReferenceMask, reachesATwoHundredthOfAPixel)
{
    const Field volume = constantField({16, 16, 16}, 0.1);
    for (const double shift : {-0.006, -0.004, 0.004, 0.006}) {
        Scene scene = headOn(volume, 5);
        scene.overlap = 1;
        scene.view.model = translation(shift / 5, 0, 0);
        EXPECT_EQ(referencePicture(scene).isUnmasked(2, 40), std::abs(shift) > 0.005) << shift;
    }
}

TEST(ReferenceMask, edgesBetweenPixelCentresMaskNothing)
{
    const Field volume = constantField({16, 16, 16}, 0.1);
    const Picture picture = referencePicture(headOn(volume, 5));
    EXPECT_EQ(std::count(picture.unmasked.begin(), picture.unmasked.end(), 0), 0);
}

TEST(ReferenceMask, leavesMostPixelsOfObliqueViewsIn)
{
    const Field volume = constantField({64, 64, 64}, 0.1);
    for (const Angles& angles : randomViews(2, 9)) {
        const Picture picture = referencePicture(seenFrom(volume, angles, 200));
        const auto masked = std::count(picture.unmasked.begin(), picture.unmasked.end(), 0);
        EXPECT_GT(masked, 0);
        EXPECT_LT(masked, 200 * 200 / 10);
    }
}

/// The picture may change within the mask only when the view is moved by less than it reaches.
TEST(ReferenceMask, coversEveryPixelThatAMoveOfAnEdgeChanges)
{
    const Field volume = constantField({24, 24, 24}, 0.5);
    for (const Angles& angles : randomViews(3, 10)) {
        Scene scene = seenFrom(volume, angles, 150);
        scene.overlap = 1;
        scene.view = perspectiveView(angles, volume.size, 150, 150, 35);
        const Picture before = referencePicture(scene);
        scene.view.projection =
            multiply(translation(0.003 * 2 / 150, -0.003 * 2 / 150, 0), scene.view.projection);
        const Picture after = referencePicture(scene);
        for (int y = 0; y < 150; ++y)
            for (int x = 0; x < 150; ++x) {
                if (!before.isUnmasked(x, y)) continue;
                ASSERT_NEAR(opacityOf(before, x, y), opacityOf(after, x, y), 1e-9);
            }
    }
}

} // namespace
