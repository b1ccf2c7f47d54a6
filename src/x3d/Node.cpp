#include "x3d/face.h"

#include <algorithm>

namespace vo {

voX3DScope::voX3DEdition faceEdition(Edition edition)
{
    switch (edition) {
    case Edition::proposal2005: return voX3DScope::PROPOSAL_2005;
    case Edition::x3d33: return voX3DScope::X3D_33;
    case Edition::x3d40: break;
    }
    return voX3DScope::X3D_40;
}

namespace {

static_assert(static_cast<int>(FieldType::mfNode) == voX3DScope::MF_NODE &&
              static_cast<int>(FieldType::sfColor) == voX3DScope::SF_COLOR &&
              static_cast<int>(FieldType::sfString) == voX3DScope::SF_STRING);
static_assert(static_cast<int>(Access::inputOutput) == voX3DScope::INPUT_OUTPUT);

Node& nodeOf(void* node)
{
    if (!node) badValue("the node is null");
    return *static_cast<Node*>(node);
}

const FieldRow& rowOf(const Node& node, const char* field)
{
    const FieldRow* const row = node.field(&required(field, "field"));
    if (!row) badValue(node.typeName() + " has no field \"" + field + "\"");
    return *row;
}

template <typename Element>
const std::vector<Element>& elementsOf(const Node& node, const char* field)
{
    const FieldRow& row = rowOf(node, field);
    const auto* const elements = std::get_if<std::vector<Element>>(&node.value(row));
    if (!elements)
        badValue(node.typeName() + "." + field + " is of type " + std::string(shapeOf(row.type).name));
    return *elements;
}

template <typename Element>
const Element* numbersOf(const char* action, void* node, const char* field)
{
    return guardedAnswer<const Element*>(action, nullptr, [&] {
        const auto& numbers = elementsOf<Element>(nodeOf(node), field);
        return numbers.empty() ? nullptr : numbers.data();
    });
}

void putChecked(Node& node, const char* field, FieldValue value)
{
    const FieldRow& row = rowOf(node, field);
    if (!isKept(row.access)) badValue(node.typeName() + "." + field + " is an event");
    auto* const integers = std::get_if<std::vector<std::int32_t>>(&value);
    if (integers && (row.type == FieldType::sfBool || row.type == FieldType::mfBool))
        for (std::int32_t& each : *integers)
            each = each != 0;
    if (const auto against = objection(row, value)) badValue(node.typeName() + "." + field + ": " + *against);
    node.put(row.slot, std::move(value));
}

template <typename Element>
std::vector<Element> copied(const Element* values, int count)
{
    if (count < 0 || (count > 0 && !values)) badValue("there are no values");
    return {values, values + count};
}

} // namespace
} // namespace vo

using namespace vo;

voX3DNode::voX3DNode() : scene_(NULL), node_(NULL) {}
voX3DNode::voX3DNode(voX3DScene* scene, void* node) : scene_(node ? scene : NULL), node_(node) {}

voBool voX3DNode::isNull() const
{
    return node_ == NULL;
}

bool voX3DNode::operator==(const voX3DNode& other) const
{
    return node_ == other.node_;
}

bool voX3DNode::operator!=(const voX3DNode& other) const
{
    return node_ != other.node_;
}

const char* voX3DNode::getTypeName() const
{
    return guardedAnswer<const char*>("getTypeName", NULL, [&] { return nodeOf(node_).typeName().c_str(); });
}

voBool voX3DNode::isType(const char* name) const
{
    return guardedAnswer<voBool>("isType", VO_FALSE, [&] {
        const std::string_view wanted = &required(name, "name");
        const auto isIt = [&](const auto& type) {
            return type->editionsOfName(wanted) != 0 && nodeOf(node_).type().isA(*type);
        };
        return std::ranges::any_of(nodeTypes(), isIt);
    });
}

voX3DScope::voX3DEdition voX3DNode::getEdition() const
{
    return guardedAnswer("getEdition", PROPOSAL_2005, [&] { return faceEdition(nodeOf(node_).edition()); });
}

const char* voX3DNode::getName() const
{
    return guardedAnswer<const char*>("getName", NULL, [&] { return nodeOf(node_).name.c_str(); });
}

const char* voX3DNode::getFile() const
{
    return guardedAnswer<const char*>("getFile", NULL, [&] {
        const auto& file = nodeOf(node_).place.file;
        return file ? file->c_str() : "";
    });
}

int voX3DNode::getLine() const
{
    return guardedAnswer("getLine", 0, [&] { return nodeOf(node_).place.line; });
}

int voX3DNode::getFieldCount() const
{
    return guardedAnswer("getFieldCount", 0, [&] {
        const Node& node = nodeOf(node_);
        return static_cast<int>(std::ranges::count_if(
            node.type().rows(), [&](const FieldRow& row) { return has(row.editions, node.edition()); }));
    });
}

const char* voX3DNode::getFieldName(int index) const
{
    return guardedAnswer<const char*>("getFieldName", NULL, [&] {
        const Node& node = nodeOf(node_);
        std::vector<const FieldRow*> rows;
        for (const FieldRow& row : node.type().rows())
            if (has(row.editions, node.edition())) rows.push_back(&row);
        return elementOf(rows, index)->name.c_str();
    });
}

voBool voX3DNode::hasField(const char* field) const
{
    return guardedAnswer<voBool>("hasField", VO_FALSE,
                                 [&] { return nodeOf(node_).field(&required(field, "field")) != nullptr; });
}

