#pragma once

#include <string>
#include <string_view>

#include "x3d/node_table.h"

namespace vo {

/// The encodings of scenes.
enum class Encoding { xml, classic };

/// What was expected and found, and where in the text.
struct ValueError
{
    std::string text;
    std::size_t at = 0;
};

/// Whether whole numbers of a field may be written without a sign up to 2^32 - 1: those with pixels.
constexpr bool holdsPixels(std::string_view fieldName)
{
    return fieldName == "image";
}

/// The value that an attribute of XML writes: numbers between blanks and commas, true and false, "strings" in
/// quotes for many, and without for one. Nodes are no attributes. Whether it could be read; `remark` is then
/// what was taken in another way than it is written, else empty.
bool parseAttribute(const FieldRow& row, std::string_view text, FieldValue& value, ValueError& error,
                    std::string& remark);

/// The value as an attribute of XML, before what XML escapes is, or with brackets in ClassicVRML. Pixels of
/// several components are hexadecimal, two digits for each.
std::string valueText(const FieldRow& row, const FieldValue& value, Encoding encoding);

/// A string in quotes, with what needs it behind a backslash.
std::string quotedText(std::string_view text);

} // namespace vo
