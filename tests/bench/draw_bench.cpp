// Frames of drawUtility beside the same slices drawn by bare OpenGL: one convex polygon a plane, one texture,
// one table, nothing asked of OpenGL and nothing given back. Each round draws one frame of every case.
//   draw_bench [PATTERN [ROUNDS [SIZE]]]

#include "demos/common/offscreen/offscreen.h"
#include "support/views.h"

#include <vo/Volumizer.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

constexpr int kPixels = 512;

double seconds(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Every voxel between 128 and 255.
std::vector<std::uint8_t> denseVolume(int size)
{
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(size) * size * size);
    std::minstd_rand random(1);
    for (std::uint8_t& v : voxels)
        v = static_cast<std::uint8_t>(128 + random() % 128);
    return voxels;
}

/// Straight tubes at random until 12% of the voxels are above zero.
std::vector<std::uint8_t> sparseVolume(int size)
{
    std::vector<std::uint8_t> voxels(static_cast<std::size_t>(size) * size * size, 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> anywhere(0.0f, static_cast<float>(size));
    const float radius = static_cast<float>(size) * 9.0f / 256.0f;
    std::size_t visible = 0;
    while (static_cast<double>(visible) < 0.12 * static_cast<double>(voxels.size())) {
        const glm::vec3 a(anywhere(random), anywhere(random), anywhere(random));
        const glm::vec3 along = glm::vec3(anywhere(random), anywhere(random), anywhere(random)) - a;
        const float length = std::sqrt(along.x * along.x + along.y * along.y + along.z * along.z);
        const int steps = static_cast<int>(length);
        const int reach = static_cast<int>(radius) + 1;
        for (int i = 0; i < steps; ++i) {
            const glm::vec3 c = a + along * (static_cast<float>(i) / length);
            for (int z = -reach; z <= reach; ++z)
                for (int y = -reach; y <= reach; ++y)
                    for (int x = -reach; x <= reach; ++x) {
                        const int px = static_cast<int>(c.x) + x, py = static_cast<int>(c.y) + y,
                                  pz = static_cast<int>(c.z) + z;
                        if (px < 0 || py < 0 || pz < 0 || px >= size || py >= size || pz >= size) continue;
                        const float d = std::sqrt(static_cast<float>(x * x + y * y + z * z));
                        if (d >= radius) continue;
                        std::uint8_t& v = voxels[(static_cast<std::size_t>(pz) * size + py) * size + px];
                        if (v == 0) ++visible;
                        v = std::max(v, static_cast<std::uint8_t>(40 + 215 * (1.0f - d / radius)));
                    }
        }
    }
    return voxels;
}

std::vector<float> colourTable(double opacity)
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        for (const double c : {v, v * v, 1.0 - v, opacity * v})
            table.push_back(static_cast<float>(c));
    }
    return table;
}

