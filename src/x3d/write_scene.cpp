#include "x3d/write_scene.h"

#include <algorithm>
#include <set>

namespace vo {
namespace {

/// What XML has no place for becomes a number; so do blanks that a reader would make plain.
std::string escaped(std::string_view text)
{
    std::string out;
    for (const char letter : text) {
        const auto code = static_cast<unsigned char>(letter);
        if (letter == '&')
            out += "&amp;";
        else if (letter == '<')
            out += "&lt;";
        else if (letter == '>')
            out += "&gt;";
        else if (letter == '\'')
            out += "&apos;";
        else if (code < ' ')
            out += "&#" + std::to_string(code) + ";";
        else
            out += letter;
    }
    return out;
}

class SceneWriter
{
public:
    SceneWriter(const Scene& scene, Encoding encoding) : scene_(scene), isXml_(encoding == Encoding::xml)
    {
        nameNodes();
    }

    std::string write()
    {
        if (isXml_)
            beginXml();
        else
            beginClassic();
        for (const Node* const root : scene_.roots) {
            indent();
            writeNode(*root, {});
        }
        for (const Route& route : scene_.routes)
            if (names_.contains(route.from) && names_.contains(route.to) && route.scope == 0)
                writeRoute(route);
        if (isXml_) out_ += "  </Scene>\n</X3D>\n";
        return std::move(out_);
    }

private:
    /// Names for all nodes that are used twice or in routes; no two alike.
    void nameNodes()
    {
        for (const Node* const root : scene_.roots)
            count(*root);
        for (const Route& route : scene_.routes)
            for (const Node* const end : {route.from, route.to})
                if (route.scope == 0 && uses_.contains(end)) uses_[end] += 2;
        std::set<std::string> taken;
        for (const Node* const node : order_)
            if (!node->name.empty() && taken.insert(node->name).second) names_[node] = node->name;
        int number = 0;
        for (const Node* const node : order_) {
            if (names_.contains(node) || (uses_[node] < 2 && node->name.empty())) continue;
            const std::string stem = node->name.empty() ? node->typeName() : node->name;
            std::string name;
            do
                name = stem + "_" + std::to_string(++number);
            while (!taken.insert(name).second);
            names_[node] = name;
        }
    }

    void count(const Node& node)
    {
        if (uses_[&node]++ > 0) return;
        order_.push_back(&node);
        for (const Node::Setting& setting : node.settings())
            if (const auto* const below = std::get_if<std::vector<Node*>>(&setting.value))
                for (const Node* const each : *below)
                    count(*each);
    }

    void beginXml()
    {
        const SceneHeader& header = scene_.header;
        out_ = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<X3D profile='" + escaped(header.profile) +
               "' version='" + escaped(header.version) + "'>\n";
        if (!header.components.empty() || !header.metas.empty()) {
            out_ += "  <head>\n";
            for (const auto& component : header.components)
                out_ += "    <component name='" + escaped(component.name) + "' level='" +
                        std::to_string(component.level) + "'/>\n";
            for (const auto& meta : header.metas)
                out_ +=
                    "    <meta name='" + escaped(meta.name) + "' content='" + escaped(meta.content) + "'/>\n";
            out_ += "  </head>\n";
        }
        out_ += "  <Scene>\n";
        depth_ = 2;
    }

    void beginClassic()
    {
        const SceneHeader& header = scene_.header;
        out_ = "#X3D V" + header.version + " utf8\nPROFILE " + header.profile + "\n";
        for (const auto& component : header.components)
            out_ += "COMPONENT " + component.name + ":" + std::to_string(component.level) + "\n";
        for (const auto& meta : header.metas)
            out_ += "META " + quotedText(meta.name) + " " + quotedText(meta.content) + "\n";
    }

    /// In lines of about 100 characters where blanks stand between numbers.
    void addValue(const std::string& before, const FieldRow& row, std::string text, const char* behind)
    {
        constexpr std::size_t kLine = 100;
        out_ += before;
        const bool isBroken = shapeOf(row.type).storage != Storage::strings;
        std::size_t column = out_.size() - (out_.rfind('\n') + 1);
        std::size_t lastBlank = text.npos;
        for (std::size_t i = 0; isBroken && i <= text.size(); ++i, ++column) {
            if (i < text.size() && text[i] != ' ') continue;
            if (column > kLine && lastBlank != text.npos) {
                text[lastBlank] = '\n';
                column = i - lastBlank;
            }
            lastBlank = i;
        }
        out_ += text + behind;
    }

