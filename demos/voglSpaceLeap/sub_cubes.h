#pragma once

#include "voglVolume.h"

#include <array>
#include <cstddef>
#include <vector>

/* A volume in sub-cubes of one size, of which only some are needed. */

struct SubCubes
{
    /** Voxels along a side; the last ones of an axis may be cut short by the volume's end. */
    int size = 1;
    std::array<int, 3> count{};
    /** x fastest; not a vector of bool, since that is no array. */
    std::vector<char> needed;

    std::size_t index(int x, int y, int z) const
    {
        return (std::size_t(z) * std::size_t(count[1]) + std::size_t(y)) * std::size_t(count[0]) +
               std::size_t(x);
    }
};

/** From lower to upper, in sub-cubes; upper is the first one outside. */
struct SubCubeBox
{
    std::array<int, 3> lower{}, upper{};
};

/** Those sub-cubes are needed in which some value from `low` to `high` may show: their voxels and the ones
   next to them, between which textures interpolate, are neither all lower nor all higher. Of volumes of
   several channels all of them count. Reads the volume once more, a layer of sub-cubes at a time. */
SubCubes findSubCubes(const VoglSource& source, int size, double low, double high);

/** Covers what is needed by boxes that do not overlap: each grows along x, then y, then z as far as it can.
 */
std::vector<SubCubeBox> coalesce(const SubCubes& cubes);

/// The sub-cubes that are needed, a box each.
std::vector<SubCubeBox> separate(const SubCubes& cubes);