/// A volume in n x n x n bricks and what drawUtility needs.
class UtilityVolume
{
public:
    UtilityVolume(const std::vector<std::uint8_t>& voxels, int size, int bricksPerSide, double opacity)
        : table_(colourTable(opacity))
    {
        const int step = (size - 1 + bricksPerSide - 1) / bricksPerSide;
        const int brick = bricksPerSide == 1 ? size : step + 1;
        volume_ = std::make_unique<voBrickSetCollection>(
            size, size, size, brick, brick, brick, voPartialBrickTypeScope::AUGMENT, 1,
            voInternalFormatTypeScope::DEFAULT, voExternalFormatTypeScope::LUMINANCE,
            voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
        voBrickSet* set = volume_->getCurrentBrickSet();
        voAppearanceActions::dataAlloc(set);
        voBrickSetIterator next(set);
        for (voBrick* b; (b = next());)
            fill(*b, voxels, size);
        voAppearanceActions::volumeOptimize(volume_.get(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
        const float s = static_cast<float>(size);
        vertices_ = {0, 0, 0, s, 0, 0, s, s, 0, 0, s, 0, 0, 0, s, s, 0, s, s, s, s, 0, s, s};
        indices_ = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
        tetras_ = std::make_unique<voIndexedTetraSet>(vertices_.data(), 8, 3, indices_.data(),
                                                      static_cast<int>(indices_.size()));
        cache_ = std::make_unique<voDrawActionCache>(tetras_.get(), volume_.get(), 4096,
                                                     voSamplingModeScope::VIEWPORT_ALIGNED, 3, 0);
        lookup_ = std::make_unique<voLookupTablePost>(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                                                      GLenum{voExternalFormatTypeScope::RGBA},
                                                      GLenum{voDataTypeScope::FLOAT}, table_.data());
        lookup_->load();
    }

    void draw(bool keepPolygons)
    {
        lookup_->enable();
        if (!keepPolygons) cache_->invalidate();
        float period[3] = {1, 1, 1};
        voGeometryActions::drawUtility(tetras_.get(), voInterleavedArrayTypeScope::V3F, volume_.get(),
                                       cache_.get(), voSamplingSpaceScope::OBJECT, period,
                                       voDecorationFlagsScope::NONE);
        if (voError::getErrorNumber() != voErrorTypeScope::NO_ERROR)
            throw std::runtime_error(voError::getErrorString());
        lookup_->disable();
    }

private:
    static void fill(voBrick& brick, const std::vector<std::uint8_t>& voxels, int size)
    {
        int x0, y0, z0, nx, ny, nz;
        brick.getBrickSizes(x0, y0, z0, nx, ny, nz);
        auto* target = static_cast<std::uint8_t*>(brick.getDataPtr());
        for (int z = z0; z < z0 + nz; ++z)
            for (int y = y0; y < y0 + ny; ++y)
                for (int x = x0; x < x0 + nx; ++x) {
                    const bool inside = x < size && y < size && z < size;
                    const std::size_t voxel = (static_cast<std::size_t>(z) * size + y) * size + x;
                    *target++ = inside ? voxels[voxel] : std::uint8_t{0};
                }
    }

    std::vector<float> table_;
    std::unique_ptr<voBrickSetCollection> volume_;
    std::vector<float> vertices_;
    std::vector<int> indices_;
    std::unique_ptr<voIndexedTetraSet> tetras_;
    std::unique_ptr<voDrawActionCache> cache_;
    std::unique_ptr<voLookupTablePost> lookup_;
};

constexpr const char* kBareVertex = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clipFromObject;
uniform float size;
out vec3 coordinate;
void main() { gl_Position = clipFromObject * vec4(position, 1.0); coordinate = position / size; }
)";

constexpr const char* kBareFragment = R"(#version 330 core
in vec3 coordinate;
uniform sampler3D voxels;
uniform sampler1D table;
layout(location = 0) out vec4 fragment;
void main()
{
    float v = texture(voxels, coordinate).r;
    fragment = texture(table, v * (255.0 / 256.0) + 0.5 / 256.0);
}
)";

/// The same planes as one convex polygon each.
class BareQuads
{
public:
    BareQuads(const vo::OffscreenContext& context, const std::vector<std::uint8_t>& voxels, int size,
              double opacity)
        : gl_(context.gl()), size_(size)
    {
        makeProgram();
        makeTextures(voxels, opacity);
        gl_.GenVertexArrays(1, &vertexArray_);
        gl_.GenBuffers(1, &buffer_);
    }

    void draw(const vo::test::View& view)
    {
        makeTriangles(view);
        const glm::dmat4 clip = glm::make_mat4(view.projection.data()) * glm::make_mat4(view.model.data());
        const glm::mat4 clipFromObject(clip);
        gl_.UseProgram(program_);
        gl_.UniformMatrix4fv(gl_.GetUniformLocation(program_, "clipFromObject"), 1, GL_FALSE,
                             &clipFromObject[0][0]);
        gl_.Uniform1f(gl_.GetUniformLocation(program_, "size"), static_cast<float>(size_));
        gl_.Uniform1i(gl_.GetUniformLocation(program_, "table"), 1);
        gl_.ActiveTexture(GL_TEXTURE1);
        gl_.BindTexture(GL_TEXTURE_1D, table_);
        gl_.ActiveTexture(GL_TEXTURE0);
        gl_.BindTexture(GL_TEXTURE_3D, voxels_);
        gl_.BindVertexArray(vertexArray_);
        gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
        gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles_.size() * sizeof(glm::vec3)),
                       triangles_.data(), GL_STREAM_DRAW);
        gl_.EnableVertexAttribArray(0);
        gl_.VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(triangles_.size()));
        gl_.BindVertexArray(0);
        gl_.UseProgram(0);
    }

