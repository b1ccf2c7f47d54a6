#pragma once

#include "x3d/scene_walk.h"
#include "x3d/styled_view.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <limits>
#include <vector>

namespace vo {

/// A box along the axes; nothing is in it at first.
struct ViewBox
{
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    bool isEmpty() const { return !(low.x <= high.x); }
    void add(const glm::dvec3& point);
    /// What a box of another space is in this one.
    void add(const ViewBox& box, const glm::dmat4& matrix);
};

/// The eye of a Viewpoint or OrthoViewpoint; of none, at the origin.
glm::dmat4 eyeFromWorldOf(const PlacedNode& viewpoint);

/// The eye moved along its line of sight and across it, until all of the box is seen.
glm::dmat4 eyeThatSeesAll(const PlacedNode& viewpoint, const glm::dmat4& eyeFromWorld, const ViewBox& world,
                          int width, int height);

/// The projection of a viewpoint (none: a Viewpoint with the default angle), its near and far planes as the
/// boxes in eye space, one of each node, ask for if the viewpoint has none.
glm::dmat4 clipFromEyeOf(const PlacedNode& viewpoint, const std::vector<ViewBox>& eyeBoxes, int width,
                         int height);

} // namespace vo
