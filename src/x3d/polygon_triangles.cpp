#include "x3d/polygon_triangles.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <numeric>

namespace vo {

glm::dvec3 areaVector(std::span<const glm::vec3> corners)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i]) - glm::dvec3(corners[0]),
                          glm::dvec3(corners[i + 1]) - glm::dvec3(corners[0]));
    return sum;
}

namespace {

/// Along the axis that is nearest to the normal, mirrored where needed so that it turns counterclockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners)
{
    const glm::dvec3 normal = areaVector(corners);
    int axis = std::abs(normal.x) > std::abs(normal.y) ? 0 : 1;
    if (std::abs(normal.z) > std::abs(normal[axis])) axis = 2;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double turn = normal[axis] < 0.0 ? -1.0 : 1.0;
    std::vector<glm::dvec2> flat;
    for (const glm::vec3& corner : corners)
        flat.emplace_back(turn * static_cast<double>(corner[u]), static_cast<double>(corner[v]));
    return flat;
}

double turnOf(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

class EarCutter
{
public:
    explicit EarCutter(std::vector<glm::dvec2> flat) : flat_(std::move(flat)), rest_(flat_.size())
    {
        std::iota(rest_.begin(), rest_.end(), 0);
    }

    std::vector<std::array<int, 3>> run()
    {
        std::vector<std::array<int, 3>> triangles;
        std::size_t from = 0;
        while (rest_.size() > 2) {
            const std::size_t ear = nextEar(from);
            triangles.push_back(cornersAt(ear));
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
            from = ear % rest_.size();
        }
        return triangles;
    }

private:
    const glm::dvec2& at(int corner) const { return flat_[static_cast<std::size_t>(corner)]; }

    std::array<int, 3> cornersAt(std::size_t i) const
    {
        const std::size_t n = rest_.size();
        return {rest_[(i + n - 1) % n], rest_[i], rest_[(i + 1) % n]};
    }

    bool isEar(const std::array<int, 3>& t) const
    {
        const glm::dvec2 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
        if (turnOf(a, b, c) <= 0.0) return false;
        for (const int corner : rest_) {
            const glm::dvec2& p = at(corner);
            if (p == a || p == b || p == c) continue;
            if (turnOf(a, b, p) >= 0.0 && turnOf(b, c, p) >= 0.0 && turnOf(c, a, p) >= 0.0) return false;
        }
        return true;
    }

    /// Where there is none, the corner that is next: the polygon is no simple one.
    std::size_t nextEar(std::size_t from) const
    {
        for (std::size_t step = 0; step < rest_.size(); ++step) {
            const std::size_t i = (from + step) % rest_.size();
            if (isEar(cornersAt(i))) return i;
        }
        return from;
    }

    std::vector<glm::dvec2> flat_;
    std::vector<int> rest_; // corners that are not cut off yet
};

} // namespace

std::vector<std::array<int, 3>> polygonTriangles(std::span<const glm::vec3> corners)
{
    return EarCutter(flattened(corners)).run();
}

} // namespace vo
