#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace vo {

/// The edges that leave the corners in front of a plane, in order round the section of a positively oriented
/// tetrahedron: counterclockwise seen from behind the plane.
struct TetraSection
{
    struct Edge
    {
        int front;
        int behind;
    };
    int count; ///< 0, 3 or 4
    std::array<Edge, 4> edges;
};

/// Indexed by a bit for each corner that is in front.
constexpr std::array<TetraSection, 16> kTetraSections = [] {
    // How many corners are in front, and an even permutation that puts them first.
    struct Split
    {
        int inFront;
        std::array<int, 4> order;
    };
    constexpr std::array<Split, 16> kSplits{{
        {0, {0, 1, 2, 3}},
        {1, {0, 1, 2, 3}},
        {1, {1, 0, 3, 2}},
        {2, {0, 1, 2, 3}},
        {1, {2, 0, 1, 3}},
        {2, {0, 2, 3, 1}},
        {2, {1, 2, 0, 3}},
        {3, {0, 1, 2, 3}},
        {1, {3, 0, 2, 1}},
        {2, {0, 3, 1, 2}},
        {2, {1, 3, 2, 0}},
        {3, {0, 3, 1, 2}},
        {2, {2, 3, 0, 1}},
        {3, {0, 2, 3, 1}},
        {3, {1, 3, 2, 0}},
        {4, {0, 1, 2, 3}},
    }};
    std::array<TetraSection, 16> sections{};
    for (std::size_t mask = 0; mask < 16; ++mask) {
        const auto& v = kSplits[mask].order;
        switch (kSplits[mask].inFront) {
        case 1: sections[mask] = {3, {{{v[0], v[1]}, {v[0], v[2]}, {v[0], v[3]}, {0, 0}}}}; break;
        case 2: sections[mask] = {4, {{{v[0], v[2]}, {v[0], v[3]}, {v[1], v[3]}, {v[1], v[2]}}}}; break;
        case 3: sections[mask] = {3, {{{v[0], v[3]}, {v[1], v[3]}, {v[2], v[3]}, {0, 0}}}}; break;
        default: sections[mask] = {0, {}}; break;
        }
    }
    return sections;
}();

/// The corners of the edges of a section, the one of the lesser number first; a third edge stands for a
/// fourth where there is none.
struct EdgeEnds
{
    std::array<std::int64_t, 4> from;
    std::array<std::int64_t, 4> to;
};

/// By whether the tetrahedron is negatively oriented, and as kTetraSections.
constexpr std::array<std::array<EdgeEnds, 16>, 2> kEdgeEnds = [] {
    std::array<std::array<EdgeEnds, 16>, 2> ends{};
    for (std::size_t mirrored = 0; mirrored < 2; ++mirrored)
        for (std::size_t mask = 0; mask < 16; ++mask) {
            const TetraSection& section = kTetraSections[mask];
            for (int i = 0; i < 4 && section.count > 0; ++i) {
                const int vertex = i < section.count ? i : section.count - 1;
                const int edge = mirrored ? section.count - 1 - vertex : vertex;
                const auto [a, b] = section.edges[static_cast<std::size_t>(edge)];
                ends[mirrored][mask].from[static_cast<std::size_t>(i)] = a < b ? a : b;
                ends[mirrored][mask].to[static_cast<std::size_t>(i)] = a < b ? b : a;
            }
        }
    return ends;
}();

} // namespace vo
