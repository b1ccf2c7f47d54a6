#include "draw/volume_shaders.h"

namespace vo {

const char* const kSliceVertexShader = R"(
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
const char* const kStylePreamble = R"(
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

const char* const kSampleFunctions = R"(
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

// What a sample shows that counts for so many units of length.
vec4 fragmentOf(vec4 color, float units)
{
    float alpha = 1.0 - pow(1.0 - clamp(color.a, 0.0, 1.0), units);
    return vec4(alpha * color.rgb, alpha);
}
)";

// Discarding early saves time even where both sides of a branch are run.
const char* const kSamplesMain = R"(
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
    fragment = fragmentOf(color, length(stepFrom(position)) / unitLength);
}
)";

const char* const kSurfaceFunctions = R"(
uniform float surfaceValues[SURFACES];
uniform float surfaceTolerance;

bool crosses(float value, float here, float there)
{
    return (here < value) != (there < value);
}

bool crossesAny(float here, float there)
{
    for (int i = 0; i < SURFACES; ++i)
        if (crosses(surfaceValues[i], here, there)) return true;
    return false;
}

// The surface that is the i-th on the way.
int surfaceOnWay(int i, float here, float there)
{
    return here < there ? i : SURFACES - 1 - i;
}

// Behind what is in the fragment already. False: there is none.
bool addSurface(int number, vec3 at, vec3 local)
{
    StyleSample s = sampleAt(at, local);
    if (s.gradient < surfaceTolerance) return false;
    s.n = SURFACE_NORMAL;
    vec4 color = chainOf(chainOfSurface[number], firstColor(s.voxel), s);
    float alpha = clamp(color.a, 0.0, 1.0);
    fragment += (1.0 - fragment.a) * vec4(alpha * color.rgb, alpha);
    return true;
}
)";

const char* const kSurfacesMain = R"(
uniform mat4 clipFromLocal, edgeShift;
uniform vec2 part; // of the way to the next plane

void main()
{
    vec3 way = stepFrom(position), placeWay = placeFromLocal * way;
    vec3 next = place + placeWay, seen = (edgeShift * vec4(position + way, 1.0)).xyz - position;
    vec3 end = place + placeFromLocal * seen;
    if (any(lessThan(end, vec3(0.0))) || any(greaterThan(end, vec3(1.0)))) discard;
    if (isClipped(vec4(position, 1.0)) || isClipped(vec4(position + way, 1.0))) discard;
    float here = textureLod(voxels, place, 0.0).r, there = textureLod(voxels, next, 0.0).r;
    if (!crossesAny(here, there)) discard;
    fragment = vec4(0.0);
    float nearest = 1.0;
    for (int i = 0; i < SURFACES; ++i) {
        int number = surfaceOnWay(i, here, there);
        float value = surfaceValues[number];
        if (!crosses(value, here, there)) continue;
        float at = (value - here) / (there - here);
        if (at < part.x || at >= part.y) continue;
        bool isFirst = fragment.a == 0.0;
        vec3 local = position + at * way;
        if (isClipped(vec4(local, 1.0)) || !addSurface(number, place + at * placeWay, local)) continue;
        if (isFirst) nearest = at;
    }
    if (fragment.a == 0.0) discard;
    vec4 clip = clipFromLocal * vec4(position + nearest * way, 1.0);
    gl_FragDepth = 0.5 * (gl_DepthRange.diff * clip.z / clip.w + gl_DepthRange.near + gl_DepthRange.far);
}
)";

