// Cameras, transforms, lights, levels, clip planes and limits of what is drawn of a scene.

#include <gtest/gtest.h>

#include "../util/scratch_folder.h"
#include "view_scene.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>

namespace vo {
namespace {

const std::string kVoxels = "<PixelTexture3D image='1 2 2 2 0 255 0 0 0 0 0 0'/>";
/// A volume that is nothing but there.
const std::string kVolume = "<VolumeData>" + kVoxels + "</VolumeData>";
const std::string kDark = "<NavigationInfo headlight='false'/>";

void expectNear(const glm::dvec3& found, const glm::dvec3& expected, double error = 1e-6)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], expected[axis], error) << "axis " << axis;
}

glm::dvec3 moved(const glm::dmat4& matrix, const glm::dvec3& point)
{
    return glm::dvec3(matrix * glm::dvec4(point, 1.0));
}

/// Where a point is in the picture, -1 to 1.
glm::dvec3 inPicture(const StyledScene& scene, const glm::dvec3& world)
{
    const glm::dvec4 clip = scene.clipFromEye * scene.eyeFromWorld * glm::dvec4(world, 1.0);
    return glm::dvec3(clip) / clip.w;
}

/// The scene in a picture of this size.
const StyledScene& drawnAt(ViewedScene& s, int width, int height)
{
    ViewRequest request;
    request.width = width;
    request.height = height;
    return s.draw(request);
}

/// The scene from a place along -Z, by a camera of the request.
const StyledScene& drawnFrom(ViewedScene& s, const glm::dvec3& eye)
{
    ViewRequest request;
    request.camera = ViewCamera{};
    request.camera->eyeFromWorld[3] = glm::dvec4(-eye, 1);
    return s.draw(request);
}

glm::dvec3 eyeOf(const StyledScene& scene)
{
    return glm::dvec3(glm::inverse(scene.eyeFromWorld)[3]);
}

const std::vector<StyleLight>& lightsOf(const ViewedScene& s, std::size_t volume = 0)
{
    return s.drawn.volumes.at(volume).surroundings.lights;
}

TEST(StyledView, transformScalesRotatesAndMovesAboutItsCenter)
{
    const ViewedScene s(
        "<Transform translation='10 0 0' center='1 0 0' rotation='0 0 1 1.5707963' scale='2 1 1'>" + kVolume +
        "</Transform>");
    ASSERT_EQ(s.drawn.volumes.size(), 1u);
    const glm::dmat4& matrix = s.drawn.volumes[0].worldFromLocal;
    expectNear(moved(matrix, {1, 0, 0}), {11, 0, 0});
    expectNear(moved(matrix, {2, 0, 0}), {11, 2, 0});
    expectNear(moved(matrix, {1, 1, 0}), {10, 0, 0});
}

TEST(StyledView, scaleOrientationTurnsTheAxesOfTheScale)
{
    const ViewedScene s("<Transform scaleOrientation='0 0 1 0.7853982' scale='3 1 1'>" + kVolume +
                        "</Transform>");
    const glm::dmat4& matrix = s.drawn.volumes.at(0).worldFromLocal;
    expectNear(moved(matrix, {1, 1, 0}), {3, 3, 0});
    expectNear(moved(matrix, {1, -1, 0}), {1, -1, 0});
}

TEST(StyledView, groupsMultiplyFromTheOutside)
{
    const ViewedScene s("<Transform translation='1 0 0'><Group><Transform scale='2 2 2'>" + kVolume +
                        "</Transform></Group></Transform>");
    expectNear(moved(s.drawn.volumes.at(0).worldFromLocal, {1, 0, 0}), {3, 0, 0});
}

TEST(StyledView, viewpointsAngleIsThatOfTheSmallerSide)
{
    ViewedScene s("<Viewpoint position='0 0 5' fieldOfView='1.5707963'/>" + kVolume);
    const auto ends = [](const StyledScene& scene) {
        return glm::dvec3(inPicture(scene, {0, 5, 0}).y, inPicture(scene, {5, 0, 0}).x, 0);
    };
    expectNear(ends(drawnAt(s, 200, 100)), {1, 0.5, 0});
    expectNear(ends(drawnAt(s, 100, 200)), {0.5, 1, 0});
}

