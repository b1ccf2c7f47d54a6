#include "mesh_assembly.h"

#include "mesh_cell.h"

#include <algorithm>
#include <utility>

#include "volume_io/printable_text.h"

namespace vo {
namespace {

/// Judges cells one by one.
class CellCheck
{
public:
    explicit CellCheck(const std::vector<std::array<double, 3>>& points) : points_(points) {}

    bool isBroken(std::span<const std::int64_t> cell) const
    {
        return std::ranges::any_of(cell, [&](std::int64_t corner) {
            return corner < 0 || corner >= static_cast<std::int64_t>(points_.size());
        });
    }
    bool isEndless(std::span<const std::int64_t> cell) const
    {
        return std::ranges::any_of(cell, [&](std::int64_t corner) {
            return !std::ranges::all_of(points_[static_cast<std::size_t>(corner)],
                                        [](double x) { return std::abs(x) < 1e30; });
        });
    }
    /// 1 or -1 for a cell of our handedness or the other; 0 for one of no volume.
    int handedness(CellKind kind, std::span<const std::int64_t> cell) const
    {
        return cellSpace(kind, cell, points_).handedness(splitFromMiddle(kind, cutsFromSmallest(kind, cell)));
    }

private:
    const std::vector<std::array<double, 3>>& points_;
};

/// The cell as its mirror image.
void turnRound(CellKind kind, std::span<std::int64_t> cell)
{
    switch (kind) {
    case CellKind::tetra: std::swap(cell[2], cell[3]); return;
    case CellKind::pyramid: std::swap(cell[1], cell[3]); return;
    case CellKind::prism: std::swap_ranges(cell.begin(), cell.begin() + 3, cell.begin() + 3); return;
    case CellKind::hexa: std::swap_ranges(cell.begin(), cell.begin() + 4, cell.begin() + 4); return;
    }
}

/// Whether tetrahedra without negative volumes can be found for a cell.
bool canBeSplit(CellKind kind, std::span<const std::int64_t> cell,
                const std::vector<std::array<double, 3>>& points);

/// For each cell whether one before it has the same corners.
std::vector<bool> repeatedCells(const std::vector<CellKind>& kinds, const std::vector<std::int64_t>& corners)
{
    struct Entry
    {
        std::uint64_t hash;
        std::int64_t cell, first;
        int count;
    };
    std::vector<Entry> entries;
    entries.reserve(kinds.size());
    std::int64_t first = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const int count = shapeOf(kinds[i]).corners;
        // Of the corners as a set: their order does not matter.
        std::uint64_t hash = static_cast<std::uint64_t>(count);
        for (std::int64_t k = first; k < first + count; ++k) {
            auto mixed =
                static_cast<std::uint64_t>(corners[static_cast<std::size_t>(k)]) + 0x9e3779b97f4a7c15u;
            mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
            mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
            hash += mixed ^ (mixed >> 31);
        }
        entries.push_back({hash, static_cast<std::int64_t>(i), first, count});
        first += count;
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        return a.hash != b.hash ? a.hash < b.hash : a.cell < b.cell;
    });
    const auto sorted = [&](const Entry& entry) {
        std::vector<std::int64_t> cell(corners.begin() + entry.first,
                                       corners.begin() + entry.first + entry.count);
        std::ranges::sort(cell);
        return cell;
    };
    std::vector<bool> repeated(kinds.size());
    for (std::size_t i = 1; i < entries.size(); ++i)
        if (entries[i].hash == entries[i - 1].hash && sorted(entries[i]) == sorted(entries[i - 1]))
            repeated[static_cast<std::size_t>(entries[i].cell)] = true;
    return repeated;
}

bool canBeSplit(CellKind kind, std::span<const std::int64_t> cell,
                const std::vector<std::array<double, 3>>& points)
{
    Mesh one;
    one.kinds = {kind};
    for (const std::int64_t corner : cell)
        one.corners.push_back(corner);
    // Numbers keep their order, so that faces are cut as in the whole mesh.
    std::vector<std::int64_t> numbers = one.corners;
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    for (std::int64_t& corner : one.corners)
        corner = std::ranges::lower_bound(numbers, corner) - numbers.begin();
    for (const std::int64_t number : numbers)
        one.points.push_back(points[static_cast<std::size_t>(number)]);
    return !splitMesh(one).tetras.empty();
}

std::string counted(std::int64_t count, const char* what)
{
    return std::to_string(count) + " " + what;
}

void addPart(std::string& text, const std::string& part, const char* separator)
{
    text += (text.empty() ? "" : separator) + part;
}

} // namespace

std::string CellCounts::text() const
{
    std::string parts;
    for (const auto& [count, what] : {std::pair{surfaces, "points, lines or surfaces"},
                                      {unknown, "of kinds that are not read"},
                                      {broken, "with corners that are no points of the file"},
                                      {endless, "at points without finite coordinates"},
                                      {flat, "of no volume"},
                                      {twisted, "partly inside out"},
                                      {repeated, "repeated"}})
        if (count > 0) addPart(parts, counted(count, what), ", ");
    std::string all;
    if (skipped() > 0)
        all = std::to_string(skipped()) + " of " + std::to_string(inFile) + " cells skipped: " + parts;
    if (inverted > 0) addPart(all, counted(inverted, "cells inside out turned round"), "; ");
    if (curved > 0) addPart(all, counted(curved, "cells with curved edges taken as straight"), "; ");
    return all;
}

