#include "cast/fill_voxels.h"

#include "core/parallel.h"

#include <algorithm>

namespace vo {

namespace {

/// Of a colour of each vertex, the plan has nothing.
CastShading planShading(const CastRequest& request)
{
    CastShading shading = request.shading;
    if (request.layout.color >= 0) shading.color = glm::vec4(1.0f);
    return shading;
}

bool leavesBlocksOut(CastBlending blending)
{
    switch (blending) {
    case CastBlending::over:
    case CastBlending::premultiplied:
    case CastBlending::sum:
    case CastBlending::alphaSum: return true;
    case CastBlending::max:
    case CastBlending::min: break;
    }
    return false;
}

bool hasAlpha(TexelFormat texel, bool classified)
{
    switch (texel) {
    case TexelFormat::intensity:
    case TexelFormat::luminanceAlpha:
    case TexelFormat::rgba: return true;
    case TexelFormat::luminance:
    case TexelFormat::rgb: break;
    }
    return classified;
}

} // namespace

void FillVoxels::startFrame(const CastRequest& request)
{
    store_.startFrame();
    setSamplers(request);
    shade(request);
    setEntries(request);
}

void FillVoxels::setSamplers(const CastRequest& request)
{
    bricks_.clear();
    samplers_.clear();
    kinds_.clear();
    const auto add = [&](std::size_t brick, const VoxelGrid* grid) {
        FillSampler sampler;
        sampler.grid = grid;
        sampler.texels = request.bricks[brick].texels;
        kinds_.push_back({sampler.texels.texel, sampler.texels.classified != nullptr});
        sampler.keepsAlpha = request.shading.replace && !request.shading.table &&
                             !hasAlpha(kinds_.back().texel, kinds_.back().classified);
        samplers_.push_back(sampler);
    };
    const std::size_t count = request.bricks.size();
    const VoxelGrid* all = store_.gridOf(request, 0, count).grid.get();
    if (all) add(0, all);
    for (std::size_t i = 0; i < count; ++i) {
        if (!all) add(i, count == 1 ? nullptr : store_.gridOf(request, i, 1).grid.get());
        setBrick(request.bricks[i], samplers_.back().grid, static_cast<int>(samplers_.size()) - 1);
    }
}

void FillVoxels::setBrick(const CastBrick& brick, const VoxelGrid* grid, int sampler)
{
    FillBrick fill;
    fill.sampler = sampler;
    for (int axis = 0; axis < 3; ++axis) {
        if (grid) {
            const bool thin = grid->view().thinAxis == axis;
            fill.shift[axis] = grid->shift()[axis];
            fill.lower[axis] = thin ? 1.0 : 0.5;
            fill.upper[axis] = grid->size()[axis] + (thin ? 0.999 : 0.5);
        } else {
            fill.scale[axis] = static_cast<double>(brick.texels.size[axis]) / brick.size[axis];
            fill.shift[axis] = -static_cast<double>(brick.origin[axis]) * fill.scale[axis];
            fill.upper[axis] = brick.texels.size[axis];
        }
    }
    bricks_.push_back(fill);
}

bool FillVoxels::isCurrent(const CastRequest& request, const CastShading& shading) const
{
    return shaded_ && generation_ == store_.generation() && blending_ == request.blending &&
           shading_.color == shading.color && shading_.replace == shading.replace &&
           (shading_.table == nullptr) == (shading.table == nullptr) &&
           (!shading.table || table_ == *shading.table) && shadedKinds_ == kinds_ &&
           std::ranges::equal(samplers_, shadedGrids_, {}, &FillSampler::grid);
}

void FillVoxels::shade(const CastRequest& request)
{
    const CastShading shading = planShading(request);
    if (!isCurrent(request, shading)) {
        shaded_ = false;
        plans_.clear();
        planOfSampler_.clear();
        shadedGrids_.clear();
        std::vector<Kind> planKinds;
        for (std::size_t i = 0; i < samplers_.size(); ++i) {
            const auto found = std::ranges::find(planKinds, kinds_[i]);
            planOfSampler_.push_back(static_cast<std::size_t>(found - planKinds.begin()));
            shadedGrids_.push_back(samplers_[i].grid);
            if (found != planKinds.end()) continue;
            planKinds.push_back(kinds_[i]);
            plans_.push_back(
                std::make_unique<ShadingPlan>(shadingPlan(shading, kinds_[i].texel, kinds_[i].classified)));
        }
        shadedKinds_ = kinds_;
        shading_ = shading;
        if (shading.table) table_ = *shading.table;
        shading_.table = shading.table ? &table_ : nullptr;
        blending_ = request.blending;
        blocks_.resize(samplers_.size());
        if (leavesBlocksOut(blending_))
            parallelFor(samplers_.size(), request.threads, [&](std::size_t i) {
                if (samplers_[i].grid)
                    findEmptyBlocks(*samplers_[i].grid, *plans_[planOfSampler_[i]], blending_,
                                    request.threads, blocks_[i]);
            });
        generation_ = store_.generation();
        shaded_ = true;
    }
    for (std::size_t i = 0; i < samplers_.size(); ++i) {
        samplers_[i].plan = plans_[planOfSampler_[i]].get();
        const bool some = samplers_[i].grid && leavesBlocksOut(blending_) && !samplers_[i].keepsAlpha;
        samplers_[i].blockDistance = some ? blocks_[i].distance.data() : nullptr;
    }
}

void FillVoxels::setEntries(const CastRequest& request)
{
    entries_.clear();
    const bool alike = request.layout.color < 0 && !request.opacityGauge && plans_.size() == 1 &&
                       plans_.front()->table && plans_.front()->oneChannel;
    if (!alike) return;
    const ShadingPlan& plan = *plans_.front();
    for (std::size_t i = 0; i <= static_cast<std::size_t>(plan.last); ++i)
        for (const std::size_t part : {std::size_t{0}, std::size_t{1}})
            for (const std::vector<float>& column : plan.entries)
                entries_.push_back(column[2 * i + part]);
}

void FillVoxels::forget(std::uint64_t brickId)
{
    store_.forget(brickId);
}

std::size_t FillVoxels::bytes() const
{
    std::size_t bytes = store_.bytes();
    for (const EmptyBlocks& blocks : blocks_)
        bytes += blocks.distance.size();
    return bytes;
}

} // namespace vo
