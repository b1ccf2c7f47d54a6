#include "support/styled_reference.h"

#include "style/shadow_grid.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace vo::test {

namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dvec3;
using glm::dvec4;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The points of a pixel by their eye depth.
struct Ray
{
    dvec3 start{0.0}, perDepth{0.0};
    dvec3 at(double depth) const { return start + perDepth * depth; }
};

Ray carried(const dmat4& matrix, const Ray& ray)
{
    return {dvec3(matrix * dvec4(ray.start, 1.0)), dvec3(matrix * dvec4(ray.perDepth, 0.0))};
}

/// A pixel, and the depths that are seen there. What lies on an edge through its centre it sees on the right
/// of the edge, or above: along `edges`.
struct Sight
{
    Ray eye, world, edges;
    double nearest = 0.0, farthest = kInfinity;
};

/// Of a point in pixels from the lower left corner; its edges are its own.
Sight sightOf(const StyledScene& scene, double x, double y)
{
    const dmat4 eyeFromClip = glm::inverse(scene.clipFromEye);
    const double u = x / scene.width * 2.0 - 1.0;
    const double v = y / scene.height * 2.0 - 1.0;
    const auto unprojected = [&](double w) { return eyeFromClip * dvec4(u, v, w, 1.0); };
    const dvec3 front = dvec3(unprojected(-1.0)) / unprojected(-1.0).w;
    const dvec3 middle = dvec3(unprojected(0.0)) / unprojected(0.0).w;
    Sight sight;
    sight.eye.perDepth = (middle - front) / (front.z - middle.z);
    sight.eye.start = front + sight.eye.perDepth * front.z;
    sight.edges = sight.world = carried(glm::inverse(scene.eyeFromWorld), sight.eye);
    sight.nearest = -front.z;
    const dvec4 back = unprojected(1.0);
    const double farthest = -back.z / back.w;
    if (std::abs(back.w) > 1e-12 && farthest > sight.nearest) sight.farthest = farthest;
    return sight;
}

Sight sightOfPixel(const StyledScene& scene, int x, int y)
{
    Sight sight = sightOf(scene, x + 0.5, y + 0.5);
    sight.edges = sightOf(scene, x + 0.5 + kPixelsPastCenter, y + 0.5 + kPixelsAboveCenter).world;
    return sight;
}

/// Something on a ray: its colour is not multiplied by its opacity.
struct Seen
{
    double depth = 0.0;
    dvec3 color{0.0};
    double opacity = 0.0;
};

bool isClipped(const std::vector<dvec4>& planes, const dvec3& world)
{
    return std::any_of(planes.begin(), planes.end(),
                       [&](const dvec4& plane) { return glm::dot(plane, dvec4(world, 1.0)) < 0.0; });
}

// Surfaces

struct Hit
{
    double depth = 0.0;
    dvec3 weights{0.0}; ///< of the corners
};

/// With the plane of a triangle.
std::optional<Hit> hitOf(const Ray& ray, const std::array<dvec3, 3>& corners)
{
    const dvec3 a = corners[1] - corners[0];
    const dvec3 b = corners[2] - corners[0];
    const dmat3 system(a, b, -ray.perDepth);
    if (std::abs(glm::determinant(system)) < 1e-300) return std::nullopt;
    const dvec3 solution = glm::inverse(system) * (ray.start - corners[0]);
    return Hit{solution.z, {1.0 - solution.x - solution.y, solution.x, solution.y}};
}

std::optional<Hit> hitOf(const Sight& sight, const std::array<dvec3, 3>& corners)
{
    const std::optional<Hit> beside = hitOf(sight.edges, corners);
    if (!beside || glm::any(glm::lessThan(beside->weights, dvec3(0.0)))) return std::nullopt;
    return hitOf(sight.world, corners);
}

template <class T>
T mixed(const std::vector<T>& values, const std::array<std::size_t, 3>& corners, const dvec3& weights)
{
    T sum(0.0f);
    for (int i = 0; i < 3; ++i)
        sum += values[corners[static_cast<std::size_t>(i)]] * static_cast<float>(weights[i]);
    return sum;
}

