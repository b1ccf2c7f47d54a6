// Where sampling planes lie: what a view shows of a volume, sheets as thick as they are, bounds of the work,
// and finer planes against the integral.

#include <gtest/gtest.h>

#include "support/styled_reference.h"
#include "view_scene.h"
#include "x3d/plane_spacing.h"

#include "cast/cast_scene.h"
#include "style/seen_part.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <numbers>

namespace vo {
namespace {

constexpr double kPi = std::numbers::pi;

/// A box that is turned about x, 10 before the eye.
StyledScene boxScene(const glm::vec3& dimensions, double degrees = 0.0)
{
    StyledScene scene;
    scene.width = scene.height = 16;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -10.0});
    scene.clipFromEye = glm::ortho(-0.3, 0.3, -0.3, 0.3, 1.0, 100.0);
    StyledVolume volume;
    volume.dimensions = dimensions;
    volume.worldFromLocal = glm::rotate(glm::dmat4(1.0), degrees * kPi / 180.0, {1.0, 0.0, 0.0});
    scene.volumes.push_back(volume);
    return scene;
}

SeenPart partOf(const StyledScene& scene)
{
    const auto part = seenPart(scene, scene.volumes[0]);
    EXPECT_TRUE(part);
    return part.value_or(SeenPart{});
}

void expectPart(const StyledScene& scene, double nearest, double farthest, double crossing)
{
    const SeenPart part = partOf(scene);
    EXPECT_NEAR(part.nearest, nearest, 1e-9);
    EXPECT_NEAR(part.farthest, farthest, 1e-9);
    EXPECT_NEAR(part.crossing, crossing, 1e-9 * crossing);
}

TEST(SeenPart, endsAtTheFacesOfTheBox)
{
    StyledScene scene = boxScene({0.4f, 0.5f, 3.0f});
    expectPart(scene, 8.5, 11.5, 3.0);
    scene.volumes[0].worldFromLocal = glm::scale(glm::dmat4(1.0), {1.0, 1.0, -2.0});
    expectPart(scene, 7.0, 13.0, 6.0);
}

TEST(SeenPart, endsAtTheEdgesOfThePicture)
{
    // Of a sheet at 45 degrees, 100 wide, the picture shows 0.6 of its height and so of its depth.
    const double thick = 0.25 * std::sqrt(2.0);
    expectPart(boxScene({100, 100, 0.25f}, 45.0), 9.7 - thick / 2.0, 10.3 + thick / 2.0, thick);
}

TEST(SeenPart, endsAtNearAndFarPlanes)
{
    StyledScene scene = boxScene({400, 400, 400});
    scene.clipFromEye = glm::ortho(-0.3, 0.3, -0.3, 0.3, 2.0, 5.0);
    expectPart(scene, 2.0, 5.0, 3.0);
    scene.clipFromEye = glm::infinitePerspective(0.5, 1.0, 0.5);
    // Ways to the corners of the picture cross the cube no faster than the way through its middle.
    expectPart(scene, 0.5, 210.0, 209.5);
}

TEST(SeenPart, crossesSheetsFastestAtTheEdgeOfThePicture)
{
    // The eye above the middle of a floor: rays go down 3/4 for each unit of depth at the most.
    StyledScene scene = boxScene({200, 0.5f, 200});
    scene.clipFromEye = glm::frustum(-0.75, 0.75, -0.75, 0.75, 1.0, 50.0);
    EXPECT_NEAR(partOf(scene).crossing, 0.5 / 0.75, 1e-9);
}

TEST(SeenPart, clipPlanesThatFaceEachOtherMakeSheets)
{
    StyledScene scene = boxScene({100, 100, 100}, 30.0);
    const double c = std::cos(kPi / 4.0);
    scene.volumes[0].clipPlanes = {{0, -3 * c, 3 * c, 0.03}, {0, c, -c, 0.01}};
    EXPECT_NEAR(partOf(scene).crossing, 0.02 / c, 1e-9);
    scene.volumes[0].clipPlanes[1].w = -0.02;
    EXPECT_FALSE(seenPart(scene, scene.volumes[0])) << "nothing is left";
}

TEST(SeenPart, isNothingBesideThePicture)
{
    StyledScene scene = boxScene({1, 1, 1});
    scene.volumes[0].worldFromLocal = glm::translate(glm::dmat4(1.0), {1.0, 0.0, 0.0});
    EXPECT_FALSE(seenPart(scene, scene.volumes[0]));
    scene.volumes[0].worldFromLocal = glm::translate(glm::dmat4(1.0), {0.0, 0.0, 12.0});
    EXPECT_FALSE(seenPart(scene, scene.volumes[0])) << "behind the eye";
    scene.clipFromEye = glm::dmat4(0.0);
    EXPECT_FALSE(seenPart(scene, scene.volumes[0])) << "no projection";
}

