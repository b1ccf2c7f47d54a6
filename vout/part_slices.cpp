#include "vout/part_slices.h"

namespace vo {

void PartSlices::fit(int bricks, int planes, int values)
{
    const auto brickCount = static_cast<std::size_t>(bricks), planeCount = static_cast<std::size_t>(planes);
    if (values != values_) sets_.clear();
    values_ = values;
    if (sets_.size() < brickCount) sets_.resize(brickCount);
    rows_.resize(sets_.size());
    array_.clear();
    for (std::size_t brick = 0; brick < sets_.size(); ++brick) {
        auto& sets = sets_[brick];
        while (sets.size() < planeCount)
            sets.push_back(std::make_unique<voIndexedFaceSet>(0, values, 0));
        rows_[brick].clear();
        for (const auto& set : sets)
            rows_[brick].push_back(set.get());
        array_.push_back(rows_[brick].data());
    }
}

} // namespace vo
