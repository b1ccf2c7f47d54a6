#include "vout/fill_cells.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <set>

namespace vo {

namespace {

using Triangle = std::array<int, 3>;

/// Twice its area by the square of its longest edge: 0.87 for an even one.
double evenness(const TetraMesh& mesh, const Triangle& t)
{
    const glm::dvec3 a = mesh.position(t[1]) - mesh.position(t[0]), b = mesh.position(t[2]) - mesh.position(t[0]),
                     c = b - a;
    const double longest = std::max({glm::dot(a, a), glm::dot(b, b), glm::dot(c, c)});
    return longest > 0 ? glm::length(glm::cross(a, b)) / longest : 0;
}

constexpr double kThin = 1e-4;

std::vector<Triangle> fan(std::span<const int> loop, std::size_t first)
{
    std::vector<Triangle> triangles;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        triangles.push_back({loop[first], loop[(first + i) % loop.size()], loop[(first + i + 1) % loop.size()]});
    return triangles;
}

double thinnest(const TetraMesh& mesh, const std::vector<Triangle>& triangles)
{
    double least = 1;
    for (const Triangle& triangle : triangles)
        least = std::min(least, evenness(mesh, triangle));
    return least;
}

/// Of all ways to cut a polygon into triangles the one whose least even triangle is the most even. Time grows with the
/// cube of the vertices, of which there are more than a few only on the edges of small faces.
class EvenTriangles
{
public:
    EvenTriangles(std::span<const int> loop, const TetraMesh& mesh) : loop_(loop), ways_(loop.size() * loop.size())
    {
        for (std::size_t length = 2; length < loop.size(); ++length)
            for (std::size_t first = 0; first + length < loop.size(); ++first) {
                Way& best = way(first, first + length);
                best.least = -1;
                for (std::size_t tip = first + 1; tip < first + length; ++tip) {
                    const double least = std::min({way(first, tip).least, way(tip, first + length).least,
                                                   evenness(mesh, triangle(first, tip, first + length))});
                    if (least > best.least) best = {least, tip};
                }
            }
    }
    std::vector<Triangle> triangles()
    {
        std::vector<Triangle> found;
        collect(0, loop_.size() - 1, found);
        return found;
    }

private:
    /// How the part of the polygon behind a line from one vertex to a later one is cut: the tip on that line.
    struct Way
    {
        double least = 1;
        std::size_t tip = 0;
    };
    Way& way(std::size_t first, std::size_t last) { return ways_[first * loop_.size() + last]; }
    Triangle triangle(std::size_t a, std::size_t b, std::size_t c) const { return {loop_[a], loop_[b], loop_[c]}; }
    void collect(std::size_t first, std::size_t last, std::vector<Triangle>& found)
    {
        if (last - first < 2) return;
        const std::size_t tip = way(first, last).tip;
        found.push_back(triangle(first, tip, last));
        collect(first, tip, found);
        collect(tip, last, found);
    }

    std::span<const int> loop_;
    std::vector<Way> ways_;
};

/// Tetrahedra from a vertex to the triangles that it is no corner of. None where it is not above all of them.
std::vector<Tetra> cone(std::span<const Triangle> surface, int tip, double leastHeight, const TetraMesh& mesh)
{
    std::vector<Tetra> tetras;
    for (const Triangle& t : surface) {
        if (std::find(t.begin(), t.end(), tip) != t.end()) continue;
        const glm::dvec3 a = mesh.position(t[0]);
        const glm::dvec3 across = glm::cross(mesh.position(t[2]) - a, mesh.position(t[1]) - a);
        if (!(glm::dot(across, mesh.position(tip) - a) > leastHeight * glm::length(across))) return {};
        tetras.push_back({t[0], t[2], t[1], tip});
    }
    return tetras;
}

} // namespace

std::vector<Triangle> trianglesOf(std::span<const int> loop, const TetraMesh& mesh)
{
    if (loop.size() == 3) return {{loop[0], loop[1], loop[2]}};
    std::vector<std::size_t> places(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i)
        places[i] = i;
    std::sort(places.begin(), places.end(), [&](std::size_t a, std::size_t b) { return loop[a] < loop[b]; });
    for (const std::size_t place : places)
        if (std::vector<Triangle> triangles = fan(loop, place); thinnest(mesh, triangles) > kThin) return triangles;
    return EvenTriangles(loop, mesh).triangles();
}

void fillCell(std::span<const Triangle> surface, double leastHeight, TetraMesh& mesh, std::vector<Tetra>& tetras)
{
    if (surface.size() == 4) { // a tetrahedron, however flat
        const Triangle& base = surface[0];
        const auto tip = std::find_if(surface[1].begin(), surface[1].end(), [&](int corner) {
            return std::find(base.begin(), base.end(), corner) == base.end();
        });
        tetras.push_back({base[0], base[2], base[1], *tip});
        return;
    }
    std::set<int> corners;
    for (const Triangle& triangle : surface)
        corners.insert(triangle.begin(), triangle.end());
    for (const int tip : corners) {
        const std::vector<Tetra> pieces = cone(surface, tip, leastHeight, mesh);
        if (pieces.empty()) continue;
        tetras.insert(tetras.end(), pieces.begin(), pieces.end());
        return;
    }
    const int tip = mesh.appendMean(corners);
    for (const Triangle& t : surface)
        tetras.push_back({t[0], t[2], t[1], tip});
}

} // namespace vo
