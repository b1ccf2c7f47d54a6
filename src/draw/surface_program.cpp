#include "draw/surface_program.h"

#include "cast/edge_shift.h"
#include "draw/ray_hits.h"
#include "draw/scene_view_point.h"
#include "style/power.h"
#include "style/shine.h"
#include "style/uncut_planes.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <vector>

namespace vo {

namespace {

constexpr const char* kVertexShader = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
uniform mat4 clipFromLocal, worldFromLocal;
uniform mat3 worldNormals;
out vec3 world;
out vec3 worldNormal;
out vec4 colorGiven;
#ifdef KNOWS_DEPTH
layout(location = 3) in vec4 plane;
layout(location = 4) in vec3 depths;
flat out vec4 eyePlane;
flat out vec2 eyeDepths;
#ifdef PLANE_DEPTHS
layout(location = 5) in vec4 windowPlane;
flat out vec4 depthPlane;
#endif
#endif
#ifdef SLICED
uniform vec4 depthRow;
uniform vec2 slab;
out float gl_ClipDistance[2];
#endif

void main()
{
    gl_Position = clipFromLocal * vec4(position, 1.0);
    world = (worldFromLocal * vec4(position, 1.0)).xyz;
    worldNormal = worldNormals * normal;
    colorGiven = color;
#ifdef KNOWS_DEPTH
    eyePlane = plane;
    eyeDepths = depths.xy;
#ifdef PLANE_DEPTHS
    depthPlane = windowPlane;
#endif
#endif
#ifdef SLICED
    float depth = dot(depthRow, vec4(position, 1.0));
    gl_ClipDistance[0] = depth - slab.x + depths.z;
    gl_ClipDistance[1] = slab.y + depths.z - depth;
#endif
}
)";

// A part of a triangle is cut out with some margin, and depths decide that are the same for the pixel in
// whatever part: they come from the triangle's plane and the pixel's ray.
constexpr const char* kFragmentShader = R"(
in vec3 world;
in vec3 worldNormal;
in vec4 colorGiven;
uniform vec4 viewer;
uniform bool mirrored, solid, lit;
uniform vec3 diffuse, emissive, specular;
uniform float ambientIntensity, exponent, opacity;
layout(location = 0) out vec4 fragment;

uniform vec2 pictureSize;
#ifdef PLANE_DEPTHS
#ifdef KNOWS_DEPTH
flat in vec4 depthPlane;
#else
uniform vec4 windowPlane;
#define depthPlane windowPlane
#endif
float windowDepth()
{
    if (depthPlane.w == 0.0) return gl_FragCoord.z;
    vec2 device = 2.0 * gl_FragCoord.xy / pictureSize - 1.0;
    float depth = clamp(depthPlane.x * device.x + depthPlane.y * device.y + depthPlane.z, 0.0, 1.0);
    return gl_DepthRange.near + gl_DepthRange.diff * depth;
}
#else
float windowDepth()
{
    return gl_FragCoord.z;
}
#endif

#ifdef KNOWS_DEPTH
flat in vec4 eyePlane;
flat in vec2 eyeDepths;
uniform mat3 rayOrigins, rayDirections;

float eyeDepth()
{
    vec3 device = vec3(1.0, 2.0 * gl_FragCoord.xy / pictureSize - 1.0);
    float toPlane = -(dot(eyePlane.xyz, rayOrigins * device) + eyePlane.w);
    float depth = toPlane / dot(eyePlane.xyz, rayDirections * device);
    return depth >= eyeDepths.x ? min(depth, eyeDepths.y) : eyeDepths.x;
}
#endif

// What is opaque hides what is translucent at its depth, however that is rounded.
#if defined(KNOWS_DEPTH) && defined(PLANE_DEPTHS)
const float kDepthStep = 1.2e-7;
#elif defined(KNOWS_DEPTH)
const float kDepthStep = 3e-8; // half of one of 24 bits
#else
const float kDepthStep = 0.0;
#endif

#ifdef SLICED
uniform vec2 slab;
bool isInSlab()
{
    float depth = eyeDepth();
    return depth >= slab.x && depth < slab.y;
}
#endif

#ifdef HIT
uniform sampler2D windowDepths;
uniform int firstTriangle;
layout(location = 1) out vec4 hit;

// Behind the last one: farther, or at one depth a later triangle.
bool isBehindLast(float depth, float triangle)
{
    if (depth + kDepthStep >= texelFetch(windowDepths, ivec2(gl_FragCoord.xy), 0).r) return false;
    vec4 last = lastReached();
    if (!isNextWanted(last)) return false;
    if (!isOwn(last)) return true;
    return depth > last.z || (depth == last.z && triangle > last.w);
}
#endif

vec3 litColor(vec3 CD, vec3 n, vec3 V)
{
    vec3 sum = emissive;
    for (int i = 0; i < lightCount; ++i)
        sum += litBy(lights[i], world, n, V, CD, specular, ambientIntensity, exponent, 1.0);
    return min(sum, 1.0);
}

void main()
{
    vec3 faceNormal = cross(dFdx(world), dFdy(world));
    if (isClipped(vec4(world, 1.0))) discard;
#ifdef SLICED
    if (!isInSlab()) discard;
#endif
#ifdef HIT
    float triangle = float(firstTriangle + gl_PrimitiveID), depth = windowDepth();
    if (!isBehindLast(depth, triangle)) discard;
    hit = vec4(eyeDepth(), 0.0, depth, triangle);
    gl_FragDepth = depth;
#elif defined(PLANE_DEPTHS)
    gl_FragDepth = windowDepth() + kDepthStep;
#endif
    bool outside = gl_FrontFacing != mirrored;
    if (solid && !outside) discard;
    vec3 V = viewer.w > 0.0 ? normalize(viewer.xyz - world) : -normalize(viewer.xyz);
    vec3 n = outside ? worldNormal : -worldNormal;
    if (n == vec3(0.0)) n = dot(faceNormal, V) < 0.0 ? -faceNormal : faceNormal;
    float size = length(n);
    n = size > 0.0 ? n / size : vec3(0.0);
#ifdef COLORS
    vec3 CD = colorGiven.rgb;
    float alpha = clamp(colorGiven.a, 0.0, 1.0);
#else
    vec3 CD = diffuse;
    float alpha = opacity;
#endif
    fragment = vec4(alpha * (lit ? litColor(CD, n, V) : emissive), alpha);
}
)";

