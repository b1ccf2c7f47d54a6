#include "x3d/read_encodings.h"

#include <algorithm>
#include <pugixml.hpp>

#include "x3d/printable_word.h"
#include "x3d/text_lines.h"
#include "x3d/value_text.h"

namespace vo {
namespace {

/// Attributes that are no fields.
bool isPlainAttribute(std::string_view name)
{
    return name == "DEF" || name == "USE" || name == "containerField" || name == "class" || name == "id" ||
           name == "style" || name.starts_with("xmlns") || name.find(':') != name.npos;
}

/// The attributes of an element as they stand in the file, one after the other: pugixml does not tell where.
class AttributeTexts
{
public:
    AttributeTexts(std::string_view text, const pugi::xml_node& element)
        : text_(text),
          at_(static_cast<std::size_t>(element.offset_debug()) + std::string_view(element.name()).size())
    {
    }

    /// What stands between the quotes of the next one.
    std::string_view next()
    {
        const std::size_t from = text_.find_first_of("\"'", at_);
        const std::size_t to = from == text_.npos ? from : text_.find(text_[from], from + 1);
        if (to == text_.npos) return text_.substr(std::min(at_, text_.size()));
        at_ = to + 1;
        return text_.substr(from + 1, to - from - 1);
    }

private:
    std::string_view text_;
    std::size_t at_;
};

class XmlReader
{
public:
    XmlReader(std::string_view text, SceneBuilder& builder) : text_(text), lines_(text), builder_(builder) {}

    void read()
    {
        if (!parse()) return;
        const pugi::xml_node top = document_.document_element();
        if (std::string_view(top.name()) != "X3D")
            return builder_.giveUp(lineOf(top), "expected the element X3D, found " + quotedWord(top.name()));
        readTop(top);
        for (pugi::xml_node other = top.next_sibling(); other; other = other.next_sibling())
            if (other.type() == pugi::node_element)
                builder_.warn(lineOf(other), "expected one element X3D, found another, " +
                                                 quotedWord(other.name()) + ": skipped");
        for (const pugi::xml_node part : top.children()) {
            const std::string_view name = part.name();
            if (name == "head")
                readHead(part);
            else if (name == "Scene")
                readContent(part);
            else if (part.type() == pugi::node_element)
                builder_.warn(lineOf(part), "unknown element " + quotedWord(name) + " skipped");
        }
        if (!top.child("Scene")) builder_.wrong(lineOf(top), "expected an element Scene in X3D, found none");
    }

private:
    bool parse()
    {
        const auto parsed = document_.load_buffer(
            text_.data(), text_.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
        if (!parsed) {
            const auto place =
                std::min(text_.size(), static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, parsed.offset)));
            builder_.giveUp(lines_.lineAt(place),
                            std::string("expected XML, found: ") + parsed.description());
            return false;
        }
        for (const pugi::xml_node part : document_.children())
            if (part.type() == pugi::node_doctype &&
                std::string_view(part.value()).find('[') != std::string_view::npos) {
                builder_.giveUp(lines_.lineAt(text_.find("<!DOCTYPE")),
                                "expected a DOCTYPE without declarations: entities are not read");
                return false;
            }
        return true;
    }

