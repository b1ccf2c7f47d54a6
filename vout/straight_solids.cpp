#include "vout/straight_solids.h"

#include "legacy/report.h"

#include "vout/axis_frame.h"
#include "vout/triangulate_polygon.h"

#include <algorithm>

namespace vo {

void check(const BoxGrid& box)
{
    requireFinite("the corner", box.corner);
    std::size_t count = 1;
    for (int axis = 0; axis < 3; ++axis) {
        static const char* const sizes[] = {"the width", "the height", "the depth"};
        static const char* const names[] = {"columns", "rows", "layers"};
        requirePositive(sizes[axis], box.size[axis]);
        requireAtLeast(names[axis], box.cells[static_cast<std::size_t>(axis)], 1);
        count *= static_cast<std::size_t>(box.cells[static_cast<std::size_t>(axis)]);
        requireCountable(count, 5);
    }
}

Solid solidOf(const BoxGrid& box)
{
    const auto [columns, rows, layers] = box.cells;
    Solid solid;
    solid.split = box.split;
    for (int k = 0; k <= layers; ++k)
        for (int j = 0; j <= rows; ++j)
            for (int i = 0; i <= columns; ++i)
                solid.add(box.corner + box.size * glm::dvec3(i, j, k) / glm::dvec3(columns, rows, layers));
    solid.parts = {boxGrid({columns, rows, layers})};
    return solid;
}

namespace {

/// A polygon as seen along a line.
std::vector<glm::dvec2> outlineOf(const Extrusion& extrusion)
{
    const AxisFrame frame(extrusion.line);
    std::vector<glm::dvec2> outline;
    for (const glm::dvec3& point : extrusion.polygon) {
        const glm::dvec3 fromFirst = point - extrusion.polygon[0]; // fewer digits are lost
        outline.push_back({glm::dot(fromFirst, frame.u), glm::dot(fromFirst, frame.v)});
    }
    return outline;
}

} // namespace

void check(const Extrusion& extrusion)
{
    requireAtLeast("points", static_cast<int>(extrusion.polygon.size()), 3);
    for (const glm::dvec3& point : extrusion.polygon)
        requireFinite("a point", point);
    requireFinite("the line", extrusion.line);
    requirePositive("the line's length", glm::length(extrusion.line));
    requireCountable(extrusion.polygon.size(), 3);
    requireSimple(outlineOf(extrusion));
}

Solid solidOf(const Extrusion& extrusion)
{
    Solid solid;
    solid.vertices = extrusion.polygon;
    for (const glm::dvec3& point : extrusion.polygon)
        solid.add(point + extrusion.line);
    const auto top = static_cast<int>(extrusion.polygon.size());
    solid.parts = {prismsOn(trianglesOf(outlineOf(extrusion)), top)};
    return solid;
}

} // namespace vo
