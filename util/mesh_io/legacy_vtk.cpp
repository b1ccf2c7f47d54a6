#include "mesh_assembly.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "stored_numbers.h"
#include "text_scanner.h"

namespace vo {
namespace {

std::string upper(std::string_view word)
{
    std::string text(word);
    for (char& letter : text)
        letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return text;
}

/// Names stand with %20 for a blank.
std::string decodedName(std::string_view name)
{
    std::string decoded;
    for (std::size_t i = 0; i < name.size(); ++i) {
        int code = 0;
        const char* digits = name.data() + i + 1;
        if (name[i] == '%' && i + 2 < name.size() &&
            std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2) {
            decoded += static_cast<char>(code);
            i += 2;
        } else {
            decoded += name[i];
        }
    }
    return decoded;
}

/// VTK's name of a type of numbers.
std::optional<StoredType> storedType(std::string_view name)
{
    static const std::map<std::string_view, StoredType> types{
        {"unsigned_char", StoredType::uint8},
        {"char", StoredType::int8},
        {"signed_char", StoredType::int8},
        {"unsigned_short", StoredType::uint16},
        {"short", StoredType::int16},
        {"unsigned_int", StoredType::uint32},
        {"int", StoredType::int32},
        {"vtkIdType", StoredType::int32},
        {"unsigned_long", StoredType::uint64},
        {"long", StoredType::int64},
        {"unsigned_long_long", StoredType::uint64},
        {"long_long", StoredType::int64},
        {"vtktypeint64", StoredType::int64},
        {"vtktypeuint64", StoredType::uint64},
        {"float", StoredType::float32},
        {"double", StoredType::float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

class LegacyVtk
{
public:
    LegacyVtk(const std::string& path, std::string_view bytes) : scan_(path, bytes), mesh_(path) {}

    Result<Mesh> read()
    {
        if (auto done = readHeader(); !done) return done.failure();
        while (!scan_.atEnd())
            if (auto done = readSection(); !done) return done.failure();
        if (auto done = addCells(); !done) return done.failure();
        return std::move(mesh_).finish();
    }

private:
    enum class Data { none, points, cells };

    Result<void> readHeader()
    {
        const std::string first(scan_.line());
        const std::string version = first.substr(std::min(first.size(), first.rfind(' ') + 1));
        const auto parsed = std::from_chars(version.data(), version.data() + version.size(), version_);
        if (parsed.ec != std::errc() || version_ < 1 || version_ >= 6)
            return Failure{scan_.path() + ": expected version 1 to 5 of VTK's files, found \"" +
                           printable(version, 20) + "\""};
        scan_.line(); // the title
        const std::string kind = upper(scan_.word());
        if (kind != "ASCII" && kind != "BINARY")
            return Failure{scan_.path() + ": expected ASCII or BINARY on the third line, found \"" +
                           printable(kind, 20) + "\""};
        binary_ = kind == "BINARY";
        mesh_.format = "VTK " + printable(version, 10) + (binary_ ? " binary" : " ascii");
        return {};
    }

    Result<void> readSection()
    {
        const std::size_t before = scan_.position();
        const std::string keyword = upper(scan_.word());
        if (keyword == "DATASET") return readKind();
        if (keyword == "FIELD") return readFieldArrays();
        if (keyword == "POINTS") return readPoints();
        if (keyword == "CELLS") return readCells();
        if (keyword == "CELL_TYPES") return readTypes();
        if (keyword == "POINT_DATA") return beginData(Data::points, mesh_.points.size(), "points");
        if (keyword == "CELL_DATA") return beginData(Data::cells, cellCount_, "cells");
        if (keyword == "METADATA") return skipMetadata();
        if (data_ != Data::none) {
            if (keyword == "SCALARS") return readScalars();
            if (keyword == "COLOR_SCALARS") return readColors();
            if (keyword == "LOOKUP_TABLE") return skipTable();
            if (keyword == "VECTORS" || keyword == "NORMALS") return readAttribute(3);
            if (keyword == "TENSORS") return readAttribute(9);
            if (keyword == "TENSORS6") return readAttribute(6);
            if (keyword == "GLOBAL_IDS" || keyword == "PEDIGREE_IDS") return readAttribute(1);
            if (keyword == "TEXTURE_COORDINATES") return readTextureCoordinates();
        }
        scan_.seek(before);
        return scan_.expected("a section of an unstructured grid");
    }

    Result<void> readKind()
    {
        const std::size_t before = scan_.position();
        if (upper(scan_.word()) == "UNSTRUCTURED_GRID") return {};
        scan_.seek(before);
        return scan_.expected("DATASET UNSTRUCTURED_GRID");
    }

    Result<std::int64_t> count(const char* what, std::int64_t least = 0)
    {
        const std::size_t before = scan_.position();
        std::int64_t value = 0;
        if (scan_.number(value) && value >= least) return value;
        scan_.seek(before);
        return scan_.expected(what);
    }

    Result<StoredType> type()
    {
        const std::size_t before = scan_.position();
        if (const auto found = storedType(scan_.word())) return *found;
        scan_.seek(before);
        return scan_.expected("a type of numbers (float, int ...)");
    }

    /// `count` numbers, which the rest of the file must have room for.
    template <typename Out>
    Result<void> readNumbers(StoredType type, std::int64_t count, std::vector<Out>& out,
                             const std::string& what)
    {
        if (std::is_integral_v<Out> && !isWhole(type))
            return Failure{scan_.path() + ": expected whole numbers as " + what + ", found " +
                           storedTypeName(type)};
        if (!binary_) return readText(count, out, what);
        scan_.line();
        std::int64_t bytes = 0;
        if (__builtin_mul_overflow(count, std::int64_t(bytesPerNumber(type)), &bytes) ||
            static_cast<std::uint64_t>(bytes) > scan_.left())
            return cutOff(count, what);
        out.resize(static_cast<std::size_t>(count));
        convertNumbers(type, ByteOrder::bigEndian, scan_.take(static_cast<std::size_t>(bytes)), out.data());
        return {};
    }

    template <typename Out>
    Result<void> readText(std::int64_t count, std::vector<Out>& out, const std::string& what)
    {
        if (!scan_.couldHold(count)) return cutOff(count, what);
        out.resize(static_cast<std::size_t>(count));
        for (Out& value : out)
            if (!scan_.number(value)) return scan_.expected("a number (" + what + ")");
        return {};
    }

    Failure cutOff(std::int64_t count, const std::string& what) const
    {
        return {scan_.path() + ": cut off: expected " + std::to_string(count) + " numbers (" + what +
                "), found " + std::to_string(scan_.left()) + " bytes"};
    }

    Result<void> readPoints()
    {
        const auto points = count("the number of points");
        if (!points) return points.failure();
        const auto stored = type();
        if (!stored) return stored.failure();
        std::int64_t numbers = 0;
        if (__builtin_mul_overflow(*points, std::int64_t(3), &numbers)) return cutOff(*points, "coordinates");
        std::vector<double> values;
        if (auto read = readNumbers(*stored, numbers, values, "coordinates"); !read) return read;
        mesh_.points.resize(values.size() / 3);
        for (std::size_t i = 0; i < values.size(); ++i)
            mesh_.points[i / 3][i % 3] = values[i];
        return {};
    }

    Result<void> readCells()
    {
        const auto first = count("the number of cells"), second = count("the size of the list of cells");
        if (!first) return first.failure();
        if (!second) return second.failure();
        if (version_ >= 5) return readOffsets(*first, *second);
        std::vector<std::int64_t> list;
        if (auto read = readNumbers(StoredType::int32, *second, list, "cells"); !read) return read;
        offsets_ = {0};
        for (std::size_t at = 0; at < list.size();) {
            const std::int64_t corners = list[at++];
            if (corners < 0 || static_cast<std::uint64_t>(corners) > list.size() - at)
                return Failure{scan_.path() + ": expected the number of corners of cell " +
                               std::to_string(offsets_.size() - 1) + ", found " + std::to_string(corners)};
            const auto from = list.begin() + static_cast<std::ptrdiff_t>(at);
            corners_.insert(corners_.end(), from, from + corners);
            at += static_cast<std::size_t>(corners);
            offsets_.push_back(static_cast<std::int64_t>(corners_.size()));
        }
        cellCount_ = offsets_.size() - 1;
        if (*first != static_cast<std::int64_t>(cellCount_))
            return Failure{scan_.path() + ": expected " + std::to_string(*first) +
                           " cells in the list, found " + std::to_string(cellCount_)};
        return {};
    }

    /// Since version 5 offsets and corners are arrays of their own.
    Result<void> readOffsets(std::int64_t offsets, std::int64_t corners)
    {
        for (const auto& [keyword, size, list] :
             {std::tuple{"OFFSETS", offsets, &offsets_}, {"CONNECTIVITY", corners, &corners_}}) {
            const std::size_t before = scan_.position();
            if (upper(scan_.word()) != keyword) {
                scan_.seek(before);
                return scan_.expected(keyword);
            }
            const auto stored = type();
            if (!stored) return stored.failure();
            if (auto read = readNumbers(*stored, size, *list, keyword); !read) return read;
        }
        cellCount_ = offsets_.empty() ? 0 : offsets_.size() - 1;
        return {};
    }

    Result<void> readTypes()
    {
        const auto cells = count("the number of cells");
        if (!cells) return cells.failure();
        return readNumbers(StoredType::int32, *cells, types_, "types of cells");
    }

    Result<void> addCells()
    {
        if (types_.size() != cellCount_)
            return Failure{scan_.path() + ": expected a type for each of " + std::to_string(cellCount_) +
                           " cells, found " + std::to_string(types_.size())};
        for (std::size_t i = 0; i < cellCount_; ++i) {
            const std::int64_t from = offsets_[i], to = offsets_[i + 1];
            if (from < 0 || to < from || to > static_cast<std::int64_t>(corners_.size()))
                return Failure{scan_.path() + ": expected the corners of cell " + std::to_string(i) +
                               " among " + std::to_string(corners_.size()) + ", found " +
                               std::to_string(from) + " to " + std::to_string(to)};
            addVtkCell(mesh_, types_[i],
                       std::span(corners_).subspan(static_cast<std::size_t>(from),
                                                   static_cast<std::size_t>(to - from)));
        }
        return {};
    }

    Result<void> beginData(Data data, std::size_t expected, const char* what)
    {
        const auto found = count("a number of values");
        if (!found) return found.failure();
        if (*found != static_cast<std::int64_t>(expected))
            return Failure{scan_.path() + ": expected data for " + std::to_string(expected) + " " + what +
                           ", found " + std::to_string(*found)};
        data_ = data;
        tuples_ = *found;
        return {};
    }

    /// Three or four bytes are a colour. `fractions`: from 0 to 1, whatever the type says.
    Result<void> addField(std::string name, StoredType stored, std::int64_t components, std::int64_t tuples,
                          bool fractions = false)
    {
        std::int64_t numbers = 0;
        if (components > 10000 || __builtin_mul_overflow(components, tuples, &numbers))
            return cutOff(tuples, name);
        const bool isColor = stored == StoredType::uint8 && (components == 3 || components == 4);
        MeshField field{std::move(name), static_cast<int>(components), isColor, {}};
        if (auto read = readNumbers(stored, numbers, field.values, printable(field.name, 40)); !read)
            return read;
        if (field.components == 0) return {};
        for (double& value : field.values)
            if (isColor && !fractions) value /= 255;
        if (data_ == Data::points)
            mesh_.pointFields.push_back(std::move(field));
        else if (data_ == Data::cells)
            mesh_.cellFields.push_back(std::move(field));
        return {};
    }

    Result<void> readScalars()
    {
        const std::string name = decodedName(scan_.word());
        const auto stored = type();
        if (!stored) return stored.failure();
        std::int64_t components = 1;
        TextScanner rest(scan_.path(), scan_.line());
        if (!rest.atEnd() && (!rest.number(components) || components < 1))
            return rest.expected("the number of components of " + printable(name, 40));
        if (upper(scan_.peek()) == "LOOKUP_TABLE") {
            scan_.word();
            scan_.word();
        } else if (binary_) {
            return addFieldHere(name, *stored, components);
        }
        return addField(name, *stored, components, tuples_);
    }

    /// The numbers begin here, not on the next line.
    Result<void> addFieldHere(const std::string& name, StoredType stored, std::int64_t components)
    {
        scan_.seek(scan_.position() - 1);
        return addField(name, stored, components, tuples_);
    }

    Result<void> readColors()
    {
        const std::string name = decodedName(scan_.word());
        const auto components = count("the number of components", 1);
        if (!components) return components.failure();
        return addField(name, StoredType::uint8, *components, tuples_, !binary_);
    }

    Result<void> readAttribute(std::int64_t components)
    {
        const std::string name = decodedName(scan_.word());
        const auto stored = type();
        if (!stored) return stored.failure();
        return addField(name, *stored, components, tuples_);
    }

    Result<void> readTextureCoordinates()
    {
        const std::string name = decodedName(scan_.word());
        const auto dimensions = count("the number of texture coordinates", 1);
        if (!dimensions) return dimensions.failure();
        const auto stored = type();
        if (!stored) return stored.failure();
        return addField(name, *stored, *dimensions, tuples_);
    }

    Result<void> readFieldArrays()
    {
        scan_.word(); // the name of them all
        const auto arrays = count("the number of arrays");
        if (!arrays) return arrays.failure();
        for (std::int64_t i = 0; i < *arrays; ++i) {
            if (upper(scan_.peek()) == "METADATA") {
                scan_.word();
                if (auto done = skipMetadata(); !done) return done;
            }
            const std::string name = decodedName(scan_.word());
            const auto components = count("the number of components"), tuples = count("the number of values");
            if (!components) return components.failure();
            if (!tuples) return tuples.failure();
            const auto stored = type();
            if (!stored) return stored.failure();
            if (auto read = addField(name, *stored, *components, *tuples); !read) return read;
        }
        return {};
    }

    /// Ends at an empty line.
    Result<void> skipMetadata()
    {
        scan_.line();
        while (scan_.left() > 0 && scan_.line().find_first_not_of(" \t") != std::string_view::npos) {
        }
        return {};
    }

    Result<void> skipTable()
    {
        scan_.word();
        const auto entries = count("the number of entries of a table");
        if (!entries) return entries.failure();
        if (*entries > (1 << 28)) return cutOff(*entries, "a table");
        std::vector<double> unused;
        return readNumbers(StoredType::uint8, 4 * *entries, unused, "a table");
    }

    TextScanner scan_;
    MeshAssembly mesh_;
    double version_ = 0;
    bool binary_ = false;
    std::vector<std::int64_t> offsets_, corners_, types_;
    std::size_t cellCount_ = 0;
    Data data_ = Data::none;
    std::int64_t tuples_ = 0;
};

} // namespace

Result<Mesh> readLegacyVtk(const std::string& path, std::string_view bytes)
{
    return LegacyVtk(path, bytes).read();
}

} // namespace vo
