#pragma once

#include "support/views.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

/// What the benchmarks draw, made by code and the same everywhere: volumes, tables, views, tetrahedra. All
/// positions in voxels: voxel i spans [i, i + 1] and is centred at i + 0.5; the volume ends at the centres of
/// its outermost voxels.
namespace bench {

/// A cube of bytes, x fastest, then y, then z.
struct Volume
{
    int side = 0;
    std::vector<std::uint8_t> voxels;
};

/// Volumes of `side` voxels a side:
/// vessels: bent tubes of falling density, empty between them;
/// cubes: solid cubes, each of one density, on a lattice of 32 / 256 of the side, 19 wide;
/// fog: a value everywhere, smooth with some noise;
/// skull: a thick shell round soft and hollow parts.
/// Throws std::invalid_argument for another name, or a side below 32 or above 2048.
Volume makeVolume(const std::string& name, int side);

/// The same, kept in `folder` as NAME-SIDE.raw for the next process that wants it.
Volume cachedVolume(const std::string& name, int side, const std::filesystem::path& folder);

/// 256 entries of red, green, blue and alpha; entry i stands for the value i / 255, between entries the value
/// is interpolated. Alpha is the opacity of one voxel's length, colours are not multiplied by it.
using Table = std::array<std::array<float, 4>, 256>;

/// sparse: colours, opaque up to 0.15 in the densest voxels, nothing in all but `visible` of the voxels;
/// dense: 2 / 255 to 4 / 255 opaque, everywhere; bone: nothing below, opaque from two thirds on;
/// grey: the value as a grey, opaque. Throws std::invalid_argument for another name.
Table makeTable(const std::string& name, const Volume& volume, double visible);

/// One picture of the benchmark.
struct Scene
{
    std::string name;
    std::string volume;
    int side = 256;
    std::string table;
    double visible = 1.0; ///< share of the voxels, for the table `sparse`
    bool maximum = false; ///< along each line of sight, of the table's colours
    bool perspective = false;
};

/// NAME is one of sceneNames(), with "/perspective" appended for that view and "@SIDE" for another side.
Scene sceneNamed(const std::string& name);
std::vector<std::string> sceneNames();

constexpr int kPictureSide = 512;   ///< pixels
constexpr double kViewAngle = 30.0; ///< degrees over the picture, perspective views

/// The viewer: from `distance` away, azimuth 30 and elevation 20 degrees (`turn` degrees more of azimuth),
/// at the volume's centre, y up. The picture's side is the volume's diagonal, or in perspective the ball
/// round the volume just fits.
struct Viewer
{
    double centre = 0.0;               ///< each coordinate of the volume's centre
    double radius = 0.0;               ///< half the diagonal
    std::array<double, 3> direction{}; ///< from the centre to the viewer, of length 1
    double distance = 0.0;
    vo::test::View view; ///< the same as OpenGL's matrices
};

Viewer viewerOf(const Scene& scene, double turn = 0.0);

/// cells^3 cells of five tetrahedra over [0, side]^3, every inner lattice point moved by up to a tenth of a
/// cell. Neighbours share faces.
struct Tetras
{
    std::vector<float> positions; ///< three a vertex
    std::vector<int> indices;     ///< four a tetrahedron
};

Tetras makeTetras(int cells, double side);

} // namespace bench
