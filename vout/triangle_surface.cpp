#include "vout/triangle_surface.h"

#include "legacy/report.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <tuple>

namespace vo {

namespace {

/// A side of a triangle, by the smaller of its vertex numbers first.
struct Side
{
    int low, high;
    bool upwards; // the triangle goes from low to high
    int triangle;

    std::pair<int, int> edge() const { return {low, high}; }
};

/// Sides of one edge stand together.
std::vector<Side> sidesByEdge(const TriangleSurface& surface)
{
    std::vector<Side> sides;
    sides.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const int from = surface.triangles[t][i], to = surface.triangles[t][(i + 1) % 3];
            sides.push_back({std::min(from, to), std::max(from, to), from < to, static_cast<int>(t)});
        }
    std::stable_sort(sides.begin(), sides.end(),
                     [](const Side& a, const Side& b) { return a.edge() < b.edge(); });
    return sides;
}

/// Calls `visit` with the first side of each edge and how many there are.
template <typename Visit>
void forEachEdge(const std::vector<Side>& sides, Visit visit)
{
    for (std::size_t first = 0, next; first < sides.size(); first = next) {
        next = first + 1;
        while (next < sides.size() && sides[next].edge() == sides[first].edge())
            ++next;
        visit(&sides[first], next - first);
    }
}

/// Numbers in sets that grow together.
class Groups
{
public:
    explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    int root(int number)
    {
        while (at(number) != number)
            number = at(number) = at(at(number));
        return number;
    }
    void join(int a, int b) { at(root(a)) = root(b); }

private:
    int& at(int number) { return parent_[static_cast<std::size_t>(number)]; }
    std::vector<int> parent_;
};

std::size_t flatTriangles(const TriangleSurface& surface)
{
    return static_cast<std::size_t>(
        std::count_if(surface.triangles.begin(), surface.triangles.end(), [&](const std::array<int, 3>& t) {
            const auto at = [&](std::size_t i) { return surface.vertices[static_cast<std::size_t>(t[i])]; };
            return glm::cross(at(1) - at(0), at(2) - at(0)) == glm::dvec3(0);
        }));
}

/// Vertices whose triangles are more than one fan. Every edge has two triangles.
std::size_t pinchedVertices(const TriangleSurface& surface, const std::vector<Side>& sides)
{
    // Corner 3 t + i of triangle t; two that share an edge are joined at both of its ends.
    const auto cornerAt = [&](int triangle, int vertex) {
        const auto& t = surface.triangles[static_cast<std::size_t>(triangle)];
        return 3 * triangle + static_cast<int>(std::find(t.begin(), t.end(), vertex) - t.begin());
    };
    Groups fans(3 * surface.triangles.size());
    forEachEdge(sides, [&](const Side* side, std::size_t) {
        for (const int end : {side->low, side->high})
            fans.join(cornerAt(side[0].triangle, end), cornerAt(side[1].triangle, end));
    });
    std::vector<int> fanOf(surface.vertices.size(), -1);
    std::set<std::size_t> pinched;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const auto vertex = static_cast<std::size_t>(surface.triangles[t][i]);
            const int fan = fans.root(static_cast<int>(3 * t + i));
            if (fanOf[vertex] >= 0 && fanOf[vertex] != fan) pinched.insert(vertex);
            fanOf[vertex] = fan;
        }
    return pinched.size();
}

/// "1 edge has", "3 edges have".
std::string counted(std::size_t count, const std::string& one, const std::string& more)
{
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

void requireTwoTrianglesAnEdge(const std::vector<Side>& sides)
{
    std::size_t open = 0, crowded = 0, opposed = 0;
    forEachEdge(sides, [&](const Side* side, std::size_t count) {
        open += count == 1;
        crowded += count > 2;
        opposed += count == 2 && side[0].upwards == side[1].upwards;
    });
    std::string found;
    const auto add = [&](std::size_t count, const std::string& one, const std::string& more) {
        if (count > 0) found += (found.empty() ? "" : ", ") + counted(count, one, more);
    };
    add(open, "edge has one triangle only", "edges have one triangle only");
    add(crowded, "edge has more than two triangles", "edges have more than two triangles");
    if (!found.empty()) badValue("the surface is not closed: " + found);
    add(opposed, "edge", "edges");
    if (opposed > 0)
        badValue("the surface is not oriented: at " + found + " the two triangles go round opposite ways");
}

} // namespace

double TriangleSurface::volume() const
{
    if (vertices.empty()) return 0;
    double sixfold = 0;
    const glm::dvec3 origin = vertices.front(); // fewer digits are lost
    for (const auto& [a, b, c] : triangles) {
        const auto at = [&](int vertex) { return vertices[static_cast<std::size_t>(vertex)] - origin; };
        sixfold += glm::dot(at(a), glm::cross(at(b), at(c)));
    }
    return sixfold / 6;
}

double TriangleSurface::area() const
{
    double twofold = 0;
    for (const auto& [a, b, c] : triangles) {
        const auto at = [&](int vertex) { return vertices[static_cast<std::size_t>(vertex)]; };
        twofold += glm::length(glm::cross(at(b) - at(a), at(c) - at(a)));
    }
    return twofold / 2;
}

