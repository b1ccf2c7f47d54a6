#include "mesh_assembly.h"

#include <algorithm>
#include <map>
#include <pugixml.hpp>

#include "stored_numbers.h"
#include "text_scanner.h"
#include "vtu_data.h"

namespace vo {
namespace {

std::optional<StoredType> storedType(const std::string& name)
{
    static const std::map<std::string, StoredType> types{
        {"UInt8", StoredType::uint8},     {"Int8", StoredType::int8},     {"UInt16", StoredType::uint16},
        {"Int16", StoredType::int16},     {"UInt32", StoredType::uint32}, {"Int32", StoredType::int32},
        {"UInt64", StoredType::uint64},   {"Int64", StoredType::int64},   {"Float32", StoredType::float32},
        {"Float64", StoredType::float64},
    };
    const auto found = types.find(name);
    return found == types.end() ? std::nullopt : std::optional(found->second);
}

class Vtu
{
public:
    Vtu(const std::string& path, std::string_view bytes) : path_(path), bytes_(bytes), mesh_(path) {}

    Result<Mesh> read()
    {
        if (auto done = parse(); !done) return done.failure();
        const pugi::xml_node file = document_.child("VTKFile");
        if (auto done = readEncoding(file); !done) return done.failure();
        const pugi::xml_node grid = file.child("UnstructuredGrid");
        if (!grid)
            return Failure{path_ + ": expected a VTKFile with an UnstructuredGrid, found type \"" +
                           printable(file.attribute("type").value(), 40) + "\""};
        for (const pugi::xml_node piece : grid.children("Piece"))
            if (auto done = readPiece(piece); !done) return done.failure();
        mesh_.format = "VTU";
        return std::move(mesh_).finish();
    }

private:
    /// The bytes of AppendedData are no XML: it is parsed without them.
    Result<void> parse()
    {
        std::size_t end = bytes_.size();
        std::string closing;
        if (const auto tag = bytes_.find("<AppendedData"); tag != bytes_.npos) {
            const auto behind = bytes_.find('>', tag);
            appendedAt_ = bytes_.find('_', behind);
            if (behind == bytes_.npos || appendedAt_ == bytes_.npos)
                return Failure{path_ + ": cut off: expected appended data behind _, found the end"};
            ++appendedAt_;
            end = behind + 1;
            closing = "</AppendedData></VTKFile>";
        }
        text_ = std::string(bytes_.substr(0, end)) + closing;
        const auto parsed = document_.load_buffer_inplace(text_.data(), text_.size());
        if (parsed) return {};
        return Failure{path_ + ": byte " + std::to_string(parsed.offset) +
                       ": expected XML, found: " + parsed.description()};
    }

    Result<void> readEncoding(const pugi::xml_node& file)
    {
        const std::string order = file.attribute("byte_order").value(),
                          header = file.attribute("header_type").value(),
                          compressor = file.attribute("compressor").value(),
                          encoding = file.child("AppendedData").attribute("encoding").value();
        if (!order.empty() && order != "LittleEndian" && order != "BigEndian")
            return Failure{path_ + ": expected the byte_order LittleEndian or BigEndian, found \"" +
                           printable(order, 40) + "\""};
        encoding_.byteOrder = order == "BigEndian" ? ByteOrder::bigEndian : ByteOrder::littleEndian;
        if (!header.empty() && header != "UInt32" && header != "UInt64")
            return Failure{path_ + ": expected the header_type UInt32 or UInt64, found \"" +
                           printable(header, 40) + "\""};
        encoding_.headerBytes = header == "UInt64" ? 8 : 4;
        if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
            return Failure{path_ + ": expected no compressor or vtkZLibDataCompressor, found \"" +
                           printable(compressor, 40) + "\""};
        encoding_.compressed = !compressor.empty();
        appendedRaw_ = encoding == "raw";
        return {};
    }

