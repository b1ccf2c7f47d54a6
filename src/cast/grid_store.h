#pragma once

#include "cast/cast_request.h"
#include "cast/voxel_grid.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace vo {

/// A grid, or why bricks make none.
struct StoredGrid
{
    std::unique_ptr<VoxelGrid> grid;
    std::string refusal;
    std::uint64_t serial = 0; ///< no other grid ever has it
};

/// The grids of bricks that were asked for last, and which bricks make none.
class GridStore
{
public:
    /// The voxels of some bricks of a request, in one grid. Valid until `startFrame` or `forget`.
    const StoredGrid& gridOf(const CastRequest& request, std::size_t firstBrick, std::size_t count);

    bool holds(std::uint64_t serial) const;

    /// Lets go of what was not asked for lately and does not fit into the bound on memory.
    void startFrame();
    void forget(std::uint64_t brickId);
    std::size_t bytes() const;
    /// Changes whenever a grid is made or let go of.
    std::uint64_t generation() const { return generation_; }

private:
    /// What the voxels of a brick in a grid depend on.
    struct Part
    {
        std::uint64_t id, version, tableSerial;
        glm::vec3 origin, size;
        glm::dvec3 lower, upper; ///< of the clip box
        int thinAxis;
        TexelFormat texel;
        VoxelFormat format;
        bool classified;
        friend bool operator==(const Part&, const Part&) = default;
    };
    struct Kept
    {
        std::vector<Part> parts;
        StoredGrid stored;
        std::uint64_t lastFrame = 0;

        std::size_t bytes() const
        {
            return parts.size() * sizeof(Part) + (stored.grid ? stored.grid->bytes() : 0);
        }
    };

    std::unordered_multimap<std::uint64_t, Kept> grids_; ///< by a number made of the parts
    std::uint64_t frame_ = 0;
    std::uint64_t generation_ = 0;
};

} // namespace vo
