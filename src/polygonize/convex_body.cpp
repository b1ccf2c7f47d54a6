#include "polygonize/convex_body.h"

#include "polygonize/slice_tetra.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cassert>

namespace vo {

namespace {

constexpr std::uint32_t kNone = UINT32_MAX;

/// Calls found(side) for the sides that leave the corners chosen, round the cut, clockwise for who looks from
/// the others to them. `start` is one of these sides.
template <class Chosen, class Found>
void walkRound(const ConvexBody& body, std::uint32_t start, const Chosen& chosen, const Found& found)
{
    std::uint32_t side = start;
    do {
        found(side);
        while (!chosen(body.from[body.next[side]]))
            side = body.next[side];
        side = body.twin[side];
    } while (side != start);
}

} // namespace

Box ConvexBody::bounds() const
{
    assert(!empty());
    Box box{corners.front(), corners.front()};
    for (const glm::dvec3& p : corners)
        box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    return box;
}

void ConvexBody::clear()
{
    corners.clear();
    from.clear();
    next.clear();
    twin.clear();
}

void sectionOf(const ConvexBody& body, std::span<const std::uint8_t> inFront, std::vector<CutBodyEdge>& edges)
{
    edges.clear();
    const auto chosen = [&](std::uint32_t corner) { return inFront[corner] != 0; };
    for (std::uint32_t side = 0; side < body.from.size(); ++side) {
        if (!chosen(body.from[side]) || chosen(body.from[body.next[side]])) continue;
        walkRound(body, side, chosen, [&](std::uint32_t leaving) {
            edges.push_back({body.from[leaving], body.from[body.next[leaving]]});
        });
        break;
    }
    std::ranges::reverse(edges);
}

void BodyCutter::endFace(ConvexBody& out)
{
    const auto end = static_cast<std::uint32_t>(out.from.size());
    for (std::uint32_t side = faceStart_; side < end; ++side)
        out.next.push_back(side + 1 < end ? side + 1 : faceStart_);
    faceStart_ = end;
}

void BodyCutter::pairSides(ConvexBody& out)
{
    pairs_.clear();
    for (std::uint32_t side = 0; side < out.from.size(); ++side) {
        const std::uint64_t a = out.from[side], b = out.from[out.next[side]];
        pairs_.push_back({std::min(a, b) << 32 | std::max(a, b), side});
    }
    std::ranges::sort(pairs_, {}, &Paired::edge);
    out.twin.assign(out.from.size(), kNone);
    for (std::size_t i = 0; i + 1 < pairs_.size(); i += 2) {
        assert(pairs_[i].edge == pairs_[i + 1].edge);
        out.twin[pairs_[i].side] = pairs_[i + 1].side;
        out.twin[pairs_[i + 1].side] = pairs_[i].side;
    }
}

void BodyCutter::makeBox(const Box& box, ConvexBody& out)
{
    out.clear();
    for (int corner = 0; corner < 8; ++corner)
        out.corners.emplace_back(corner & 1 ? box.upper.x : box.lower.x,
                                 corner & 2 ? box.upper.y : box.lower.y,
                                 corner & 4 ? box.upper.z : box.lower.z);
    constexpr std::array<std::array<std::uint32_t, 4>, 6> kFaces{
        {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};
    faceStart_ = 0;
    for (const auto& face : kFaces) {
        out.from.insert(out.from.end(), face.begin(), face.end());
        endFace(out);
    }
    pairSides(out);
}

void BodyCutter::split(const ConvexBody& body, std::span<const double> distances, int axis, double coordinate,
                       ConvexBody& below, ConvexBody& above)
{
    assert(&below != &body && &above != &body && &below != &above);
    below.clear();
    above.clear();
    if (body.empty()) return;
    const auto [low, high] = std::ranges::minmax(distances);
    if (low >= 0.0 || high <= 0.0) {
        (low >= 0.0 ? above : below) = body;
        return;
    }
    isAbove_.resize(body.corners.size());
    for (std::size_t i = 0; i < body.corners.size(); ++i)
        isAbove_[i] = distances[i] >= 0.0;
    cutOfSide_.assign(body.from.size(), kNone);
    cuts_.clear();
    for (std::uint32_t side = 0; side < body.from.size(); ++side) {
        const std::uint32_t a = body.from[side], b = body.from[body.next[side]];
        if (!isAbove_[a] || isAbove_[b]) continue;
        glm::dvec3 cut;
        cutEdge(&body.corners[a].x, &body.corners[b].x, distances[a], distances[b], 3, &cut.x);
        if (axis >= 0) cut[axis] = coordinate;
        cutOfSide_[side] = cutOfSide_[body.twin[side]] = static_cast<std::uint32_t>(cuts_.size());
        cuts_.push_back(cut);
    }
    take(body, true, above);
    take(body, false, below);
}

/// The part of `body` on one side of the cut.
void BodyCutter::take(const ConvexBody& body, bool above, ConvexBody& out)
{
    out.corners.assign(cuts_.begin(), cuts_.end());
    number_.assign(body.corners.size(), kNone);
    for (std::size_t i = 0; i < body.corners.size(); ++i) {
        if ((isAbove_[i] != 0) != above) continue;
        number_[i] = static_cast<std::uint32_t>(out.corners.size());
        out.corners.push_back(body.corners[i]);
    }
    faceStart_ = 0;
    for (std::uint32_t side = 0; side < body.from.size(); ++side) {
        const std::uint32_t kept = number_[body.from[side]];
        if (kept != kNone) out.from.push_back(kept);
        if (cutOfSide_[side] != kNone) out.from.push_back(cutOfSide_[side]);
        if (body.next[side] <= side) endFace(out);
    }
    addCap(body, above, out);
    pairSides(out);
}

/// The face that closes the cut, against the sides between two new corners that the faces cut have got.
void BodyCutter::addCap(const ConvexBody& body, bool above, ConvexBody& out)
{
    const auto chosen = [&](std::uint32_t corner) { return (isAbove_[corner] != 0) == above; };
    seen_.assign(body.from.size(), 0);
    for (std::uint32_t side = 0; side < body.from.size(); ++side) {
        if (seen_[side] || cutOfSide_[side] == kNone || !chosen(body.from[side])) continue;
        walkRound(body, side, chosen, [&](std::uint32_t leaving) {
            seen_[leaving] = 1;
            out.from.push_back(cutOfSide_[leaving]);
        });
        std::reverse(out.from.begin() + faceStart_, out.from.end());
        endFace(out);
    }
}

} // namespace vo