TEST(SeenPart, isThatOfTheBoxRoundTetrahedra)
{
    StyledScene scene = boxScene({9, 9, 9});
    auto tetras = std::make_shared<StyledTetras>();
    tetras->positions = {{0, 0, 1}, {0.1f, 0, 3}, {0, 0.1f, 2}, {0.1f, 0.1f, 1.5f}};
    tetras->indices = {0, 1, 2, 3};
    scene.volumes[0].tetras = tetras;
    expectPart(scene, 7.0, 9.0, 2.0);
}

// Spacings

TEST(PlaneSpacing, isTheShortestEdgeOfAVoxelInTheWorld)
{
    StyledScene scene = boxScene({4, 4, 8});
    scene.volumes[0].unitLength = 4.0 / 64.0;
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 1.0).distance, 4.0 / 64.0, 1e-12);
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 0.25).distance, 1.0 / 64.0, 1e-12);
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 2.0).distance, 8.0 / 64.0, 1e-12);
    scene.volumes[0].worldFromLocal = glm::scale(glm::dmat4(1.0), {0.5, 2.0, 3.0});
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 1.0).distance, 2.0 / 64.0, 1e-12);
}

TEST(PlaneSpacing, isUsuallyHalfAsLongWhereStylesReadNormals)
{
    StyledVolume volume;
    EXPECT_EQ(usualSampling(volume), 1.0);
    Shaded shaded;
    volume.chains = {{}, {test::styleWithReference(OpacityMap{}), test::styleWithReference(shaded)}};
    EXPECT_EQ(usualSampling(volume), 1.0) << "not lit";
    shaded.lighting = true;
    volume.chains[1][1] = test::styleWithReference(shaded);
    EXPECT_EQ(usualSampling(volume), 0.5);
    volume.surfaces.emplace();
    EXPECT_EQ(usualSampling(volume), 1.0) << "surfaces lie between planes";
    volume.surfaces.reset();
    volume.stipple.emplace();
    EXPECT_EQ(usualSampling(volume), 1.0) << "points lie on no planes";
    volume.stipple.reset();
    auto normals = std::make_shared<VoxelTexture>();
    normals->components = 3;
    normals->texels.resize(3);
    shaded.surfaceNormals = normals;
    volume.chains[1][1] = test::styleWithReference(shaded);
    EXPECT_EQ(usualSampling(volume), 0.5) << "normals that are given";
}

TEST(PlaneSpacing, hasNoMoreThan4096PlanesInTheWayOfARay)
{
    StyledScene scene = boxScene({4, 4, 8});
    scene.volumes[0].unitLength = 1e-5;
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 1.0).distance, 8.0 / 4096.0, 1e-12);
    EXPECT_NEAR(planeSpacing(scene, scene.volumes[0], 0.5).distance, 8.0 / 8192.0, 1e-12);
}

TEST(PlaneSpacing, putsPlanesIntoEverySheetThatWorkAllows)
{
    for (const double degrees : {0.0, 45.0, 80.0, 89.0, 89.99, 90.0}) {
        const StyledScene scene = boxScene({1, 1, 1e-4f}, degrees);
        const PlaneSpacing planes = planeSpacing(scene, scene.volumes[0], 1.0);
        EXPECT_GE(partOf(scene).crossing / planes.distance, 25.0) << degrees;
        EXPECT_TRUE(planes.meetsVolume);
    }
    StyledScene thinner = boxScene({1, 1, 1e-6f}, 45.0);
    EXPECT_FALSE(planeSpacing(thinner, thinner.volumes[0], 1.0).meetsVolume);
    thinner.volumes[0].worldFromLocal = glm::dmat4(1.0);
    EXPECT_TRUE(planeSpacing(thinner, thinner.volumes[0], 1.0).meetsVolume) << "seen face on";
}

TEST(PlaneSpacing, sheetsTooThinForTheViewAreToldOfOnce)
{
    ViewedScene s("<OrthoViewpoint fieldOfView='-1 -1 1 1'/>\n<Transform rotation='1 0 0 0.785398'>"
                  "<VolumeData dimensions='1 1 0.000001'><PixelTexture3D image='1 1 1 1 51'/></VolumeData>"
                  "</Transform>");
    s.draw();
    EXPECT_EQ(s.messages(),
              "s.x3d:3: warning: expected a volume thicker than a part in 131072 of its depth in "
              "the view, found a thinner one: it is drawn with gaps\n");
}

// Pictures

std::string sheetSeenAt(double degrees, const char* eye)
{
    // 10 of 255 over the thickness, in one voxel.
    return std::string(eye) + "<Transform rotation='1 0 0 " + std::to_string(degrees * kPi / 180.0) +
           "'><VolumeData dimensions='1 1 0.0001'><PixelTexture3D image='1 1 1 1 "
           "10'/></VolumeData></Transform>";
}

