#pragma once

#include "cast/sample_ramps.h"
#include "draw/compositing_state.h"
#include "draw/context_record.h"
#include "draw/draw_state.h"

#include <cstdint>
#include <memory>
#include <span>

namespace vo {

/// Distances between cells in which something is seen, for skipping those where nothing is.
struct CellDistances
{
    int side = 0; ///< of a cell, voxels
    VoxelSize count;
    std::span<const std::uint8_t> distance; ///< in cells, x fastest; at most 255
    std::uint64_t serial = 0;               ///< others have another
};

/// What of a frame one brick draws.
struct MarchedBrick
{
    Box box;                                     ///< its part of the volume, voxels
    std::array<bool, 3> upperBelongsElsewhere{}; ///< samples in the upper face are those of another brick
    glm::dvec3 origin{0.0}, size{1.0};           ///< of the texture
};

/// Draws all samples of a pixel in one fragment: a loop over sampling planes, front to back, that ends where
/// nothing more shows through and blends once. The result is that of polygons drawn one by one, but for the
/// rounding of framebuffers in between. For states that readCompositingState() accepts without a depth test,
/// with blending over or alphaSum.
class SampleMarch
{
public:
    /// Whether there are bounds enough.
    static bool canBound(const SampleRamps& ramps);

    /// Everything is borrowed for the march's life. What lies in empty cells is left out: fragments without
    /// opacity change nothing.
    SampleMarch(ContextRecord& context, const DrawState& draw, const CompositingState& state,
                const SampleRamps& ramps, const CellDistances& cells);
    ~SampleMarch();
    SampleMarch(const SampleMarch&) = delete;
    SampleMarch& operator=(const SampleMarch&) = delete;

    /// One brick, the texture of which is bound to the active unit, that of draw.voxelUnit. Bricks go from
    /// back to front. `pixels` holds those that see it.
    void draw(const DrawState& draw, const MarchedBrick& brick, const PixelRectangle& pixels);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
