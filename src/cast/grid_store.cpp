#include "cast/grid_store.h"

#include "core/serial.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <new>
#include <string>
#include <utility>

namespace vo {

namespace {

/// Of grids that are not in use.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

} // namespace

const StoredGrid& GridStore::gridOf(const CastRequest& request, std::size_t firstBrick, std::size_t count)
{
    assert(request.bricks.size() == request.clipBoxes.size() && count >= 1);
    const auto bricks = request.bricks.subspan(firstBrick, count);
    const auto boxes = request.clipBoxes.subspan(firstBrick, count);
    std::vector<Part> parts;
    std::uint64_t number = count;
    for (std::size_t i = 0; i < count; ++i) {
        const CastBrick& brick = bricks[i];
        parts.push_back({brick.id, brick.version, brick.tableSerial, brick.origin, brick.size, boxes[i].lower,
                         boxes[i].upper, brick.thinAxis, brick.texels.texel, brick.texels.format,
                         brick.texels.classified != nullptr});
        number = number * 0x9e3779b97f4a7c15u + brick.id;
    }
    const auto [first, last] = grids_.equal_range(number);
    const auto found =
        std::find_if(first, last, [&](const auto& entry) { return entry.second.parts == parts; });
    if (found != last) {
        found->second.lastFrame = frame_;
        return found->second.stored;
    }
    StoredGrid stored{nullptr, "", newSerial()};
    try {
        stored.grid = std::make_unique<VoxelGrid>(bricks, boxes, request.threads, stored.refusal);
    } catch (const std::bad_alloc&) {
        stored.refusal = "no memory for the voxels";
    }
    if (!stored.refusal.empty()) stored.grid.reset();
    ++generation_;
    return grids_.emplace(number, Kept{std::move(parts), std::move(stored), frame_})->second.stored;
}

bool GridStore::holds(std::uint64_t serial) const
{
    return std::ranges::any_of(grids_,
                               [&](const auto& entry) { return entry.second.stored.serial == serial; });
}

void GridStore::startFrame()
{
    std::vector<std::pair<std::uint64_t, decltype(grids_)::iterator>> byAge;
    for (auto i = grids_.begin(); i != grids_.end(); ++i)
        if (i->second.lastFrame != frame_) byAge.emplace_back(i->second.lastFrame, i);
    std::ranges::sort(byAge, std::greater(), [](const auto& entry) { return entry.first; });
    std::size_t sum = 0;
    for (const auto& [age, entry] : byAge) {
        sum += entry->second.bytes();
        if (sum <= kMostBytes) continue;
        grids_.erase(entry);
        ++generation_;
    }
    ++frame_;
}

void GridStore::forget(std::uint64_t brickId)
{
    ++generation_;
    std::erase_if(grids_, [&](const auto& entry) {
        return std::ranges::any_of(entry.second.parts, [&](const Part& part) { return part.id == brickId; });
    });
}

std::size_t GridStore::bytes() const
{
    std::size_t bytes = 0;
    for (const auto& [number, kept] : grids_)
        bytes += kept.bytes();
    return bytes;
}

} // namespace vo
