// Scenes that are written and read again are the same, in both encodings, and one encoding says what the
// other does.

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

#include "same_graph.h"
#include "x3d/read_scene.h"
#include "x3d/write_scene.h"

namespace vo {
namespace {

/// Random scenes of every node: any field, any value that it may have.
class RandomScene
{
public:
    RandomScene(unsigned seed, Edition edition) : random_(seed)
    {
        scene.edition = edition;
        scene.header.version = edition == Edition::proposal2005 ? "3.1"
                               : edition == Edition::x3d33      ? "3.3"
                                                                : "4.0";
        for (int i = 0; i < 6; ++i)
            if (Node* const node = make(knownNodeType("X3DChildNode"), 0)) scene.roots.push_back(node);
        addRoutes();
    }

    Scene scene;

private:
    int upTo(int most) { return std::uniform_int_distribution<int>(0, most)(random_); }

    /// A node of a type, new or, now and then, one that is there already.
    Node* make(const NodeType& base, int depth)
    {
        if (depth > 5) return nullptr;
        std::vector<const NodeType*> types;
        for (const auto& type : nodeTypes())
            if (!type->isAbstract() && type->isA(base) &&
                type->editionsOfName(type->name(scene.edition)) != 0 &&
                has(type->editionsOfName(type->name(scene.edition)), scene.edition))
                types.push_back(type.get());
        if (types.empty()) return nullptr;
        if (upTo(5) == 0)
            for (Node* const node : done_)
                if (node->type().isA(base) && upTo(2) == 0) return node;
        Node* const node = scene.create(
            *types[static_cast<std::size_t>(upTo(static_cast<int>(types.size()) - 1))], scene.edition);
        if (upTo(2) == 0) {
            node->name = "N" + std::to_string(scene.nodeCount()) + (upTo(3) == 0 ? "-\xc3\xa4:b" : "");
            scene.names[node->name] = node;
        }
        for (const FieldRow& row : node->type().rows())
            if (has(row.editions, scene.edition) && isKept(row.access) && upTo(2) == 0)
                set(*node, row, depth);
        done_.push_back(node);
        return node;
    }

    void set(Node& node, const FieldRow& row, int depth)
    {
        const FieldShape& shape = shapeOf(row.type);
        const int elements = shape.isMany ? upTo(4) : 1;
        FieldValue value = emptyValue(row.type);
        for (int i = 0; i < elements * shape.components; ++i)
            add(value, row, depth);
        if (row.name == "image") value = image(row.type == FieldType::sfImage);
        if (objection(row, value)) return;
        if (shape.storage == Storage::nodes && sizeOf(value) == 0) return;
        node.put(row.slot, std::move(value));
    }

    void add(FieldValue& value, const FieldRow& row, int depth)
    {
        const bool isBool = row.type == FieldType::sfBool || row.type == FieldType::mfBool;
        if (auto* const nodes = std::get_if<std::vector<Node*>>(&value)) {
            if (Node* const below = row.accepted.empty() ? nullptr : make(*row.accepted.front(), depth + 1))
                nodes->push_back(below);
        } else if (auto* const strings = std::get_if<std::vector<std::string>>(&value)) {
            strings->push_back(
                row.choices.empty()
                    ? text()
                    : row.choices[static_cast<std::size_t>(upTo(static_cast<int>(row.choices.size()) - 1))]);
        } else if (auto* const integers = std::get_if<std::vector<std::int32_t>>(&value)) {
            integers->push_back(isBool         ? upTo(1)
                                : upTo(3) == 0 ? static_cast<std::int32_t>(random_())
                                               : upTo(3));
        } else if (auto* const floats = std::get_if<std::vector<float>>(&value)) {
            floats->push_back(static_cast<float>(number()));
        } else {
            std::get<std::vector<double>>(value).push_back(number());
        }
    }

    /// From tiny to huge, most of them from 0 to 1.
    double number()
    {
        const double fraction = std::ldexp(static_cast<double>(random_()), -32);
        const int kind = upTo(9);
        if (kind == 0) return (fraction - 0.5) * 1e30;
        if (kind == 1) return fraction * 1e-38;
        return kind == 2 ? -fraction : kind == 3 ? 1 : fraction;
    }

    std::string text()
    {
        static const char* const kParts[] = {"a", "\"",  "\\",    "\\\"",        "'", "&",
                                             "<", ">",   "\n",    "\t",          " ", "# no comment",
                                             ",", "]]>", "&amp;", "\xe2\x82\xac"};
        std::string out;
        for (int i = upTo(6); i > 0; --i)
            out += kParts[upTo(15)];
        return out;
    }

