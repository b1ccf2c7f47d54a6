#pragma once

#include "style/voxel_texture.h"

#include <glm/vec4.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

namespace vo {

class GlslChain;

/// Tables in one texture, each from the beginning of a row of a list (texel_list.h) on. Programs fetch the
/// texels of a table and mix them themselves: no filter reaches into the next one.
class TableStack
{
public:
    /// Puts a table there, if it is not there yet. The GLSL of its texel at a vec3 `place` of values, which
    /// change along the first `axes` axes and are 0 along the others, is a vec4. What the table is like is a
    /// uniform; the program has to declare `sampler3D stackedTables`, and kListPlaceGlsl.
    std::string write(GlslChain& chain, const std::shared_ptr<const VoxelTexture>& table, int axes,
                      const std::string& place);

    bool empty() const { return tables_.empty(); }
    /// Of the tables, in their order: stacks of the same ones are the same.
    std::vector<std::uint64_t> serials() const;
    /// How large texture() is.
    VoxelSize size() const;
    /// Of four components, 0 where a table has less, in the finest kind that a table has.
    VoxelTexture texture() const;

private:
    struct Entry
    {
        std::shared_ptr<const VoxelTexture> table;
        std::uint64_t firstRow;
    };

    const Entry& add(const std::shared_ptr<const VoxelTexture>& table);

    std::vector<Entry> tables_;
    std::unordered_map<std::uint64_t, std::size_t> numbers_; ///< by serial
    std::uint64_t rows_ = 0;
};

} // namespace vo
