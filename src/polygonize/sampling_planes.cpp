#include "polygonize/sampling_planes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A plane more or less for a rounding error: counts forgive this fraction of a step, and of an extent, since
/// periods are given in single precision.
constexpr double kForgiven = 1e-6;
/// A set seen farther aside than this (cosine of 80 degrees, relative to the middle of the view) does not set
/// the direction along which planes are counted.
constexpr double kAside = 0.17;

bool finite(const glm::dvec3& p)
{
    return std::isfinite(p.x + p.y + p.z);
}

DepthRange rangeOfTetra(const TetraView& tetras, int tetra, const glm::dvec3& normal)
{
    DepthRange range{kInfinity, -kInfinity};
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec3 p = tetras.position(
            tetras.indices[static_cast<std::size_t>(tetra) * 4 + static_cast<std::size_t>(corner)]);
        if (!finite(p)) continue;
        const double t = glm::dot(normal, p);
        range.nearest = std::min(range.nearest, t);
        range.farthest = std::max(range.farthest, t);
    }
    return range;
}

/// Of all vertices, which are fewer than corners, where the first and the last are some tetrahedron's.
std::optional<DepthRange> rangeOfVertices(const TetraView& tetras, const glm::dvec3& normal)
{
    const auto vertices =
        static_cast<int>(tetras.records.size() / static_cast<std::size_t>(tetras.valuesPerVertex));
    if (static_cast<std::size_t>(vertices) > tetras.indices.size()) return {};
    DepthRange range{kInfinity, -kInfinity};
    int nearest = 0, farthest = 0;
    for (int vertex = 0; vertex < vertices; ++vertex) {
        const glm::dvec3 p = tetras.position(vertex);
        const double t = glm::dot(normal, p);
        if (!(t < range.nearest || t > range.farthest) || !finite(p)) continue;
        if (t < range.nearest) nearest = vertex;
        if (t > range.farthest) farthest = vertex;
        range = {std::min(range.nearest, t), std::max(range.farthest, t)};
    }
    const auto belongs = [&](int vertex) {
        return std::ranges::find(tetras.indices, vertex) != tetras.indices.end();
    };
    if (range.empty() || !belongs(nearest) || !belongs(farthest)) return {};
    return range;
}

/// Depth of the view volume; empty when it has no end.
DepthRange rangeOfView(const Camera& camera, const SamplingAxis& axis)
{
    DepthRange range{kInfinity, -kInfinity};
    if (axis.axis >= 0) {
        for (const glm::dvec3& corner : camera.corners) {
            if (!finite(corner)) return {1.0, 0.0};
            const double t = glm::dot(axis.normal, corner);
            range = {std::min(range.nearest, t), std::max(range.farthest, t)};
        }
        return range;
    }
    const double scale = glm::length(axis.normal);
    const auto [low, high] = std::minmax({camera.nearDepth * scale, camera.farDepth * scale});
    return std::isfinite(low + high) ? DepthRange{low, high} : DepthRange{1.0, 0.0};
}

glm::dvec3 centreOfBox(const TetraView& tetras)
{
    Box box{glm::dvec3(kInfinity), glm::dvec3(-kInfinity)};
    for (const int vertex : tetras.indices) {
        const glm::dvec3 p = tetras.position(vertex);
        if (!finite(p)) continue;
        box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    }
    return 0.5 * (box.lower + box.upper); // NaN without vertices
}

/// The direction along which spacing is measured.
glm::dvec3 countingDirection(const TetraView& tetras, const Camera& camera)
{
    if (!camera.perspective) return camera.direction;
    const glm::dvec3 towards = camera.towards(centreOfBox(tetras));
    const double middle = glm::dot(camera.depthNormal, camera.direction);
    const bool ahead = glm::dot(camera.depthNormal, towards) > kAside * middle;
    return ahead ? towards : camera.direction;
}

/// Number of steps in an extent, as a double: it may exceed any integer.
double stepsIn(double extent, double step)
{
    const double steps = extent / step;
    return std::ceil(std::min(steps - kForgiven, steps * (1.0 - kForgiven)));
}

int clampedCount(double wanted, int maxSamples)
{
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(std::max(1, maxSamples))));
}

/// Planes at 1/2 + m * step for all integers m inside the range; the step grows to the multiple that fits.
PlaneFamily anchoredPlanes(const SamplingAxis& axis, const DepthRange& range, int maxSamples)
{
    PlaneFamily planes;
    planes.normal = axis.normal;
    if (range.empty()) return planes;
    const bool ascending = axis.normal[axis.axis] > 0.0; // along the axis, away from the viewer
    const double lower = (ascending ? range.nearest : -range.farthest) - 0.5;
    const double upper = (ascending ? range.farthest : -range.nearest) - 0.5;
    const double wanted = axis.step.value_or(1.0);
    const double most = std::max(1, maxSamples);

    double multiple = std::max(1.0, std::floor((upper - lower) / wanted / most));
    double lowest, highest;
    for (;; multiple = std::max(multiple + 1.0, std::nextafter(multiple, kInfinity))) {
        const double step = wanted * multiple;
        lowest = std::ceil((lower - kForgiven) / step);
        highest = std::floor((upper + kForgiven) / step);
        if (!(highest - lowest + 1.0 > most)) break;
    }
    planes.spacing = wanted * multiple;
    planes.first = ascending ? 0.5 + highest * planes.spacing : -(0.5 + lowest * planes.spacing);
    planes.count = static_cast<int>(std::max(0.0, highest - lowest + 1.0));
    return planes;
}

