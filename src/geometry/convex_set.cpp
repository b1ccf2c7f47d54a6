#include "geometry/convex_set.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace vo {

namespace {

/// Corners of a plane face that was turned and rounded to floats leave their plane by a few units in the last
/// place: this part of the largest coordinate.
constexpr double kRounding = 1e-6;
/// Polyhedra of more faces are not worth being told apart from others, and would take quadratic time.
constexpr std::size_t kMostPlanes = 512;

/// A face of a tetrahedron by its places, ascending. The sign says which way round it is seen from outside.
struct Facet
{
    std::array<std::uint32_t, 3> places;
    int sign;
    double size = 0.0; ///< twice the area

    friend bool operator<(const Facet& a, const Facet& b) { return a.places < b.places; }
};

class HullFinder
{
public:
    explicit HullFinder(const TetraView& tetras) : tetras_(tetras) {}

    std::optional<ConvexSet> find()
    {
        if (tetras_.tetraCount() == 0 || !mergePlaces() || !collectFacets() || !keepOuterFacets()) return {};
        return findPlanes() && coveredOnce() ? std::optional(std::move(set_)) : std::nullopt;
    }

private:
    /// Numbers the positions in use, equal ones alike. False: one is not finite.
    bool mergePlaces()
    {
        placeOf_.assign(tetras_.records.size() / static_cast<std::size_t>(tetras_.valuesPerVertex), 0);
        std::vector<std::pair<glm::dvec3, int>> used;
        for (const int vertex : tetras_.indices) {
            if (std::exchange(placeOf_[static_cast<std::size_t>(vertex)], 1u)) continue;
            used.emplace_back(tetras_.position(vertex), vertex);
            const glm::dvec3 size = glm::abs(used.back().first);
            if (!std::isfinite(size.x + size.y + size.z)) return false;
            rounding_ = std::max({rounding_, kRounding * size.x, kRounding * size.y, kRounding * size.z});
        }
        std::ranges::sort(used, [](const auto& a, const auto& b) {
            return std::lexicographical_compare(&a.first.x, &a.first.x + 3, &b.first.x, &b.first.x + 3);
        });
        for (const auto& [position, vertex] : used) {
            if (places_.empty() || places_.back() != position) places_.push_back(position);
            placeOf_[static_cast<std::size_t>(vertex)] = static_cast<std::uint32_t>(places_.size() - 1);
        }
        return true;
    }

    /// False: a tetrahedron is flat.
    bool collectFacets()
    {
        facets_.reserve(tetras_.indices.size());
        for (std::size_t i = 0; i + 4 <= tetras_.indices.size(); i += 4) {
            std::array<std::uint32_t, 4> v;
            for (std::size_t corner = 0; corner < 4; ++corner)
                v[corner] = placeOf_[static_cast<std::size_t>(tetras_.indices[i + corner])];
            const glm::dvec3& origin = places_[v[0]];
            const double volume =
                glm::dot(places_[v[1]] - origin, glm::cross(places_[v[2]] - origin, places_[v[3]] - origin));
            if (volume == 0.0 || !std::isfinite(volume)) return false;
            if (volume < 0.0) std::swap(v[0], v[1]);
            addFacet(v[1], v[2], v[3]);
            addFacet(v[0], v[3], v[2]);
            addFacet(v[0], v[1], v[3]);
            addFacet(v[0], v[2], v[1]);
        }
        return true;
    }

    void addFacet(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        int sign = 1;
        const auto order = [&sign](std::uint32_t& p, std::uint32_t& q) {
            if (p <= q) return;
            std::swap(p, q);
            sign = -sign;
        };
        order(a, b);
        order(b, c);
        order(a, b);
        facets_.push_back({{a, b, c}, sign});
    }

