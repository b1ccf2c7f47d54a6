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

glm::dvec4 viewerIn(const StyledScene& scene, const glm::dmat4& worldFromSpace)
{
    const glm::dmat4 spaceFromEye = glm::inverse(scene.eyeFromWorld * worldFromSpace);
    if (isPerspective(scene.clipFromEye)) return spaceFromEye[3];
    // Rays of an oblique view are not along the axis.
    const glm::dmat4 eyeFromClip = glm::inverse(scene.clipFromEye);
    glm::dvec4 way = eyeFromClip[2];
    way /= -way.z;
    return spaceFromEye * way;
}

glm::dvec4 depthRowOf(const StyledScene& scene, const glm::dmat4& worldFromSpace)
{
    return -glm::transpose(scene.eyeFromWorld * worldFromSpace)[2];
}

} // namespace vo
