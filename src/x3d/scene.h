#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "x3d/node_table.h"
#include "x3d/scene_folders.h"

namespace vo {

/// A line of a file, counted from 1; 0 where there is none.
struct TextPlace
{
    std::shared_ptr<const std::string> file;
    int line = 0;
};

/// A node of a scene. It knows those below it, not those above. What a file or a caller has not set has its
/// default.
class Node
{
public:
    Node(const NodeType& type, Edition ofNode) : type_(type), edition_(ofNode) {}

    const NodeType& type() const { return type_; }
    /// Whose fields and defaults it has.
    Edition edition() const { return edition_; }
    const std::string& typeName() const { return type_.name(edition_); }

    /// Of its edition; NULL where that has none of this name.
    const FieldRow* field(std::string_view fieldName) const;
    const FieldRow& field(std::size_t slot) const { return type_.row(slot, edition_); }

    bool isSet(std::size_t slot) const { return find(slot) != nullptr; }
    const FieldValue& value(std::size_t slot) const;
    const FieldValue& value(const FieldRow& row) const { return value(row.slot); }
    /// What was set; NULL where nothing was.
    const FieldValue* find(std::size_t slot) const;
    FieldValue* find(std::size_t slot)
    {
        ++revision_;
        return const_cast<FieldValue*>(std::as_const(*this).find(slot));
    }
    /// Without a check; slots rise in settings().
    void put(std::size_t slot, FieldValue value);
    void unset(std::size_t slot);
    struct Setting
    {
        std::size_t slot;
        FieldValue value;
    };
    const std::vector<Setting>& settings() const { return settings_; }
    /// Another number after each change of a value, so that what was made of them can be kept.
    std::uint64_t revision() const { return revision_; }

    /// The name of DEF, "" without one.
    std::string name;
    TextPlace place;
    /// Of an Inline: the nodes of its file.
    std::vector<Node*> inlined;
    /// Which file of the scene it stands in: 0 for the scene's own, then that of an Inline.
    int scope = 0;

    void setEdition(Edition ofNode) { edition_ = ofNode; }

private:
    const NodeType& type_;
    Edition edition_;
    std::vector<Setting> settings_;
    std::uint64_t revision_ = 0;
};

/// An event of a field that goes to another.
struct Route
{
    Node* from;
    std::size_t fromSlot;
    Node* to;
    std::size_t toSlot;
    TextPlace place;
    int scope = 0;
};

enum class Severity {
    /// Unknown, not supported, or taken in another way than it is written.
    warning,
    /// Wrong; what is wrong was left out.
    error,
};

enum class MessageTopic {
    other,
    /// No voxel can be seen of a volume or of a surface, whatever the view is.
    nothingSeen,
};

struct SceneMessage
{
    Severity severity = Severity::warning;
    TextPlace place;
    std::string text;
    MessageTopic topic = MessageTopic::other;
};

/// "scene.x3d:12: warning: text"; of a node that no file has, without the place.
std::string messageLine(const SceneMessage& message);

enum class ChannelType;

/// Voxels as a file has them: the first `components` of `channels` numbers each count.
struct ReadVoxels
{
    std::array<std::int64_t, 3> size{};
    int channels = 1, components = 1;
    ChannelType type{};
    std::vector<std::byte> bytes;
    std::uint64_t revision = 0; ///< of the texture that has the file
};

/// What a file says of itself before its nodes.
struct SceneHeader
{
    std::string profile = "Full";
    std::string version = "4.0";
    struct Component
    {
        std::string name;
        int level = 1;
        int line = 0;
    };
    std::vector<Component> components;
    struct Meta
    {
        std::string name, content;
    };
    std::vector<Meta> metas;
};

/// A scene: its nodes live as long as it does.
class Scene
{
public:
    /// A node below none.
    Node* create(const NodeType& type, Edition ofNode);
    std::size_t nodeCount() const { return nodes_.size(); }
    const std::vector<std::unique_ptr<Node>>& nodes() const { return nodes_; }

    Edition edition = Edition::x3d40;
    SceneHeader header;
    std::vector<Node*> roots;
    std::vector<Route> routes;
    /// By name; of two with one name the later.
    std::map<std::string, Node*, std::less<>> names;
    std::vector<SceneMessage> messages;
    /// What was wrong beyond the messages that are kept.
    std::size_t messagesLeftOut = 0;
    std::shared_ptr<const std::string> file;
    /// What Inline nodes and urls may name, the folder of the scene's file among them.
    SceneFolders folders;
    /// The folder of each file, by the scope of its nodes.
    std::vector<std::filesystem::path> folderOfScope;

    /// Of the files of textures, until these are made.
    std::map<const Node*, std::shared_ptr<ReadVoxels>> readVoxels;

    /// Values that a file has for fields and that were left out: what their nodes lack was told.
    std::set<std::pair<const Node*, std::size_t>> refused;
    /// Whether a field has its default since what the file has for it was left out.
    bool lacksRefused(const Node& node, std::string_view field) const;

    /// Where the file of a url of a node lies.
    SceneFolders::Place locate(const Node& node, std::string_view url) const;
    std::size_t errorCount() const;

    /// Adds a message on a node, once. Beyond 1000 of these they are counted alone.
    void tell(Severity severity, const Node& node, const std::string& text,
              MessageTopic topic = MessageTopic::other);

private:
    std::vector<std::unique_ptr<Node>> nodes_;
    std::set<std::pair<const Node*, std::string>> told_;
};

/// Why a value may not stand in this field; nothing where it may. Range, choices, kinds of nodes, and of
/// images the sizes against the number of values.
std::optional<std::string> objection(const FieldRow& row, const FieldValue& value);

/// Whether it may stand in a scene below no other node.
bool mayBeRoot(const Node& node);

/// Whether both encodings can write it as a name.
bool isNodeName(std::string_view name);

/// Whether `below` is `node` or stands below it.
bool isAtOrBelow(const Node& below, const Node& node);

/// The row of an event's name: fields that are in and out are also set_NAME and NAME_changed.
const FieldRow* eventRow(const Node& node, std::string_view name, bool isOut);

/// Why the events of one field cannot go to the other; nothing where they can.
std::optional<std::string> routeObjection(const Node& from, const FieldRow& fromRow, const Node& to,
                                          const FieldRow& toRow);

} // namespace vo
