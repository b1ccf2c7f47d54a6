#include "x3d/interpolate.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <span>

#include "style/hsv_color.h"

namespace vo {
namespace {

/// Between which keys a fraction lies, and how far.
struct KeySpan
{
    std::size_t low = 0, high = 0;
    double part = 0;
};

KeySpan spanOf(std::span<const float> keys, float fraction)
{
    const auto above = std::ranges::upper_bound(keys, fraction);
    if (above == keys.begin()) return {};
    const auto high = static_cast<std::size_t>(above - keys.begin());
    const std::size_t low = high - 1;
    if (high == keys.size()) return {low, low, 0};
    const double from = static_cast<double>(keys[low]), to = static_cast<double>(keys[high]);
    return {low, high, (static_cast<double>(fraction) - from) / (to - from)};
}

using Numbers = std::span<const float>;

std::vector<float> straight(Numbers from, Numbers to, double part)
{
    std::vector<float> value(from.size());
    for (std::size_t i = 0; i < value.size(); ++i)
        value[i] = static_cast<float>(std::lerp(double(from[i]), double(to[i]), part));
    return value;
}

glm::dquat quaternionOf(Numbers rotation)
{
    const glm::dvec3 axis(rotation[0], rotation[1], rotation[2]);
    const double length = glm::length(axis);
    return length > 0 ? glm::angleAxis(double(rotation[3]), axis / length) : glm::dquat(1, 0, 0, 0);
}

std::vector<float> turned(Numbers from, Numbers to, double part)
{
    const glm::dquat between = glm::slerp(quaternionOf(from), quaternionOf(to), part);
    const glm::dvec3 axis(between.x, between.y, between.z);
    const double sine = glm::length(axis);
    if (sine < 1e-12) return {0, 0, 1, 0};
    const glm::dvec3 unit = axis / sine;
    return {float(unit.x), float(unit.y), float(unit.z), float(2 * std::atan2(sine, between.w))};
}

glm::dvec3 colorOf(Numbers numbers)
{
    return {numbers[0], numbers[1], numbers[2]};
}

std::vector<float> mixedColor(Numbers from, Numbers to, double part)
{
    const glm::dvec3 color = HsvRamp(colorOf(from), colorOf(to)).rgbAt(part);
    return {float(color.r), float(color.g), float(color.b)};
}

} // namespace

std::optional<FieldValue> interpolated(const Node& interpolator, float fraction)
{
    if (std::isnan(fraction)) return {};
    const FieldRow& valueRow = *interpolator.field("keyValue");
    const auto& keys = std::get<std::vector<float>>(interpolator.value(*interpolator.field("key")));
    const auto& values = std::get<std::vector<float>>(interpolator.value(valueRow));
    const auto components = static_cast<std::size_t>(shapeOf(valueRow.type).components);
    // Keys that fall end the list.
    const auto rising = static_cast<std::size_t>(std::ranges::is_sorted_until(keys) - keys.begin());
    const std::size_t count = std::min(rising, values.size() / components);
    if (count == 0) return {};
    const KeySpan span = spanOf(std::span(keys).first(count), fraction);
    const Numbers from = std::span(values).subspan(span.low * components, components);
    if (span.part == 0) return FieldValue(std::vector<float>(from.begin(), from.end()));
    const Numbers to = std::span(values).subspan(span.high * components, components);
    switch (valueRow.type) {
    case FieldType::mfRotation: return FieldValue(turned(from, to, span.part));
    case FieldType::mfColor: return FieldValue(mixedColor(from, to, span.part));
    default: return FieldValue(straight(from, to, span.part));
    }
}

} // namespace vo
