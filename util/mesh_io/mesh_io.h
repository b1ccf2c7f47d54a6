#pragma once

/// Meshes of cells with fields, in files (docs/formats.md). Needs neither the library nor OpenGL. Nothing
/// here prints: what goes wrong comes back as a Failure.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/cell_split.h"
#include "volume_io/result.h"

namespace vo {

/// Numbers at the points or on the cells of a mesh.
struct MeshField
{
    std::string name;
    /// Numbers at one point or on one cell, side by side.
    int components = 1;
    /// Red, green, blue and (4 components) opacity, from 0 to 1.
    bool isColor = false;
    /// `components` for each point or cell; NaN where the file has none.
    std::vector<double> values;
};

/// What a file has that a mesh has not, or not as the file has it. Numbers of cells.
struct CellCounts
{
    /// In the file, of all kinds.
    std::int64_t inFile = 0;
    // Skipped:
    std::int64_t surfaces = 0; ///< points, lines and faces
    std::int64_t unknown = 0;  ///< of kinds that are not read
    std::int64_t broken = 0;   ///< with too few corners, or corners that are no points of the file
    std::int64_t endless = 0;  ///< with a coordinate that is no finite number
    std::int64_t flat = 0;     ///< of no volume
    std::int64_t twisted = 0;  ///< partly inside out
    std::int64_t repeated = 0; ///< with the corners of another
    // Kept:
    std::int64_t inverted = 0; ///< inside out, turned round
    std::int64_t curved = 0;   ///< with points between corners, which are not kept

    std::int64_t skipped() const { return surfaces + unknown + broken + endless + flat + twisted + repeated; }
    /// For a message: "12 of 160 cells skipped: 3 flat, 9 repeated; 2 cells inside out turned round"; empty
    /// where there is nothing to say.
    std::string text() const;
};

/// Cells and fields. All corners are points, all cells have a volume and the handedness of CellKind, no two
/// the same corners.
struct Mesh
{
    /// "VTK 3.0 binary", "VTU", "Gmsh 4.1" ...
    std::string format;
    std::vector<std::array<double, 3>> points;
    std::vector<CellKind> kinds;
    /// Point numbers, cell after cell, as many as the kind has corners.
    std::vector<std::int64_t> corners;
    std::vector<MeshField> pointFields, cellFields;
    CellCounts counts;
    /// What else a user should know, one line each without the file's name.
    std::vector<std::string> notes;

    std::size_t cellCount() const { return kinds.size(); }
};

/// Reads a mesh, in a format that is known by the file's content, for plain text by its ending:
///  - VTK's files of before XML, UNSTRUCTURED_GRID, ascii and binary, versions 1 to 5.1;
///  - VTU: ascii, base64 and appended data, also zlib-compressed;
///  - Gmsh: .msh 2.2 and 4.1, ascii and binary, and parsed views with scalars on cells (.pos);
///  - TetGen's .node and .ele, of which `path` is either.
/// Any of them may be compressed with gzip. Cells that cannot be drawn are counted, and left out. A failure
/// where the file is damaged or cut off, or holds no cell at all.
Result<Mesh> readMesh(const std::string& path);

/// A mesh of tetrahedra alone that fills the same space and has no cracks: faces of four corners are cut from
/// their smallest point number.
struct SplitMesh
{
    /// Those of the mesh, then a middle for each cell that needs one.
    std::vector<std::array<double, 3>> points;
    /// Of the cells with a middle, in the order of these points.
    std::vector<std::int64_t> middleOfCell;
    /// Point numbers of tetrahedra of positive volume.
    std::vector<std::array<std::int64_t, 4>> tetras;
    /// The cell that each tetrahedron is a part of.
    std::vector<std::int64_t> cellOfTetra;
};

SplitMesh splitMesh(const Mesh& mesh);

/// A field at the points of the split mesh: in the middle of a cell, the mean of its corners.
std::vector<double> valuesAtPoints(const Mesh& mesh, const SplitMesh& split, const MeshField& pointField);

} // namespace vo
