#pragma once

#include "mesh_io/mesh_io.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <array>
#include <bit>
#include <cstring>
#include <fstream>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>
#include <zlib.h>

/// Meshes by construction, and the formats that hold them, written apart from the readers.
namespace vo::test {

using Point = std::array<double, 3>;

/// Positive for tetrahedra of the project's handedness.
inline double volumeOf(const SplitMesh& split, const std::array<std::int64_t, 4>& tetra)
{
    const auto at = [&](std::size_t i) {
        const auto& [x, y, z] = split.points[static_cast<std::size_t>(tetra[i])];
        return glm::dvec3(x, y, z);
    };
    return glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6;
}

/// A box of n x n x n cells whose inner points are moved: columns of hexahedra and of pairs of prisms, and
/// cells of six pyramids or of twelve tetrahedra, which meet face to face.
class MixedMesh
{
public:
    MixedMesh(int n, double moved, unsigned seed) : n_(n), random_(seed)
    {
        for (int k = 0; k <= n; ++k)
            for (int j = 0; j <= n; ++j)
                for (int i = 0; i <= n; ++i)
                    mesh.points.push_back({i + shift(i, moved), j + shift(j, moved), k + shift(k, moved)});
        // Numbers in no order, so that faces are cut in all ways.
        std::vector<std::size_t> order(mesh.points.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            order[i] = i;
        std::shuffle(order.begin(), order.end(), random_);
        number_.resize(order.size());
        std::vector<Point> points(order.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            number_[i] = static_cast<std::int64_t>(order[i]);
            points[order[i]] = mesh.points[i];
        }
        mesh.points = points;
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const bool prisms = random_() % 3 == 0;
                for (int k = 0; k < n; ++k)
                    addBox(i, j, k, prisms);
            }
        addFields();
    }

    Mesh mesh;
    double volume() const { return double(n_) * n_ * n_; }

    void add(CellKind kind, const std::vector<std::int64_t>& corners)
    {
        mesh.kinds.push_back(kind);
        mesh.corners.insert(mesh.corners.end(), corners.begin(), corners.end());
    }

private:
    double shift(int i, double moved)
    {
        const double by = std::uniform_real_distribution<double>(-moved, moved)(random_);
        return i == 0 || i == n_ ? 0 : by;
    }

    void addBox(int i, int j, int k, bool prisms)
    {
        const auto at = [&](int a, int b, int c) {
            return number_[static_cast<std::size_t>(((k + c) * (n_ + 1) + j + b) * (n_ + 1) + i + a)];
        };
        const std::array<std::int64_t, 8> box{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0),
                                              at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)};
        if (prisms) {
            add(CellKind::prism, {box[0], box[1], box[2], box[4], box[5], box[6]});
            add(CellKind::prism, {box[0], box[2], box[3], box[4], box[6], box[7]});
            return;
        }
        const auto kind = random_() % 3;
        if (kind == 0) return add(CellKind::hexa, {box.begin(), box.end()});
        addFromMiddle(box, kind == 1);
    }

    void addFromMiddle(const std::array<std::int64_t, 8>& box, bool pyramids)
    {
        Point middle{};
        for (const std::int64_t corner : box)
            for (std::size_t axis = 0; axis < 3; ++axis)
                middle[axis] += mesh.points[static_cast<std::size_t>(corner)][axis] / 8;
        const auto tip = static_cast<std::int64_t>(mesh.points.size());
        mesh.points.push_back(middle);
        // Counter-clockwise as seen from the middle.
        constexpr int faces[6][4] = {{0, 1, 2, 3}, {4, 7, 6, 5}, {0, 4, 5, 1},
                                     {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
        for (const auto& face : faces) {
            std::array<std::int64_t, 4> q{};
            for (std::size_t i = 0; i < 4; ++i)
                q[i] = box[static_cast<std::size_t>(face[i])];
            if (pyramids) {
                add(CellKind::pyramid, {q[0], q[1], q[2], q[3], tip});
                continue;
            }
            std::rotate(q.begin(), std::min_element(q.begin(), q.end()), q.end());
            add(CellKind::tetra, {q[0], q[1], q[2], tip});
            add(CellKind::tetra, {q[0], q[2], q[3], tip});
        }
    }

    void addFields()
    {
        std::uniform_real_distribution<double> value(-3, 5);
        const auto field = [&](const char* name, int components, std::size_t count) {
            MeshField made{name, components, false, {}};
            for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i)
                made.values.push_back(static_cast<double>(static_cast<float>(value(random_))));
            return made;
        };
        mesh.pointFields = {field("heat", 1, mesh.points.size()), field("flow", 3, mesh.points.size())};
        mesh.cellFields = {field("region", 1, mesh.cellCount())};
    }

    int n_;
    std::mt19937 random_;
    std::vector<std::int64_t> number_;
};

