#include "mesh_assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "stored_numbers.h"
#include "text_scanner.h"

namespace vo {
namespace {

CellCode gmshCellCode(std::int64_t type)
{
    struct Row
    {
        int type;
        CellKind kind;
        int points;
    };
    static constexpr Row kSolids[] = {
        {4, CellKind::tetra, 4},      {5, CellKind::hexa, 8},       {6, CellKind::prism, 6},
        {7, CellKind::pyramid, 5},    {11, CellKind::tetra, 10},    {12, CellKind::hexa, 27},
        {13, CellKind::prism, 18},    {14, CellKind::pyramid, 14},  {17, CellKind::hexa, 20},
        {18, CellKind::prism, 15},    {19, CellKind::pyramid, 13},  {29, CellKind::tetra, 20},
        {30, CellKind::tetra, 35},    {31, CellKind::tetra, 56},    {90, CellKind::prism, 40},
        {91, CellKind::prism, 75},    {92, CellKind::hexa, 64},     {93, CellKind::hexa, 125},
        {118, CellKind::pyramid, 30}, {119, CellKind::pyramid, 55},
    };
    static constexpr std::pair<int, int> kSurfaces[] = {
        {1, 2},   {2, 3},   {3, 4},   {8, 3},   {9, 6},  {10, 9}, {15, 1}, {16, 8},  {20, 9},  {21, 10},
        {22, 12}, {23, 15}, {24, 15}, {25, 21}, {26, 4}, {27, 5}, {28, 6}, {36, 16}, {37, 25},
    };
    for (const Row& row : kSolids)
        if (row.type == type) return {CellClass::solid, row.kind, row.points};
    for (const auto& [code, points] : kSurfaces)
        if (code == type) return {CellClass::surface, CellKind::tetra, points};
    return {};
}

/// Places of the tags of nodes or elements.
class Tags
{
public:
    void add(std::int64_t tag)
    {
        // Most files count from 1.
        if (tag == static_cast<std::int64_t>(counted_) + 1 && others_.empty())
            ++counted_;
        else
            others_.try_emplace(tag, static_cast<std::int64_t>(size_));
        ++size_;
    }
    /// -1 where there is no such tag.
    std::int64_t placeOf(std::int64_t tag) const
    {
        if (tag >= 1 && tag <= static_cast<std::int64_t>(counted_)) return tag - 1;
        const auto found = others_.find(tag);
        return found == others_.end() ? -1 : found->second;
    }
    std::size_t size() const { return size_; }

private:
    std::size_t counted_ = 0, size_ = 0;
    std::unordered_map<std::int64_t, std::int64_t> others_;
};

class Gmsh
{
public:
    Gmsh(const std::string& path, std::string_view bytes) : scan_(path, bytes), mesh_(path) {}

    Result<Mesh> read()
    {
        while (!scan_.atEnd()) {
            const std::string section(scan_.word());
            if (section.size() < 2 || section[0] != '$')
                return Failure{scan_.path() + ": " + scan_.place() +
                               ": expected a section that begins with $, found \"" + printable(section, 40) +
                               "\""};
            if (auto done = readSection(section.substr(1)); !done) return done.failure();
        }
        if (version_ == 0) return Failure{scan_.path() + ": expected a section $MeshFormat, found none"};
        return std::move(mesh_).finish();
    }

private:
    Result<void> readSection(const std::string& name)
    {
        Result<void> done;
        if (name == "MeshFormat")
            done = readFormat();
        else if (version_ == 0)
            return Failure{scan_.path() + ": expected $MeshFormat first, found $" + printable(name, 40)};
        else if (name == "Nodes")
            done = version_ < 4 ? readNodes2() : readNodes4();
        else if (name == "Elements")
            done = version_ < 4 ? readElements2() : readElements4();
        else if (name == "NodeData")
            done = readData(nodes_, mesh_.pointFields);
        else if (name == "ElementData")
            done = readData(elements_, mesh_.cellFields);
        else
            return skipSection(name);
        if (!done) return done;
        if (scan_.peek() != "$End" + name) return scan_.expected("$End" + name);
        scan_.word();
        return {};
    }

    Result<void> skipSection(const std::string& name)
    {
        const auto end = scan_.text().find("$End" + name, scan_.position());
        if (end == std::string_view::npos)
            return Failure{scan_.path() + ": cut off: expected $End" + printable(name, 40) +
                           ", found the end"};
        scan_.seek(end + 4 + name.size());
        return {};
    }

    Result<void> readFormat()
    {
        int kind = 0;
        const std::size_t before = scan_.position();
        if (!scan_.number(version_) || !scan_.number(kind) || !scan_.number(sizeBytes_) ||
            (kind != 0 && kind != 1) ||
            !((version_ >= 2 && version_ < 3) || (version_ >= 4.1 && version_ < 5)) ||
            (sizeBytes_ != 8 && sizeBytes_ != 4)) {
            version_ = 0;
            scan_.seek(before);
            return scan_.expected("version 2.2 or 4.1, 0 or 1, and 8");
        }
        binary_ = kind == 1;
        mesh_.format = std::string("Gmsh ") + (version_ < 4 ? "2" : "4.1") + (binary_ ? " binary" : " ascii");
        if (!binary_) return {};
        scan_.line();
        if (scan_.left() < 4) return cutOff();
        const auto one = scan_.take(4);
        for (const ByteOrder order : {ByteOrder::littleEndian, ByteOrder::bigEndian}) {
            order_ = order;
            if (storedNumber<std::int32_t>(one.data(), order) == 1) return {};
        }
        return Failure{scan_.path() +
                       ": expected the number 1 behind the format, found neither byte order of it"};
    }