TEST(StyledView, viewpointInScaledGroupStaysRigid)
{
    const ViewedScene s("<Transform translation='0 0 3' rotation='0 1 0 1.5707963' scale='2 1 5'>"
                        "<Viewpoint position='0 0 1'/></Transform>" +
                        kVolume);
    const glm::dmat4 worldFromEye = glm::inverse(s.drawn.eyeFromWorld);
    expectNear(eyeOf(s.drawn), {5, 0, 3}, 1e-5);
    expectNear(glm::dvec3(worldFromEye[2]), {1, 0, 0}, 1e-6);
    expectNear(glm::dvec3(worldFromEye[1]), {0, 1, 0});
    EXPECT_NEAR(glm::determinant(glm::dmat3(worldFromEye)), 1.0, 1e-9);
}

TEST(StyledView, withoutViewpointAllIsSeen)
{
    const ViewedScene s("<Transform translation='100 7 0'>" + kVolume +
                        "</Transform><Transform translation='0 0 -50'>" + kVolume + "</Transform>");
    for (const StyledVolume& volume : s.drawn.volumes)
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 at(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
            const glm::dvec3 seen = inPicture(s.drawn, moved(volume.worldFromLocal, at));
            EXPECT_LE(std::max({std::abs(seen.x), std::abs(seen.y), std::abs(seen.z)}), 1.0);
        }
    // A ball round the box of all fits into the angle, and no more.
    const double radius = std::hypot(101.0, 8.0, 51.0) / 2.0;
    expectNear(eyeOf(s.drawn), {50.0, 3.5, -25.0 + radius / std::sin(0.785398 / 2.0)}, 1e-4);
}

TEST(StyledView, orthoViewpointShowsItsRectangleWhole)
{
    for (const char* const version : {"3.3", "4.0"}) {
        ViewedScene s("<OrthoViewpoint fieldOfView='-1 -2 3 2'/>" + kVolume, version);
        drawnAt(s, 200, 100);
        expectNear({inPicture(s.drawn, {1, 0, 0}).x, inPicture(s.drawn, {0, 2, 0}).y,
                    inPicture(s.drawn, {5, 0, -3}).x},
                   {0, 1, 1});
    }
}

TEST(StyledView, orthoRectangleIsMadeHigherInHighWindows)
{
    ViewedScene s("<OrthoViewpoint fieldOfView='-1 -2 3 2'/>" + kVolume);
    drawnAt(s, 100, 200);
    expectNear(inPicture(s.drawn, {3, 4, 0}) * glm::dvec3(1, 1, 0), {1, 1, 0});
    expectNear(inPicture(s.drawn, {-1, -4, 0}) * glm::dvec3(1, 1, 0), {-1, -1, 0});
}

TEST(StyledView, viewpointAndCameraOfTheRequestComeFirst)
{
    ViewedScene s("<Viewpoint DEF='A' position='1 0 5'/><Viewpoint DEF='B' position='2 0 5'/>"
                  "<Switch><OrthoViewpoint DEF='C'/></Switch>" +
                  kVolume);
    EXPECT_NEAR(eyeOf(s.drawn).x, 1.0, 1e-9);
    ViewRequest request;
    request.viewpoint = s.scene.names.at("B");
    EXPECT_NEAR(eyeOf(s.draw(request)).x, 2.0, 1e-9);
    request.camera = ViewCamera{};
    request.camera->eyeFromWorld[3] = glm::dvec4(-3, 0, 0, 1);
    EXPECT_NEAR(eyeOf(s.draw(request)).x, 3.0, 1e-9);
    EXPECT_EQ(s.drawn.clipFromEye, glm::dmat4(1.0));
    const auto viewpoints = s.view->viewpoints();
    ASSERT_EQ(viewpoints.size(), 3u);
    EXPECT_EQ(viewpoints[1], s.scene.names.at("B"));
    EXPECT_EQ(viewpoints[2], s.scene.names.at("C"));
}