glm::dvec3 TriangleSurface::lower() const
{
    glm::dvec3 lower(vertices.empty() ? NAN : HUGE_VAL);
    for (const glm::dvec3& vertex : vertices)
        lower = glm::min(lower, vertex);
    return lower;
}

glm::dvec3 TriangleSurface::upper() const
{
    glm::dvec3 upper(vertices.empty() ? NAN : -HUGE_VAL);
    for (const glm::dvec3& vertex : vertices)
        upper = glm::max(upper, vertex);
    return upper;
}

TriangleSurface merged(const TriangleSurface& surface)
{
    const auto before = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::map<glm::dvec3, int, decltype(before)> numbers(before);
    TriangleSurface result;
    for (std::array<int, 3> triangle : surface.triangles) {
        for (int& corner : triangle) {
            const glm::dvec3& vertex = surface.vertices[static_cast<std::size_t>(corner)];
            const auto [found, isNew] = numbers.try_emplace(vertex, static_cast<int>(numbers.size()));
            if (isNew) result.vertices.push_back(vertex);
            corner = found->second;
        }
        result.triangles.push_back(triangle);
    }
    return result;
}

void alignNeighbours(TriangleSurface& surface)
{
    std::vector<std::vector<std::pair<int, bool>>> neighbours(
        surface.triangles.size()); // and whether opposed
    forEachEdge(sidesByEdge(surface), [&](const Side* side, std::size_t count) {
        if (count != 2) return;
        const bool isOpposed = side[0].upwards == side[1].upwards;
        neighbours[static_cast<std::size_t>(side[0].triangle)].push_back({side[1].triangle, isOpposed});
        neighbours[static_cast<std::size_t>(side[1].triangle)].push_back({side[0].triangle, isOpposed});
    });
    enum : char { unseen, kept, turned };
    std::vector<char> state(surface.triangles.size(), unseen);
    std::vector<int> waiting;
    for (std::size_t start = 0; start < state.size(); ++start) {
        if (state[start] != unseen) continue;
        state[start] = kept;
        waiting.push_back(static_cast<int>(start));
        while (!waiting.empty()) {
            const auto triangle = static_cast<std::size_t>(waiting.back());
            waiting.pop_back();
            for (const auto& [next, isOpposed] : neighbours[triangle]) {
                char& own = state[static_cast<std::size_t>(next)];
                if (own != unseen) continue;
                own = (state[triangle] == turned) != isOpposed ? turned : kept;
                waiting.push_back(next);
            }
        }
    }
    for (std::size_t t = 0; t < state.size(); ++t)
        if (state[t] == turned) std::swap(surface.triangles[t][1], surface.triangles[t][2]);
}

void requireClosed(const TriangleSurface& surface)
{
    if (surface.triangles.empty()) badValue("the surface has no triangles");
    if (const std::size_t flat = flatTriangles(surface))
        badValue(counted(flat, "triangle has", "triangles have") + " no area");
    const std::vector<Side> sides = sidesByEdge(surface);
    requireTwoTrianglesAnEdge(sides);
    if (const std::size_t pinched = pinchedVertices(surface, sides))
        badValue("the surface touches itself in " + counted(pinched, "vertex", "vertices"));
}

double sharpestAngle(const TriangleSurface& surface, bool alsoWithout)
{
    const auto unit = [&](int triangle) {
        const auto& t = surface.triangles[static_cast<std::size_t>(triangle)];
        const auto at = [&](std::size_t i) { return surface.vertices[static_cast<std::size_t>(t[i])]; };
        return glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    };
    double sharpest = 180;
    forEachEdge(sidesByEdge(surface), [&](const Side* side, std::size_t) {
        const int from = side->upwards ? side->low : side->high, to = side->upwards ? side->high : side->low;
        const glm::dvec3 along =
            surface.vertices[static_cast<std::size_t>(to)] - surface.vertices[static_cast<std::size_t>(from)];
        const glm::dvec3 normal = unit(side[0].triangle), next = unit(side[1].triangle);
        // How far the surface bends back over the edge, from -180 (a fold outwards) to 180 degrees.
        const double bend =
            std::atan2(glm::dot(glm::cross(normal, next), glm::normalize(along)), glm::dot(normal, next)) *
            180 / std::numbers::pi;
        sharpest = std::min(sharpest, 180 - bend);
        if (alsoWithout) sharpest = std::min(sharpest, 180 + bend);
    });
    return sharpest;
}

std::vector<int> componentsOf(const TriangleSurface& surface)
{
    Groups groups(surface.vertices.size());
    for (const auto& [a, b, c] : surface.triangles) {
        groups.join(a, b);
        groups.join(a, c);
    }
    std::map<int, int> numbers;
    std::vector<int> components;
    components.reserve(surface.triangles.size());
    for (const auto& triangle : surface.triangles)
        components.push_back(
            numbers.try_emplace(groups.root(triangle[0]), static_cast<int>(numbers.size())).first->second);
    return components;
}

} // namespace vo
