#include "tag_stencil.h"

#include "matrices.h"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

const char* const kVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
uniform mat4 clipFromObject;
uniform vec3 origin;
out vec3 voxel;

void main()
{
    gl_Position = clipFromObject * vec4(position, 1.0);
    voxel = position - origin;
}
)";

// A brick of 2D textures has one voxel along one axis, which its texture does not have.
const char* const kFragmentShader = R"(
in vec3 voxel;
uniform ivec3 size;
uniform int tag;
out vec4 fragment;
#ifdef FLAT
uniform sampler2D tags;

vec4 fetch(ivec3 at)
{
    if (size.z == 1) return texelFetch(tags, at.xy, 0);
    return texelFetch(tags, size.y == 1 ? at.xz : at.yz, 0);
}
#else
uniform sampler3D tags;

vec4 fetch(ivec3 at)
{
    return texelFetch(tags, at, 0);
}
#endif

void main()
{
    ivec3 nearest = clamp(ivec3(floor(voxel)), ivec3(0), size - 1);
    if (int(fetch(nearest).r * 255.0 + 0.5) != tag) discard;
    fragment = vec4(1.0);
}
)";

void attach(GLuint program, GLenum stage, const std::string& text)
{
    const GLuint shader = gl->CreateShader(stage);
    const char* source = text.c_str();
    gl->ShaderSource(shader, 1, &source, nullptr);
    gl->CompileShader(shader);
    gl->AttachShader(program, shader);
    gl->DeleteShader(shader); // goes with the program
}

// As the library does it: the product in double precision, so that both draw the same pixels.
void sendMatrix(GLint location)
{
    GLdouble model[16], projection[16];
    GLfloat product[16];
    vo::getMatrices(model, projection);
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += projection[4 * k + row] * model[4 * column + k];
            product[4 * column + row] = float(sum);
        }
    }
    gl->UniformMatrix4fv(location, 1, GL_FALSE, product);
}

std::vector<GLuint> triangles(voIndexedFaceSet* faces)
{
    std::vector<GLuint> corners;
    voIndices& indices = *faces->getIndices();
    for (int i = 0; i < indices.getCount(); i += indices[i] + 1) {
        for (int corner = 2; corner < indices[i]; ++corner)
            for (const int index : {indices[i + 1], indices[i + corner], indices[i + corner + 1]})
                corners.push_back(GLuint(index));
    }
    return corners;
}

} // namespace

TagStencil::TagStencil(bool twoDimensional) : twoDimensional_(twoDimensional), program_(gl->CreateProgram())
{
    attach(program_, GL_VERTEX_SHADER, kVertexShader);
    attach(program_, GL_FRAGMENT_SHADER,
           std::string("#version 330 core\n") + (twoDimensional ? "#define FLAT\n" : "") + kFragmentShader);
    gl->LinkProgram(program_);
    GLint linked = GL_FALSE;
    gl->GetProgramiv(program_, GL_LINK_STATUS, &linked);
    if (!linked) {
        std::fprintf(stderr, "voglTagged: the driver does not link the program that tests tags\n");
        std::exit(1);
    }
    gl->GenVertexArrays(1, &vertexArray_);
    gl->GenBuffers(1, &vertexBuffer_);
    gl->GenBuffers(1, &indexBuffer_);
}

TagStencil::~TagStencil()
{
    gl->DeleteProgram(program_);
    gl->DeleteVertexArrays(1, &vertexArray_);
    gl->DeleteBuffers(1, &vertexBuffer_);
    gl->DeleteBuffers(1, &indexBuffer_);
}

void TagStencil::draw(voIndexedFaceSet* faces, voBrick* tags, int tag)
{
    const std::vector<GLuint> corners = triangles(faces);
    if (corners.empty()) return;
    int origin[3], size[3];
    tags->getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
    gl->UseProgram(program_);
    const auto location = [this](const char* name) { return gl->GetUniformLocation(program_, name); };
    sendMatrix(location("clipFromObject"));
    gl->Uniform3f(location("origin"), float(origin[0]), float(origin[1]), float(origin[2]));
    gl->Uniform3i(location("size"), size[0], size[1], size[2]);
    gl->Uniform1i(location("tag"), tag);
    gl->Uniform1i(location("tags"), 0);

    voVertexData& vertices = *faces->getVertexData();
    GLuint first = corners[0], last = corners[0];
    for (const GLuint corner : corners) {
        first = std::min(first, corner);
        last = std::max(last, corner);
    }
    gl->BindVertexArray(vertexArray_);
    gl->BindBuffer(GL_ARRAY_BUFFER, vertexBuffer_);
    gl->BufferData(GL_ARRAY_BUFFER, GLsizeiptr((last + 1 - first) * 3 * sizeof(float)), vertices[int(first)],
                   GL_STREAM_DRAW);
    gl->VertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    gl->EnableVertexAttribArray(0);
    gl->BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indexBuffer_);
    gl->BufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(corners.size() * sizeof(GLuint)), corners.data(),
                   GL_STREAM_DRAW);
    gl->DrawElementsBaseVertex(GL_TRIANGLES, GLsizei(corners.size()), GL_UNSIGNED_INT, nullptr,
                               -GLint(first));
    gl->BindVertexArray(0);
    gl->BindBuffer(GL_ARRAY_BUFFER, 0);
    gl->UseProgram(0);
}
