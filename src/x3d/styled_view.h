#pragma once

#include "style/styled_scene.h"
#include "x3d/scene.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vo {

/// What a viewer asks of a scene.
struct ViewRequest
{
    int width = 512, height = 512;
    const Node* viewpoint = nullptr; ///< nothing: the scene's first, or one from which all of it is seen
    bool headlight = true;           ///< if the scene's NavigationInfo has none against it
};

/// Makes of a scene what engines draw. What cannot be drawn becomes a message of the scene, once.
class SceneView
{
public:
    explicit SceneView(Scene& scene);
    ~SceneView();
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    StyledScene styledScene(const ViewRequest& request);
    /// The node that has this id in the styled scene that was made last.
    const Node* nodeOf(int id) const;
    /// Viewpoints and OrthoViewpoints in the order of the scene.
    std::vector<const Node*> viewpoints() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
