#include "draw/seen_bounds.h"

#include "style/styled_voxels.h"

#include <algorithm>
#include <array>

namespace vo {

namespace {

constexpr double kLeastW = 1e-6;

void addPoint(const glm::dvec4& eye, const glm::dvec4& clip, SeenBounds& bounds)
{
    bounds.nearest = std::min(bounds.nearest, -eye.z);
    bounds.farthest = std::max(bounds.farthest, -eye.z);
    const bool isBehind = !(clip.w > kLeastW);
    const glm::dvec2 device = glm::dvec2(clip) / clip.w;
    bounds.lower = isBehind ? glm::dvec2(-1.0) : glm::min(bounds.lower, device);
    bounds.upper = isBehind ? glm::dvec2(1.0) : glm::max(bounds.upper, device);
}

/// One of the two is in front of the other, or beside it.
bool areApart(double lower, double upper, double otherLower, double otherUpper)
{
    return upper < otherLower || otherUpper < lower;
}

bool showsThrough(const StyledSurface& surface)
{
    if (!isSound(surface)) return false;
    for (std::size_t first = 0; first + 2 < surface.triangles.size(); first += 3)
        if (!surface.isOpaque(first)) return true;
    return false;
}

} // namespace

bool SeenBounds::overlaps(const SeenBounds& other) const
{
    return !areApart(nearest, farthest, other.nearest, other.farthest) &&
           !areApart(lower.x, upper.x, other.lower.x, other.upper.x) &&
           !areApart(lower.y, upper.y, other.lower.y, other.upper.y);
}

SeenBounds seenBounds(const StyledScene& scene, const glm::dmat4& worldFromLocal,
                      std::span<const glm::vec3> points)
{
    const glm::dmat4 eyeFromLocal = scene.eyeFromWorld * worldFromLocal;
    SeenBounds bounds;
    for (const glm::vec3& point : points) {
        const glm::dvec4 eye = eyeFromLocal * glm::dvec4(glm::dvec3(point), 1.0);
        addPoint(eye, scene.clipFromEye * eye, bounds);
    }
    return bounds;
}

SeenBounds seenBounds(const StyledScene& scene, const StyledVolume& volume)
{
    if (volume.tetras) return seenBounds(scene, volume.worldFromLocal, volume.tetras->positions);
    std::array<glm::vec3, 8> corners;
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = volume.dimensions * (glm::vec3(i & 1, i >> 1 & 1, i >> 2) - 0.5f);
    return seenBounds(scene, volume.worldFromLocal, corners);
}

std::vector<bool> standingAlone(const StyledScene& scene, std::span<const StyledVolume* const> volumes)
{
    std::vector<SeenBounds> all;
    for (const StyledVolume* const volume : volumes)
        all.push_back(seenBounds(scene, *volume));
    for (const StyledSurface& surface : scene.surfaces)
        if (showsThrough(surface))
            all.push_back(seenBounds(scene, surface.worldFromLocal, surface.positions));
    std::vector<bool> alone;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        bool isAlone = true;
        for (std::size_t k = 0; k < all.size() && isAlone; ++k)
            isAlone = k == i || !all[i].overlaps(all[k]);
        alone.push_back(isAlone);
    }
    return alone;
}

} // namespace vo
