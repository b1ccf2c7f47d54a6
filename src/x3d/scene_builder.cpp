#include "x3d/scene_builder.h"

#include <algorithm>
#include <cctype>

#include "x3d/number_text.h"
#include "x3d/printable_word.h"

namespace vo {
namespace {

bool sameButForCase(std::string_view a, std::string_view b)
{
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// A name that differs in capital letters alone.
std::string nodeMeant(std::string_view name)
{
    for (const auto& type : nodeTypes()) {
        if (type->isAbstract()) continue;
        for (const Edition edition : {Edition::x3d40, Edition::proposal2005})
            if (sameButForCase(type->name(edition), name)) return " (" + type->name(edition) + "?)";
    }
    return "";
}

std::string fieldMeant(const NodeType& type, std::string_view name)
{
    const auto found = std::ranges::find_if(
        type.rows(), [&](const FieldRow& row) { return sameButForCase(row.name, name); });
    return found == type.rows().end() ? "" : " (" + found->name + "?)";
}

} // namespace

SceneBuilder::SceneBuilder(Scene& scene, std::shared_ptr<const std::string> file, int scope,
                           const SceneLimits& limits)
    : scene_(scene), file_(std::move(file)), scope_(scope), limits_(limits), edition_(scene.edition)
{
}

void SceneBuilder::say(Severity severity, int line, std::string text)
{
    if (scene_.messages.size() < limits_.messages || (gaveUp_ && scene_.messages.size() == limits_.messages))
        scene_.messages.push_back({severity, {file_, line}, std::move(text)});
    else
        ++scene_.messagesLeftOut;
}

void SceneBuilder::giveUp(int line, std::string text)
{
    if (gaveUp_) return;
    gaveUp_ = true;
    say(Severity::error, line, std::move(text));
}

void SceneBuilder::setVersion(std::string_view version, int line)
{
    const auto dot = std::min(version.find('.'), version.size());
    int major = 0, minor = 0;
    if (!parseNumber(version.substr(0, dot), major) ||
        (dot < version.size() && !parseNumber(version.substr(dot + 1), minor)) || major < 3 || minor < 0) {
        warn(line, "expected a version of X3D from 3.0 on, found " + quotedWord(version) + ", taken as 4.0");
        header.version = "4.0";
        edition_ = Edition::x3d40;
        return;
    }
    header.version = std::to_string(major) + "." + std::to_string(minor);
    edition_ = editionOfVersion(major, minor);
}

void SceneBuilder::setProfile(std::string_view name, int line)
{
    if (isNodeName(name))
        header.profile = name;
    else
        wrong(line, "expected the name of a profile, found " + quotedWord(name));
}

void SceneBuilder::addComponent(std::string_view name, int level, int line)
{
    if (isNodeName(name) && level > 0)
        header.components.push_back({std::string(name), level, line});
    else
        wrong(line, "expected the name of a component and a level above 0, found " + quotedWord(name) +
                        " and " + std::to_string(level));
}

const NodeType* SceneBuilder::typeOf(std::string_view name, int line)
{
    const NodeType* const type = findNodeType(name);
    if (!type)
        warn(line, "unknown node " + quotedWord(name) + (isFull() ? "" : nodeMeant(name)) + " skipped");
    return type;
}

Node* SceneBuilder::begin(const NodeType& type, std::string_view typeName, std::string_view defName, int line)
{
    if (open_.size() >= static_cast<std::size_t>(limits_.depth)) {
        giveUp(line, "expected nodes at most " + std::to_string(limits_.depth) + " deep, found more");
        return nullptr;
    }
    if (scene_.nodeCount() >= limits_.nodes) {
        giveUp(line, "expected at most " + std::to_string(limits_.nodes) + " nodes, found more");
        return nullptr;
    }
    Node* const node = scene_.create(type, edition_);
    node->place = {file_, line};
    node->scope = scope_;
    if (!defName.empty()) giveName(*node, defName, line);
    open_.push_back({node, type.editionsOfName(typeName), {}});
    return node;
}

void SceneBuilder::giveName(Node& node, std::string_view name, int line)
{
    if (!isNodeName(name)) return wrong(line, "expected a name for DEF, found " + quotedWord(name));
    if (const auto before = names_.find(name); before != names_.end()) {
        warn(line, "the name " + quotedWord(name) + " is given twice; from here on it is this node's alone");
        before->second->name.clear();
    }
    node.name = name;
    names_[node.name] = &node;
    if (scope_ == 0) scene_.names[node.name] = &node;
}

const FieldRow* SceneBuilder::rowToSet(std::string_view name, int line)
{
    const NodeType& type = current().type();
    const FieldRow* const row = type.row(name, edition_);
    if (!row) {
        warn(line, "unknown field " + quotedWord(name) + (isFull() ? "" : fieldMeant(type, name)) + " of " +
                       current().typeName() + " skipped");
        return nullptr;
    }
    if (isKept(row->access)) return row;
    wrong(line, current().typeName() + "." + row->name + " is an event, which has no value in a file");
    return nullptr;
}

void SceneBuilder::set(const FieldRow& row, FieldValue value, int line)
{
    current().put(row.slot, std::move(value));
    auto& written = open_.back().written;
    const auto again = std::ranges::find(written, row.slot, [](const auto& each) { return each.row->slot; });
    if (again == written.end()) {
        written.push_back({&row, line});
        return;
    }
    warn(line, current().typeName() + "." + row.name + " is given twice; this value is kept");
    *again = {&row, line};
}

void SceneBuilder::refuse(const FieldRow& row, int line, const std::string& why)
{
    wrong(line, current().typeName() + "." + row.name + ": " + why);
    scene_.refused.emplace(&current(), row.slot);
}

void SceneBuilder::attach(Node& child, std::string_view field, int line)
{
    if (open_.empty()) return attachRoot(child, line);
    Node& parent = current();
    const FieldRow* const row = field.empty() ? rowFor(child, line) : rowToSet(field, line);
    if (!row) return;
    if (shapeOf(row->type).storage != Storage::nodes)
        return wrong(line,
                     parent.typeName() + "." + row->name + " takes no nodes, found " + child.typeName());
    if (const auto against = objection(*row, std::vector<Node*>{&child})) return refuse(*row, line, *against);
    auto& written = open_.back().written;
    if (std::ranges::find(written, row->slot, [](const auto& each) { return each.row->slot; }) ==
        written.end())
        written.push_back({row, line});
    if (!parent.isSet(row->slot)) parent.put(row->slot, std::vector<Node*>());
    std::get<std::vector<Node*>>(*parent.find(row->slot)).push_back(&child);
}

/// The field that a node goes to where the file does not say.
const FieldRow* SceneBuilder::rowFor(const Node& child, int line)
{
    const NodeType& type = current().type();
    const auto takes = [&](const FieldRow& row) {
        return isKept(row.access) && std::ranges::any_of(row.accepted, [&](const NodeType* each) {
                   return child.type().isA(*each);
               });
    };
    // A name that one edition alone has decides, as in settleEdition().
    const Edition edition = nearestEdition(open_.back().editionsOfName, edition_);
    const FieldRow* usual = type.row(child.type().container(), edition);
    if (usual) usual = &type.row(usual->slot, edition);
    if (usual && takes(*usual)) return usual;
    const auto found = std::ranges::find_if(
        type.rows(), [&](const FieldRow& row) { return has(row.editions, edition) && takes(row); });
    if (found != type.rows().end()) return &*found;
    wrong(line, child.typeName() + " cannot stand in " + current().typeName());
    return nullptr;
}

void SceneBuilder::attachRoot(Node& child, int line)
{
    if (mayBeRoot(child))
        roots.push_back(&child);
    else
        wrong(line, child.typeName() + " cannot stand in a scene by itself");
}

Node* SceneBuilder::use(std::string_view name, int line)
{
    const auto found = names_.find(name);
    if (found == names_.end()) {
        if (!skippedNames_.contains(name))
            wrong(line, "expected a name that DEF gave before, found " + quotedWord(name));
        return nullptr;
    }
    const bool isAbove = std::ranges::find(open_, found->second,
                                           [](const OpenNode& open) { return open.node; }) != open_.end();
    if (!isAbove) return found->second;
    wrong(line, "the node " + quotedWord(name) + " cannot stand below itself");
    return nullptr;
}

void SceneBuilder::end()
{
    OpenNode& open = open_.back();
    settleEdition(open);
    for (const OpenNode::Written& written : open.written)
        checkValue(open, written);
    open_.pop_back();
}

/// A name that one edition alone has tells of which edition a node is, whatever the version of its file.
void SceneBuilder::settleEdition(OpenNode& open)
{
    Node& node = *open.node;
    Editions editions = open.editionsOfName;
    const FieldRow* foreign = nullptr;
    for (const OpenNode::Written& written : open.written) {
        const Editions ofRow = node.type().editionsOfRow(written.row->name);
        if (!has(ofRow, edition_)) foreign = written.row;
        if ((editions & ofRow) == 0)
            wrong(written.line, node.typeName() + "." + written.row->name +
                                    " is of another version than what else stands in the node");
        else
            editions &= ofRow;
    }
    if (has(editions, edition_)) return;
    node.setEdition(nearestEdition(editions, edition_));
    const std::string what = foreign ? node.typeName() + "." + foreign->name : node.typeName();
    warn(node.place.line, what + " is of " + editionText(node.edition()) + ", the file of " +
                              editionText(edition_) + ": the node has fields and defaults of the former");
}

void SceneBuilder::checkValue(OpenNode& open, const OpenNode::Written& written)
{
    Node& node = *open.node;
    const FieldRow& row = node.field(written.row->slot);
    const auto against = objection(row, node.value(row));
    if (!against) return;
    refuse(row, written.line, *against);
    node.unset(row.slot);
}

Node* SceneBuilder::endOfRoute(std::string_view name, int line)
{
    const auto found = names_.find(name);
    if (found != names_.end()) return found->second;
    if (!skippedNames_.contains(name))
        wrong(line, "ROUTE: expected a name that DEF gave, found " + quotedWord(name));
    return nullptr;
}

void SceneBuilder::route(std::string_view from, std::string_view fromField, std::string_view to,
                         std::string_view toField, int line)
{
    Node* const source = endOfRoute(from, line);
    Node* const target = endOfRoute(to, line);
    if (!source || !target) return;
    const FieldRow* const fromRow = eventRow(*source, fromField, true);
    const FieldRow* const toRow = eventRow(*target, toField, false);
    if (!fromRow)
        return wrong(line, "ROUTE: " + source->typeName() + " has no field " + quotedWord(fromField));
    if (!toRow) return wrong(line, "ROUTE: " + target->typeName() + " has no field " + quotedWord(toField));
    if (const auto against = routeObjection(*source, *fromRow, *target, *toRow))
        return wrong(line, "ROUTE: " + *against);
    scene_.routes.push_back({source, fromRow->slot, target, toRow->slot, {file_, line}, scope_});
}

} // namespace vo
