// Views of scenes without OpenGL: cameras, viewpoints, what lies under a pixel, pointing devices, events that
// change what is drawn, and what is refused.

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include <vo/Error.h>
#include <vo/x3d/View.h>

namespace {

bool refused()
{
    return voError::getErrorNumber() == voError::BAD_VALUE;
}

/// A volume of 8 x 2 x 2 voxels, 4 x 2 x 2 wide, whose value rises along x from 0 to 7/7.
constexpr const char* kRamp =
    "<VolumeData DEF='V' dimensions='4 2 2'><PixelTexture3D containerField='voxels' image='1 8 2 2 "
    "0 36 73 109 146 182 219 255 0 36 73 109 146 182 219 255 "
    "0 36 73 109 146 182 219 255 0 36 73 109 146 182 219 255'/></VolumeData>";

/// Eye on the x axis at -10, looking along +x: its right is +z, its up +y.
constexpr const char* kFromLeft = "<OrthoViewpoint DEF='Left' position='-10 0 0' orientation='0 1 0 "
                                  "-1.570796327' fieldOfView='-2 -2 2 2'/>";

class View : public testing::Test
{
protected:
    void read(const std::string& nodes)
    {
        const std::string text = "<X3D profile='Full' version='4.0'><Scene>" + nodes + "</Scene></X3D>";
        ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
        for (int i = 0; i < scene.getMessageCount(); ++i)
            ADD_FAILURE() << scene.getMessage(i);
        view.setSize(64, 64);
        voError::getErrorNumber();
    }
    bool truth(const char* node, const char* field)
    {
        const int* const found = scene.find(node).getInts(field);
        return found && *found != 0;
    }
    std::vector<float> picture()
    {
        std::vector<float> rgba(std::size_t(4 * view.getWidth() * view.getHeight()), -1.0f);
        EXPECT_TRUE(view.picture(rgba.data()));
        return rgba;
    }
    float red(const std::vector<float>& rgba, int x, int y) const
    {
        return rgba[std::size_t(4 * (y * view.getWidth() + x))];
    }
    /// The sky is black.
    float red(int x, int y) { return red(picture(), x, y); }

