#include "style/tetra_corners.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace vo {

std::optional<TetraCorners> cornersOf(const StyledTetras& tetras, std::size_t tetra)
{
    TetraCorners corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const int index = tetras.indices[4 * tetra + i];
        if (index < 0) return {};
        const auto vertex = static_cast<std::size_t>(index);
        if (vertex >= tetras.positions.size() || vertex >= tetras.places.size()) return {};
        corners.positions[i] = tetras.positions[vertex];
        corners.places[i] = tetras.places[vertex];
    }
    return corners;
}

std::optional<glm::dmat4> TetraCorners::placeFromLocal() const
{
    const glm::dmat3 linear =
        glm::dmat3(places[1] - places[0], places[2] - places[0], places[3] - places[0]) *
        glm::inverse(edges());
    glm::dmat4 matrix(linear);
    matrix[3] = glm::dvec4(places[0] - linear * positions[0], 1.0);
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(matrix[column][row])) return {};
    return matrix;
}

} // namespace vo
