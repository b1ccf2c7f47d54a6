// The support levels of the proposal of 2005, table 2: every field of every node that they name changes the
// picture, or is listed here as one that no text gives a meaning.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <vo/x3d/View.h>

#include "../util/scratch_folder.h"

namespace {

constexpr int kSize = 24;
constexpr int kVoxels = 12;

/// Voxels of a large ball and of a small one between it and the light, in the components that a number stands
/// for: `packed` makes it of a value from 0 to 255 and of which ball is nearer, 1 or 2.
template <class Pack>
std::string balls(const std::string& field, int components, Pack packed)
{
    std::string image = std::to_string(components) + " 12 12 12";
    for (int z = 0; z < kVoxels; ++z)
        for (int y = 0; y < kVoxels; ++y)
            for (int x = 0; x < kVoxels; ++x) {
                const auto away = [&](double a, double b, double c) {
                    return std::hypot(x + 0.5 - a, y + 0.5 - b, z + 0.5 - c);
                };
                const double large = 3.5 - away(6.5, 5, 5), small = 1.8 - away(3, 9, 9);
                const double value = std::clamp(128 + 60 * std::max(large, small), 0.0, 255.0);
                image += " " + std::to_string(packed(int(value), large > small ? 1 : 2));
            }
    return "<PixelTexture3D containerField='" + field + "' image='" + image + "'/>";
}

const std::string kVoxelsNode = balls("voxels", 1, [](int value, int) { return value; });
const std::string kOtherVoxels = balls("voxels", 1, [](int value, int) { return value / 2; });
/// All normals along x.
const std::string kNormals = balls("surfaceNormals", 3, [](int, int) { return 0xFF8080; });
const std::string kTable =
    "<PixelTexture containerField='transferFunction' image='4 1 4 0xFF800000 0xFF800010 "
    "0xFFA04060 0xFFC080A0'/>";
const std::string kMap = "<OpacityMapVolumeStyle>" + kTable + "</OpacityMapVolumeStyle>";

std::string volume(const std::string& below, const std::string& attributes = "dimensions='2 2 2'")
{
    return "<VolumeData " + attributes + ">" + kVoxelsNode + below + "</VolumeData>";
}

/// Behind a table, since most styles keep its colour or its opacity.
std::string behindTable(const std::string& node, const std::string& attributes, const std::string& below)
{
    return volume("<CompositeVolumeStyle ordered='true'>" + kMap + "<" + node + " " + attributes + ">" +
                  below + "</" + node + "></CompositeVolumeStyle>");
}

std::string alone(const std::string& node, const std::string& attributes, const std::string& below)
{
    return volume("<" + node + " " + attributes + ">" + below + "</" + node + ">");
}

/// Nearer and nearer: what goes by how far the eye was in the beginning shows.
std::string wholeScene(const std::string& nodes)
{
    return "<X3D profile='Full' version='3.0'><Scene><Viewpoint position='0.5 1 4'/>"
           "<NavigationInfo headlight='false'/><DirectionalLight direction='0.6 -0.6 -0.6' global='true' "
           "ambientIntensity='0.2'/><TimeSensor DEF='Clock' loop='true' cycleInterval='2'/>"
           "<PositionInterpolator DEF='Way' key='0 1' keyValue='0 0 0 0 0 1'/>"
           "<Transform DEF='Moving'>" +
           nodes +
           "</Transform><ROUTE fromNode='Clock' fromField='fraction_changed' toNode='Way' "
           "toField='set_fraction'/>"
           "<ROUTE fromNode='Way' fromField='value_changed' toNode='Moving' toField='set_translation'/>"
           "</Scene></X3D>";
}

struct Drawn
{
    std::vector<float> picture;
    std::string messages;
};

Drawn drawn(const std::string& nodes)
{
    const std::string text = wholeScene(nodes);
    voX3DScene scene;
    EXPECT_TRUE(scene.readText(text.data(), text.size(), "scene"));
    voX3DView view(scene);
    view.setSize(kSize, kSize);
    Drawn result;
    result.picture.resize(4 * kSize * kSize);
    for (const double time : {0.0, 1.0}) {
        view.setTime(time);
        EXPECT_TRUE(view.picture(result.picture.data()));
    }
    scene.check();
    for (int i = 0; i < scene.getMessageCount(); ++i)
        result.messages += std::string(scene.getMessage(i)) + "\n";
    return result;
}

double mostDifference(const Drawn& one, const Drawn& other)
{
    double most = 0;
    for (std::size_t i = 0; i < one.picture.size(); ++i)
        most = std::max(most, double(std::abs(one.picture[i] - other.picture[i])));
    return most;
}

/// Of the colours alone.
double brightest(const Drawn& one)
{
    float most = 0;
    for (std::size_t i = 0; i < one.picture.size(); ++i)
        if (i % 4 != 3) most = std::max(most, one.picture[i]);
    return double(most);
}

/// A field, the two values that are compared, and what else is set. Values are attributes, or nodes below.
struct FieldCase
{
    const char *level, *node, *field;
    std::string one, other;
};

/// Fields of styles, whose values are attributes.
struct Attribute
{
    const char *level, *node, *field, *one, *other, *more;
};

const Attribute kAttributes[] = {
    {"1", "OpacityMapVolumeStyle", "enabled", "true", "false", ""},
    {"2", "BoundaryEnhancementVolumeStyle", "enabled", "true", "false", ""},
    {"2", "BoundaryEnhancementVolumeStyle", "retainedOpacity", "1", "0.2", ""},
    {"2", "BoundaryEnhancementVolumeStyle", "boundaryOpacity", "0", "3", "retainedOpacity='0'"},
    {"2", "BoundaryEnhancementVolumeStyle", "opacityFactor", "1", "3", "boundaryOpacity='3'"},
    {"2", "BoundaryEnhancementVolumeStyle", "gradientColor", "0 0 1 1", "0 1 0 0.5", ""},
    {"2", "CompositeVolumeStyle", "enabled", "true", "false", ""},
    {"2", "EdgeEnhancementVolumeStyle", "enabled", "true", "false", ""},
    {"2", "EdgeEnhancementVolumeStyle", "edgeColor", "0 0 0 1", "0 0 1 1", ""},
    {"2", "EdgeEnhancementVolumeStyle", "gradientThreshold", "0.2", "1.4", ""},
    {"3", "SilhouetteEnhancementVolumeStyle", "enabled", "true", "false", ""},
    {"3", "SilhouetteEnhancementVolumeStyle", "silhouetteFactor", "0.5", "4", ""},
    {"3", "ToneMappedVolumeStyle", "enabled", "true", "false", ""},
    {"3", "ToneMappedVolumeStyle", "coolColor", "0 0 1 0", "0 1 0 0", ""},
    {"3", "ToneMappedVolumeStyle", "warmColor", "1 1 0 0", "1 0 0 0", ""},
    {"3", "ISOVolumeStyle", "enabled", "true", "false", ""},
    {"3", "ISOVolumeStyle", "lighting", "true", "false", ""},
    {"3", "ISOVolumeStyle", "shadows", "true", "false", "lighting='true'"},
    {"3", "CartoonVolumeStyle", "enabled", "true", "false", ""},
    {"3", "CartoonVolumeStyle", "parallelColor", "0 0 0 1", "0 0 1 1", ""},
    {"3", "CartoonVolumeStyle", "orthogonalColor", "1 1 1 1", "0 1 0 1", ""},
    {"3", "CartoonVolumeStyle", "colorSteps", "4", "2", ""},
    {"3", "StippleVolumeStyle", "enabled", "true", "false", ""},
    {"3", "StippleVolumeStyle", "distanceFactor", "0", "4", "gradientRetainedOpacity='0.2'"},
    {"3", "StippleVolumeStyle", "interiorFactor", "0.5", "3", ""},
    {"3", "StippleVolumeStyle", "lightingFactor", "0.2", "4", ""},
    {"3", "StippleVolumeStyle", "gradientThreshold", "0", "1.5",
     "gradientRetainedOpacity='0' gradientBoundaryOpacity='4'"},
    {"3", "StippleVolumeStyle", "gradientRetainedOpacity", "1", "0.1", ""},
    {"3", "StippleVolumeStyle", "gradientBoundaryOpacity", "0", "4", "gradientRetainedOpacity='0'"},
    {"3", "StippleVolumeStyle", "gradientOpacityFactor", "0.2", "4",
     "gradientRetainedOpacity='0' gradientBoundaryOpacity='4'"},
    {"3", "StippleVolumeStyle", "silhouetteRetainedOpacity", "1", "0.1", ""},
    {"3", "StippleVolumeStyle", "silhouetteBoundaryOpacity", "0", "4", "silhouetteRetainedOpacity='0'"},
    {"3", "StippleVolumeStyle", "silhouetteOpacityFactor", "0.2", "6",
     "silhouetteRetainedOpacity='0' silhouetteBoundaryOpacity='2'"},
    {"3", "StippleVolumeStyle", "resolutionFactor", "0", "6", "gradientRetainedOpacity='0.4'"},
};

/// Styles that take surfaceNormals and do something with them.
const Attribute kWithNormals[] = {
    {"2", "EdgeEnhancementVolumeStyle", "surfaceNormals", "", "", ""},
    {"3", "SilhouetteEnhancementVolumeStyle", "surfaceNormals", "", "", ""},
    {"3", "ToneMappedVolumeStyle", "surfaceNormals", "", "", ""},
    {"3", "ISOVolumeStyle", "surfaceNormals", "", "", "lighting='true'"},
    {"3", "CartoonVolumeStyle", "surfaceNormals", "", "", ""},
};

bool drawsAlone(const std::string& node)
{
    return node == "StippleVolumeStyle" || node == "OpacityMapVolumeStyle";
}

std::string withAttribute(const Attribute& row, const char* value)
{
    const std::string attributes = std::string(row.field) + "='" + value + "' " + row.more;
    if (std::string(row.node) == "CompositeVolumeStyle") return alone(row.node, attributes, kMap);
    return drawsAlone(row.node) ? alone(row.node, attributes, "") : behindTable(row.node, attributes, "");
}

std::string segments(const std::string& attributes, const std::string& styles, int shift = 1)
{
    return "<SegmentedVolumeData " + attributes + ">" +
           balls("segmentedVoxels", 2,
                 [shift](int value, int ball) { return value << 8 | (ball == 1 ? 0 : shift); }) +
           styles + "</SegmentedVolumeData>";
}

std::string octTree(const std::string& attributes, const std::string& high, const std::string& low)
{
    return "<OctTree DEF='Tree' " + attributes + "><Transform containerField='highRes'>" + high +
           "</Transform><Transform containerField='lowRes'>" + low + "</Transform></OctTree>";
}

const std::string kRed = volume("<CartoonVolumeStyle orthogonalColor='1 0 0 1' colorSteps='1'/>");
const std::string kBlue = volume("<CartoonVolumeStyle orthogonalColor='0 0 1 1' colorSteps='1'/>");

std::vector<FieldCase> fieldCases()
{
    const std::string cube = "dimensions='2 2 2'", edge = "<EdgeEnhancementVolumeStyle/>";
    const std::string otherTable =
        "<PixelTexture containerField='transferFunction' image='2 1 4 0 0x0000FFFF'/>";
    const std::string bricks = "<OpacityMapVolumeStyle/>" + edge;
    std::vector<FieldCase> cases{
        {"1", "VolumeData", "dimensions", volume(kMap), volume(kMap, "dimensions='2 1 2'")},
        {"1", "VolumeData", "renderStyle", volume(""), volume(kMap)},
        {"1", "VolumeData", "voxels", volume(kMap),
         "<VolumeData dimensions='2 2 2'>" + kOtherVoxels + kMap + "</VolumeData>"},
        {"1", "OpacityMapVolumeStyle", "transferFunction", alone("OpacityMapVolumeStyle", "", kTable),
         alone("OpacityMapVolumeStyle", "", otherTable)},
        {"1", "OctTree", "highRes", octTree("", kRed, kBlue), octTree("", kBlue, kBlue)},
        {"1", "OctTree", "lowRes", octTree("range='1'", kRed, kBlue), octTree("range='1'", kRed, kRed)},
        {"1", "OctTree", "range", octTree("range='8'", kRed, kBlue), octTree("range='1'", kRed, kBlue)},
        {"1", "OctTree", "center", octTree("range='8'", kRed, kBlue),
         octTree("range='8' center='0 0 -20'", kRed, kBlue)},
        {"2", "BoundaryEnhancementVolumeStyle", "transferFunction",
         alone("BoundaryEnhancementVolumeStyle", "", kTable),
         alone("BoundaryEnhancementVolumeStyle", "", otherTable)},
        {"2", "CompositeVolumeStyle", "styles", alone("CompositeVolumeStyle", "", kMap),
         alone("CompositeVolumeStyle", "", kMap + edge)},
        {"3", "SegmentedVolumeData", "dimensions", segments(cube, kMap),
         segments("dimensions='2 1 2'", kMap)},
        {"3", "SegmentedVolumeData", "renderStyle", segments(cube, kMap), segments(cube, kMap + kMap)},
        {"3", "SegmentedVolumeData", "segmentEnabled", segments(cube, kMap),
         segments(cube + " segmentEnabled='false'", kMap)},
        {"3", "SegmentedVolumeData", "segmentedVoxels", segments(cube, kMap), segments(cube, kMap, 0)},
    };
    for (const Attribute& row : kAttributes)
        cases.push_back(
            {row.level, row.node, row.field, withAttribute(row, row.one), withAttribute(row, row.other)});
    for (const Attribute& row : kWithNormals)
        cases.push_back({row.level, row.node, row.field, behindTable(row.node, row.more, ""),
                         behindTable(row.node, row.more, kNormals)});
    return cases;
}

/// Fields that no text says how to draw by: the picture stays.
struct Silent
{
    const char *level, *node, *field;
    std::string one, other, message;
};

std::vector<Silent> silentFields()
{
    const std::string cube = "dimensions='2 2 2' ", boundary = "BoundaryEnhancementVolumeStyle";
    const auto changesNothing = [](const std::string& field) {
        return "scene:1: warning: " + field + " is in no equation and changes nothing\n";
    };
    std::vector<Silent> silent{
        {"2", "BoundaryEnhancementVolumeStyle", "contribution", behindTable(boundary, "", ""),
         behindTable(boundary, "contribution='0.9'", ""), changesNothing(boundary + ".contribution")},
        {"2", "BoundaryEnhancementVolumeStyle", "surfaceNormals", behindTable(boundary, "", ""),
         behindTable(boundary, "", kNormals), changesNothing(boundary + ".surfaceNormals")},
        {"2", "EdgeEnhancementVolumeStyle", "contribution", behindTable("EdgeEnhancementVolumeStyle", "", ""),
         behindTable("EdgeEnhancementVolumeStyle", "contribution='0.9'", ""),
         changesNothing("EdgeEnhancementVolumeStyle.contribution")},
        {"2", "CompositeVolumeStyle", "ordered", alone("CompositeVolumeStyle", "ordered='false'", kMap),
         alone("CompositeVolumeStyle", "ordered='true'", kMap), ""},
    };
    for (const char* const field : {"bboxCenter", "bboxSize"}) {
        const std::string box = std::string(field) + "='2 2 2'";
        silent.push_back({"1", "VolumeData", field, volume(kMap), volume(kMap, cube + box), ""});
        silent.push_back({"1", "OctTree", field, octTree("", kRed, kBlue), octTree(box, kRed, kBlue), ""});
        silent.push_back(
            {"3", "SegmentedVolumeData", field, segments(cube, kMap), segments(cube + box, kMap), ""});
    }
    return silent;
}

TEST(ProposalLevels, everyFieldWithAMeaningChangesThePicture)
{
    for (const FieldCase& each : fieldCases()) {
        const std::string where = std::string("level ") + each.level + " " + each.node + "." + each.field;
        const Drawn one = drawn(each.one), other = drawn(each.other);
        EXPECT_GT(mostDifference(one, other), 0.05) << where;
        EXPECT_GT(std::max(brightest(one), brightest(other)), 0.1) << where;
        EXPECT_EQ(one.messages + other.messages, "") << where;
    }
}

TEST(ProposalLevels, fieldsWithoutAMeaningLeaveThePictureAndAreToldOf)
{
    for (const Silent& each : silentFields()) {
        const std::string where = std::string("level ") + each.level + " " + each.node + "." + each.field;
        const Drawn one = drawn(each.one), other = drawn(each.other);
        EXPECT_EQ(mostDifference(one, other), 0) << where;
        EXPECT_GT(brightest(one), 0.1) << where;
        EXPECT_EQ(one.messages, "") << where;
        EXPECT_EQ(other.messages, each.message) << where;
    }
}

TEST(ProposalLevels, allFieldsOfAllNodesAreListed)
{
    std::map<std::string, std::set<std::string>> listed;
    for (const FieldCase& each : fieldCases())
        EXPECT_TRUE(listed[each.node].insert(each.field).second) << each.node << "." << each.field;
    for (const Silent& each : silentFields())
        EXPECT_TRUE(listed[each.node].insert(each.field).second) << each.node << "." << each.field;
    EXPECT_EQ(listed.size(), 12u) << "nodes of table 2";
    // What it sends is a case of its own.
    listed["OctTree"].insert("lowResActive");
    voX3DScene scene;
    const std::string text = wholeScene("");
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "scene"));
    for (const auto& [name, fields] : listed) {
        const voX3DNode node = scene.createNode(name.c_str());
        ASSERT_EQ(node.getEdition(), voX3DScope::PROPOSAL_2005) << name;
        for (int i = 0; i < node.getFieldCount(); ++i) {
            const std::string field = node.getFieldName(i);
            EXPECT_TRUE(field == "metadata" || fields.contains(field)) << name << "." << field;
        }
    }
}

