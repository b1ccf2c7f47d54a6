#include "x3d/solid_meshes.h"

#include "x3d/node_values.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace vo {
namespace {

constexpr int kSides = 48;
constexpr int kRings = 24;

/// A point of the outline that turns round the y axis: distance from the axis, height, and the normal's part
/// along both.
struct OutlinePoint
{
    float radius, y, normalRadius, normalY;
};

/// Turns a piece of outline round the y axis. Its left side, seen along it with the axis to the left, is
/// inside: upwards on the outside, outwards below, inwards above.
void addTurned(SurfaceMesh& mesh, const std::vector<OutlinePoint>& outline)
{
    const int first = static_cast<int>(mesh.positions.size());
    const int points = static_cast<int>(outline.size());
    for (int side = 0; side <= kSides; ++side) {
        const double angle = 2.0 * std::numbers::pi * (side % kSides) / kSides;
        const auto x = static_cast<float>(std::cos(angle)), z = static_cast<float>(-std::sin(angle));
        for (const OutlinePoint& point : outline) {
            mesh.positions.emplace_back(point.radius * x, point.y, point.radius * z);
            mesh.normals.emplace_back(point.normalRadius * x, point.normalY, point.normalRadius * z);
        }
    }
    for (int side = 0; side < kSides; ++side)
        for (int i = 0; i + 1 < points; ++i) {
            const int here = first + side * points + i, next = here + points;
            if (outline[static_cast<std::size_t>(i)].radius > 0.0f)
                mesh.triangles.insert(mesh.triangles.end(), {here, next, next + 1});
            if (outline[static_cast<std::size_t>(i) + 1].radius > 0.0f)
                mesh.triangles.insert(mesh.triangles.end(), {here, next + 1, here + 1});
        }
}

SurfaceMesh boxMesh(const Node& node)
{
    SurfaceMesh mesh;
    const glm::vec3 half = vec3Of(node, "size") / 2.0f;
    for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0f, 1.0f}) {
            glm::vec3 normal(0.0f), u(0.0f), v(0.0f);
            normal[axis] = side;
            u[(axis + 1) % 3] = side;
            v[(axis + 2) % 3] = 1.0f;
            const int first = static_cast<int>(mesh.positions.size());
            for (const glm::vec3& corner : {-u - v, u - v, u + v, v - u}) {
                mesh.positions.push_back((normal + corner) * half);
                mesh.normals.push_back(normal);
            }
            mesh.triangles.insert(mesh.triangles.end(),
                                  {first, first + 1, first + 2, first, first + 2, first + 3});
        }
    return mesh;
}

SurfaceMesh sphereMesh(const Node& node)
{
    const float radius = floatOf(node, "radius");
    std::vector<OutlinePoint> outline;
    for (int ring = 0; ring <= kRings; ++ring) {
        const double angle = std::numbers::pi * (static_cast<double>(ring) / kRings - 0.5);
        const bool isPole = ring == 0 || ring == kRings;
        const float outwards = isPole ? 0.0f : static_cast<float>(std::cos(angle));
        const auto up = static_cast<float>(std::sin(angle));
        outline.push_back({radius * outwards, radius * up, outwards, up});
    }
    SurfaceMesh mesh;
    addTurned(mesh, outline);
    return mesh;
}

SurfaceMesh cylinderMesh(const Node& node)
{
    const float radius = floatOf(node, "radius"), half = floatOf(node, "height") / 2.0f;
    SurfaceMesh mesh;
    if (boolOf(node, "bottom")) addTurned(mesh, {{0, -half, 0, -1}, {radius, -half, 0, -1}});
    if (boolOf(node, "side")) addTurned(mesh, {{radius, -half, 1, 0}, {radius, half, 1, 0}});
    if (boolOf(node, "top")) addTurned(mesh, {{radius, half, 0, 1}, {0, half, 0, 1}});
    return mesh;
}

SurfaceMesh coneMesh(const Node& node)
{
    const float radius = floatOf(node, "bottomRadius"), height = floatOf(node, "height");
    const float half = height / 2.0f, slant = std::hypot(radius, height);
    SurfaceMesh mesh;
    if (boolOf(node, "bottom")) addTurned(mesh, {{0, -half, 0, -1}, {radius, -half, 0, -1}});
    if (boolOf(node, "side"))
        addTurned(mesh, {{radius, -half, height / slant, radius / slant},
                         {0, half, height / slant, radius / slant}});
    return mesh;
}

} // namespace

SurfaceMesh solidMesh(const Node& node)
{
    SurfaceMesh mesh = isOf(&node, "Box")        ? boxMesh(node)
                       : isOf(&node, "Sphere")   ? sphereMesh(node)
                       : isOf(&node, "Cylinder") ? cylinderMesh(node)
                                                 : coneMesh(node);
    mesh.solid = boolOf(node, "solid", true);
    return mesh;
}

} // namespace vo
