#include "x3d/scene.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "x3d/number_text.h"
#include "x3d/printable_word.h"

namespace vo {

const FieldRow* Node::field(std::string_view fieldName) const
{
    const FieldRow* const row = type_.row(fieldName, edition_);
    return row && has(row->editions, edition_) ? row : nullptr;
}

const FieldValue* Node::find(std::size_t slot) const
{
    const auto found = std::ranges::lower_bound(settings_, slot, {}, &Setting::slot);
    return found != settings_.end() && found->slot == slot ? &found->value : nullptr;
}

const FieldValue& Node::value(std::size_t slot) const
{
    const FieldValue* const own = find(slot);
    return own ? *own : field(slot).defaultValue;
}

void Node::put(std::size_t slot, FieldValue value)
{
    ++revision_;
    const auto found = std::ranges::lower_bound(settings_, slot, {}, &Setting::slot);
    if (found != settings_.end() && found->slot == slot)
        found->value = std::move(value);
    else
        settings_.insert(found, {slot, std::move(value)});
}

void Node::unset(std::size_t slot)
{
    ++revision_;
    std::erase_if(settings_, [&](const Setting& setting) { return setting.slot == slot; });
}

std::string messageLine(const SceneMessage& message)
{
    const TextPlace& place = message.place;
    return (place.file ? *place.file + ":" : "") + (place.line > 0 ? std::to_string(place.line) + ":" : "") +
           (place.file ? " " : "") + (message.severity == Severity::error ? "error: " : "warning: ") +
           message.text;
}

Node* Scene::create(const NodeType& type, Edition ofNode)
{
    return nodes_.emplace_back(std::make_unique<Node>(type, ofNode)).get();
}

SceneFolders::Place Scene::locate(const Node& node, std::string_view url) const
{
    const auto scope = static_cast<std::size_t>(node.scope);
    return folders.locate(url, scope < folderOfScope.size() ? folderOfScope[scope] : std::filesystem::path());
}

bool Scene::lacksRefused(const Node& node, std::string_view field) const
{
    const FieldRow* const row = refused.empty() ? nullptr : node.field(field);
    return row && !node.isSet(row->slot) && refused.contains({&node, row->slot});
}

std::size_t Scene::errorCount() const
{
    return static_cast<std::size_t>(std::ranges::count(messages, Severity::error, &SceneMessage::severity));
}

void Scene::tell(Severity severity, const Node& node, const std::string& text, MessageTopic topic)
{
    constexpr std::size_t kMost = 1000;
    if (told_.size() >= kMost) {
        if (!told_.contains({&node, text})) ++messagesLeftOut;
        return;
    }
    if (told_.emplace(&node, text).second) messages.push_back({severity, node.place, text, topic});
}

namespace {

std::string named(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
    return text;
}

template <typename Number>
std::optional<std::string> outside(const Range& range, const std::vector<Number>& numbers)
{
    for (const Number number : numbers)
        if (!range.contains(static_cast<double>(number)))
            return "expected numbers in " + range.text + ", found " + numberText(number);
    return {};
}

std::optional<std::string> noChoice(const FieldRow& row, const std::vector<std::string>& strings)
{
    if (row.choices.empty()) return {};
    for (const std::string& text : strings)
        if (std::ranges::find(row.choices, text) == row.choices.end())
            return "expected " + named(row.choices) + ", found " + quotedWord(text);
    return {};
}

std::optional<std::string> wrongNode(const FieldRow& row, const std::vector<Node*>& nodes)
{
    for (const Node* const node : nodes) {
        const bool isAccepted =
            std::ranges::any_of(row.accepted, [&](const NodeType* type) { return node->type().isA(*type); });
        if (isAccepted) continue;
        std::vector<std::string> names;
        for (const NodeType* const type : row.accepted)
            names.push_back(type->name(node->edition()));
        return "expected " + named(names) + ", found " + node->typeName();
    }
    return {};
}

/// The sizes of SFImage are width, height and components; those of PixelTexture3D components, width, height
/// and depth. None of the products is trusted before it is known to fit.
std::optional<std::string> wrongImage(const FieldRow& row, const std::vector<std::int32_t>& numbers)
{
    const bool isFlat = row.type == FieldType::sfImage;
    const std::size_t sizes = isFlat ? 3 : 4;
    if (numbers.size() < sizes)
        return std::string("expected ") +
               (isFlat ? "width, height and components" : "components, width, height and depth") +
               ", found " + std::to_string(numbers.size()) + " numbers";
    const std::int32_t components = isFlat ? numbers[2] : numbers[0];
    if (components < 0 || components > 4)
        return "expected 0 to 4 components, found " + std::to_string(components);
    std::uint64_t pixels = 1;
    std::string product;
    for (std::size_t i = isFlat ? 0 : 1; i < (isFlat ? 2u : 4u); ++i) {
        if (numbers[i] < 0) return "expected a size of at least 0, found " + std::to_string(numbers[i]);
        product += (product.empty() ? "" : " x ") + std::to_string(numbers[i]);
        if (__builtin_mul_overflow(pixels, static_cast<std::uint64_t>(numbers[i]), &pixels))
            return "expected sizes with a product below 2^64, found more";
    }
    const std::size_t found = numbers.size() - sizes;
    if (components == 0 && found == 0) return {};
    if (pixels == found) return {};
    return "expected " + product + " = " + std::to_string(pixels) + " pixels, found " + std::to_string(found);
}

} // namespace

std::optional<std::string> objection(const FieldRow& row, const FieldValue& value)
{
    const bool isOneNode = row.type == FieldType::sfNode && std::holds_alternative<std::vector<Node*>>(value);
    if (isOneNode && !fits(row.type, value))
        return "expected one node, found " + std::to_string(sizeOf(value)) + ": none is kept";
    if (!fits(row.type, value))
        return "expected " + std::string(shapeOf(row.type).name) + ", found " +
               std::to_string(sizeOf(value)) + " elements or another type";
    if (const auto* const strings = std::get_if<std::vector<std::string>>(&value))
        return noChoice(row, *strings);
    if (const auto* const nodes = std::get_if<std::vector<Node*>>(&value)) return wrongNode(row, *nodes);
    if (const auto* const floats = std::get_if<std::vector<float>>(&value))
        return outside(row.range, *floats);
    if (const auto* const doubles = std::get_if<std::vector<double>>(&value))
        return outside(row.range, *doubles);
    const auto& integers = std::get<std::vector<std::int32_t>>(value);
    if (row.name == "image") return wrongImage(row, integers);
    return outside(row.range, integers);
}

bool mayBeRoot(const Node& node)
{
    return node.type().isA(knownNodeType("X3DChildNode")) ||
           node.type().isA(knownNodeType("X3DMetadataObject"));
}

bool isNodeName(std::string_view name)
{
    const auto isWrong = [](unsigned char letter) {
        return letter <= ' ' || letter == 0x7f ||
               std::string_view("\"#',.[]\\{}&<>").find(static_cast<char>(letter)) != std::string_view::npos;
    };
    const bool beginsRight = !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0])) &&
                             name[0] != '+' && name[0] != '-';
    return beginsRight && std::ranges::none_of(name, isWrong);
}