voX3DScope::voX3DFieldType voX3DNode::getFieldType(const char* field) const
{
    return guardedAnswer("getFieldType", SF_BOOL,
                         [&] { return static_cast<voX3DFieldType>(rowOf(nodeOf(node_), field).type); });
}

voX3DScope::voX3DAccess voX3DNode::getFieldAccess(const char* field) const
{
    return guardedAnswer("getFieldAccess", INITIALIZE_ONLY,
                         [&] { return static_cast<voX3DAccess>(rowOf(nodeOf(node_), field).access); });
}

voBool voX3DNode::isSet(const char* field) const
{
    return guardedAnswer<voBool>("isSet", VO_FALSE,
                                 [&] { return nodeOf(node_).isSet(rowOf(nodeOf(node_), field).slot); });
}

int voX3DNode::getCount(const char* field) const
{
    return guardedAnswer("getCount", 0, [&] {
        const FieldRow& row = rowOf(nodeOf(node_), field);
        return static_cast<int>(sizeOf(nodeOf(node_).value(row)) /
                                static_cast<std::size_t>(shapeOf(row.type).components));
    });
}

const int* voX3DNode::getInts(const char* field) const
{
    return numbersOf<std::int32_t>("getInts", node_, field);
}

const float* voX3DNode::getFloats(const char* field) const
{
    return numbersOf<float>("getFloats", node_, field);
}

const double* voX3DNode::getDoubles(const char* field) const
{
    return numbersOf<double>("getDoubles", node_, field);
}

const char* voX3DNode::getString(const char* field, int index) const
{
    return guardedAnswer<const char*>("getString", NULL, [&] {
        return elementOf(elementsOf<std::string>(nodeOf(node_), field), index).c_str();
    });
}

voX3DNode voX3DNode::getNode(const char* field, int index) const
{
    return guardedAnswer("getNode", voX3DNode(), [&] {
        const auto& nodes = elementsOf<Node*>(nodeOf(node_), field);
        const bool isSingle = rowOf(nodeOf(node_), field).type == FieldType::sfNode;
        return isSingle && nodes.empty() && index == 0 ? voX3DNode()
                                                       : voX3DNode(scene_, elementOf(nodes, index));
    });
}

void voX3DNode::setInts(const char* field, const int* values, int numbers)
{
    guarded("setInts", [&] { putChecked(nodeOf(node_), field, copied<std::int32_t>(values, numbers)); });
}

void voX3DNode::setFloats(const char* field, const float* values, int numbers)
{
    guarded("setFloats", [&] { putChecked(nodeOf(node_), field, copied(values, numbers)); });
}

void voX3DNode::setDoubles(const char* field, const double* values, int numbers)
{
    guarded("setDoubles", [&] { putChecked(nodeOf(node_), field, copied(values, numbers)); });
}

void voX3DNode::setStrings(const char* field, const char* const* values, int count)
{
    guarded("setStrings", [&] {
        std::vector<std::string> strings;
        for (const char* const text : copied(values, count))
            strings.emplace_back(&required(text, "string"));
        putChecked(nodeOf(node_), field, std::move(strings));
    });
}

void voX3DNode::setNodes(const char* field, const voX3DNode* nodes, int count)
{
    guarded("setNodes", [&] {
        Node& node = nodeOf(node_);
        std::vector<Node*> below;
        for (const voX3DNode& each : copied(nodes, count)) {
            if (each.scene_ != scene_) badValue("a node is null or of another scene");
            below.push_back(&nodeOf(each.node_));
            if (isAtOrBelow(node, *below.back())) badValue("a node would stand below itself");
        }
        const bool isEmpty = below.empty();
        putChecked(node, field, std::move(below));
        if (isEmpty) node.unset(rowOf(node, field).slot);
    });
}

void voX3DNode::setInt(const char* field, int value)
{
    setInts(field, &value, 1);
}

void voX3DNode::setFloat(const char* field, float value)
{
    setFloats(field, &value, 1);
}

void voX3DNode::setDouble(const char* field, double value)
{
    setDoubles(field, &value, 1);
}

void voX3DNode::setString(const char* field, const char* value)
{
    setStrings(field, &value, 1);
}

void voX3DNode::setNode(const char* field, const voX3DNode& node)
{
    setNodes(field, &node, node.isNull() ? 0 : 1);
}

void voX3DNode::reset(const char* field)
{
    guarded("reset", [&] { nodeOf(node_).unset(rowOf(nodeOf(node_), field).slot); });
}

int voX3DNode::getInlinedCount() const
{
    return guardedAnswer("getInlinedCount", 0,
                         [&] { return static_cast<int>(nodeOf(node_).inlined.size()); });
}

voX3DNode voX3DNode::getInlined(int index) const
{
    return guardedAnswer("getInlined", voX3DNode(),
                         [&] { return voX3DNode(scene_, elementOf(nodeOf(node_).inlined, index)); });
}

const char* voX3DNode::getPath(const char* field, int index) const
{
    return guardedAnswer<const char*>("getPath", NULL, [&] {
        const Node& node = nodeOf(node_);
        const std::string& url = elementOf(elementsOf<std::string>(node, field), index);
        voX3DScene::Private& d = *scene_->d;
        const auto place = d.scene->locate(node, url);
        if (!place.reason.empty()) badValue(place.reason);
        d.text = place.path.string();
        return d.text.c_str();
    });
}
