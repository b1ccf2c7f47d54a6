#include "appearance/cell_range_store.h"

namespace vo {

std::size_t CellRangeStore::Kept::bytes() const
{
    return sizeof(Kept) + sizeof(CellRanges) + ranges->ranges.size() * sizeof(ValueRange);
}

std::shared_ptr<const CellRanges> CellRangeStore::find(const CellRangeKey& key)
{
    const auto found = places_.find({key.id, key.component});
    if (found == places_.end() || found->second->key != key) return nullptr;
    kept_.splice(kept_.begin(), kept_, found->second);
    return found->second->ranges;
}

void CellRangeStore::keep(const CellRangeKey& key, std::shared_ptr<const CellRanges> ranges)
{
    const Place place(key.id, key.component);
    drop(place);
    kept_.push_front({key, std::move(ranges)});
    places_[place] = kept_.begin();
    bytes_ += kept_.front().bytes();
    while (bytes_ > mostBytes_)
        drop({kept_.back().key.id, kept_.back().key.component});
}

void CellRangeStore::forget(std::uint64_t id)
{
    drop({id, VoxelComponent::red});
    drop({id, VoxelComponent::alpha});
}

void CellRangeStore::drop(const Place& place)
{
    const auto found = places_.find(place);
    if (found == places_.end()) return;
    bytes_ -= found->second->bytes();
    kept_.erase(found->second);
    places_.erase(found);
}

} // namespace vo
