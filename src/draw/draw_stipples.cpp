#include "draw/draw_stipples.h"

#include "style/stipple_points.h"

#include <vector>

namespace vo {

namespace {

constexpr int kValues = 6; ///< position in eye space, colour

constexpr const char* kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 color;
uniform mat4 clipFromEye;
uniform vec2 pictureSize;
out vec3 shown;
void main()
{
    // The middle of the pixel: elsewhere drivers differ in what the nearest pixel is.
    vec4 clip = clipFromEye * vec4(position, 1.0);
    vec2 pixel = floor((0.5 * clip.xy / clip.w + 0.5) * pictureSize) + 0.5;
    gl_Position = vec4((2.0 * pixel / pictureSize - 1.0) * clip.w, clip.zw);
    shown = color;
}
)";

constexpr const char* kFragmentShader = R"(#version 330 core
in vec3 shown;
layout(location = 0) out vec4 fragment;
void main()
{
    fragment = vec4(shown, 1.0);
}
)";

} // namespace

void DrawnStipples::prepare(const StyledScene& scene)
{
    std::vector<float> records;
    for (const StyledVolume& volume : scene.volumes) {
        if (!volume.stipple) continue;
        const glm::dmat4 eyeFromLocal = scene.eyeFromWorld * volume.worldFromLocal;
        for (const StipplePoint& point : stipplePoints(scene, volume, 0)) {
            const glm::dvec4 eye = eyeFromLocal * glm::dvec4(point.position, 1.0);
            for (int axis = 0; axis < 3; ++axis)
                records.push_back(static_cast<float>(eye[axis]));
            for (int channel = 0; channel < 3; ++channel)
                records.push_back(point.color[channel]);
        }
    }
    count_ = static_cast<GLsizei>(records.size() / kValues);
    if (count_ == 0) return;
    arrays_.send(records.data(), records.size());
    arrays_.attribute(0, 3, 0, kValues);
    arrays_.attribute(1, 3, 3, kValues);
}

void DrawnStipples::draw(const StyledScene& scene)
{
    if (count_ == 0) return;
    SceneProgram& program = resources_.programs.find(kVertexShader, kFragmentShader);
    program.use();
    program.set("clipFromEye", glm::mat4(scene.clipFromEye));
    program.set("pictureSize", glm::vec2(scene.width, scene.height));
    arrays_.bind();
    resources_.context.gl.DrawArrays(GL_POINTS, 0, count_);
}

} // namespace vo
