#pragma once

#include "core/box.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// A convex polyhedron: corners, and the sides of its faces, counterclockwise from outside. The sides of a
/// face follow each other in the arrays.
struct ConvexBody
{
    std::vector<glm::dvec3> corners;
    std::vector<std::uint32_t> from; ///< the corner where a side begins; it ends where the next one begins
    std::vector<std::uint32_t> next; ///< the next side of the face
    std::vector<std::uint32_t> twin; ///< the same edge in the neighbouring face

    bool empty() const { return corners.empty(); }
    Box bounds() const; ///< of a body that is not empty
    void clear();
};

/// An edge from a corner in front of a plane to one behind.
struct CutBodyEdge
{
    std::uint32_t front;
    std::uint32_t behind;
};

/// The edges that leave the corners in front (a value for each corner, not 0 is in front), in order round the
/// section: counterclockwise for who looks from behind to the front. Nothing when all are on one side.
void sectionOf(const ConvexBody& body, std::span<const std::uint8_t> inFront,
               std::vector<CutBodyEdge>& edges);

/// Makes bodies, with memory that stays from call to call.
class BodyCutter
{
public:
    void makeBox(const Box& box, ConvexBody& out);

    /// Cuts a body in two where `distances` (one a corner, linear over the body) is zero. Corners at zero
    /// count as above. `below` and `above` get the same new corners, bit for bit, and so do other bodies
    /// which share the edge that is cut; with an axis (0, 1, 2; -1: none) they lie at `coordinate` on it.
    void split(const ConvexBody& body, std::span<const double> distances, int axis, double coordinate,
               ConvexBody& below, ConvexBody& above);

private:
    void take(const ConvexBody& body, bool above, ConvexBody& out);
    void addCap(const ConvexBody& body, bool above, ConvexBody& out);
    void endFace(ConvexBody& out);
    void pairSides(ConvexBody& out);

    struct Paired
    {
        std::uint64_t edge;
        std::uint32_t side;
    };
    std::uint32_t faceStart_ = 0;
    std::vector<Paired> pairs_;
    std::vector<std::uint8_t> isAbove_; ///< of each corner
    std::vector<std::uint8_t> seen_;
    std::vector<std::uint32_t> cutOfSide_; ///< the new corner on a side, or kNone
    std::vector<std::uint32_t> number_;    ///< of a corner that is kept
    std::vector<glm::dvec3> cuts_;
};

} // namespace vo
