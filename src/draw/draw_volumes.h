#pragma once

#include "cast/clear_blocks.h"
#include "cast/segment_blocks.h"
#include "draw/hit_plan.h"
#include "draw/join_planes.h"
#include "draw/merge_projections.h"
#include "draw/ray_hits.h"
#include "draw/scene_resources.h"
#include "draw/scene_steps.h"
#include "draw/translucent_target.h"
#include "draw/volume_programs.h"
#include "polygonize/slice_occupied.h"
#include "style/styled_scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace vo {

class StackSlicer;

/// A volume of one picture, cut and sent to OpenGL; drawn layer by layer.
class DrawnVolume
{
public:
    explicit DrawnVolume(SceneResources& resources);

    /// Borrows all but the slicer until it is drawn.
    void prepare(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
                 VolumePlace place);
    const std::vector<SliceLayer>& layers() const { return layers_.layers; }
    /// Whether it is a projection that may have other things between or over its rays: it is not drawn, but
    /// kept for what draws such ones.
    bool isMerged() const { return isMerged_ && !layers_.layers.empty(); }
    /// Before anything is drawn into the target: what has one of its own.
    void drawApart(const TranslucentTarget& target);
    /// After that, of what isMerged().
    void keep(const TranslucentTarget& target, const ProjectionMerger& merger, std::size_t layer);
    /// Makes its program, textures and arrays, and the target with the depths or without, those that draw()
    /// uses.
    void use(const TranslucentTarget& target);
    void draw(const SceneStep& step);
    /// Of VolumePlace::betweenHits: draws what is there. At one depth it is behind sources of lesser numbers.
    void drawBetween(const RayHits& hits, float source, const TranslucentTarget& target);
    /// Of VolumePlace::ofHits: draws the next hits of a source into what is bound.
    void findHits(const RayHits& hits, std::size_t source, const TranslucentTarget& target);

private:
    bool isJoined() const { return way_ == VolumeWay::planeSamples; }
    int unitsOfPicture() const;
    int bindPicture(const TranslucentTarget& target, int unit);
    bool takesRays() const { return way_ == VolumeWay::rays || way_ == VolumeWay::projectedRays; }
    void fillChainTextures();
    ClearBlocks findClearBlocks();
    void keepClearBlocks(const ClearBlocks& clear);
    void cutSlices(const ClearBlocks& clear, StackSlicer& slicer);
    void sendSlices();
    void sendRays();
    void useProgram(const TranslucentTarget& target);
    void bindTextures(const TranslucentTarget& target);
    void bindSegments(const Segments& segments, int unit);
    void setView(SceneProgram& program) const;
    void setRays(SceneProgram& program) const;
    void drawSlice(std::size_t first, std::size_t count) const;
    void drawRays() const;

    SceneResources& resources_;
    SceneArrays arrays_;
    VolumeLayers layers_;
    VolumeProgram texts_;
    SceneProgram* program_ = nullptr;
    VolumeWay way_ = VolumeWay::slices;
    VolumeLayers planes_; ///< of samples that are joined
    std::unique_ptr<PlaneJoiner> joiner_;
    OccupiedSlicer occupiedSlicer_;
    std::optional<SegmentBlocks> segmentBlocks_;
    VoxelTexture chainTable_, chainRows_, stackedTables_, clearBlocks_;
    std::vector<std::uint64_t> tablesStacked_; ///< their serial numbers
    bool leaps_ = false, isMerged_ = false;
    RayReach part_ = RayReach::whole;
    const RayHits* hits_ = nullptr; ///< of parts of rays
    float source_ = 0.0f;
    const StyledScene* scene_ = nullptr;
    const StyledVolume* volume_ = nullptr;
};

/// Whether there is anything of it to draw.
bool isDrawn(const StyledVolume& volume);

} // namespace vo
