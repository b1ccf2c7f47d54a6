#pragma once

#include "style/styled_scene.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <array>
#include <optional>

namespace vo {

/// The corners of one tetrahedron.
struct TetraCorners
{
    std::array<glm::dvec3, 4> positions; ///< local
    std::array<glm::dvec3, 4> places;    ///< S, T, R

    /// From the first position to the others.
    glm::dmat3 edges() const
    {
        return {positions[1] - positions[0], positions[2] - positions[0], positions[3] - positions[0]};
    }
    /// Nothing where it is flat.
    std::optional<glm::dmat4> placeFromLocal() const;
};

/// Nothing where it names corners that are not there.
std::optional<TetraCorners> cornersOf(const StyledTetras& tetras, std::size_t tetra);

} // namespace vo
