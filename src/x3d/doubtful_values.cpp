#include "x3d/doubtful_values.h"

#include "x3d/node_values.h"
#include "x3d/number_text.h"
#include "x3d/value_text.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace vo {
namespace {

using Doubts = std::vector<Doubt>;

std::string listed(std::span<const float> numbers)
{
    std::string text;
    for (const float number : numbers) {
        if (!text.empty()) text += ' ';
        text += numberText(number);
    }
    return text;
}

bool isZero(std::span<const float> numbers)
{
    return std::ranges::all_of(numbers, [](float number) { return number == 0.0f; });
}

/// An axis of no length turns nothing, which is as it should be where the angle is 0.
void lookAtRotations(const Node& node, const FieldRow& row, Doubts& doubts)
{
    const auto& numbers = floatsOf(node, row.name);
    for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4) {
        const auto rotation = std::span(numbers).subspan(i, 4);
        if (!isZero(rotation.first(3)) || rotation[3] == 0.0f) continue;
        doubts.push_back(
            {row.name, "expected an axis other than 0 0 0", listed(rotation) + ": turns nothing"});
        return;
    }
}

/// What a number that voxels do not have does; MAX and MIN then choose as with the number named.
std::string withoutVoxels(const Node& node)
{
    if (!node.field("intensityThreshold")) return "has no surface";
    const std::string_view type = stringOf(node, "type");
    return type == "AVERAGE" ? "changes nothing" : type == "MIN" ? "taken as 1" : "taken as 0";
}

void lookAtVoxelRange(const Node& node, const FieldRow& row, Doubts& doubts)
{
    for (const float number : floatsOf(node, row.name)) {
        if (row.voxelRange->contains(static_cast<double>(number))) continue;
        const bool isSurface = isOf(&node, "IsoSurfaceVolumeData");
        doubts.push_back({row.name, "expected numbers in " + row.voxelRange->text + ", the range of voxels",
                          numberText(number) + ": " + withoutVoxels(node),
                          isSurface ? MessageTopic::nothingSeen : MessageTopic::other});
        return;
    }
}

/// Of fewer than four components, whose pixels have fewer than 32 bits.
void lookAtPixels(const Node& node, const FieldRow& row, Doubts& doubts)
{
    const auto& image = integersOf(node, row.name);
    const std::size_t sizes = row.type == FieldType::sfImage ? 3 : 4;
    if (image.size() <= sizes) return;
    const std::int32_t components = row.type == FieldType::sfImage ? image[2] : image[0];
    if (components < 1 || components > 3) return;
    const std::uint32_t most = (1u << (8 * components)) - 1;
    const auto isOver = [&](std::int32_t pixel) { return static_cast<std::uint32_t>(pixel) > most; };
    const auto over = std::find_if(image.begin() + static_cast<std::ptrdiff_t>(sizes), image.end(), isOver);
    if (over == image.end()) return;
    doubts.push_back({row.name,
                      "expected pixels from 0 to " + numberText(most) + " for " + std::to_string(components) +
                          (components == 1 ? " component" : " components"),
                      numberText(*over) + ": higher bits are left out"});
}

void lookAtDirection(const Node& node, Doubts& doubts)
{
    const auto& direction = floatsOf(node, "direction");
    if (!direction.empty() && isZero(direction))
        doubts.push_back({"direction", "expected a direction other than 0 0 0", "0 0 0: taken as 0 0 -1"});
}

void lookAtScale(const Node& node, Doubts& doubts)
{
    const auto& scale = floatsOf(node, "scale");
    if (std::ranges::find(scale, 0.0f) != scale.end())
        doubts.push_back(
            {"scale", "expected numbers other than 0", listed(scale) + ": nothing in it is drawn"});
}

void lookAtPlane(const Node& node, Doubts& doubts)
{
    const auto& plane = floatsOf(node, "plane");
    if (plane.size() == 4 && isZero(std::span(plane).first(3)))
        doubts.push_back({"plane", "expected a normal other than 0 0 0",
                          listed(plane) + (plane[3] < 0.0f ? ": cuts all away" : ": cuts nothing away")});
}

void lookAtDepths(const Node& node, Doubts& doubts)
{
    const float near = floatOf(node, "nearDistance", -1.0f), far = floatOf(node, "farDistance", -1.0f);
    if (near > 0.0f && far > 0.0f && near >= far)
        doubts.push_back({"nearDistance", "expected less than farDistance",
                          numberText(near) + " and " + numberText(far) + ": seen from " + numberText(near) +
                              " to " + numberText(2.0f * near)});
}

void lookAtRectangle(const Node& node, Doubts& doubts)
{
    const auto& seen = floatsOf(node, "fieldOfView");
    const std::string name = "fieldOfView";
    if (seen.size() != 4)
        doubts.push_back({name, "expected 4 numbers",
                          std::to_string(seen.size()) +
                              (seen.size() < 4 ? ": taken as -1 -1 1 1" : ": the first are taken")});
    else if (!(seen[0] < seen[2] && seen[1] < seen[3]))
        doubts.push_back({name, "expected minimum x, minimum y, and a maximum x and y above them",
                          listed(seen) + ": taken as -1 -1 1 1"});
}

