#pragma once

#include "geometry/cell_split.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

/// Which ways to split a cell do, where its corners lie.
namespace vo {

/// Six times the volume of a tetrahedron; positive as CornerTetra has it: one of three axes' unit vectors,
/// from the origin, has 1.
inline double sixfoldVolume(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                            const glm::dvec3& d)
{
    return glm::dot(glm::cross(b - a, c - a), d - a);
}

/// Corner number of the point in the middle of a cell's first face; the other faces' follow.
constexpr int kFaceMiddle = kCellMiddle + 1;
/// Points of a cell: its corners, its middle, and the middles of its faces.
constexpr int kCellPoints = kFaceMiddle + kMostFaces;

/// A cell in space, to judge pieces by.
class CellSpace
{
public:
    /// The place of corner i is corner(i). `precision`: how far off a coordinate of 1 may be.
    template <typename Corner>
    CellSpace(CellKind kind, const Corner& corner, double precision)
    {
        const CellShape& shape = shapeOf(kind);
        glm::dvec3 farthest(0), sum(0);
        for (std::size_t i = 0; i < static_cast<std::size_t>(shape.corners); ++i) {
            point_[i] = corner(i);
            farthest = glm::max(farthest, glm::abs(point_[i]));
            sum += point_[i];
        }
        point_[kCellMiddle] = sum / static_cast<double>(shape.corners);
        for (std::size_t f = 0; f < static_cast<std::size_t>(shape.faces); ++f) {
            glm::dvec3& middle = point_[kFaceMiddle + f];
            for (std::size_t i = 0; i < static_cast<std::size_t>(shape.face[f].corners); ++i)
                middle += at(shape.face[f].corner[i]);
            middle /= shape.face[f].corners;
        }
        error_ = precision * farthest;
    }

    const glm::dvec3& at(int point) const { return point_[static_cast<std::size_t>(point)]; }
    double volume(const CornerTetra& t) const
    {
        return sixfoldVolume(at(t[0]), at(t[1]), at(t[2]), at(t[3]));
    }
    /// Whether the errors of the corners could make such a volume of nothing.
    bool isFlat(const CornerTetra& t) const
    {
        const glm::dvec3 a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]), c = at(t[3]) - at(t[0]);
        const glm::dvec3 faces = glm::abs(glm::cross(a, b)) + glm::abs(glm::cross(b, c)) +
                                 glm::abs(glm::cross(c, a)) + glm::abs(glm::cross(b - a, c - a));
        return std::abs(glm::dot(glm::cross(a, b), c)) <= glm::dot(error_, faces);
    }
    /// +1 or -1 for a cell of one handedness or the other, by all its pieces; 0 where it has no volume.
    int handedness(const CellPieces& pieces) const
    {
        double sum = 0;
        bool flat = true;
        for (const CornerTetra& tetra : pieces.all()) {
            sum += volume(tetra);
            flat = flat && isFlat(tetra);
        }
        return flat ? 0 : sum < 0 ? -1 : 1;
    }

private:
    std::array<glm::dvec3, kCellPoints> point_{};
    glm::dvec3 error_; ///< how far a corner may lie from where it should
};

/// Chooses among ways to split a cell of a handedness: the first whose pieces all have a volume, else the
/// first that has none inside out.
class SplitChoice
{
public:
    SplitChoice(const CellSpace& space, int hand) : space_(space), hand_(hand) {}

    /// Whether the search is over.
    bool takes(const CellPieces& pieces)
    {
        bool whole = true, insideOut = false;
        for (const CornerTetra& tetra : pieces.all()) {
            const bool positive = hand_ * space_.volume(tetra) > 0;
            whole = whole && positive;
            insideOut = insideOut || (!positive && !space_.isFlat(tetra));
        }
        if (whole || (!chosen_ && !insideOut)) chosen_ = pieces;
        return whole;
    }
    const std::optional<CellPieces>& chosen() const { return chosen_; }

private:
    const CellSpace& space_;
    int hand_;
    std::optional<CellPieces> chosen_;
};

} // namespace vo
