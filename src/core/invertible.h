#pragma once

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace vo {

/// Whether all numbers of a matrix are finite, and it has an inverse.
inline bool isInvertible(const glm::dmat4& matrix)
{
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(matrix[column][row])) return false;
    const double determinant = glm::determinant(matrix);
    return std::isfinite(determinant) && std::isfinite(1.0 / determinant);
}

} // namespace vo
