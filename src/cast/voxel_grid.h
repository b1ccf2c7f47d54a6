#pragma once

#include "cast/cast_request.h"
#include "core/kept_array.h"
#include "core/volume_size.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace vo {

/// How a cell's numbers lie in memory. bytes: 16 bits, the voxel (low) and its neighbour in +y (high).
/// shorts: 32 bits, likewise. floats: 1 or 4 numbers, interleaved.
enum class GridKind { bytes, shorts, floats };

/// What a sampler answers for a byte of 1: fixed-point numbers of 15 bits.
constexpr float kByteRaw = 128.0f;

/// Edges of the blocks of cells whose range is known.
constexpr int kBlockShift = 2;
constexpr int kBlockCells = 1 << kBlockShift;

/// What a sampler needs of a grid. Grid coordinates: voxel (i, j, k) of the grid has its centre at (i + 1,
/// j + 1, k + 1); voxels repeat outwards by one at each face, so that all of [0.5, size + 0.5] can be read.
/// On the thin axis voxel i spans [i + 1, i + 2] and is not interpolated.
struct GridView
{
    GridKind kind = GridKind::bytes;
    int channels = 1; ///< 1 or 4
    const std::byte* cells = nullptr;
    std::uint32_t rowPitch = 0; ///< cells; x is next to x
    std::uint32_t slicePitch = 0;
    std::uint32_t lastCell = 0; ///< the last whose neighbours in +x, +y and +z are there
    int thinAxis = -1;
    /// A sampler's answer that stands for 1: bytes are 128 each, the others as they are stored.
    float rawUnit = 1.0f;
};

/// The voxels of bricks that agree where they overlap, in one grid.
class VoxelGrid
{
public:
    /// Rearranges voxels in up to `threads` threads. Leaves `refusal` empty, or says there why these bricks
    /// make no grid (then the grid is empty). Throws std::bad_alloc.
    VoxelGrid(std::span<const CastBrick> bricks, std::span<const Box> clipBoxes, int threads,
              std::string& refusal);

    const GridView& view() const { return view_; }
    const VoxelSize& size() const { return size_; }
    /// Grid coordinate less voxel coordinate.
    glm::dvec3 shift() const;

    /// Blocks of kBlockCells^3 cells, x fastest.
    const glm::ivec3& blockCount() const { return blockCount_; }
    /// Of the samples in each block, as a sampler answers: for each channel the lowest and the highest.
    std::span<const float> blockRanges() const { return ranges_; }
    std::size_t bytes() const { return memory_.size() + ranges_.size() * sizeof(float); }

private:
    bool place(std::span<const CastBrick> bricks, std::span<const Box> clipBoxes, std::string& refusal);
    bool chooseKind(const CastBrick& brick, std::string& refusal);
    template <class T>
    bool fill(std::span<const CastBrick> bricks, int threads);
    template <class T>
    void findRanges(int threads);

    GridView view_;
    VoxelOrigin lower_;
    VoxelSize size_;
    glm::ivec3 blockCount_{0};
    KeptArray<std::byte> memory_;
    std::vector<float> ranges_;
};

} // namespace vo
