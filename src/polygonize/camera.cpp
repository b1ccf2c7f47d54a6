#include "polygonize/camera.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// Below this, relative to its size, 1 / clip w counts as the same from near to far: orthographic.
constexpr double kSameDepth = 1e-9;
/// Below this, after rows and columns were scaled to unit size, a determinant counts as zero.
constexpr double kSingular = 1e-13;
/// Below this, beside the others, a component of a turned normal counts as rounded: quarter turns in single
/// precision leave some 1e-7.
constexpr double kRounded = 1e-6;

bool allFinite(const glm::dmat4& m)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row])) return false;
    return true;
}

double largest(const glm::dvec4& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w)});
}

/// Scales rows and columns in turn: how far a matrix is from singular does not depend on units nor on where
/// the origin lies, but its determinant does.
bool singular(glm::dmat4 m)
{
    for (int pass = 0; pass < 4; ++pass) {
        for (int column = 0; column < 4; ++column) {
            const double size = largest(m[column]);
            if (!(size > 0.0)) return true;
            m[column] /= size;
        }
        m = glm::transpose(m);
    }
    const double size = glm::determinant(m);
    return !(std::abs(size) > kSingular);
}

glm::dvec3 xyz(const glm::dvec4& v)
{
    return {v.x, v.y, v.z};
}

glm::dvec3 unproject(const glm::dmat4& inverse, double x, double y, double z)
{
    const glm::dvec4 p = inverse * glm::dvec4(x, y, z, 1.0);
    return xyz(p) / p.w;
}

double depthOnPlane(const Camera& camera, const glm::dmat4& inverse, double z)
{
    const glm::dvec4 p = inverse * glm::dvec4(0.0, 0.0, z, 1.0);
    if (std::abs(p.w) <= 1e-14 * largest(inverse[3])) return HUGE_VAL;
    return glm::dot(camera.depthNormal, xyz(p) / p.w);
}

/// The unit normal of a plane that is given in object space, without what rounding left of components that
/// were none before the model was scaled.
glm::dvec3 cleanNormal(const glm::dvec4& plane, const glm::dmat4& model)
{
    glm::dvec3 normal = xyz(plane), turned;
    for (int axis = 0; axis < 3; ++axis)
        turned[axis] = std::abs(normal[axis]) / glm::length(xyz(model[axis]));
    const double least = kRounded * std::max({turned.x, turned.y, turned.z});
    for (int axis = 0; axis < 3; ++axis)
        if (turned[axis] < least) normal[axis] = 0.0;
    return normal / glm::length(normal);
}

/// Every line of sight goes to the same clip x, y and w; the third column of the inverse is where they all
/// meet, a point or a direction.
void placeViewer(Camera& camera, const glm::dmat4& model, const glm::dmat4& toClip, const glm::dmat4& inverse)
{
    const glm::dmat4 rows = glm::transpose(toClip);
    const double side = inverse[3].w > 0.0 ? 1.0 : -1.0; // sign of clip w in the middle of the view volume
    const glm::dvec4 meeting = inverse[2];
    if (camera.perspective) {
        camera.eye = xyz(meeting) / meeting.w;
        camera.direction = glm::normalize(unproject(inverse, 0.0, 0.0, 0.0) - camera.eye);
        camera.depthNormal = side * cleanNormal(rows[3], model);
    } else {
        camera.direction = side * glm::normalize(xyz(meeting));
        camera.depthNormal = side * cleanNormal(rows[2], model);
    }
}

} // namespace

glm::dvec3 Camera::towards(const glm::dvec3& point) const
{
    if (!perspective) return direction;
    const glm::dvec3 way = point - eye;
    const double length = glm::length(way);
    return length > 0.0 ? way / length : direction;
}

std::optional<Camera> findCamera(const glm::dmat4& model, const glm::dmat4& projection)
{
    const glm::dmat4 toClip = projection * model;
    if (!allFinite(toClip) || singular(toClip)) return std::nullopt;
    const glm::dmat4 inverse = glm::inverse(toClip);
    if (!allFinite(inverse)) return std::nullopt;

    Camera camera;
    camera.perspective = std::abs(inverse[2].w) > kSameDepth * std::abs(inverse[3].w);
    placeViewer(camera, model, toClip, inverse);
    camera.nearDepth = depthOnPlane(camera, inverse, -1.0);
    camera.farDepth = depthOnPlane(camera, inverse, 1.0);
    for (int corner = 0; corner < 8; ++corner)
        camera.corners[static_cast<std::size_t>(corner)] =
            unproject(inverse, corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0);
    const bool usable = std::isfinite(glm::dot(camera.eye, camera.eye)) &&
                        std::isfinite(glm::dot(camera.direction, camera.depthNormal));
    return usable ? std::optional(camera) : std::nullopt;
}

} // namespace vo