/// Numbers as bytes or as text.
class NumberWriter
{
public:
    NumberWriter(bool binary, bool bigEndian) : binary_(binary), bigEndian_(bigEndian) {}

    template <typename Number>
    void put(Number number)
    {
        if (!binary_) {
            std::ostringstream text;
            text.precision(17);
            text << +number << (++column_ % 9 == 0 ? '\n' : ' ');
            bytes += text.str();
            return;
        }
        std::array<char, sizeof number> part;
        std::memcpy(part.data(), &number, sizeof number);
        if (bigEndian_ != (std::endian::native == std::endian::big)) std::reverse(part.begin(), part.end());
        bytes.append(part.data(), part.size());
    }
    std::string bytes;

private:
    bool binary_, bigEndian_;
    int column_ = 0;
};

inline int vtkType(CellKind kind)
{
    constexpr int types[] = {10, 14, 13, 12};
    return types[static_cast<std::size_t>(kind)];
}

inline int gmshType(CellKind kind)
{
    constexpr int types[] = {4, 7, 6, 5};
    return types[static_cast<std::size_t>(kind)];
}

/// Calls work(cell number, its corners).
template <typename Work>
void forEachCell(const Mesh& mesh, Work work)
{
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.cellCount(); ++i) {
        const auto corners = static_cast<std::size_t>(shapeOf(mesh.kinds[i]).corners);
        work(i, std::span(mesh.corners).subspan(first, corners));
        first += corners;
    }
}

inline std::string legacyVtk(const Mesh& mesh, bool binary, bool version5)
{
    std::string file = std::string("# vtk DataFile Version ") + (version5 ? "5.1" : "3.0") + "\na mesh\n" +
                       (binary ? "BINARY" : "ASCII") + "\nDATASET UNSTRUCTURED_GRID\n";
    const auto count = [](std::size_t n) { return std::to_string(n); };
    const auto section = [&](const std::string& title, auto fill) {
        NumberWriter numbers(binary, true);
        fill(numbers);
        file += title + "\n" + numbers.bytes + "\n";
    };
    section("POINTS " + count(mesh.points.size()) + " double", [&](NumberWriter& out) {
        for (const Point& point : mesh.points)
            for (const double x : point)
                out.put(x);
    });
    if (version5) {
        file += "METADATA\nINFORMATION 0\n\n";
        file += "CELLS " + count(mesh.cellCount() + 1) + " " + count(mesh.corners.size()) + "\n";
        section("OFFSETS vtktypeint64", [&](NumberWriter& out) {
            std::int64_t end = 0;
            out.put(end);
            for (const CellKind kind : mesh.kinds)
                out.put(end += shapeOf(kind).corners);
        });
        section("CONNECTIVITY vtktypeint64", [&](NumberWriter& out) {
            for (const std::int64_t corner : mesh.corners)
                out.put(corner);
        });
    } else {
        section("CELLS " + count(mesh.cellCount()) + " " + count(mesh.cellCount() + mesh.corners.size()),
                [&](NumberWriter& out) {
                    forEachCell(mesh, [&](std::size_t, std::span<const std::int64_t> cell) {
                        out.put(static_cast<std::int32_t>(cell.size()));
                        for (const std::int64_t corner : cell)
                            out.put(static_cast<std::int32_t>(corner));
                    });
                });
    }
    section("CELL_TYPES " + count(mesh.cellCount()), [&](NumberWriter& out) {
        for (const CellKind kind : mesh.kinds)
            out.put(static_cast<std::int32_t>(vtkType(kind)));
    });
    const auto floats = [](const MeshField& field) {
        return [&](NumberWriter& out) {
            for (const double value : field.values)
                out.put(static_cast<float>(value));
        };
    };
    file += "CELL_DATA " + count(mesh.cellCount()) + "\n";
    section("SCALARS " + mesh.cellFields[0].name + " float 1\nLOOKUP_TABLE default",
            floats(mesh.cellFields[0]));
    file += "POINT_DATA " + count(mesh.points.size()) + "\nFIELD FieldData 1\n";
    section(mesh.pointFields[0].name + " 1 " + count(mesh.points.size()) + " float",
            floats(mesh.pointFields[0]));
    section("VECTORS " + mesh.pointFields[1].name + " float", floats(mesh.pointFields[1]));
    return file;
}