    voX3DScene scene;
    voX3DView view{scene};
    voX3DPick hit;
};

void expectNear(const float* found, std::array<double, 3> expected, double within)
{
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(double(found[i]), expected[i], within) << i;
}

TEST_F(View, boundsOfAVolumeArePicked)
{
    read(std::string(kFromLeft) + "<Transform translation='1 0 0'>" + kRamp + "</Transform>");
    // Pixel (40, 24): z = (40.5 - 32) / 16, y = (24.5 - 32) / 16.
    ASSERT_TRUE(view.pick(40, 24, -1, hit));
    EXPECT_EQ(hit.kind, voX3DPick::BOUNDS);
    EXPECT_EQ(hit.node, scene.find("V"));
    expectNear(hit.world, {-1, -0.46875, 0.53125}, 1e-5);
    expectNear(hit.local, {-2, -0.46875, 0.53125}, 1e-5);
    expectNear(hit.textureCoordinate, {0, 0.265625, 0.765625}, 1e-5);
    expectNear(hit.normal, {-1, 0, 0}, 1e-5);
    EXPECT_NEAR(hit.depth, 9, 1e-5);
    EXPECT_FALSE(view.pick(2, 2, -1, hit));
    EXPECT_EQ(hit.kind, voX3DPick::NOTHING);
    EXPECT_TRUE(hit.node.isNull());
}

TEST_F(View, theFirstVoxelAboveAnOpacityIsPicked)
{
    read(std::string(kFromLeft) + kRamp);
    // The default style is as opaque as the value: x = -1.75 + 3.5 * value; planes are 1/2 apart.
    ASSERT_TRUE(view.pick(32, 32, 0.5f, hit));
    EXPECT_EQ(hit.kind, voX3DPick::VOXEL);
    EXPECT_GE(hit.world[0], 0);
    EXPECT_LE(hit.world[0], 0.5 + 1e-4);
    EXPECT_NEAR(hit.opacity, (hit.world[0] + 1.75) / 3.5, 0.01);
    EXPECT_GT(hit.opacity, 0.5f);
    expectNear(hit.normal, {-1, 0, 0}, 1e-3);
    EXPECT_FALSE(view.pick(32, 32, 1, hit)) << "nothing is above 1";
}

TEST_F(View, isosurfacesArePickedWhereTheyLie)
{
    read(std::string(kFromLeft) + "<IsoSurfaceVolumeData dimensions='4 2 2' surfaceValues='0.4'>" +
         std::string(kRamp).substr(std::string(kRamp).find("<Pixel"),
                                   std::string(kRamp).find("</Vol") - std::string(kRamp).find("<Pixel")) +
         "</IsoSurfaceVolumeData>");
    ASSERT_TRUE(view.pick(30, 34, 0, hit));
    EXPECT_EQ(hit.kind, voX3DPick::SURFACE);
    EXPECT_NEAR(hit.world[0], -1.75 + 3.5 * 0.4, 0.01);
    expectNear(hit.normal, {-1, 0, 0}, 1e-3);
}

TEST_F(View, surfacesHideVolumes)
{
    read(std::string(kFromLeft) + kRamp +
         "<Transform translation='-3 0.5 0' scale='1 0.5 1'><Shape DEF='S'><Box size='1 2 "
         "4'/></Shape></Transform>");
    ASSERT_TRUE(view.pick(32, 40, 0.5f, hit));
    EXPECT_EQ(hit.kind, voX3DPick::SURFACE);
    EXPECT_EQ(hit.node, scene.find("S"));
    expectNear(hit.world, {-3.5, 8.5 / 16, 0.5 / 16}, 1e-5);
    expectNear(hit.local, {-0.5, (8.5 / 16 - 0.5) / 0.5, 0.5 / 16}, 1e-5);
    ASSERT_TRUE(view.pick(32, 20, 0.5f, hit));
    EXPECT_EQ(hit.kind, voX3DPick::VOXEL);
}

TEST_F(View, solidFacesArePickedFromOutsideAlone)
{
    // Two squares that look to -z and +z, the one to +z farther from the eye at +z.
    const auto square = [](const char* name, const char* solid, const char* z, const char* order) {
        return std::string("<Transform translation='0 0 ") + z + "'><Shape DEF='" + name +
               "'><IndexedFaceSet solid='" + solid + "' coordIndex='" + order +
               "'><Coordinate point='-1 -1 0 1 -1 0 1 1 0 -1 1 0'/></IndexedFaceSet></Shape></Transform>";
    };
    const std::string viewpoint = "<OrthoViewpoint position='0 0 9' fieldOfView='-2 -2 2 2'/>";
    read(viewpoint + square("Back", "true", "1", "3 2 1 0") + square("Front", "true", "0", "0 1 2 3"));
    ASSERT_TRUE(view.pick(32, 32, 0, hit));
    EXPECT_EQ(hit.node, scene.find("Front"));
    read(viewpoint + square("Back", "false", "1", "3 2 1 0") + square("Front", "true", "0", "0 1 2 3"));
    ASSERT_TRUE(view.pick(32, 32, 0, hit));
    EXPECT_EQ(hit.node, scene.find("Back"));
    expectNear(hit.normal, {0, 0, 1}, 1e-6);
}

TEST_F(View, segmentsThatAreHiddenAreNotPicked)
{
    const std::string ids = "<PixelTexture3D containerField='segmentIdentifiers' image='1 2 1 1 0 1'/>";
    const std::string voxels = "<PixelTexture3D containerField='voxels' image='1 2 1 1 255 255'/>";
    read(std::string(kFromLeft) + "<SegmentedVolumeData dimensions='2 2 2' segmentEnabled='false true'>" +
         voxels + ids + "</SegmentedVolumeData>");
    ASSERT_TRUE(view.pick(32, 32, 0.5f, hit));
    EXPECT_GT(hit.world[0], 0) << "the half of number 0 is not there";
}

/// With it, planes are 1 apart in rowOf(), which has 32 of them otherwise.
constexpr double kRowSampling = 32.0 / 9.0;

/// 9 x 1 x 1 voxels, as many wide, of any values; the eye looks along +x.
std::string rowOf(const std::string& values, const std::string& style)
{
    return "<OrthoViewpoint position='-10 0 0' orientation='0 1 0 -1.570796327' fieldOfView='-2 -2 2 2'/>"
           "<VolumeData DEF='V' dimensions='9 1 1'>" +
           style + "<PixelTexture3D containerField='voxels' image='1 9 1 1 " + values + "'/></VolumeData>";
}

TEST_F(View, projectionsArePickedWhereTheVoxelLiesThatTheyShow)
{
    struct Case
    {
        const char* fields;
        double x;
    };
    // Voxels lie at -4 to 4. Planes lie half a voxel from them; a sample is the mean of two voxels.
    const std::string row = "50 100 100 40 10 20 250 250 30";
    view.setSampling(kRowSampling);
    for (const Case& each : {Case{"type='MAX'", 2.5}, Case{"type='MIN'", 0.5}, Case{"type='AVERAGE'", 2.5},
                             Case{"type='MAX' intensityThreshold='0.25'", -2.5}}) {
        read(rowOf(row, std::string("<ProjectionVolumeStyle ") + each.fields + "/>"));
        ASSERT_TRUE(view.pick(32, 32, 0.5f, hit)) << each.fields;
        EXPECT_EQ(hit.kind, voX3DPick::VOXEL);
        EXPECT_NEAR(hit.world[0], each.x, 0.51) << each.fields;
        EXPECT_EQ(hit.opacity, 1.0f) << "voxels have no opacity of their own";
        EXPECT_FALSE(view.pick(32, 32, 1, hit)) << "nothing is above 1";
    }
}

TEST_F(View, projectionsEndAtOpaqueSurfacesAndStandAtTheirFirstSample)
{
    const std::string row = rowOf("50 100 100 40 10 20 250 250 30", "<ProjectionVolumeStyle/>");
    view.setSampling(kRowSampling);
    const auto wallAt = [](double x, const char* transparency) {
        return "<Transform translation='" + std::to_string(x) +
               " 0 0'><Shape DEF='S'><Appearance><Material transparency='" + transparency +
               "'/></Appearance><Box size='0.2 4 4'/></Shape></Transform>";
    };
    read(row + wallAt(0, "0"));
    ASSERT_TRUE(view.pick(32, 32, 0, hit));
    EXPECT_EQ(hit.node, scene.find("V"));
    EXPECT_NEAR(hit.world[0], -2.5, 0.51) << "the greatest is hidden";
    read(row + wallAt(0, "0.5"));
    ASSERT_TRUE(view.pick(32, 32, 0, hit));
    EXPECT_EQ(hit.node, scene.find("V")) << "which stands in front of the wall";
    EXPECT_NEAR(hit.world[0], 2.5, 0.51);
    read(row + wallAt(-6, "0.5"));
    ASSERT_TRUE(view.pick(32, 32, 0, hit));
    EXPECT_EQ(hit.node, scene.find("S"));
}

TEST_F(View, stipplesArePickedAtTheirPoints)
{
    const std::string text =
        "<X3D profile='Full' version='3.0'><Scene><Viewpoint position='0 0 6'/><VolumeData DEF='V' "
        "dimensions='2 2 2'><StippleVolumeStyle/><PixelTexture3D containerField='voxels' image='1 3 3 3 "
        "0 0 0 0 90 0 0 0 0 0 90 0 90 255 90 0 90 0 0 0 0 0 90 0 0 0 0'/></VolumeData></Scene></X3D>";
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
    view.setSize(64, 64);
    view.setHeadlight(VO_FALSE);
    const std::vector<float> drawn = picture();
    int points = 0, beside = 0;
    for (int y = 16; y < 48; ++y)
        for (int x = 16; x < 48; ++x) {
            // Every point that is drawn is hit: it projects into its pixel.
            const bool isDrawn = drawn[std::size_t(4 * (y * 64 + x)) + 3] > 0 && red(drawn, x, y) > 0;
            const bool isHit = view.pick(x, y, 0.5f, hit);
            EXPECT_TRUE(isHit || !isDrawn) << x << " " << y;
            if (!isHit) continue;
            const double scale = 32 / std::tan(M_PI / 8) / hit.depth;
            const double offX = std::floor(32 + scale * double(hit.world[0])) - x;
            const double offY = std::floor(32 + scale * double(hit.world[1])) - y;
            EXPECT_LE(std::hypot(offX, offY), isDrawn ? 0.0 : 3.0) << x << " " << y;
            EXPECT_NEAR(hit.depth, 6 - double(hit.world[2]), 1e-4);
            EXPECT_EQ(hit.opacity, 1.0f);
            ++(isDrawn ? points : beside);
        }
    EXPECT_GT(points, 4);
    EXPECT_GT(beside, 20);
    EXPECT_FALSE(view.pick(32, 32, 1, hit));
}

TEST_F(View, camerasByMatricesAreTaken)
{
    read(kRamp);
    const GLdouble eye[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -10, 1};
    const GLdouble projection[16] = {0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -0.1, 0, 0, 0, -1, 1};
    view.setCamera(eye, projection);
    ASSERT_TRUE(view.pick(0, 32, -1, hit));
    EXPECT_NEAR(hit.world[0], 0.5 / 16 - 2, 1e-5);
    EXPECT_NEAR(hit.world[2], 1, 1e-5);
    GLdouble found[16], foundProjection[16];
    ASSERT_TRUE(view.getCamera(found, foundProjection));
    for (int i = 0; i < 16; ++i) {
        EXPECT_NEAR(found[i], eye[i], 1e-12);
        EXPECT_NEAR(foundProjection[i], projection[i], 1e-12);
    }
    GLdouble scaled[16];
    for (int i = 0; i < 16; ++i)
        scaled[i] = 2 * eye[i];
    view.setCamera(scaled, projection);
    EXPECT_TRUE(refused()) << "no rigid motion";
    const GLdouble singular[16] = {0.5};
    view.setCamera(eye, singular);
    EXPECT_TRUE(refused()) << "singular";
    view.setCamera(NULL, projection);
    EXPECT_TRUE(refused());
    double center[3], radius = 0;
    ASSERT_TRUE(view.getBounds(center, radius));
    EXPECT_NEAR(radius, std::sqrt(6.0), 1e-6);
}

TEST_F(View, viewpointsGoByNameDescriptionAndNumber)
{
    read("<Viewpoint DEF='A' description='The front'/><Group><OrthoViewpoint DEF='B'/></Group>");
    EXPECT_EQ(view.getViewpointCount(), 2);
    EXPECT_EQ(view.getViewpoint(1), scene.find("B"));
    EXPECT_TRUE(view.setViewpoint("The front"));
    EXPECT_TRUE(view.setViewpoint("B"));
    EXPECT_TRUE(view.setViewpoint("2"));
    EXPECT_FALSE(view.setViewpoint("3"));
    EXPECT_TRUE(refused());
    EXPECT_TRUE(view.getViewpoint(2).isNull());
    EXPECT_TRUE(refused());
    GLdouble eye[16], projection[16];
    const double bind = 1;
    view.setViewpoint(voX3DNode());
    view.send(scene.find("B"), "set_bind", &bind, 1);
    ASSERT_TRUE(view.getCamera(eye, projection));
    EXPECT_EQ(projection[15], 1) << "the orthographic one is bound";
}

TEST_F(View, timeMovesWhatIsDrawn)
{
    read("<OrthoViewpoint fieldOfView='-4 -4 4 4'/><Transform DEF='T'><VolumeData dimensions='2 2 2'>"
         "<PixelTexture3D containerField='voxels' image='1 1 1 1 255'/></VolumeData></Transform>"
         "<TimeSensor DEF='C' cycleInterval='8' loop='true'/>"
         "<PositionInterpolator DEF='P' key='0 1' keyValue='-4 0 0 4 0 0'/>"
         "<ROUTE fromNode='C' fromField='fraction_changed' toNode='P' toField='set_fraction'/>"
         "<ROUTE fromNode='P' fromField='value_changed' toNode='T' toField='translation'/>");
    EXPECT_EQ(view.getCycle(), 8);
    EXPECT_FALSE(view.isAnimated());
    view.setTime(6); // x from 1 to 3
    EXPECT_TRUE(view.isAnimated());
    EXPECT_EQ(view.getTime(), 6);
    for (int x = 0; x < 64; x += 3)
        EXPECT_NEAR(red(x, 32), x >= 40 && x < 56 ? 1 : 0, 1e-5) << x;
    view.setTime(std::nan(""));
    EXPECT_TRUE(refused());
}

TEST_F(View, levelsOfDetailTellWhichIsShown)
{
    read("<Viewpoint position='0 0 10'/><LOD DEF='L' range='5 20'><Group/><Group/><Group/></LOD>"
         "<Switch DEF='S' whichChoice='-1'><Group/><Group/></Switch>"
         "<ROUTE fromNode='L' fromField='level_changed' toNode='S' toField='whichChoice'/>");
    picture();
    EXPECT_EQ(scene.find("L").getInts("level_changed")[0], 1);
    EXPECT_EQ(scene.find("S").getInts("whichChoice")[0], 1);
}

TEST_F(View, octTreesTellWhenTheLowResolutionIsShown)
{
    const std::string text =
        "<X3D profile='Full' version='3.0'><Scene><Viewpoint DEF='E' position='0 0 10'/>"
        "<OctTree DEF='O' range='5'><Group containerField='lowRes'/></OctTree></Scene></X3D>";
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "test"));
    picture();
    EXPECT_TRUE(truth("O", "lowResActive"));
    const float near[3] = {0, 0, 4};
    scene.find("E").setFloats("position", near, 3);
    picture();
    EXPECT_FALSE(truth("O", "lowResActive"));
}