void MeshAssembly::addCell(CellKind kind, std::span<const std::int64_t> corners, bool curved)
{
    kinds_.push_back(kind);
    corners_.insert(corners_.end(), corners.begin(), corners.begin() + shapeOf(kind).corners);
    places_.push_back(counts_.inFile++);
    counts_.curved += curved;
}

void MeshAssembly::skipSurface()
{
    ++counts_.inFile;
    ++counts_.surfaces;
}

void MeshAssembly::skipUnknown()
{
    ++counts_.inFile;
    ++counts_.unknown;
}

void MeshAssembly::skipBroken()
{
    ++counts_.inFile;
    ++counts_.broken;
}

Result<void> MeshAssembly::checkField(const MeshField& field, std::size_t expected, const char* what) const
{
    if (field.values.size() == expected * static_cast<std::size_t>(field.components)) return {};
    return Failure{
        path_ + ": expected " + std::to_string(expected) + " values of the field \"" +
        printable(field.name, 40) + "\", one for each " + what + ", found " +
        std::to_string(field.values.size() / static_cast<std::size_t>(std::max(field.components, 1)))};
}

Result<Mesh> MeshAssembly::finish() &&
{
    for (const MeshField& field : pointFields)
        if (auto fits = checkField(field, points.size(), "point"); !fits) return fits.failure();
    for (const MeshField& field : cellFields)
        if (auto fits = checkField(field, static_cast<std::size_t>(counts_.inFile), "cell"); !fits)
            return fits.failure();

    const CellCheck check(points);
    const std::vector<bool> repeated = repeatedCells(kinds_, corners_);
    Mesh mesh;
    std::vector<std::size_t> kept; // places in the file
    for (std::size_t i = 0, first = 0; i < kinds_.size(); ++i) {
        const auto count = static_cast<std::size_t>(shapeOf(kinds_[i]).corners);
        const auto cell = std::span(corners_).subspan(first, count);
        first += count;
        if (check.isBroken(cell)) {
            ++counts_.broken;
            continue;
        }
        if (check.isEndless(cell)) {
            ++counts_.endless;
            continue;
        }
        const int hand = check.handedness(kinds_[i], cell);
        if (hand == 0) {
            ++counts_.flat;
            continue;
        }
        if (repeated[i]) {
            ++counts_.repeated;
            continue;
        }
        if (hand < 0) {
            turnRound(kinds_[i], cell);
            // Prisms are written both ways.
            counts_.inverted += kinds_[i] != CellKind::prism;
        }
        if (kinds_[i] != CellKind::tetra && !canBeSplit(kinds_[i], cell, points)) {
            ++counts_.twisted;
            continue;
        }
        mesh.kinds.push_back(kinds_[i]);
        mesh.corners.insert(mesh.corners.end(), cell.begin(), cell.end());
        kept.push_back(static_cast<std::size_t>(places_[i]));
    }
    if (kept.empty())
        return Failure{path_ + ": expected a cell of some volume, found " + std::to_string(counts_.inFile) +
                       " cells" + (counts_.inFile > 0 ? "; " + counts_.text() : "")};
    for (MeshField& field : cellFields) {
        const auto components = static_cast<std::size_t>(field.components);
        std::vector<double> values;
        values.reserve(kept.size() * components);
        for (const std::size_t place : kept)
            for (std::size_t k = 0; k < components; ++k)
                values.push_back(field.values[place * components + k]);
        field.values = std::move(values);
    }
    mesh.format = std::move(format);
    mesh.points = std::move(points);
    mesh.pointFields = std::move(pointFields);
    mesh.cellFields = std::move(cellFields);
    mesh.counts = counts_;
    mesh.notes = std::move(notes);
    return mesh;
}

void addCodedCell(MeshAssembly& mesh, const CellCode& code, std::span<const std::int64_t> corners)
{
    if (code.is == CellClass::surface) return mesh.skipSurface();
    if (code.is == CellClass::unknown) return mesh.skipUnknown();
    const auto needed = static_cast<std::size_t>(shapeOf(code.kind).corners);
    if (corners.size() < needed) return mesh.skipBroken();
    mesh.addCell(code.kind, corners.first(needed), corners.size() > needed);
}

CellCode vtkCellCode(std::int64_t type)
{
    const auto solid = [](CellKind kind) { return CellCode{CellClass::solid, kind, 0}; };
    switch (type) {
    case 10:
    case 24:
    case 71:
    case 78: return solid(CellKind::tetra);
    case 11:
    case 12:
    case 25:
    case 29:
    case 33:
    case 72:
    case 79: return solid(CellKind::hexa);
    case 13:
    case 26:
    case 31:
    case 32:
    case 73:
    case 80: return solid(CellKind::prism);
    case 14:
    case 27:
    case 37:
    case 74:
    case 81: return solid(CellKind::pyramid);
    default: break;
    }
    for (const auto& [first, last] :
         {std::pair{0, 9}, {21, 23}, {28, 28}, {30, 30}, {34, 36}, {68, 70}, {75, 77}})
        if (type >= first && type <= last) return {CellClass::surface};
    return {};
}

void addVtkCell(MeshAssembly& mesh, std::int64_t type, std::span<const std::int64_t> corners)
{
    constexpr std::int64_t kVoxel = 11;
    const CellCode code = vtkCellCode(type);
    if (type == kVoxel && corners.size() == 8) {
        const std::array hexa{corners[0], corners[1], corners[3], corners[2],
                              corners[4], corners[5], corners[7], corners[6]};
        return mesh.addCell(code.kind, hexa);
    }
    addCodedCell(mesh, code, corners);
}

} // namespace vo
