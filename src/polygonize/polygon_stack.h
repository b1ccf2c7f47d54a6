#pragma once

#include "core/kept_array.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vo {

/// Polygons as triangles, in runs of one brick each. A polygon is a fan whose triangles end with its first
/// vertex; its records follow each other.
struct PolygonStack
{
    struct Run
    {
        int brick;
        std::size_t first; ///< of the indices
        std::size_t count;
    };

    KeptArray<float> records;
    KeptArray<std::uint32_t> indices; ///< record numbers, three a triangle
    std::vector<Run> runs;

    void clear()
    {
        records.clear();
        indices.clear();
        runs.clear();
    }
};

} // namespace vo
