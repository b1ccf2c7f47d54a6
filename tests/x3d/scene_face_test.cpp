// The face of scenes: what programs make, change, name and connect, and what it refuses.

#include <gtest/gtest.h>
#include <string>

#include <vo/Error.h>
#include <vo/x3d/Scene.h>

#include "../util/scratch_folder.h"

namespace {

bool refused()
{
    return voError::getErrorNumber() == voError::BAD_VALUE;
}

TEST(SceneFace, whatAProgramMakesIsWrittenAndRead)
{
    const vo::ScratchFolder folder;
    const std::string path = folder / "made.x3d";
    voX3DScene made;
    voX3DNode volume = made.createNode("VolumeData"), style = made.createNode("CartoonVolumeStyle");
    const float size[3] = {1, 2, 3};
    volume.setFloats("dimensions", size, 3);
    volume.setNode("renderStyle", style);
    style.setInt("colorSteps", 7);
    made.setName(volume, "Head");
    made.setRoots(&volume, 1);
    EXPECT_EQ(made.find("Head"), volume);
    ASSERT_TRUE(made.write(path.c_str()));

    voX3DScene read;
    ASSERT_TRUE(read.read(path.c_str()));
    ASSERT_EQ(read.getMessageCount(), 0);
    ASSERT_EQ(read.getRootCount(), 1);
    const voX3DNode again = read.getRoot(0);
    EXPECT_EQ(again, read.find("Head"));
    EXPECT_EQ(std::string(again.getTypeName()), "VolumeData");
    EXPECT_EQ(std::string(again.getName()), "Head");
    EXPECT_EQ(again.getFile(), path);
    EXPECT_EQ(again.getLine(), 4);
    EXPECT_EQ(again.getFloats("dimensions")[2], 3);
    EXPECT_TRUE(again.isSet("dimensions"));
    EXPECT_FALSE(again.isSet("bboxSize"));
    EXPECT_EQ(again.getNode("renderStyle").getInts("colorSteps")[0], 7);
    EXPECT_TRUE(again.getNode("renderStyle").isType("X3DVolumeRenderStyleNode"));
    EXPECT_TRUE(again.getNode("voxels").isNull());
    EXPECT_EQ(again.getCount("voxels"), 0);
}

TEST(SceneFace, nodesThatMayNotStandThereAreRefused)
{
    voX3DScene scene, other;
    voX3DNode outer = scene.createNode("Group"), inner = scene.createNode("Group");
    voX3DNode foreign = other.createNode("Group"), box = scene.createNode("Box");
    voError::getErrorNumber();
    outer.setNodes("children", &inner, 1);
    EXPECT_FALSE(refused());
    inner.setNodes("children", &outer, 1);
    EXPECT_TRUE(refused()) << "a cycle";
    inner.setNodes("children", &inner, 1);
    EXPECT_TRUE(refused()) << "itself";
    inner.setNodes("children", &foreign, 1);
    EXPECT_TRUE(refused()) << "of another scene";
    inner.setNodes("children", &box, 1);
    EXPECT_TRUE(refused()) << "no child";
    scene.setRoots(&box, 1);
    EXPECT_TRUE(refused()) << "no root";
    EXPECT_EQ(inner.getCount("children"), 0);
    inner.setNode("metadata", voX3DNode());
    EXPECT_FALSE(refused());
    outer.reset("children");
    EXPECT_EQ(outer.getCount("children"), 0);
}

TEST(SceneFace, whatDoesNotExistIsAnError)
{
    voX3DScene scene;
    voX3DNode volume = scene.createNode("VolumeData");
    voError::getErrorNumber();
    EXPECT_TRUE(scene.createNode("Teapot").isNull());
    EXPECT_TRUE(refused());
    EXPECT_TRUE(scene.createNode("X3DChildNode").isNull());
    EXPECT_TRUE(refused()) << "abstract";
    EXPECT_EQ(volume.getFloats("shininess"), nullptr);
    EXPECT_TRUE(refused());
    EXPECT_EQ(volume.getInts("dimensions"), nullptr);
    EXPECT_TRUE(refused()) << "another type";
    EXPECT_EQ(voX3DNode().getTypeName(), nullptr);
    EXPECT_TRUE(refused()) << "the null node";
    EXPECT_TRUE(scene.getRoot(0).isNull());
    EXPECT_TRUE(refused());
    volume.setFloat("dimensions", 1);
    EXPECT_TRUE(refused()) << "one number of three";
    scene.setName(volume, "two words");
    EXPECT_TRUE(refused());
    EXPECT_FALSE(scene.write("/"));
    EXPECT_TRUE(refused());
    EXPECT_FALSE(scene.read("/absent.x3d"));
    EXPECT_EQ(std::string(scene.getMessage(0)), "/absent.x3d: error: no such file");
    EXPECT_TRUE(scene.isError(0));
}

TEST(SceneFace, messagesSayWhatTheyAreAbout)
{
    voX3DScene scene;
    const std::string text =
        "<X3D profile='Full' version='4.0'><Scene><IsoSurfaceVolumeData><Teapot/></IsoSurfaceVolumeData>"
        "</Scene></X3D>";
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "a.x3d"));
    const voX3DNode made = scene.createNode("IsoSurfaceVolumeData");
    scene.setRoots(&made, 1);
    scene.check();
    ASSERT_EQ(scene.getMessageCount(), 5) << "two for each volume";
    EXPECT_EQ(scene.getMessageTopic(0), voX3DScope::ANYTHING_ELSE) << scene.getMessage(0);
    EXPECT_EQ(scene.getMessageTopic(1), voX3DScope::NOTHING_SEEN) << scene.getMessage(1);
    EXPECT_EQ(std::string(scene.getMessageFile(0)), "a.x3d");
    EXPECT_EQ(std::string(scene.getMessageFile(2)), "") << scene.getMessage(2);
    voError::getErrorNumber();
    scene.getMessageFile(5);
    EXPECT_TRUE(refused());
    scene.getMessageTopic(-1);
    EXPECT_TRUE(refused());
}

