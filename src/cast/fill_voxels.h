#pragma once

#include "cast/cast_request.h"
#include "cast/empty_blocks.h"
#include "cast/fill_tile.h"
#include "cast/grid_store.h"
#include "cast/shading_plan.h"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace vo {

/// The voxels of a request ready to be sampled and shaded: in one grid where bricks agree, else a grid for
/// each brick, and for bricks that make none as the caller holds them. Kept from frame to frame.
class FillVoxels
{
public:
    void startFrame(const CastRequest& request);

    /// As the request's bricks.
    std::span<const FillBrick> bricks() const { return bricks_; }
    std::span<const FillSampler> samplers() const { return samplers_; }
    /// FillFrame::entries.
    std::span<const float> entries() const { return entries_; }

    void forget(std::uint64_t brickId);
    std::size_t bytes() const;

private:
    void setSamplers(const CastRequest& request);
    void setBrick(const CastBrick& brick, const VoxelGrid* grid, int sampler);
    bool isCurrent(const CastRequest& request, const CastShading& shading) const;
    void shade(const CastRequest& request);
    void setEntries(const CastRequest& request);

    /// What the texels of a brick answer with.
    struct Kind
    {
        TexelFormat texel;
        bool classified;
        friend bool operator==(const Kind&, const Kind&) = default;
    };

    GridStore store_;
    std::vector<FillBrick> bricks_;
    std::vector<FillSampler> samplers_;
    std::vector<Kind> kinds_; ///< of the samplers
    std::vector<float> entries_;

    // What the last shading made of the samplers.
    bool shaded_ = false;
    std::uint64_t generation_ = 0;
    std::vector<const VoxelGrid*> shadedGrids_;
    std::vector<Kind> shadedKinds_;
    CastShading shading_; ///< `table_` for its table
    Table table_;
    CastBlending blending_ = CastBlending::over;
    std::vector<std::unique_ptr<ShadingPlan>> plans_;
    std::vector<std::size_t> planOfSampler_;
    std::vector<EmptyBlocks> blocks_;
};

} // namespace vo
