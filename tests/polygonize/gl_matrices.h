#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <numbers>

/// OpenGL's and GLU's matrices from their reference pages, in double.
namespace gl_matrices {

inline glm::dmat4 rows(const glm::dvec4& r0, const glm::dvec4& r1, const glm::dvec4& r2, const glm::dvec4& r3)
{
    glm::dmat4 m;
    for (int column = 0; column < 4; ++column)
        m[column] = {r0[column], r1[column], r2[column], r3[column]};
    return m;
}

inline glm::dmat4 ortho(double l, double r, double b, double t, double n, double f)
{
    return rows({2 / (r - l), 0, 0, -(r + l) / (r - l)}, {0, 2 / (t - b), 0, -(t + b) / (t - b)},
                {0, 0, -2 / (f - n), -(f + n) / (f - n)}, {0, 0, 0, 1});
}

inline glm::dmat4 frustum(double l, double r, double b, double t, double n, double f)
{
    return rows({2 * n / (r - l), 0, (r + l) / (r - l), 0}, {0, 2 * n / (t - b), (t + b) / (t - b), 0},
                {0, 0, -(f + n) / (f - n), -2 * f * n / (f - n)}, {0, 0, -1, 0});
}

inline glm::dmat4 perspective(double degrees, double aspect, double n, double f)
{
    const double top = n * std::tan(degrees * std::numbers::pi / 360);
    return frustum(-top * aspect, top * aspect, -top, top, n, f);
}

inline glm::dmat4 translate(const glm::dvec3& v)
{
    return rows({1, 0, 0, v.x}, {0, 1, 0, v.y}, {0, 0, 1, v.z}, {0, 0, 0, 1});
}

inline glm::dmat4 scale(const glm::dvec3& v)
{
    return rows({v.x, 0, 0, 0}, {0, v.y, 0, 0}, {0, 0, v.z, 0}, {0, 0, 0, 1});
}

inline glm::dmat4 rotate(double degrees, const glm::dvec3& about)
{
    const glm::dvec3 u = glm::normalize(about);
    const double c = std::cos(degrees * std::numbers::pi / 180);
    const double s = std::sin(degrees * std::numbers::pi / 180);
    const glm::dvec3 v = (1 - c) * u;
    return rows({u.x * v.x + c, u.x * v.y - u.z * s, u.x * v.z + u.y * s, 0},
                {u.y * v.x + u.z * s, u.y * v.y + c, u.y * v.z - u.x * s, 0},
                {u.z * v.x - u.y * s, u.z * v.y + u.x * s, u.z * v.z + c, 0}, {0, 0, 0, 1});
}

/// A turn as a compatibility context makes it, where even 90 degrees have a cosine of -4e-8.
inline glm::mat4 rotateInFloats(double degrees, const glm::dvec3& axis)
{
    const auto angle = static_cast<float>(degrees * std::numbers::pi / 180);
    const float c = std::cos(angle), s = std::sin(angle);
    const glm::vec3 u(axis), v = (1 - c) * u;
    return rows({u.x * v.x + c, u.x * v.y - u.z * s, u.x * v.z + u.y * s, 0},
                {u.y * v.x + u.z * s, u.y * v.y + c, u.y * v.z - u.x * s, 0},
                {u.z * v.x - u.y * s, u.z * v.y + u.x * s, u.z * v.z + c, 0}, {0, 0, 0, 1});
}

inline glm::dmat4 lookAt(const glm::dvec3& eye, const glm::dvec3& centre, const glm::dvec3& up)
{
    const glm::dvec3 f = glm::normalize(centre - eye);
    const glm::dvec3 s = glm::normalize(glm::cross(f, up));
    const glm::dvec3 u = glm::cross(s, f);
    return rows({s, 0}, {u, 0}, {-f, 0}, {0, 0, 0, 1}) * translate(-eye);
}

} // namespace gl_matrices
