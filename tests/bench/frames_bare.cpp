// The least that slices can cost in OpenGL: one polygon a slice, made before, drawn in one call with the
// textures and the program that the library itself uses for the scene. What the library does more in a frame
// is its overhead.
//
// The library draws one frame first; its program, with all uniforms, and its textures are then taken as they
// are.
#include "bench_scene.h"
#include "bench_worker.h"
#include "volumizer_frames.h"

#include "support/reference.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

namespace {

/// Where the plane cuts the box [0.5, side - 0.5]^3, corners in order round the polygon.
std::vector<glm::dvec3> boxSection(double side, const glm::dvec3& normal, double offset)
{
    std::vector<glm::dvec3> corners;
    const double low = 0.5, high = side - 0.5;
    for (int axis = 0; axis < 3; ++axis)
        for (int edge = 0; edge < 4; ++edge) {
            glm::dvec3 a(low);
            a[(axis + 1) % 3] = edge & 1 ? high : low;
            a[(axis + 2) % 3] = edge & 2 ? high : low;
            glm::dvec3 b = a;
            b[axis] = high;
            const double from = glm::dot(normal, a) - offset, to = glm::dot(normal, b) - offset;
            if ((from < 0.0) != (to < 0.0)) corners.push_back(a + from / (from - to) * (b - a));
        }
    if (corners.size() < 3) return {};
    glm::dvec3 centre(0.0);
    for (const glm::dvec3& corner : corners)
        centre += corner / static_cast<double>(corners.size());
    const glm::dvec3 right = glm::normalize(corners[0] - centre),
                     up = glm::normalize(glm::cross(normal, right));
    std::ranges::sort(corners, {}, [&](const glm::dvec3& p) {
        return std::atan2(glm::dot(p - centre, up), glm::dot(p - centre, right));
    });
    return corners;
}

/// The slices of a scene from the back, three numbers a corner, three corners a triangle.
std::vector<float> sliceTriangles(const bench::Scene& scene)
{
    vo::test::Field sizes;
    sizes.size = {scene.side, scene.side, scene.side};
    vo::test::Scene planes;
    planes.volume = &sizes;
    planes.view = bench::viewerOf(scene).view;
    planes.width = planes.height = bench::kPictureSide;
    const vo::test::ReferencePlanes family = vo::test::referencePlanes(planes);
    std::vector<float> positions;
    for (const double offset : family.offsets) {
        const std::vector<glm::dvec3> corners = boxSection(scene.side, family.normal, offset);
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i, i + 1})
                for (int axis = 0; axis < 3; ++axis)
                    positions.push_back(static_cast<float>(corners[corner][axis]));
    }
    return positions;
}

class BareSlices
{
public:
    BareSlices(const bench::FrameOptions& options, bench::VolumizerFrames& frames)
        : gl_(frames.gl()), frames_(frames)
    {
        // Where fragments are counted, they are drawn slice by slice.
        frames.countFragments([&] { frames.draw(0.0); });
        takeProgram();
        const std::vector<float> positions = sliceTriangles(options.scene);
        count_ = static_cast<GLsizei>(positions.size() / 3);
        GLuint array = 0, buffer = 0;
        gl_.GenVertexArrays(1, &array);
        gl_.GenBuffers(1, &buffer);
        gl_.BindVertexArray(array);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer);
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(positions.size() * sizeof(float)),
                       positions.data(), GL_STATIC_DRAW);
        const auto location = static_cast<GLuint>(gl_.GetAttribLocation(program_, "position"));
        gl_.VertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.EnableVertexAttribArray(location);
        gl_.UseProgram(program_);
    }

    void draw()
    {
        gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl_.DrawArrays(GL_TRIANGLES, 0, count_);
        gl_.Finish();
    }

    std::string facts()
    {
        return bench::jsonPair("fragments", frames_.countFragments([&] { draw(); })) + ", " +
               bench::jsonPair("drawnBy", frames_.renderer());
    }

private:
    /// The only program that has an attribute `position`, and a texture for each of its samplers.
    void takeProgram()
    {
        for (GLuint name = 1; name < 256; ++name) {
            if (!gl_.IsProgram(name) || gl_.GetAttribLocation(name, "position") < 0) continue;
            if (program_ != 0) throw std::runtime_error("the library used several programs for one frame");
            program_ = name;
        }
        if (program_ == 0) throw std::runtime_error("the library's program was not found");
        GLint uniforms = 0;
        gl_.GetProgramiv(program_, GL_ACTIVE_UNIFORMS, &uniforms);
        for (GLuint i = 0; i < static_cast<GLuint>(uniforms); ++i) {
            char name[64] = "";
            GLint size = 0, unit = 0;
            GLenum type = 0;
            gl_.GetActiveUniform(program_, i, sizeof name, nullptr, &size, &type, name);
            if (type != GL_SAMPLER_3D && type != GL_SAMPLER_2D && type != GL_SAMPLER_1D) continue;
            gl_.GetUniformiv(program_, gl_.GetUniformLocation(program_, name), &unit);
            const GLenum target = type == GL_SAMPLER_3D   ? GL_TEXTURE_3D
                                  : type == GL_SAMPLER_2D ? GL_TEXTURE_2D
                                                          : GL_TEXTURE_1D;
            gl_.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            const GLuint texture = onlyTexture(target);
            gl_.BindTexture(target, texture);
        }
    }

    /// Of the target; of two dimensions the one that is a table, one texel high.
    GLuint onlyTexture(GLenum target) const
    {
        GLuint found = 0;
        for (GLuint name = 1; name < 256; ++name) {
            if (!gl_.IsTexture(name)) continue;
            gl_.BindTexture(target, name);
            GLint height = 0;
            if (gl_.GetError() != GL_NO_ERROR) continue; // a texture of another kind
            gl_.GetTexLevelParameteriv(target, 0, GL_TEXTURE_HEIGHT, &height);
            if (target == GL_TEXTURE_2D && height != 1) continue;
            if (found != 0) throw std::runtime_error("the library used several textures of one kind");
            found = name;
        }
        if (found == 0)
            throw std::runtime_error("the library's texture of kind " + std::to_string(target) +
                                     " was not found");
        return found;
    }

    const GladGLContext& gl_;
    bench::VolumizerFrames& frames_;
    GLuint program_ = 0;
    GLsizei count_ = 0;
};

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 2) throw std::invalid_argument("arguments: SCENE FOLDER-OF-VOLUMES");
    setenv("VO_ENGINE", "slices", 1);
    bench::FrameOptions options{bench::sceneNamed(arguments[0]), arguments[1]};
    options.perLength = false;
    bench::VolumizerFrames frames(options);
    BareSlices slices(options, frames);
    bench::Worker worker;
    worker.work = [&](int) { slices.draw(); };
    worker.picture = [&] {
        slices.draw();
        return frames.pixels();
    };
    worker.facts = [&] { return slices.facts(); };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