TEST(StyledView, viewAllMovesTheEyeAndKeepsItsDirection)
{
    const ViewedScene s(
        "<Viewpoint viewAll='true' orientation='0 1 0 1.5707963'/><Transform translation='0 9 0'>" + kVolume +
        "</Transform>");
    expectNear(glm::dvec3(glm::inverse(s.drawn.eyeFromWorld)[2]), {1, 0, 0});
    EXPECT_NEAR(eyeOf(s.drawn).y, 9.0, 1e-6);
    EXPECT_NEAR(eyeOf(s.drawn).x, std::sqrt(0.75) / std::sin(0.785398 / 2.0), 1e-5);
    EXPECT_LE(std::abs(inPicture(s.drawn, {0.5, 9.5, 0.5}).y), 1.0);
}

TEST(StyledView, viewAllGoesByTheNarrowerSide)
{
    ViewedScene s("<Viewpoint viewAll='true' fieldOfView='0.6'/>" + kVolume);
    for (const auto& [width, height] : {std::pair(200, 100), std::pair(100, 200), std::pair(100, 100)})
        EXPECT_NEAR(eyeOf(drawnAt(s, width, height)).z, std::sqrt(0.75) / std::sin(0.3), 1e-5)
            << width << " x " << height;
}

TEST(StyledView, nearAndFarPlanesHoldAllThatIsBeforeTheEye)
{
    const ViewedScene s("<Viewpoint position='0 0 3'/><Transform translation='0 0 -1000'>" + kVolume +
                        "</Transform>" + kVolume);
    EXPECT_GT(inPicture(s.drawn, {0, 0, 0.5}).z, -1.0);
    EXPECT_LT(inPicture(s.drawn, {0, 0, -1000.5}).z, 1.0);
    const ViewedScene near("<Viewpoint position='0 0 3'/>" + kVolume);
    EXPECT_LT(inPicture(near.drawn, {0, 0, 0.55}).z, -1.0) << "no farther before it than needed";
    EXPECT_GT(inPicture(near.drawn, {0, 0, -0.55}).z, 1.0) << "nor behind it";
}

TEST(StyledView, whatIsSmallAndNearIsNotCutByWhatIsLargeAndFar)
{
    const ViewedScene s("<Viewpoint position='0 0 3'/>" + kVolume +
                        "<Transform translation='0 -1000000 0' scale='2000000 1 2000000'>" + kVolume +
                        "</Transform>");
    EXPECT_GT(inPicture(s.drawn, {0, 0, 0.5}).z, -1.0);
    EXPECT_LT(inPicture(s.drawn, {0, -1e6, -1e6}).z, 1.0);
    // What is beside the view moves no plane.
    const ViewedScene beside("<Viewpoint position='0 0 1000'/>" + kVolume +
                             "<Transform translation='900 0 999.9'>" + kVolume + "</Transform>");
    EXPECT_NEAR(inPicture(beside.drawn, {0, 0, 0.6}).z, -1.0, 0.5);
}

TEST(StyledView, nearPlaneIsAThousandthOfItsOwnDepthAndAMillionthOfAll)
{
    // Its depth is 1/2, and a hundredth of its diagonal.
    const ViewedScene within("<Viewpoint position='0 0 0'/>" + kVolume);
    const double thousandth = (0.5 + 0.01 * std::sqrt(3.0)) * 1e-3;
    EXPECT_GT(inPicture(within.drawn, {0, 0, -1.01 * thousandth}).z, -1.0);
    EXPECT_LT(inPicture(within.drawn, {0, 0, -0.99 * thousandth}).z, -1.0);
    const ViewedScene large("<Viewpoint position='0 0 0'/><Transform translation='0 0 -0.1' scale='0.01 0.01 "
                            "0.01'>" +
                            kVolume + "</Transform><Transform translation='0 0 -1000000'>" + kVolume +
                            "</Transform>");
    // Depths are 1e6, and a hundredth of that.
    EXPECT_GT(inPicture(large.drawn, {0, 0, -1.02}).z, -1.0);
    EXPECT_LT(inPicture(large.drawn, {0, 0, -1.0}).z, -1.0);
}