private:
    void makeProgram()
    {
        program_ = gl_.CreateProgram();
        for (const auto& [stage, text] :
             {std::pair{GL_VERTEX_SHADER, kBareVertex}, std::pair{GL_FRAGMENT_SHADER, kBareFragment}}) {
            const GLuint shader = gl_.CreateShader(static_cast<GLenum>(stage));
            gl_.ShaderSource(shader, 1, &text, nullptr);
            gl_.CompileShader(shader);
            gl_.AttachShader(program_, shader);
        }
        gl_.LinkProgram(program_);
        GLint linked = GL_FALSE;
        gl_.GetProgramiv(program_, GL_LINK_STATUS, &linked);
        if (!linked) throw std::runtime_error("the bare program does not link");
    }

    void makeTextures(const std::vector<std::uint8_t>& voxels, double opacity)
    {
        gl_.GenTextures(1, &voxels_);
        gl_.BindTexture(GL_TEXTURE_3D, voxels_);
        gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
        gl_.TexImage3D(GL_TEXTURE_3D, 0, GL_R16, size_, size_, size_, 0, GL_RED, GL_UNSIGNED_BYTE,
                       voxels.data());
        gl_.GenTextures(1, &table_);
        gl_.BindTexture(GL_TEXTURE_1D, table_);
        gl_.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA32F, 256, 0, GL_RGBA, GL_FLOAT, colourTable(opacity).data());
        for (const GLenum target : {GL_TEXTURE_1D, GL_TEXTURE_3D}) {
            for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
                gl_.TexParameteri(target, name, GL_LINEAR);
            for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
                gl_.TexParameteri(target, name, GL_CLAMP_TO_EDGE);
            gl_.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, 0);
        }
    }

    /// Planes of docs/frames.md for the whole volume, cut to [1/2, size - 1/2], orthographic.
    void makeTriangles(const vo::test::View& view)
    {
        const glm::dmat4 model = glm::make_mat4(view.model.data());
        const glm::dvec3 towardsViewer(model[0][2], model[1][2], model[2][2]);
        const glm::dvec3 n = towardsViewer / std::sqrt(glm::dot(towardsViewer, towardsViewer));
        double low = 0.0, high = 0.0;
        for (int axis = 0; axis < 3; ++axis)
            (n[axis] < 0 ? low : high) += n[axis] * size_;
        const int count = std::max(1, static_cast<int>(std::ceil((high - low) * (1 - 1e-6))));
        const double spacing = (high - low) / count;
        triangles_.clear();
        for (int k = 0; k < count; ++k)
            appendSection(n, low + (k + 0.5) * spacing);
    }

    void appendSection(const glm::dvec3& n, double offset)
    {
        const double lower = 0.5, upper = size_ - 0.5;
        std::vector<glm::dvec3> corners;
        for (int axis = 0; axis < 3; ++axis)
            for (int end = 0; end < 4; ++end) {
                glm::dvec3 p(0.0);
                p[(axis + 1) % 3] = end & 1 ? upper : lower;
                p[(axis + 2) % 3] = end & 2 ? upper : lower;
                p[axis] = (offset - glm::dot(n, p)) / n[axis];
                if (p[axis] >= lower && p[axis] <= upper) corners.push_back(p);
            }
        if (corners.size() < 3) return;
        glm::dvec3 middle(0.0);
        for (const glm::dvec3& p : corners)
            middle += p / static_cast<double>(corners.size());
        const glm::dvec3 u = corners[0] - middle, v = glm::cross(n, u);
        std::sort(corners.begin(), corners.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
            return std::atan2(glm::dot(a - middle, v), glm::dot(a - middle, u)) <
                   std::atan2(glm::dot(b - middle, v), glm::dot(b - middle, u));
        });
        for (std::size_t i = 1; i + 1 < corners.size(); ++i)
            for (const std::size_t corner : {std::size_t{0}, i, i + 1})
                triangles_.emplace_back(corners[corner]);
    }

    const GladGLContext& gl_;
    int size_;
    GLuint program_ = 0, vertexArray_ = 0, buffer_ = 0, voxels_ = 0, table_ = 0;
    std::vector<glm::vec3> triangles_;
};

struct Case
{
    std::string name;
    std::function<void(int frame)> draw;
    std::vector<double> wall;
    std::vector<double> cpu;
    std::vector<float> picture;
    GLuint fragments = 0;
};

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double worstDifference(const std::vector<float>& a, const std::vector<float>& b)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        worst = std::max(worst, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
    return worst;
}