Seen shadedSurface(const StyledSurface& surface, const std::array<std::size_t, 3>& corners, const Hit& hit,
                   const dvec3& world, const dvec3& V, bool fromBehind)
{
    Seen seen{hit.depth, dvec3(surface.emissive), 1.0 - static_cast<double>(surface.transparency)};
    dvec3 diffuse(surface.diffuse);
    if (!surface.colors.empty()) {
        const dvec4 color(mixed(surface.colors, corners, hit.weights));
        diffuse = dvec3(color);
        seen.opacity = color.a;
    }
    if (!surface.lit) return seen;
    const dmat3 worldFromNormal = glm::transpose(glm::inverse(dmat3(surface.worldFromLocal)));
    dvec3 n = glm::normalize(worldFromNormal * dvec3(mixed(surface.normals, corners, hit.weights)));
    if (fromBehind) n = -n;
    const ReferenceMaterial material{diffuse, dvec3(surface.emissive), dvec3(surface.specular),
                                     static_cast<double>(surface.ambientIntensity),
                                     static_cast<double>(surface.shininess)};
    seen.color = referenceLit(material, surface.lights, world, n, V);
    return seen;
}

/// A surface in the world, for all pixels.
struct PlacedSurface
{
    const StyledSurface& surface;
    std::vector<std::array<dvec3, 3>> triangles;
    bool mirrored = false;

    explicit PlacedSurface(const StyledSurface& of)
        : surface(of), mirrored(glm::determinant(dmat3(of.worldFromLocal)) < 0.0)
    {
        const auto corner = [&](std::size_t i) {
            const auto& position = of.positions[static_cast<std::size_t>(of.triangles[i])];
            return dvec3(of.worldFromLocal * dvec4(dvec3(position), 1.0));
        };
        for (std::size_t t = 0; t + 2 < of.triangles.size(); t += 3)
            triangles.push_back({corner(t), corner(t + 1), corner(t + 2)});
    }
};

void addSurface(const PlacedSurface& placed, const Sight& sight, std::vector<Seen>& all)
{
    const StyledSurface& surface = placed.surface;
    const std::size_t first = all.size();
    for (std::size_t t = 0; t + 2 < surface.triangles.size(); t += 3) {
        const std::array<dvec3, 3>& corners = placed.triangles[t / 3];
        std::array<std::size_t, 3> indices{};
        for (std::size_t i = 0; i < 3; ++i)
            indices[i] = static_cast<std::size_t>(surface.triangles[t + i]);
        const auto hit = hitOf(sight, corners);
        if (!hit || hit->depth < sight.nearest || hit->depth > sight.farthest) continue;
        // An edge that two triangles share is one place.
        const bool again =
            std::any_of(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), [&](const Seen& seen) {
                return std::abs(seen.depth - hit->depth) < 1e-9 * hit->depth;
            });
        const dvec3 world = sight.world.at(hit->depth);
        if (again || isClipped(surface.clipPlanes, sight.edges.at(hit->depth))) continue;
        const dvec3 outside = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        const bool fromBehind = (glm::dot(outside, sight.world.perDepth) > 0.0) != placed.mirrored;
        if (fromBehind && surface.solid) continue;
        const dvec3 V = -glm::normalize(sight.world.perDepth);
        all.push_back(shadedSurface(surface, indices, *hit, world, V, fromBehind));
        if (surface.isOpaque(t)) all.back().opacity = 1.0;
    }
}

// Volumes

/// Where a position lies in the voxels, and how that changes with the position.
struct Spot
{
    dvec3 place{0.0};
    dmat3 placeFromLocal{1.0};
};

std::optional<Spot> spotInBox(const dvec3& dimensions, const dvec3& position, const dvec3& beside)
{
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(beside[axis]) > dimensions[axis] / 2.0) return std::nullopt;
    dmat3 placeFromLocal(0.0);
    for (int axis = 0; axis < 3; ++axis)
        placeFromLocal[axis][axis] = 1.0 / dimensions[axis];
    return Spot{position / dimensions + 0.5, placeFromLocal};
}

