#include "draw/volume_programs.h"

#include "draw/scene_programs.h"
#include "style/surface_normals.h"

#include <algorithm>
#include <array>

namespace vo {

namespace {

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 voxel;
uniform mat4 clipFromVoxel;
uniform vec3 voxelCount, dimensions;
out vec3 position;
out vec3 place;
#ifdef OWN_PLACES
layout(location = 1) in vec3 placeGiven;
layout(location = 2) in mat3 placeFromLocalGiven;
out mat3 placeFromLocal;
#endif

void main()
{
    gl_Position = clipFromVoxel * vec4(voxel, 1.0);
    position = (voxel / voxelCount - 0.5) * dimensions;
#ifdef OWN_PLACES
    place = placeGiven;
    placeFromLocal = placeFromLocalGiven;
#else
    place = voxel / voxelCount;
#endif
}
)";

// What styles may use (style/glsl_chain.h), beside the lights.
constexpr const char* kStylePreamble = R"(
struct StyleSample {
    vec4 voxel;
    vec3 place, position, V, n;
    float gradient;
};
vec4 styleTexture(sampler3D map, vec3 place)
{
    return textureLod(map, place, 0.0);
}
)";

constexpr const char* kSampleFunctions = R"(
#ifndef WHOLE_RAYS
in vec3 position;
in vec3 place;
#endif
uniform sampler3D voxels;
uniform vec3 voxelCount, dimensions;
uniform vec4 viewer, depthRow;
uniform float spacing, unitLength, shortestEdge;
layout(location = 0) out vec4 fragment;
#ifdef OWN_PLACES
in mat3 placeFromLocal;
#else
mat3 placeFromLocal = mat3(1.0 / dimensions.x, 0.0, 0.0, 0.0, 1.0 / dimensions.y, 0.0, 0.0, 0.0, 1.0 / dimensions.z);
#endif

float valueAt(vec3 at)
{
    vec4 voxel = textureLod(voxels, at, 0.0);
#if COMPONENTS < 3
    return voxel.r;
#else
    return (voxel.r + voxel.g + voxel.b) / 3.0;
#endif
}

// The change of the value over the shortest edge of a voxel, local.
vec3 slopeAt(vec3 at)
{
    vec3 d = 1.0 / voxelCount;
    vec3 change = vec3(valueAt(at + vec3(d.x, 0.0, 0.0)) - valueAt(at - vec3(d.x, 0.0, 0.0)),
                       valueAt(at + vec3(0.0, d.y, 0.0)) - valueAt(at - vec3(0.0, d.y, 0.0)),
                       valueAt(at + vec3(0.0, 0.0, d.z)) - valueAt(at - vec3(0.0, 0.0, d.z)));
    return 0.5 * shortestEdge * ((voxelCount * change) * placeFromLocal);
}

StyleSample sampleWithoutNormal(vec3 at, vec3 local)
{
    StyleSample s;
    s.voxel = textureLod(voxels, at, 0.0);
    s.place = at;
    s.position = local;
    s.V = viewer.w > 0.0 ? normalize(viewer.xyz - local) : -normalize(viewer.xyz);
    s.n = vec3(0.0);
    s.gradient = 0.0;
    return s;
}

void setNormal(inout StyleSample s)
{
#ifdef NEEDS_NORMAL
    vec3 slope = slopeAt(s.place);
    s.gradient = length(slope);
    if (s.gradient >= 1e-6) s.n = -slope / s.gradient;
#endif
}

StyleSample sampleAt(vec3 at, vec3 local)
{
    StyleSample s = sampleWithoutNormal(at, local);
    setNormal(s);
    return s;
}

// The way to the next plane behind, along the ray.
vec3 stepFrom(vec3 local)
{
    if (viewer.w <= 0.0) return spacing * viewer.xyz;
    return (spacing / dot(depthRow, vec4(local, 1.0))) * (local - viewer.xyz);
}
)";

