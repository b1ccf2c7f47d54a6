#include "mesh_assembly.h"

#include <algorithm>

#include "text_scanner.h"

namespace vo {
namespace {

/// Lines of numbers; # begins a comment, empty lines count for nothing.
class NumberLines
{
public:
    NumberLines(const std::string& path, std::string_view text) : scan_(path, text) {}

    /// The numbers of the next line that has any; a failure at the end, or for fewer than `least`.
    Result<std::vector<double>> next(std::size_t least, const std::string& what)
    {
        while (!scan_.atEnd()) {
            const std::size_t begin = scan_.position();
            const auto line = scan_.line();
            TextScanner words(scan_.path(), line.substr(0, line.find('#')));
            std::vector<double> numbers;
            for (double value = 0; words.number(value);)
                numbers.push_back(value);
            if (words.atEnd() && numbers.empty()) continue;
            if (words.atEnd() && numbers.size() >= least) return numbers;
            scan_.seek(begin);
            return Failure{scan_.path() + ": " + scan_.place() + ": expected " + what + ", found \"" +
                           printable(std::string(line), 40) + "\""};
        }
        return Failure{scan_.path() + ": cut off: expected " + what + ", found the end"};
    }
    /// A count that so many lines of text could hold.
    bool couldHold(double count) const
    {
        return count >= 0 && count <= static_cast<double>(scan_.left()) &&
               count == static_cast<double>(std::int64_t(count));
    }

private:
    TextScanner scan_;
};

class TetGen
{
public:
    /// `stem`: the path without its ending.
    TetGen(const std::string& path, std::string stem) : stem_(std::move(stem)), mesh_(path) {}

    Result<Mesh> read()
    {
        mesh_.format = "TetGen";
        if (auto done = readNodes(); !done) return done.failure();
        if (auto done = readElements(); !done) return done.failure();
        return std::move(mesh_).finish();
    }

private:
    static double numberAt(const std::vector<double>& numbers, std::size_t i)
    {
        return i < numbers.size() ? numbers[i] : 0;
    }

    Result<std::string> fileNamed(const char* ending) const
    {
        auto plain = readWholeFile(stem_ + ending);
        if (plain) return plain;
        auto packed = readWholeFile(stem_ + ending + ".gz");
        return packed ? packed : plain;
    }

    static std::vector<MeshField> fieldsNamed(const char* name, std::size_t count)
    {
        std::vector<MeshField> fields(count);
        for (std::size_t i = 0; i < count; ++i)
            fields[i].name = count == 1 ? name : std::string(name) + std::to_string(i + 1);
        return fields;
    }

    /// COUNT 3 ATTRIBUTES MARKERS, then NUMBER X Y Z ATTRIBUTE... a line.
    Result<void> readNodes()
    {
        const auto text = fileNamed(".node");
        if (!text) return text.failure();
        NumberLines lines(stem_ + ".node", *text);
        const auto head = lines.next(2, "the number of points and 3");
        if (!head) return head.failure();
        const double attributes = numberAt(*head, 2);
        if (!lines.couldHold((*head)[0]) || (*head)[1] != 3 || !(attributes >= 0 && attributes <= 1000))
            return Failure{stem_ + ".node: expected a number of points and 3, found a line of other numbers"};
        const auto count = static_cast<std::size_t>((*head)[0]),
                   fields = static_cast<std::size_t>(attributes);
        mesh_.pointFields = fieldsNamed("value", fields);
        for (std::size_t i = 0; i < count; ++i) {
            const auto line =
                lines.next(4 + fields, "the number, place and values of point " + std::to_string(i));
            if (!line) return line.failure();
            if (i == 0) first_ = (*line)[0];
            if ((*line)[0] != first_ + static_cast<double>(i))
                return Failure{stem_ + ".node: expected points in order, found " +
                               std::to_string((*line)[0]) + " as point " + std::to_string(i)};
            mesh_.points.push_back({(*line)[1], (*line)[2], (*line)[3]});
            for (std::size_t k = 0; k < fields; ++k)
                mesh_.pointFields[k].values.push_back((*line)[4 + k]);
        }
        return {};
    }

    /// COUNT 4 ATTRIBUTES, then NUMBER A B C D ATTRIBUTE... a line; curved tetrahedra have ten points.
    Result<void> readElements()
    {
        const auto text = fileNamed(".ele");
        if (!text) return text.failure();
        NumberLines lines(stem_ + ".ele", *text);
        const auto head = lines.next(2, "the number of tetrahedra and 4");
        if (!head) return head.failure();
        const double attributes = numberAt(*head, 2), corners = (*head)[1];
        if (!lines.couldHold((*head)[0]) || (corners != 4 && corners != 10) ||
            !(attributes >= 0 && attributes <= 1000))
            return Failure{
                stem_ + ".ele: expected a number of tetrahedra and 4 or 10, found a line of other numbers"};
        const auto count = static_cast<std::size_t>((*head)[0]), points = static_cast<std::size_t>(corners),
                   fields = static_cast<std::size_t>(attributes);
        mesh_.cellFields = fieldsNamed("region", fields);
        std::vector<std::int64_t> cell(points);
        for (std::size_t i = 0; i < count; ++i) {
            const auto line =
                lines.next(1 + points + fields, "the points of tetrahedron " + std::to_string(i));
            if (!line) return line.failure();
            for (std::size_t k = 0; k < points; ++k) {
                const double corner = (*line)[1 + k] - first_;
                const bool isPlace = corner >= 0 && corner < static_cast<double>(mesh_.points.size()) &&
                                     corner == static_cast<double>(std::int64_t(corner));
                cell[k] = isPlace ? std::int64_t(corner) : -1;
            }
            addCodedCell(mesh_, {CellClass::solid, CellKind::tetra, 0}, cell);
            for (std::size_t k = 0; k < fields; ++k)
                mesh_.cellFields[k].values.push_back((*line)[1 + points + k]);
        }
        return {};
    }

    std::string stem_;
    MeshAssembly mesh_;
    double first_ = 0;
};

} // namespace

Result<Mesh> readTetGen(const std::string& path)
{
    std::string stem = path;
    if (stem.ends_with(".gz")) stem.resize(stem.size() - 3);
    stem.resize(stem.rfind('.'));
    return TetGen(path, std::move(stem)).read();
}

} // namespace vo