    Result<std::int64_t> count(const pugi::xml_node& piece, const char* name) const
    {
        TextScanner scan(path_, piece.attribute(name).value());
        std::int64_t value = -1;
        if (scan.number(value) && scan.atEnd() && value >= 0) return value;
        return Failure{path_ + ": expected a number " + name + " of a Piece, found \"" +
                       printable(piece.attribute(name).value(), 40) + "\""};
    }

    Result<void> readPiece(const pugi::xml_node& piece)
    {
        const auto points = count(piece, "NumberOfPoints"), cells = count(piece, "NumberOfCells");
        if (!points) return points.failure();
        if (!cells) return cells.failure();
        const auto before = static_cast<std::int64_t>(mesh_.points.size());
        const auto cellsBefore = mesh_.cellsInFile();
        if (auto done = readPoints(piece.child("Points").child("DataArray"), *points); !done) return done;
        if (auto done = readCells(piece.child("Cells"), *cells, before, *points); !done) return done;
        if (auto done = readFields(piece.child("PointData"), *points, before, mesh_.pointFields); !done)
            return done;
        return readFields(piece.child("CellData"), *cells, cellsBefore, mesh_.cellFields);
    }

    /// `numbers` numbers of an array.
    template <typename Out>
    Result<std::vector<Out>> readArray(const pugi::xml_node& array, const std::string& name,
                                       std::int64_t numbers)
    {
        const std::string what = path_ + ": array \"" + printable(name, 40) + "\"",
                          typeName = array.attribute("type").value(),
                          format = array.attribute("format").value();
        if (!array) return Failure{what + ": expected in a Piece, found none"};
        const auto type = storedType(typeName);
        if (!type || (std::is_integral_v<Out> && !isWhole(*type)))
            return Failure{what + ": expected a type of " + (std::is_integral_v<Out> ? "whole " : "") +
                           "numbers, found \"" + printable(typeName, 40) + "\""};
        std::int64_t bytes = 0;
        if (numbers < 0 || __builtin_mul_overflow(numbers, std::int64_t(bytesPerNumber(*type)), &bytes))
            return Failure{what + ": expected a length below 2^63, found more"};
        if (format == "ascii" || format.empty()) return readText<Out>(array, what, numbers);
        VtuEncoding encoding = encoding_;
        std::string_view stored = array.text().get();
        if (format == "appended") {
            const auto place = appendedPlace(array, what);
            if (!place) return place.failure();
            stored = bytes_.substr(*place);
            encoding.base64 = !appendedRaw_;
        } else if (format != "binary") {
            return Failure{what + ": expected the format ascii, binary or appended, found \"" +
                           printable(format, 40) + "\""};
        }
        const auto found = vtuBytes(encoding, stored, bytes, what);
        if (!found) return found.failure();
        std::vector<Out> values(static_cast<std::size_t>(numbers));
        convertNumbers(*type, encoding_.byteOrder, *found, values.data());
        return values;
    }

    template <typename Out>
    Result<std::vector<Out>> readText(const pugi::xml_node& array, const std::string& what,
                                      std::int64_t numbers)
    {
        TextScanner scan(what, array.text().get());
        if (!scan.couldHold(numbers))
            return Failure{what + ": expected " + std::to_string(numbers) + " numbers, found " +
                           std::to_string(scan.left()) + " characters"};
        std::vector<Out> values(static_cast<std::size_t>(numbers));
        for (Out& value : values)
            if (!scan.number(value)) return scan.expected("a number");
        if (!scan.atEnd()) return scan.expected("the end of " + std::to_string(numbers) + " numbers");
        return values;
    }

    Result<std::size_t> appendedPlace(const pugi::xml_node& array, const std::string& what) const
    {
        TextScanner scan(path_, array.attribute("offset").value());
        std::uint64_t offset = 0;
        if (appendedAt_ > 0 && scan.number(offset) && scan.atEnd() && offset < bytes_.size() - appendedAt_)
            return appendedAt_ + static_cast<std::size_t>(offset);
        return Failure{what + ": expected an offset into " +
                       std::to_string(appendedAt_ > 0 ? bytes_.size() - appendedAt_ : 0) +
                       " bytes of appended data, found \"" +
                       printable(array.attribute("offset").value(), 40) + "\""};
    }