// Discarding early saves time even where both sides of a branch are run.
constexpr const char* kSamplesMain = R"(
void main()
{
    if (isClipped(vec4(position, 1.0))) discard;
    int chain = chainAt(place);
    if (chain < 0) discard;
    StyleSample s = sampleWithoutNormal(place, position);
    vec4 color = withoutNormals(chain, firstColor(s.voxel), s);
#ifdef KEEPS_CLEAR
    if (color.a <= 0.0) discard;
#endif
    setNormal(s);
    color = withNormals(chain, color, s);
    float units = length(stepFrom(position)) / unitLength;
    float alpha = 1.0 - pow(1.0 - clamp(color.a, 0.0, 1.0), units);
    fragment = vec4(alpha * color.rgb, alpha);
}
)";

constexpr const char* kSurfacesMain = R"(
uniform float surfaceValues[SURFACES];
uniform float surfaceTolerance;
uniform mat4 clipFromLocal;

void main()
{
    vec3 way = stepFrom(position), placeWay = placeFromLocal * way;
    vec3 next = place + placeWay;
    if (any(lessThan(next, vec3(0.0))) || any(greaterThan(next, vec3(1.0)))) discard;
    if (isClipped(vec4(position, 1.0)) || isClipped(vec4(position + way, 1.0))) discard;
    float here = textureLod(voxels, place, 0.0).r, there = textureLod(voxels, next, 0.0).r;
    bool crosses = false;
    for (int i = 0; i < SURFACES; ++i)
        crosses = crosses || (here < surfaceValues[i]) != (there < surfaceValues[i]);
    if (!crosses) discard;
    fragment = vec4(0.0);
    float nearest = 1.0;
    for (int i = 0; i < SURFACES; ++i) {
        int number = here < there ? i : SURFACES - 1 - i;
        float value = surfaceValues[number];
        if ((here < value) == (there < value)) continue;
        float part = (value - here) / (there - here);
        StyleSample s = sampleAt(place + part * placeWay, position + part * way);
        if (s.gradient < surfaceTolerance || isClipped(vec4(s.position, 1.0))) continue;
        s.n = SURFACE_NORMAL;
        vec4 color = chainOf(min(number, CHAINS - 1), firstColor(s.voxel), s);
        float alpha = clamp(color.a, 0.0, 1.0);
        if (fragment.a == 0.0) nearest = part;
        fragment += (1.0 - fragment.a) * vec4(alpha * color.rgb, alpha);
    }
    if (fragment.a == 0.0) discard;
    vec4 clip = clipFromLocal * vec4(position + nearest * way, 1.0);
    gl_FragDepth = 0.5 * (gl_DepthRange.diff * clip.z / clip.w + gl_DepthRange.near + gl_DepthRange.far);
}
)";