std::optional<Spot> spotInTetras(const StyledTetras& tetras, const dvec3& position, const dvec3& beside)
{
    const auto corner = [&](const std::vector<glm::vec3>& of, std::size_t index) {
        return dvec3(of[static_cast<std::size_t>(tetras.indices[index])]);
    };
    for (std::size_t t = 0; t + 3 < tetras.indices.size(); t += 4) {
        const dvec3 origin = corner(tetras.positions, t);
        const dvec3 place = corner(tetras.places, t);
        dmat3 edges, placeEdges;
        for (int i = 0; i < 3; ++i) {
            edges[i] = corner(tetras.positions, t + 1 + static_cast<std::size_t>(i)) - origin;
            placeEdges[i] = corner(tetras.places, t + 1 + static_cast<std::size_t>(i)) - place;
        }
        if (glm::determinant(edges) == 0.0) continue;
        const dvec3 weights = glm::inverse(edges) * (beside - origin);
        if (std::min({weights.x, weights.y, weights.z, 1.0 - weights.x - weights.y - weights.z}) < 0.0)
            continue;
        const dmat3 placeFromLocal = placeEdges * glm::inverse(edges);
        return Spot{place + placeFromLocal * (position - origin), placeFromLocal};
    }
    return std::nullopt;
}

/// `beside`: whether that lies in the volume decides.
std::optional<Spot> spotIn(const StyledVolume& volume, const dvec3& position, const dvec3& beside)
{
    return volume.tetras ? spotInTetras(*volume.tetras, position, beside)
                         : spotInBox(dvec3(volume.dimensions), position, beside);
}

/// A volume along one ray.
class Walk
{
public:
    Walk(const StyledVolume& volume, const Sight& sight)
        : volume_(volume), sight_(sight), local_(carried(glm::inverse(volume.worldFromLocal), sight.world)),
          localEdges_(carried(glm::inverse(volume.worldFromLocal), sight.edges))
    {
    }

    /// The samples in the volume, from the nearest: `take(k, depth)`.
    template <class Take>
    void forSamples(double farthest, const Take& take) const
    {
        const double reach = depthReach();
        const double middle = middleDepth();
        const double from = std::max(sight_.nearest, middle - reach);
        const double to = std::min(farthest, middle + reach);
        const auto last = static_cast<long>(std::floor(to / volume_.spacing - 0.5));
        for (auto k = static_cast<long>(std::ceil(from / volume_.spacing - 0.5)); k <= last; ++k) {
            const double depth = sampleDepth(volume_.spacing, static_cast<double>(k));
            if (spotAt(depth)) take(k, depth);
        }
    }

    /// Where the ray enters the box, as far as it is seen and not clipped: the last of the faces that it
    /// comes to.
    double entryDepth() const
    {
        double entry = sight_.nearest;
        const auto enter = [&entry](double value, double slope) {
            if (slope > 0.0) entry = std::max(entry, -value / slope);
        };
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                enter(0.5 * static_cast<double>(volume_.dimensions[axis]) + side * localEdges_.start[axis],
                      side * localEdges_.perDepth[axis]);
        for (const dvec4& plane : volume_.clipPlanes)
            enter(glm::dot(plane, dvec4(sight_.edges.start, 1.0)),
                  glm::dot(plane, dvec4(sight_.edges.perDepth, 0.0)));
        return entry;
    }

    std::optional<Spot> spotAt(double depth) const
    {
        if (isClipped(volume_.clipPlanes, sight_.edges.at(depth))) return std::nullopt;
        return spotIn(volume_, local_.at(depth), localEdges_.at(depth));
    }

    /// Before any style; its normal, which takes most of the time, may be left out where nothing reads it.
    ReferenceSample sampleAt(double depth, bool withNormal = true) const
    {
        const Spot spot = spotAt(depth).value();
        ReferenceSample sample;
        sample.place = spot.place;
        sample.position = local_.at(depth);
        sample.V = -glm::normalize(local_.perDepth);
        sample.voxel = referenceTexel(*volume_.voxels, spot.place);
        const dvec3 dimensions(volume_.dimensions);
        if (withNormal)
            setNormal(referenceGradient(*volume_.voxels, dimensions, spot.place, spot.placeFromLocal),
                      sample);
        referenceFirstColor(volume_.voxels->components, sample);
        return sample;
    }

