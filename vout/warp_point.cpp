#include "vout/warp_point.h"

#include <algorithm>
#include <cmath>

namespace vo {

glm::dvec3 twisted(const glm::dvec3& point, const glm::dvec3& size, int axis, double angle)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double turn = angle * point[axis] / size[axis];
    glm::dvec3 moved = point;
    moved[u] = std::cos(turn) * point[u] - std::sin(turn) * point[v];
    moved[v] = std::sin(turn) * point[u] + std::cos(turn) * point[v];
    return moved;
}

glm::dvec3 bent(const glm::dvec3& point, const glm::dvec3& size, int axis, int towards, double angle)
{
    const double turn = angle * point[axis] / size[axis];
    if (turn == 0) return point;
    const double radius = size[axis] / angle; // of the arc
    glm::dvec3 moved = point;
    moved[towards] = radius - (radius - point[towards]) * std::cos(turn);
    moved[axis] = (radius - point[towards]) * std::sin(turn);
    return moved;
}

glm::dvec3 tapered(const glm::dvec3& point, const glm::dvec3& size, int axis, double factor)
{
    glm::dvec3 moved = point * (1 + (factor - 1) * (point[axis] / size[axis] + 0.5));
    moved[axis] = point[axis];
    return moved;
}

glm::dvec3 fanned(const glm::dvec3& point, const glm::dvec3& size, const Fan& fan)
{
    const int swingAxis = 3 - fan.depthAxis - fan.beamAxis;
    const glm::dvec3 part = point / size;
    const double depth = part[fan.depthAxis] + 0.5;
    const double radius = fan.innerRadius + (fan.outerRadius - fan.innerRadius) * depth;
    const double turn = fan.angle * part[fan.beamAxis], swing = fan.elevation * part[swingAxis];
    glm::dvec3 moved = point;
    moved[fan.beamAxis] = radius * std::sin(turn);
    moved[fan.depthAxis] = radius * std::cos(turn) * std::cos(swing);
    if (fan.elevation != 0) moved[swingAxis] = radius * std::cos(turn) * std::sin(swing);
    return moved;
}

glm::dvec3 vectorAt(const glm::dvec3& point, const glm::dvec3& size, const VectorField& field)
{
    glm::ivec3 lower, upper;
    glm::dvec3 weight;
    for (int axis = 0; axis < 3; ++axis) {
        const int last = field.cells[axis] - 1;
        const double at =
            std::clamp((point[axis] / size[axis] + 0.5) * field.cells[axis] - 0.5, 0.0, double(last));
        lower[axis] = static_cast<int>(at);
        upper[axis] = std::min(lower[axis] + 1, last);
        weight[axis] = at - lower[axis];
    }
    glm::dvec3 sum(0);
    for (int corner = 0; corner < 8; ++corner) {
        std::size_t cell = 0;
        double share = 1;
        for (int axis = 2; axis >= 0; --axis) {
            const bool isUpper = corner >> axis & 1;
            share *= isUpper ? weight[axis] : 1 - weight[axis];
            cell = cell * static_cast<std::size_t>(field.cells[axis]) +
                   static_cast<std::size_t>(isUpper ? upper[axis] : lower[axis]);
        }
        const float* vector = field.parts.data() + 3 * cell;
        // Cells without weight may hold anything.
        if (share > 0) sum += share * glm::dvec3(vector[0], vector[1], vector[2]);
    }
    return sum;
}

} // namespace vo
