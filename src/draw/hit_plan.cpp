#include "draw/hit_plan.h"

#include "draw/seen_bounds.h"
#include "draw/volume_programs.h"
#include "style/styled_voxels.h"

#include <algorithm>
#include <array>

namespace vo {

namespace {

/// Each takes 32 bytes a pixel.
constexpr std::ptrdiff_t kMostSources = 8;
/// Rays stop at each; slabs are drawn once for all that are in them. Projections among slabs need no slices.
constexpr double kMostLayers = 64.0, kMostLayersOfProjections = 16.0;
/// Without volumes slabs are a few draws.
constexpr double kMostLayersOfFaces = 8.0;

/// Of the part that is in the picture.
double areaOf(const SeenBounds& bounds)
{
    const glm::dvec2 size = glm::min(bounds.upper, 1.0) - glm::max(bounds.lower, -1.0);
    return std::max(size.x, 0.0) * std::max(size.y, 0.0);
}

/// How many translucent triangles are one behind the other, on average over the part of the picture that they
/// are in. A triangle counts as half of the rectangle around it.
double translucentLayers(const StyledScene& scene)
{
    double covered = 0.0;
    SeenBounds all;
    for (const StyledSurface& surface : scene.surfaces) {
        if (!isSound(surface)) continue;
        for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
            if (surface.isOpaque(i)) continue;
            std::array<glm::vec3, 3> corners;
            for (std::size_t corner = 0; corner < 3; ++corner)
                corners[corner] = surface.positions[static_cast<std::size_t>(surface.triangles[i + corner])];
            const SeenBounds bounds = seenBounds(scene, surface.worldFromLocal, corners);
            if (!(areaOf(bounds) > 0.0)) continue;
            covered += 0.5 * areaOf(bounds);
            all.lower = glm::min(all.lower, bounds.lower);
            all.upper = glm::max(all.upper, bounds.upper);
        }
    }
    return covered > 0.0 ? covered / areaOf(all) : 0.0;
}

/// All between hits or of them; empty where that cannot be.
std::vector<VolumePlace> placesOnRays(const StyledScene& scene, std::span<const StyledVolume* const> volumes)
{
    std::vector<VolumePlace> places(volumes.size(), VolumePlace::ofHits);
    std::vector<SeenBounds> walked;
    const auto walk = [&](std::size_t i) {
        const SeenBounds bounds = seenBounds(scene, *volumes[i]);
        if (std::ranges::any_of(walked, [&](const SeenBounds& other) { return other.overlaps(bounds); }))
            return false;
        walked.push_back(bounds);
        places[i] = VolumePlace::betweenHits;
        return true;
    };
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        if (volumes[i]->tetras) return {};
        if (!volumes[i]->surfaces && !isProjected(*volumes[i]) && !walk(i)) return {};
    }
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (volumes[i]->surfaces) walk(i);
    const bool areProjected =
        std::ranges::any_of(volumes, [](const auto* volume) { return isProjected(*volume); });
    const bool isTooMuch = std::ranges::count(places, VolumePlace::ofHits) >= kMostSources ||
                           translucentLayers(scene) > (areProjected ? kMostLayersOfProjections : kMostLayers);
    return isTooMuch ? std::vector<VolumePlace>() : places;
}

} // namespace

std::vector<VolumePlace> volumePlaces(const StyledScene& scene, std::span<const StyledVolume* const> volumes)
{
    const std::vector<bool> alone = standingAlone(scene, volumes);
    std::vector<VolumePlace> places(volumes.size(), VolumePlace::alone);
    if (std::ranges::find(alone, false) == alone.end()) return places;
    if (std::vector<VolumePlace> onRays = placesOnRays(scene, volumes); !onRays.empty()) return onRays;
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (!alone[i]) places[i] = VolumePlace::among;
    return places;
}

bool facesHaveHits(const StyledScene& scene)
{
    const double layers = translucentLayers(scene);
    return layers > 0.0 && layers <= kMostLayersOfFaces;
}

std::vector<std::size_t> walkedNearestFirst(const StyledScene& scene,
                                            std::span<const StyledVolume* const> volumes,
                                            std::span<const VolumePlace> places)
{
    std::vector<std::size_t> walked;
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (places[i] == VolumePlace::betweenHits) walked.push_back(i);
    std::ranges::stable_sort(walked, {},
                             [&](std::size_t i) { return seenBounds(scene, *volumes[i]).nearest; });
    return walked;
}

} // namespace vo
