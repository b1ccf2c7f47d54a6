#pragma once

#include "lookup/table.h"

#include <cstdint>
#include <vector>

namespace vo {

/// Tells whether any value of a range has an opacity.
class VisibleValues
{
public:
    /// The value is the opacity.
    VisibleValues() = default;
    /// The opacity is the table's alpha, interpolated between entries.
    explicit VisibleValues(const Table& table);

    /// False: every value from `low` to `high` has an opacity of exactly 0.
    bool any(float low, float high) const;

private:
    std::vector<std::uint32_t> visibleBefore_; ///< entry i: how many before it have an alpha other than 0
};

} // namespace vo