/// The number of planes in a way is less than one off, so its exponent is.
void expectSheet(const StyledScene& scene, double length, double red, const char* what)
{
    const double unit = 1e-4, Ov = 10.0 / 255.0, off = scene.volumes[0].spacing;
    const auto opacity = [&](double l) { return 1.0 - std::pow(1.0 - Ov, l / unit); };
    EXPECT_GE(red, opacity(length - off) - 1e-5) << what;
    EXPECT_LE(red, opacity(length + off) + 1e-5) << what;
    EXPECT_LT(off, length / 25.0) << what;
}

TEST(PlaneSpacing, thinSheetsAreAsOpaqueAsTheirThickness)
{
    constexpr const char* kOrtho = "<OrthoViewpoint fieldOfView='-.001 -.001 .001 .001'/>";
    for (const double degrees : {0.0, 30.0, 45.0, 75.0, 89.0}) {
        ViewedScene s(sheetSeenAt(degrees, kOrtho));
        ViewRequest request;
        request.width = request.height = 4;
        s.draw(request);
        s.drawn.volumes.at(0).chains = {{test::styleWithReference(OpacityMap{})}};
        ScenePicture picture;
        castScene(s.drawn, 1, picture);
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4) // red is opacity * 10 / 255 on black
            expectSheet(s.drawn, 1e-4 / std::cos(degrees * kPi / 180.0),
                        double(picture.rgba[i]) / (10.0 / 255.0), ("at " + std::to_string(degrees)).c_str());
        if (degrees < 40.0) continue; // where the reference takes long
        const std::vector<double> reference = test::styledReference(s.drawn);
        for (std::size_t i = 0; i < reference.size(); ++i)
            EXPECT_NEAR(double(picture.rgba[i]), reference[i], 1e-4) << degrees;
    }
}

TEST(PlaneSpacing, thinSheetsInPerspectiveAreAsOpaqueAsTheirThickness)
{
    for (const double degrees : {0.0, 45.0}) {
        ViewedScene s(sheetSeenAt(degrees, "<Viewpoint position='0 0 1'/>"));
        ViewRequest request;
        request.width = request.height = 9;
        s.draw(request);
        ScenePicture picture;
        castScene(s.drawn, 1, picture);
        const std::size_t middle = 4 * (9 * 4 + 4);
        expectSheet(s.drawn, 1e-4 / std::cos(degrees * kPi / 180.0),
                    double(picture.rgba[middle]) / (10.0 / 255.0), "in the middle");
    }
}

/// A ball with a soft edge, lit from the upper left.
StyledScene litBall()
{
    constexpr int kEdge = 36;
    StyledScene scene = boxScene(glm::vec3(kEdge));
    scene.width = scene.height = 32;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -60.0});
    scene.clipFromEye = glm::ortho(-12.0, 12.0, -12.0, 12.0, 1.0, 100.0);
    StyledVolume& volume = scene.volumes[0];
    auto voxels = std::make_shared<VoxelTexture>();
    voxels->size = {kEdge, kEdge, kEdge};
    for (int i = 0; i < kEdge * kEdge * kEdge; ++i) {
        const glm::vec3 at =
            glm::vec3(i % kEdge, i / kEdge % kEdge, i / kEdge / kEdge) + (1.0f - kEdge) * 0.5f;
        const float value = std::clamp(10.0f - glm::length(at), 0.0f, 4.0f) / 4.0f;
        voxels->texels.push_back(static_cast<std::byte>(std::lround(255.0f * value)));
    }
    volume.voxels = voxels;
    Shaded shaded;
    shaded.lighting = true;
    shaded.hasMaterial = true;
    volume.chains = {{test::styleWithReference(shaded)}};
    StyleLight light;
    light.direction = glm::normalize(glm::vec3(1, -1, -1));
    volume.surroundings.lights = {light};
    return scene;
}

TEST(PlaneSpacing, finerPlanesComeCloserToTheIntegral)
{
    StyledScene scene = litBall();
    StyledVolume& volume = scene.volumes[0];
    volume.spacing = 1.0 / 64.0;
    const std::vector<double> integral = test::styledReference(scene);
    const auto errorWith = [&](double sampling) {
        volume.spacing = planeSpacing(scene, volume, sampling).distance;
        ScenePicture picture;
        castScene(scene, 1, picture);
        double sum = 0.0;
        for (std::size_t i = 0; i < integral.size(); ++i)
            sum += std::pow(double(picture.rgba[i]) - integral[i], 2.0);
        const double error = std::sqrt(sum / double(integral.size()));
        RecordProperty("PSNR at " + std::to_string(sampling), std::to_string(-20.0 * std::log10(error)));
        return error;
    };
    const double whole = errorWith(1.0), half = errorWith(0.5), quarter = errorWith(0.25);
    EXPECT_LT(half, 0.5 * whole);
    EXPECT_LT(quarter, half);
}

} // namespace
} // namespace vo