TEST_F(View, pointingDevicesMoveTouchSensors)
{
    read(std::string(kFromLeft) + "<Transform translation='1 0 0' scale='1 2 1'>" + kRamp +
         "<TouchSensor DEF='T'/></Transform><TouchSensor DEF='Outer'/>"
         "<TimeSensor DEF='C' cycleInterval='4'/>"
         "<ROUTE fromNode='T' fromField='touchTime' toNode='C' toField='startTime'/>");
    view.setTime(3);
    EXPECT_FALSE(view.movePointer(1, 1));
    EXPECT_TRUE(view.movePointer(32, 32));
    EXPECT_TRUE(truth("T", "isOver"));
    EXPECT_EQ(scene.find("Outer").getInts("isOver") && truth("Outer", "isOver"), false) << "the nearest one";
    expectNear(scene.find("T").getFloats("hitPoint_changed"), {-2, 0.015625, 0.03125}, 1e-5);
    expectNear(scene.find("T").getFloats("hitNormal_changed"), {-1, 0, 0}, 1e-5);
    view.pressPointer();
    EXPECT_TRUE(truth("T", "isActive"));
    view.releasePointer();
    EXPECT_FALSE(truth("T", "isActive"));
    EXPECT_EQ(scene.find("T").getDoubles("touchTime")[0], 3);
    view.setTime(4);
    EXPECT_EQ(scene.find("C").getFloats("fraction_changed")[0], 0.25f) << "it started when touched";
    view.pressPointer();
    view.movePointer(1, 1);
    EXPECT_FALSE(truth("T", "isOver"));
    view.setTime(5);
    view.releasePointer();
    EXPECT_EQ(scene.find("T").getDoubles("touchTime")[0], 3) << "let go beside it";
}