struct VtuStyle
{
    enum class Where { ascii, inlined, appendedRaw, appendedBase64 } where = Where::ascii;
    bool compressed = false, bigEndian = false, longHeader = false;
};

inline std::string base64(const std::string& bytes)
{
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            text += k > bytes.size() - i ? '=' : digits[bits >> (18 - 6 * k) & 63];
    }
    return text;
}

class VtuWriter
{
public:
    explicit VtuWriter(const VtuStyle& style) : style_(style) {}

    std::string file(const std::vector<const Mesh*>& pieces)
    {
        std::string xml =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"";
        xml += style_.bigEndian ? "BigEndian\"" : "LittleEndian\"";
        if (style_.longHeader) xml += " header_type=\"UInt64\"";
        if (style_.compressed) xml += " compressor=\"vtkZLibDataCompressor\"";
        xml += ">\n<UnstructuredGrid>\n";
        for (const Mesh* mesh : pieces)
            xml += piece(*mesh);
        xml += "</UnstructuredGrid>\n";
        if (style_.where == VtuStyle::Where::appendedRaw)
            xml += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
        if (style_.where == VtuStyle::Where::appendedBase64)
            xml += "<AppendedData encoding=\"base64\">\n_" + appended_ + "\n</AppendedData>\n";
        return xml + "</VTKFile>\n";
    }

private:
    std::string piece(const Mesh& mesh)
    {
        std::string xml = "<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size()) +
                          "\" NumberOfCells=\"" + std::to_string(mesh.cellCount()) + "\">\n<PointData>\n";
        for (const MeshField& field : mesh.pointFields)
            xml += array<float>("Float32", field.name, field.components, field.values);
        xml += "</PointData>\n<CellData>\n";
        for (const MeshField& field : mesh.cellFields)
            xml += array<float>("Float32", field.name, field.components, field.values);
        std::vector<double> places, ends, types;
        for (const Point& point : mesh.points)
            places.insert(places.end(), point.begin(), point.end());
        for (const CellKind kind : mesh.kinds) {
            ends.push_back((ends.empty() ? 0 : ends.back()) + shapeOf(kind).corners);
            types.push_back(vtkType(kind));
        }
        const std::vector<double> corners(mesh.corners.begin(), mesh.corners.end());
        return xml + "</CellData>\n<Points>\n" + array<double>("Float64", "Points", 3, places) +
               "</Points>\n<Cells>\n" + array<std::int64_t>("Int64", "connectivity", 1, corners) +
               array<std::int32_t>("Int32", "offsets", 1, ends) +
               array<std::uint8_t>("UInt8", "types", 1, types) + "</Cells>\n</Piece>\n";
    }

    template <typename Number>
    std::string array(const char* type, const std::string& name, int components,
                      const std::vector<double>& values)
    {
        NumberWriter numbers(style_.where != VtuStyle::Where::ascii, style_.bigEndian);
        for (const double value : values)
            numbers.put(static_cast<Number>(value));
        std::string tag = std::string("<DataArray type=\"") + type + "\" Name=\"" + name +
                          "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=";
        switch (style_.where) {
        case VtuStyle::Where::ascii: return tag + "\"ascii\">\n" + numbers.bytes + "</DataArray>\n";
        case VtuStyle::Where::inlined:
            return tag + "\"binary\">\n  " + packed(numbers.bytes) + "\n</DataArray>\n";
        default: break;
        }
        tag += "\"appended\" offset=\"" + std::to_string(appended_.size()) + "\"/>\n";
        appended_ += packed(numbers.bytes);
        return tag;
    }

