#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <vector>

namespace vo {

/// Triangles of a geometry node, counterclockwise from outside.
struct SurfaceMesh
{
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals; ///< unit, one a position
    std::vector<glm::vec4> colors;  ///< one a position, or none
    bool colorsHaveAlpha = false;
    std::vector<int> triangles; ///< three a triangle
    bool solid = true;
};

} // namespace vo
