#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace vo {

class Node;

/// Types of fields of X3D; the order is that of kFieldTypes and of the face's voX3DFieldType.
enum class FieldType {
    sfBool,
    mfBool,
    sfInt32,
    mfInt32,
    sfFloat,
    mfFloat,
    sfDouble,
    mfDouble,
    sfTime,
    mfTime,
    sfString,
    mfString,
    sfVec2f,
    mfVec2f,
    sfVec3f,
    mfVec3f,
    sfVec4f,
    mfVec4f,
    sfRotation,
    mfRotation,
    sfColor,
    mfColor,
    sfColorRgba,
    mfColorRgba,
    sfImage,
    sfNode,
    mfNode,
};

/// A value of any type. Booleans are 0 and 1; an image is its width, height, components and pixels; a SFNode
/// that is NULL has no element.
using FieldValue = std::variant<std::vector<std::int32_t>, std::vector<float>, std::vector<double>,
                                std::vector<std::string>, std::vector<Node*>>;

/// What a value keeps, as the index in FieldValue.
enum class Storage { integers, floats, doubles, strings, nodes };

struct FieldShape
{
    std::string_view name;
    Storage storage;
    /// Numbers, or strings, or nodes of one element; an image has any number.
    int components;
    /// Whether there may be any number of elements.
    bool isMany;
};

const FieldShape& shapeOf(FieldType type);
/// Whether there is a type of this name.
bool findFieldType(std::string_view name, FieldType& type);

/// No element, of the storage of the type.
FieldValue emptyValue(FieldType type);
/// Numbers, strings or nodes in a value.
std::size_t sizeOf(const FieldValue& value);
/// Whether a value has the storage of the type and a number of elements that it may have.
bool fits(FieldType type, const FieldValue& value);

} // namespace vo
