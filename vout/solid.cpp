#include "vout/solid.h"

#include "legacy/report.h"

#include <cmath>
#include <sstream>

namespace vo {

namespace {

std::string printed(double number)
{
    std::ostringstream text;
    text << number;
    return text.str();
}

} // namespace

TetraMesh tessellated(const Solid& solid)
{
    TetraMesh mesh;
    mesh.records.reserve(3 * solid.vertices.size());
    for (const glm::dvec3& vertex : solid.vertices)
        for (int axis = 0; axis < 3; ++axis) {
            const auto coordinate = static_cast<float>(vertex[axis]);
            if (!std::isfinite(coordinate)) badValue("it reaches farther than floats do");
            mesh.records.push_back(coordinate);
        }
    std::size_t flat = 0;
    for (const Cells& cells : solid.parts)
        flat += splitCells(cells, solid.split, mesh);
    if (flat > 0) badValue("too small, too fine or too far from the origin: floats do not tell its vertices apart");
    return mesh;
}

void requireFinite(const char* name, const glm::dvec3& point)
{
    if (std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z)) return;
    badValue(std::string(name) + " is " + printed(point.x) + " " + printed(point.y) + " " + printed(point.z));
}

void requirePositive(const char* name, double length)
{
    if (!(length > 0) || !std::isfinite(length))
        badValue(std::string(name) + " is " + printed(length) + ", more than 0 is needed");
}

void requireAtLeast(const char* name, int number, int least)
{
    if (number < least)
        badValue(std::string(name) + ": " + std::to_string(number) + ", " + std::to_string(least) +
                 " or more are needed");
}

} // namespace vo
