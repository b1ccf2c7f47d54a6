#pragma once

#include "x3d/scene.h"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// Values of fields by name. A field that the node's edition does not have has no element: numbers are then
/// the fallback.
const std::vector<float>& floatsOf(const Node& node, std::string_view field);
const std::vector<std::int32_t>& integersOf(const Node& node, std::string_view field);
const std::vector<std::string>& stringsOf(const Node& node, std::string_view field);
const std::vector<Node*>& nodesOf(const Node& node, std::string_view field);

float floatOf(const Node& node, std::string_view field, float fallback = 0.0f);
std::int32_t integerOf(const Node& node, std::string_view field, std::int32_t fallback = 0);
double doubleOf(const Node& node, std::string_view field, double fallback = 0.0);
bool boolOf(const Node& node, std::string_view field, bool fallback = false);
glm::vec3 vec3Of(const Node& node, std::string_view field, const glm::vec3& fallback = glm::vec3(0.0f));
glm::vec4 vec4Of(const Node& node, std::string_view field, const glm::vec4& fallback = glm::vec4(0.0f));
/// The first string, or "".
std::string_view stringOf(const Node& node, std::string_view field);
/// The first node, or NULL.
const Node* nodeOf(const Node& node, std::string_view field);

/// Three by three, four by four numbers; what is left over is left out.
std::vector<glm::vec3> vec3sOf(const Node& node, std::string_view field);
std::vector<glm::vec4> vec4sOf(const Node& node, std::string_view field);

/// What a field of one truth, or of one time, holds.
FieldValue truthValue(bool isTrue);
FieldValue timeValue(double seconds);

/// Whether it is of this type or below it; NULL is of none.
bool isOf(const Node* node, std::string_view typeName);

} // namespace vo
