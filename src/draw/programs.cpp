#include "draw/programs.h"

#include "core/log.h"

#include <string>

namespace vo {

// What becomes of a sample: the table, then the texture environment. The table is fetched and mixed here:
// linear filtering of textures has 8 bits of weight on some hardware. Where it is as exact as floats are, the
// driver's filter takes half the time.
const char* const kShading = R"(
#ifdef TEXTURED
uniform SAMPLER voxels;
#ifdef LOOKUP
uniform sampler1D table;
#ifdef LOOKUP_FILTERED
vec4 lookup(vec4 sampled)
{
    float size = float(textureSize(table, 0));
    vec4 place = sampled * ((size - 1.0) / size) + 0.5 / size;
#ifdef LOOKUP_BY_RED
    return textureLod(table, place.r, 0.0);
#else
    return vec4(textureLod(table, place.r, 0.0).r, textureLod(table, place.g, 0.0).g,
                textureLod(table, place.b, 0.0).b, textureLod(table, place.a, 0.0).a);
#endif
}
#else
vec4 lookup(vec4 sampled)
{
    int last = textureSize(table, 0) - 1;
    vec4 entry = clamp(sampled, 0.0, 1.0) * float(last);
    ivec4 low = ivec4(entry);
    ivec4 high = min(low + 1, last);
    vec4 weight = entry - vec4(low);
#ifdef LOOKUP_BY_RED
    return mix(texelFetch(table, low.r, 0), texelFetch(table, high.r, 0), weight.r);
#else
    vec4 below = vec4(texelFetch(table, low.r, 0).r, texelFetch(table, low.g, 0).g,
                      texelFetch(table, low.b, 0).b, texelFetch(table, low.a, 0).a);
    vec4 above = vec4(texelFetch(table, high.r, 0).r, texelFetch(table, high.g, 0).g,
                      texelFetch(table, high.b, 0).b, texelFetch(table, high.a, 0).a);
    return mix(below, above, weight);
#endif
}
#endif
#endif

vec4 shade(vec4 sampled, vec4 color)
{
#ifdef LOOKUP
    sampled = lookup(sampled);
#endif
#if ENVIRONMENT == 0
    return color * sampled;
#elif ENVIRONMENT == 1
    return sampled;
#else
    return vec4(sampled.rgb, color.a);
#endif
}
#endif
)";

namespace {

// One text for both profiles, so that both give the same bytes; gl_ClipDistance works in both, with the
// planes that glClipPlane left in eye space.
constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 position;
#ifdef VERTEX_COLOR
layout(location = 1) in vec4 vertexColor;
#endif
layout(location = 2) in vec3 vertexTexCoord;
uniform mat4 clipFromObject;
uniform mat4 eyeFromObject;
uniform mat4 textureMatrix;
uniform vec4 currentColor;
uniform vec4 texgenPlanes[3];
#if CLIP_DISTANCES > 0
uniform vec4 clipPlanes[CLIP_DISTANCES];
out float gl_ClipDistance[CLIP_DISTANCES];
#endif
INTERPOLATION out vec4 color;
#ifdef OPACITY_PER_LENGTH
uniform vec4 viewer;
out vec3 sight;
#endif
#ifdef TEXTURED
out vec4 texCoord;
#endif

void main()
{
    vec4 object = vec4(position, 1.0);
    gl_Position = clipFromObject * object;
#ifdef VERTEX_COLOR
    color = vertexColor;
#else
    color = currentColor;
#endif
#ifdef OPACITY_PER_LENGTH
    sight = viewer.w > 0.0 ? position - viewer.xyz : viewer.xyz;
#endif
#ifdef TEXTURED
#ifdef TEXGEN
    vec4 coordinate = vec4(dot(texgenPlanes[0], object), dot(texgenPlanes[1], object), dot(texgenPlanes[2], object), 1.0);
#else
    vec4 coordinate = vec4(vertexTexCoord, 1.0);
#endif
    texCoord = textureMatrix * coordinate;
#endif
#if CLIP_DISTANCES > 0
    vec4 eye = eyeFromObject * object;
    for (int i = 0; i < CLIP_DISTANCES; ++i)
        gl_ClipDistance[i] = dot(clipPlanes[i], eye);
#endif
}
)";

