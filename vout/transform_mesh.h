#pragma once

#include "vout/tetra_mesh.h"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <optional>

namespace vo {

/// An OpenGL matrix that has an inverse and keeps parallels. Throws CallerError for others.
glm::dmat4 affineMatrix(const double* columns);

/// The format that placed() makes of one: with voxel coordinates, and with four channels of colour where one is given.
voInterleavedArrayType placedFormat(voInterleavedArrayType format, bool hasColor);

/// The mesh with voxel coordinates, its own or else its positions, and positions moved by the matrix; its colours times
/// `color`, which stands for them where it has none. Throws CallerError for a format that the records do not have.
TetraMesh placed(const TetraMesh& mesh, voInterleavedArrayType format, const glm::dmat4& matrix,
                 const std::optional<glm::vec4>& color = std::nullopt);

} // namespace vo
