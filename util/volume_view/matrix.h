#pragma once

#include <array>
#include <cstddef>

namespace vo {

/// 16 values column by column, as OpenGL has them.
using Matrix = std::array<double, 16>;

inline Matrix product(const Matrix& a, const Matrix& b)
{
    Matrix c{};
    for (std::size_t column = 0; column < 4; ++column)
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t k = 0; k < 4; ++k)
                c[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return c;
}

inline Matrix translation(double x, double y, double z)
{
    return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

} // namespace vo
