#include "x3d/node_transform.h"

#include "x3d/node_values.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vo {

glm::dmat4 rotationMatrix(const glm::vec4& axisAngle)
{
    const glm::dvec3 axis(axisAngle);
    const double length = glm::length(axis);
    if (length == 0.0) return glm::dmat4(1.0);
    return glm::rotate(glm::dmat4(1.0), static_cast<double>(axisAngle.w), axis / length);
}

glm::dmat4 transformMatrix(const Node& transform)
{
    const glm::dvec3 center(vec3Of(transform, "center"));
    const glm::dmat4 stretch = rotationMatrix(vec4Of(transform, "scaleOrientation"));
    glm::dmat4 matrix =
        glm::translate(glm::dmat4(1.0), glm::dvec3(vec3Of(transform, "translation")) + center);
    matrix *= rotationMatrix(vec4Of(transform, "rotation")) * stretch;
    matrix = glm::scale(matrix, glm::dvec3(vec3Of(transform, "scale", glm::vec3(1.0f))));
    return glm::translate(matrix * glm::transpose(stretch), -center);
}

namespace {

glm::dvec3 unitOr(const glm::dvec3& vector, const glm::dvec3& fallback)
{
    const double length = glm::length(vector);
    return length > 0.0 && std::isfinite(length) ? vector / length : fallback;
}

} // namespace

glm::dmat3 rigidAxes(const glm::dmat4& matrix)
{
    const glm::dvec3 back = unitOr(glm::dvec3(matrix[2]), glm::dvec3(0, 0, 1));
    const glm::dvec3 up(matrix[1]);
    const glm::dvec3 other = std::abs(back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 y =
        unitOr(up - back * glm::dot(up, back), glm::normalize(other - back * glm::dot(other, back)));
    return {glm::cross(y, back), y, back};
}

double smallestScale(const glm::dmat4& matrix)
{
    const glm::dmat3 linear(matrix);
    const glm::dmat3 a = glm::transpose(linear) * linear;
    const double off = a[1][0] * a[1][0] + a[2][0] * a[2][0] + a[2][1] * a[2][1];
    const double mean = (a[0][0] + a[1][1] + a[2][2]) / 3.0;
    const glm::dvec3 apart(a[0][0] - mean, a[1][1] - mean, a[2][2] - mean);
    const double spread = std::sqrt((glm::dot(apart, apart) + 2.0 * off) / 6.0);
    if (!(spread > 1e-12 * mean)) return std::sqrt(std::max(mean, 0.0));
    // The eigenvalues of a symmetric matrix: mean + 2 spread cos(angle), angle in three steps round.
    const glm::dmat3 shape = (a - glm::dmat3(mean)) / spread;
    const double angle = std::acos(std::clamp(glm::determinant(shape) / 2.0, -1.0, 1.0)) / 3.0;
    const double least = mean + 2.0 * spread * std::cos(angle + 2.0 * std::numbers::pi / 3.0);
    return std::sqrt(std::max(least, 0.0));
}

} // namespace vo
