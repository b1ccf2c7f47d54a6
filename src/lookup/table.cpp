#include "lookup/table.h"

#include <algorithm>
#include <cassert>

namespace vo {

Table linearRamp(int size, double center, double width)
{
    assert(size >= 1);
    const double span = width >= 1.0 ? width : 1.0;
    const double start = center - span / 2;
    Table table;
    table.rgba.resize(static_cast<std::size_t>(size) * 4);
    for (int i = 0; i < size; ++i) {
        const auto value = static_cast<float>(std::clamp((i - start) / span, 0.0, 1.0));
        std::fill_n(table.rgba.begin() + 4 * i, 4, value);
    }
    return table;
}

void applyTable(const Table& table, float* rgba, std::size_t count)
{
    assert(table.size() >= 1);
    const int last = table.size() - 1;
    const auto scale = static_cast<float>(last);
    const float* entries = table.rgba.data();
    for (std::size_t i = 0; i < 4 * count; ++i) {
        const float* column = entries + i % 4;
        // Written so that a NaN counts as 0.
        const float place = rgba[i] > 0.0f ? std::min(rgba[i], 1.0f) * scale : 0.0f;
        const int below = static_cast<int>(place);
        const int above = std::min(below + 1, last);
        const float low = column[4 * below];
        rgba[i] = low + (column[4 * above] - low) * (place - static_cast<float>(below));
    }
}

} // namespace vo
