#include "x3d/read_scene.h"

#include "x3d/read_encodings.h"
#include "x3d/printable_word.h"
#include "x3d/scene_text.h"
#include "x3d/text_lines.h"
#include "x3d/utf8_text.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// Reads a scene and the files of its Inline nodes.
class SceneReader
{
public:
    SceneReader(Scene& scene, const SceneLimits& limits)
        : scene_(scene), limits_(limits), bytesLeft_(limits.bytes)
    {
    }

    bool readTop(std::string_view text, const std::string& name, const fs::path& path)
    {
        scene_.file = std::make_shared<const std::string>(name);
        bytesLeft_ -= static_cast<std::int64_t>(text.size());
        addFile(path, -1, 0);
        SceneBuilder builder(scene_, scene_.file, 0, limits_);
        readText(text, builder);
        scene_.header = builder.header;
        scene_.edition = builder.edition();
        scene_.roots = builder.roots;
        if (builder.gaveUp()) return false;
        readInlines();
        return true;
    }

private:
    struct File
    {
        fs::path path;
        int parent;
        int depth;
    };

    void addFile(const fs::path& path, int parent, int depth)
    {
        files_.push_back({path, parent, depth});
        scene_.folderOfScope.push_back(path.parent_path());
    }

    static void readText(std::string_view text, SceneBuilder& builder)
    {
        if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
        if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff"))
            return builder.giveUp(1, "expected text in UTF-8, found UTF-16 or UTF-32");
        const auto zero = text.find('\0');
        if (zero != text.npos)
            return builder.giveUp(TextLines(text.substr(0, zero)).lineAt(zero),
                                  "expected text in UTF-8, found a zero byte");
        if (const auto wrong = firstWrongByte(text); wrong != text.npos)
            builder.warn(TextLines(text.substr(0, wrong)).lineAt(wrong),
                         "expected text in UTF-8, found other bytes, which stay as they are");
        const auto first = text.find_first_not_of(" \t\r\n");
        if (first != text.npos && text[first] == '<')
            readXml(text, builder);
        else
            readClassic(text, builder);
    }

    /// Nodes that are read here come behind, and with them their own Inline nodes.
    void readInlines()
    {
        const NodeType& inlineType = knownNodeType("Inline");
        for (std::size_t i = 0; i < scene_.nodeCount(); ++i)
            if (Node& node = *scene_.nodes()[i]; &node.type() == &inlineType && isLoaded(node))
                readInline(node);
    }

    static bool isLoaded(const Node& node)
    {
        return std::get<std::vector<std::int32_t>>(node.value(*node.field("load"))).front() != 0;
    }

    void readInline(Node& node)
    {
        const auto& urls = std::get<std::vector<std::string>>(node.value(*node.field("url")));
        if (urls.empty() && !scene_.lacksRefused(node, "url"))
            say(node, Severity::warning, "Inline: expected a url, found none: nothing is drawn of it");
        bool isRemote = !urls.empty();
        std::string reasons;
        for (const std::string& url : urls) {
            SceneFolders::Place place = scene_.locate(node, url);
            if (place.reason.empty() && readFile(node, place)) return;
            isRemote = isRemote && place.isRemote;
            reasons += (reasons.empty() ? "" : "; ") + place.reason;
            if (reasons.size() > 400) break;
        }
        if (!reasons.empty()) say(node, isRemote ? Severity::warning : Severity::error, "Inline: " + reasons);
    }

    bool readFile(Node& node, SceneFolders::Place& place)
    {
        std::string text;
        const File& from = files_[static_cast<std::size_t>(node.scope)];
        const std::string name = quotedWord(place.path.filename().string());
        for (int i = node.scope; i >= 0; i = files_[static_cast<std::size_t>(i)].parent)
            if (files_[static_cast<std::size_t>(i)].path == place.path) place.reason = name + " is in itself";
        if (from.depth >= limits_.inlineDepth || static_cast<int>(files_.size()) > limits_.inlines)
            place.reason = name + " is one file too many: at most " + std::to_string(limits_.inlines) + ", " +
                           std::to_string(limits_.inlineDepth) + " deep";
        std::string why;
        if (place.reason.empty() && !readSceneFile(place.path, bytesLeft_, text, why))
            place.reason = name + ": " + why;
        if (!place.reason.empty()) return false;
        bytesLeft_ -= static_cast<std::int64_t>(text.size());
        const int scope = static_cast<int>(files_.size());
        addFile(place.path, node.scope, from.depth + 1);
        SceneBuilder builder(scene_, std::make_shared<const std::string>(place.path.string()), scope,
                             limits_);
        readText(text, builder);
        node.inlined = builder.roots;
        return true;
    }

    void say(const Node& node, Severity severity, std::string text)
    {
        if (scene_.messages.size() < limits_.messages)
            scene_.messages.push_back({severity, node.place, std::move(text)});
        else
            ++scene_.messagesLeftOut;
    }

    Scene& scene_;
    const SceneLimits& limits_;
    std::int64_t bytesLeft_;
    std::vector<File> files_;
};

} // namespace

bool readScene(Scene& scene, const std::string& path, const SceneLimits& limits)
{
    std::string text, reason = "no such file";
    std::error_code error;
    const fs::path whole = fs::canonical(path, error);
    if (error || !readSceneFile(whole, limits.bytes, text, reason)) {
        scene.file = std::make_shared<const std::string>(path);
        SceneMessage& message = scene.messages.emplace_back();
        message.severity = Severity::error;
        message.place.file = scene.file;
        message.text = reason;
        return false;
    }
    scene.folders.allow(whole.parent_path().string());
    return SceneReader(scene, limits).readTop(text, path, whole);
}

bool readSceneText(Scene& scene, std::string_view text, const std::string& name, const SceneLimits& limits)
{
    return SceneReader(scene, limits).readTop(text, name, {});
}

} // namespace vo
