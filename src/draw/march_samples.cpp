#include "draw/march_samples.h"

#include "draw/programs.h"
#include "draw/scoped_state.h"
#include "draw/shading.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <vector>

namespace vo {

namespace {

/// The faces of a box, the ends of the view volume, and clip planes.
constexpr std::size_t kMostBounds = 20;

constexpr const char* kVertexShader = R"(
uniform vec4 rectangle; // left, bottom, right, top in normalised device coordinates
void main()
{
    gl_Position = vec4(rectangle[(gl_VertexID & 1) * 2], rectangle[(gl_VertexID & 2) + 1], 0.0, 1.0);
}
)";

// Samples are counted from the nearest. Numbers of a pixel are ramps: at the middle of the viewport, and
// their change to the right and up.
//
// Software runs some neighbouring pixels as one: those that look for the next sample wait for those that take
// some. So several are taken before it is asked again.
constexpr const char* kFragmentShader = R"(
uniform vec2 middle;
uniform float last;
uniform vec3 textureBase[3], textureStep[3];
uniform vec3 sampleBase[3], sampleStep[3];
uniform vec3 bounds[2 * MOST_BOUNDS]; // base and step of each; lower faces of the box, upper ones, others
uniform int boundCount;
uniform bvec3 upperBelongsElsewhere;
uniform vec4 currentColor;
uniform float cellSide;
uniform vec3 cellCount;
uniform sampler3D cells;
uniform int alphaFrom; // as in alphaSource()
#ifdef OPACITY_PER_LENGTH
uniform mat3 sampleGauge;
#endif
layout(location = 0, index = 0) out vec4 front;
layout(location = 0, index = 1) out vec4 behind;

const float kSnapDistance = 1e-5;
const float kLeastTransmittance = 1.0 / 65536.0;
const float kSamplesAtOnce = 6.0;

vec3 atPixel(vec3 ramps[3], vec3 pixel)
{
    return vec3(dot(ramps[0], pixel), dot(ramps[1], pixel), dot(ramps[2], pixel));
}

vec3 withoutZero(vec3 steps)
{
    return mix(steps, vec3(1e-20), lessThan(abs(steps), vec3(1e-20)));
}

// The samples that lie within all bounds: first and last.
vec2 keptSamples(vec3 pixel)
{
    vec2 kept = vec2(0.0, last);
    for (int i = 0; i < boundCount; ++i) {
        float base = dot(bounds[2 * i], pixel), by = dot(bounds[2 * i + 1], pixel);
        if (by == 0.0) by = 1e-20;
        bool open = i >= 3 && i < 6 && upperBelongsElsewhere[i - 3];
        float slack = i >= 6 ? 0.0 : open ? -kSnapDistance : kSnapDistance;
        float end = (slack - base) / by;
        if (by > 0.0)
            kept.y = min(kept.y, open ? ceil(end) - 1.0 : floor(end));
        else
            kept.x = max(kept.x, open ? floor(end) + 1.0 : ceil(end));
    }
    return kept;
}

void main()
{
    vec3 pixel = vec3(1.0, gl_FragCoord.xy - middle);
    vec2 kept = keptSamples(pixel);
    vec3 place = atPixel(textureBase, pixel), placeStep = atPixel(textureStep, pixel);
    vec3 base = atPixel(sampleBase, pixel) / cellSide;
    vec3 step = withoutZero(atPixel(sampleStep, pixel) / cellSide);
    vec3 perCell = 1.0 / step;
    vec3 way = sign(step), ahead = max(way, 0.0);
    vec3 perVolume = 1.0 / cellCount;
#ifdef OPACITY_PER_LENGTH
    float units = length(step) / length(sampleGauge * step);
#endif
    vec3 color = vec3(0.0);
    float alpha = 0.0, through = 1.0;
    float at = kept.x;
    while (at <= kept.y && through > kLeastTransmittance) {
        while (at <= kept.y) {
            vec3 cell = base + at * step;
            float empty = floor(textureLod(cells, cell * perVolume, 0.0).r * 255.0 + 0.5);
            if (empty < 0.5) break;
            vec3 wall = floor(cell) + ahead + way * (empty - 1.0);
            vec3 ends = (wall - base) * perCell;
            at = max(at + 1.0, ceil(min(ends.x, min(ends.y, ends.z))));
        }
        float until = min(at + kSamplesAtOnce - 1.0, kept.y);
        while (at <= until) {
            vec4 fragment = shade(textureLod(voxels, place + at * placeStep, 0.0), currentColor);
#ifdef OPACITY_PER_LENGTH
            fragment.a = 1.0 - pow(1.0 - clamp(fragment.a, 0.0, 1.0), units);
#endif
            float weight = through * fragment.a;
            color += weight * fragment.rgb;
            alpha += weight * fragment.a;
#ifdef HIDES_BEHIND
            through -= weight;
#endif
            at += 1.0;
        }
    }
    front = vec4(color, alphaFrom < 2 ? alpha : alphaFrom == 2 ? 1.0 - through : 0.0);
    behind = vec4(vec3(through), alphaFrom == 3 ? 1.0 : through);
}
)";

