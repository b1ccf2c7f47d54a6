#include "vout/triangulate_polygon.h"

#include "legacy/report.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// Twice the area of a triangle, positive counter-clockwise; 0 where rounding could be all there is.
double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const glm::dvec2 u = b - a, v = c - a;
    const double area = u.x * v.y - u.y * v.x;
    constexpr double kNoise = 1e-12;
    return std::abs(area) <= kNoise * glm::length(u) * glm::length(v) ? 0 : area;
}

int side(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    const double area = turn(a, b, c);
    return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/// Whether p, on the line of a and b, lies between them.
bool isBetween(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
    return glm::dot(p - a, p - b) <= 0;
}

bool isOn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& p)
{
    return side(a, b, p) == 0 && isBetween(a, b, p);
}

bool meet(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    if (isOn(a, b, c) || isOn(a, b, d) || isOn(c, d, a) || isOn(c, d, b)) return true;
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

double signedArea(const std::vector<glm::dvec2>& polygon)
{
    double sum = 0;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
        sum += polygon[j].x * polygon[i].y - polygon[j].y * polygon[i].x;
    return sum / 2;
}

/// Cuts corners off a polygon, each time the one that makes the best triangle.
class EarCutter
{
public:
    explicit EarCutter(const std::vector<glm::dvec2>& polygon) : polygon_(polygon)
    {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            rest_.push_back(static_cast<int>(i));
        if (signedArea(polygon) < 0) std::reverse(rest_.begin(), rest_.end());
    }

    std::vector<std::array<int, 3>> run()
    {
        std::vector<std::array<int, 3>> triangles;
        while (rest_.size() > 2) {
            const std::size_t ear = bestEar();
            triangles.push_back(cornersAt(ear));
            rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        return triangles;
    }

private:
    const glm::dvec2& at(int corner) const { return polygon_[static_cast<std::size_t>(corner)]; }

    std::array<int, 3> cornersAt(std::size_t i) const
    {
        const std::size_t n = rest_.size();
        return {rest_[(i + n - 1) % n], rest_[i], rest_[(i + 1) % n]};
    }

    /// How far from a needle: area over the longest side's square; 0 or less where the polygon is not convex.
    double quality(const std::array<int, 3>& t) const
    {
        const glm::dvec2 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
        const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        return turn(a, b, c) / (longest * longest);
    }

    /// No other corner lies in the triangle or on its sides, so that what remains stays simple.
    bool isEmpty(const std::array<int, 3>& t) const
    {
        const glm::dvec2 &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
        return std::none_of(rest_.begin(), rest_.end(), [&](int corner) {
            if (corner == t[0] || corner == t[1] || corner == t[2]) return false;
            const glm::dvec2& p = at(corner);
            return side(a, b, p) >= 0 && side(b, c, p) >= 0 && side(c, a, p) >= 0;
        });
    }

    std::size_t bestEar() const
    {
        double best = 0;
        std::size_t ear = rest_.size();
        for (std::size_t i = 0; i < rest_.size(); ++i) {
            const std::array<int, 3> triangle = cornersAt(i);
            const double found = quality(triangle);
            if (found <= best || !isEmpty(triangle)) continue;
            best = found;
            ear = i;
        }
        if (ear == rest_.size()) badValue("the polygon is too thin to be cut into triangles");
        return ear;
    }

    const std::vector<glm::dvec2>& polygon_;
    std::vector<int> rest_; ///< corners that are not cut off yet, counter-clockwise
};

} // namespace

void requireSimple(const std::vector<glm::dvec2>& polygon)
{
    const std::size_t n = polygon.size();
    const auto refuse = [](std::size_t i, std::size_t j) {
        badValue("seen along the line, the sides after points " + std::to_string(i) + " and " + std::to_string(j) +
                 " of the polygon meet");
    };
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 &a = polygon[i], &b = polygon[(i + 1) % n], &c = polygon[(i + 2) % n];
        if (a == b || isOn(a, b, c) || isOn(b, c, a)) refuse(i, (i + 1) % n);
        for (std::size_t j = i + 2; j < n; ++j)
            if ((j + 1) % n != i && meet(a, b, polygon[j], polygon[(j + 1) % n])) refuse(i, j);
    }
}

std::vector<std::array<int, 3>> trianglesOf(const std::vector<glm::dvec2>& polygon)
{
    return EarCutter(polygon).run();
}

} // namespace vo