TEST_F(View, finerSamplingFindsVoxelsCloserToWhereTheyAre)
{
    read(std::string(kFromLeft) + kRamp);
    // The value is 0.5 at x = 0, and 32 planes are in the 4 of the way.
    for (const double sampling : {1.0, 0.25, 0.01}) {
        view.setSampling(sampling);
        ASSERT_TRUE(view.pick(32, 32, 0.5f, hit));
        EXPECT_GE(hit.world[0], -0.01);
        EXPECT_LE(hit.world[0], 4.0 / 32 * sampling + 0.01);
    }
    for (const double wrong : {-1.0, 0.001, 101.0, std::nan("")}) {
        view.setSampling(wrong);
        EXPECT_TRUE(refused()) << wrong;
    }
}

TEST_F(View, aSceneThatIsReadAnewIsSeen)
{
    read("<Viewpoint DEF='A'/>" + std::string(kRamp));
    view.setViewpoint("A");
    view.setTime(5);
    EXPECT_GT(red(32, 32), 0);
    read("<Group/>");
    EXPECT_EQ(red(32, 32), 0);
    EXPECT_EQ(view.getViewpointCount(), 0);
    EXPECT_FALSE(view.pick(32, 32, 0, hit));
}

TEST_F(View, wrongValuesAreRefused)
{
    read(kRamp);
    view.setSize(0, 5);
    EXPECT_TRUE(refused());
    view.setSize(5, 40000);
    EXPECT_TRUE(refused());
    EXPECT_EQ(view.getWidth(), 64);
    EXPECT_FALSE(view.picture(NULL));
    EXPECT_TRUE(refused());
    EXPECT_FALSE(view.pick(1, 1, std::nanf(""), hit));
    EXPECT_TRUE(refused());
    const double numbers[3] = {1, -1, 1};
    view.send(scene.find("V"), "set_dimensions", numbers, 3);
    EXPECT_TRUE(refused());
    view.send(scene.find("V"), "voxels", numbers, 3);
    EXPECT_TRUE(refused());
    view.send(scene.find("V"), "bboxSize", numbers, 3);
    EXPECT_TRUE(refused()) << "takes no events";
    view.setViewpoint(scene.find("V"));
    EXPECT_TRUE(refused());
    EXPECT_FALSE(view.draw()) << "without a context";
    EXPECT_EQ(voError::getErrorNumber(), voError::UNSUPPORTED);
}

} // namespace
