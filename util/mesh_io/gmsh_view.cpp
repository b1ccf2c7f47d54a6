#include "mesh_assembly.h"

#include <bit>
#include <unordered_map>

#include "text_scanner.h"

namespace vo {
namespace {

/// A parsed view: items such as SS(x, y, z, ...){value, ...};, whose first letter says what the values are
/// (scalars, vectors, tensors) and whose second what the points span.
class GmshView
{
public:
    GmshView(const std::string& path, std::string_view text) : scan_(path, text), mesh_(path) {}

    Result<Mesh> read()
    {
        mesh_.format = "Gmsh view";
        for (skipComments(); !scan_.atEnd(); skipComments()) {
            if (!scan_.peek().starts_with("View")) return scan_.expected("View \"name\" { ... };");
            if (auto done = readView(); !done) return done.failure();
        }
        if (views_ > 1) mesh_.notes.push_back("the first of " + std::to_string(views_) + " views is read");
        if (steps_ > 1) mesh_.notes.push_back("the first of " + std::to_string(steps_) + " steps is read");
        if (!field_.values.empty()) mesh_.pointFields.push_back(std::move(field_));
        return std::move(mesh_).finish();
    }

private:
    void skipComments()
    {
        for (;;) {
            scan_.skipBlanks();
            const auto rest = scan_.text().substr(scan_.position());
            if (rest.starts_with("//")) {
                scan_.line();
            } else if (rest.starts_with("/*")) {
                const auto end = rest.find("*/", 2);
                scan_.seek(end == rest.npos ? scan_.text().size() : scan_.position() + end + 2);
            } else {
                return;
            }
        }
    }

    Result<void> readView()
    {
        scan_.seek(scan_.position() + 4);
        if (!scan_.skip('"')) return scan_.expected("the name of a view in quotes");
        const auto end = scan_.text().find('"', scan_.position());
        if (end == std::string_view::npos) return scan_.expected("the name of a view in quotes");
        const std::string name(scan_.take(end - scan_.position()));
        scan_.skip('"');
        if (!scan_.skip('{')) return scan_.expected("{");
        if (++views_ == 1) field_.name = name;
        for (skipComments(); !scan_.skip('}'); skipComments())
            if (auto done = readItem(); !done) return done;
        scan_.skip(';');
        return {};
    }

    /// A list of numbers in brackets; those of another kind end it.
    Result<void> readList(char open, char close, std::vector<double>& values)
    {
        values.clear();
        if (!scan_.skip(open)) return scan_.expected(std::string("a list in ") + open + close);
        for (double value = 0; scan_.number(value);) {
            values.push_back(value);
            if (!scan_.skip(',')) break;
        }
        if (!scan_.skip(close)) return scan_.expected(std::string("a number, or ") + close);
        return {};
    }

    Result<void> readItem()
    {
        scan_.skipBlanks();
        const auto rest = scan_.text().substr(scan_.position(), 40);
        const auto letters = rest.substr(0, std::min(rest.find_first_of("({ \t\r\n"), rest.size()));
        static constexpr std::string_view kShapes = "PLTQSIHY";
        static constexpr int kCorners[] = {1, 2, 3, 4, 4, 6, 8, 5};
        const auto shape = letters.size() == 2 ? kShapes.find(letters[1]) : kShapes.npos;
        if (letters == "TIME" || letters.starts_with("INTERPOLATION_SCHEME") || letters == "T2" ||
            letters == "T3")
            return skipItem();
        if (shape == kShapes.npos || std::string_view("SVT").find(letters[0]) == std::string_view::npos)
            return scan_.expected("an item of a view such as SS(...){...};");
        scan_.seek(scan_.position() + 2);
        if (auto done = readList('(', ')', places_); !done) return done;
        if (auto done = readList('{', '}', values_); !done) return done;
        scan_.skip(';');
        const auto corners = static_cast<std::size_t>(kCorners[shape]);
        const std::size_t components = letters[0] == 'S' ? 1 : letters[0] == 'V' ? 3 : 9;
        if (places_.size() != 3 * corners || values_.empty() || values_.size() % (corners * components) != 0)
            return Failure{scan_.path() + ": " + scan_.place() + ": expected " + std::to_string(3 * corners) +
                           " coordinates and " + std::to_string(corners * components) + " values for " +
                           std::string(letters) + ", found " + std::to_string(places_.size()) + " and " +
                           std::to_string(values_.size())};
        if (views_ > 1) return {};
        if (shape < 4) {
            mesh_.skipSurface();
        } else if (components > 1) {
            mesh_.skipUnknown();
        } else {
            addCell(letters[1] == 'S'   ? CellKind::tetra
                    : letters[1] == 'I' ? CellKind::prism
                    : letters[1] == 'H' ? CellKind::hexa
                                        : CellKind::pyramid,
                    corners);
        }
        return {};
    }

    Result<void> skipItem()
    {
        const auto end = scan_.text().find(';', scan_.position());
        if (end == std::string_view::npos) return scan_.expected("an item that ends in ;");
        scan_.seek(end + 1);
        return {};
    }

    void addCell(CellKind kind, std::size_t corners)
    {
        std::array<std::int64_t, kMostCorners> cell{};
        for (std::size_t i = 0; i < corners; ++i)
            cell[i] = pointAt({places_[3 * i], places_[3 * i + 1], places_[3 * i + 2]}, values_[i]);
        steps_ = std::max(steps_, values_.size() / corners);
        mesh_.addCell(kind, std::span(cell).first(corners));
    }

    /// Each item has points of its own: those of the same place and value are one.
    std::int64_t pointAt(const std::array<double, 3>& place, double value)
    {
        const Key key{place[0], place[1], place[2], value};
        const auto [found, isNew] = known_.try_emplace(key, static_cast<std::int64_t>(mesh_.points.size()));
        if (isNew) {
            mesh_.points.push_back(place);
            field_.values.push_back(value);
        }
        return found->second;
    }

    using Key = std::array<double, 4>;
    struct KeyHash
    {
        std::size_t operator()(const Key& key) const
        {
            std::uint64_t hash = 0;
            for (const double part : key) {
                hash ^= std::bit_cast<std::uint64_t>(part + 0.0); // one zero
                hash = (hash ^ (hash >> 29)) * 0xbf58476d1ce4e5b9u;
            }
            return hash ^ (hash >> 32);
        }
    };

    TextScanner scan_;
    MeshAssembly mesh_;
    MeshField field_;
    std::int64_t views_ = 0;
    std::size_t steps_ = 0;
    std::vector<double> places_, values_;
    std::unordered_map<Key, std::int64_t, KeyHash> known_;
};

} // namespace

Result<Mesh> readGmshView(const std::string& path, std::string_view bytes)
{
    return GmshView(path, bytes).read();
}

} // namespace vo