const char* const kPictureVertexShader = R"(
layout(location = 0) in vec2 corner;
out vec2 device;
void main()
{
    device = corner;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

// The ray of a pixel. Depths and planes are counted from `depthBase`, near the volume, where numbers are
// small and exact; planes lie at (k + 1/2) * spacing.
const char* const kRayFunctions = R"(
in vec2 device;
uniform mat3 rayOrigins, rayDirections;
uniform vec3 originShift, wayShift; // to where pixels look for edges
uniform vec2 depthsSeen;
uniform float depthBase;
uniform vec4 depthsInWindow;
uniform sampler2D windowDepths;

// Where the ray meets what is opaque, so much farther in the window.
float opaqueDepth(float farther)
{
    float there = texelFetch(windowDepths, ivec2(gl_FragCoord.xy), 0).r + farther;
    float z = (2.0 * there - gl_DepthRange.near - gl_DepthRange.far) / gl_DepthRange.diff;
    if (z >= 1.0) return 1e30;
    return (depthsInWindow.z - z * depthsInWindow.w) / (depthsInWindow.x - z * depthsInWindow.y) - depthBase;
}

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

// Where the ray is in the volume.
vec2 depthsOn(vec3 origin, vec3 way)
{
    vec2 range = depthsSeen;
    vec3 from = (origin + originShift) / dimensions, along = (way + wayShift) / dimensions;
    for (int axis = 0; axis < 3; ++axis) {
        cut(range, from[axis] + 0.5, along[axis]);
        cut(range, 0.5 - from[axis], -along[axis]);
    }
#if CLIP_PLANES > 0
    for (int i = 0; i < CLIP_PLANES; ++i)
        cut(range, dot(clipPlanes[i], vec4(origin, 1.0)), dot(clipPlanes[i].xyz, way));
#endif
    return range;
}

// The first and the last plane there.
vec2 planesIn(vec2 range)
{
    return vec2(ceil(range.x / spacing - 0.5), floor(range.y / spacing - 0.5));
}

float lastBefore(float depth)
{
    return floor(min(depth, 1e30) / spacing - 0.5);
}

// Of the part of a ray that is drawn: where it begins, which is not in it, and where it ends.
#ifdef BETWEEN_HITS
uniform sampler2D next;
vec4 nextHit()
{
    return texelFetch(next, ivec2(gl_FragCoord.xy), 0);
}
vec2 partOfRay()
{
    return vec2(lastReached().x, nextHit().x) - depthBase;
}
bool isInPart(float depth)
{
    float there = depthBase + depth;
    return isBehind(there, source, lastReached().xy) && !isBehind(there, source, nextHit().xy);
}
#else
vec2 partOfRay()
{
    return vec2(-1e30, 1e30);
}
bool isInPart(float depth)
{
    return true;
}
#endif
)";

// Planes of a ray, one after the other. Blocks of voxels in which nothing is seen are leapt over:
// `clearBlocks` says how many blocks it is at least to the next one that is not.
const char* const kWalkFunctions = R"(
const float kOpaque = 1.0 - 1.0 / 4096.0;
const float kSamplesAtOnce = 8.0;

// Where plane 0 is met, and how far it is to the next: local, as a place in the volume, and in cells.
struct Walk {
    vec3 local, localStep, place, placeStep, cell, cellStep;
};

Walk walkOf(vec3 origin, vec3 way)
{
    vec3 localStep = spacing * way, local = origin + 0.5 * localStep;
    vec3 placeStep = localStep / dimensions, place = local / dimensions + 0.5;
    return Walk(local, localStep, place, placeStep, place * voxelCount + CELL_SHIFT, placeStep * voxelCount);
}

#ifdef LEAPS
uniform sampler3D clearBlocks;

float leapFrom(float k, float last, Walk walk)
{
    vec3 cell = walk.cell, cellStep = walk.cellStep;
    vec3 side = sign(cellStep), perCell = 1.0 / mix(cellStep, vec3(1e-9), lessThan(abs(cellStep), vec3(1e-9)));
    while (k < last) {
        vec3 here = cell + k * cellStep;
        ivec3 block = ivec3(here) >> BLOCK_SHIFT;
        float blocks = floor(255.0 * texelFetch(clearBlocks, block, 0).r + 0.5);
        if (blocks < 0.5) break;
        vec3 end = (vec3(block) + max(side, 0.0) + side * (blocks - 1.0)) * float(1 << BLOCK_SHIFT);
        vec3 steps = mix((end - here) * perCell, vec3(1e9), lessThan(abs(cellStep), vec3(1e-9)));
        float over = floor(0.9999 * min(steps.x, min(steps.y, steps.z)));
        if (over < 1.0) break;
        k = min(k + over, last);
    }
    return k;
}
#else
float leapFrom(float k, float last, Walk walk)
{
    return k;
}
#endif
)";

