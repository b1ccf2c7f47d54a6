#include "draw/scene_view_point.h"

#include <glm/matrix.hpp>

#include <limits>

namespace vo {

DepthsSeen depthsSeen(const glm::dmat4& clipFromEye)
{
    const double zz = clipFromEye[2][2], zw = clipFromEye[2][3];
    const double wz = clipFromEye[3][2], ww = clipFromEye[3][3];
    const auto depthAt = [&](double side) {
        const double change = zz - side * zw;
        return change == 0.0 ? std::numeric_limits<double>::infinity() : (wz - side * ww) / change;
    };
    return {depthAt(-1.0), depthAt(1.0)};
}

bool isPerspective(const glm::dmat4& clipFromEye)
{
    return clipFromEye[2][3] != 0.0;
}

EyeRays eyeRays(const glm::dmat4& clipFromEye)
{
    const glm::dmat4 eyeFromClip = glm::inverse(clipFromEye);
    EyeRays rays;
    for (int i = 0; i < 3; ++i) {
        const double x = i == 1 ? 1.0 : 0.0, y = i == 2 ? 1.0 : 0.0;
        const glm::dvec4 from = eyeFromClip * glm::dvec4(x, y, -1.0, 1.0);
        const glm::dvec4 to = eyeFromClip * glm::dvec4(x, y, 1.0, 1.0);
        // The far end may be at infinity.
        const glm::dvec3 along = glm::dvec3(to) * from.w - glm::dvec3(from) * to.w;
        rays.direction[i] = along / -along.z;
        const glm::dvec3 start = glm::dvec3(from) / from.w;
        rays.origin[i] = start + rays.direction[i] * start.z;
    }
    for (int i = 1; i < 3; ++i) {
        rays.direction[i] -= rays.direction[0];
        rays.origin[i] -= rays.origin[0];
    }
    return rays;
}

glm::dvec4 viewerIn(const StyledScene& scene, const glm::dmat4& worldFromSpace)
{
    const glm::dmat4 spaceFromEye = glm::inverse(scene.eyeFromWorld * worldFromSpace);
    if (isPerspective(scene.clipFromEye)) return spaceFromEye[3];
    return spaceFromEye * glm::dvec4(eyeRays(scene.clipFromEye).direction[0], 0.0);
}

glm::dvec4 depthRowOf(const StyledScene& scene, const glm::dmat4& worldFromSpace)
{
    return -glm::transpose(scene.eyeFromWorld * worldFromSpace)[2];
}

} // namespace vo
