#pragma once

#include "cast/cast_volume.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace vo {

constexpr int kChunkSize = 16;

/// Where neighbouring sampling planes meet a ray, and the voxels there.
struct SampleChunk
{
    int count = 0;
    std::int64_t plane = 0; ///< of the first sample
    std::size_t piece = 0;  ///< of the path
    BatchVectors place;
    std::array<BatchFloats, 4> voxel;
};

/// The way of a ray through a volume: one piece in a box, several in tetrahedra.
class RayPath
{
public:
    struct Piece
    {
        RayPart depths;
        std::int64_t first = 0, last = -1; ///< sampling planes in it
        DepthRay place;
        int tetra = -1; ///< below 0: the box
    };

    explicit RayPath(const CastVolume& volume) : volume_(volume) {}

    /// Starts a ray of eye space; false if no sampling plane meets it in the volume within `depths`. `spans`:
    /// of the volume's tetrahedra.
    bool begin(const DepthRay& ray, RayPart depths, std::span<const TetraSpan> spans);
    /// The next samples, up to kChunkSize; false at the end.
    bool next(SampleChunk& chunk);

    double depthOf(std::int64_t plane) const
    {
        return sampleDepth(volume_.styled->spacing, static_cast<double>(plane));
    }
    const DepthRay& local() const { return local_; }
    const Piece& piece(std::size_t index) const { return pieces_[index]; }
    /// From now on blocks are leapt over that have no other values: of volumes that leapsByValue.
    void leapOver(const VoxelBlocks::Range& values) { idle_ = values; }
    /// Planes of those that were leapt over since this was asked.
    std::int64_t takeLeapt() { return std::exchange(leaptPlanes_, 0); }
    /// The piece that has a depth; nothing outside of the volume.
    const Piece* pieceAt(double depth) const;
    /// How long a sample is, in unit lengths.
    double unitsOfSample() const;

private:
    void addPiece(RayPart depths, const DepthRay& place, int tetra);
    void toPlanes();
    void leap();
    int samplesToLeap(const glm::vec3& cell, const glm::vec3& step) const;
    std::int64_t clearPlanes() const;
    void finishPiece();

    const CastVolume& volume_;
    DepthRay local_;
    std::vector<Piece> pieces_;
    std::size_t piece_ = 0;
    std::int64_t plane_ = 0;
    std::optional<VoxelBlocks::Range> idle_;
    std::int64_t leaptPlanes_ = 0;
    bool leapt_ = false;                    ///< plane_ is the last of those that were leapt over
    std::optional<std::int64_t> lastPlane_; ///< of the pieces added so far
};

} // namespace vo