bool isAtOrBelow(const Node& below, const Node& node)
{
    std::vector<const Node*> left{&node};
    std::set<const Node*> seen;
    while (!left.empty()) {
        const Node* const next = left.back();
        left.pop_back();
        if (next == &below) return true;
        if (!seen.insert(next).second) continue;
        for (const Node::Setting& setting : next->settings())
            if (const auto* const nodes = std::get_if<std::vector<Node*>>(&setting.value))
                left.insert(left.end(), nodes->begin(), nodes->end());
    }
    return false;
}

const FieldRow* eventRow(const Node& node, std::string_view name, bool isOut)
{
    if (const FieldRow* const row = node.field(name)) return row;
    if (isOut && name.ends_with("_changed"))
        name.remove_suffix(std::string_view("_changed").size());
    else if (!isOut && name.starts_with("set_"))
        name.remove_prefix(std::string_view("set_").size());
    else
        return nullptr;
    const FieldRow* const row = node.field(name);
    return row && row->access == Access::inputOutput ? row : nullptr;
}

std::optional<std::string> routeObjection(const Node& from, const FieldRow& fromRow, const Node& to,
                                          const FieldRow& toRow)
{
    if (!isOutput(fromRow.access)) return from.typeName() + "." + fromRow.name + " sends no events";
    if (!isInput(toRow.access)) return to.typeName() + "." + toRow.name + " takes no events";
    if (fromRow.type == toRow.type) return {};
    return from.typeName() + "." + fromRow.name + " is of type " + std::string(shapeOf(fromRow.type).name) +
           ", " + to.typeName() + "." + toRow.name + " of type " + std::string(shapeOf(toRow.type).name);
}

} // namespace vo
