#pragma once

#include "geometry/tetra_view.h"

#include <algorithm>
#include <vector>

namespace vo {

/// A copy of tetrahedra, which tells whether others are the same. At first of none.
class KeptTetras
{
public:
    bool equal(const TetraView& tetras) const
    {
        return valuesPerVertex_ == tetras.valuesPerVertex && voxelColumn_ == tetras.voxelColumn &&
               std::ranges::equal(indices_, tetras.indices) && std::ranges::equal(records_, tetras.records);
    }

    /// Whether they are others than were kept; keeps them.
    bool renew(const TetraView& tetras)
    {
        if (equal(tetras)) return false;
        valuesPerVertex_ = tetras.valuesPerVertex;
        voxelColumn_ = tetras.voxelColumn;
        records_.assign(tetras.records.begin(), tetras.records.end());
        indices_.assign(tetras.indices.begin(), tetras.indices.end());
        return true;
    }

    int valuesPerVertex() const { return valuesPerVertex_; }
    int voxelColumn() const { return voxelColumn_; }

private:
    int valuesPerVertex_ = 0;
    int voxelColumn_ = -1;
    std::vector<float> records_;
    std::vector<int> indices_;
};

} // namespace vo