    /// Facets that two tetrahedra share from opposite sides cancel. False: some overlap.
    bool keepOuterFacets()
    {
        std::sort(facets_.begin(), facets_.end());
        std::size_t kept = 0;
        for (std::size_t i = 0; i < facets_.size();) {
            Facet facet{facets_[i].places, 0};
            for (; i < facets_.size() && facets_[i].places == facet.places; ++i)
                facet.sign += facets_[i].sign;
            if (std::abs(facet.sign) > 1) return false;
            if (facet.sign == 0) continue;
            facet.size = glm::length(normalOf(facet));
            facets_[kept++] = facet;
        }
        facets_.resize(kept);
        std::ranges::sort(facets_, [](const Facet& a, const Facet& b) { return a.size > b.size; });
        return true;
    }

    /// Outwards, as long as twice the area.
    glm::dvec3 normalOf(const Facet& facet) const
    {
        const auto [a, b, c] = corners(facet);
        return static_cast<double>(facet.sign) * glm::cross(b - a, c - a);
    }

    std::array<glm::dvec3, 3> corners(const Facet& facet) const
    {
        return {places_[facet.places[0]], places_[facet.places[1]], places_[facet.places[2]]};
    }

    static double distance(const glm::dvec4& plane, const glm::dvec3& p)
    {
        return glm::dot(glm::dvec3(plane), p) + plane.w;
    }

    bool inPlane(const Facet& facet, const glm::dvec4& plane) const
    {
        return std::ranges::all_of(
                   corners(facet),
                   [&](const glm::dvec3& p) { return std::abs(distance(plane, p)) <= rounding_; }) &&
               glm::dot(normalOf(facet), glm::dvec3(plane)) > 0.0;
    }

    /// The planes of the outer facets, large ones first. False: something lies outside of one.
    bool findPlanes()
    {
        std::vector<std::uint32_t> outer;
        for (const Facet& facet : facets_)
            outer.insert(outer.end(), facet.places.begin(), facet.places.end());
        std::ranges::sort(outer);
        outer.erase(std::unique(outer.begin(), outer.end()), outer.end());
        for (const Facet& facet : facets_) {
            const auto known = [&](const glm::dvec4& plane) { return inPlane(facet, plane); };
            if (std::ranges::any_of(set_.planes, known)) continue;
            if (!(facet.size > 0.0) || set_.planes.size() == kMostPlanes) return false;
            const glm::dvec3 normal = normalOf(facet) / facet.size;
            const glm::dvec4 plane(normal, -glm::dot(normal, places_[facet.places[0]]));
            if (std::ranges::any_of(
                    outer, [&](std::uint32_t place) { return distance(plane, places_[place]) > rounding_; }))
                return false;
            set_.planes.push_back(plane);
        }
        return set_.planes.size() >= 4;
    }

    /// The outer facets form a closed surface in that of the polyhedron, so they cover all of it equally
    /// often: as often as the middle of one of them.
    bool coveredOnce() const
    {
        const auto [a, b, c] = corners(facets_.front());
        const glm::dvec3 middle = (a + b + c) / 3.0;
        const auto covers = [&](const Facet& facet) {
            return inPlane(facet, set_.planes.front()) && isOver(facet, middle);
        };
        return std::ranges::count_if(facets_, covers) == 1;
    }

    bool isOver(const Facet& facet, const glm::dvec3& point) const
    {
        const glm::dvec3 normal = normalOf(facet);
        const std::array<glm::dvec3, 3> p = corners(facet);
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 inwards =
                static_cast<double>(facet.sign) * glm::cross(normal, p[(i + 1) % 3] - p[i]);
            if (glm::dot(inwards, point - p[i]) < 0.0) return false;
        }
        return true;
    }

    const TetraView& tetras_;
    std::vector<std::uint32_t> placeOf_; ///< of each vertex
    std::vector<glm::dvec3> places_;
    double rounding_ = 0.0;
    std::vector<Facet> facets_;
    ConvexSet set_;
};

} // namespace

std::optional<ConvexSet> convexSet(const TetraView& tetras)
{
    return HullFinder(tetras).find();
}

} // namespace vo