class DrawBench
{
public:
    DrawBench(const vo::OffscreenContext& context, std::string pattern)
        : context_(context), pattern_(std::move(pattern))
    {
    }

    void add(const std::string& name, const std::function<std::function<void(int)>()>& make)
    {
        if (name.find(pattern_) != std::string::npos) cases_.push_back({name, make(), {}, {}, {}, 0});
    }

    void run(int rounds)
    {
        for (Case& c : cases_) {
            const GladGLContext& gl = context_.gl();
            GLuint query = 0;
            gl.GenQueries(1, &query);
            gl.BeginQuery(GL_SAMPLES_PASSED, query);
            frame(c, 0);
            gl.EndQuery(GL_SAMPLES_PASSED);
            gl.GetQueryObjectuiv(query, GL_QUERY_RESULT, &c.fragments);
            gl.DeleteQueries(1, &query);
            c.picture = context_.readFloats();
        }
        for (int round = 1; round <= rounds; ++round)
            for (Case& c : cases_) {
                const double wall = seconds(CLOCK_MONOTONIC), cpu = seconds(CLOCK_PROCESS_CPUTIME_ID);
                frame(c, round);
                c.wall.push_back(seconds(CLOCK_MONOTONIC) - wall);
                c.cpu.push_back(seconds(CLOCK_PROCESS_CPUTIME_ID) - cpu);
            }
        for (const Case& c : cases_)
            std::printf("%-34s %8.2f ms wall %8.2f ms CPU   x%.3f   %5.2f M fragments   off %.2e\n",
                        c.name.c_str(), 1e3 * median(c.wall), 1e3 * median(c.cpu),
                        median(c.cpu) / median(cases_[0].cpu), 1e-6 * c.fragments,
                        worstDifference(c.picture, cases_[0].picture));
    }

private:
    void frame(const Case& c, int round)
    {
        const GladGLContext& gl = context_.gl();
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        c.draw(round);
        gl.Finish();
    }

    const vo::OffscreenContext& context_;
    std::string pattern_;
    std::vector<Case> cases_;
};

vo::test::View viewOf(int size)
{
    return vo::test::orthographicView({20, 30}, {size, size, size}, kPixels, kPixels);
}

} // namespace

int main(int argc, char** argv)
{
    const std::string pattern = argc > 1 ? argv[1] : "";
    const int rounds = argc > 2 ? std::max(1, std::atoi(argv[2])) : 9;
    const int size = argc > 3 ? std::max(8, std::atoi(argv[3])) : 256;
    vo::OffscreenRequest request;
    request.width = request.height = kPixels;
    request.floatColor = true;
    std::string whyNot;
    const auto context = vo::openOffscreen(request, &whyNot);
    if (!context) {
        std::fprintf(stderr, "draw_bench: no OpenGL context: %s\n", whyNot.c_str());
        return 1;
    }
    const GladGLContext& gl = context->gl();
    const vo::test::View view = viewOf(size);
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadMatrixd(view.projection.data());
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadMatrixd(view.model.data());
    gl.Disable(GL_DEPTH_TEST);
    gl.Enable(GL_BLEND);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    std::printf("%s, %d^3 bytes, %d x %d pixels; ratios of CPU time to the first case\n",
                context->description().c_str(), size, kPixels, kPixels);

    for (const bool sparse : {false, true}) {
        const std::vector<std::uint8_t> voxels = sparse ? sparseVolume(size) : denseVolume(size);
        const double opacity = sparse ? 0.05 : 4.0 / 255.0;
        const std::string name = sparse ? "sparse" : "dense";
        DrawBench bench(*context, pattern);
        bench.add(name + " bare", [&] {
            auto bare = std::make_shared<BareQuads>(*context, voxels, size, opacity);
            return [bare, view](int) { bare->draw(view); };
        });
        for (const int bricks : {1, 2, 4})
            for (const bool keep : {true, false})
                bench.add(name + " drawUtility " + std::to_string(bricks * bricks * bricks) +
                              (keep ? " kept" : " anew"),
                          [&] {
                              auto volume = std::make_shared<UtilityVolume>(voxels, size, bricks, opacity);
                              return [volume, keep](int) { volume->draw(keep); };
                          });
        bench.run(rounds);
    }
    return 0;
}
