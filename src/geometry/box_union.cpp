#include "geometry/box_union.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace vo {

namespace {

/// Finer lattices cost more than they save.
constexpr std::size_t kMostCells = std::size_t{1} << 24;
constexpr double kFarthest = 1 << 22; ///< of coordinates whose products are exact

/// Positions, and which way round it is seen from outside.
struct Facet
{
    std::array<glm::dvec3, 3> corner; ///< ascending
    int sign;                         ///< the normal is outwards with 1

    friend bool sameCorners(const Facet& a, const Facet& b) { return a.corner == b.corner; }
};

bool comesFirst(const glm::dvec3& a, const glm::dvec3& b)
{
    return std::lexicographical_compare(&a.x, &a.x + 3, &b.x, &b.x + 3);
}

Facet facetOf(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c)
{
    int sign = 1;
    const auto order = [&sign](glm::dvec3& p, glm::dvec3& q) {
        if (!comesFirst(q, p)) return;
        std::swap(p, q);
        sign = -sign;
    };
    order(a, b);
    order(b, c);
    order(a, b);
    return {{a, b, c}, sign};
}

/// Number of the axis that a triangle lies across; -1: none.
int axisAcross(const Facet& facet)
{
    for (int axis = 0; axis < 3; ++axis)
        if (facet.corner[0][axis] == facet.corner[1][axis] && facet.corner[0][axis] == facet.corner[2][axis])
            return axis;
    return -1;
}

/// Finds how often each cell between planes is filled, by the faces across x that a line along x passes.
class UnionFinder
{
public:
    explicit UnionFinder(const TetraView& tetras) : tetras_(tetras) {}

    std::optional<BoxUnion> find()
    {
        if (tetras_.tetraCount() == 0 || !findBounds()) return {};
        collectFacets();
        if (!keepOuterFacets() || !findPlanes() || !fill()) return {};
        return std::move(union_);
    }

private:
    bool findBounds()
    {
        Box& bounds = union_.bounds;
        bounds = {glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
        for (const int vertex : tetras_.indices) {
            const glm::dvec3 p = tetras_.position(vertex);
            for (int axis = 0; axis < 3; ++axis)
                if (!(std::abs(p[axis]) <= kFarthest) || 2.0 * p[axis] != std::floor(2.0 * p[axis]))
                    return false;
            bounds = {glm::min(bounds.lower, p), glm::max(bounds.upper, p)};
        }
        return true;
    }

    void collectFacets()
    {
        facets_.reserve(tetras_.indices.size());
        for (std::size_t i = 0; i + 4 <= tetras_.indices.size(); i += 4) {
            std::array<glm::dvec3, 4> v;
            for (std::size_t corner = 0; corner < 4; ++corner)
                v[corner] = tetras_.position(tetras_.indices[i + corner]);
            const double volume = glm::dot(v[1] - v[0], glm::cross(v[2] - v[0], v[3] - v[0]));
            if (volume == 0.0) continue;
            if (volume < 0.0) std::swap(v[0], v[1]);
            facets_.push_back(facetOf(v[1], v[2], v[3]));
            facets_.push_back(facetOf(v[0], v[3], v[2]));
            facets_.push_back(facetOf(v[0], v[1], v[3]));
            facets_.push_back(facetOf(v[0], v[2], v[1]));
        }
    }

    /// Those that two tetrahedra share from opposite sides cancel. False: one is across no axis.
    bool keepOuterFacets()
    {
        std::ranges::sort(facets_, [](const Facet& a, const Facet& b) {
            for (std::size_t i = 0; i < 3; ++i)
                if (a.corner[i] != b.corner[i]) return comesFirst(a.corner[i], b.corner[i]);
            return false;
        });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < facets_.size();) {
            Facet facet{facets_[i].corner, 0};
            for (; i < facets_.size() && sameCorners(facets_[i], facet); ++i)
                facet.sign += facets_[i].sign;
            if (facet.sign == 0) continue;
            if (axisAcross(facet) < 0) return false;
            facets_[kept++] = facet;
        }
        facets_.resize(kept);
        return true;
    }