TEST(StyledView, depthsThatAViewpointGivesAreThosePlanes)
{
    // The volume is 9.5 to 10.5 away.
    const auto depthAt = [](const std::string& fields, double depth) {
        return inPicture(ViewedScene("<Viewpoint position='0 0 10' " + fields + "/>" + kVolume).drawn,
                         {0, 0, 10 - depth})
            .z;
    };
    EXPECT_NEAR(depthAt("farDistance='2'", 2.0), 1.0, 1e-9);
    EXPECT_NEAR(depthAt("farDistance='2'", 1.0), -1.0, 1e-9) << "before all that is seen";
    EXPECT_NEAR(depthAt("farDistance='40'", 40.0), 1.0, 1e-9);
    EXPECT_GT(depthAt("farDistance='40'", 9.5), -1.0);
    EXPECT_LT(depthAt("farDistance='40'", 9.4), -1.0);
    EXPECT_NEAR(depthAt("nearDistance='50'", 50.0), -1.0, 1e-9);
    EXPECT_NEAR(depthAt("nearDistance='50'", 100.0), 1.0, 1e-9);
    EXPECT_NEAR(depthAt("nearDistance='3'", 3.0), -1.0, 1e-9);
    EXPECT_LT(depthAt("nearDistance='3'", 10.5), 1.0);
    EXPECT_GT(depthAt("nearDistance='3'", 10.6), 1.0);
    EXPECT_NEAR(depthAt("nearDistance='3' farDistance='8'", 3.0), -1.0, 1e-9);
    EXPECT_NEAR(depthAt("nearDistance='3' farDistance='8'", 8.0), 1.0, 1e-9);
    EXPECT_NEAR(depthAt("nearDistance='9' farDistance='9.5'", 9.0), -1.0, 1e-9);
    EXPECT_NEAR(depthAt("nearDistance='9' farDistance='9.5'", 9.5), 1.0, 1e-9);
}

TEST(StyledView, headlightShinesFromTheEye)
{
    const std::string viewpoint = "<Viewpoint position='5 0 0' orientation='0 1 0 1.5707963'/>";
    ViewedScene s(viewpoint + "<Transform rotation='0 0 1 1.5707963' scale='3 3 3'>" + kVolume +
                  "</Transform>");
    ASSERT_EQ(lightsOf(s).size(), 1u);
    EXPECT_EQ(lightsOf(s)[0].kind, StyleLight::Kind::directional);
    expectNear(glm::dvec3(lightsOf(s)[0].direction), {0, 1, 0});
    ViewRequest request;
    request.headlight = false;
    s.draw(request);
    EXPECT_TRUE(lightsOf(s).empty());
    EXPECT_TRUE(lightsOf(ViewedScene(kDark + viewpoint + kVolume)).empty());
}

TEST(StyledView, directionalLightsShineOnTheirGroupAlone)
{
    const ViewedScene s(kDark + "<Group>" + kVolume + "<Transform rotation='0 1 0 1.5707963'><Group>" +
                        kVolume +
                        "</Group></Transform><DirectionalLight direction='1 0 0' intensity='0.5'/></Group>" +
                        kVolume + "<Group>" + kVolume + "<DirectionalLight on='false'/></Group>");
    ASSERT_EQ(s.drawn.volumes.size(), 4u);
    ASSERT_EQ(lightsOf(s, 0).size(), 1u);
    ASSERT_EQ(lightsOf(s, 1).size(), 1u);
    EXPECT_EQ(lightsOf(s, 0)[0].intensity, 0.5f);
    expectNear(glm::dvec3(lightsOf(s, 0)[0].direction), {1, 0, 0});
    expectNear(glm::dvec3(lightsOf(s, 1)[0].direction), {0, 0, 1});
    EXPECT_TRUE(lightsOf(s, 2).empty());
    EXPECT_TRUE(lightsOf(s, 3).empty());
}