// Samples are taken front to back until nothing more shows through. Searching for the next one that is seen
// is a loop of its own: pixels that are drawn together wait for each other there, and are then shaded
// together.
const char* const kMarchedSamplesMain = R"(
void main()
{
    vec3 origin = rayOrigins * vec3(1.0, device), way = rayDirections * vec3(1.0, device);
    vec2 planes = planesIn(depthsOn(origin, way)), part = partOfRay();
    float last = min(min(planes.y, lastBefore(opaqueDepth(0.0))), lastBefore(part.y));
    planes.x = max(planes.x, lastBefore(part.x) + 1.0);
    if (planes.x > last) discard;
    float units = length(way) * spacing / unitLength;
    Walk walk = walkOf(origin, way);
    StyleSample s = sampleWithoutNormal(vec3(0.0), walk.local);
    s.V = -normalize(way);
    fragment = vec4(0.0);
    vec4 color = vec4(0.0);
    int chain = 0;
    float k = planes.x;
    while (k <= last && fragment.a < kOpaque) {
        k = leapFrom(k, last, walk);
        float until = min(k + kSamplesAtOnce, last + 1.0);
        bool seen = false;
        while (k < until) {
            s.place = walk.place + k * walk.placeStep;
            s.position = walk.local + k * walk.localStep;
            s.voxel = textureLod(voxels, s.place, 0.0);
            chain = chainAt(s.place);
            color = chain < 0 ? vec4(0.0) : withoutNormals(chain, firstColor(s.voxel), s);
#ifdef KEEPS_CLEAR
            seen = color.a > 0.0;
#else
            seen = chain >= 0;
#endif
            k += 1.0;
            if (seen) break;
        }
        if (seen) {
            s.n = vec3(0.0);
            s.gradient = 0.0;
            setNormal(s);
            color = withNormals(chain, color, s);
            fragment += (1.0 - fragment.a) * fragmentOf(color, units);
        }
    }
    if (fragment.a <= 0.0) discard;
}
)";

const char* const kCrossingFunctions = R"(
// Surfaces in one place with what is opaque are in front of it: four steps of depths of 24 bits.
const float kInFront = 2.4e-7;

// Goes on by leaps and a few planes, as far as one before which a surface is crossed: whether there is one.
// The values at the plane before it, and at it.
bool findCrossing(inout float k, float last, Walk walk, out float here, out float there)
{
    k = leapFrom(k, last, walk);
    float until = min(k + kSamplesAtOnce, last);
    there = textureLod(voxels, walk.place + k * walk.placeStep, 0.0).r;
    here = there;
    while (k < until) {
        here = there;
        k += 1.0;
        there = textureLod(voxels, walk.place + k * walk.placeStep, 0.0).r;
        if (crossesAny(here, there)) return true;
    }
    return false;
}
)";

const char* const kMarchedSurfacesMain = R"(
void main()
{
    vec3 origin = rayOrigins * vec3(1.0, device), way = rayDirections * vec3(1.0, device);
    vec2 planes = planesIn(depthsOn(origin, way)), part = partOfRay();
    // A crossing at the plane where the part begins or ends may be of the cell beside.
    float opaque = opaqueDepth(kInFront), last = min(planes.y, lastBefore(min(opaque, part.y)) + 2.0);
    planes.x = max(planes.x, lastBefore(part.x) - 1.0);
    if (planes.x >= last) discard;
    Walk walk = walkOf(origin, way);
    fragment = vec4(0.0);
    float k = planes.x;
    while (k < last && fragment.a < kOpaque) {
        float here, there;
        if (!findCrossing(k, last, walk, here, there)) continue;
        for (int i = 0; i < SURFACES; ++i) {
            int number = surfaceOnWay(i, here, there);
            float value = surfaceValues[number];
            float at = k - 1.0 + (value - here) / (there - here), depth = (at + 0.5) * spacing;
            if (!crosses(value, here, there) || depth >= opaque || !isInPart(depth)) continue;
            addSurface(number, walk.place + at * walk.placeStep, walk.local + at * walk.localStep);
        }
    }
    if (fragment.a <= 0.0) discard;
}
)";

// A hit has the plane before it and the number of the surface on the way to the next one.
const char* const kNextSurfaceMain = R"(
layout(location = 1) out vec4 hit;
void main()
{
    vec4 before = lastReached();
    if (!isNextWanted(before)) discard;
    hit = vec4(kNoHit, 0.0, 0.0, 0.0);
    fragment = vec4(0.0);
    vec3 origin = rayOrigins * vec3(1.0, device), way = rayDirections * vec3(1.0, device);
    vec2 planes = planesIn(depthsOn(origin, way));
    float opaque = opaqueDepth(kInFront), last = min(planes.y, lastBefore(opaque) + 1.0);
    if (planes.x >= last) return;
    Walk walk = walkOf(origin, way);
    bool isFirst = !isOwn(before);
    float k = isFirst ? planes.x : before.z;
    while (k < last && fragment.a == 0.0) {
        float here, there;
        if (!findCrossing(k, last, walk, here, there)) continue;
        bool isPassed = !isFirst && k - 1.0 == before.z;
        for (int i = isPassed ? int(before.w) + 1 : 0; i < SURFACES && fragment.a == 0.0; ++i) {
            int number = surfaceOnWay(i, here, there);
            float value = surfaceValues[number];
            float at = k - 1.0 + (value - here) / (there - here), depth = (at + 0.5) * spacing;
            if (!crosses(value, here, there) || depth >= opaque) continue;
            addSurface(number, walk.place + at * walk.placeStep, walk.local + at * walk.localStep);
            hit = vec4(depthBase + depth, 0.0, k - 1.0, float(i));
        }
    }
    if (fragment.a == 0.0) hit.x = kNoHit;
}
)";