TEST(ProposalLevels, oneToFourComponentsAreDrawnInEveryStyle)
{
    for (int components = 1; components <= 4; ++components) {
        const std::string voxels = balls("voxels", components, [components](int value, int) {
            unsigned packed = 0;
            for (int i = 0; i < components; ++i)
                packed = packed << 8 | unsigned(value);
            return packed;
        });
        for (const Attribute& row : kAttributes) {
            if (std::string(row.field) != "enabled") continue;
            const std::string below = std::string(row.node) == "CompositeVolumeStyle" ? kMap : "";
            const Drawn one = drawn("<VolumeData dimensions='2 2 2'>" + voxels + "<" + row.node + ">" +
                                    below + "</" + row.node + "></VolumeData>");
            EXPECT_GT(brightest(one), 0.1) << row.node << " of " << components;
            EXPECT_EQ(one.messages, "") << row.node << " of " << components;
        }
    }
}

TEST(ProposalLevels, lowResActiveIsSentToOthers)
{
    const std::string route =
        "<ROUTE fromNode='Tree' fromField='lowResActive' toNode='Style' toField='enabled'/>";
    const auto both = [&](const char* range) {
        return drawn(octTree("range='" + std::string(range) + "'", "<Group/>", "<Group/>") +
                     volume("<OpacityMapVolumeStyle DEF='Style' enabled='false'/>") + route);
    };
    EXPECT_EQ(brightest(both("9")), 0);
    EXPECT_GT(brightest(both("1")), 0.1);
}

