#pragma once

#include "style/styled_scene.h"

#include <glm/vec2.hpp>

#include <cmath>
#include <span>
#include <vector>

namespace vo {

/// Where in a picture something may be seen: depths, and a rectangle in normalised device coordinates.
struct SeenBounds
{
    double nearest = INFINITY, farthest = -INFINITY;
    glm::dvec2 lower{1.0}, upper{-1.0};

    bool overlaps(const SeenBounds& other) const;
};

/// Of what lies between some points. All of the picture where one of them is behind the eye.
SeenBounds seenBounds(const StyledScene& scene, const glm::dmat4& worldFromLocal,
                      std::span<const glm::vec3> points);
SeenBounds seenBounds(const StyledScene& scene, const StyledVolume& volume);

/// For each volume of a list, whether no other one of them, nor a translucent surface, lies between parts of
/// it for some pixel.
std::vector<bool> standingAlone(const StyledScene& scene, std::span<const StyledVolume* const> volumes);

} // namespace vo
