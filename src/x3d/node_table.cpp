#include "x3d/node_table.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <map>
#include <numbers>

#include "x3d/node_declarations.h"
#include "x3d/number_text.h"

namespace vo {

const char* editionText(Edition edition)
{
    switch (edition) {
    case Edition::proposal2005: return "the proposal of 2005";
    case Edition::x3d33: return "X3D 3.3";
    case Edition::x3d40: break;
    }
    return "X3D 4.0";
}

Edition editionOfVersion(int major, int minor)
{
    if (major >= 4) return Edition::x3d40;
    return major == 3 && minor >= 3 ? Edition::x3d33 : Edition::proposal2005;
}

Edition nearestEdition(Editions editions, Edition to)
{
    using enum Edition;
    constexpr Edition kNearest[3][3] = {
        {proposal2005, x3d33, x3d40}, {x3d33, x3d40, proposal2005}, {x3d40, x3d33, proposal2005}};
    for (const Edition edition : kNearest[to == proposal2005 ? 0 : to == x3d33 ? 1 : 2])
        if (has(editions, edition)) return edition;
    return to;
}

bool Range::contains(double number) const
{
    if (orMinusOne && number == -1) return true;
    return (hasLow ? number >= low : number > low) && (hasHigh ? number <= high : number < high);
}

const std::string& NodeType::name(Edition edition) const
{
    const auto found =
        std::ranges::find_if(names_, [&](const Name& name) { return has(name.editions, edition); });
    return found == names_.end() ? names_.front().text : found->text;
}

Editions NodeType::editionsOfName(std::string_view name) const
{
    const auto found = std::ranges::find(names_, name, &Name::text);
    return found == names_.end() ? 0 : found->editions;
}

bool NodeType::isA(const NodeType& base) const
{
    return this == &base || std::ranges::find(bases_, &base) != bases_.end();
}

const FieldRow* NodeType::row(std::string_view name, Edition edition) const
{
    const FieldRow* any = nullptr;
    for (const FieldRow& row : rows_) {
        if (row.name != name) continue;
        if (has(row.editions, edition)) return &row;
        any = &row;
    }
    return any;
}

const FieldRow& NodeType::row(std::size_t slot, Edition edition) const
{
    const FieldRow* any = nullptr;
    for (const FieldRow& row : rows_) {
        if (row.slot != slot) continue;
        if (has(row.editions, edition)) return row;
        any = &row;
    }
    assert(any);
    return *any;
}

Editions NodeType::editionsOfRow(std::string_view name) const
{
    Editions editions = 0;
    for (const FieldRow& row : rows_)
        if (row.name == name) editions |= row.editions;
    return editions;
}

namespace {

/// The words of a line. A list in brackets of any kind is one word with the brackets, if it holds a blank or
/// not.
std::vector<std::string_view> wordsOf(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t at = 0; (at = line.find_first_not_of(' ', at)) != line.npos;) {
        const char close = line[at] == '<' ? '>' : line[at] == '{' ? '}' : ' ';
        std::size_t end = line.find(close, at);
        end = end == line.npos ? line.size() : end + (close != ' ');
        words.push_back(line.substr(at, end - at));
        at = end;
    }
    return words;
}

std::vector<std::string_view> inside(std::string_view list)
{
    return wordsOf(list.substr(1, list.size() - 2));
}

Editions editionsOf(std::string_view when)
{
    if (when.empty()) return kAllEditions;
    static const std::map<std::string_view, Editions> known{
        {"2005", 1}, {"3.3", 2}, {"4.0", 4}, {"iso", 6}, {"3", 3}};
    return known.at(when);
}

double limitOf(std::string_view text)
{
    // Files write pi with few digits.
    constexpr double kPiAbove = std::numbers::pi + 1e-4;
    if (text == "inf") return std::numeric_limits<double>::infinity();
    if (text == "pi") return kPiAbove;
    if (text == "pi/2") return kPiAbove / 2;
    double number = 0;
    [[maybe_unused]] const bool isNumber = parseNumber(text, number);
    assert(isNumber);
    return number;
}

Range rangeOf(std::string_view word)
{
    Range range;
    range.text = word;
    range.orMinusOne = word.ends_with("|-1");
    if (range.orMinusOne) word.remove_suffix(3);
    range.hasLow = word.front() == '[';
    range.hasHigh = word.back() == ']';
    const auto comma = word.find(',');
    range.low = limitOf(word.substr(1, comma - 1));
    range.high = limitOf(word.substr(comma + 1, word.size() - comma - 2));
    return range;
}

/// What a type allows where a row says nothing.
Range rangeOfType(FieldType type)
{
    const bool isColor = type == FieldType::sfColor || type == FieldType::mfColor ||
                         type == FieldType::sfColorRgba || type == FieldType::mfColorRgba;
    return isColor ? rangeOf("[0,1]") : Range{-HUGE_VAL, HUGE_VAL, true, true, false, ""};
}

void addToDefault(std::string_view word, FieldValue& value)
{
    if (auto* const strings = std::get_if<std::vector<std::string>>(&value)) {
        strings->emplace_back(word.substr(1, word.size() - 2));
        return;
    }
    const double number = word == "TRUE" ? 1 : word == "FALSE" ? 0 : limitOf(word);
    if (auto* const integers = std::get_if<std::vector<std::int32_t>>(&value))
        integers->push_back(static_cast<std::int32_t>(number));
    else if (auto* const doubles = std::get_if<std::vector<double>>(&value))
        doubles->push_back(number);
    else
        parseNumber(word, std::get<std::vector<float>>(value).emplace_back());
}

Access accessOf(std::string_view word)
{
    static const std::map<std::string_view, Access> known{{"[]", Access::initializeOnly},
                                                          {"[in]", Access::inputOnly},
                                                          {"[out]", Access::outputOnly},
                                                          {"[in,out]", Access::inputOutput}};
    return known.at(word);
}

} // namespace