    Result<void> readPoints(const pugi::xml_node& array, std::int64_t points)
    {
        if (points > INT64_MAX / 3)
            return Failure{path_ + ": expected fewer points, found " + std::to_string(points)};
        const auto values = readArray<double>(array, "Points", 3 * points);
        if (!values) return values.failure();
        for (std::size_t i = 0; i + 2 < values->size(); i += 3)
            mesh_.points.push_back({(*values)[i], (*values)[i + 1], (*values)[i + 2]});
        return {};
    }

    Result<void> readCells(const pugi::xml_node& node, std::int64_t cells, std::int64_t firstPoint,
                           std::int64_t pointCount)
    {
        const auto named = [&](const char* name) {
            return node.find_child_by_attribute("DataArray", "Name", name);
        };
        const auto offsets = readArray<std::int64_t>(named("offsets"), "offsets", cells);
        if (!offsets) return offsets.failure();
        const auto types = readArray<std::int64_t>(named("types"), "types", cells);
        if (!types) return types.failure();
        const auto corners = readArray<std::int64_t>(named("connectivity"), "connectivity",
                                                     offsets->empty() ? 0 : offsets->back());
        if (!corners) return corners.failure();
        std::vector<std::int64_t> cell;
        std::int64_t from = 0;
        for (std::size_t i = 0; i < types->size(); ++i) {
            const std::int64_t to = (*offsets)[i];
            if (to < from || to > static_cast<std::int64_t>(corners->size()))
                return Failure{path_ + ": expected rising offsets up to " + std::to_string(corners->size()) +
                               ", found " + std::to_string(to) + " for cell " + std::to_string(i)};
            cell.clear();
            for (; from < to; ++from) {
                const std::int64_t corner = (*corners)[static_cast<std::size_t>(from)];
                // Numbers of a piece are its own.
                cell.push_back(corner < 0 || corner >= pointCount ? -1 : firstPoint + corner);
            }
            addVtkCell(mesh_, (*types)[i], cell);
        }
        return {};
    }

    Result<void> readFields(const pugi::xml_node& data, std::int64_t tuples, std::int64_t before,
                            std::vector<MeshField>& fields)
    {
        std::size_t next = 0;
        for (const pugi::xml_node array : data.children("DataArray")) {
            const std::string name = array.attribute("Name").value();
            const std::int64_t components = array.attribute("NumberOfComponents").as_int(1);
            std::int64_t numbers = 0;
            if (components < 1 || components > 10000 || __builtin_mul_overflow(components, tuples, &numbers))
                return Failure{path_ + ": array \"" + printable(name, 40) +
                               "\": expected 1 to 10000 components, found " + std::to_string(components)};
            auto values = readArray<double>(array, name, numbers);
            if (!values) return values.failure();
            const bool isColor = std::string(array.attribute("type").value()) == "UInt8" &&
                                 (components == 3 || components == 4);
            if (isColor)
                for (double& value : *values)
                    value /= 255;
            if (before == 0) {
                fields.push_back({name, static_cast<int>(components), isColor, std::move(*values)});
                continue;
            }
            // Later pieces have the same fields in the same order.
            if (next >= fields.size() || fields[next].name != name || fields[next].components != components)
                return Failure{path_ + ": expected the same arrays in all pieces, found \"" +
                               printable(name, 40) + "\" in one alone"};
            fields[next].values.insert(fields[next].values.end(), values->begin(), values->end());
            ++next;
        }
        return {};
    }

    std::string path_;
    std::string_view bytes_;
    std::string text_; // what pugixml keeps pointers into
    pugi::xml_document document_;
    std::size_t appendedAt_ = 0;
    bool appendedRaw_ = false;
    VtuEncoding encoding_;
    MeshAssembly mesh_;
};

} // namespace

Result<Mesh> readVtu(const std::string& path, std::string_view bytes)
{
    return Vtu(path, bytes).read();
}

} // namespace vo