TEST(SceneFace, voxelsThatWereReadAreOfTexturesWithFiles)
{
    voX3DScene scene;
    const voX3DNode file = scene.createNode("ImageTexture3D"), pixels = scene.createNode("PixelTexture3D");
    const unsigned char voxels[8] = {};
    const int size[3] = {2, 2, 1}, none[3] = {2, 0, 1};
    const voDataType byte = voDataTypeScope::UNSIGNED_BYTE;
    voError::getErrorNumber();
    scene.setReadVoxels(file, voxels, size, 2, 1, byte);
    EXPECT_FALSE(refused());
    scene.setReadVoxels(pixels, voxels, size, 2, 1, byte);
    EXPECT_TRUE(refused()) << "no file";
    scene.setReadVoxels(file, NULL, size, 1, 1, byte);
    EXPECT_TRUE(refused()) << "no voxels";
    scene.setReadVoxels(file, voxels, none, 1, 1, byte);
    EXPECT_TRUE(refused()) << "no size";
    scene.setReadVoxels(file, voxels, size, 1, 2, byte);
    EXPECT_TRUE(refused()) << "more components than channels";
    scene.setReadVoxels(file, voxels, size, 1, 1, voDataTypeScope::INT);
    EXPECT_TRUE(refused()) << "a type that files do not have";
}

TEST(SceneFace, routesJoinFieldsOfOneType)
{
    voX3DScene scene;
    const voX3DNode path = scene.createNode("PositionInterpolator"), turn = scene.createNode("Transform");
    voError::getErrorNumber();
    scene.addRoute(path, "value_changed", turn, "set_translation");
    EXPECT_FALSE(refused());
    scene.addRoute(path, "value_changed", turn, "rotation");
    EXPECT_TRUE(refused());
    ASSERT_EQ(scene.getRouteCount(), 1);
    EXPECT_EQ(scene.getRouteSource(0), path);
    EXPECT_EQ(std::string(scene.getRouteSourceField(0)), "value_changed");
    EXPECT_EQ(scene.getRouteTarget(0), turn);
    EXPECT_EQ(std::string(scene.getRouteTargetField(0)), "translation");
}

} // namespace
