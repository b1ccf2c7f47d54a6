#include "draw/draw_faces.h"

#include "draw/scoped_state.h"
#include "draw/shading.h"

#include <glm/gtc/type_ptr.hpp>

namespace vo {

namespace {

void useProgram(ContextRecord& context, const DrawState& state, const RecordLayout& layout)
{
    const GladGLContext& gl = context.gl;
    const ProgramVariant variant = variantFor(context, state, layout);
    const Program& program = programFor(context, variant);
    gl.UseProgram(program.name);
    const glm::mat4 clipFromObject(state.projection * state.model);
    const glm::mat4 eyeFromObject(state.model);
    gl.UniformMatrix4fv(program.clipFromObject, 1, GL_FALSE, glm::value_ptr(clipFromObject));
    gl.UniformMatrix4fv(program.eyeFromObject, 1, GL_FALSE, glm::value_ptr(eyeFromObject));
    gl.UniformMatrix4fv(program.textureMatrix, 1, GL_FALSE, glm::value_ptr(state.textureMatrix));
    gl.Uniform4fv(program.currentColor, 1, glm::value_ptr(state.color));
    gl.Uniform4fv(program.texgenPlanes, 3, glm::value_ptr(state.texgenPlanes[0]));
    if (state.clipPlaneCount > 0)
        gl.Uniform4fv(program.clipPlanes, state.clipPlaneCount, glm::value_ptr(state.clipPlanes[0]));
    gl.Uniform4fv(program.viewer, 1, glm::value_ptr(state.viewer));
    gl.UniformMatrix3fv(program.sampleGauge, 1, GL_FALSE, glm::value_ptr(state.sampleGauge));
    gl.Uniform1i(program.voxels, state.voxelUnit);
    gl.Uniform1i(program.table, state.tableUnit);
    if (variant.lookup != Lookup::none) bindTable(context, state);
}

void pointAt(const GladGLContext& gl, GLuint attribute, int offset, int channels, int valuesPerVertex)
{
    if (offset < 0) {
        gl.DisableVertexAttribArray(attribute);
        return;
    }
    gl.EnableVertexAttribArray(attribute);
    gl.VertexAttribPointer(attribute, channels, GL_FLOAT, GL_FALSE,
                           static_cast<GLsizei>(static_cast<std::size_t>(valuesPerVertex) * sizeof(float)),
                           reinterpret_cast<const void*>(static_cast<std::size_t>(offset) * sizeof(float)));
}

/// Binds the context's own vertex array and buffers and fills them, in new storage, unless they hold what has
/// this serial; 0 is nobody's.
void sendVertices(ContextRecord& context, const RecordLayout& layout, std::span<const float> records,
                  std::span<const std::uint32_t> indices, std::uint64_t serial)
{
    const GladGLContext& gl = context.gl;
    if (context.vertexArray == 0) {
        gl.GenVertexArrays(1, &context.vertexArray);
        gl.GenBuffers(1, &context.vertexBuffer);
        gl.GenBuffers(1, &context.indexBuffer);
    }
    gl.BindVertexArray(context.vertexArray);
    gl.BindBuffer(GL_ARRAY_BUFFER, context.vertexBuffer);
    const bool held = serial != 0 && context.sentVertices == serial;
    context.sentVertices = serial;
    if (!held)
        gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(records.size_bytes()), records.data(),
                      GL_STREAM_DRAW);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, context.indexBuffer);
    if (!held)
        gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size_bytes()), indices.data(),
                      GL_STREAM_DRAW);
    pointAt(gl, kPosition, layout.position(), 3, layout.values);
    pointAt(gl, kColor, layout.color, layout.colorChannels, layout.values);
    pointAt(gl, kTexCoord, layout.texCoord, 3, layout.values);
}

void appendFan(std::span<const int> polygon, std::vector<std::uint32_t>& indices)
{
    // The first vertex comes last: that is the one that flat shading takes, and a polygon's colour is its
    // first's.
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        for (const int vertex : {polygon[i], polygon[i + 1], polygon[0]})
            indices.push_back(static_cast<std::uint32_t>(vertex));
}

void appendEdges(std::span<const int> polygon, std::vector<std::uint32_t>& indices)
{
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        indices.push_back(static_cast<std::uint32_t>(polygon[i]));
        indices.push_back(static_cast<std::uint32_t>(polygon[(i + 1) % polygon.size()]));
    }
}

GLenum indexPrimitives(std::span<const int> polygons, GLenum mode, std::vector<std::uint32_t>& indices)
{
    indices.clear();
    for (std::size_t i = 0; i < polygons.size();) {
        const auto count = static_cast<std::size_t>(polygons[i]);
        const std::span<const int> polygon = polygons.subspan(i + 1, count);
        i += count + 1;
        if (mode == GL_LINE)
            appendEdges(polygon, indices);
        else if (mode == GL_POINT)
            indices.insert(indices.end(), polygon.begin(), polygon.end());
        else
            appendFan(polygon, indices);
    }
    return mode == GL_LINE ? GL_LINES : mode == GL_POINT ? GL_POINTS : GL_TRIANGLES;
}

} // namespace

void drawFaces(ContextRecord& context, const DrawState& state, const RecordLayout& layout,
               std::span<const float> records, std::span<const int> polygons, GLenum mode)
{
    if (polygons.empty()) return;
    thread_local std::vector<std::uint32_t> indices;
    const GLenum primitive = indexPrimitives(polygons, mode, indices);
    const ScopedDrawState scope(context.gl, state.voxelUnit, state.tableUnit);
    context.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(state.voxelUnit));
    useProgram(context, state, layout);
    sendVertices(context, layout, records, indices, 0);
    context.gl.DrawElements(primitive, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
}

void drawSegments(ContextRecord& context, const DrawState& state, std::span<const float> positions)
{
    thread_local std::vector<std::uint32_t> indices;
    indices.resize(positions.size() / 3);
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = static_cast<std::uint32_t>(i);
    DrawState plain = state;
    plain.texturing = Texturing::none;
    const ScopedDrawState scope(context.gl, state.voxelUnit, state.tableUnit);
    useProgram(context, plain, RecordLayout{});
    sendVertices(context, RecordLayout{}, positions, indices, 0);
    context.gl.DrawElements(GL_LINES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
}

struct FaceStream::Private
{
    ContextRecord& context;
    RecordLayout layout;
    ScopedDrawState scope;
};

FaceStream::FaceStream(ContextRecord& context, const DrawState& state, const RecordLayout& layout,
                       std::span<const float> records, std::span<const std::uint32_t> indices,
                       std::uint64_t serial)
    : d(new Private{context, layout, ScopedDrawState(context.gl, state.voxelUnit, state.tableUnit)})
{
    context.gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(state.voxelUnit));
    sendVertices(context, layout, records, indices, serial);
}

FaceStream::~FaceStream() = default;

void FaceStream::draw(const DrawState& state, std::size_t first, std::size_t count)
{
    if (count == 0) return;
    useProgram(d->context, state, d->layout);
    d->context.gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                               reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

} // namespace vo
