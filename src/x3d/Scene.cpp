#include "x3d/face.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "volume_io/volume_io.h"
#include "x3d/check_scene.h"
#include "x3d/check_textures.h"
#include "x3d/node_values.h"
#include "x3d/printable_word.h"
#include "x3d/styled_view.h"
#include "x3d/write_scene.h"

namespace vo {
namespace {

/// A scene without nodes that may read what the former one was allowed to.
std::unique_ptr<Scene> emptyScene(const SceneFolders& folders)
{
    auto scene = std::make_unique<Scene>();
    scene->folders = folders;
    return scene;
}

ChannelType channelTypeOf(voDataType type)
{
    switch (type) {
    case voDataTypeScope::UNSIGNED_BYTE: return ChannelType::uint8;
    case voDataTypeScope::BYTE: return ChannelType::int8;
    case voDataTypeScope::UNSIGNED_SHORT: return ChannelType::uint16;
    case voDataTypeScope::SHORT: return ChannelType::int16;
    case voDataTypeScope::FLOAT: return ChannelType::float32;
    default: badValue("expected bytes, shorts or floats");
    }
}

const FieldRow& eventOf(const Node& node, const char* field, bool isOut)
{
    const FieldRow* const row = eventRow(node, &required(field, "field"), isOut);
    if (!row) badValue(node.typeName() + " has no field \"" + field + "\"");
    return *row;
}

} // namespace
} // namespace vo

using namespace vo;

voX3DScene::voX3DScene() : d(new Private) {}

voX3DScene::~voX3DScene()
{
    delete d;
}

void voX3DScene::allowFolder(const char* folder)
{
    guarded("allowFolder", [&] {
        if (!d->allowed.allow(&required(folder, "folder"))) badValue(std::string(folder) + " is no folder");
        d->scene->folders = d->allowed;
    });
}

voBool voX3DScene::read(const char* path)
{
    return guardedAnswer<voBool>("read", VO_FALSE, [&] {
        d->scene = emptyScene(d->allowed);
        d->messages.clear();
        return readScene(*d->scene, &required(path, "path"));
    });
}

voBool voX3DScene::readText(const char* text, size_t bytes, const char* name)
{
    return guardedAnswer<voBool>("readText", VO_FALSE, [&] {
        d->scene = emptyScene(d->allowed);
        d->messages.clear();
        return readSceneText(*d->scene, {&required(text, "text"), bytes}, &required(name, "name"));
    });
}

voBool voX3DScene::write(const char* path, voX3DEncoding encoding) const
{
    return !guarded("write", [&] {
        const std::string text =
            sceneText(*d->scene, encoding == CLASSIC_VRML ? Encoding::classic : Encoding::xml);
        std::ofstream file(&required(path, "path"), std::ios::binary | std::ios::trunc);
        file.write(text.data(), static_cast<std::streamsize>(text.size()));
        file.close();
        if (!file) badValue(std::string(path) + ": cannot write: " + std::strerror(errno));
    });
}

int voX3DScene::getMessageCount() const
{
    return static_cast<int>(d->scene->messages.size());
}

const char* voX3DScene::getMessage(int index) const
{
    return guardedAnswer<const char*>("getMessage", NULL, [&] {
        const SceneMessage& message = elementOf(d->scene->messages, index);
        d->messages.resize(d->scene->messages.size());
        std::string& line = d->messages[static_cast<std::size_t>(index)];
        line = messageLine(message);
        return line.c_str();
    });
}

voBool voX3DScene::isError(int index) const
{
    return guardedAnswer<voBool>("isError", VO_FALSE, [&] {
        return elementOf(d->scene->messages, index).severity == Severity::error;
    });
}

voX3DScope::voX3DMessageTopic voX3DScene::getMessageTopic(int index) const
{
    return guardedAnswer("getMessageTopic", ANYTHING_ELSE, [&] {
        const bool isEmpty = elementOf(d->scene->messages, index).topic == MessageTopic::nothingSeen;
        return isEmpty ? NOTHING_SEEN : ANYTHING_ELSE;
    });
}

const char* voX3DScene::getMessageFile(int index) const
{
    return guardedAnswer<const char*>("getMessageFile", NULL, [&] {
        const auto& file = elementOf(d->scene->messages, index).place.file;
        return file ? file->c_str() : "";
    });
}

int voX3DScene::getErrorCount() const
{
    return static_cast<int>(d->scene->errorCount());
}

int voX3DScene::getLeftOutMessageCount() const
{
    return static_cast<int>(d->scene->messagesLeftOut);
}

void voX3DScene::check()
{
    guarded("check", [&] {
        checkView(*d->scene);
        checkScene(*d->scene);
        checkTextures(*d->scene);
    });
}

const char* voX3DScene::getVersion() const
{
    return d->scene->header.version.c_str();
}

const char* voX3DScene::getProfile() const
{
    return d->scene->header.profile.c_str();
}

voX3DScope::voX3DEdition voX3DScene::getEdition() const
{
    return faceEdition(d->scene->edition);
}

int voX3DScene::getRootCount() const
{
    return static_cast<int>(d->scene->roots.size());
}

