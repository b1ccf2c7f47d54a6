#pragma once

#include "cast/clear_blocks.h"
#include "cast/clear_values.h"
#include "cast/padded_voxels.h"
#include "cast/scene_rays.h"
#include "cast/scene_tetras.h"
#include "cast/segment_blocks.h"
#include "style/styled_scene.h"
#include "style/surface_normals.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace vo {

/// A chain of styles, and how far it goes without normals.
struct ChainPlan
{
    StyleChain chain; ///< effectiveChain()
    /// Styles at the front that read no normal: the opacity they leave decides which samples go on.
    std::size_t withoutNormals = 0;
    bool keepsClear = true;
    /// What firstColor() makes of a voxel is what the chain begins with.
    bool beginsWithVoxel = true;
    /// Samples whose voxel firstColor() makes clear are clear after the chain: of several components.
    bool keepsClearVoxels = true;
    bool needsPosition = false;

    explicit ChainPlan(const StyleChain& whole);
};

/// All that rays need of a volume; not changed while they walk.
struct CastVolume
{
    const StyledVolume* styled = nullptr;
    std::shared_ptr<const PaddedVoxels> voxels;
    glm::dmat4 localFromEye{1.0};
    glm::dmat4 edgesFromEye{1.0};      ///< localFromEye after the edgeShift(): where the faces are met
    std::vector<glm::dvec4> eyePlanes; ///< kept where dot(plane, p) >= 0, after the edgeShift()
    std::vector<ChainPlan> plans;      ///< of the volume's chains, or of its surfaces
    float shortestEdge = 1.0f;         ///< of a voxel, local
    std::optional<CastTetras> tetras;
    SurfaceNormals gradients{nullptr}; ///< of IsoSurfaces
    ClearValues clear;                 ///< samples of them are left out
    ClearBlocks blocks;                ///< that are leapt over; in a projection, after its first sample
    /// In a projection blocks are leapt over whose values change nothing any more.
    bool leapsByValue = false;

    /// Finds what is clear, once the voxels are there. `chainsIn`: SegmentBlocks::chainsIn(), or nothing.
    void findClear(std::span<const std::uint64_t> chainsIn);

    /// `voxels` and `tetras` are left to the caller. Borrows both.
    CastVolume(const StyledVolume& styled, const SceneRays& rays);

    /// Reads the components of the first `count` voxels.
    void read(int count, const BatchVectors& place, std::array<BatchFloats, 4>& voxel) const;

private:
    bool projectsVoxels() const;
};

/// False for volumes whose numbers make no sense, and for what rays do not draw (stipples).
bool isCast(const StyledVolume& volume);

} // namespace vo