TEST(StyledView, pointAndSpotLightsShineEverywhereInLocalSpace)
{
    const ViewedScene s(kDark +
                        "<Transform translation='0 0 8'>"
                        "<PointLight location='1 0 0' radius='12' attenuation='1 2 3'/>"
                        "<SpotLight direction='0 0 -2' beamWidth='0.25' cutOffAngle='0.5'/></Transform>"
                        "<Transform translation='1 0 0' scale='4 4 4'>" +
                        kVolume + "</Transform>");
    const auto& lights = lightsOf(s);
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0].kind, StyleLight::Kind::point);
    expectNear(glm::dvec3(lights[0].position), {0, 0, 2});
    EXPECT_NEAR(lights[0].radius, 3.0f, 1e-6);
    // A length of 1 here is one of 4 in the world.
    expectNear(glm::dvec3(lights[0].attenuation), {1, 8, 48}, 1e-4);
    EXPECT_EQ(lights[1].kind, StyleLight::Kind::spot);
    expectNear(glm::dvec3(lights[1].direction), {0, 0, -1});
    EXPECT_EQ(lights[1].beamWidth, 0.25f);
    EXPECT_EQ(lights[1].cutOffAngle, 0.5f);
}

TEST(StyledView, lightsWithoutDirectionShineAlongTheirOwnAxis)
{
    const ViewedScene s(kDark +
                        "<Transform rotation='0 1 0 1.5707963'>"
                        "<DirectionalLight direction='0 0 0' global='true'/></Transform>"
                        "<Transform scale='1 0 1'><DirectionalLight direction='0 -1 0' global='true'/>"
                        "</Transform><Transform rotation='1 0 0 1.5707963' scale='2 2 2'>" +
                        kVolume + "</Transform>");
    const auto& lights = lightsOf(s);
    ASSERT_EQ(lights.size(), 2u);
    expectNear(glm::dvec3(lights[0].direction), {-1, 0, 0});
    EXPECT_NEAR(glm::length(lights[1].direction), 1.0f, 1e-6f) << "of a Transform without extent";
}

TEST(StyledView, globalDecidesAboutTheScopeOfLights)
{
    const ViewedScene s(
        kDark + "<Group><PointLight global='false'/><DirectionalLight global='true'/></Group>" + kVolume);
    ASSERT_EQ(lightsOf(s).size(), 1u);
    EXPECT_EQ(lightsOf(s)[0].kind, StyleLight::Kind::directional);
}

TEST(StyledView, lightsBeyondEightAreToldOf)
{
    std::string lights;
    for (int i = 0; i < 9; ++i)
        lights += "<PointLight/>";
    const ViewedScene s(lights + "\n" + kVolume + "<Shape><Box/></Shape>");
    ASSERT_EQ(lightsOf(s).size(), 8u);
    EXPECT_EQ(lightsOf(s)[0].kind, StyleLight::Kind::directional);
    const std::string told = "s.x3d:3: warning: expected at most 8 lights, found 10: the first shine on it\n";
    EXPECT_EQ(s.messages(), told + told) << "of the volume and of the shape";
}

TEST(StyledView, clipPlanesCutTheirGroupAlone)
{
    const ViewedScene s("<Transform translation='2 0 0'><ClipPlane plane='1 0 0 0.5'/>" + kVolume +
                        "<Transform scale='3 3 3'><Shape><Box/></Shape></Transform>"
                        "<ClipPlane enabled='false'/></Transform>" +
                        kVolume);
    ASSERT_EQ(s.drawn.volumes.size(), 2u);
    ASSERT_EQ(s.drawn.volumes[0].clipPlanes.size(), 1u);
    // x' + 1/2 >= 0 with x' = x - 2.
    const glm::dvec4 plane = s.drawn.volumes[0].clipPlanes[0];
    expectNear(glm::dvec3(plane), {1, 0, 0});
    EXPECT_NEAR(plane.w, -1.5, 1e-9);
    EXPECT_EQ(s.drawn.surfaces.at(0).clipPlanes.size(), 1u);
    EXPECT_TRUE(s.drawn.volumes[1].clipPlanes.empty());
}

TEST(StyledView, switchShowsItsChoice)
{
    const auto shownBy = [](const std::string& choice) {
        const ViewedScene s("<Switch whichChoice='" + choice + "'>" + kVolume +
                            "<Shape><Box/></Shape></Switch>");
        return std::pair(s.drawn.volumes.size(), s.drawn.surfaces.size());
    };
    EXPECT_EQ(shownBy("-1"), std::pair(0ul, 0ul));
    EXPECT_EQ(shownBy("0"), std::pair(1ul, 0ul));
    EXPECT_EQ(shownBy("1"), std::pair(0ul, 1ul));
    EXPECT_EQ(shownBy("2"), std::pair(0ul, 0ul));
}

