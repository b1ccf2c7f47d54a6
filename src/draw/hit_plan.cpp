#include "draw/hit_plan.h"

#include "draw/seen_bounds.h"
#include "draw/volume_programs.h"

#include <algorithm>

namespace vo {

namespace {

/// Each takes 32 bytes a pixel.
constexpr std::ptrdiff_t kMostSources = 8;

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
        if (volumes[i]->tetras || isProjected(*volumes[i])) return {};
        if (!volumes[i]->surfaces && !walk(i)) return {};
    }
    for (std::size_t i = 0; i < volumes.size(); ++i)
        if (volumes[i]->surfaces) walk(i);
    return std::ranges::count(places, VolumePlace::ofHits) < kMostSources ? places
                                                                          : std::vector<VolumePlace>();
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
