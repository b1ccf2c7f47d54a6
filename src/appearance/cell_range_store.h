#pragma once

#include "appearance/cell_ranges.h"

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <utility>

namespace vo {

/// What the ranges of a brick's cells depend on. `id` stands for the brick as long as it lives, `version` for
/// its present voxels.
struct CellRangeKey
{
    std::uint64_t id = 0;
    std::uint64_t version = 0;
    VoxelComponent component = VoxelComponent::alpha;
    VoxelOrigin origin;
    friend bool operator==(const CellRangeKey&, const CellRangeKey&) = default;
};

/// Ranges of bricks: those asked for last, of one version of each brick and component.
class CellRangeStore
{
public:
    /// `mostBytes`: what is kept at most; what somebody else holds on to lives longer.
    explicit CellRangeStore(std::size_t mostBytes = std::size_t{64} << 20) : mostBytes_(mostBytes) {}

    /// nullptr where they are not kept.
    std::shared_ptr<const CellRanges> find(const CellRangeKey& key);
    /// Takes the place of another version's; lets go of what was asked for longest ago.
    void keep(const CellRangeKey& key, std::shared_ptr<const CellRanges> ranges);
    void forget(std::uint64_t id);
    std::size_t bytes() const { return bytes_; }

private:
    struct Kept
    {
        CellRangeKey key;
        std::shared_ptr<const CellRanges> ranges;

        std::size_t bytes() const;
    };
    using Place = std::pair<std::uint64_t, VoxelComponent>;

    void drop(const Place& place);

    std::size_t mostBytes_;
    std::size_t bytes_ = 0;
    std::list<Kept> kept_; ///< asked for last first
    std::map<Place, std::list<Kept>::iterator> places_;
};

} // namespace vo