    int lineOf(const pugi::xml_node& node) const
    {
        return lines_.lineAt(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, node.offset_debug())));
    }

    /// Of the first word of text between elements.
    int lineOfText(const pugi::xml_node& part) const
    {
        const auto from = static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, part.offset_debug()));
        return lines_.lineAt(std::min(text_.find_first_not_of(" \t\r\n", from), text_.size()));
    }

    /// A place in the text between the quotes of an attribute.
    int lineIn(std::string_view raw, std::size_t inside = 0) const
    {
        return lines_.lineAt(static_cast<std::size_t>(raw.data() - text_.data()) +
                             std::min(inside, raw.size()));
    }

    void readTop(const pugi::xml_node& top)
    {
        if (const auto version = top.attribute("version"))
            builder_.setVersion(version.value(), lineOf(top));
        else
            builder_.warn(lineOf(top), "expected a version of X3D, found none, taken as 4.0");
        if (const auto profile = top.attribute("profile"))
            builder_.setProfile(profile.value(), lineOf(top));
        else
            builder_.warn(lineOf(top), "expected a profile of X3D, found none, taken as Full");
    }

    void readHead(const pugi::xml_node& head)
    {
        for (const pugi::xml_node part : head.children()) {
            const std::string_view name = part.name();
            if (name == "component")
                builder_.addComponent(part.attribute("name").value(), part.attribute("level").as_int(1),
                                      lineOf(part));
            else if (name == "meta")
                builder_.header.metas.push_back(
                    {part.attribute("name").value(), part.attribute("content").value()});
            else if (part.type() == pugi::node_element)
                builder_.warn(lineOf(part), "unknown element " + quotedWord(name) + " skipped");
        }
    }

    /// The nodes and routes in an element.
    void readContent(const pugi::xml_node& parent)
    {
        for (const pugi::xml_node part : parent.children()) {
            if (builder_.gaveUp()) return;
            if (part.type() != pugi::node_element) {
                if (part.type() == pugi::node_pcdata || part.type() == pugi::node_cdata)
                    builder_.warn(lineOfText(part), "text in " + quotedWord(parent.name()) + " skipped");
                continue;
            }
            if (std::string_view(part.name()) == "ROUTE")
                readRoute(part);
            else
                readNode(part);
        }
    }

    void readRoute(const pugi::xml_node& route)
    {
        builder_.route(route.attribute("fromNode").value(), route.attribute("fromField").value(),
                       route.attribute("toNode").value(), route.attribute("toField").value(), lineOf(route));
    }

    void readNode(const pugi::xml_node& element)
    {
        const int line = lineOf(element);
        const NodeType* const type = builder_.typeOf(element.name(), line);
        if (!type) return skipNames(element);
        const std::string_view container = element.attribute("containerField").value();
        if (const auto use = element.attribute("USE")) {
            tellOfUse(element, line);
            if (Node* const node = builder_.use(use.value(), line)) attachUsed(*node, *type, container, line);
            return;
        }
        Node* const node = builder_.begin(*type, element.name(), element.attribute("DEF").value(), line);
        if (!node) return;
        AttributeTexts texts(text_, element);
        for (const pugi::xml_attribute attribute : element.attributes()) {
            const std::string_view raw = texts.next();
            if (!isPlainAttribute(attribute.name())) readField(attribute, raw);
        }
        readContent(element);
        builder_.end();
        if (!builder_.gaveUp()) builder_.attach(*node, container, line);
    }

    /// What stands in an element that names another node.
    void tellOfUse(const pugi::xml_node& element, int line)
    {
        const std::string what = "USE of " + quotedWord(element.attribute("USE").value()) + ": ";
        for (const pugi::xml_attribute attribute : element.attributes())
            if (std::string_view(attribute.name()) == "DEF" || !isPlainAttribute(attribute.name()))
                builder_.warn(line,
                              what + quotedWord(attribute.name()) + " is not read, the node is as it was");
        if (element.first_child())
            builder_.warn(line, what + "what stands in it is not read, the node is as it was");
    }

    void attachUsed(Node& node, const NodeType& type, std::string_view container, int line)
    {
        if (&node.type() != &type)
            builder_.wrong(line, "USE of the " + node.typeName() + " " + quotedWord(node.name) + " as " +
                                     type.name(builder_.edition()));
        else
            builder_.attach(node, container, line);
    }

    void readField(const pugi::xml_attribute& attribute, std::string_view raw)
    {
        const FieldRow* const row = builder_.rowToSet(attribute.name(), lineIn(raw));
        if (!row) return;
        FieldValue value;
        ValueError error;
        std::string remark;
        const bool isRead = parseAttribute(*row, attribute.value(), value, error, remark);
        const int line = lineIn(raw, isRead ? 0 : error.at);
        if (!isRead) return builder_.refuse(*row, line, error.text);
        if (!remark.empty())
            builder_.warn(line, builder_.current().typeName() + "." + row->name + ": " + remark);
        builder_.set(*row, std::move(value), line);
    }

    /// What uses a name in an element that was skipped is skipped too.
    void skipNames(const pugi::xml_node& element)
    {
        struct Names : pugi::xml_tree_walker
        {
            explicit Names(SceneBuilder& target) : builder(target) {}
            bool for_each(pugi::xml_node& node) override
            {
                if (const auto name = node.attribute("DEF")) builder.skipName(name.value());
                return true;
            }
            SceneBuilder& builder;
        } names(builder_);
        pugi::xml_node top = element;
        names.for_each(top);
        top.traverse(names);
    }

    std::string_view text_;
    TextLines lines_;
    SceneBuilder& builder_;
    pugi::xml_document document_;
};

} // namespace

void readXml(std::string_view text, SceneBuilder& builder)
{
    XmlReader(text, builder).read();
}

} // namespace vo