    std::vector<std::int32_t> image(bool isFlat)
    {
        const int w = upTo(3), h = upTo(3), d = isFlat ? 1 : upTo(3), components = 1 + upTo(3);
        std::vector<std::int32_t> out = isFlat ? std::vector<std::int32_t>{w, h, components}
                                               : std::vector<std::int32_t>{components, w, h, d};
        for (int i = 0; i < w * h * d; ++i)
            out.push_back(static_cast<std::int32_t>(random_()));
        return out;
    }

    void addRoutes()
    {
        std::set<const Node*> reachable;
        for (Node* const root : scene.roots)
            for (Node* const node : done_)
                if (isAtOrBelow(*node, *root)) reachable.insert(node);
        for (int i = 0; i < 4000 && scene.routes.size() < 5; ++i) {
            Node* const from = done_[static_cast<std::size_t>(upTo(static_cast<int>(done_.size()) - 1))];
            Node* const to = done_[static_cast<std::size_t>(upTo(static_cast<int>(done_.size()) - 1))];
            if (!reachable.contains(from) || !reachable.contains(to)) continue;
            const auto rows = from->type().rows(), toRows = to->type().rows();
            const FieldRow& out = rows[static_cast<std::size_t>(upTo(static_cast<int>(rows.size()) - 1))];
            const FieldRow& in = toRows[static_cast<std::size_t>(upTo(static_cast<int>(toRows.size()) - 1))];
            if (!has(out.editions, scene.edition) || !has(in.editions, scene.edition) ||
                routeObjection(*from, out, *to, in))
                continue;
            scene.routes.push_back({from, out.slot, to, in.slot, {}, 0});
        }
    }

    std::mt19937 random_;
    std::vector<Node*> done_;
};

std::string messagesOf(const Scene& scene)
{
    std::string lines;
    for (const SceneMessage& message : scene.messages)
        lines += messageLine(message) + "\n";
    return lines;
}

/// How the scene differs from itself, written and read again.
std::string afterRoundTrip(const Scene& scene, Encoding encoding)
{
    const std::string text = sceneText(scene, encoding);
    Scene again;
    SceneLimits noInlines;
    noInlines.inlines = 0;
    if (!readSceneText(again, text, "again", noInlines)) return "not read: " + messagesOf(again) + text;
    const std::string difference = graphDifference(scene, again);
    return difference.empty() ? "" : difference + "\n" + messagesOf(again) + text;
}

TEST(RoundTrip, keepsRandomScenes)
{
    std::set<const NodeType*> seen;
    std::size_t routes = 0;
    for (unsigned seed = 0; seed < 300; ++seed)
        for (const Edition edition : {Edition::proposal2005, Edition::x3d33, Edition::x3d40}) {
            const RandomScene random(seed, edition);
            ASSERT_EQ(afterRoundTrip(random.scene, Encoding::xml), "") << seed;
            ASSERT_EQ(afterRoundTrip(random.scene, Encoding::classic), "") << seed;
            routes += random.scene.routes.size();
            for (const auto& node : random.scene.nodes())
                seen.insert(&node->type());
        }
    EXPECT_GT(routes, 1000u);
    // All nodes that are not abstract.
    std::size_t concrete = 0;
    for (const auto& type : nodeTypes())
        concrete += !type->isAbstract();
    EXPECT_EQ(seen.size(), concrete);
}

TEST(RoundTrip, bothEncodingsSayTheSame)
{
    const std::string_view xml = R"(<?xml version="1.0" encoding="UTF-8"?>
<!DOCTYPE X3D PUBLIC "ISO//Web3D//DTD X3D 3.3//EN" "http://www.web3d.org/specifications/x3d-3.3.dtd">
<X3D profile='Full' version='3.3'>
<head><component name='VolumeRendering' level='2'/><meta name='title' content='a "head"'/></head>
<Scene>
  <!-- a comment -->
  <Transform DEF='Turn' rotation='0 1 0, 0.5'>
    <VolumeData DEF='Head' dimensions='1 2.5 1e0'>
      <EdgeEnhancementVolumeStyle edgeColor='1 0 0 1'/>
      <ImageTexture3D containerField='voxels' url='"head.nrrd" "other \"quoted\".nrrd"'/>
    </VolumeData>
    <Group bboxSize='1 1 1'><VolumeData USE='Head'/></Group>
  </Transform>
  <TimeSensor DEF='Time' loop='true' cycleInterval='2'/>
  <OrientationInterpolator DEF='Path' key='0 1' keyValue='0 1 0 0, 0 1 0 3'/>
  <ROUTE fromNode='Time' fromField='fraction_changed' toNode='Path' toField='set_fraction'/>
  <ROUTE fromNode='Path' fromField='value_changed' toNode='Turn' toField='set_rotation'/>
</Scene></X3D>)";
    const std::string_view classic = R"(#X3D V3.3 utf8
PROFILE Full
COMPONENT VolumeRendering:2
META "title" "a \"head\""
DEF Turn Transform { # turned
  rotation 0 1 0 0.5
  children [
    DEF Head VolumeData {
      dimensions 1 2.5 1
      renderStyle EdgeEnhancementVolumeStyle { edgeColor 1 0 0 1 }
      voxels ImageTexture3D { url [ "head.nrrd", "other \"quoted\".nrrd" ] }
    }
    Group { bboxSize 1 1 1 children USE Head }
  ]
}
DEF Time TimeSensor { loop TRUE cycleInterval 2 }
DEF Path OrientationInterpolator { key [0 1] keyValue [0 1 0 0, 0 1 0 3] }
ROUTE Time.fraction_changed TO Path.set_fraction
ROUTE Path.value_changed TO Turn.rotation
)";
    Scene fromXml, fromClassic;
    ASSERT_TRUE(readSceneText(fromXml, xml, "xml"));
    ASSERT_TRUE(readSceneText(fromClassic, classic, "classic"));
    EXPECT_EQ(messagesOf(fromXml) + messagesOf(fromClassic), "");
    EXPECT_EQ(graphDifference(fromXml, fromClassic), "");
    EXPECT_EQ(fromClassic.header.metas.front().content, fromXml.header.metas.front().content);
    EXPECT_EQ(sceneText(fromXml, Encoding::xml), sceneText(fromClassic, Encoding::xml));
    EXPECT_EQ(fromXml.roots.size(), 3u);
    EXPECT_EQ(fromXml.routes.size(), 2u);
}