constexpr const char* kPictureVertexShader = R"(
layout(location = 0) in vec2 corner;
out vec2 device;
void main()
{
    device = corner;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// TYPE is 0 for the maximum, 1 for the minimum, 2 for the mean. Each pixel is drawn with the band that its
// first plane is in.
constexpr const char* kProjectionMain = R"(
in vec2 device;
uniform mat3 rayOrigins, rayDirections;
uniform vec2 depthsSeen, band;
uniform float intensityThreshold;
uniform mat4 clipFromLocal;
#ifdef OPAQUE_DEPTHS
uniform sampler2D opaqueDepths;
#endif

// Keeps of a range the part where value + slope * depth is not negative.
void cut(inout vec2 range, float value, float slope)
{
    if (slope > 0.0)
        range.x = max(range.x, -value / slope);
    else if (slope < 0.0)
        range.y = min(range.y, -value / slope);
    else if (value < 0.0)
        range.y = -1e30;
}

void main()
{
    vec3 origin = rayOrigins * vec3(1.0, device), way = rayDirections * vec3(1.0, device);
    vec2 range = depthsSeen;
    for (int axis = 0; axis < 3; ++axis) {
        cut(range, origin[axis] / dimensions[axis] + 0.5, way[axis] / dimensions[axis]);
        cut(range, 0.5 - origin[axis] / dimensions[axis], -way[axis] / dimensions[axis]);
    }
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i)
        cut(range, dot(clipPlanes[i], vec4(origin, 1.0)), dot(clipPlanes[i].xyz, way));
#endif
#ifdef OPAQUE_DEPTHS
    range.y = min(range.y, texelFetch(opaqueDepths, ivec2(gl_FragCoord.xy), 0).r);
#endif
    vec2 planes = vec2(ceil(range.x / spacing - 0.5), floor(range.y / spacing - 0.5));
    if (planes.x > planes.y || planes.x < band.x || planes.x > band.y) discard;

    float side = TYPE == 1 ? -1.0 : 1.0;
    float best = -1e30, opacity = 0.0, count = 0.0, first = planes.x;
    float before = -1e30, opacityBefore = 0.0;
    bool found = false;
    for (float k = planes.x; k <= planes.y; k += 1.0) {
        vec3 local = origin + ((k + 0.5) * spacing) * way;
        vec3 at = local / dimensions + 0.5;
        int chain = chainAt(at);
        if (chain < 0) continue;
        StyleSample s = sampleAt(at, local);
        vec4 color = chainOf(chain, firstColor(s.voxel), s);
        float value = side * (color.r + color.g + color.b) / 3.0, alpha = opacityOf(chain, color, s);
        if (count == 0.0) first = k;
        count += 1.0;
#if TYPE == 2
        best = count == 1.0 ? value : best + value;
        opacity += alpha;
#else
        if (intensityThreshold > 0.0 && before > side * intensityThreshold && value < before) {
            found = true;
            break;
        }
        if (value > best) {
            best = value;
            opacity = alpha;
        }
        before = value;
        opacityBefore = alpha;
#endif
    }
    if (count == 0.0) discard;
#if TYPE == 2
    best /= count;
    opacity /= count;
#else
    if (found || (intensityThreshold > 0.0 && before > side * intensityThreshold)) {
        best = before;
        opacity = opacityBefore;
    }
#endif
    opacity = clamp(opacity, 0.0, 1.0);
    fragment = vec4(vec3(side * best * opacity), opacity);
    vec4 clip = clipFromLocal * vec4(origin + ((first + 0.5) * spacing) * way, 1.0);
    gl_FragDepth = 0.5 * (gl_DepthRange.diff * clip.z / clip.w + gl_DepthRange.near + gl_DepthRange.far);
}
)";

bool needsNormal(std::span<const StyleChain> chains)
{
    return std::ranges::any_of(chains, [](const StyleChain& chain) {
        return std::ranges::any_of(chain, [](const auto& style) { return style->needsNormal(); });
    });
}

/// How many styles at the front of a chain read no normal.
std::ptrdiff_t countWithoutNormals(const StyleChain& chain)
{
    return std::ranges::find_if(chain, [](const auto& style) { return style->needsNormal(); }) -
           chain.begin();
}

/// Whether what is clear without normals is so with them.
bool keepsClear(std::span<const StyleChain> chains)
{
    return std::ranges::all_of(chains, [](const StyleChain& chain) {
        return std::all_of(chain.begin() + countWithoutNormals(chain), chain.end(),
                           [](const auto& style) { return style->keepsClear() && !style->replacesColor(); });
    });
}

/// Writes `vec4 withoutNormals(int chain, vec4 color, StyleSample s)` for the styles at the front of chains,
/// withNormals for those from the first on that reads one, and chainOf for both.
std::string writeChains(GlslChain& glsl, std::span<const StyleChain> chains)
{
    constexpr const char* kParameters = "(int chain, vec4 color, StyleSample s)\n{\n";
    std::string without = std::string("vec4 withoutNormals") + kParameters;
    std::string with = std::string("vec4 withNormals") + kParameters;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const auto writePart = [&](auto from, auto to, const std::string& name, std::string& choice) {
            std::for_each(from, to, [&glsl](const auto& style) { style->write(glsl); });
            glsl.endFunction(name);
            choice += "    if (chain == " + std::to_string(i) + ") return " + name + "(color, s);\n";
        };
        const std::string number = std::to_string(i);
        const auto middle = chains[i].begin() + countWithoutNormals(chains[i]);
        writePart(chains[i].begin(), middle, "front" + number, without);
        writePart(middle, chains[i].end(), "rest" + number, with);
    }
    constexpr const char* kEnd = "    return color;\n}\n";
    return without + kEnd + with + kEnd + "vec4 chainOf" + kParameters +
           "    return withNormals(chain, withoutNormals(chain, color, s), s);\n}\n";
}

