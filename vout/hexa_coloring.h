#pragma once

#include "vout/cells.h"

#include <vector>

namespace vo {

/// Gives the vertices of hexahedra two colours so that the ends of each edge differ. Of a face the two vertices of
/// either colour face each other: cutting all faces between vertices of one colour makes neighbours agree.
class HexaColoring
{
public:
    /// The first corner of the first hexahedron of each connected part gets the colour false.
    HexaColoring(const Cells& hexas, int vertexCount);

    /// Whether the part of a vertex can be coloured; where not, its colours mean nothing.
    bool isPossible(int vertex) const { return possible_[root(vertex)]; }
    bool color(int vertex) const { return isOdd(vertex) != rootColor_[root(vertex)]; }

private:
    std::size_t root(int vertex) const { return static_cast<std::size_t>(parent_[static_cast<std::size_t>(vertex)]); }
    bool isOdd(int vertex) const { return odd_[static_cast<std::size_t>(vertex)]; }
    int find(int vertex);
    void join(int a, int b);

    // A forest: each vertex has a parent, itself at a root, and the colour of its parent or the other one.
    std::vector<int> parent_;
    std::vector<int> size_;
    std::vector<bool> odd_;
    std::vector<bool> possible_;
    std::vector<bool> rootColor_;
};

} // namespace vo
