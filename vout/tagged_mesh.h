#pragma once

#include "vout/tetra_mesh.h"

#include <vector>

namespace vo {

/// Meshes on records of one size as one, with a tag for each tetrahedron.
class TaggedMesh
{
public:
    /// Throws CallerError for records without a position.
    explicit TaggedMesh(int values = 3);

    /// Throws CallerError for records of another size, or more than ints can number, and appends nothing.
    void append(const TetraMesh& mesh, int tag);
    /// Makes vertices of equal records one, now and in what is appended later; returns how many fewer there are.
    int mergeVertices();

    const TetraMesh& mesh() const { return mesh_; }
    const std::vector<int>& tags() const { return tags_; }
    bool hasTag(int tag) const;
    TetraMesh extract(int tag) const;

private:
    TetraMesh mesh_;
    std::vector<int> tags_;
    bool merges_ = false;
};

} // namespace vo
