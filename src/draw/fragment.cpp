#include "draw/fragment.h"

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

double lookedUp(const Table& table, double value, int column)
{
    const int last = table.size() - 1;
    const double place = value > 0.0 ? std::min(value, 1.0) * last : 0.0;
    const int below = static_cast<int>(place);
    const int above = std::min(below + 1, last);
    const auto entry = [&](int i) {
        return static_cast<double>(table.rgba[static_cast<std::size_t>(4 * i + column)]);
    };
    return entry(below) + (entry(above) - entry(below)) * (place - below);
}

} // namespace

glm::dvec4 fragmentOf(const DrawState& state, const Table* table, glm::dvec4 sampled, const glm::dvec4& color)
{
    if (table) {
        const glm::dvec4 value = state.oneChannel ? glm::dvec4(sampled.r) : sampled;
        for (int column = 0; column < 4; ++column)
            sampled[column] = lookedUp(*table, value[column], column);
    }
    if (!state.replace) return color * sampled;
    if (table || state.textureHasAlpha) return sampled;
    return {sampled.r, sampled.g, sampled.b, color.a};
}

double opacityOver(double alpha, double units)
{
    return 1.0 - std::pow(1.0 - std::clamp(alpha, 0.0, 1.0), units);
}

} // namespace vo
