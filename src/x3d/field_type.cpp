#include "x3d/field_type.h"

#include <algorithm>
#include <array>

namespace vo {
namespace {

constexpr std::array<FieldShape, 27> kFieldTypes{{
    {"SFBool", Storage::integers, 1, false},    {"MFBool", Storage::integers, 1, true},
    {"SFInt32", Storage::integers, 1, false},   {"MFInt32", Storage::integers, 1, true},
    {"SFFloat", Storage::floats, 1, false},     {"MFFloat", Storage::floats, 1, true},
    {"SFDouble", Storage::doubles, 1, false},   {"MFDouble", Storage::doubles, 1, true},
    {"SFTime", Storage::doubles, 1, false},     {"MFTime", Storage::doubles, 1, true},
    {"SFString", Storage::strings, 1, false},   {"MFString", Storage::strings, 1, true},
    {"SFVec2f", Storage::floats, 2, false},     {"MFVec2f", Storage::floats, 2, true},
    {"SFVec3f", Storage::floats, 3, false},     {"MFVec3f", Storage::floats, 3, true},
    {"SFVec4f", Storage::floats, 4, false},     {"MFVec4f", Storage::floats, 4, true},
    {"SFRotation", Storage::floats, 4, false},  {"MFRotation", Storage::floats, 4, true},
    {"SFColor", Storage::floats, 3, false},     {"MFColor", Storage::floats, 3, true},
    {"SFColorRGBA", Storage::floats, 4, false}, {"MFColorRGBA", Storage::floats, 4, true},
    {"SFImage", Storage::integers, 1, true},    {"SFNode", Storage::nodes, 1, false},
    {"MFNode", Storage::nodes, 1, true},
}};
static_assert(kFieldTypes.size() == static_cast<std::size_t>(FieldType::mfNode) + 1);

} // namespace

const FieldShape& shapeOf(FieldType type)
{
    return kFieldTypes[static_cast<std::size_t>(type)];
}

bool findFieldType(std::string_view name, FieldType& type)
{
    const auto found = std::ranges::find(kFieldTypes, name, &FieldShape::name);
    if (found == kFieldTypes.end()) return false;
    type = static_cast<FieldType>(found - kFieldTypes.begin());
    return true;
}

FieldValue emptyValue(FieldType type)
{
    switch (shapeOf(type).storage) {
    case Storage::integers: return std::vector<std::int32_t>();
    case Storage::floats: return std::vector<float>();
    case Storage::doubles: return std::vector<double>();
    case Storage::strings: return std::vector<std::string>();
    case Storage::nodes: break;
    }
    return std::vector<Node*>();
}

std::size_t sizeOf(const FieldValue& value)
{
    return std::visit([](const auto& elements) { return elements.size(); }, value);
}

bool fits(FieldType type, const FieldValue& value)
{
    const FieldShape& shape = shapeOf(type);
    if (value.index() != static_cast<std::size_t>(shape.storage)) return false;
    const std::size_t size = sizeOf(value), components = static_cast<std::size_t>(shape.components);
    if (type == FieldType::sfNode) return size <= 1;
    return shape.isMany ? size % components == 0 : size == components;
}

} // namespace vo
