#pragma once

#include "style/shadow_textures.h"
#include "style/styled_scene.h"
#include "x3d/node_cameras.h"
#include "x3d/scene_walk.h"
#include "x3d/seen_values.h"
#include "x3d/volume_styles.h"

#include <map>
#include <optional>

namespace vo {

/// The box of a volume node, local; empty where it has no extent.
ViewBox volumeBox(const Node& node);

/// Makes volumes of volume nodes.
class VolumeNodes
{
public:
    /// Where sizes alone are read, volumes are not for drawing: making them gives the messages.
    VolumeNodes(const Scene& scene, ViewMessages& messages, VoxelReading reading)
        : scene_(scene), messages_(messages), reading_(reading), textures_(scene, messages, reading),
          styles_(textures_, messages)
    {
    }

    /// Nothing where nothing of it is drawn. Lights are those that the node was found with; sampling planes
    /// go by the size and the matrices of the scene (plane_spacing.h).
    std::optional<StyledVolume> of(const ShownNode& shown, const StyledScene& scene,
                                   const std::optional<double>& sampling);

private:
    struct SurfaceValue
    {
        float value;
        std::size_t style; ///< its number
    };

    bool fill(const Node& node, StyledVolume& volume);
    std::shared_ptr<const VoxelTexture> voxelsOf(const Node& node, const char* field);
    bool fillPlain(const Node& node, StyledVolume& volume);
    bool fillSegmented(const Node& node, StyledVolume& volume);
    bool fillSurfaces(const Node& node, StyledVolume& volume);
    bool takeSegmentedVoxels(const Node& node, StyledVolume& volume, Segments& segments);
    bool takeIdentifiers(const Node& node, StyledVolume& volume, Segments& segments);
    bool addFirstSegment(const Node& node, StyledVolume& volume);
    int addSegmentChain(const Node* style, const Node& node, StyledVolume& volume);
    std::vector<SurfaceValue> surfaceValues(const Node& node, const VoxelTexture& voxels);
    void addContours(const Node& node, double step, const VoxelRange& range,
                     std::vector<SurfaceValue>& surfaces);
    void light(const ShownNode& shown, StyledVolume& volume);
    void tellIfEmpty(const Node& node, const StyledVolume& volume);

    const Scene& scene_;
    ViewMessages& messages_;
    VoxelReading reading_;
    VoxelTextures textures_;
    VolumeStyles styles_;
    ShadowStore shadows_;
    VoxelRanges ranges_;
};

} // namespace vo