void setMaterial(const StyledSurface& surface, SceneProgram& program)
{
    program.set("solid", static_cast<int>(surface.solid));
    program.set("lit", static_cast<int>(surface.lit));
    program.set("mirrored", static_cast<int>(glm::determinant(glm::dmat3(surface.worldFromLocal)) < 0.0));
    program.set("diffuse", surface.diffuse);
    program.set("emissive", surface.emissive);
    program.set("specular", surface.specular);
    program.set("ambientIntensity", surface.ambientIntensity);
    program.set("exponent", 128.0f * surface.shininess);
    program.set("opacity", 1.0f - surface.transparency);
    program.set(surface.lights);
}

/// Planes that do not cut what is drawn have no sides.
void setClipPlanes(const StyledScene& scene, const StyledSurface& surface, std::uint32_t uncut,
                   SceneProgram& program)
{
    std::vector<glm::vec4> planes;
    const glm::dmat4 shift = glm::inverse(scene.eyeFromWorld) * edgeShift(scene) * scene.eyeFromWorld;
    for (std::size_t i = 0; i < surface.clipPlanes.size(); ++i)
        planes.emplace_back(isUncut(uncut, i) ? glm::dvec4(0.0) : surface.clipPlanes[i] * shift);
    program.set("clipPlanes", std::span<const glm::vec4>(planes));
}

void setView(const StyledScene& scene, const StyledSurface& surface, SceneProgram& program)
{
    const glm::dmat4& worldFromLocal = surface.worldFromLocal;
    program.set("clipFromLocal", glm::mat4(scene.clipFromEye * scene.eyeFromWorld * worldFromLocal));
    program.set("worldFromLocal", glm::mat4(worldFromLocal));
    program.set("worldNormals", glm::mat3(glm::transpose(glm::inverse(glm::dmat3(worldFromLocal)))));
    program.set("viewer", glm::vec4(viewerIn(scene, glm::dmat4(1.0))));
    program.set("depthRow", glm::vec4(depthRowOf(scene, worldFromLocal)));
    program.set("pictureSize", glm::vec2(scene.width, scene.height));
    const EyeRays rays = eyeRays(scene.clipFromEye);
    program.set("rayOrigins", glm::mat3(rays.origin));
    program.set("rayDirections", glm::mat3(rays.direction));
}

} // namespace

glm::vec4 windowPlane(const glm::dvec4& eyePlane, const glm::dmat4& clipFromEye)
{
    const glm::dvec4 clip = eyePlane * glm::inverse(clipFromEye);
    const glm::vec4 plane(glm::dvec3(-clip.x, -clip.y, clip.z - clip.w) / (2.0 * clip.z), 1.0);
    const auto isUsable = [](float value) { return std::isfinite(value) && std::abs(value) < 1e6f; };
    return isUsable(plane.x) && isUsable(plane.y) && isUsable(plane.z) ? plane : glm::vec4(0.0f);
}

SceneProgram& useSurfaceProgram(const StyledScene& scene, const StyledSurface& surface,
                                const SurfaceRequest& request, ScenePrograms& programs)
{
    const SurfacePart part = request.part;
    std::string definitions = "#version 330 core\n";
    if (part != SurfacePart::whole) definitions += "#define KNOWS_DEPTH\n";
    if (part == SurfacePart::slab) definitions += "#define SLICED\n";
    if (part == SurfacePart::hit) definitions += "#define HIT\n";
    if (request.depths == SurfaceDepths::ofPlane) definitions += "#define PLANE_DEPTHS\n";
    const std::string vertexText = definitions + kVertexShader;
    if (!surface.colors.empty()) definitions += "#define COLORS\n";
    SceneProgram& program =
        programs.find(vertexText, definitions + lightDeclarations(surface.lights.size()) +
                                      clipPlaneDeclarations(surface.clipPlanes.size()) + kRaisedGlsl +
                                      kDirectionToGlsl + kStrengthOfGlsl + kLitByGlsl +
                                      (part == SurfacePart::hit ? kReachedGlsl : "") + kFragmentShader);
    program.use();
    setMaterial(surface, program);
    setView(scene, surface, program);
    setClipPlanes(scene, surface, request.uncut, program);
    return program;
}

} // namespace vo