    double opacityOver(double Ov) const
    {
        const double length = glm::length(local_.perDepth) * volume_.spacing;
        return 1.0 - std::pow(1.0 - std::clamp(Ov, 0.0, 1.0), length / volume_.unitLength);
    }

private:
    double middleDepth() const
    {
        // The plane of depth d is where the eye's z is -d; the local origin lies on one of them.
        const dvec3 world(volume_.worldFromLocal[3]);
        const dvec3 forward = sight_.world.perDepth;
        return glm::dot(world - sight_.world.start, forward) / glm::dot(forward, forward);
    }

    /// No part of the volume is farther than this from middleDepth() along the ray.
    double depthReach() const
    {
        double farthest = glm::length(dvec3(volume_.dimensions)) / 2.0;
        if (volume_.tetras)
            for (const glm::vec3& position : volume_.tetras->positions)
                farthest = std::max(farthest, glm::length(dvec3(position)));
        double scale = 0.0;
        for (int column = 0; column < 3; ++column)
            scale += glm::length(dvec3(volume_.worldFromLocal[column]));
        return farthest * scale / glm::length(sight_.world.perDepth) + volume_.spacing;
    }

    const StyledVolume& volume_;
    const Sight& sight_;
    Ray local_, localEdges_;
};

/// The chain of a sample's segment, or nothing.
const StyleChain* chainAt(const StyledVolume& volume, const dvec3& place)
{
    if (!volume.segments) return &volume.chains.at(0);
    const Segments& segments = *volume.segments;
    const VoxelTexture& identifiers = *segments.identifiers;
    const double value = referenceTexel(identifiers, place, {identifiers.repeats, true})[segments.component];
    const auto id = static_cast<std::size_t>(std::lround(value * static_cast<double>(segments.scale)));
    const int chain = id < segments.chainOf.size() ? segments.chainOf[id] : segments.beyond;
    return chain < 0 ? nullptr : &volume.chains.at(static_cast<std::size_t>(chain));
}

// Shadows

/// The opacity at a position, seen along the normal; 0 outside.
double opacityToLight(const StyledVolume& volume, const dvec3& position)
{
    const auto spot = spotIn(volume, position, position);
    const dvec3 world(volume.worldFromLocal * dvec4(position, 1.0));
    if (!spot || isClipped(volume.clipPlanes, world)) return 0.0;
    const StyleChain* const chain = chainAt(volume, spot->place);
    if (!chain) return 0.0;
    ReferenceSample sample;
    sample.place = spot->place;
    sample.position = position;
    sample.voxel = referenceTexel(*volume.voxels, spot->place);
    setNormal(referenceGradient(*volume.voxels, dvec3(volume.dimensions), spot->place, spot->placeFromLocal),
              sample);
    sample.V = glm::length(sample.n) > 0.0 ? sample.n : dvec3(0, 0, 1);
    referenceFirstColor(volume.voxels->components, sample);
    referenceChain(*chain, {}, sample);
    return std::clamp(sample.Ov, 0.0, 1.0);
}

/// 1.5 texels or voxels of its way to the light from a sample, as many as are longer.
double shadowBegin(const StyledVolume& volume, const LocalBox& box, const dvec3& toLight)
{
    const ShadowGrid grid = emptyShadowGrid(volume, box);
    const auto edgeAlong = [&](const glm::vec3& edges) { return 1.0 / glm::length(toLight / dvec3(edges)); };
    return 1.5 * std::max(edgeAlong(grid.edges), edgeAlong(grid.voxelEdges));
}

/// Along the straight way to the light, in short steps.
double throughTo(const StyledVolume& volume, const StyleLight& light, const dvec3& position)
{
    const dvec3 L = referenceWayTo(light, position);
    const LocalBox box = shadowBoxOf(volume).value();
    double end = glm::length(dvec3(box.sides));
    if (light.kind != StyleLight::Kind::directional)
        end = std::min(end, glm::distance(dvec3(light.position), position));
    const double step = volume.unitLength / 3.0;
    double through = 1.0;
    for (double at = shadowBegin(volume, box, L); at < end; at += step) {
        const double part = std::min(step, end - at);
        through *= std::pow(1.0 - opacityToLight(volume, position + L * (at + part / 2.0)),
                            part / volume.unitLength);
    }
    return through;
}