PlaneFamily planesInRange(const SamplingAxis& axis, const DepthRange& range, int maxSamples)
{
    return axis.anchored ? anchoredPlanes(axis, range, maxSamples) : centredPlanes(axis, range, maxSamples);
}

} // namespace

PlaneFamily centredPlanes(const SamplingAxis& axis, const DepthRange& range, int maxSamples)
{
    PlaneFamily planes;
    planes.normal = axis.normal;
    if (range.empty()) return planes;
    const double extent = range.farthest - range.nearest;
    const int count =
        axis.step ? clampedCount(stepsIn(extent, *axis.step), maxSamples) : std::max(1, maxSamples);
    const double spacing = extent / count;
    if (!(spacing > 0.0)) {
        planes.first = range.farthest;
        planes.spacing = axis.step.value_or(1.0);
        planes.count = 1;
        return planes;
    }
    planes.first = range.farthest - 0.5 * spacing;
    planes.spacing = spacing;
    planes.count = count;
    return planes;
}

PlaneFamily spanningPlanes(const SamplingAxis& axis, const DepthRange& range, int maxSamples)
{
    PlaneFamily planes;
    planes.normal = axis.normal;
    if (range.empty()) return planes;
    const double extent = range.farthest - range.nearest;
    planes.first = range.farthest;
    planes.count =
        axis.step ? clampedCount(stepsIn(extent, *axis.step) + 1.0, maxSamples) : std::max(1, maxSamples);
    planes.spacing = planes.count > 1 ? extent / (planes.count - 1) : extent;
    if (planes.spacing > 0.0) return planes;
    planes.spacing = axis.step.value_or(1.0);
    planes.count = 1;
    return planes;
}

int firstPlaneInFront(const PlaneFamily& planes, double nearest, double offset)
{
    const auto inFront = [&](int k) {
        const double plane = planes.offset(k);
        return plane > nearest ? offset >= plane : offset > plane;
    };
    const double guess = std::ceil((planes.first - offset) / planes.spacing);
    int k = guess > 0.0 ? static_cast<int>(std::min(guess, static_cast<double>(planes.count))) : 0;
    while (k > 0 && inFront(k - 1))
        --k;
    while (k < planes.count && !inFront(k))
        ++k;
    return k;
}

DepthRange rangeOfSet(const TetraView& tetras, const glm::dvec3& normal)
{
    if (const std::optional<DepthRange> range = rangeOfVertices(tetras, normal)) return *range;
    DepthRange range{kInfinity, -kInfinity};
    for (int tetra = 0; tetra < tetras.tetraCount(); ++tetra) {
        const DepthRange own = rangeOfTetra(tetras, tetra, normal);
        range.nearest = std::min(range.nearest, own.nearest);
        range.farthest = std::max(range.farthest, own.farthest);
    }
    return range;
}

int closestAxis(const Camera& camera)
{
    const glm::dvec3 size = glm::abs(camera.direction);
    const double longest = std::max({size.x, size.y, size.z});
    const double nearlyLongest = longest * (1.0 - 1e-9); // a tie but for rounding stays a tie
    for (int axis = 2; axis > 0; --axis)
        if (size[axis] >= nearlyLongest) return axis;
    return 0;
}

SamplingAxis samplingAxis(const TetraView& tetras, const Camera& camera, const SamplingRequest& request)
{
    SamplingAxis result;
    if (request.mode == SamplingMode::axisAligned) {
        result.axis = closestAxis(camera);
        result.anchored = request.stackAxis == result.axis;
        result.normal = glm::dvec3(0.0);
        result.normal[result.axis] = camera.direction[result.axis] < 0.0 ? -1.0 : 1.0;
        if (request.period) result.step = (*request.period)[result.axis];
    } else {
        const glm::dvec3 direction = countingDirection(tetras, camera);
        result.normal = camera.depthNormal / glm::dot(camera.depthNormal, direction);
        if (request.period) result.step = 1.0 / glm::length(direction / *request.period);
    }
    result.set = rangeOfSet(tetras, result.normal);
    return result;
}

PlaneFamily samplingPlanes(const TetraView& tetras, const SamplingAxis& axis, const Camera& camera,
                           const SamplingRequest& request)
{
    if (axis.set.empty()) return PlaneFamily{axis.normal};
    if (request.space == SamplingSpace::primitive) {
        int deepest = 0;
        double extent = -kInfinity;
        for (int tetra = 0; tetra < tetras.tetraCount(); ++tetra) {
            const DepthRange range = rangeOfTetra(tetras, tetra, axis.normal);
            if (range.farthest - range.nearest > extent) {
                extent = range.farthest - range.nearest;
                deepest = tetra;
            }
        }
        return primitivePlanes(tetras, deepest, axis, request);
    }
    if (request.space == SamplingSpace::viewVolume && !axis.anchored)
        return spanningPlanes(axis, rangeOfView(camera, axis), request.maxSamples);
    return planesInRange(axis, axis.set, request.maxSamples);
}

PlaneFamily samplingPlanes(const TetraView& tetras, const Camera& camera, const SamplingRequest& request)
{
    return samplingPlanes(tetras, samplingAxis(tetras, camera, request), camera, request);
}

PlaneFamily primitivePlanes(const TetraView& tetras, int tetra, const SamplingAxis& axis,
                            const SamplingRequest& request)
{
    return planesInRange(axis, rangeOfTetra(tetras, tetra, axis.normal), request.maxSamples);
}

PlaneFamily primitivePlanes(const TetraView& tetras, int tetra, const Camera& camera,
                            const SamplingRequest& request)
{
    return primitivePlanes(tetras, tetra, samplingAxis(tetras, camera, request), request);
}

} // namespace vo