TEST(StyledView, levelOfDetailGoesByTheEyesDistanceInLocalSpace)
{
    ViewedScene s("<Viewpoint DEF='V'/><Transform scale='2 2 2'><LOD DEF='L' center='0 0 1' range='1 3'>" +
                  kVolume + "<Shape><Box/></Shape><Group/></LOD></Transform>");
    const auto levelAt = [&](double z) {
        drawnFrom(s, {0, 0, z});
        return s.view->shownLevels().at(0).level;
    };
    EXPECT_EQ(levelAt(3.9), 0);
    EXPECT_EQ(s.drawn.volumes.size(), 1u);
    EXPECT_EQ(levelAt(4.1), 1);
    EXPECT_EQ(s.drawn.surfaces.size(), 1u);
    EXPECT_EQ(levelAt(7.9), 1);
    EXPECT_EQ(levelAt(8.1), 2);
    EXPECT_EQ(levelAt(0.1), 0);
    EXPECT_EQ(s.view->shownLevels().at(0).node, s.scene.names.at("L"));
}

TEST(StyledView, levelsBeyondTheLastChildAreTheLastChild)
{
    const ViewedScene s("<Viewpoint position='0 0 100'/><LOD range='1 2 3'>" + kVolume +
                        "<Shape><Box/></Shape></LOD>");
    EXPECT_EQ(s.view->shownLevels().at(0).level, 1);
    EXPECT_EQ(s.drawn.surfaces.size(), 1u);
    const ViewedScene empty("<Viewpoint position='0 0 100'/><LOD range='1 2 3'/>");
    EXPECT_TRUE(empty.drawn.volumes.empty());
}

TEST(StyledView, octTreeShowsHighResWithinItsRange)
{
    std::string highRes;
    for (int i = 0; i < 9; ++i)
        highRes += "<VolumeData containerField='highRes'>" + kVoxels + "</VolumeData>";
    ViewedScene s("<Viewpoint position='0 0 10'/><OctTree range='9' center='0 0 1.5'>" + highRes +
                      "<VolumeData containerField='lowRes'>" + kVoxels + "</VolumeData></OctTree>",
                  "3.0");
    EXPECT_EQ(s.view->shownLevels().at(0).level, 0);
    EXPECT_EQ(s.drawn.volumes.size(), 8u);
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: expected at most 8 nodes in OctTree.highRes, found 9: the first are "
              "drawn\n");
    EXPECT_EQ(drawnFrom(s, {0, 0, 11}).volumes.size(), 1u);
    EXPECT_EQ(s.view->shownLevels().at(0).level, 1);
}

TEST(StyledView, whatIsNotVisibleIsNotDrawn)
{
    const ViewedScene s("<Group visible='false'>" + kVolume + "</Group><VolumeData visible='false'>" +
                        kVoxels + "</VolumeData><Shape visible='false'><Box/></Shape>" + kVolume);
    EXPECT_EQ(s.drawn.volumes.size(), 1u);
    EXPECT_TRUE(s.drawn.surfaces.empty());
}

TEST(StyledView, allKindsOfGroupsShowTheirChildren)
{
    for (const std::string group : {"Group", "StaticGroup", "Anchor", "Collision"}) {
        const ViewedScene s("<" + group + "><ClipPlane/>" + kVolume + "</" + group + "><" + group +
                            " visible='false'>" + kVolume + "</" + group + ">");
        EXPECT_EQ(s.drawn.volumes.size(), 1u) << group;
        EXPECT_EQ(s.drawn.volumes.at(0).clipPlanes.size(), 1u) << group;
        EXPECT_EQ(s.messages(), "") << group;
    }
    // What stands for the children in collisions is not seen.
    const ViewedScene s("<Collision enabled='false'><VolumeData containerField='proxy'>" + kVoxels +
                        "</VolumeData></Collision>");
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_EQ(s.messages(), "");
}

