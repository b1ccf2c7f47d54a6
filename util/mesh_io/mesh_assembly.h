#pragma once

#include <optional>

#include "mesh_io.h"
#include "volume_io/input_file.h"

namespace vo {

/// What readers of formats put together, as the file has it and unchecked.
class MeshAssembly
{
public:
    explicit MeshAssembly(std::string path) : path_(std::move(path)) {}

    const std::string& path() const { return path_; }

    std::string format;
    std::vector<std::array<double, 3>> points;
    /// A value for each point of the file, or for each cell, those that are skipped among them.
    std::vector<MeshField> pointFields, cellFields;
    std::vector<std::string> notes;

    /// The next cell of the file. Point numbers may be anything. `curved`: the file has more points for it.
    void addCell(CellKind kind, std::span<const std::int64_t> corners, bool curved = false);
    /// The same for cells of no volume, and for those of unknown kinds.
    void skipSurface();
    void skipUnknown();
    /// For a cell with too few corners.
    void skipBroken();
    std::int64_t cellsInFile() const { return counts_.inFile; }

    /// Checks and turns round cells, and leaves out those that are no use. A failure where fields do not fit,
    /// or nothing is left.
    Result<Mesh> finish() &&;

private:
    Result<void> checkField(const MeshField& field, std::size_t expected, const char* what) const;

    std::string path_;
    std::vector<CellKind> kinds_;
    std::vector<std::int64_t> corners_;
    std::vector<std::int64_t> places_; ///< among the cells of the file
    CellCounts counts_;
};

/// Where cells of one kind stand in a format's numbering of kinds.
enum class CellClass { solid, surface, unknown };
struct CellCode
{
    CellClass is = CellClass::unknown;
    CellKind kind = CellKind::tetra;
    /// Points that a cell has in all; 0: any number.
    int points = 0;
};

/// Adds a cell of a format: `corners` as many as it says, more than the kind's where it is curved.
void addCodedCell(MeshAssembly& mesh, const CellCode& code, std::span<const std::int64_t> corners);

/// VTK's types; with addVtkCell, which turns voxels and wedges to our order.
CellCode vtkCellCode(std::int64_t type);
void addVtkCell(MeshAssembly& mesh, std::int64_t type, std::span<const std::int64_t> corners);

/// The readers of formats. `bytes` is the whole file, decompressed.
Result<Mesh> readLegacyVtk(const std::string& path, std::string_view bytes);
Result<Mesh> readVtu(const std::string& path, std::string_view bytes);
Result<Mesh> readGmsh(const std::string& path, std::string_view bytes);
Result<Mesh> readGmshView(const std::string& path, std::string_view bytes);
Result<Mesh> readTetGen(const std::string& path);

/// The whole file, decompressed if it is a gzip file.
Result<std::string> readWholeFile(const std::string& path);

} // namespace vo
