#pragma once

#include "draw/opaque_depths.h"
#include "draw/scene_resources.h"
#include "draw/volume_layers.h"
#include "draw/volume_programs.h"
#include "style/styled_scene.h"

#include <memory>
#include <vector>

namespace vo {

class StackSlicer;

/// A volume of one picture, cut and sent to OpenGL; drawn layer by layer.
class DrawnVolume
{
public:
    explicit DrawnVolume(SceneResources& resources);

    /// Borrows all but the slicer until it is drawn. `opaqueDepths`: where rays of a projection end, if
    /// anywhere.
    void prepare(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
                 const OpaqueDepths* opaqueDepths);
    const std::vector<SliceLayer>& layers() const { return layers_.layers; }
    /// Makes its program, textures and arrays those that draw() uses.
    void use();
    void draw(std::size_t first, std::size_t count) const;

private:
    void sendSlices();
    void bindTextures();
    void bindSegments(const Segments& segments, int unit);
    void setView(SceneProgram& program) const;
    void setRays(SceneProgram& program) const;

    SceneResources& resources_;
    SceneArrays arrays_;
    VolumeLayers layers_;
    VolumeProgram texts_;
    SceneProgram* program_ = nullptr;
    VoxelTexture chainTable_;
    const StyledScene* scene_ = nullptr;
    const StyledVolume* volume_ = nullptr;
    const OpaqueDepths* opaqueDepths_ = nullptr;
};

/// Whether there is anything of it to draw.
bool isDrawn(const StyledVolume& volume);

} // namespace vo