TEST(StyledView, idsLeadToNodesAndTheirPaths)
{
    const ViewedScene s("<Group DEF='G'><VolumeData DEF='V'>" + kVoxels +
                        "</VolumeData></Group><Transform DEF='T'><VolumeData USE='V'/></Transform>"
                        "<Shape DEF='S'><Box/></Shape>");
    ASSERT_EQ(s.drawn.volumes.size(), 2u);
    const auto& names = s.scene.names;
    EXPECT_EQ(s.view->nodeOf(s.drawn.volumes[1].id), names.at("V"));
    EXPECT_EQ(s.view->pathOf(s.drawn.volumes[0].id),
              (std::vector<const Node*>{names.at("G"), names.at("V")}));
    EXPECT_EQ(s.view->pathOf(s.drawn.volumes[1].id),
              (std::vector<const Node*>{names.at("T"), names.at("V")}));
    EXPECT_EQ(s.view->nodeOf(s.drawn.surfaces.at(0).id), names.at("S"));
    EXPECT_EQ(s.view->nodeOf(0), nullptr);
    EXPECT_EQ(s.view->nodeOf(99), nullptr);
    EXPECT_TRUE(s.view->pathOf(99).empty());
}

TEST(StyledView, oneNodeInSeveralPlacesHasOneTexture)
{
    ViewedScene s("<VolumeData DEF='V'><PixelTexture3D DEF='P' image='1 1 1 1 7'/></VolumeData>"
                  "<Transform><VolumeData USE='V'/></Transform>");
    ASSERT_EQ(s.drawn.volumes.size(), 2u);
    const auto texture = s.drawn.volumes[0].voxels;
    EXPECT_EQ(s.drawn.volumes[1].voxels, texture);
    EXPECT_EQ(s.draw().volumes[0].voxels, texture);
    Node& pixels = *s.scene.names.at("P");
    pixels.put(pixels.field("image")->slot, std::vector<std::int32_t>{1, 1, 1, 1, 8});
    EXPECT_EQ(s.draw().volumes[0].voxels->texels.at(0), std::byte{8});
}

TEST(StyledView, inlinesAreDrawnAndTheirBindablesAreNotBound)
{
    const ScratchFolder folder;
    std::ofstream(folder / "part.x3d")
        << "<X3D version='4.0'><Scene><Viewpoint position='0 0 77'/>" << kVolume << "</Scene></X3D>";
    const ViewedScene s("<Transform translation='5 0 0'><Inline url='\"part.x3d\"'/></Transform>"
                        "<Viewpoint position='0 0 3'/><Inline load='false' url='\"part.x3d\"'/>",
                        "4.0", folder / "");
    ASSERT_EQ(s.drawn.volumes.size(), 1u);
    EXPECT_EQ(s.drawn.volumes[0].worldFromLocal[3].x, 5.0);
    EXPECT_NEAR(eyeOf(s.drawn).z, 3.0, 1e-9);
    EXPECT_EQ(s.view->viewpoints().size(), 2u);
    EXPECT_EQ(s.view->pathOf(1).size(), 3u);
}

TEST(StyledView, backgroundGivesTheSky)
{
    const ViewedScene s("<Transform rotation='0 0 1 1.5707963' scale='2 3 4'><Background skyAngle='1 2' "
                        "skyColor='1 0 0 0 1 0 0 0 1' groundAngle='0.5' groundColor='0 0 0 1 1 1' "
                        "transparency='0.25'/></Transform><Background/>");
    const SkyColors& sky = s.drawn.background;
    EXPECT_EQ(sky.skyAngles, (std::vector<float>{1, 2}));
    ASSERT_EQ(sky.sky.size(), 3u);
    EXPECT_EQ(sky.sky[2], glm::vec3(0, 0, 1));
    EXPECT_EQ(sky.groundAngles, std::vector<float>{0.5f});
    EXPECT_EQ(sky.ground.size(), 2u);
    EXPECT_EQ(sky.opacity, 0.75f);
    expectNear(sky.worldFromBackground * glm::dvec3(1, 0, 0), {0, 1, 0});
    EXPECT_EQ(s.messages(), "");
}