void shadow(const StyledVolume& volume, const StyleChain& chain, ReferenceSample& sample)
{
    const bool asks =
        std::any_of(chain.begin(), chain.end(), [](const auto& style) { return style->asksForShadows(); });
    if (!asks) return;
    for (const StyleLight& light : volume.surroundings.lights)
        sample.lightThrough.push_back(throughTo(volume, light, sample.position));
}

void addSamples(const StyledVolume& volume, const Sight& sight, double farthest, std::vector<Seen>& all)
{
    const Walk walk(volume, sight);
    walk.forSamples(farthest, [&](long, double depth) {
        const StyleChain* chain = chainAt(volume, walk.spotAt(depth)->place);
        if (!chain) return;
        ReferenceSample sample = walk.sampleAt(depth, !chain->empty());
        shadow(volume, *chain, sample);
        referenceChain(*chain, volume.surroundings, sample);
        all.push_back({depth, sample.Cv, walk.opacityOver(sample.Ov)});
    });
}

// Projections

/// Whether the sample is the first local maximum beyond the threshold, in a row whose values are the greater
/// the more they count.
std::size_t chosen(const std::vector<double>& values, std::optional<double> threshold)
{
    if (threshold)
        for (std::size_t i = 0; i < values.size(); ++i)
            if (values[i] > *threshold && (i + 1 == values.size() || values[i + 1] < values[i])) return i;
    return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

Seen joined(const RayProjection& projection, const std::vector<Seen>& samples)
{
    std::vector<double> values;
    double sum = 0.0;
    double opacities = 0.0;
    const double sign = projection.type == RayProjection::Type::min ? -1.0 : 1.0;
    for (const Seen& sample : samples) {
        values.push_back(sign * (sample.color.r + sample.color.g + sample.color.b) / 3.0);
        sum += values.back();
        opacities += sample.opacity;
    }
    const double count = static_cast<double>(samples.size());
    if (projection.type == RayProjection::Type::average)
        return {samples[0].depth, dvec3(sum / count), opacities / count};
    std::optional<double> threshold;
    if (projection.intensityThreshold > 0.0f)
        threshold = sign * static_cast<double>(projection.intensityThreshold);
    const std::size_t i = chosen(values, threshold);
    return {samples[0].depth, dvec3(sign * values[i]), samples[i].opacity};
}

void addProjection(const StyledVolume& volume, const Sight& sight, double farthest, std::vector<Seen>& all)
{
    const Walk walk(volume, sight);
    std::vector<Seen> samples;
    walk.forSamples(farthest, [&](long, double depth) {
        const StyleChain* chain = chainAt(volume, walk.spotAt(depth)->place);
        if (!chain) return;
        ReferenceSample sample = walk.sampleAt(depth, !chain->empty());
        referenceChain(*chain, volume.surroundings, sample);
        const int components = volume.voxels->components;
        if (chain->empty()) sample.Ov = components % 2 ? 1.0 : sample.voxel[components - 1];
        samples.push_back({depth, sample.Cv, sample.Ov});
    });
    if (samples.empty()) return;
    all.push_back(joined(*volume.projection, samples));
    if (!volume.tetras) all.back().depth = walk.entryDepth();
}

// Surfaces of a value

void addCrossing(const StyledVolume& volume, const Walk& walk, std::size_t value, double depth,
                 std::vector<Seen>& all)
{
    const IsoSurfaces& surfaces = *volume.surfaces;
    if (!walk.spotAt(depth)) return;
    ReferenceSample sample = walk.sampleAt(depth);
    if (sample.gradient < static_cast<double>(surfaces.surfaceTolerance)) return;
    if (surfaces.gradients) sample.n = referenceNormal(referenceTexel(*surfaces.gradients, sample.place));
    referenceChain(surfaces.chains[std::min(value, surfaces.chains.size() - 1)], volume.surroundings, sample);
    all.push_back({depth, sample.Cv, sample.Ov});
}

void addSurfacesOfValues(const StyledVolume& volume, const Sight& sight, std::vector<Seen>& all)
{
    const Walk walk(volume, sight);
    long previous = 0;
    std::optional<double> before;
    walk.forSamples(sight.farthest, [&](long k, double depth) {
        const double value = walk.sampleAt(depth, false).voxel.r;
        for (std::size_t i = 0; before && previous + 1 == k && i < volume.surfaces->values.size(); ++i) {
            const double level = static_cast<double>(volume.surfaces->values[i]);
            if ((*before < level) == (value < level)) continue;
            const double part = (level - *before) / (value - *before);
            addCrossing(volume, walk, i, depth - volume.spacing * (1.0 - part), all);
        }
        previous = k;
        before = value;
    });
}

// The sky

dvec3 colorAtAngle(const std::vector<float>& angles, const std::vector<glm::vec3>& colors, double angle)
{
    double low = 0.0;
    for (std::size_t i = 0; i < angles.size() && i + 1 < colors.size(); ++i) {
        const double high = static_cast<double>(angles[i]);
        if (angle <= high)
            return high > low ? glm::mix(dvec3(colors[i]), dvec3(colors[i + 1]), (angle - low) / (high - low))
                              : dvec3(colors[i + 1]);
        low = high;
    }
    return dvec3(colors.back());
}

dvec4 skyAt(const SkyColors& sky, const dvec3& direction)
{
    const dvec3 up = glm::normalize(glm::inverse(sky.worldFromBackground) * direction);
    const double angle = std::acos(std::clamp(up.y, -1.0, 1.0));
    const double fromNadir = std::numbers::pi - angle;
    const bool ground = !sky.groundAngles.empty() && !sky.ground.empty() &&
                        fromNadir <= static_cast<double>(sky.groundAngles.back());
    const dvec3 color = ground ? colorAtAngle(sky.groundAngles, sky.ground, fromNadir)
                               : colorAtAngle(sky.skyAngles, sky.sky, angle);
    return dvec4(color, 1.0) * static_cast<double>(sky.opacity);
}

/// All that is seen on a ray, from the nearest.
std::vector<Seen> seenAlong(const StyledScene& scene, std::span<const PlacedSurface> placed,
                            const Sight& sight)
{
    std::vector<Seen> surfaces, all;
    for (const PlacedSurface& surface : placed)
        addSurface(surface, sight, surfaces);
    double opaque = sight.farthest;
    for (const Seen& seen : surfaces)
        if (seen.opacity >= 1.0) opaque = std::min(opaque, seen.depth);
    for (const StyledVolume& volume : scene.volumes)
        if (volume.surfaces)
            addSurfacesOfValues(volume, sight, all);
        else if (volume.projection)
            addProjection(volume, sight, opaque, all);
        else
            addSamples(volume, sight, opaque, all);
    all.insert(all.end(), surfaces.begin(), surfaces.end());
    std::stable_sort(all.begin(), all.end(), [](const Seen& a, const Seen& b) { return a.depth < b.depth; });
    return all;
}

} // namespace

std::vector<double> styledReference(const StyledScene& scene)
{
    std::vector<double> picture;
    const std::vector<PlacedSurface> surfaces(scene.surfaces.begin(), scene.surfaces.end());
    for (int y = 0; y < scene.height; ++y)
        for (int x = 0; x < scene.width; ++x) {
            const Sight sight = sightOfPixel(scene, x, y);
            dvec4 sum(0.0);
            for (const Seen& seen : seenAlong(scene, surfaces, sight))
                sum += (1.0 - sum.a) * seen.opacity * dvec4(seen.color, 1.0);
            sum += (1.0 - sum.a) * skyAt(scene.background, sight.world.perDepth);
            for (int channel = 0; channel < 4; ++channel)
                picture.push_back(sum[channel]);
        }
    return picture;
}

double psnr(std::span<const float> picture, const std::vector<double>& reference)
{
    if (picture.size() != reference.size()) return std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.size(); ++i)
        sum += std::pow(static_cast<double>(picture[i]) - reference[i], 2.0);
    return -10.0 * std::log10(sum / static_cast<double>(picture.size()));
}

} // namespace vo::test
