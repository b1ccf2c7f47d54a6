// What readers say of scenes that are unknown, wrong, hostile or cut off, and which files they reach.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

#include "../util/scratch_folder.h"
#include "x3d/check_scene.h"
#include "x3d/read_scene.h"

namespace vo {
namespace {

std::string messagesOf(const Scene& scene)
{
    std::string lines;
    for (const SceneMessage& message : scene.messages)
        lines += messageLine(message) + "\n";
    return lines;
}

const char* const kXmlStart = "<X3D profile='Full' version='4.0'><Scene>";
const char* const kClassicStart = "#X3D V4.0 utf8\nPROFILE Full\n";

/// The messages of nodes in a scene of 4.0, whose first line is 1; in ClassicVRML it is 3.
std::string ofXml(const std::string& nodes, Scene&& scene = {})
{
    readSceneText(scene, kXmlStart + nodes + "</Scene></X3D>", "s.x3d");
    return messagesOf(scene);
}
std::string ofClassic(const std::string& nodes, Scene&& scene = {})
{
    readSceneText(scene, kClassicStart + nodes, "s.x3dv");
    return messagesOf(scene);
}

TEST(ReadScene, unknownNodesAreSkippedWithTheirLine)
{
    Scene xml, classic;
    EXPECT_EQ(
        ofXml(
            "\n<Group>\n<Teapot DEF='T'><Box DEF='B'/></Teapot><Group USE='B'/>\n<sphere/></Group>\n<Group/>",
            std::move(xml)),
        "s.x3d:3: warning: unknown node \"Teapot\" skipped\n"
        "s.x3d:4: warning: unknown node \"sphere\" (Sphere?) skipped\n");
    EXPECT_EQ(ofClassic("Group { children [\nDEF T Teapot { lid [ \"}\" ] # }\n spout DEF B Box { } } USE B "
                        "] }\nGroup {}",
                        std::move(classic)),
              "s.x3dv:4: warning: unknown node \"Teapot\" skipped\n");
    EXPECT_EQ(xml.roots.size(), 2u);
    EXPECT_EQ(classic.roots.size(), 2u);
}

TEST(ReadScene, stylesGoToTheFieldThatTheirParentsNameHas)
{
    for (const char* const version : {"3.0", "4.0"})
        for (const char* const parent : {"CompositeVolumeStyle", "ComposedVolumeStyle"}) {
            Scene scene;
            readSceneText(scene,
                          "<X3D profile='Full' version='" + std::string(version) + "'><Scene><VolumeData><" +
                              parent + " DEF='P'><CartoonVolumeStyle/></" + parent +
                              "></VolumeData></Scene></X3D>",
                          "s.x3d");
            EXPECT_EQ(scene.errorCount(), 0u) << messagesOf(scene);
            const Node& node = *scene.names.at("P");
            const bool isOld = node.edition() == Edition::proposal2005;
            EXPECT_EQ(isOld, std::string_view(parent) == "CompositeVolumeStyle");
            const auto& styles = node.value(*node.field(isOld ? "styles" : "renderStyle"));
            EXPECT_EQ(std::get<std::vector<Node*>>(styles).size(), 1u);
        }
}

TEST(ReadScene, unknownFieldsAreSkippedWithTheirLine)
{
    EXPECT_EQ(ofXml("<VolumeData\n dimensions='1 1 1'\n shininess='1' Dimensions='2 2 2'/>"),
              "s.x3d:3: warning: unknown field \"shininess\" of VolumeData skipped\n"
              "s.x3d:3: warning: unknown field \"Dimensions\" (dimensions?) of VolumeData skipped\n");
    EXPECT_EQ(ofClassic("VolumeData { a 1 2 3 b \"x\" c [ 1 { } ]\nd DEF E Box { size 1 1 1 } e TRUE f USE E "
                        "dimensions 1 0 1 }"),
              "s.x3dv:3: warning: unknown field \"a\" of VolumeData skipped\n"
              "s.x3dv:3: warning: unknown field \"b\" of VolumeData skipped\n"
              "s.x3dv:3: warning: unknown field \"c\" of VolumeData skipped\n"
              "s.x3dv:4: warning: unknown field \"d\" of VolumeData skipped\n"
              "s.x3dv:4: warning: unknown field \"e\" of VolumeData skipped\n"
              "s.x3dv:4: warning: unknown field \"f\" of VolumeData skipped\n"
              "s.x3dv:4: error: VolumeData.dimensions: expected numbers in (0,inf), found 0\n");
}

TEST(ReadScene, valuesOfAnotherTypeAreLeftOut)
{
    EXPECT_EQ(
        ofXml(
            "<VolumeData dimensions='1 1\n x'/><VolumeData dimensions='1 1'/><Material transparency='nan'/>"),
        "s.x3d:2: error: VolumeData.dimensions: expected a number, found \"x\"\n"
        "s.x3d:2: error: VolumeData.dimensions: expected 3 values, found 2\n"
        "s.x3d:2: error: Material.transparency: expected a number, found \"nan\"\n"
        "s.x3d:2: error: Material cannot stand in a scene by itself\n");
    EXPECT_EQ(
        ofXml("<Switch whichChoice='4000000000'/><TimeSensor loop='TRUE' enabled='yes'/>"),
        "s.x3d:1: error: Switch.whichChoice: expected a whole number of 32 bits, found \"4000000000\"\n"
        "s.x3d:1: warning: TimeSensor.loop: expected true or false in small letters, found TRUE, taken so\n"
        "s.x3d:1: error: TimeSensor.enabled: expected true or false, found \"yes\"\n");
    EXPECT_EQ(ofXml("<VolumeData voxels='1'/><TimeSensor isActive='true'/>"),
              "s.x3d:1: error: VolumeData.voxels: expected a node as an element, found \"1\"\n"
              "s.x3d:1: error: TimeSensor.isActive is an event, which has no value in a file\n");
    EXPECT_EQ(ofClassic("VolumeData {\n dimensions 1 one 1 }"),
              "s.x3dv:4: error: expected a number for dimensions, found \"one\"\n");
}

TEST(ReadScene, valuesOutOfRangeAreLeftOut)
{
    Scene scene;
    EXPECT_EQ(
        ofXml("<VolumeData DEF='V'\n dimensions='1 0 1'><CartoonVolumeStyle colorSteps='65'/></VolumeData>",
              std::move(scene)),
        "s.x3d:2: error: CartoonVolumeStyle.colorSteps: expected numbers in [1,64], found 65\n"
        "s.x3d:2: error: VolumeData.dimensions: expected numbers in (0,inf), found 0\n");
    EXPECT_FALSE(scene.names.at("V")->isSet(scene.names.at("V")->field("dimensions")->slot));
    EXPECT_EQ(ofXml("<Group><VolumeData><ProjectionVolumeStyle type='MEDIAN'/></VolumeData></Group>"),
              "s.x3d:1: error: ProjectionVolumeStyle.type: expected MAX, MIN or AVERAGE, found \"MEDIAN\"\n");
}

TEST(ReadScene, nodesStandWhereTheyMay)
{
    EXPECT_EQ(ofXml("<VolumeData>\n<Box/>\n<Box containerField='voxels'/>\n<ImageTexture3D/></VolumeData>"),
              "s.x3d:2: error: Box cannot stand in VolumeData\n"
              "s.x3d:3: error: VolumeData.voxels: expected X3DTexture3DNode, found Box\n");
    EXPECT_EQ(ofXml("<VolumeData>\n<ImageTexture3D/><ImageTexture3D/></VolumeData>"),
              "s.x3d:2: error: VolumeData.voxels: expected one node, found 2: none is kept\n");
    // 2005 has mip levels there.
    Scene old;
    ASSERT_TRUE(readSceneText(old,
                              "<X3D profile='Full' version='3.1'><Scene><VolumeData DEF='V'><ImageTexture3D/>"
                              "<ImageTexture3D/></VolumeData></Scene></X3D>",
                              "s"));
    EXPECT_EQ(messagesOf(old), "");
    EXPECT_EQ(sizeOf(old.names.at("V")->value(*old.names.at("V")->field("voxels"))), 2u);
}

TEST(ReadScene, namesOfAnotherEditionDecideOverTheVersion)
{
    Scene scene;
    EXPECT_EQ(
        ofXml("<VolumeData><SilhouetteEnhancementVolumeStyle DEF='S' silhouetteFactor='2'/></VolumeData>",
              std::move(scene)),
        "s.x3d:1: warning: SilhouetteEnhancementVolumeStyle.silhouetteFactor is of the proposal of 2005, the "
        "file "
        "of X3D 4.0: the node has fields and defaults of the former\n");
    EXPECT_EQ(scene.names.at("S")->edition(), Edition::proposal2005);
    EXPECT_EQ(scene.edition, Edition::x3d40);
    EXPECT_EQ(ofXml("<VolumeData>\n<BoundaryEnhancementVolumeStyle DEF='B' contribution='0.5'/></VolumeData>",
                    std::move(scene))
                  .substr(0, 17),
              "s.x3d:1: warning:");
}

TEST(ReadScene, cyclesAreRefused)
{
    EXPECT_EQ(ofXml("<Group DEF='G'>\n<Group><Group USE='G'/></Group></Group>"),
              "s.x3d:2: error: the node \"G\" cannot stand below itself\n");
    EXPECT_EQ(ofClassic("DEF G Group { children [\nGroup { children USE G } ] }"),
              "s.x3dv:4: error: the node \"G\" cannot stand below itself\n");
    EXPECT_EQ(ofXml("<Group USE='Nobody'/>"),
              "s.x3d:1: error: expected a name that DEF gave before, found \"Nobody\"\n");
    // Shared nodes multiply to 2^60 paths, which nobody walks.
    std::string doubling = "<Group DEF='G0'/>";
    for (int i = 1; i < 60; ++i) {
        const std::string below = "<Group USE='G" + std::to_string(i - 1) + "'/>";
        doubling += "<Group DEF='G" + std::to_string(i) + "'>" + below + below + "</Group>";
    }
    EXPECT_EQ(ofXml(doubling), "");
}

TEST(ReadScene, deepNestingIsRefused)
{
    std::string xml, classic;
    for (int i = 0; i < 100000; ++i) {
        xml += "<Group>";
        classic += "Group { children ";
    }
    EXPECT_EQ(ofClassic(classic), "s.x3dv:3: error: expected nodes at most 200 deep, found more\n");
    for (int i = 0; i < 100000; ++i)
        xml += "</Group>";
    EXPECT_EQ(ofXml(xml), "s.x3d:1: error: expected nodes at most 200 deep, found more\n");
    EXPECT_EQ(ofXml("<Teapot>" + xml + "</Teapot>"), "s.x3d:1: warning: unknown node \"Teapot\" skipped\n");
    EXPECT_EQ(
        ofClassic("Teapot { a " + std::string(100000, '[')),
        "s.x3dv:3: warning: unknown node \"Teapot\" skipped\n"
        "s.x3dv:3: error: expected } or ] of what is skipped from line 3 on, found the end of the file\n");
}

TEST(ReadScene, muchOfOneKindTakesNoTimeThatGrowsWithItsSquare)
{
    // Each of these took minutes if every part looked at all others.
    constexpr int kMany = 200000;
    std::string attributes, nodes, uses = "<Group DEF='G'/>", urls;
    for (int i = 0; i < kMany; ++i) {
        attributes += " a" + std::to_string(i) + "='1'";
        nodes += "<Group DEF='N" + std::to_string(i) + "'/>";
        uses += "<Group USE='G'/>";
        urls += "\"gone.x3d\" ";
    }
    Scene scene;
    EXPECT_TRUE(readSceneText(
        scene, kXmlStart + ("<Group" + attributes + ">") + nodes + uses + "</Group></Scene></X3D>", "s"));
    EXPECT_EQ(scene.messages.size(), 1000u);
    EXPECT_EQ(scene.messagesLeftOut, kMany - 1000u);
    EXPECT_EQ(scene.nodeCount(), kMany + 2u);
    EXPECT_NE(ofXml("<Inline url='" + urls + "'/>"), "");
    EXPECT_NE(ofClassic("Teapot { a [ " + std::string(kMany, '{') + std::string(kMany, '}') + " ] }"), "");
}

TEST(ReadScene, lyingSizesOfImagesAreRefused)
{
    const char* const start = "s.x3d:1: error: PixelTexture3D.image: ";
    const auto image = [](const std::string& numbers) {
        return ofXml("<VolumeData><PixelTexture3D image='" + numbers + "'/></VolumeData>");
    };
    EXPECT_EQ(image("1 2 1 2 1 2 3 0xff"), "");
    EXPECT_EQ(image("4 1 1 2 4294967295 -1"), "");
    EXPECT_EQ(image("1 2 1 2 1 2 3"), start + std::string("expected 2 x 1 x 2 = 4 pixels, found 3\n"));
    EXPECT_EQ(image("1 2147483647 2147483647 2147483647 1"),
              start + std::string("expected sizes with a product below 2^64, found more\n"));
    EXPECT_EQ(image("1 100000 100000 10000 1"),
              start + std::string("expected 100000 x 100000 x 10000 = 100000000000000 pixels, found 1\n"));
    EXPECT_EQ(image("1 -1 2 2"), start + std::string("expected a size of at least 0, found -1\n"));
    EXPECT_EQ(image("5 1 1 1 0"), start + std::string("expected 0 to 4 components, found 5\n"));
    EXPECT_EQ(image("1 2"),
              start + std::string("expected components, width, height and depth, found 2 numbers\n"));
    EXPECT_EQ(
        ofClassic(
            "Shape { appearance Appearance {\n texture PixelTexture { image 1000000 1000000 3 1 2 } } }"),
        "s.x3dv:4: error: PixelTexture.image: expected 1000000 x 1000000 = 1000000000000 pixels, found 2\n");
}

TEST(ReadScene, routesJoinWhatMayBeJoined)
{
    const std::string nodes = "<TimeSensor DEF='T'/><Transform DEF='X'/><PositionInterpolator DEF='P'/>";
    const auto route = [&](const char* from, const char* to) {
        const auto end = [](const std::string& text, const char* node, const char* field) {
            const auto dot = text.find('.');
            return std::string(node) + "='" + text.substr(0, dot) + "' " + field + "='" +
                   text.substr(dot + 1) + "'";
        };
        return ofXml(nodes + "<ROUTE " + end(from, "fromNode", "fromField") + " " +
                     end(to, "toNode", "toField") + "/>");
    };
    const std::string start = "s.x3d:1: error: ROUTE: ";
    EXPECT_EQ(route("T.fraction_changed", "P.set_fraction"), "");
    EXPECT_EQ(route("P.value_changed", "X.set_translation"), "");
    EXPECT_EQ(route("X.translation_changed", "X.scale"), "");
    EXPECT_EQ(route("T.fraction_changed", "X.translation"),
              start +
                  "TimeSensor.fraction_changed is of type SFFloat, Transform.translation of type SFVec3f\n");
    EXPECT_EQ(route("X.bboxSize", "X.translation"), start + "Transform.bboxSize sends no events\n");
    EXPECT_EQ(route("P.value_changed", "X.bboxSize"), start + "Transform.bboxSize takes no events\n");
    EXPECT_EQ(route("T.nothing", "X.scale"), start + "TimeSensor has no field \"nothing\"\n");
    EXPECT_EQ(route("Z.value_changed", "X.scale"), start + "expected a name that DEF gave, found \"Z\"\n");
}

TEST(ReadScene, halfAFileIsAnErrorWithItsLine)
{
    const std::string xml = std::string(kXmlStart) + "\n<Group>\n<Box/></Group></Scene></X3D>\n";
    const std::string classic =
        std::string(kClassicStart) + "Group { children [\nShape { geometry Box { } } ] }";
    for (std::size_t end = 0; end < xml.size() - 2; ++end) {
        Scene scene;
        EXPECT_FALSE(readSceneText(scene, xml.substr(0, end), "s")) << end;
        ASSERT_FALSE(scene.messages.empty());
        EXPECT_GE(scene.messages.back().place.line, 1);
    }
    const auto begins = classic.find("Group");
    for (std::size_t end = begins + 1; end < classic.size(); ++end) {
        Scene scene;
        EXPECT_FALSE(readSceneText(scene, classic.substr(0, end), "s")) << end;
    }
}

TEST(ReadScene, onlyX3dIsRead)
{
    const auto first = [](const std::string& text) {
        Scene scene;
        EXPECT_FALSE(readSceneText(scene, text, "s"));
        return messagesOf(scene);
    };
    EXPECT_EQ(first("#VRML V2.0 utf8\nGroup {}"),
              "s:1: error: expected \"#X3D V3.0 utf8\" or a later version, found VRML, which is not read\n");
    EXPECT_EQ(first("<html/>"), "s:1: error: expected the element X3D, found \"html\"\n");
    EXPECT_EQ(first("#X3D V3.0 utf8\nPROFILE Full\nGroup {" + std::string(1, '\0') + "}"),
              "s:3: error: expected text in UTF-8, found a zero byte\n");
    EXPECT_EQ(first("<?xml version='1.0'?>\n<!DOCTYPE X3D [<!ENTITY e SYSTEM 'file:///etc/passwd'>]>\n<X3D "
                    "version='4.0' "
                    "profile='Full'><Scene><WorldInfo title='&e;'/></Scene></X3D>"),
              "s:2: error: expected a DOCTYPE without declarations: entities are not read\n");
    EXPECT_NE(first(""), "");
}

TEST(ReadScene, wordsStandWhereTheyMustInClassicVrml)
{
    const auto first = [](const std::string& text) {
        Scene scene;
        EXPECT_FALSE(readSceneText(scene, "#X3D V4.0 utf8\n" + text, "s")) << text;
        return scene.messages.empty() ? "" : messageLine(scene.messages.front());
    };
    EXPECT_EQ(first("PROFILE \"Full\""), "s:2: error: expected the name of a profile, found \"Full\"");
    EXPECT_EQ(first("PROFILE"), "s:2: error: expected the name of a profile, found the end of the file");
    EXPECT_EQ(first("PROFILE Full\nMETA a b"), "s:3: error: expected a name in quotes for META, found \"a\"");
    EXPECT_EQ(first("PROFILE Full\nMETA \"a\" \"b"),
              "s:3: error: expected a text in quotes for META, found a string without an end");
    EXPECT_EQ(first("PROFILE Full\nCOMPONENT {"),
              "s:3: error: expected a name, a colon and a level for COMPONENT, found \"{\"");
    EXPECT_EQ(first("PROFILE Full\nDEF \"A\" Group { }"),
              "s:3: error: expected a name behind DEF, found \"A\"");
    EXPECT_EQ(first("PROFILE Full\nGroup { children USE }"),
              "s:3: error: expected a name behind USE, found \"}\"");
    EXPECT_EQ(first("PROFILE Full\nUSE"),
              "s:3: error: expected a name behind USE, found the end of the file");
    EXPECT_EQ(first("PROFILE Full\nROUTE A.b TO"),
              "s:3: error: expected ROUTE node.field TO node.field, found the end of the file");
    EXPECT_EQ(first("PROFILE Full\nTransform {\ntranslation 1 2 3 4 }"),
              "s:4: error: expected the name of a field, or }, found \"4\"");
    EXPECT_NE(
        ofClassic("PROFILE Core\n").find("s.x3dv:3: warning: PROFILE is given twice; this one is kept\n"),
        std::string::npos);
}

TEST(ReadScene, prototypesAreSkippedWithTheirNodes)
{
    EXPECT_EQ(ofClassic("PROTO P [ field SFFloat a 1 ] { Group { } }\nP { a 2 }"),
              "s.x3dv:3: warning: PROTO is not supported, skipped with all nodes \"P\"\n"
              "s.x3dv:4: warning: unknown node \"P\" skipped\n");
}

TEST(ReadScene, linesEndInEverySystemsWay)
{
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        Scene classic, xml;
        EXPECT_TRUE(readSceneText(classic,
                                  "#X3D V4.0 utf8" + end + "PROFILE Full # Group" + end +
                                      "WorldInfo { title \"a" + end + "b\" }" + end + "Foo { }" + end,
                                  "s"));
        EXPECT_EQ(messagesOf(classic), "s:5: warning: unknown node \"Foo\" skipped\n");
        EXPECT_EQ(classic.roots.size(), 1u);
        EXPECT_TRUE(readSceneText(
            xml, "<X3D profile='Full' version='4.0'>" + end + "<Scene>" + end + "<Foo/></Scene></X3D>", "s"));
        EXPECT_EQ(messagesOf(xml), "s:3: warning: unknown node \"Foo\" skipped\n");
    }
}

TEST(ReadScene, otherTextThanUtf8IsToldOf)
{
    const auto told = [](const std::string& bytes) {
        Scene scene;
        readSceneText(scene, kClassicStart + std::string("WorldInfo {\ntitle \"") + bytes + "\" }", "s");
        return messagesOf(scene);
    };
    // Characters of two, three and four bytes, and the last there is.
    EXPECT_EQ(told("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x98\x80 \xf4\x8f\xbf\xbf \xee\x80\x80"), "");
    // Alone, cut off, longer than needed, half of a pair, beyond the last, and what begins nothing.
    for (const char* const wrong :
         {"\xe9", "\xc3", "\xa9", "\xc0\xaf", "\xe0\x80\xaf", "\xf0\x80\x80\xaf", "\xed\xa0\x80",
          "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xe2\x82"})
        EXPECT_EQ(told(wrong),
                  "s:4: warning: expected text in UTF-8, found other bytes, which stay as they are\n");
    Scene wide;
    EXPECT_FALSE(readSceneText(wide, std::string("\xff\xfe#\0X\0", 6), "s"));
    EXPECT_EQ(messagesOf(wide), "s:1: error: expected text in UTF-8, found UTF-16 or UTF-32\n");
}

TEST(ReadScene, whatStandsInAUseIsToldOf)
{
    EXPECT_EQ(ofXml("<Transform DEF='A'/>\n<Transform USE='A' DEF='B' translation='1 2 3' class='c' "
                    "containerField='children'/>\n<Transform USE='A'><Group/></Transform>"),
              "s.x3d:2: warning: USE of \"A\": \"DEF\" is not read, the node is as it was\n"
              "s.x3d:2: warning: USE of \"A\": \"translation\" is not read, the node is as it was\n"
              "s.x3d:3: warning: USE of \"A\": what stands in it is not read, the node is as it was\n");
    EXPECT_EQ(ofXml("\n<Group>\n\nword</Group>"), "s.x3d:4: warning: text in \"Group\" skipped\n");
    Scene two;
    EXPECT_TRUE(readSceneText(two, kXmlStart + std::string("</Scene></X3D>\n<X3D/>"), "s"));
    EXPECT_EQ(messagesOf(two), "s:2: warning: expected one element X3D, found another, \"X3D\": skipped\n");
}

/// A folder with a scene in it, and one beside it.
class SceneFiles : public testing::Test
{
protected:
    SceneFiles()
    {
        std::filesystem::create_directory(folder / "scene");
        std::filesystem::create_directory(folder / "outside");
        write("outside/secret.x3d", "<Group/>");
        write("scene/below.x3d", "<Group DEF='Inner'/><Group/>");
    }
    void write(const std::string& name, const std::string& nodes)
    {
        std::ofstream(folder / name) << kXmlStart << nodes << "</Scene></X3D>";
    }
    /// The messages of a scene with an Inline of this url; the nodes that came are counted.
    std::string ofUrl(const std::string& url, const std::string& allowed = "")
    {
        write("scene/top.x3d", "<Inline DEF='I' url='\"" + url + "\"'/>");
        Scene scene;
        if (!allowed.empty()) scene.folders.allow(allowed);
        EXPECT_TRUE(readScene(scene, folder / "scene/top.x3d"));
        inlined = scene.names.at("I")->inlined.size();
        std::string lines;
        for (const SceneMessage& message : scene.messages)
            lines += message.text + "\n";
        return lines;
    }
    ScratchFolder folder;
    std::size_t inlined = 0;
};

TEST_F(SceneFiles, inlineReadsBelowTheScenesFolderAlone)
{
    EXPECT_EQ(ofUrl("below.x3d"), "");
    EXPECT_EQ(inlined, 2u);
    EXPECT_EQ(ofUrl("../outside/secret.x3d"), "Inline: \"../outside/secret.x3d\" is not below the folder of "
                                              "the scene (-allow FOLDER lets it in)\n");
    EXPECT_EQ(inlined, 0u);
    EXPECT_EQ(ofUrl("%2e%2e/outside/secret.x3d").substr(0, 7), "Inline:");
    EXPECT_EQ(ofUrl(folder / "outside/secret.x3d").substr(0, 7), "Inline:");
    EXPECT_EQ(ofUrl("file://" + (folder / "outside/secret.x3d")).substr(0, 7), "Inline:");
    EXPECT_EQ(ofUrl("../outside/secret.x3d", folder / "outside"), "");
    EXPECT_EQ(inlined, 1u);
    EXPECT_EQ(ofUrl("file://" + (folder / "outside/secret.x3d"), folder / "outside"), "");
    EXPECT_EQ(ofUrl("nothing.x3d"), "Inline: \"nothing.x3d\": no such file\n");
    EXPECT_EQ(ofUrl("http://example.org/a.x3d"),
              "Inline: \"http://example.org/a.x3d\" is in a network or no file: not read\n");
}

TEST_F(SceneFiles, linksThatLeadOutsideCountAsOutside)
{
    std::filesystem::create_symlink("../outside/secret.x3d", folder / "scene/link.x3d");
    std::filesystem::create_directory_symlink("../outside", folder / "scene/door");
    std::filesystem::create_symlink("below.x3d", folder / "scene/near.x3d");
    EXPECT_NE(ofUrl("link.x3d"), "");
    EXPECT_NE(ofUrl("door/secret.x3d"), "");
    EXPECT_EQ(inlined, 0u);
    EXPECT_EQ(ofUrl("near.x3d"), "");
    EXPECT_EQ(inlined, 2u);
}

TEST_F(SceneFiles, inlineOfItselfIsRefused)
{
    EXPECT_EQ(ofUrl("top.x3d"), "Inline: \"top.x3d\" is in itself\n");
    write("scene/a.x3d", "<Inline url='\"b.x3d\"'/>");
    write("scene/b.x3d", "<Inline url='\"a.x3d\"'/>");
    EXPECT_EQ(ofUrl("a.x3d"), "Inline: \"a.x3d\" is in itself\n");
}

TEST_F(SceneFiles, inlinesThatMultiplyAreBounded)
{
    for (int i = 0; i < 18; ++i) {
        const std::string next = "<Inline url='\"m" + std::to_string(i + 1) + ".x3d\"'/>";
        write("scene/m" + std::to_string(i) + ".x3d", next + next + next);
    }
    write("scene/m18.x3d", "<Group/>");
    EXPECT_NE(ofUrl("m0.x3d").find("is one file too many: at most 1000, 20 deep"), std::string::npos);
}

TEST_F(SceneFiles, namesOfAnInlineAreItsOwn)
{
    write("scene/top.x3d", "<Inline url='\"below.x3d\"'/><Group DEF='Inner'/>\n<Group USE='Inner'/>");
    Scene scene;
    ASSERT_TRUE(readScene(scene, folder / "scene/top.x3d"));
    EXPECT_EQ(messagesOf(scene), "");
    EXPECT_EQ(scene.names.at("Inner")->scope, 0);
}

TEST_F(SceneFiles, checkTellsMissingFilesAndComponents)
{
    std::ofstream(folder / "scene/top.x3d")
        << "<X3D profile='Immersive' version='4.0'><Scene>\n<VolumeData>\n"
           "<ImageTexture3D containerField='voxels' url='\"gone.nrrd\"'/></VolumeData></Scene></X3D>";
    Scene scene;
    ASSERT_TRUE(readScene(scene, folder / "scene/top.x3d"));
    checkScene(scene);
    ASSERT_EQ(scene.messages.size(), 3u) << messagesOf(scene);
    EXPECT_EQ(scene.messages[0].text,
              "VolumeData is of the component VolumeRendering, level 1, which the profile "
              "Immersive does not bring and no component statement names");
    EXPECT_EQ(scene.messages[2].place.line, 3);
    EXPECT_EQ(scene.messages[2].text, "ImageTexture3D.url: \"gone.nrrd\": no such file");
}

TEST_F(SceneFiles, gzipIsRead)
{
    write("scene/top.x3d", "<Group DEF='G'/>");
    ASSERT_EQ(std::system(("gzip -f " + (folder / "scene/top.x3d")).c_str()), 0);
    Scene scene;
    EXPECT_TRUE(readScene(scene, folder / "scene/top.x3d.gz"));
    EXPECT_EQ(messagesOf(scene), "");
    EXPECT_EQ(scene.names.count("G"), 1u);
    std::filesystem::resize_file(folder / "scene/top.x3d.gz",
                                 std::filesystem::file_size(folder / "scene/top.x3d.gz") - 12);
    Scene cut;
    EXPECT_FALSE(readScene(cut, folder / "scene/top.x3d.gz"));
    EXPECT_EQ(cut.messages.back().text, "cannot read: unexpected end of file");
    SceneLimits small;
    small.bytes = 20;
    Scene tooLarge;
    EXPECT_FALSE(readScene(tooLarge, folder / "scene/top.x3d.gz", small));
    EXPECT_EQ(tooLarge.messages.back().text, "expected at most 20 bytes of text, found more");
}

} // namespace
} // namespace vo
