#pragma once

#include "style/styled_scene.h"
#include "x3d/scene.h"
#include "x3d/voxel_files.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vo {

/// Where the eye is in the world (a rigid motion; it looks along -z), and what it sees.
struct ViewCamera
{
    glm::dmat4 eyeFromWorld{1.0};
    glm::dmat4 clipFromEye{1.0};
};

/// What a viewer asks of a scene.
struct ViewRequest
{
    int width = 512, height = 512;
    const Node* viewpoint = nullptr;  ///< nothing: the scene's first, or one from which all of it is seen
    std::optional<ViewCamera> camera; ///< in place of the viewpoint's own; lights and levels go by it
    bool headlight = true;            ///< if the scene's NavigationInfo has none against it
    /// Distance of sampling planes, in shortest edges of a voxel; nothing: usualSampling().
    std::optional<double> sampling;
};

/// What a LOD or an OctTree shows: the index of the child, 0 for highRes and 1 for lowRes.
struct ShownLevel
{
    const Node* node = nullptr;
    int level = 0;
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
    /// The nodes above it, a root of the scene first, and itself last (Inlines among them).
    std::vector<const Node*> pathOf(int id) const;
    /// Of all LODs and OctTrees of the styled scene that was made last, in the order of the scene.
    const std::vector<ShownLevel>& shownLevels() const;
    /// Viewpoints and OrthoViewpoints in the order of the scene.
    std::vector<const Node*> viewpoints() const;

private:
    friend void checkView(Scene& scene);
    SceneView(Scene& scene, VoxelReading reading);
    struct Private;
    std::unique_ptr<Private> d;
};

/// Adds the messages that a picture of the scene would: on what is not drawn, values that make no sense, and
/// limits. Of files of voxels only their sizes are looked at.
void checkView(Scene& scene);

} // namespace vo