const char* const kProjectedSample = R"(
// The value and the opacity that are joined.
vec2 projectedSample(int chain, vec3 at, vec3 local)
{
    StyleSample s = sampleAt(at, local);
    vec4 color = chainOf(chain, firstColor(s.voxel), s);
    return vec2((color.r + color.g + color.b) / 3.0, opacityOf(chain, color, s));
}
)";

// Samples are joined later.
const char* const kPlaneSamplesMain = R"(
void main()
{
    int chain = chainAt(place);
    if (chain < 0 || isClipped(vec4(position, 1.0))) discard;
    fragment = vec4(projectedSample(chain, place, position), 0.0, 0.0);
}
)";

// TYPE is 0 for the maximum, 1 for the minimum, 2 for the mean.
const char* const kJoinFunctions = R"(
uniform float intensityThreshold;
const float kSide = TYPE == 1 ? -1.0 : 1.0;

struct Joined {
    float best, opacity;         // of all so far; the sum for the mean
    float before, opacityBefore; // of the last one
    float count, first;          // how many, and the plane of the first
    bool found;                  // no further one counts
};

void join(inout Joined all, float value, float alpha, float plane)
{
    if (all.found) return;
    if (all.count == 0.0) all.first = plane;
#if TYPE == 2
    all.best += value;
    all.opacity += alpha;
#else
    value *= kSide;
    all.found = intensityThreshold > 0.0 && all.count > 0.0 && all.before > kSide * intensityThreshold && value < all.before;
    if (all.found) return;
    if (all.count == 0.0 || value > all.best) {
        all.best = value;
        all.opacity = alpha;
    }
    all.before = value;
    all.opacityBefore = alpha;
#endif
    all.count += 1.0;
}

vec4 colorOf(Joined all)
{
#if TYPE == 2
    float value = all.best / all.count, alpha = all.opacity / all.count;
#else
    bool last = all.found || (intensityThreshold > 0.0 && all.before > kSide * intensityThreshold);
    float value = kSide * (last ? all.before : all.best), alpha = last ? all.opacityBefore : all.opacity;
#endif
    alpha = clamp(alpha, 0.0, 1.0);
    return vec4(vec3(alpha * value), alpha);
}
)";

// A ray has one hit, where it begins. The projection merger keeps of it (draw/merge_projections.h) its grey
// times its opacity, that, and the depth at which it begins.
const char* const kProjectionMain = R"(
#ifdef NEXT_HIT
layout(location = 1) out vec4 hit;
#endif
void main()
{
#ifdef NEXT_HIT
    vec4 before = lastReached();
    if (!isNextWanted(before)) discard;
    fragment = vec4(0.0);
    hit = vec4(kNoHit, 0.0, 0.0, 0.0);
    if (isOwn(before)) return;
#endif
    vec3 origin = rayOrigins * vec3(1.0, device), way = rayDirections * vec3(1.0, device);
    vec2 range = depthsOn(origin, way), planes = planesIn(range);
    float last = min(planes.y, lastBefore(opaqueDepth(0.0)));
    if (planes.x > last) discard;
    Joined all = Joined(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, false);
    for (float k = planes.x; k <= last && !all.found; k += 1.0) {
        vec3 local = origin + ((k + 0.5) * spacing) * way;
        vec3 at = local / dimensions + 0.5;
        int chain = chainAt(at);
        if (chain < 0) continue;
        vec2 projected = projectedSample(chain, at, local);
        join(all, projected.x, projected.y, k);
    }
    if (all.count == 0.0) discard;
    fragment = colorOf(all);
#ifdef MERGED_LATER
    fragment = vec4(fragment.ra, depthBase + range.x, 1.0);
#endif
#ifdef NEXT_HIT
    if (fragment.a <= 0.0) discard;
    hit = vec4(depthBase + range.x, 0.0, 0.0, 0.0);
#endif
}
)";

} // namespace vo
