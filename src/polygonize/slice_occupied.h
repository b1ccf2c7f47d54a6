#pragma once

#include "core/box.h"
#include "core/volume_size.h"
#include "polygonize/box_lattice.h"
#include "polygonize/sampling_planes.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Cubic cells of a volume, with those marked in which something may be seen: cell c spans [c, c + 1] * side
/// on each axis.
struct OccupiedCells
{
    int side = 8; ///< voxels
    VoxelSize count;
    std::vector<std::uint8_t> occupied; ///< 0 or 1, x fastest
};

/// Triangles of sampling planes, in runs that lie in one brick each, in each from the farthest plane to the
/// nearest.
struct OccupiedSlices
{
    struct Run
    {
        int brick;
        std::size_t first; ///< of the indices
        std::size_t count;
    };

    std::vector<float> positions; ///< three a vertex
    std::vector<std::uint32_t> indices;
    std::vector<Run> runs;

    double area = 0.0;      ///< of all triangles, voxels squared
    double perimeter = 0.0; ///< of all triangles, voxels
    double wholeArea = 0.0; ///< of the planes, if nothing were left out
};

/// Slices a box of voxels where its cells are occupied. Within a plane, rectangles over the two axes that the
/// plane faces least steeply cover the occupied cells; an edge that two of them share has the same vertices
/// on both sides, bit for bit, so that no pixel is drawn twice or left out. Edges elsewhere lie in empty
/// cells. Bricks part them as polygonize() does.
class OccupiedSlicer
{
public:
    /// Of `domain` cut to `clipBoxes`; run.brick is a number of these. False: the boxes are no lattice that
    /// fills its bounds, and `slices` means nothing.
    bool slice(const Box& domain, std::span<const Box> clipBoxes, const OccupiedCells& cells,
               const PlaneFamily& planes, OccupiedSlices& slices);

private:
    /// Coordinates between which rectangles lie along one axis.
    struct Breaks
    {
        std::vector<double> at;
        std::vector<int> interval; ///< of the bricks, that the piece after it lies in
        bool startsBrick(std::size_t i) const { return i > 0 && interval[i] != interval[i - 1]; }
        std::size_t pieces() const { return interval.size(); }
    };
    /// Pieces from `first` to before `end` along v.
    struct Stretch
    {
        std::size_t first;
        std::size_t end;
        friend bool operator==(const Stretch&, const Stretch&) = default;
    };
    /// Consecutive rows with the same stretches.
    struct Band
    {
        std::size_t first;
        std::size_t end;
        std::vector<Stretch> stretches;
    };
    struct Corner
    {
        double u, v, w;
    };

    bool findBounds(const Box& domain);
    Breaks breaksAlong(int axis, int step, double leastGap) const;
    void countOccupied(const OccupiedCells& cells);
    bool isOccupied(std::size_t row, std::size_t column, double low, double high) const;
    void findStretches(std::size_t row, std::vector<Stretch>& stretches) const;
    void findBands();
    void slicePlane();
    void sliceRectangle(const Band& band, const Stretch& stretch, const Band* below, const Band* above);
    void appendInserts(const Band* neighbour, double u, const Stretch& stretch, bool backwards);
    double depthAt(double u, double v) const;
    void clipDepth(double face, bool keepAbove, const std::vector<Corner>& in,
                   std::vector<Corner>& out) const;
    void emit(const std::vector<Corner>& polygon, std::size_t row, std::size_t column, int interval);
    void measure(const PlaneFamily& planes);
    std::uint32_t appendMiddle(std::span<const std::uint32_t> vertices);

    BoxLattice lattice_;
    int u_ = 0, v_ = 1, w_ = 2; ///< axes; planes are most perpendicular to w
    glm::dvec3 lower_{0.0}, upper_{0.0};
    Breaks rows_, columns_;
    int cellSide_ = 8;
    int cellsAlong_ = 0; ///< w
    std::vector<std::uint32_t>
        occupied_; ///< by row and column: how many cells along w before one are occupied

    double offset_ = 0.0; ///< of the plane at hand
    glm::dvec3 normal_{0.0};
    std::vector<Band> bands_;
    std::size_t bandCount_ = 0;
    std::vector<Stretch> stretches_;
    std::vector<Corner> outline_, cut_, part_;
    std::vector<std::uint32_t> vertices_;
    std::vector<std::vector<std::uint32_t>> indices_; ///< by brick
    OccupiedSlices* slices_ = nullptr;
};

} // namespace vo
