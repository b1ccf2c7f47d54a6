#include "style/seen_part.h"

#include "core/invertible.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vo {

namespace {

/// More are left out, so that the number of corners stays small.
constexpr std::size_t kMostClipPlanes = 12;

struct Extent
{
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

Extent extentOf(const StyledVolume& volume)
{
    const glm::dvec3 half = glm::dvec3(volume.dimensions) * 0.5;
    if (!volume.tetras) return {-half, half};
    Extent extent;
    for (const glm::vec3& position : volume.tetras->positions) {
        extent.low = glm::min(extent.low, glm::dvec3(position));
        extent.high = glm::max(extent.high, glm::dvec3(position));
    }
    return extent;
}

/// The box is a cube from 0 to 1 here, however thin it is in the world.
glm::dmat4 worldFromCube(const StyledVolume& volume)
{
    const Extent extent = extentOf(volume);
    return glm::scale(glm::translate(volume.worldFromLocal, extent.low), extent.high - extent.low);
}

/// Half-spaces dot(plane, p) >= 0, the normals of unit length; those without a normal cut nothing.
void addHalfSpace(const glm::dvec4& plane, std::vector<glm::dvec4>& all)
{
    const double length = glm::length(glm::dvec3(plane));
    if (length > 0.0 && std::isfinite(length)) all.push_back(plane / length);
}

std::vector<glm::dvec4> halfSpacesOf(const StyledScene& scene, const StyledVolume& volume,
                                     const glm::dmat4& worldFromBox)
{
    std::vector<glm::dvec4> all;
    const glm::dmat4 rows = glm::transpose(scene.clipFromEye * scene.eyeFromWorld * worldFromBox);
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec4 low(0.0);
        low[axis] = 1.0;
        addHalfSpace(low, all);
        addHalfSpace(glm::dvec4(0, 0, 0, 1) - low, all);
        addHalfSpace(rows[3] + rows[axis], all);
        addHalfSpace(rows[3] - rows[axis], all);
    }
    for (std::size_t i = 0; i < std::min(volume.clipPlanes.size(), kMostClipPlanes); ++i)
        addHalfSpace(volume.clipPlanes[i] * worldFromBox, all);
    return all;
}

/// Calls take for each corner of the body that half-spaces leave.
template <class Take>
void forCorners(const std::vector<glm::dvec4>& all, const Take& take)
{
    constexpr double kParallel = 1e-12, kOutside = -1e-9;
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b)
            for (std::size_t c = b + 1; c < all.size(); ++c) {
                const glm::dmat3 normals =
                    glm::transpose(glm::dmat3(glm::dvec3(all[a]), glm::dvec3(all[b]), glm::dvec3(all[c])));
                if (std::abs(glm::determinant(normals)) < kParallel) continue;
                const glm::dvec4 corner(glm::inverse(normals) * -glm::dvec3(all[a].w, all[b].w, all[c].w),
                                        1.0);
                if (std::ranges::all_of(
                        all, [&](const glm::dvec4& plane) { return glm::dot(plane, corner) >= kOutside; }))
                    take(corner);
            }
}

/// The way of a point of the picture over a unit of eye depth, in the world; -1 to 1 over the picture.
glm::dvec3 wayOf(const StyledScene& scene, double x, double y)
{
    const glm::dmat4 eyeFromClip = glm::inverse(scene.clipFromEye);
    const glm::dvec4 from = eyeFromClip * glm::dvec4(x, y, -1.0, 1.0);
    const glm::dvec4 to = eyeFromClip * glm::dvec4(x, y, 1.0, 1.0);
    const glm::dvec3 along = glm::dvec3(to) * from.w - glm::dvec3(from) * to.w;
    return glm::transpose(glm::dmat3(scene.eyeFromWorld)) * (along / -along.z);
}

/// Pairs of faces: a way crosses the whole distance between them dot(slab, way) times.
std::vector<glm::dvec3> slabsOf(const StyledVolume& volume, const glm::dmat4& boxFromWorld)
{
    constexpr double kFacing = -1.0 + 1e-9;
    std::vector<glm::dvec3> slabs;
    const glm::dmat3 rows = glm::transpose(glm::dmat3(boxFromWorld));
    for (int axis = 0; axis < 3; ++axis)
        slabs.push_back(rows[axis]);
    std::vector<glm::dvec4> cuts;
    for (std::size_t i = 0; i < std::min(volume.clipPlanes.size(), kMostClipPlanes); ++i)
        addHalfSpace(volume.clipPlanes[i], cuts);
    for (std::size_t a = 0; a < cuts.size(); ++a)
        for (std::size_t b = a + 1; b < cuts.size(); ++b) {
            const double width = cuts[a].w + cuts[b].w;
            const bool faceEachOther = glm::dot(glm::dvec3(cuts[a]), glm::dvec3(cuts[b])) < kFacing;
            if (faceEachOther && width > 0.0) slabs.push_back(glm::dvec3(cuts[a]) / width);
        }
    return slabs;
}

double crossingOf(const StyledScene& scene, const std::vector<glm::dvec3>& slabs)
{
    double most = 0.0;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) {
            const glm::dvec3 way = wayOf(scene, x, y);
            for (const glm::dvec3& slab : slabs)
                most = std::max(most, std::abs(glm::dot(slab, way)));
        }
    return 1.0 / most;
}

} // namespace

std::optional<SeenPart> seenPart(const StyledScene& scene, const StyledVolume& volume)
{
    const glm::dmat4 worldFromBox = worldFromCube(volume);
    if (!isInvertible(worldFromBox) || !isInvertible(scene.eyeFromWorld) || !isInvertible(scene.clipFromEye))
        return {};
    const glm::dvec4 depthRow = -glm::transpose(scene.eyeFromWorld * worldFromBox)[2];
    SeenPart part{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0};
    forCorners(halfSpacesOf(scene, volume, worldFromBox), [&](const glm::dvec4& corner) {
        const double depth = glm::dot(depthRow, corner);
        part.nearest = std::min(part.nearest, depth);
        part.farthest = std::max(part.farthest, depth);
    });
    if (!(part.nearest <= part.farthest)) return {};
    part.crossing = std::min(crossingOf(scene, slabsOf(volume, glm::inverse(worldFromBox))),
                             part.farthest - part.nearest);
    return part;
}

} // namespace vo