/// Makes the table of the declarations.
class NodeTableReader
{
public:
    NodeTableReader()
    {
        for (std::string_view part : nodeDeclarations())
            while (!part.empty()) {
                const auto end = std::min(part.find('\n'), part.size() - 1);
                readLine(part.substr(0, end));
                part.remove_prefix(end + 1);
            }
        resolve();
    }

    std::vector<std::unique_ptr<NodeType>> types;
    std::map<std::string, NodeType*, std::less<>> byName;

private:
    void readLine(std::string_view line)
    {
        auto words = wordsOf(line);
        if (words.empty()) return;
        if (line.starts_with(' '))
            readRow(words);
        else
            readNode(words);
    }

    void readNode(const std::vector<std::string_view>& words)
    {
        NodeType& type = *types.emplace_back(std::make_unique<NodeType>());
        type.isAbstract_ = words[0] == "abstract";
        std::size_t i = 1;
        for (; i < words.size() && words[i] != ":"; ++i) {
            const auto at = std::min(words[i].find('@'), words[i].size());
            const auto when = at == words[i].size() ? "" : words[i].substr(at + 1);
            type.names_.push_back({std::string(words[i].substr(0, at)), editionsOf(when)});
            byName[type.names_.back().text] = &type;
        }
        for (++i; i < words.size() && words[i] != "|"; ++i)
            addBase(type, *byName.find(words[i])->second);
        if (type.isAbstract_) return;
        type.component_ = words[i + 1];
        type.level2005_ = words[i + 2].front() - '0';
        type.levelIso_ = words[i + 2].back() - '0';
        type.container_ = words[i + 4];
    }

    static void addBase(NodeType& type, const NodeType& base)
    {
        if (type.isA(base)) return;
        type.bases_.push_back(&base);
        for (const NodeType* const further : base.bases_)
            if (!type.isA(*further)) type.bases_.push_back(further);
        for (const FieldRow& row : base.rows_)
            addRow(type, row);
    }

    /// The slot of a key is that of the first row with it; the row replaces earlier ones in its editions.
    static FieldRow& addRow(NodeType& type, FieldRow row, std::string_view key = {})
    {
        if (key.empty()) key = row.name;
        const auto sameSlot = std::ranges::find(type.rows_, key, &FieldRow::name);
        row.slot = sameSlot == type.rows_.end() ? type.slotCount_++ : sameSlot->slot;
        for (FieldRow& earlier : type.rows_)
            if (earlier.slot == row.slot) earlier.editions &= ~row.editions;
        std::erase_if(type.rows_, [](const FieldRow& earlier) { return earlier.editions == 0; });
        return type.rows_.emplace_back(std::move(row));
    }

    void readRow(std::vector<std::string_view> words)
    {
        FieldRow row;
        if (words[0].starts_with('@')) {
            row.editions = editionsOf(words[0].substr(1));
            words.erase(words.begin());
        }
        [[maybe_unused]] const bool isType = findFieldType(words[0], row.type);
        assert(isType);
        row.access = accessOf(words[1]);
        const auto equals = words[2].find('=');
        row.name = words[2].substr(0, equals);
        row.range = rangeOfType(row.type);
        row.defaultValue = emptyValue(row.type);
        for (const std::string_view word : std::span(words).subspan(3)) {
            if (word.front() == '<')
                row.acceptedNames = word;
            else if (word.front() == '{')
                for (const auto choice : inside(word))
                    row.choices.emplace_back(choice);
            else if (word.front() == '~')
                row.voxelRange = rangeOf(word.substr(1));
            else if (word.find(',') != word.npos)
                row.range = rangeOf(word);
            else if (word != "[]" && word != "NULL")
                addToDefault(word, row.defaultValue);
        }
        if (!isKept(row.access)) fillDefault(row);
        const auto key = equals == words[2].npos ? std::string_view() : words[2].substr(equals + 1);
        addRow(*types.back(), std::move(row), key);
    }

    /// Events that no file gives begin with zero, FALSE or "".
    static void fillDefault(FieldRow& row)
    {
        const FieldShape& shape = shapeOf(row.type);
        if (shape.isMany || shape.storage == Storage::nodes) return;
        std::visit([&](auto& elements) { elements.resize(static_cast<std::size_t>(shape.components)); },
                   row.defaultValue);
    }

    void resolve()
    {
        for (auto& type : types)
            for (FieldRow& row : type->rows_) {
                if (row.acceptedNames.empty()) continue;
                for (const auto name : inside(row.acceptedNames))
                    row.accepted.push_back(byName.find(name)->second);
            }
    }
};

namespace {

const NodeTableReader& table()
{
    static const NodeTableReader read;
    return read;
}

} // namespace

std::span<const std::unique_ptr<NodeType>> nodeTypes()
{
    return table().types;
}

const NodeType* findNodeType(std::string_view name)
{
    const auto found = table().byName.find(name);
    return found == table().byName.end() || found->second->isAbstract() ? nullptr : found->second;
}

const NodeType& knownNodeType(std::string_view name)
{
    const auto found = table().byName.find(name);
    assert(found != table().byName.end());
    return *found->second;
}

} // namespace vo