MarchProgram link(const GladGLContext& gl, const ProgramVariant& variant, bool hides)
{
    const std::string definitions = programDefinitions(variant) + (hides ? "#define HIDES_BEHIND\n" : "") +
                                    "#define MOST_BOUNDS " + std::to_string(kMostBounds) + "\n";
    MarchProgram program;
    program.name = linkProgram(gl, definitions + kVertexShader, definitions + kShading + kFragmentShader);
    const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name, name); };
    program.rectangle = find("rectangle");
    program.middle = find("middle");
    program.last = find("last");
    program.textureBase = find("textureBase");
    program.textureStep = find("textureStep");
    program.sampleBase = find("sampleBase");
    program.sampleStep = find("sampleStep");
    program.bounds = find("bounds");
    program.boundCount = find("boundCount");
    program.upperBelongsElsewhere = find("upperBelongsElsewhere");
    program.currentColor = find("currentColor");
    program.sampleGauge = find("sampleGauge");
    program.cellSide = find("cellSide");
    program.cellCount = find("cellCount");
    program.alphaFrom = find("alphaFrom");
    program.voxels = find("voxels");
    program.table = find("table");
    program.cells = find("cells");
    return program;
}

const MarchProgram& marchProgram(ContextRecord& context, const ProgramVariant& variant, bool hides)
{
    const unsigned key = variant.key() << 1 | static_cast<unsigned>(hides);
    const auto found = context.marchPrograms.find(key);
    if (found != context.marchPrograms.end()) return found->second;
    return context.marchPrograms.emplace(key, link(context.gl, variant, hides)).first->second;
}

/// A third texture unit, with the distances between cells; the caller's binding is given back.
class ScopedCellTexture
{
public:
    ScopedCellTexture(ContextRecord& context, int unit, const CellDistances& cells)
        : gl_(context.gl), unit_(static_cast<GLuint>(unit))
    {
        gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &active_);
        gl_.ActiveTexture(GL_TEXTURE0 + unit_);
        gl_.GetIntegerv(GL_TEXTURE_BINDING_3D, &texture_);
        gl_.GetIntegerv(GL_SAMPLER_BINDING, &sampler_);
        gl_.BindSampler(unit_, 0);
        if (context.cellTexture == 0) gl_.GenTextures(1, &context.cellTexture);
        gl_.BindTexture(GL_TEXTURE_3D, context.cellTexture);
        if (context.cellTextureSerial != cells.serial) send(context, cells);
        gl_.ActiveTexture(static_cast<GLenum>(active_));
    }
    ~ScopedCellTexture()
    {
        GLint active = GL_TEXTURE0;
        gl_.GetIntegerv(GL_ACTIVE_TEXTURE, &active);
        gl_.ActiveTexture(GL_TEXTURE0 + unit_);
        gl_.BindTexture(GL_TEXTURE_3D, static_cast<GLuint>(texture_));
        gl_.BindSampler(unit_, static_cast<GLuint>(sampler_));
        gl_.ActiveTexture(static_cast<GLenum>(active));
    }
    ScopedCellTexture(const ScopedCellTexture&) = delete;
    ScopedCellTexture& operator=(const ScopedCellTexture&) = delete;

private:
    void send(ContextRecord& context, const CellDistances& cells) const
    {
        const ScopedUploadState scope(gl_, context.core);
        gl_.TexImage3D(GL_TEXTURE_3D, 0, GL_R8, cells.count.x, cells.count.y, cells.count.z, 0, GL_RED,
                       GL_UNSIGNED_BYTE, cells.distance.data());
        for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            gl_.TexParameteri(GL_TEXTURE_3D, name, GL_NEAREST);
        for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
            gl_.TexParameteri(GL_TEXTURE_3D, name, GL_CLAMP_TO_EDGE);
        gl_.TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
        context.cellTextureSerial = cells.serial;
    }

    const GladGLContext& gl_;
    GLuint unit_;
    GLint active_ = GL_TEXTURE0;
    GLint texture_ = 0;
    GLint sampler_ = 0;
};

/// A ramp over pixels, as one from the middle of the viewport.
glm::vec3 fromMiddle(const PixelRamp& ramp, const GLint viewport[4])
{
    return {ramp(0.5 * viewport[2] - 0.5, 0.5 * viewport[3] - 0.5), ramp.dx, ramp.dy};
}

using Ramps = std::array<PixelRamp, 3>;

void setRamps(const GladGLContext& gl, GLint location, const Ramps& ramps, const GLint viewport[4])
{
    std::array<glm::vec3, 3> values;
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = fromMiddle(ramps[i], viewport);
    gl.Uniform3fv(location, 3, glm::value_ptr(values[0]));
}

/// Neither that of the voxels nor that of the table, which is the next.
int cellUnit(const ContextRecord& context, const DrawState& draw)
{
    GLint units = 3;
    context.gl.GetIntegerv(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS, &units);
    return (draw.tableUnit + 1) % units;
}

} // namespace

