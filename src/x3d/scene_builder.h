#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "x3d/read_scene.h"

namespace vo {

/// Makes the nodes of one file, for the readers of both encodings: names, editions, what may stand where.
/// What is wrong becomes a message of the scene and is left out.
class SceneBuilder
{
public:
    /// The file's nodes go to scene.roots, or below the Inline that it is of.
    SceneBuilder(Scene& scene, std::shared_ptr<const std::string> file, int scope, const SceneLimits& limits);

    void warn(int line, std::string text) { say(Severity::warning, line, std::move(text)); }
    void wrong(int line, std::string text) { say(Severity::error, line, std::move(text)); }
    /// An error that ends the reading.
    void giveUp(int line, std::string text);
    bool gaveUp() const { return gaveUp_; }
    std::size_t messageCount() const { return scene_.messages.size() + scene_.messagesLeftOut; }

    /// The version of the file, "3.3", which decides its edition.
    void setVersion(std::string_view version, int line);
    Edition edition() const { return edition_; }
    void setProfile(std::string_view name, int line);
    void addComponent(std::string_view name, int level, int line);
    SceneHeader header;

    /// The type of a node that is known; NULL after a warning.
    const NodeType* typeOf(std::string_view name, int line);

    /// Begins a node; NULL after giving up. Every begin() has its end().
    Node* begin(const NodeType& type, std::string_view typeName, std::string_view defName, int line);
    /// The innermost node that has begun.
    Node& current() { return *open_.back().node; }
    /// Settles its edition and leaves out what may not stand in it.
    void end();

    /// The row of a field that a file may set; NULL after a message.
    const FieldRow* rowToSet(std::string_view name, int line);
    void set(const FieldRow& row, FieldValue value, int line);
    /// Tells what is wrong with a value, which is left out.
    void refuse(const FieldRow& row, int line, const std::string& why);
    /// Puts a node below the current one, or among the roots where none has begun. An empty field: that of
    /// the node's type, or the first that takes it.
    void attach(Node& child, std::string_view field, int line);
    /// The node of a name; NULL after a message.
    Node* use(std::string_view name, int line);
    /// A name below a node that was skipped: what uses it is skipped without a word.
    void skipName(std::string_view name) { skippedNames_.emplace(name); }

    void route(std::string_view from, std::string_view fromField, std::string_view to,
               std::string_view toField, int line);

    /// The nodes below none.
    std::vector<Node*> roots;

private:
    struct OpenNode
    {
        Node* node;
        Editions editionsOfName;
        struct Written
        {
            const FieldRow* row;
            int line;
        };
        std::vector<Written> written;
    };

    void say(Severity severity, int line, std::string text);
    /// Whether further messages are only counted, so that what takes time to tell is not looked for.
    bool isFull() const { return scene_.messages.size() >= limits_.messages; }
    void giveName(Node& node, std::string_view name, int line);
    void settleEdition(OpenNode& open);
    void checkValue(OpenNode& open, const OpenNode::Written& written);
    const FieldRow* rowFor(const Node& child, int line);
    void attachRoot(Node& child, int line);
    Node* endOfRoute(std::string_view name, int line);

    Scene& scene_;
    std::shared_ptr<const std::string> file_;
    int scope_;
    const SceneLimits& limits_;
    Edition edition_;
    std::vector<OpenNode> open_;
    std::map<std::string, Node*, std::less<>> names_;
    std::set<std::string, std::less<>> skippedNames_;
    bool gaveUp_ = false;
};

} // namespace vo
