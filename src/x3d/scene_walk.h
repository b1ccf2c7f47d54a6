#pragma once

#include "style/styled_scene.h"
#include "x3d/styled_view.h"
#include "x3d/view_messages.h"

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <optional>
#include <vector>

namespace vo {

/// A node where it stands in the world, once for each place.
struct PlacedNode
{
    const Node* node = nullptr;
    glm::dmat4 worldFromLocal{1.0};
};

/// Viewpoints, NavigationInfos and Backgrounds in the order of the scene, each at its first place, also where
/// a Switch or a LOD does not show them.
std::vector<PlacedNode> bindableNodes(const Scene& scene);

/// A volume or a Shape that is shown, and what falls on it: lights in the world, and planes that cut it.
struct ShownNode
{
    const Node* node = nullptr;
    glm::dmat4 worldFromLocal{1.0};
    std::vector<const Node*> path; ///< from a root to itself
    std::vector<StyleLight> lights;
    std::vector<glm::dvec4> clipPlanes;
};

struct ShownNodes
{
    std::vector<ShownNode> nodes;
    std::vector<ShownLevel> levels;
};

/// What Switch, LOD, OctTree and `visible` leave of a scene. Without an eye (in the world), LODs show their
/// first child and OctTrees highRes. Scenes that are deeper or larger than anyone draws are cut off, with a
/// message.
ShownNodes shownNodes(const Scene& scene, const std::optional<glm::dvec3>& eye, ViewMessages& messages);

} // namespace vo