TEST(StyledView, backgroundsOfWrongLengthsAreRepaired)
{
    const ViewedScene s("<Background skyAngle='1 0.5' skyColor='1 0 0 0 1 0 0 0 1' frontUrl='\"a.png\"'/>");
    EXPECT_EQ(s.drawn.background.skyAngles.size(), 1u);
    EXPECT_EQ(s.drawn.background.sky.size(), 2u);
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: expected rising angles in Background.skyAngle, one fewer than colours, "
              "found 2 for 3: what fits is drawn\n"
              "s.x3d:2: warning: Background.frontUrl: pictures of the sky are not drawn\n");
}

TEST(StyledView, collapsedTransformsAreToldOfOnce)
{
    ViewedScene s("<Transform scale='1 0 1'>\n" + kVolume + "<ClipPlane/><DirectionalLight/></Transform>");
    s.draw();
    EXPECT_TRUE(s.drawn.volumes.empty());
    EXPECT_EQ(s.messages(), "s.x3d:2: warning: Transform.scale: expected numbers other than 0, found 1 0 1: "
                            "nothing in it is drawn\n");
}

/// 2^24 places of a node.
std::string inManyPlaces(const std::string& node)
{
    std::string nodes = "<Group DEF='G0'>" + node + "</Group>";
    for (int level = 1; level <= 24; ++level) {
        const std::string before = "<Group USE='G" + std::to_string(level - 1) + "'/>";
        nodes += "<Group DEF='G" + std::to_string(level) + "'>" + before + before + "</Group>";
    }
    return nodes;
}

TEST(StyledView, nodesInTooManyPlacesAreCutOff)
{
    const ViewedScene s(inManyPlaces("<Shape><Box/></Shape>"));
    EXPECT_LE(s.drawn.surfaces.size(), 100'000u);
    EXPECT_NE(s.messages().find("expected at most 100000 shapes and volumes in all places, found more"),
              std::string::npos);
}

TEST(StyledView, volumesInTooManyPlacesAreCutOff)
{
    const ViewedScene s(inManyPlaces(kVolume));
    EXPECT_EQ(s.drawn.volumes.size(), 512u);
    EXPECT_NE(s.messages().find("expected at most 512 volumes in all places, found more"), std::string::npos);
}

TEST(StyledView, nodesBelowThemselvesEnd)
{
    ViewedScene s("<Group DEF='G'>" + kVolume + "</Group>");
    Node& group = *s.scene.names.at("G");
    const auto slot = group.field("children")->slot;
    auto children = std::get<std::vector<Node*>>(group.value(slot));
    children.push_back(&group);
    group.put(slot, children);
    s.draw();
    EXPECT_LE(s.drawn.volumes.size(), 512u);
    EXPECT_NE(s.messages().find("expected nodes at most 500 deep, found more"), std::string::npos);
}

TEST(StyledView, blendedVoxelsHaveTheGradientOfTheVolumesBox)
{
    const ViewedScene s("<VolumeData dimensions='1 1 8'>" + kVoxels +
                        "<BlendedVolumeStyle weightConstant1='0' weightConstant2='1'>"
                        "<BoundaryEnhancementVolumeStyle retainedOpacity='0' boundaryOpacity='1' "
                        "opacityFactor='1'/><PixelTexture3D image='1 1 1 3 0 102 255'/>"
                        "</BlendedVolumeStyle></VolumeData>");
    ASSERT_EQ(s.drawn.volumes.size(), 1u) << s.messages();
    SampleBatch samples{};
    samples.count = 1;
    for (BatchFloats& coordinate : samples.place)
        coordinate[0] = 0.5f;
    ASSERT_EQ(s.drawn.volumes[0].chains[0].size(), 1u);
    s.drawn.volumes[0].chains[0][0]->apply({}, samples);
    // From 0 to 1 over two voxels of 8/3; the shortest edge is 1.
    EXPECT_NEAR(samples.Ov[0], 0.4 * 0.5 / (8.0 / 3.0), 1e-6);
}

} // namespace
} // namespace vo
