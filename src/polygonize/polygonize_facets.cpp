#include "polygonize/polygonize_facets.h"

#include "polygonize/facet_cutter.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

bool finite(const glm::dvec3& p)
{
    return std::isfinite(p.x + p.y + p.z);
}

bool overlap(const Box& a, const Box& b)
{
    return glm::all(glm::lessThanEqual(a.lower, b.upper)) && glm::all(glm::lessThanEqual(b.lower, a.upper));
}

bool hasArea(std::span<const glm::dvec3> corners)
{
    glm::dvec3 sum(0.0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return glm::length(sum) > 0.0;
}

/// Empty (lower > upper) when a corner is not finite.
Box boundsOf(std::span<const glm::dvec3> corners)
{
    Box box{corners.front(), corners.front()};
    for (const glm::dvec3& p : corners) {
        if (!finite(p)) return {glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
        box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    }
    return box;
}

} // namespace

bool polygonizeFacets(const TetraView& tetras, FacetSource& surfaces, int count, BoxCutter& cutter,
                      FaceSink& sink)
{
    std::vector<FacetTetra> all;
    Box box{glm::dvec3(HUGE_VAL), glm::dvec3(-HUGE_VAL)};
    for (int number = 0; number < tetras.tetraCount(); ++number) {
        FacetTetra tetra(tetras, number);
        if (tetra.isFlat()) continue;
        box = {glm::min(box.lower, tetra.bounds().lower), glm::max(box.upper, tetra.bounds().upper)};
        all.push_back(std::move(tetra));
    }
    if (all.empty()) return true;

    FacetList facets;
    std::vector<FacetCorner> corners;
    FacetCutter facetCutter;
    CutPolygon polygon;
    for (int surface = 0; surface < count; ++surface) {
        facets.clear();
        surfaces.facetsOf(surface, box, facets);
        std::size_t first = 0;
        for (const int size : facets.counts) {
            const std::span<const glm::dvec3> facet(facets.corners.data() + first,
                                                    static_cast<std::size_t>(size));
            first += facet.size();
            if (!hasArea(facet)) continue;
            const Box bounds = boundsOf(facet);
            for (const FacetTetra& tetra : all) {
                if (!overlap(bounds, tetra.bounds())) continue;
                corners.clear();
                for (const glm::dvec3& p : facet)
                    corners.push_back({p, tetra.distances(p)});
                facetCutter.cut(tetra, corners, polygon);
                if (!cutter.cut(polygon, surface, sink)) return false;
            }
        }
    }
    return true;
}

} // namespace vo
