#include "polygonize/sampling_shells.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace vo {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.14159265358979323846;
/// Facets never span more than this, however large the error that they may have (radians, from their
/// middles).
constexpr double kWidestFacet = kPi / 6;
/// An eye so far away that it would take more is beyond what double precision can tell.
constexpr double kMostRings = 1 << 24;

bool finite(const glm::dvec3& p)
{
    return std::isfinite(p.x + p.y + p.z);
}

double squared(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

/// Squared distance from the origin to a segment.
double distanceToSegment(const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    const double length = squared(along);
    const double place = length > 0.0 ? std::clamp(-glm::dot(a, along) / length, 0.0, 1.0) : 0.0;
    return squared(a + place * along);
}

/// Squared distance from the origin to a triangle.
double distanceToTriangle(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const glm::dvec3 normal = glm::cross(b - a, c - a);
    const double size = squared(normal);
    const bool above = size > 0.0 && glm::dot(glm::cross(a, b), normal) >= 0.0 &&
                       glm::dot(glm::cross(b, c), normal) >= 0.0 && glm::dot(glm::cross(c, a), normal) >= 0.0;
    if (above) return glm::dot(normal, a) * glm::dot(normal, a) / size;
    return std::min({distanceToSegment(a, b), distanceToSegment(b, c), distanceToSegment(c, a)});
}

bool holdsOrigin(const std::array<glm::dvec3, 4>& p)
{
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 &a = p[(i + 1) % 4], &b = p[(i + 2) % 4], &c = p[(i + 3) % 4];
        const glm::dvec3 normal = glm::cross(b - a, c - a);
        const double inside = glm::dot(normal, p[i] - a);
        if (inside == 0.0 || glm::dot(normal, -a) * inside < 0.0) return false;
    }
    return true;
}

/// Near plane to the farthest corner of the view volume; empty when it has no end.
DepthRange rangeOfView(const Camera& camera, const ShellFamily& shells)
{
    DepthRange range{kInfinity, 0.0};
    for (const glm::dvec3& corner : camera.corners) {
        if (!finite(corner)) return {1.0, 0.0};
        range.farthest = std::max(range.farthest, glm::length((corner - shells.eye) / shells.scale));
    }
    // The plane in the scaled space; its distance is that of its nearest point, seen or not.
    const glm::dvec3 normal = camera.depthNormal * shells.scale;
    for (const double depth : {camera.nearDepth, camera.farDepth})
        range.nearest = std::min(range.nearest, std::abs(depth - glm::dot(camera.depthNormal, shells.eye)) /
                                                    glm::length(normal));
    return range;
}

glm::dvec3 centreOfSet(const TetraView& tetras)
{
    glm::dvec3 lower(kInfinity), upper(-kInfinity);
    for (const int vertex : tetras.indices) {
        const glm::dvec3 p = tetras.position(vertex);
        if (!finite(p)) continue;
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    return 0.5 * (lower + upper);
}

void setRadii(ShellFamily& shells, const PlaneFamily& spread)
{
    shells.first = spread.first;
    shells.spacing = spread.spacing;
    shells.count = spread.count;
}

SamplingAxis spreadRequest(const SamplingRequest& request)
{
    SamplingAxis spread;
    if (request.period) spread.step = 1.0; // the scale is the period
    return spread;
}

} // namespace

DepthRange shellRange(const TetraView& tetras, int tetra, const ShellFamily& shells)
{
    std::array<glm::dvec3, 4> p;
    DepthRange range{kInfinity, -kInfinity};
    for (std::size_t i = 0; i < 4; ++i) {
        p[i] = (tetras.position(tetras.indices[static_cast<std::size_t>(tetra) * 4 + i]) - shells.eye) /
               shells.scale;
        if (!finite(p[i])) return {kInfinity, -kInfinity};
        range.farthest = std::max(range.farthest, glm::length(p[i]));
    }
    if (holdsOrigin(p)) {
        range.nearest = 0.0;
        return range;
    }
    double nearest = kInfinity;
    for (std::size_t i = 0; i < 4; ++i)
        nearest = std::min(nearest, distanceToTriangle(p[(i + 1) % 4], p[(i + 2) % 4], p[(i + 3) % 4]));
    range.nearest = std::sqrt(nearest);
    return range;
}

