#include "x3d/value_text.h"

#include <algorithm>
#include <functional>

#include "x3d/number_text.h"
#include "x3d/printable_word.h"

namespace vo {
namespace {

constexpr std::string_view kBetween = " \t\r\n,";

/// Reads an attribute from front to back.
class AttributeReader
{
public:
    AttributeReader(std::string_view text, ValueError& error) : text_(text), error_(error) {}

    /// The next word; empty at the end.
    std::string_view next()
    {
        at_ = std::min(text_.find_first_not_of(kBetween, end_), text_.size());
        end_ = std::min(text_.find_first_of(kBetween, at_), text_.size());
        return text_.substr(at_, end_ - at_);
    }

    bool expected(const char* what, std::string_view found)
    {
        error_.text = std::string("expected ") + what + ", found " + quotedWord(found);
        error_.at = at_;
        return false;
    }

    template <typename Number>
    bool numbers(std::vector<Number>& out)
    {
        for (std::string_view word = next(); !word.empty(); word = next())
            if (!parseNumber(word, out.emplace_back())) return expected("a number", word);
        return true;
    }

    bool integers(std::vector<std::int32_t>& out, bool mayBeUnsigned)
    {
        for (std::string_view word = next(); !word.empty(); word = next())
            if (!parseInteger(word, mayBeUnsigned, out.emplace_back()))
                return expected("a whole number of 32 bits", word);
        return true;
    }

    bool booleans(std::vector<std::int32_t>& out, std::string& remark)
    {
        for (std::string_view word = next(); !word.empty(); word = next()) {
            const bool isTrue = word == "true" || word == "TRUE";
            if (!isTrue && word != "false" && word != "FALSE") return expected("true or false", word);
            if (word[0] < 'a')
                remark = "expected true or false in small letters, found " + std::string(word) + ", taken so";
            out.push_back(isTrue);
        }
        return true;
    }

    bool strings(std::vector<std::string>& out, std::string& remark)
    {
        at_ = std::min(text_.find_first_not_of(kBetween), text_.size());
        if (at_ < text_.size() && text_[at_] != '"') {
            remark = "expected \"strings\" in quotes, found none, taken as one";
            out.emplace_back(text_);
            return true;
        }
        while (at_ < text_.size()) {
            if (text_[at_] != '"') return expected("a string in quotes", text_.substr(at_));
            if (!quoted(out.emplace_back())) return expected("a quote at a string's end", text_.substr(at_));
            at_ = std::min(text_.find_first_not_of(kBetween, at_), text_.size());
        }
        return true;
    }

private:
    bool quoted(std::string& out)
    {
        for (std::size_t i = at_ + 1; i < text_.size(); ++i) {
            if (text_[i] == '"') {
                at_ = i + 1;
                return true;
            }
            if (text_[i] == '\\' && i + 1 < text_.size() && (text_[i + 1] == '"' || text_[i + 1] == '\\'))
                ++i;
            out += text_[i];
        }
        return false;
    }

    std::string_view text_;
    ValueError& error_;
    std::size_t at_ = 0, end_ = 0;
};

bool isBoolean(FieldType type)
{
    return type == FieldType::sfBool || type == FieldType::mfBool;
}

/// 0xFF000080 for red and an opacity of a half.
std::string pixelText(std::int32_t pixel, int components)
{
    constexpr char kDigits[] = "0123456789ABCDEF";
    const auto bits = static_cast<std::uint32_t>(pixel);
    std::string text = "0x";
    for (int digit = 7; digit >= 0; --digit)
        if (digit < 2 * components || bits >> (4 * digit) != 0) text += kDigits[bits >> (4 * digit) & 15u];
    return text;
}

/// Sizes, and pixels of one component, which are numbers, are decimal.
void addPixels(FieldType type, const std::vector<std::int32_t>& image,
               const std::function<void(const std::string&)>& add)
{
    const std::size_t sizes = type == FieldType::sfImage ? 3 : 4;
    const int components = image.size() < sizes ? 0 : type == FieldType::sfImage ? image[2] : image[0];
    for (std::size_t i = 0; i < image.size(); ++i)
        add(i < sizes || components < 2 ? std::to_string(image[i]) : pixelText(image[i], components));
}

} // namespace

bool parseAttribute(const FieldRow& row, std::string_view text, FieldValue& value, ValueError& error,
                    std::string& remark)
{
    AttributeReader reader(text, error);
    const FieldType type = row.type;
    value = emptyValue(type);
    bool isRead = true;
    if (type == FieldType::sfString)
        std::get<std::vector<std::string>>(value).emplace_back(text);
    else if (auto* const strings = std::get_if<std::vector<std::string>>(&value))
        isRead = reader.strings(*strings, remark);
    else if (auto* const floats = std::get_if<std::vector<float>>(&value))
        isRead = reader.numbers(*floats);
    else if (auto* const doubles = std::get_if<std::vector<double>>(&value))
        isRead = reader.numbers(*doubles);
    else if (auto* const integers = std::get_if<std::vector<std::int32_t>>(&value))
        isRead = isBoolean(type) ? reader.booleans(*integers, remark)
                                 : reader.integers(*integers, holdsPixels(row.name));
    else
        return reader.expected("a node as an element", text);
    if (!isRead || fits(type, value)) return isRead;
    const FieldShape& shape = shapeOf(type);
    const std::string per = std::to_string(shape.components);
    error = {"expected " + (shape.isMany ? "a multiple of " + per : per) +
                 (per == "1" ? " value" : " values") + ", found " + std::to_string(sizeOf(value)),
             0};
    return false;
}

std::string quotedText(std::string_view text)
{
    std::string out = "\"";
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') out += '\\';
        out += letter;
    }
    return out + '"';
}

std::string valueText(const FieldRow& row, const FieldValue& value, Encoding encoding)
{
    const FieldType type = row.type;
    if (encoding == Encoding::xml && type == FieldType::sfString)
        return std::get<std::vector<std::string>>(value).front();
    std::string out;
    const auto add = [&](const std::string& word) { out.append(out.empty() ? "" : " ").append(word); };
    if (const auto* const strings = std::get_if<std::vector<std::string>>(&value))
        for (const std::string& text : *strings)
            add(quotedText(text));
    else if (const auto* const floats = std::get_if<std::vector<float>>(&value))
        for (const float number : *floats)
            add(numberText(number));
    else if (const auto* const doubles = std::get_if<std::vector<double>>(&value))
        for (const double number : *doubles)
            add(numberText(number));
    else if (const auto* const integers = std::get_if<std::vector<std::int32_t>>(&value);
             integers && holdsPixels(row.name))
        addPixels(type, *integers, add);
    else if (integers)
        for (const std::int32_t number : *integers)
            add(!isBoolean(type)                ? std::to_string(number)
                : encoding == Encoding::classic ? (number ? "TRUE" : "FALSE")
                                                : (number ? "true" : "false"));
    const bool isList = encoding == Encoding::classic && shapeOf(type).isMany && type != FieldType::sfImage;
    return isList ? "[" + out + "]" : out;
}

} // namespace vo
