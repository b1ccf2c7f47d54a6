// Every node and field, its type, access and default in each edition, read back through the face.

#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <vector>

#include <vo/Error.h>
#include <vo/x3d/Scene.h>

#include "expected_fields.h"

namespace {

const char* const kTypes[] = {"SFBool",     "MFBool",     "SFInt32", "MFInt32", "SFFloat",     "MFFloat",
                              "SFDouble",   "MFDouble",   "SFTime",  "MFTime",  "SFString",    "MFString",
                              "SFVec2f",    "MFVec2f",    "SFVec3f", "MFVec3f", "SFVec4f",     "MFVec4f",
                              "SFRotation", "MFRotation", "SFColor", "MFColor", "SFColorRGBA", "MFColorRGBA",
                              "SFImage",    "SFNode",     "MFNode"};
const char* const kAccesses[] = {"[]", "[in]", "[out]", "[in,out]"};

/// An empty scene of a version of X3D.
void readVersion(voX3DScene& scene, const std::string& version)
{
    const std::string text = "<X3D profile='Full' version='" + version + "'><Scene/></X3D>";
    ASSERT_TRUE(scene.readText(text.data(), text.size(), "memory"));
    ASSERT_EQ(scene.getMessageCount(), 0) << scene.getMessage(0);
}

std::string shown(float number)
{
    std::ostringstream out;
    out << number;
    return out.str();
}

/// A default in the words of expected_fields.h.
std::string valueOf(const voX3DNode& node, const char* field)
{
    const std::string type = kTypes[node.getFieldType(field)];
    const int count = node.getCount(field);
    if (type == "SFNode") return node.getNode(field).isNull() ? "NULL" : "a node";
    std::vector<std::string> words;
    if (type == "MFNode") {
        words.resize(static_cast<std::size_t>(count), "a node");
    } else if (type.ends_with("String")) {
        for (int i = 0; i < count; ++i)
            words.push_back("\"" + std::string(node.getString(field, i)) + "\"");
    } else if (type.ends_with("Bool")) {
        for (int i = 0; i < count; ++i)
            words.push_back(node.getInts(field)[i] ? "TRUE" : "FALSE");
    } else if (type.ends_with("Int32") || type == "SFImage") {
        for (int i = 0; i < count; ++i)
            words.push_back(std::to_string(node.getInts(field)[i]));
    } else if (type.ends_with("Time") || type.ends_with("Double")) {
        for (int i = 0; i < count; ++i)
            words.push_back(shown(static_cast<float>(node.getDoubles(field)[i])));
    } else {
        const int parts = type.ends_with("2f")                              ? 2
                          : type.ends_with("3f") || type.ends_with("Color") ? 3
                          : type.ends_with("Float")                         ? 1
                                                                            : 4;
        for (int i = 0; i < count * parts; ++i)
            words.push_back(shown(node.getFloats(field)[i]));
    }
    std::string line;
    for (const std::string& word : words)
        line += (line.empty() ? "" : " ") + word;
    return line.empty() && !type.starts_with("SF") ? "[]" : line;
}

/// A number of expected_fields.h as valueOf writes it: 0.785398 has more digits than a stream shows.
std::string rewritten(const std::string& text)
{
    std::istringstream in(text);
    std::string out, word;
    while (in >> word) {
        std::istringstream number(word);
        float value = 0;
        const bool isNumber = static_cast<bool>(number >> value) && number.eof();
        out += (out.empty() ? "" : " ") + (isNumber ? shown(value) : word);
    }
    return out;
}

void compareField(const voX3DNode& node, const std::string& line)
{
    std::istringstream in(line);
    std::string field, type, access, value;
    in >> field >> type >> access;
    std::getline(in, value);
    const std::string where = std::string(node.getTypeName()) + "." + field;
    ASSERT_TRUE(node.hasField(field.c_str())) << where;
    EXPECT_EQ(kTypes[node.getFieldType(field.c_str())], type) << where;
    EXPECT_EQ(kAccesses[node.getFieldAccess(field.c_str())], access) << where;
    EXPECT_FALSE(node.isSet(field.c_str())) << where;
    if (rewritten(value) == "-") return;
    EXPECT_EQ(valueOf(node, field.c_str()), rewritten(value)) << where;
}

/// Returns how many nodes the text has.
int compareNodes(const char* version, std::string_view expectedNodes, voX3DScope::voX3DEdition edition)
{
    voX3DScene scene;
    readVersion(scene, version);
    std::istringstream in{std::string(expectedNodes)};
    voX3DNode node;
    int fields = 0, nodes = 0;
    const auto closeNode = [&] {
        // What is not in the list, metadata apart, is no field.
        if (node.isNull()) return;
        EXPECT_EQ(node.getFieldCount(), fields + 1) << node.getTypeName() << " in " << version;
    };
    for (std::string line; std::getline(in, line);) {
        if (line.empty()) continue;
        if (line[0] == ' ') {
            compareField(node, line);
            ++fields;
            continue;
        }
        closeNode();
        node = scene.createNode(line.c_str());
        EXPECT_FALSE(node.isNull()) << line;
        if (node.isNull()) return nodes;
        EXPECT_EQ(node.getTypeName(), line);
        EXPECT_EQ(node.getEdition(), edition) << line;
        EXPECT_EQ(valueOf(node, "metadata"), "NULL");
        fields = 0;
        ++nodes;
    }
    closeNode();
    return nodes;
}

TEST(NodeFields, areThoseOfTheProposal)
{
    EXPECT_EQ(compareNodes("3.0", expected::kProposal2005, voX3DScope::PROPOSAL_2005), 12);
}

TEST(NodeFields, areThoseOfX3d33)
{
    EXPECT_EQ(compareNodes("3.3", expected::kIsoStyles, voX3DScope::X3D_33), 10);
    EXPECT_EQ(compareNodes("3.3", expected::kIsoData33, voX3DScope::X3D_33), 3);
}

TEST(NodeFields, areThoseOfX3d40)
{
    EXPECT_EQ(compareNodes("4.0", expected::kIsoStyles, voX3DScope::X3D_40), 10);
    EXPECT_EQ(compareNodes("4.0", expected::kIsoData40, voX3DScope::X3D_40), 3);
    EXPECT_EQ(compareNodes("4.0", expected::kRound40, voX3DScope::X3D_40), 51);
}

TEST(NodeFields, nodesOfOneEditionHaveItInAnyScene)
{
    voX3DScene scene;
    readVersion(scene, "4.0");
    const voX3DNode composite = scene.createNode("CompositeVolumeStyle");
    EXPECT_EQ(composite.getEdition(), voX3DScope::PROPOSAL_2005);
    EXPECT_TRUE(composite.hasField("styles"));
    EXPECT_FALSE(composite.hasField("renderStyle"));
    EXPECT_TRUE(composite.isType("ComposedVolumeStyle"));
    readVersion(scene, "3.1");
    EXPECT_EQ(scene.createNode("BlendedVolumeStyle").getEdition(), voX3DScope::X3D_33);
    EXPECT_EQ(std::string(scene.createNode("ISOVolumeStyle").getTypeName()), "ISOSurfaceVolumeStyle");
}

struct Limit
{
    const char *version, *node, *field;
    float inside, outside;
};

TEST(NodeFields, numbersOutsideTheirRangesAreRefused)
{
    const Limit limits[] = {
        {"3.0", "BoundaryEnhancementVolumeStyle", "retainedOpacity", 1, 1.01f},
        {"3.0", "BoundaryEnhancementVolumeStyle", "boundaryOpacity", 50, -0.1f},
        {"4.0", "BoundaryEnhancementVolumeStyle", "boundaryOpacity", 1, 50},
        {"3.0", "BoundaryEnhancementVolumeStyle", "opacityFactor", 0.5f, -1},
        {"4.0", "BoundaryEnhancementVolumeStyle", "opacityFactor", 1, 0.5f},
        {"3.0", "BoundaryEnhancementVolumeStyle", "contribution", 1, 2},
        {"3.0", "EdgeEnhancementVolumeStyle", "gradientThreshold", 1.5708f, 1.6f},
        {"4.0", "EdgeEnhancementVolumeStyle", "gradientThreshold", 3.1416f, 3.2f},
        {"3.0", "EdgeEnhancementVolumeStyle", "contribution", 0, -0.1f},
        {"3.0", "SilhouetteEnhancementVolumeStyle", "silhouetteFactor", 9, -1},
        {"3.0", "StippleVolumeStyle", "gradientThreshold", 1.57f, 1.6f},
        {"3.0", "StippleVolumeStyle", "silhouetteRetainedOpacity", 1, 2},
        {"4.0", "IsoSurfaceVolumeData", "surfaceTolerance", 0, -0.1f},
        {"4.0", "Material", "transparency", 1, 1.1f},
        {"4.0", "Sphere", "radius", 0.1f, 0},
    };
    voX3DScene scene;
    for (const Limit& limit : limits) {
        readVersion(scene, limit.version);
        voX3DNode node = scene.createNode(limit.node);
        voError::getErrorNumber();
        node.setFloat(limit.field, limit.inside);
        EXPECT_EQ(voError::getErrorNumber(), voError::NO_ERROR) << limit.node << "." << limit.field;
        node.setFloat(limit.field, limit.outside);
        EXPECT_EQ(voError::getErrorNumber(), voError::BAD_VALUE) << limit.node << "." << limit.field;
        EXPECT_EQ(node.getFloats(limit.field)[0], limit.inside);
    }
}

TEST(NodeFields, wholeNumbersVectorsAndChoicesHaveRangesToo)
{
    voX3DScene scene;
    readVersion(scene, "4.0");
    voX3DNode cartoon = scene.createNode("CartoonVolumeStyle"), volume = scene.createNode("VolumeData");
    voX3DNode projection = scene.createNode("ProjectionVolumeStyle");
    const auto refused = [] { return voError::getErrorNumber() == voError::BAD_VALUE; };
    cartoon.setInt("colorSteps", 64);
    EXPECT_FALSE(refused());
    cartoon.setInt("colorSteps", 65);
    EXPECT_TRUE(refused());
    const float flat[] = {1, 0, 1}, unknownBox[] = {-1, -1, -1}, wrongBox[] = {-2, 1, 1};
    volume.setFloats("dimensions", flat, 3);
    EXPECT_TRUE(refused());
    volume.setFloats("bboxSize", unknownBox, 3);
    EXPECT_FALSE(refused());
    volume.setFloats("bboxSize", wrongBox, 3);
    EXPECT_TRUE(refused());
    projection.setString("type", "MIN");
    EXPECT_FALSE(refused());
    projection.setString("type", "MEDIAN");
    EXPECT_TRUE(refused());
    readVersion(scene, "3.0");
    volume = scene.createNode("VolumeData");
    volume.setFloats("dimensions", flat, 3);
    EXPECT_FALSE(refused());
}

} // namespace