    Failure cutOff() const { return {scan_.path() + ": cut off: expected more numbers, found the end"}; }

    /// A number, which stands in binary files as the type says. False: there is none.
    template <typename Stored, typename Out>
    bool get(Out& value)
    {
        if (!binary_) return scan_.number(value);
        if (scan_.left() < sizeof(Stored)) return false;
        value = static_cast<Out>(storedNumber<Stored>(scan_.take(sizeof(Stored)).data(), order_));
        return true;
    }
    bool getInt(std::int64_t& value) { return get<std::int32_t>(value); }
    bool getSize(std::int64_t& value)
    {
        return sizeBytes_ == 8 ? get<std::int64_t>(value) : get<std::int32_t>(value);
    }
    bool getDouble(double& value) { return get<double>(value); }
    Failure noNumber(const char* what)
    {
        if (binary_) return cutOff();
        return scan_.expected(what);
    }
    /// In front of binary numbers the line ends.
    void beginNumbers()
    {
        if (binary_) scan_.line();
    }
    /// Whether so many things, of so many bytes at least, could still follow.
    bool couldHold(std::int64_t count, std::int64_t bytesEach) const
    {
        const std::int64_t each = binary_ ? bytesEach : 2;
        return count >= 0 && count <= (static_cast<std::int64_t>(scan_.left()) + 1) / each;
    }

    Result<void> readNodes2()
    {
        std::int64_t count = 0;
        if (!scan_.number(count) || !couldHold(count, 28)) return scan_.expected("the number of nodes");
        beginNumbers();
        for (std::int64_t i = 0; i < count; ++i) {
            std::int64_t tag = 0;
            std::array<double, 3> point{};
            if (!getInt(tag) || !getDouble(point[0]) || !getDouble(point[1]) || !getDouble(point[2]))
                return noNumber("the number and place of a node");
            nodes_.add(tag);
            mesh_.points.push_back(point);
        }
        return {};
    }

    Result<void> readNodes4()
    {
        beginNumbers();
        std::int64_t blocks = 0, count = 0, least = 0, most = 0;
        if (!getSize(blocks) || !getSize(count) || !getSize(least) || !getSize(most))
            return noNumber("the numbers of blocks and nodes");
        std::vector<std::int64_t> tags;
        for (; blocks > 0; --blocks) {
            std::int64_t dimension = 0, entity = 0, parametric = 0, nodes = 0;
            if (!getInt(dimension) || !getInt(entity) || !getInt(parametric) || !getSize(nodes) ||
                !couldHold(nodes, 32))
                return noNumber("a block of nodes");
            for (std::int64_t i = 0; i < nodes; ++i) {
                std::int64_t tag = 0;
                if (!getSize(tag)) return noNumber("the number of a node");
                nodes_.add(tag);
            }
            for (std::int64_t i = 0; i < nodes; ++i) {
                std::array<double, 3> point{};
                double parameter = 0;
                if (!getDouble(point[0]) || !getDouble(point[1]) || !getDouble(point[2]))
                    return noNumber("the place of a node");
                for (std::int64_t k = 0; parametric != 0 && k < dimension; ++k)
                    if (!getDouble(parameter)) return noNumber("the parameter of a node");
                mesh_.points.push_back(point);
            }
        }
        return {};
    }

    /// A cell by the tags of its nodes.
    void addCell(std::int64_t tag, const CellCode& code)
    {
        for (std::int64_t& corner : cell_)
            corner = nodes_.placeOf(corner);
        elements_.add(tag);
        addCodedCell(mesh_, code, cell_);
    }

    Result<void> readElements2()
    {
        std::int64_t count = 0;
        if (!scan_.number(count) || !couldHold(count, 8)) return scan_.expected("the number of elements");
        beginNumbers();
        return binary_ ? readElementBlocks2(count) : readElementLines2(count);
    }

    Result<void> readElementLines2(std::int64_t count)
    {
        scan_.line();
        for (std::int64_t i = 0; i < count; ++i) {
            TextScanner line(scan_.path(), scan_.line());
            std::int64_t tag = 0, type = 0, tags = 0, value = 0;
            if (!line.number(tag) || !line.number(type) || !line.number(tags))
                return scan_.expected("a line for each of " + std::to_string(count) + " elements");
            for (; tags > 0 && line.number(value); --tags) {
            }
            cell_.clear();
            while (line.number(value))
                cell_.push_back(value);
            addCell(tag, gmshCellCode(type));
        }
        return {};
    }

