#include "vout/hexa_coloring.h"

#include <utility>

namespace vo {

namespace {

constexpr int kEdges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                               {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

std::size_t at(int vertex)
{
    return static_cast<std::size_t>(vertex);
}

} // namespace

HexaColoring::HexaColoring(const Cells& hexas, int vertexCount)
    : parent_(at(vertexCount)), size_(at(vertexCount), 1), odd_(at(vertexCount), false),
      possible_(at(vertexCount), true), rootColor_(at(vertexCount), false)
{
    for (int vertex = 0; vertex < vertexCount; ++vertex)
        parent_[at(vertex)] = vertex;
    for (std::size_t first = 0; first < hexas.corners.size(); first += kMostCorners)
        for (const auto& [from, to] : kEdges)
            join(hexas.corners[first + at(from)], hexas.corners[first + at(to)]);
    for (int vertex = 0; vertex < vertexCount; ++vertex)
        find(vertex);
    std::vector<bool> seen(at(vertexCount), false);
    for (std::size_t first = 0; first < hexas.corners.size(); first += kMostCorners) {
        const int corner = hexas.corners[first];
        if (seen[root(corner)]) continue;
        seen[root(corner)] = true;
        rootColor_[root(corner)] = isOdd(corner);
    }
}

/// The root of a vertex, to which it and those on the way are then tied directly.
int HexaColoring::find(int vertex)
{
    bool odd = false;
    int top = vertex;
    while (parent_[at(top)] != top) {
        odd = odd != isOdd(top);
        top = parent_[at(top)];
    }
    while (parent_[at(vertex)] != vertex) {
        const bool ownOdd = isOdd(vertex);
        odd_[at(vertex)] = odd;
        odd = odd != ownOdd;
        vertex = std::exchange(parent_[at(vertex)], top);
    }
    return top;
}

void HexaColoring::join(int a, int b)
{
    int rootA = find(a), rootB = find(b);
    if (rootA == rootB) {
        if (isOdd(a) == isOdd(b)) possible_[at(rootA)] = false;
        return;
    }
    const bool differ = isOdd(a) == isOdd(b);
    if (size_[at(rootA)] < size_[at(rootB)]) std::swap(rootA, rootB);
    parent_[at(rootB)] = rootA;
    odd_[at(rootB)] = differ;
    size_[at(rootA)] += size_[at(rootB)];
    if (!possible_[at(rootB)]) possible_[at(rootA)] = false;
}

} // namespace vo