ShellFamily samplingShells(const TetraView& tetras, const Camera& camera, const SamplingRequest& request)
{
    ShellFamily shells;
    shells.eye = camera.eye;
    if (request.period) shells.scale = *request.period;

    DepthRange set{kInfinity, -kInfinity}, deepest{0.0, -1.0};
    for (int tetra = 0; tetra < tetras.tetraCount(); ++tetra) {
        const DepthRange own = shellRange(tetras, tetra, shells);
        if (own.empty()) continue;
        set = {std::min(set.nearest, own.nearest), std::max(set.farthest, own.farthest)};
        if (own.farthest - own.nearest > deepest.farthest - deepest.nearest) deepest = own;
    }
    if (set.empty()) return shells;

    const glm::dvec3 middle = (centreOfSet(tetras) - shells.eye) / shells.scale;
    const glm::dvec3 view = glm::normalize(camera.direction / shells.scale);
    const glm::dvec3 u = glm::length(middle) > 1e-6 * set.farthest ? glm::normalize(middle) : view;
    const glm::dvec3 size = glm::abs(u);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 v = glm::normalize(glm::cross(other, u));
    shells.frame = glm::dmat3(u, v, glm::cross(u, v));

    if (request.space == SamplingSpace::primitive) return primitiveShells(shells, deepest, request);
    const SamplingAxis spread = spreadRequest(request);
    setRadii(shells, request.space == SamplingSpace::viewVolume
                         ? spanningPlanes(spread, rangeOfView(camera, shells), request.maxSamples)
                         : centredPlanes(spread, set, request.maxSamples));
    return shells;
}

ShellFamily primitiveShells(const ShellFamily& set, const DepthRange& range, const SamplingRequest& request)
{
    ShellFamily own = set;
    setRadii(own, centredPlanes(spreadRequest(request), range, request.maxSamples));
    return own;
}

/// With vertices at R = 2 r / (1 + cos a), where a is the angle from the middle of a facet to its corners,
/// facets reach from R down to R cos a: r (1 - cos a) / (1 + cos a) = r tan(a / 2)^2 on either side of r.
void ShellGrid::assign(const ShellFamily& shells, int k)
{
    shells_ = shells;
    const double radius = shells.radius(k);
    const double error = kChordError * shells.spacing / std::max(radius, 1e-300);
    const double reach = std::min(2.0 * std::atan(std::sqrt(error)), kWidestFacet);
    radius_ = 2.0 * radius / (1.0 + std::cos(reach));
    // At the equator, where facets are largest, cos(reach) = cos(half)^2.
    const double side = 2.0 * std::acos(std::sqrt(std::cos(reach)));
    rings_ = static_cast<int>(std::ceil(std::min(kPi / side, kMostRings)));
    sectors_ = static_cast<int>(std::ceil(std::min(2.0 * kPi / side, 2.0 * kMostRings)));
}

void ShellGrid::select(const Range& range)
{
    range_ = range;
    latitudes_.clear();
    for (int i = range.firstRing; i <= range.lastRing + 1; ++i) {
        const double angle = i * (kPi / rings_) - 0.5 * kPi;
        const bool pole = i == 0 || i == rings_; // one vertex
        latitudes_.push_back(pole ? Turn{0.0, i == 0 ? -1.0 : 1.0} : Turn{std::cos(angle), std::sin(angle)});
    }
    longitudes_.clear();
    for (int j = range.firstSector; j <= range.lastSector + 1; ++j) {
        const int once = (j % sectors_ + sectors_) % sectors_;
        const double angle = once * (2.0 * kPi / sectors_) - kPi;
        longitudes_.push_back({std::cos(angle), std::sin(angle)});
    }
}

glm::dvec3 ShellGrid::vertex(int ring, int sector) const
{
    const Turn& latitude = latitudes_[static_cast<std::size_t>(ring - range_.firstRing)];
    const Turn& longitude = longitudes_[static_cast<std::size_t>(sector - range_.firstSector)];
    const glm::dvec3 direction(latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine,
                               latitude.sine);
    return shells_.eye + shells_.scale * (radius_ * (shells_.frame * direction));
}

/// A facet whose lower edge is a chord reaches a little farther to the pole than its circles of latitude say:
/// a ring and a sector more on each side.
ShellGrid::Range ShellGrid::facetsInCone(const glm::dvec3& axis, double halfAngle) const
{
    const glm::dvec3 local = glm::transpose(shells_.frame) * axis;
    const double latitude = std::asin(std::clamp(local.z, -1.0, 1.0));
    const double ringsPerRadian = rings_ / kPi, sectorsPerRadian = sectors_ / (2.0 * kPi);
    Range range = allFacets();
    range.firstRing =
        std::max(0, static_cast<int>(std::floor((latitude - halfAngle + 0.5 * kPi) * ringsPerRadian)) - 1);
    range.lastRing = std::min(
        rings_ - 1, static_cast<int>(std::floor((latitude + halfAngle + 0.5 * kPi) * ringsPerRadian)) + 1);
    const double pole = std::sin(halfAngle) / std::cos(latitude);
    if (std::abs(latitude) + halfAngle >= 0.5 * kPi || !(pole < 1.0)) return range;
    const double longitude = std::atan2(local.y, local.x), half = std::asin(pole);
    const int first = static_cast<int>(std::floor((longitude - half + kPi) * sectorsPerRadian)) - 1;
    const int last = static_cast<int>(std::floor((longitude + half + kPi) * sectorsPerRadian)) + 1;
    if (last - first + 1 >= sectors_) return range;
    range.firstSector = first;
    range.lastSector = last;
    return range;
}

} // namespace vo