/// What is written of nodes, in lines.
std::vector<std::string> writtenLines(const std::string& nodes, Encoding encoding)
{
    Scene scene;
    EXPECT_TRUE(
        readSceneText(scene, "<X3D profile='Full' version='4.0'><Scene>" + nodes + "</Scene></X3D>", "s"));
    std::vector<std::string> lines;
    std::istringstream text(sceneText(scene, encoding));
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

TEST(RoundTrip, pixelsOfSeveralComponentsAreHexadecimal)
{
    const auto image = [](const std::string& type, const std::string& written) {
        const std::string node = "<" + type + (type == "PixelTexture3D" ? " containerField='voxels'" : "") +
                                 " image='" + written + "'/>";
        const std::string nodes = type == "PixelTexture3D"
                                      ? "<VolumeData>" + node + "</VolumeData>"
                                      : "<Shape><Appearance>" + node + "</Appearance></Shape>";
        for (const std::string& line : writtenLines(nodes, Encoding::xml))
            if (const auto at = line.find("image='"); at != line.npos)
                return line.substr(at + 7, line.find('\'', at + 7) - at - 7);
        return std::string();
    };
    EXPECT_EQ(image("PixelTexture", "1 2 4 -16777216 255"), "1 2 4 0xFF000000 0x000000FF");
    EXPECT_EQ(image("PixelTexture", "2 1 2 65535 1"), "2 1 2 0xFFFF 0x0001");
    EXPECT_EQ(image("PixelTexture", "1 1 1 0x10"), "1 1 1 16");
    EXPECT_EQ(image("PixelTexture", "1 1 3 0x1FFFFFF"), "1 1 3 0x1FFFFFF") << "no bit is lost";
    EXPECT_EQ(image("PixelTexture3D", "3 1 1 2 0 16711680"), "3 1 1 2 0x000000 0xFF0000");
    EXPECT_EQ(image("PixelTexture3D", "1 1 1 2 0 255"), "1 1 1 2 0 255");
    EXPECT_EQ(image("PixelTexture3D", "0 0 0 0"), "0 0 0 0");
}

TEST(RoundTrip, longValuesAreInLines)
{
    std::string image = "300 1 4", keys;
    for (int i = 0; i < 300; ++i) {
        image += " " + std::to_string(i * 1000003);
        keys += " " + std::to_string(i) + ".5";
    }
    const std::string nodes = "<Shape><Appearance><PixelTexture image='" + image +
                              "'/></Appearance></Shape><ScalarInterpolator key='" + keys + "'/>";
    for (const Encoding encoding : {Encoding::xml, Encoding::classic}) {
        std::size_t longest = 0, full = 0;
        for (const std::string& line : writtenLines(nodes, encoding)) {
            longest = std::max(longest, line.size());
            full += line.size() > 85 ? 1 : 0;
        }
        EXPECT_LE(longest, 101u);
        EXPECT_GE(full, (300 * 11 + 300 * 5) / 110u) << "lines are filled";
    }
    // Where it is no number, a blank is a part of it.
    const std::string title(300, 'a');
    Scene scene;
    readSceneText(scene,
                  "<X3D profile='Full' version='4.0'><Scene><WorldInfo title='" + title + " b " + title +
                      "'/>" + nodes + "</Scene></X3D>",
                  "s");
    EXPECT_EQ(afterRoundTrip(scene, Encoding::xml), "");
    EXPECT_EQ(afterRoundTrip(scene, Encoding::classic), "");
}

} // namespace
} // namespace vo