voX3DNode voX3DScene::getRoot(int index) const
{
    return guardedAnswer("getRoot", voX3DNode(), [&] { return handle(elementOf(d->scene->roots, index)); });
}

void voX3DScene::setRoots(const voX3DNode* nodes, int count)
{
    guarded("setRoots", [&] {
        if (count < 0 || (count > 0 && !nodes)) badValue("there are no nodes");
        std::vector<Node*> roots;
        for (int i = 0; i < count; ++i) {
            roots.push_back(static_cast<Node*>(own(nodes[i])));
            if (!mayBeRoot(*roots.back()))
                badValue(roots.back()->typeName() + " cannot stand in a scene by itself");
        }
        d->scene->roots = std::move(roots);
    });
}

voX3DNode voX3DScene::find(const char* name) const
{
    return guardedAnswer("find", voX3DNode(), [&] {
        const auto found = d->scene->names.find(std::string_view(&required(name, "name")));
        return found == d->scene->names.end() ? voX3DNode() : handle(found->second);
    });
}

voX3DNode voX3DScene::createNode(const char* typeName)
{
    return guardedAnswer("createNode", voX3DNode(), [&] {
        const NodeType* const type = findNodeType(&required(typeName, "typeName"));
        if (!type) badValue(std::string("there is no node ") + typeName);
        return handle(
            d->scene->create(*type, nearestEdition(type->editionsOfName(typeName), d->scene->edition)));
    });
}

void voX3DScene::setName(const voX3DNode& node, const char* name)
{
    guarded("setName", [&] {
        Node& named = *static_cast<Node*>(own(node));
        const std::string text = &required(name, "name");
        auto& names = d->scene->names;
        const auto holder = names.find(text);
        if (holder != names.end() && holder->second == &named) return;
        if (holder != names.end()) badValue("another node has the name " + quotedWord(text));
        if (!text.empty() && !isNodeName(text)) badValue("files cannot write the name " + quotedWord(text));
        const auto before = names.find(named.name);
        if (before != names.end() && before->second == &named) names.erase(before);
        named.name = text;
        if (!text.empty()) names[text] = &named;
    });
}

void voX3DScene::setReadVoxels(const voX3DNode& texture, const void* voxels, const int size[3], int channels,
                               int components, voDataType type)
{
    guarded("setReadVoxels", [&] {
        const Node& node = *static_cast<const Node*>(own(texture));
        if (!isOf(&node, "ImageTexture3D")) badValue(node.typeName() + " has no file of voxels");
        if (components < 1 || components > channels || channels > 4)
            badValue("expected 1 to 4 components, no more than channels");
        auto read = std::make_shared<ReadVoxels>();
        read->type = channelTypeOf(type);
        for (std::size_t i = 0; i < 3; ++i)
            read->size[i] = (&required(size, "size"))[i];
        read->channels = channels;
        read->components = components;
        read->revision = node.revision();
        const auto bytes = volumeBytes(read->size, channels * bytesPerChannel(read->type));
        if (!bytes) badValue(bytes.failure().text);
        const auto* const first = static_cast<const std::byte*>(voxels);
        if (!first) badValue("there are no voxels");
        read->bytes.assign(first, first + *bytes);
        d->scene->readVoxels[&node] = std::move(read);
    });
}

int voX3DScene::getRouteCount() const
{
    return static_cast<int>(d->scene->routes.size());
}

voX3DNode voX3DScene::getRouteSource(int index) const
{
    return guardedAnswer("getRouteSource", voX3DNode(),
                         [&] { return handle(elementOf(d->scene->routes, index).from); });
}

const char* voX3DScene::getRouteSourceField(int index) const
{
    return guardedAnswer<const char*>("getRouteSourceField", NULL, [&] {
        const Route& route = elementOf(d->scene->routes, index);
        return route.from->field(route.fromSlot).name.c_str();
    });
}

voX3DNode voX3DScene::getRouteTarget(int index) const
{
    return guardedAnswer("getRouteTarget", voX3DNode(),
                         [&] { return handle(elementOf(d->scene->routes, index).to); });
}

const char* voX3DScene::getRouteTargetField(int index) const
{
    return guardedAnswer<const char*>("getRouteTargetField", NULL, [&] {
        const Route& route = elementOf(d->scene->routes, index);
        return route.to->field(route.toSlot).name.c_str();
    });
}

void voX3DScene::addRoute(const voX3DNode& source, const char* sourceField, const voX3DNode& target,
                          const char* targetField)
{
    guarded("addRoute", [&] {
        Node& from = *static_cast<Node*>(own(source));
        Node& to = *static_cast<Node*>(own(target));
        const FieldRow& fromRow = eventOf(from, sourceField, true);
        const FieldRow& toRow = eventOf(to, targetField, false);
        if (const auto against = routeObjection(from, fromRow, to, toRow)) badValue(*against);
        d->scene->routes.push_back({&from, fromRow.slot, &to, toRow.slot, {}, 0});
    });
}

voX3DNode voX3DScene::handle(void* node) const
{
    return voX3DNode(const_cast<voX3DScene*>(this), node);
}

void* voX3DScene::own(const voX3DNode& node) const
{
    if (!node.node_ || node.scene_ != this) badValue("the node is null or of another scene");
    return node.node_;
}