    void indent() { out_.append(static_cast<std::size_t>(depth_) * 2, ' '); }

    /// From where the line has been indented; ends the line.
    void writeNode(const Node& node, std::string_view container)
    {
        const bool isAgain = !written_.insert(&node).second;
        const auto name = names_.find(&node);
        if (!isXml_) {
            if (isAgain) {
                out_ += "USE " + name->second + "\n";
                return;
            }
            if (name != names_.end()) out_ += "DEF " + name->second + " ";
            out_ += node.typeName() + " {\n";
            writeClassicFields(node);
            return;
        }
        out_ += "<" + node.typeName();
        if (name != names_.end())
            out_ += std::string(isAgain ? " USE" : " DEF") + "='" + escaped(name->second) + "'";
        if (!container.empty() && container != node.type().container())
            out_ += " containerField='" + std::string(container) + "'";
        if (isAgain)
            out_ += "/>\n";
        else
            writeXmlFields(node);
    }

    void writeXmlFields(const Node& node)
    {
        bool hasNodes = false;
        for (const auto& [slot, value] : node.settings()) {
            const FieldRow& row = node.field(slot);
            if (!isKept(row.access)) continue; // what it sent last
            if (shapeOf(row.type).storage == Storage::nodes)
                hasNodes = hasNodes || sizeOf(value) > 0;
            else
                addValue(" " + row.name + "='", row, escaped(valueText(row, value, Encoding::xml)), "'");
        }
        out_ += hasNodes ? ">\n" : "/>\n";
        if (!hasNodes) return;
        ++depth_;
        for (const auto& [slot, value] : node.settings())
            if (const auto* const below = std::get_if<std::vector<Node*>>(&value))
                for (const Node* const each : *below) {
                    indent();
                    writeNode(*each, node.field(slot).name);
                }
        --depth_;
        indent();
        out_ += "</" + node.typeName() + ">\n";
    }

    void writeClassicFields(const Node& node)
    {
        ++depth_;
        for (const auto& [slot, value] : node.settings()) {
            const FieldRow& row = node.field(slot);
            if (!isKept(row.access)) continue;
            indent();
            out_ += row.name + " ";
            const auto* const below = std::get_if<std::vector<Node*>>(&value);
            if (!below)
                addValue("", row, valueText(row, value, Encoding::classic), "\n");
            else if (row.type == FieldType::sfNode)
                below->empty() ? void(out_ += "NULL\n") : writeNode(*below->front(), {});
            else
                writeClassicList(*below);
        }
        --depth_;
        indent();
        out_ += "}\n";
    }

    void writeClassicList(const std::vector<Node*>& nodes)
    {
        out_ += "[\n";
        ++depth_;
        for (const Node* const each : nodes) {
            indent();
            writeNode(*each, {});
        }
        --depth_;
        indent();
        out_ += "]\n";
    }

    void writeRoute(const Route& route)
    {
        const std::string from = names_.at(route.from), to = names_.at(route.to),
                          fromField = route.from->field(route.fromSlot).name,
                          toField = route.to->field(route.toSlot).name;
        indent();
        if (isXml_)
            out_ += "<ROUTE fromNode='" + escaped(from) + "' fromField='" + fromField + "' toNode='" +
                    escaped(to) + "' toField='" + toField + "'/>\n";
        else
            out_ += "ROUTE " + from + "." + fromField + " TO " + to + "." + toField + "\n";
    }

    const Scene& scene_;
    bool isXml_;
    std::string out_;
    int depth_ = 0;
    std::map<const Node*, int> uses_;
    std::vector<const Node*> order_;
    std::map<const Node*, std::string> names_;
    std::set<const Node*> written_;
};

} // namespace

std::string sceneText(const Scene& scene, Encoding encoding)
{
    return SceneWriter(scene, encoding).write();
}

} // namespace vo