    Result<void> readElementBlocks2(std::int64_t count)
    {
        for (std::int64_t done = 0; done < count;) {
            std::int64_t type = 0, following = 0, tags = 0;
            if (!getInt(type) || !getInt(following) || !getInt(tags)) return cutOff();
            const CellCode code = gmshCellCode(type);
            if (code.points == 0 || following < 1 || following > count - done || tags < 0 || tags > 1000)
                return unknownType(type);
            for (std::int64_t i = 0; i < following; ++i) {
                std::int64_t tag = 0, value = 0;
                if (!getInt(tag)) return cutOff();
                for (std::int64_t k = 0; k < tags; ++k)
                    if (!getInt(value)) return cutOff();
                cell_.assign(static_cast<std::size_t>(code.points), 0);
                for (std::int64_t& corner : cell_)
                    if (!getInt(corner)) return cutOff();
                addCell(tag, code);
            }
            done += following;
        }
        return {};
    }

    Failure unknownType(std::int64_t type) const
    {
        return {scan_.path() + ": " + scan_.place() + ": expected a type of elements that is known, found " +
                std::to_string(type)};
    }

    Result<void> readElements4()
    {
        beginNumbers();
        std::int64_t blocks = 0, count = 0, least = 0, most = 0;
        if (!getSize(blocks) || !getSize(count) || !getSize(least) || !getSize(most))
            return noNumber("the numbers of blocks and elements");
        for (; blocks > 0; --blocks) {
            std::int64_t dimension = 0, entity = 0, type = 0, elements = 0;
            if (!getInt(dimension) || !getInt(entity) || !getInt(type) || !getSize(elements))
                return noNumber("a block of elements");
            const CellCode code = gmshCellCode(type);
            if (code.points == 0) return unknownType(type);
            if (!couldHold(elements, 16)) return cutOff();
            for (std::int64_t i = 0; i < elements; ++i) {
                std::int64_t tag = 0;
                if (!getSize(tag)) return noNumber("the number of an element");
                cell_.assign(static_cast<std::size_t>(code.points), 0);
                for (std::int64_t& corner : cell_)
                    if (!getSize(corner)) return noNumber("the nodes of an element");
                addCell(tag, code);
            }
        }
        return {};
    }

    /// Names in quotes, times, then numbers: the step, components, entities; then the entities.
    Result<void> readData(const Tags& tags, std::vector<MeshField>& fields)
    {
        std::int64_t strings = 0, reals = 0, integers = 0;
        std::string name;
        if (!scan_.number(strings)) return scan_.expected("the number of names");
        scan_.line();
        for (std::int64_t i = 0; i < strings && scan_.left() > 0; ++i) {
            const auto line = scan_.line();
            const auto first = line.find('"'), last = line.rfind('"');
            if (i == 0 && first < last) name = line.substr(first + 1, last - first - 1);
        }
        if (!scan_.number(reals)) return scan_.expected("the number of times");
        for (double time = 0; reals > 0 && scan_.number(time); --reals) {
        }
        std::vector<std::int64_t> numbers;
        if (!scan_.number(integers)) return scan_.expected("how many whole numbers follow");
        for (std::int64_t value = 0; integers > 0 && scan_.number(value); --integers)
            numbers.push_back(value);
        if (numbers.size() < 3 || numbers[1] < 1 || numbers[1] > 9 || !couldHold(numbers[2], 4))
            return scan_.expected("the step, components and number of entities of " + printable(name, 40));
        beginNumbers();
        return readValues(tags, {name, static_cast<int>(numbers[1]), false, {}}, numbers[2], fields);
    }

    Result<void> readValues(const Tags& tags, MeshField field, std::int64_t entities,
                            std::vector<MeshField>& fields)
    {
        const auto components = static_cast<std::size_t>(field.components);
        // Of nodes or elements that are not named, the view has no values.
        field.values.assign(tags.size() * components, std::numeric_limits<double>::quiet_NaN());
        for (std::int64_t i = 0; i < entities; ++i) {
            std::int64_t tag = 0;
            double value = 0;
            if (!getInt(tag)) return noNumber("a node or an element and its values");
            const std::int64_t place = tags.placeOf(tag);
            for (std::size_t k = 0; k < components; ++k) {
                if (!getDouble(value)) return noNumber("a value");
                if (place >= 0) field.values[static_cast<std::size_t>(place) * components + k] = value;
            }
        }
        const auto same = std::ranges::count_if(fields, [&](const MeshField& other) {
            return other.name == field.name || other.name.starts_with(field.name + " step ");
        });
        if (same > 0) field.name += " step " + std::to_string(same + 1);
        fields.push_back(std::move(field));
        return {};
    }

    TextScanner scan_;
    MeshAssembly mesh_;
    double version_ = 0;
    bool binary_ = false;
    int sizeBytes_ = 8;
    ByteOrder order_ = nativeByteOrder();
    Tags nodes_, elements_;
    std::vector<std::int64_t> cell_;
};

} // namespace

Result<Mesh> readGmsh(const std::string& path, std::string_view bytes)
{
    return Gmsh(path, bytes).read();
}

} // namespace vo
