#pragma once

#include "polygonize/polygon_stack.h"

#include "scenes.h"

#include <cmath>

/// The polygons of a stack as faces, for the checks that faces have.
namespace stack_faces {

/// The plane on which a point lies, as near as single precision has it.
inline int planeOf(const glm::dvec3& point, const vo::PlaneFamily& planes)
{
    return static_cast<int>(std::lround((planes.first - glm::dot(planes.normal, point)) / planes.spacing));
}

/// Triangles that end with the same vertex, one after the other, are one polygon.
inline scenes::Faces faces(const vo::PolygonStack& stack, int values, const vo::PlaneFamily& planes)
{
    scenes::Faces result(values);
    for (const vo::PolygonStack::Run& run : stack.runs)
        for (std::size_t i = run.first; i < run.first + run.count;) {
            const std::uint32_t first = stack.indices[i + 2];
            std::size_t end = i;
            while (end < run.first + run.count && stack.indices[end + 2] == first)
                end += 3;
            const std::size_t count = (end - i) / 3 + 2;
            const float* records = stack.records.data() + first * static_cast<std::size_t>(values);
            result.all.push_back(
                {run.brick, 0, {records, records + count * static_cast<std::size_t>(values)}, values});
            result.all.back().sample = planeOf(result.all.back().point(0), planes);
            i = end;
        }
    return result;
}

} // namespace stack_faces