/// A volume of these sizes, all of it opaque red but its first slice along x, as a file.
void expectSizeIsDrawn(int x, int y, int z)
{
    const vo::ScratchFolder folder;
    {
        std::ofstream file(folder / "v.nrrd", std::ios::binary);
        file << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: " << x << ' ' << y << ' ' << z
             << "\nencoding: raw\n\n";
        const std::string row = '\0' + std::string(std::size_t(x - 1), '\xff');
        for (int i = 0; i < y * z; ++i)
            file << row;
    }
    std::ofstream(folder / "s.x3d")
        << "<X3D profile='Full' version='3.0'><Scene><Viewpoint position='0 0 400'/><VolumeData dimensions='"
        << x << ' ' << y << ' ' << z
        << "'><ImageTexture3D containerField='voxels' url='\"v.nrrd\"'/><OpacityMapVolumeStyle><PixelTexture "
           "containerField='transferFunction' image='2 1 4 0 "
           "0xFF0000FF'/></OpacityMapVolumeStyle></VolumeData>"
           "</Scene></X3D>";
    voX3DScene scene;
    ASSERT_TRUE(scene.read((folder / "s.x3d").c_str()));
    voX3DView view(scene);
    view.setSize(kSize, kSize);
    std::vector<float> picture(4 * kSize * kSize);
    ASSERT_TRUE(view.picture(picture.data()));
    EXPECT_EQ(scene.getMessageCount(), 0);
    const std::size_t middle = 4 * (kSize / 2 * kSize + kSize / 2);
    EXPECT_NEAR(picture[middle], 1, 1e-4) << x << ' ' << y << ' ' << z;
    EXPECT_NEAR(picture[middle + 1], 0, 1e-4);
}

TEST(ProposalLevels, volumesOf256VoxelsASideAndOfAnySizeAreDrawn)
{
    expectSizeIsDrawn(256, 256, 256);
    expectSizeIsDrawn(257, 129, 3);
}

} // namespace