/// `int chainAt(vec3 place)`: which chain a place has, or -1.
std::string chainAtText(const StyledVolume& volume)
{
    if (!volume.segments || volume.surfaces) return "int chainAt(vec3 place) { return 0; }\n";
    return R"(
uniform sampler3D identifiers, chainTable;
uniform float identifierScale;
uniform int chainsGiven, chainBeyond;
int chainAt(vec3 place)
{
    ivec3 size = textureSize(identifiers, 0), width = textureSize(chainTable, 0);
    ivec3 texel = clamp(ivec3(floor(place * vec3(size))), ivec3(0), size - 1);
    int id = int(texelFetch(identifiers, texel, 0)[)" +
           std::to_string(volume.segments->component) + R"(] * identifierScale + 0.5);
    if (id >= chainsGiven) return chainBeyond;
    return int(floor(texelFetch(chainTable, ivec3(id % width.x, id / width.x, 0), 0).r + 0.5));
}
)";
}

/// `float opacityOf(int chain, vec4 color, StyleSample s)`: of a projected sample.
std::string opacityOfText(const StyledVolume& volume)
{
    constexpr std::array kVoxelOpacities{"1.0", "s.voxel.g", "1.0", "s.voxel.a"};
    const std::string ofVoxel = kVoxelOpacities.at(static_cast<std::size_t>(volume.voxels->components) - 1);
    std::string text = "float opacityOf(int chain, vec4 color, StyleSample s)\n{\n";
    for (std::size_t i = 0; i < volume.chains.size(); ++i)
        if (volume.chains[i].empty())
            text += "    if (chain == " + std::to_string(i) + ") return " + ofVoxel + ";\n";
    return text + "    return color.a;\n}\n";
}

std::string define(const std::string& what)
{
    return "#define " + what + "\n";
}

} // namespace

bool isProjected(const StyledVolume& volume)
{
    return volume.projection && !volume.surfaces;
}

VolumeProgram volumeProgram(const StyledVolume& volume, bool opaqueDepths)
{
    VolumeProgram program;
    const bool projection = isProjected(volume);
    const bool surfaces = volume.surfaces.has_value();
    std::vector<StyleChain> chains = surfaces ? volume.surfaces->chains : volume.chains;
    std::ranges::transform(chains, chains.begin(), effectiveChain);
    std::string definitions = "#version 330 core\n";
    if (volume.tetras) definitions += define("OWN_PLACES");
    program.vertexText = definitions + (projection ? kPictureVertexShader : kVertexShader);
    if (projection)
        definitions += define("WHOLE_RAYS") +
                       define("TYPE " + std::to_string(static_cast<int>(volume.projection->type))) +
                       define("CLIP_PLANES " + std::to_string(volume.clipPlanes.size()));
    if (projection && opaqueDepths) definitions += define("OPAQUE_DEPTHS");

    const std::string components = std::to_string(volume.voxels->components);
    definitions += define("COMPONENTS " + components) + define("firstColor firstColor" + components) +
                   define("CHAINS " + std::to_string(chains.size()));
    if (surfaces) definitions += define("SURFACES " + std::to_string(volume.surfaces->values.size()));
    if (surfaces || needsNormal(chains)) definitions += define("NEEDS_NORMAL");
    if (keepsClear(chains)) definitions += define("KEEPS_CLEAR");
    const std::string choice = writeChains(program.chains, chains);
    if (surfaces)
        definitions +=
            define("SURFACE_NORMAL " + SurfaceNormals(volume.surfaces->gradients).write(program.chains));
    program.fragmentText = definitions + lightDeclarations(volume.surroundings.lights.size()) +
                           clipPlaneDeclarations(volume.clipPlanes.size()) + kStylePreamble +
                           kFirstColorGlsl + program.chains.declarations() + program.chains.functions() +
                           choice + kSampleFunctions +
                           (surfaces     ? kSurfacesMain
                            : projection ? chainAtText(volume) + opacityOfText(volume) + kProjectionMain
                                         : chainAtText(volume) + kSamplesMain);
    return program;
}

} // namespace vo
