#include "vout/block_tetras.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace vo {

namespace {

constexpr int kNobody = -1;

/// A rectangle of a box's side with one box, or nothing, behind it. Both boxes find the same.
struct Patch
{
    std::size_t axis;  ///< across it
    BlockPlace corner; ///< corners of blocks, the lowest
    int uSize, vSize;  ///< along the next two axes, blocks
};

using Triangle = std::array<int, 3>;

/// Corners of patches are the vertices. The outline of a patch runs over all of them that lie on it: then each side of a
/// face, and of an edge, has the same ones. A patch is cut by lines from its lowest corner, or from a vertex in its
/// middle where others lie between this corner and the next ones. A box is cut likewise: from its lowest corner where all
/// sides round this are whole patches cut from there, or from its middle.
class BlockMesher
{
public:
    BlockMesher(const BlockGrid& grid, std::span<const BlockBox> boxes) : grid_(grid), boxes_(boxes)
    {
        requireCountable(boxes.size(), kUsualTetras);
        findOwners();
        findVertices();
    }

    TetraMesh mesh()
    {
        for (const BlockBox& box : boxes_)
            addBox(box);
        if (!boxes_.empty() && !fillsVolume()) addVolumeCorners();
        requireCountable(mesh_.tetras.size() / VO_TETRA_VERTICES, 1);
        return std::move(mesh_);
    }

private:
    static constexpr int kUsualTetras = 6;

    void findOwners()
    {
        owner_.assign(grid_.occupied.size(), kNobody);
        for (std::size_t number = 0; number < boxes_.size(); ++number) {
            const BlockBox& box = boxes_[number];
            for (int z = box.lower[2]; z < box.upper[2]; ++z)
                for (int y = box.lower[1]; y < box.upper[1]; ++y)
                    std::fill_n(owner_.begin() +
                                    static_cast<std::ptrdiff_t>(grid_.index({box.lower[0], y, z})),
                                box.upper[0] - box.lower[0], static_cast<int>(number));
        }
    }

    std::size_t latticeIndex(const BlockPlace& corner) const
    {
        const auto at = [&](std::size_t axis) { return static_cast<std::size_t>(corner[axis]); };
        return (at(2) * static_cast<std::size_t>(grid_.count[1] + 1) + at(1)) *
                   static_cast<std::size_t>(grid_.count[0] + 1) +
               at(0);
    }

    /// Numbers ascend with the place, so that the lowest corner of anything has the smallest.
    void findVertices()
    {
        const BlockPlace& count = grid_.count;
        vertexAt_.assign(latticeIndex(count) + 1, kNobody);
        for (const BlockBox& box : boxes_)
            for (int side = 0; side < 6; ++side)
                for (const Patch& patch : patchesOf(box, side))
                    for (int corner = 0; corner < 4; ++corner)
                        vertexAt_[latticeIndex(
                            placeIn(patch, corner & 1 ? patch.uSize : 0, corner & 2 ? patch.vSize : 0))] = 0;
        int number = 0;
        for (int z = 0; z <= count[2]; ++z)
            for (int y = 0; y <= count[1]; ++y)
                for (int x = 0; x <= count[0]; ++x) {
                    int& vertex = vertexAt_[latticeIndex({x, y, z})];
                    if (vertex == kNobody) continue;
                    vertex = number++;
                    addRecord({x, y, z});
                }
    }

    int addRecord(const BlockPlace& corner)
    {
        for (std::size_t axis = 0; axis < 3; ++axis)
            mesh_.records.push_back(static_cast<float>(grid_.voxel(axis, corner[axis])));
        return static_cast<int>(mesh_.vertexCount()) - 1;
    }

    static BlockPlace placeIn(const Patch& patch, int u, int v)
    {
        BlockPlace place = patch.corner;
        place[(patch.axis + 1) % 3] += u;
        place[(patch.axis + 2) % 3] += v;
        return place;
    }

    /// Sides 0 to 2 are the lower ones across x, y and z, 3 to 5 the upper ones.
    std::vector<Patch> patchesOf(const BlockBox& box, int side) const
    {
        const auto axis = static_cast<std::size_t>(side % 3), uAxis = (axis + 1) % 3, vAxis = (axis + 2) % 3;
        const bool upper = side >= 3;
        const int us = box.upper[uAxis] - box.lower[uAxis], vs = box.upper[vAxis] - box.lower[vAxis];
        BlockPlace behind = box.lower, corner = box.lower;
        behind[axis] = upper ? box.upper[axis] : box.lower[axis] - 1;
        if (upper) corner[axis] = box.upper[axis];
        std::vector<int> neighbours;
        for (int v = 0; v < vs; ++v)
            for (int u = 0; u < us; ++u) {
                BlockPlace block = behind;
                block[uAxis] += u;
                block[vAxis] += v;
                const bool outside = block[axis] < 0 || block[axis] == grid_.count[axis];
                neighbours.push_back(outside ? kNobody : owner_[grid_.index(block)]);
            }
        return rectangles(axis, corner, us, vs, neighbours);
    }