struct SampleMarch::Private
{
    ContextRecord& context;
    const CompositingState& state;
    const SampleRamps& ramps;
    const CellDistances& cells;
    int cellUnit;
    ScopedDrawState drawScope;
    ScopedCellTexture cellScope;
    ScopedUnclipped clipping;
    ScopedJoinedBlending blending;

    void setBounds(const MarchProgram& program, const MarchedBrick& brick) const
    {
        std::vector<glm::vec3> values;
        const auto append = [&](const SampleBound& bound) {
            values.push_back(fromMiddle(bound.base, state.viewport));
            values.push_back(fromMiddle(bound.step, state.viewport));
        };
        std::ranges::for_each(boxBounds(ramps, brick.box), append);
        std::ranges::for_each(ramps.bounds, append);
        const GladGLContext& gl = context.gl;
        gl.Uniform3fv(program.bounds, static_cast<GLsizei>(values.size()), glm::value_ptr(values[0]));
        gl.Uniform1i(program.boundCount, static_cast<GLint>(values.size() / 2));
        const auto& upper = brick.upperBelongsElsewhere;
        gl.Uniform3i(program.upperBelongsElsewhere, upper[0], upper[1], upper[2]);
        gl.Uniform1f(program.last, static_cast<float>(ramps.count - 1));
    }

    void setPlaces(const MarchProgram& program, const MarchedBrick& brick) const
    {
        const GladGLContext& gl = context.gl;
        Ramps base, step;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto axis = static_cast<int>(i);
            base[i] = (1.0 / brick.size[axis]) * ramps.base[i];
            base[i].at -= brick.origin[axis] / brick.size[axis];
            step[i] = (1.0 / brick.size[axis]) * ramps.step[i];
        }
        setRamps(gl, program.textureBase, base, state.viewport);
        setRamps(gl, program.textureStep, step, state.viewport);
        setRamps(gl, program.sampleBase, ramps.base, state.viewport);
        setRamps(gl, program.sampleStep, ramps.step, state.viewport);
        gl.Uniform2f(program.middle, static_cast<float>(state.viewport[0] + 0.5 * state.viewport[2]),
                     static_cast<float>(state.viewport[1] + 0.5 * state.viewport[3]));
    }

    void setShading(const MarchProgram& program, const DrawState& draw) const
    {
        const GladGLContext& gl = context.gl;
        gl.Uniform4fv(program.currentColor, 1, glm::value_ptr(draw.color));
        gl.UniformMatrix3fv(program.sampleGauge, 1, GL_FALSE, glm::value_ptr(draw.sampleGauge));
        gl.Uniform1f(program.cellSide, static_cast<float>(cells.side));
        gl.Uniform3f(program.cellCount, static_cast<float>(cells.count.x), static_cast<float>(cells.count.y),
                     static_cast<float>(cells.count.z));
        gl.Uniform1i(program.alphaFrom, alphaSource(state.blending));
        gl.Uniform1i(program.voxels, draw.voxelUnit);
        gl.Uniform1i(program.table, draw.tableUnit);
        gl.Uniform1i(program.cells, cellUnit);
    }
};

bool SampleMarch::canBound(const SampleRamps& ramps)
{
    return ramps.bounds.size() + 6 <= kMostBounds;
}

SampleMarch::SampleMarch(ContextRecord& context, const DrawState& draw, const CompositingState& state,
                         const SampleRamps& ramps, const CellDistances& cells)
    : d(new Private{context, state, ramps, cells, cellUnit(context, draw),
                    ScopedDrawState(context.gl, draw.voxelUnit, draw.tableUnit),
                    ScopedCellTexture(context, cellUnit(context, draw), cells), ScopedUnclipped(context.gl),
                    ScopedJoinedBlending(context.gl, state.blending)})
{
    const GladGLContext& gl = context.gl;
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(draw.voxelUnit));
    if (context.pictureVertexArray == 0) gl.GenVertexArrays(1, &context.pictureVertexArray);
    gl.BindVertexArray(context.pictureVertexArray);
}

SampleMarch::~SampleMarch() = default;

void SampleMarch::draw(const DrawState& draw, const MarchedBrick& brick, const PixelRectangle& pixels)
{
    if (pixels.empty() || d->ramps.count == 0) return;
    ProgramVariant variant = variantFor(d->context, draw, RecordLayout{});
    variant.texgen = variant.flat = false;
    variant.clipDistances = 0;
    const MarchProgram& program = marchProgram(d->context, variant, hidesBehind(d->state.blending.color));
    const GladGLContext& gl = d->context.gl;
    gl.UseProgram(program.name);
    d->setBounds(program, brick);
    d->setPlaces(program, brick);
    d->setShading(program, draw);
    const auto inDevice = [](int pixel, int size) {
        return static_cast<float>(2.0 * pixel / static_cast<double>(size) - 1.0);
    };
    const GLint width = d->state.viewport[2], height = d->state.viewport[3];
    gl.Uniform4f(program.rectangle, inDevice(pixels.left, width), inDevice(pixels.bottom, height),
                 inDevice(pixels.right, width), inDevice(pixels.top, height));
    if (variant.lookup != Lookup::none) bindTable(d->context, draw);
    gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

} // namespace vo