constexpr const char* kFragmentShader = R"(
INTERPOLATION in vec4 color;
#ifdef OPACITY_PER_LENGTH
in vec3 sight;
uniform mat3 sampleGauge;
#endif
#ifdef TEXTURED
in vec4 texCoord;
#endif
layout(location = 0) out vec4 fragment;

void main()
{
    fragment = color;
#ifdef TEXTURED
#ifdef PROJECTIVE
    fragment = shade(texture(voxels, texCoord.COORDINATES / texCoord.q), color);
#else
    fragment = shade(texture(voxels, texCoord.COORDINATES), color);
#endif
#endif
#ifdef OPACITY_PER_LENGTH
    float units = length(sight) / length(sampleGauge * sight);
    fragment.a = 1.0 - pow(1.0 - clamp(fragment.a, 0.0, 1.0), units);
#endif
}
)";

Program link(const GladGLContext& gl, const ProgramVariant& variant)
{
    const std::string definitions = programDefinitions(variant);
    Program program;
    program.name = linkProgram(gl, definitions + kVertexShader, definitions + kShading + kFragmentShader);
    const auto find = [&](const char* name) { return gl.GetUniformLocation(program.name, name); };
    program.clipFromObject = find("clipFromObject");
    program.eyeFromObject = find("eyeFromObject");
    program.textureMatrix = find("textureMatrix");
    program.currentColor = find("currentColor");
    program.texgenPlanes = find("texgenPlanes");
    program.clipPlanes = find("clipPlanes");
    program.viewer = find("viewer");
    program.sampleGauge = find("sampleGauge");
    program.voxels = find("voxels");
    program.table = find("table");
    return program;
}

} // namespace

std::string programDefinitions(const ProgramVariant& v)
{
    std::string text = "#version 330 core\n";
    const auto define = [&text](const std::string& what) { text += "#define " + what + "\n"; };
    if (v.texturing != Texturing::none) {
        define("TEXTURED");
        define(v.texturing == Texturing::threeDimensional ? "SAMPLER sampler3D" : "SAMPLER sampler2D");
        define(v.texturing == Texturing::threeDimensional ? "COORDINATES stp" : "COORDINATES st");
        if (v.texgen) define("TEXGEN");
        if (v.projectiveTexture) define("PROJECTIVE");
        define("ENVIRONMENT " + std::to_string(static_cast<int>(v.environment)));
        if (v.lookup != Lookup::none) define("LOOKUP");
        if (v.lookup == Lookup::byRed) define("LOOKUP_BY_RED");
        if (v.filteredLookup) define("LOOKUP_FILTERED");
    }
    if (v.vertexColor) define("VERTEX_COLOR");
    if (v.opacityPerLength) define("OPACITY_PER_LENGTH");
    define(v.flat ? "INTERPOLATION flat" : "INTERPOLATION");
    define("CLIP_DISTANCES " + std::to_string(v.clipDistances));
    return text;
}

unsigned ProgramVariant::key() const
{
    return static_cast<unsigned>(texturing) | static_cast<unsigned>(texgen) << 2 |
           static_cast<unsigned>(projectiveTexture) << 3 | static_cast<unsigned>(vertexColor) << 4 |
           static_cast<unsigned>(flat) << 5 | static_cast<unsigned>(environment) << 6 |
           static_cast<unsigned>(lookup) << 8 | static_cast<unsigned>(clipDistances) << 10 |
           static_cast<unsigned>(opacityPerLength) << 14 | static_cast<unsigned>(filteredLookup) << 15;
}

const Program& programFor(ContextRecord& context, const ProgramVariant& variant)
{
    const auto found = context.programs.find(variant.key());
    if (found != context.programs.end()) return found->second;
    debug(2, "compiling a program for drawing");
    return context.programs.emplace(variant.key(), link(context.gl, variant)).first->second;
}

} // namespace vo