    /// Cuts a side into rectangles with one neighbour each.
    static std::vector<Patch> rectangles(std::size_t axis, const BlockPlace& corner, int us, int vs,
                                         std::vector<int>& neighbours)
    {
        constexpr int kTaken = -2;
        std::vector<Patch> patches;
        const auto at = [&](int u, int v) -> int& { return neighbours[static_cast<std::size_t>(v * us + u)]; };
        for (int v = 0; v < vs; ++v)
            for (int u = 0; u < us; ++u) {
                const int neighbour = at(u, v);
                if (neighbour == kTaken) continue;
                int uEnd = u, vEnd = v + 1;
                while (uEnd < us && at(uEnd, v) == neighbour)
                    ++uEnd;
                const auto goesOn = [&](int row) {
                    for (int i = u; i < uEnd; ++i)
                        if (at(i, row) != neighbour) return false;
                    return true;
                };
                while (vEnd < vs && goesOn(vEnd))
                    ++vEnd;
                for (int j = v; j < vEnd; ++j)
                    std::fill(&at(u, j), &at(u, j) + (uEnd - u), kTaken);
                const Patch whole{axis, corner, us, vs};
                patches.push_back({axis, placeIn(whole, u, v), uEnd - u, vEnd - v});
            }
        return patches;
    }

    /// The vertices round a patch, from its lowest corner along u.
    std::vector<int> outlineOf(const Patch& patch) const
    {
        std::vector<int> outline;
        int u = 0, v = 0;
        const auto walk = [&](int du, int dv, int steps) {
            for (int step = 0; step < steps; ++step, u += du, v += dv)
                if (const int vertex = vertexAt_[latticeIndex(placeIn(patch, u, v))]; vertex != kNobody)
                    outline.push_back(vertex);
        };
        walk(1, 0, patch.uSize);
        walk(0, 1, patch.vSize);
        walk(-1, 0, patch.uSize);
        walk(0, -1, patch.vSize);
        return outline;
    }

    bool isCutFromCorner(const Patch& patch, const std::vector<int>& outline) const
    {
        return outline[1] == vertexAt_[latticeIndex(placeIn(patch, patch.uSize, 0))] &&
               outline.back() == vertexAt_[latticeIndex(placeIn(patch, 0, patch.vSize))];
    }

    int middleOf(const Patch& patch)
    {
        const std::size_t key = 3 * latticeIndex(patch.corner) + patch.axis;
        const auto [known, isNew] = middles_.try_emplace(key, 0);
        if (isNew) {
            std::array<int, 4> corners{};
            for (int corner = 0; corner < 4; ++corner)
                corners[static_cast<std::size_t>(corner)] = vertexAt_[latticeIndex(
                    placeIn(patch, corner & 1 ? patch.uSize : 0, corner & 2 ? patch.vSize : 0))];
            known->second = mesh_.appendMean(corners);
        }
        return known->second;
    }

    void appendTriangles(const Patch& patch, std::vector<Triangle>& triangles)
    {
        const std::vector<int> outline = outlineOf(patch);
        const std::size_t count = outline.size();
        if (isCutFromCorner(patch, outline)) {
            for (std::size_t i = 1; i + 1 < count; ++i)
                triangles.push_back({outline[0], outline[i], outline[i + 1]});
            return;
        }
        const int middle = middleOf(patch);
        for (std::size_t i = 0; i < count; ++i)
            triangles.push_back({middle, outline[i], outline[(i + 1) % count]});
    }

    bool isCutFromCorner(const BlockBox& box) const
    {
        for (int side = 0; side < 3; ++side) {
            const std::vector<Patch> patches = patchesOf(box, side);
            if (patches.size() > 1 || !isCutFromCorner(patches[0], outlineOf(patches[0]))) return false;
        }
        return true;
    }

    int middleOf(const BlockBox& box)
    {
        std::array<int, 2> corners{vertexAt_[latticeIndex(box.lower)], vertexAt_[latticeIndex(box.upper)]};
        return mesh_.appendMean(corners);
    }

    void addBox(const BlockBox& box)
    {
        const bool fromCorner = isCutFromCorner(box);
        std::vector<Triangle> triangles;
        for (int side = fromCorner ? 3 : 0; side < 6; ++side)
            for (const Patch& patch : patchesOf(box, side))
                appendTriangles(patch, triangles);
        const int apex = fromCorner ? vertexAt_[latticeIndex(box.lower)] : middleOf(box);
        for (const auto& [a, b, c] : triangles) {
            const Tetra tetra{a, b, c, apex};
            const Tetra turned{a, c, b, apex};
            const Tetra& positive = sixfoldVolume(mesh_, tetra) > 0 ? tetra : turned;
            mesh_.tetras.insert(mesh_.tetras.end(), positive.begin(), positive.end());
        }
    }

    bool fillsVolume() const
    {
        return std::ranges::find(owner_, kNobody) == owner_.end();
    }

    void addVolumeCorners()
    {
        for (int corner = 0; corner < 8; ++corner)
            mesh_.tetras.push_back(addRecord({corner & 1 ? grid_.count[0] : 0, corner & 2 ? grid_.count[1] : 0,
                                              corner & 4 ? grid_.count[2] : 0}));
    }

    const BlockGrid& grid_;
    std::span<const BlockBox> boxes_;
    std::vector<int> owner_;    ///< of each block: the number of a box
    std::vector<int> vertexAt_; ///< corners of blocks, x fastest
    std::unordered_map<std::size_t, int> middles_; ///< of patches
    TetraMesh mesh_;
};

} // namespace

TetraMesh blockTetras(const BlockGrid& grid, std::span<const BlockBox> boxes)
{
    return BlockMesher(grid, boxes).mesh();
}

} // namespace vo
