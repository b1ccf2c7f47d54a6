#pragma once

#include "cast/sample_padded.h"
#include "core/kept_array.h"
#include "style/sample_batch.h"
#include "style/voxel_texture.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vo {

/// What is in the cells of each block of PaddedVoxels, x fastest: values of one component, opacities (as
/// firstColor() says) of several.
struct VoxelBlocks
{
    struct Range
    {
        float low, high;
    };
    glm::ivec3 count{0};
    std::vector<Range> ranges;
};

/// One number a voxel, as the texture has it, with kPadding voxels more on all sides that say what is outside
/// (the edge again, or what repeats): neighbours are read without looking where the volume ends.
class PaddedVoxels
{
public:
    static constexpr int kPadding = PaddedGrid::kPadding;
    /// Edges of the blocks of cells whose range is known.
    static constexpr int kBlockShift = 3;

    /// Of a texture that isUsable(): its one component, or the mean of the first three (two components: the
    /// first). In up to `threads` threads. Throws std::bad_alloc.
    PaddedVoxels(const VoxelTexture& texture, int threads);
    PaddedVoxels(const PaddedVoxels&) = delete;

    /// The first `count` values at places (S, T, R), filtered as the texture says.
    void values(int count, const BatchVectors& place, BatchFloats& value) const
    {
        sampleValues(grid_, count, place, value);
    }
    /// How much the value changes along S, T and R: half of what it is a voxel farther less what it is a
    /// voxel before.
    void changes(int count, const BatchVectors& place, BatchVectors& change) const
    {
        sampleChanges(grid_, count, place, change);
    }

    const VoxelSize& size() const { return grid_.size; }
    const PaddedGrid& grid() const { return grid_; }
    /// The cell in which a place from 0 to 1 lies, and how far in it, without what repeats.
    glm::vec3 cellOf(const glm::vec3& place) const;
    /// None for textures that repeat.
    const VoxelBlocks& blocks() const { return blocks_; }
    std::size_t bytes() const { return memory_.size(); }

private:
    template <class T>
    void fill(const VoxelTexture& texture, int threads);
    template <class T>
    void findRangesOf(const VoxelTexture& texture, int threads);
    template <class T, class NumberAt>
    void findRanges(float unit, const NumberAt& numberAt, int threads);

    PaddedGrid grid_;
    KeptArray<std::byte> memory_;
    VoxelBlocks blocks_;
};

} // namespace vo