    bool findPlanes()
    {
        std::size_t cells = 1;
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double>& planes = union_.planes[static_cast<std::size_t>(axis)];
            planes = {union_.bounds.lower[axis], union_.bounds.upper[axis]};
            for (const Facet& facet : facets_)
                for (const glm::dvec3& corner : facet.corner)
                    planes.push_back(corner[axis]);
            std::ranges::sort(planes);
            planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
            if (planes.size() < 2 || planes.size() > kMostCells) return false;
            cells *= planes.size() - 1;
            if (cells > kMostCells) return false;
        }
        union_.covered.assign(cells, 0);
        return true;
    }

    std::size_t cells(int axis) const { return union_.planes[static_cast<std::size_t>(axis)].size() - 1; }
    std::size_t planeNumber(int axis, double at) const
    {
        const std::vector<double>& planes = union_.planes[static_cast<std::size_t>(axis)];
        return static_cast<std::size_t>(std::ranges::lower_bound(planes, at) - planes.begin());
    }

    /// Where the middle of a column of cells lies from a line: a middle on it counts to one side, seen either
    /// way.
    static double sideOf(const glm::dvec3& a, const glm::dvec3& b, double y, double z)
    {
        const double side = (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
        if (side != 0.0) return side;
        return comesFirst(a, b) ? 1.0 : -1.0;
    }

    /// False: some cell is filled more than once.
    bool fill()
    {
        // Steps of the count, at the end of each row too.
        std::vector<int> steps((cells(0) + 1) * cells(1) * cells(2), 0);
        for (const Facet& facet : facets_)
            if (axisAcross(facet) == 0) addSteps(facet, steps);
        std::uint8_t* covered = union_.covered.data();
        const int* step = steps.data();
        for (std::size_t row = 0; row < cells(1) * cells(2); ++row, ++step) {
            int count = 0;
            for (std::size_t x = 0; x < cells(0); ++x) {
                count += *step++;
                if (count < 0 || count > 1) return false;
                *covered++ = static_cast<std::uint8_t>(count);
            }
        }
        return true;
    }

    void addSteps(const Facet& facet, std::vector<int>& steps) const
    {
        const auto& [a, b, c] = facet.corner;
        const auto [yLow, yHigh] = std::minmax({a.y, b.y, c.y});
        const auto [zLow, zHigh] = std::minmax({a.z, b.z, c.z});
        const double turn = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
        const double x = a.x;
        const std::size_t plane = planeNumber(0, x);
        // The normal of a, b, c is along x where they turn from y to z.
        const int step = (turn > 0.0 ? -1 : 1) * facet.sign;
        const std::vector<double>&ys = union_.planes[1], &zs = union_.planes[2];
        for (std::size_t k = planeNumber(2, zLow); zs[k] < zHigh; ++k)
            for (std::size_t j = planeNumber(1, yLow); ys[j] < yHigh; ++j) {
                const double y = 0.5 * (ys[j] + ys[j + 1]), z = 0.5 * (zs[k] + zs[k + 1]);
                const double sides[3] = {sideOf(a, b, y, z), sideOf(b, c, y, z), sideOf(c, a, y, z)};
                if (std::ranges::all_of(sides, [&](double side) { return side * turn > 0.0; }))
                    steps[(k * cells(1) + j) * (cells(0) + 1) + plane] += step;
            }
    }

    const TetraView& tetras_;
    std::vector<Facet> facets_;
    BoxUnion union_;
};

} // namespace

bool BoxUnion::covers(const Box& box) const
{
    std::array<std::size_t, 3> first{}, end{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::vector<double>& at = planes[axis];
        const auto number = [&](auto place) { return static_cast<std::size_t>(place - at.begin()); };
        const double low = box.lower[static_cast<int>(axis)], high = box.upper[static_cast<int>(axis)];
        first[axis] = std::max<std::size_t>(number(std::ranges::upper_bound(at, low)), 1) - 1;
        end[axis] = std::min(number(std::ranges::lower_bound(at, high)), at.size() - 1);
    }
    for (std::size_t z = first[2]; z < end[2]; ++z)
        for (std::size_t y = first[1]; y < end[1]; ++y)
            for (std::size_t x = first[0]; x < end[0]; ++x)
                if (!covered[(z * (planes[1].size() - 1) + y) * (planes[0].size() - 1) + x]) return false;
    return true;
}

std::optional<BoxUnion> boxUnion(const TetraView& tetras)
{
    return UnionFinder(tetras).find();
}

} // namespace vo