    /// Header and data; in base64 the header of compressed data is padded by itself.
    std::string packed(const std::string& bytes)
    {
        std::string data = bytes;
        std::vector<std::size_t> header{bytes.size()};
        if (style_.compressed) {
            constexpr std::size_t kBlock = 1000;
            const std::size_t blocks = (bytes.size() + kBlock - 1) / kBlock;
            header = {blocks, kBlock, bytes.size() % kBlock};
            data.clear();
            for (std::size_t i = 0; i < blocks; ++i) {
                const std::string block = bytes.substr(i * kBlock, kBlock);
                std::vector<Bytef> out(compressBound(block.size()));
                uLongf length = out.size();
                ::compress(out.data(), &length, reinterpret_cast<const Bytef*>(block.data()), block.size());
                header.push_back(length);
                data.append(reinterpret_cast<const char*>(out.data()), length);
            }
        }
        NumberWriter numbers(true, style_.bigEndian);
        for (const std::size_t value : header)
            style_.longHeader ? numbers.put(static_cast<std::uint64_t>(value))
                              : numbers.put(static_cast<std::uint32_t>(value));
        if (style_.where == VtuStyle::Where::appendedRaw) return numbers.bytes + data;
        return style_.compressed ? base64(numbers.bytes) + base64(data) : base64(numbers.bytes + data);
    }

    VtuStyle style_;
    std::string appended_;
};

inline std::string gmshData(const char* section, const MeshField& field, bool binary, bool bigEndian)
{
    const std::size_t count = field.values.size() / static_cast<std::size_t>(field.components);
    std::string file = std::string("$") + section + "\n1\n\"" + field.name + "\"\n1\n0.5\n3\n0\n" +
                       std::to_string(field.components) + "\n" + std::to_string(count) + "\n";
    NumberWriter numbers(binary, bigEndian);
    for (std::size_t i = 0; i < count; ++i) {
        numbers.put(static_cast<std::int32_t>(i + 1));
        for (std::size_t k = 0; k < static_cast<std::size_t>(field.components); ++k)
            numbers.put(field.values[i * static_cast<std::size_t>(field.components) + k]);
        if (!binary) numbers.bytes += '\n';
    }
    return file + numbers.bytes + "\n$End" + section + "\n";
}

