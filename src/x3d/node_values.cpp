#include "x3d/node_values.h"

namespace vo {
namespace {

template <class Element>
const std::vector<Element>& elementsOf(const Node& node, std::string_view field)
{
    static const std::vector<Element> none;
    const FieldRow* const row = node.field(field);
    const auto* const elements = row ? std::get_if<std::vector<Element>>(&node.value(*row)) : nullptr;
    return elements ? *elements : none;
}

template <class Vector>
Vector firstOf(const Node& node, std::string_view field, const Vector& fallback)
{
    const auto& numbers = floatsOf(node, field);
    if (numbers.size() < static_cast<std::size_t>(Vector::length())) return fallback;
    Vector vector;
    for (int i = 0; i < Vector::length(); ++i)
        vector[i] = numbers[static_cast<std::size_t>(i)];
    return vector;
}

template <class Vector>
std::vector<Vector> vectorsOf(const Node& node, std::string_view field)
{
    constexpr auto length = static_cast<std::size_t>(Vector::length());
    const auto& numbers = floatsOf(node, field);
    std::vector<Vector> vectors(numbers.size() / length);
    for (std::size_t i = 0; i < vectors.size(); ++i)
        for (std::size_t axis = 0; axis < length; ++axis)
            vectors[i][static_cast<int>(axis)] = numbers[i * length + axis];
    return vectors;
}

} // namespace

const std::vector<float>& floatsOf(const Node& node, std::string_view field)
{
    return elementsOf<float>(node, field);
}

const std::vector<std::int32_t>& integersOf(const Node& node, std::string_view field)
{
    return elementsOf<std::int32_t>(node, field);
}

const std::vector<std::string>& stringsOf(const Node& node, std::string_view field)
{
    return elementsOf<std::string>(node, field);
}

const std::vector<Node*>& nodesOf(const Node& node, std::string_view field)
{
    return elementsOf<Node*>(node, field);
}

float floatOf(const Node& node, std::string_view field, float fallback)
{
    const auto& numbers = floatsOf(node, field);
    return numbers.empty() ? fallback : numbers.front();
}

std::int32_t integerOf(const Node& node, std::string_view field, std::int32_t fallback)
{
    const auto& numbers = integersOf(node, field);
    return numbers.empty() ? fallback : numbers.front();
}

double doubleOf(const Node& node, std::string_view field, double fallback)
{
    const auto& numbers = elementsOf<double>(node, field);
    return numbers.empty() ? fallback : numbers.front();
}

bool boolOf(const Node& node, std::string_view field, bool fallback)
{
    return integerOf(node, field, fallback) != 0;
}

glm::vec3 vec3Of(const Node& node, std::string_view field, const glm::vec3& fallback)
{
    return firstOf(node, field, fallback);
}

glm::vec4 vec4Of(const Node& node, std::string_view field, const glm::vec4& fallback)
{
    return firstOf(node, field, fallback);
}

std::string_view stringOf(const Node& node, std::string_view field)
{
    const auto& strings = stringsOf(node, field);
    return strings.empty() ? std::string_view() : strings.front();
}

const Node* nodeOf(const Node& node, std::string_view field)
{
    const auto& nodes = nodesOf(node, field);
    return nodes.empty() ? nullptr : nodes.front();
}

std::vector<glm::vec3> vec3sOf(const Node& node, std::string_view field)
{
    return vectorsOf<glm::vec3>(node, field);
}

std::vector<glm::vec4> vec4sOf(const Node& node, std::string_view field)
{
    return vectorsOf<glm::vec4>(node, field);
}

FieldValue truthValue(bool isTrue)
{
    return std::vector<std::int32_t>{isTrue ? 1 : 0};
}

FieldValue timeValue(double seconds)
{
    return std::vector<double>{seconds};
}

bool isOf(const Node* node, std::string_view typeName)
{
    return node && node->type().isA(knownNodeType(typeName));
}

} // namespace vo