void lookAtKeys(const Node& node, Doubts& doubts)
{
    const auto& keys = floatsOf(node, "key");
    const FieldRow& values = *node.field("keyValue");
    const std::size_t valueCount =
        floatsOf(node, "keyValue").size() / static_cast<std::size_t>(shapeOf(values.type).components);
    if (keys.size() != valueCount)
        doubts.push_back(
            {"keyValue", "expected as many values as keys",
             std::to_string(valueCount) + " for " + std::to_string(keys.size()) + ": " +
                 (keys.empty() || valueCount == 0 ? "sends nothing" : "what is over is left out")});
    const auto fall = std::ranges::is_sorted_until(keys);
    if (fall != keys.end())
        doubts.push_back(
            {"key", "expected numbers that do not fall",
             numberText(*fall) + " behind " + numberText(*(fall - 1)) + ": what follows is left out"});
}

void lookAtLevels(const Node& node, Doubts& doubts)
{
    const auto& range = floatsOf(node, "range");
    const auto fall = std::ranges::is_sorted_until(range);
    if (fall != range.end())
        doubts.push_back(
            {"range", "expected distances that do not fall",
             numberText(*fall) + " behind " + numberText(*(fall - 1)) + ": its level is not seen"});
    const std::size_t levels = nodesOf(node, "children").size();
    if (!range.empty() && levels > range.size() + 1)
        doubts.push_back(
            {"children", "expected at most one more than distances in range",
             std::to_string(levels) + " for " + std::to_string(range.size()) + ": the last are not seen"});
}

void lookAtChoice(const Node& node, Doubts& doubts)
{
    const std::int32_t choice = integerOf(node, "whichChoice", -1);
    const std::size_t count = nodesOf(node, "children").size();
    if (choice >= 0 && static_cast<std::size_t>(choice) >= count)
        doubts.push_back(
            {"whichChoice",
             "expected the number of one of its " + std::to_string(count) + " children, from 0, or -1",
             std::to_string(choice) + ": none is drawn"});
}

void lookAtSurfaceValues(const Node& node, Doubts& doubts)
{
    if (floatsOf(node, "surfaceValues").empty())
        doubts.push_back({"surfaceValues", "expected the value of a surface", "none: nothing is drawn",
                          MessageTopic::nothingSeen});
}

struct Look
{
    const NodeType* type;
    void (*look)(const Node&, Doubts&);
};

const std::vector<Look>& looks()
{
    static const std::vector<Look> all{
        {&knownNodeType("X3DLightNode"), lookAtDirection},
        {&knownNodeType("Transform"), lookAtScale},
        {&knownNodeType("ClipPlane"), lookAtPlane},
        {&knownNodeType("X3DViewpointNode"), lookAtDepths},
        {&knownNodeType("OrthoViewpoint"), lookAtRectangle},
        {&knownNodeType("X3DInterpolatorNode"), lookAtKeys},
        {&knownNodeType("LOD"), lookAtLevels},
        {&knownNodeType("Switch"), lookAtChoice},
        {&knownNodeType("IsoSurfaceVolumeData"), lookAtSurfaceValues},
    };
    return all;
}

bool isRotation(const FieldRow& row)
{
    return isKept(row.access) && (row.type == FieldType::sfRotation || row.type == FieldType::mfRotation);
}

/// Whether values of nodes of this type can be doubtful.
bool isDoubtable(const NodeType& type)
{
    return std::ranges::any_of(looks(), [&](const Look& each) { return type.isA(*each.type); }) ||
           std::ranges::any_of(type.rows(), [](const FieldRow& row) {
               return row.voxelRange || isRotation(row) || holdsPixels(row.name);
           });
}

} // namespace

std::vector<Doubt> doubtsOf(const Node& node)
{
    Doubts doubts;
    for (const FieldRow& row : node.type().rows()) {
        if (!has(row.editions, node.edition())) continue;
        if (isRotation(row)) lookAtRotations(node, row, doubts);
        if (row.voxelRange) lookAtVoxelRange(node, row, doubts);
        if (holdsPixels(row.name)) lookAtPixels(node, row, doubts);
    }
    for (const Look& each : looks())
        if (node.type().isA(*each.type)) each.look(node, doubts);
    return doubts;
}

void DoubtfulValues::tell()
{
    constexpr auto kNever = std::numeric_limits<std::uint64_t>::max();
    for (const auto& nodes = scene_.nodes(); known_ < nodes.size(); ++known_)
        if (isDoubtable(nodes[known_]->type())) watched_.push_back({nodes[known_].get(), kNever});
    for (Watched& watched : watched_) {
        const Node& node = *watched.node;
        if (std::exchange(watched.revision, node.revision()) == node.revision()) continue;
        for (const Doubt& doubt : doubtsOf(node)) {
            if (scene_.lacksRefused(node, doubt.field)) continue;
            const std::string expected = node.typeName() + "." + doubt.field + ": " + doubt.expected;
            if (told_.emplace(&node, expected).second)
                messages_.warn(node, expected + ", found " + doubt.found, doubt.topic);
        }
    }
}

} // namespace vo
