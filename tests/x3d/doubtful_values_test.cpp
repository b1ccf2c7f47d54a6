// Values that their fields allow and that make no sense: what is told of them, by a picture and by a check.

#include <gtest/gtest.h>

#include "../util/scratch_folder.h"
#include "view_scene.h"
#include "x3d/check_scene.h"
#include "x3d/scene_events.h"

#include <limits>
#include <ostream>

namespace vo {
namespace {

const std::string kVoxels =
    "<PixelTexture3D containerField='voxels' image='1 2 2 2 0 255 0 255 0 255 0 255'/>";

std::string volume(const std::string& style = "", const std::string& name = "VolumeData")
{
    return "<" + name + ">" + kVoxels + style + "</" + name + ">";
}

std::string isoVolume(const std::string& attributes)
{
    return "<IsoSurfaceVolumeData " + attributes + ">" + kVoxels + "</IsoSurfaceVolumeData>";
}

/// What is told of a scene whose nodes begin in line 2.
struct Case
{
    std::string nodes;
    std::string told; ///< behind "s.x3d:2: warning: "; "" for nothing
    std::string version = "4.0";
};

void PrintTo(const Case& each, std::ostream* stream)
{
    *stream << each.nodes;
}

std::string checked(const Case& each)
{
    Scene scene;
    readSceneText(
        scene, "<X3D profile='Full' version='" + each.version + "'><Scene>\n" + each.nodes + "</Scene></X3D>",
        "s.x3d");
    checkView(scene);
    checkScene(scene);
    std::string lines;
    for (const SceneMessage& message : scene.messages)
        lines += messageLine(message) + "\n";
    return lines;
}

class DoubtfulValue : public testing::TestWithParam<Case>
{
};

TEST_P(DoubtfulValue, isToldOfByAPictureAndByACheck)
{
    const Case& each = GetParam();
    const std::string line = each.told.empty() ? "" : "s.x3d:2: warning: " + each.told + "\n";
    ViewedScene seen(each.nodes, each.version);
    seen.draw();
    EXPECT_EQ(seen.messages(), line);
    EXPECT_EQ(checked(each), line);
}

INSTANTIATE_TEST_SUITE_P(
    Pixels, DoubtfulValue,
    testing::Values(
        Case{
            "<VolumeData><PixelTexture3D containerField='voxels' image='1 2 1 1 255 256'/></VolumeData>",
            "PixelTexture3D.image: expected pixels from 0 to 255 for 1 component, found 256: higher bits are "
            "left out"},
        Case{"<VolumeData><PixelTexture3D containerField='voxels' image='1 2 1 1 255 -1'/></VolumeData>",
             "PixelTexture3D.image: expected pixels from 0 to 255 for 1 component, found -1: higher bits are "
             "left out"},
        Case{"<VolumeData><PixelTexture3D containerField='voxels' image='3 1 1 1 0x1FFFFFF'/></VolumeData>",
             "PixelTexture3D.image: expected pixels from 0 to 16777215 for 3 components, found 33554431: "
             "higher "
             "bits are left out"},
        Case{"<VolumeData><PixelTexture3D containerField='voxels' image='4 1 1 1 -1'/></VolumeData>", ""},
        Case{"<VolumeData><PixelTexture3D containerField='voxels' image='2 1 1 1 0xFFFF'/></VolumeData>",
             ""}));

INSTANTIATE_TEST_SUITE_P(
    Voxels, DoubtfulValue,
    testing::Values(
        Case{isoVolume("surfaceValues='1.5'"),
             "IsoSurfaceVolumeData.surfaceValues: expected numbers in [0,1], the range of voxels, found 1.5: "
             "has no surface"},
        Case{isoVolume("surfaceValues='0.5 -0.25'"),
             "IsoSurfaceVolumeData.surfaceValues: expected numbers "
             "in [0,1], the range of voxels, found -0.25: has no surface"},
        Case{isoVolume("surfaceValues='0 1 0.5'"), ""},
        Case{isoVolume(""),
             "IsoSurfaceVolumeData.surfaceValues: expected the value of a surface, found none: "
             "nothing is drawn"},
        Case{
            volume("<ProjectionVolumeStyle intensityThreshold='1.5'/>"),
            "ProjectionVolumeStyle.intensityThreshold: expected numbers in [0,1], the range of voxels, found "
            "1.5: taken as 0"},
        Case{
            volume("<ProjectionVolumeStyle type='MIN' intensityThreshold='2'/>"),
            "ProjectionVolumeStyle.intensityThreshold: expected numbers in [0,1], the range of voxels, found "
            "2: taken as 1"},
        Case{
            volume("<ProjectionVolumeStyle type='AVERAGE' intensityThreshold='2'/>"),
            "ProjectionVolumeStyle.intensityThreshold: expected numbers in [0,1], the range of voxels, found "
            "2: changes nothing"},
        Case{volume("<ProjectionVolumeStyle intensityThreshold='1'/>"), ""},
        Case{"<VolumeData/>", "VolumeData has no voxels: not drawn"}));

/// What was refused is not missing a second time.
TEST(DoubtfulValues, valuesThatWereRefusedAreToldOfOnce)
{
    const auto expectOne = [](const std::string& nodes, const std::string& told, const std::string& version) {
        EXPECT_EQ(ViewedScene(nodes, version).messages(), "s.x3d:2: error: " + told + "\n");
        EXPECT_EQ(checked({nodes, "", version}), "s.x3d:2: error: " + told + "\n");
    };
    expectOne("<VolumeData><PixelTexture containerField='voxels' image='1 1 1 7'/></VolumeData>",
              "VolumeData.voxels: expected X3DTexture3DNode, found PixelTexture", "4.0");
    const std::string texture = "<PixelTexture3D containerField='voxels' image='1 1 1 1 7'/>";
    expectOne("<VolumeData>" + texture + texture + "</VolumeData>",
              "VolumeData.voxels: expected one node, found 2: none is kept", "4.0");
    expectOne(
        "<IsoSurfaceVolumeData surfaceValues='nothing'><PixelTexture3D containerField='voxels' image='1 1 1 "
        "1 7'/></IsoSurfaceVolumeData>",
        "IsoSurfaceVolumeData.surfaceValues: expected a number, found \"nothing\"", "4.0");
}

TEST(DoubtfulValues, whyNothingIsSeenHasATopicOfItsOwn)
{
    const auto topicsOf = [](const std::string& nodes) {
        std::vector<MessageTopic> topics;
        for (const SceneMessage& message : ViewedScene(nodes).scene.messages)
            topics.push_back(message.topic);
        return topics;
    };
    using Topics = std::vector<MessageTopic>;
    EXPECT_EQ(topicsOf(isoVolume("surfaceValues='1.5'")), Topics{MessageTopic::nothingSeen});
    EXPECT_EQ(topicsOf(isoVolume("")), Topics{MessageTopic::nothingSeen});
    EXPECT_EQ(
        topicsOf("<VolumeData><PixelTexture3D containerField='voxels' image='1 1 1 1 0'/></VolumeData>"),
        Topics{MessageTopic::nothingSeen});
    EXPECT_EQ(topicsOf(volume("<ProjectionVolumeStyle intensityThreshold='1.5'/>")),
              Topics{MessageTopic::other});
    EXPECT_EQ(topicsOf("<Transform scale='0 1 1'/>"), Topics{MessageTopic::other});
}

INSTANTIATE_TEST_SUITE_P(
    Lists, DoubtfulValue,
    testing::Values(
        Case{"<ScalarInterpolator key='0 0.5 0.25 1' keyValue='0 1 2 3'/>",
             "ScalarInterpolator.key: expected numbers that do not fall, found 0.25 behind 0.5: what follows "
             "is "
             "left out"},
        Case{"<ScalarInterpolator key='0 0.5 0.5 1' keyValue='0 1 2 3'/>", ""},
        Case{"<ScalarInterpolator/>", ""},
        Case{"<PositionInterpolator key='0 0.5 1' keyValue='0 0 0 1 1 1'/>",
             "PositionInterpolator.keyValue: expected as many values as keys, found 2 for 3: what is over is "
             "left out"},
        Case{"<ColorInterpolator keyValue='0 0 0 1 1 1'/>",
             "ColorInterpolator.keyValue: expected as many values as keys, found 2 for 0: sends nothing"},
        Case{"<OrientationInterpolator key='0 1' keyValue='0 0 1 0 0 0 0 2'/>",
             "OrientationInterpolator.keyValue: expected an axis other than 0 0 0, found 0 0 0 2: turns "
             "nothing"},
        Case{"<LOD range='10 5'><Group/><Group/><Group/></LOD>",
             "LOD.range: expected distances that do not fall, found 5 behind 10: its level is not seen"},
        Case{"<LOD range='10'><Group/><Group/><Group/></LOD>",
             "LOD.children: expected at most one more than distances in range, found 3 for 1: the last are "
             "not "
             "seen"},
        Case{"<LOD range='10 20 30'><Group/><Group/></LOD>", ""},
        Case{"<Inline/>", "Inline: expected a url, found none: nothing is drawn of it"},
        Case{"<Inline load='false'/>", ""}, Case{"<Anchor url='\"of-a-link.html\"'/>", ""},
        Case{"<Switch whichChoice='1'><Group/></Switch>", "Switch.whichChoice: expected the number of one of "
                                                          "its 1 children, from 0, or -1, found 1: none is "
                                                          "drawn"},
        Case{"<Switch whichChoice='0'><Group/></Switch><Switch><Group/></Switch>", ""},
        Case{"<Background skyAngle='2 1' skyColor='1 0 0 0 1 0 0 0 1'/>",
             "expected rising angles in Background.skyAngle, one fewer than colours, found 2 for 3: what "
             "fits is "
             "drawn"}));

INSTANTIATE_TEST_SUITE_P(
    Cameras, DoubtfulValue,
    testing::Values(
        Case{"<OrthoViewpoint fieldOfView='1 1 -1 -1'/>",
             "OrthoViewpoint.fieldOfView: expected minimum x, minimum y, and a maximum x and y above them, "
             "found "
             "1 1 -1 -1: taken as -1 -1 1 1"},
        Case{"<OrthoViewpoint fieldOfView='-1 0 1 0'/>", "OrthoViewpoint.fieldOfView: expected minimum x, "
                                                         "minimum y, and a maximum x and y above them, found "
                                                         "-1 0 1 0: taken as -1 -1 1 1"},
        Case{"<OrthoViewpoint fieldOfView='1 1 -1'/>",
             "OrthoViewpoint.fieldOfView: expected 4 numbers, found 3: taken as -1 -1 1 1", "3.3"},
        Case{"<OrthoViewpoint fieldOfView='-2 -1 2 1'/>", ""},
        Case{"<Viewpoint nearDistance='10' farDistance='1'/>",
             "Viewpoint.nearDistance: expected less than farDistance, found 10 and 1: seen from 10 to 20"},
        Case{"<Viewpoint nearDistance='1' farDistance='10'/>", ""},
        Case{"<Viewpoint nearDistance='10'/>", ""},
        Case{"<Viewpoint orientation='0 0 0 1'/>",
             "Viewpoint.orientation: expected an axis other than 0 0 0, found 0 0 0 1: turns nothing"}));

INSTANTIATE_TEST_SUITE_P(
    Directions, DoubtfulValue,
    testing::Values(
        Case{"<Transform rotation='0 0 0 1'/>",
             "Transform.rotation: expected an axis other than 0 0 0, found 0 0 0 1: turns nothing"},
        Case{"<Transform rotation='0 0 0 0'/>", ""},
        Case{"<Transform scaleOrientation='0 0 0 -2'/>",
             "Transform.scaleOrientation: expected an axis other than 0 0 0, found 0 0 0 -2: turns nothing"},
        Case{"<Transform scale='2 0 1'/>",
             "Transform.scale: expected numbers other than 0, found 2 0 1: nothing in it is drawn"},
        Case{"<Transform scale='0 1 1'>" + volume() + "</Transform>",
             "Transform.scale: expected numbers other than 0, found 0 1 1: nothing in it is drawn"},
        Case{"<Transform scale='1 0 1'><Transform><Shape><Box/></Shape></Transform></Transform>",
             "Transform.scale: expected numbers other than 0, found 1 0 1: nothing in it is drawn"},
        Case{"<Transform scale='-1 2 1'/>", ""},
        Case{"<DirectionalLight direction='0 0 0'/>", "DirectionalLight.direction: expected a direction "
                                                      "other than 0 0 0, found 0 0 0: taken as 0 0 -1"},
        Case{"<SpotLight direction='0 0 0'/>",
             "SpotLight.direction: expected a direction other than 0 0 0, found 0 0 0: taken as 0 0 -1"},
        Case{"<PointLight/>", ""},
        Case{"<ClipPlane plane='0 0 0 -1'/>",
             "ClipPlane.plane: expected a normal other than 0 0 0, found 0 0 0 -1: cuts all away"},
        Case{"<ClipPlane plane='0 0 0 1'/>",
             "ClipPlane.plane: expected a normal other than 0 0 0, found 0 0 0 1: cuts nothing away"}));

std::string scaled(const std::string& scale, int times, const std::string& nodes)
{
    std::string text = nodes;
    for (int i = 0; i < times; ++i)
        text = "<Transform scale='" + scale + " " + scale + " " + scale + "'>" + text + "</Transform>";
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, DoubtfulValue,
    testing::Values(
        Case{scaled("1e38", 1, volume()),
             "VolumeData in its Transforms: expected coordinates in the world up to "
             "1e+15, found 5e+37: not drawn"},
        Case{scaled("1e38", 3, volume()),
             "VolumeData stands in Transforms whose scales no number can hold: not drawn"},
        Case{scaled("1e-30", 1, volume()),
             "VolumeData in its Transforms: expected a size in the world from 1e-15 "
             "on, found 1.73e-30: not drawn"},
        Case{
            scaled("1e38", 1, "<Shape><Box/></Shape>"),
            "Shape in its Transforms: expected coordinates in the world up to 1e+15, found 1e+38: not drawn"},
        Case{"<Transform translation='1e38 0 0'>" + volume() + "</Transform>",
             "VolumeData in its Transforms: expected coordinates in the world up to 1e+15, found 1e+38: not "
             "drawn"},
        Case{scaled("1e14", 1, volume()), ""}, Case{scaled("1e-14", 1, volume()), ""},
        // What one scale takes away another gives back.
        Case{scaled("1e30", 1, scaled("1e-30", 1, volume())), ""}));

TEST(DoubtfulValues, limitsOfDrawingAreCheckedToo)
{
    std::string places = "<Group DEF='G'>" + volume() + "</Group>";
    for (int i = 0; i < 512; ++i)
        places += "<Group USE='G'/>";
    EXPECT_EQ(
        checked({places, "", "4.0"}),
        "s.x3d:2: error: expected at most 512 volumes in all places, found more: from here on they are left "
        "out\n");
    std::string groups = "<Group DEF='D1'/>";
    for (int i = 2; i <= 21; ++i) {
        const std::string before = "<Group USE='D" + std::to_string(i - 1) + "'/>";
        groups += "<Group DEF='D" + std::to_string(i) + "'>" + before + before + "</Group>";
    }
    EXPECT_EQ(checked({groups, "", "4.0"}), "s.x3d:2: error: expected nodes in at most 1000000 places, found "
                                            "more: from here on they are left out\n");
}

TEST(DoubtfulValues, whatOtherChoicesShowIsCheckedToo)
{
    EXPECT_EQ(checked({"<Switch><VolumeData/></Switch>", "", "4.0"}),
              "s.x3d:2: warning: VolumeData has no voxels: not drawn\n");
}

TEST(DoubtfulValues, aCheckReadsNoVoxels)
{
    const ScratchFolder folder;
    // NaN alone, which the file does not say before its voxels.
    std::ofstream(folder / "v.nrrd")
        << "NRRD0004\ntype: float\ndimension: 3\nsizes: 1 1 1\nendian: little\nencoding: raw\n\n"
        << "\xff\xff\xff\x7f";
    const std::string nodes = "<VolumeData>\n<ImageTexture3D url='\"v.nrrd\"'/></VolumeData>";
    ViewedScene seen(nodes, "4.0", folder / "");
    EXPECT_EQ(seen.scene.errorCount(), 1u) << seen.messages();
    Scene scene;
    ASSERT_TRUE(readScene(scene, folder / "s.x3d"));
    checkView(scene);
    EXPECT_TRUE(scene.messages.empty()) << messageLine(scene.messages.front());
}

TEST(DoubtfulValues, onesThatComeLaterAreToldOfOnce)
{
    ViewedScene s("<ClipPlane DEF='C'/>");
    Node& plane = *s.scene.names.at("C");
    for (const float distance : {-1.0f, -2.0f, -3.0f}) {
        plane.put(plane.field("plane")->slot, std::vector<float>{0, 0, 0, distance});
        s.draw();
    }
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: ClipPlane.plane: expected a normal other than 0 0 0, found 0 0 0 "
              "-1: cuts all away\n");
}

TEST(DoubtfulValues, keysThatFallEndTheList)
{
    ViewedScene s("<ScalarInterpolator DEF='I' key='0 1 0.5 2' keyValue='0 10 -50 -70'/>");
    Node& node = *s.scene.names.at("I");
    SceneEvents events(s.scene);
    const auto at = [&](float fraction) {
        events.receive(node, *node.field("set_fraction"), std::vector<float>{fraction});
        return std::get<std::vector<float>>(node.value(*node.field("value_changed"))).front();
    };
    EXPECT_FLOAT_EQ(at(0.5f), 5.0f);
    EXPECT_FLOAT_EQ(at(0.75f), 7.5f);
    EXPECT_FLOAT_EQ(at(1.5f), 10.0f);
}

/// Of a scene with viewAll, in units of a volume's edge.
glm::dmat4 clipFromLocal(const std::string& scale)
{
    const ViewedScene s("<Viewpoint viewAll='true'/>" + scaled(scale, 1, volume()));
    return s.drawn.clipFromEye * s.drawn.eyeFromWorld * s.drawn.volumes.at(0).worldFromLocal;
}

TEST(DoubtfulValues, smallScenesAreSeenAsLargeOnesAre)
{
    const glm::dmat4 usual = clipFromLocal("1");
    for (const std::string scale : {"1e-14", "1e-9", "1e-6", "1e3", "1e14"}) {
        const glm::dmat4 scaled = clipFromLocal(scale);
        const glm::dvec4 corner(0.5, -0.5, 0.5, 1.0);
        const glm::dvec4 here = usual * corner, there = scaled * corner;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(here[axis] / here.w, there[axis] / there.w, 1e-5) << scale << " " << axis;
    }
}

} // namespace
} // namespace vo
