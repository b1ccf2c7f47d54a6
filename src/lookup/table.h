#pragma once

#include <cstddef>
#include <vector>

namespace vo {

/// A classification table: `size` entries of red, green, blue, alpha, each 0 to 1, not premultiplied. Entry i
/// stands for the value i / (size - 1); between entries the value is interpolated linearly.
struct Table
{
    std::vector<float> rgba;

    int size() const { return static_cast<int>(rgba.size() / 4); }
    friend bool operator==(const Table&, const Table&) = default;
};

/// A ramp 0 to 1 in all four components over [center - width/2, center + width/2] in entry numbers, entry i
/// at i; width below 1 counts as 1.
Table linearRamp(int size, double center, double width);

/// Looks each component of `count` (red, green, blue, alpha) up in its own column of the table, in place.
/// Values outside 0 to 1 are clamped.
void applyTable(const Table& table, float* rgba, std::size_t count);

} // namespace vo
