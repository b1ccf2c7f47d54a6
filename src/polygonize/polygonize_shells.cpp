#include "polygonize/polygonize_shells.h"

#include "polygonize/facet_cutter.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace vo {

namespace {

/// A tetrahedron, and where it lies seen from the eye.
struct ShellTetra
{
    FacetTetra tetra;
    DepthRange range;
    glm::dvec3 axis{0.0}; ///< of a cone of directions that holds it
    double halfAngle = 0.0;
    bool everywhere = false; ///< no cone does
};

/// Wider cones count as all directions.
constexpr double kWidestCone = 1.4;

ShellTetra seen(const TetraView& tetras, int number, const ShellFamily& shells)
{
    ShellTetra result{FacetTetra(tetras, number), shellRange(tetras, number, shells)};
    std::array<glm::dvec3, 4> directions;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 p = tetras.position(tetras.indices[static_cast<std::size_t>(number) * 4 + i]);
        directions[i] = glm::normalize((p - shells.eye) / shells.scale);
        result.axis += directions[i];
    }
    result.axis = glm::normalize(result.axis);
    for (const glm::dvec3& direction : directions)
        result.halfAngle =
            std::max(result.halfAngle, std::acos(std::clamp(glm::dot(direction, result.axis), -1.0, 1.0)));
    const bool cone = result.range.nearest > 0.0 && result.halfAngle < kWidestCone;
    result.everywhere = !cone || !std::isfinite(result.axis.x + result.halfAngle);
    return result;
}

class ShellCutter
{
public:
    ShellCutter(BoxCutter& boxes, FaceSink& sink) : boxes_(boxes), sink_(sink) {}

    void useShell(const ShellFamily& shells, int k)
    {
        grid_.assign(shells, k);
        sample_ = k;
        const double error = kChordError * shells.spacing;
        reach_ = {shells.radius(k) - error, shells.radius(k) + error};
    }

    /// False: the sink had no room.
    bool cut(const ShellTetra& tetra)
    {
        if (tetra.range.farthest < reach_.nearest || tetra.range.nearest > reach_.farthest) return true;
        const ShellGrid::Range range =
            tetra.everywhere ? grid_.allFacets() : grid_.facetsInCone(tetra.axis, tetra.halfAngle);
        grid_.select(range);
        fillRow(tetra.tetra, range.firstRing, range, upper_);
        for (int ring = range.firstRing; ring <= range.lastRing; ++ring) {
            std::swap(lower_, upper_);
            fillRow(tetra.tetra, ring + 1, range, upper_);
            for (std::size_t j = 0; j + 1 < lower_.size(); ++j)
                if (!cutFacet(tetra.tetra, j)) return false;
        }
        return true;
    }

private:
    void fillRow(const FacetTetra& tetra, int ring, const ShellGrid::Range& range,
                 std::vector<FacetCorner>& row)
    {
        row.clear();
        for (int sector = range.firstSector; sector <= range.lastSector + 1; ++sector) {
            const glm::dvec3 p = grid_.vertex(ring, sector);
            row.push_back({p, tetra.distances(p)});
        }
    }

    /// Counterclockwise for the eye, to whom meridians run from right to left. At the poles two corners are
    /// one.
    bool cutFacet(const FacetTetra& tetra, std::size_t j)
    {
        const std::array<FacetCorner, 4> facet{lower_[j + 1], lower_[j], upper_[j], upper_[j + 1]};
        for (int face = 0; face < 4; ++face)
            if (std::none_of(facet.begin(), facet.end(), [&](const FacetCorner& corner) {
                    return tetra.isInside(face, corner.distances[static_cast<std::size_t>(face)]);
                }))
                return true;
        facets_.cut(tetra, facet, polygon_);
        return boxes_.cut(polygon_, sample_, sink_);
    }

    BoxCutter& boxes_;
    FaceSink& sink_;
    ShellGrid grid_;
    int sample_ = 0;
    DepthRange reach_;
    std::vector<FacetCorner> lower_, upper_;
    FacetCutter facets_;
    CutPolygon polygon_;
};

} // namespace

bool polygonizeShells(const TetraView& tetras, const ShellFamily& shells, const SamplingRequest& request,
                      BoxCutter& cutter, FaceSink& sink)
{
    ShellCutter shellCutter(cutter, sink);
    std::vector<ShellTetra> all;
    for (int number = 0; number < tetras.tetraCount(); ++number) {
        ShellTetra tetra = seen(tetras, number, shells);
        if (!tetra.tetra.isFlat() && !tetra.range.empty()) all.push_back(std::move(tetra));
    }
    if (request.space == SamplingSpace::primitive) {
        for (const ShellTetra& tetra : all) {
            const ShellFamily own = primitiveShells(shells, tetra.range, request);
            for (int k = 0; k < own.count; ++k) {
                shellCutter.useShell(own, k);
                if (!shellCutter.cut(tetra)) return false;
            }
        }
        return true;
    }
    for (int k = 0; k < shells.count; ++k) {
        shellCutter.useShell(shells, k);
        for (const ShellTetra& tetra : all)
            if (!shellCutter.cut(tetra)) return false;
    }
    return true;
}

} // namespace vo