/// Nodes and elements are numbered from 1; in front of the cells stands a triangle.
inline std::string gmsh(const Mesh& mesh, bool version4, bool binary, bool bigEndian)
{
    NumberWriter one(true, bigEndian), out(binary, bigEndian);
    one.put(std::int32_t(1));
    std::string file = std::string("$MeshFormat\n") + (version4 ? "4.1" : "2.2") +
                       (binary ? " 1 8\n" : " 0 8\n") + (binary ? one.bytes + "\n" : "") +
                       "$EndMeshFormat\n$Comments\nof any kind\n$EndComments\n$Nodes\n";
    const auto points = static_cast<std::int64_t>(mesh.points.size());
    const auto cells = static_cast<std::int64_t>(mesh.cellCount());
    const auto coordinates = [&](std::size_t i) {
        for (const double x : mesh.points[i])
            out.put(x);
    };
    const auto endLine = [&] {
        if (!binary) out.bytes += '\n';
    };
    if (version4) {
        for (const std::int64_t n : {std::int64_t(1), points, std::int64_t(1), points})
            out.put(n);
        for (const std::int32_t n : {3, 1, 0})
            out.put(n);
        out.put(points);
        for (std::int64_t tag = 1; tag <= points; ++tag)
            out.put(tag);
    } else {
        file += std::to_string(points) + "\n";
    }
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        if (!version4) out.put(static_cast<std::int32_t>(i + 1));
        coordinates(i);
        endLine();
    }
    file += out.bytes + "\n$EndNodes\n$Elements\n";
    out.bytes.clear();
    if (version4)
        for (const std::int64_t n : {cells + 1, cells + 1, std::int64_t(1), cells + 1})
            out.put(n);
    else
        file += std::to_string(cells + 1) + "\n";
    const auto element = [&](std::int64_t tag, int type, std::span<const std::int64_t> corners) {
        if (version4) {
            for (const std::int32_t n : {3, 1, type})
                out.put(n);
            out.put(std::int64_t(1));
            out.put(tag);
            for (const std::int64_t corner : corners)
                out.put(corner + 1);
        } else {
            const auto number = static_cast<std::int32_t>(tag);
            const std::vector<std::int32_t> head = binary
                                                       ? std::vector<std::int32_t>{type, 1, 2, number, 7, 8}
                                                       : std::vector<std::int32_t>{number, type, 2, 7, 8};
            // A line each, without breaks inside.
            std::string line;
            for (const std::int32_t n : head)
                binary ? out.put(n) : void(line += std::to_string(n) + ' ');
            for (const std::int64_t corner : corners)
                binary ? out.put(static_cast<std::int32_t>(corner + 1))
                       : void(line += std::to_string(corner + 1) + ' ');
            out.bytes += line;
        }
        endLine();
    };
    forEachCell(mesh, [&](std::size_t i, std::span<const std::int64_t> corners) {
        element(static_cast<std::int64_t>(i + 1), gmshType(mesh.kinds[i]), corners);
    });
    const std::int64_t triangle[] = {0, 1, 2};
    element(cells + 1, 2, triangle);
    file += out.bytes + "\n$EndElements\n";
    for (const MeshField& field : mesh.pointFields)
        file += gmshData("NodeData", field, binary, bigEndian);
    for (const MeshField& field : mesh.cellFields)
        file += gmshData("ElementData", field, binary, bigEndian);
    return file;
}

/// The first point field on all cells.
inline std::string gmshView(const Mesh& mesh)
{
    std::ostringstream file;
    file.precision(17);
    file << "// a view\nView \"" << mesh.pointFields[0].name << "\" {\nTIME{0.5};\nSP(0,0,0){1};\n";
    forEachCell(mesh, [&](std::size_t i, std::span<const std::int64_t> cell) {
        constexpr const char* names[] = {"SS", "SY", "SI", "SH"};
        file << names[static_cast<std::size_t>(mesh.kinds[i])];
        char separator = '(';
        for (const std::int64_t corner : cell)
            for (const double x : mesh.points[static_cast<std::size_t>(corner)])
                file << std::exchange(separator, ',') << x;
        file << ")";
        separator = '{';
        for (const std::int64_t corner : cell)
            file << std::exchange(separator, ',')
                 << mesh.pointFields[0].values[static_cast<std::size_t>(corner)];
        file << "}; /* " << i << " */\n";
    });
    file << "};\n";
    return file.str();
}

/// Tetrahedra alone, the first point field and the first cell field; points are counted from `first`.
inline std::string tetGenNodes(const Mesh& mesh, int first)
{
    std::ostringstream file;
    file.precision(17);
    file << "# points\n" << mesh.points.size() << " 3 1 0\n\n";
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
        file << i + std::size_t(first) << ' ' << mesh.points[i][0] << ' ' << mesh.points[i][1] << "  "
             << mesh.points[i][2] << ' ' << mesh.pointFields[0].values[i] << '\n';
    return file.str();
}

inline std::string tetGenElements(const Mesh& mesh, int first)
{
    std::ostringstream file;
    file.precision(17);
    file << mesh.cellCount() << " 4 1\n";
    forEachCell(mesh, [&](std::size_t i, std::span<const std::int64_t> cell) {
        file << i + std::size_t(first);
        for (const std::int64_t corner : cell)
            file << ' ' << corner + first;
        file << ' ' << mesh.cellFields[0].values[i] << " # " << i << '\n';
    });
    return file.str();
}

inline void writeFile(const std::string& path, const std::string& bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

} // namespace vo::test
