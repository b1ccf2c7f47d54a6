#include "draw/draw_sky.h"

#include "draw/scene_view_point.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <vector>

namespace vo {

namespace {

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec2 place;
out vec2 device;
void main()
{
    device = place;
    gl_Position = vec4(place, 1.0, 1.0);
}
)";

// A colour stands at the pole; each further one at its angle.
constexpr const char* kFragmentShader = R"(
in vec2 device;
uniform mat3 ways;
uniform float opacity;
uniform vec3 sky[SKY];
uniform float skyAngles[SKY];
#if GROUND > 1
uniform vec3 ground[GROUND];
uniform float groundAngles[GROUND];
#endif
layout(location = 0) out vec4 fragment;

const float kHalfTurn = 3.14159265;

void main()
{
    vec3 way = normalize(ways * vec3(1.0, device));
    float angle = acos(clamp(way.y, -1.0, 1.0));
    vec3 color = sky[SKY - 1];
    for (int i = SKY - 1; i > 0; --i)
        if (angle <= skyAngles[i]) {
            float wide = skyAngles[i] - skyAngles[i - 1];
            color = mix(sky[i - 1], sky[i], wide > 0.0 ? (angle - skyAngles[i - 1]) / wide : 1.0);
        }
#if GROUND > 1
    angle = kHalfTurn - angle;
    for (int i = GROUND - 1; i > 0; --i)
        if (angle <= groundAngles[i]) {
            float wide = groundAngles[i] - groundAngles[i - 1];
            color = mix(ground[i - 1], ground[i], wide > 0.0 ? (angle - groundAngles[i - 1]) / wide : 1.0);
        }
#endif
    fragment = opacity * vec4(color, 1.0);
}
)";

/// Colours, and the angle of each: 0 for the first.
struct Ramp
{
    std::vector<glm::vec3> colors;
    std::vector<float> angles{0.0f};

    Ramp(const std::vector<glm::vec3>& given, const std::vector<float>& givenAngles)
        : colors(given.begin(),
                 given.begin() + static_cast<std::ptrdiff_t>(std::min(given.size(), givenAngles.size() + 1)))
    {
        if (colors.empty()) colors.emplace_back(0.0f);
        angles.insert(angles.end(), givenAngles.begin(),
                      givenAngles.begin() + static_cast<std::ptrdiff_t>(colors.size() - 1));
    }
};

} // namespace

void drawSky(const StyledScene& scene, SceneResources& resources, SceneArrays& arrays)
{
    const SkyColors& colors = scene.background;
    const Ramp sky(colors.sky, colors.skyAngles), ground(colors.ground, colors.groundAngles);
    SceneProgram& program = resources.programs.find(
        kVertexShader, "#version 330 core\n#define SKY " + std::to_string(sky.colors.size()) +
                           "\n#define GROUND " + std::to_string(ground.colors.size()) + "\n" +
                           kFragmentShader);
    program.use();
    const glm::dmat3 backgroundFromEye =
        glm::inverse(glm::dmat3(scene.eyeFromWorld) * colors.worldFromBackground);
    program.set("ways", glm::mat3(backgroundFromEye * eyeRays(scene.clipFromEye).direction));
    program.set("opacity", std::clamp(colors.opacity, 0.0f, 1.0f));
    program.set("sky", std::span<const glm::vec3>(sky.colors));
    program.set("skyAngles", std::span<const float>(sky.angles));
    program.set("ground", std::span<const glm::vec3>(ground.colors));
    program.set("groundAngles", std::span<const float>(ground.angles));
    arrays.sendPictureTriangle();
    resources.context.gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace vo
