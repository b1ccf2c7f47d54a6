#include "mesh_scene.h"

#include <algorithm>
#include <climits>
#include <cmath>
#include <span>

namespace {

using vo::Failure;
using vo::Mesh;
using vo::MeshField;

struct FoundField
{
    const MeshField* field = nullptr;
    bool onCells = false;
};

std::string fieldNames(const Mesh& mesh)
{
    std::string names;
    for (const auto* fields : {&mesh.pointFields, &mesh.cellFields})
        for (const MeshField& field : *fields)
            names.append(names.empty() ? "" : ", ").append(field.name);
    return names;
}

vo::Result<FoundField> findField(const Mesh& mesh, const std::string& name)
{
    const std::pair<const std::vector<MeshField>*, bool> places[] = {{&mesh.pointFields, false},
                                                                     {&mesh.cellFields, true}};
    for (const bool scalar : {true, false})
        for (const auto& [fields, onCells] : places)
            for (const MeshField& field : *fields)
                if (name.empty() ? !scalar || field.components == 1 : field.name == name)
                    return FoundField{&field, onCells};
    const std::string names = fieldNames(mesh);
    if (names.empty()) return Failure{"expected a field, found none at points or on cells"};
    return Failure{"expected one of the fields " + names + ", found '" + name + "'"};
}

/// The number that is shown of a field's `components` numbers.
double shown(const double* numbers, int components, int component)
{
    if (component >= 0) return numbers[component];
    if (components == 1) return numbers[0];
    double length = 0;
    for (int i = 0; i < components; i++)
        length = std::hypot(length, numbers[i]);
    return length;
}

class SceneMaker
{
public:
    SceneMaker(const Mesh& mesh, const FoundField& found, int component)
        : mesh_(mesh), split_(vo::splitMesh(mesh)), field_(*found.field), onCells_(found.onCells),
          component_(component)
    {
        numbers_ = onCells_ ? field_.values : vo::valuesAtPoints(mesh, split_, field_);
    }

    vo::Result<MeshScene> make()
    {
        const std::size_t vertices = onCells_ ? 4 * split_.tetras.size() : split_.points.size();
        if (vertices > INT_MAX / 8 || split_.tetras.size() > INT_MAX / 8)
            return Failure{"expected at most " + std::to_string(INT_MAX / 8) + " tetrahedra, found " +
                           std::to_string(split_.tetras.size())};
        markCells();
        addTetras();
        if (scene_.tetras.empty())
            return Failure{"expected numbers of the field '" + field_.name + "' on a cell, found none"};
        addFaces();
        fit();
        if (!isColor()) findRange();
        scene_.fieldName = field_.name;
        if (!isColor() && field_.components > 1 && component_ >= 0)
            scene_.fieldName.append(" ").append(std::to_string(component_));
        return std::move(scene_);
    }

private:
    bool isColor() const { return field_.isColor && component_ < 0; }
    const double* numbersOf(std::int64_t place) const
    {
        return numbers_.data() +
               static_cast<std::size_t>(place) * static_cast<std::size_t>(field_.components);
    }
    bool hasValue(std::int64_t place) const
    {
        return std::isfinite(static_cast<float>(shown(numbersOf(place), field_.components, component_)));
    }

    /// Cells that are shown: those with numbers at all corners.
    void markCells()
    {
        hasValue_.resize(mesh_.cellCount());
        std::size_t first = 0;
        for (std::size_t cell = 0; cell < mesh_.cellCount(); cell++) {
            const auto corners = static_cast<std::size_t>(vo::shapeOf(mesh_.kinds[cell]).corners);
            hasValue_[cell] = true;
            if (onCells_) hasValue_[cell] = hasValue(static_cast<std::int64_t>(cell));
            for (std::size_t i = first; !onCells_ && i < first + corners; i++)
                hasValue_[cell] = hasValue_[cell] && hasValue(mesh_.corners[i]);
            first += corners;
            scene_.cellsWithoutValue += !hasValue_[cell];
        }
    }

    /// The vertex of a point with the numbers of a place.
    int vertexOf(std::int64_t point, std::int64_t place)
    {
        int& known = vertexOfPoint_[static_cast<std::size_t>(point)];
        if (known >= 0 && !onCells_) return known;
        known = static_cast<int>(places_.size());
        places_.push_back(split_.points[static_cast<std::size_t>(point)]);
        const double* numbers = numbersOf(place);
        if (isColor()) {
            std::array<float, 4> color{0, 0, 0, 1};
            for (std::size_t i = 0; i < static_cast<std::size_t>(field_.components); i++)
                color[i] = static_cast<float>(std::clamp(numbers[i], 0.0, 1.0));
            scene_.colors.push_back(color);
        } else {
            scene_.values.push_back(shown(numbers, field_.components, component_));
        }
        return known;
    }

    void addTetras()
    {
        vertexOfPoint_.assign(split_.points.size(), -1);
        for (std::size_t i = 0; i < split_.tetras.size(); i++) {
            const std::int64_t cell = split_.cellOfTetra[i];
            if (!hasValue_[static_cast<std::size_t>(cell)]) continue;
            for (const std::int64_t point : split_.tetras[i])
                scene_.tetras.push_back(vertexOf(point, onCells_ ? cell : point));
        }
    }

    void addFaces()
    {
        std::size_t first = 0;
        for (std::size_t cell = 0; cell < mesh_.cellCount(); cell++) {
            const vo::CellShape& shape = vo::shapeOf(mesh_.kinds[cell]);
            const auto vertex = [&](int corner) {
                return vertexOfPoint_[static_cast<std::size_t>(
                    mesh_.corners[first + static_cast<std::size_t>(corner)])];
            };
            for (std::size_t f = 0; hasValue_[cell] && f < static_cast<std::size_t>(shape.faces); f++) {
                const auto corners =
                    std::span(shape.face[f].corner).first(static_cast<std::size_t>(shape.face[f].corners));
                // Corners of flat parts of a cell belong to no tetrahedron.
                if (std::ranges::any_of(corners, [&](int corner) { return vertex(corner) < 0; })) continue;
                scene_.faces.push_back(shape.face[f].corners);
                for (const int corner : corners)
                    scene_.faces.push_back(vertex(corner));
            }
            first += static_cast<std::size_t>(shape.corners);
        }
    }

    void fit()
    {
        std::array<double, 3> lower = places_[0], upper = places_[0];
        for (const auto& place : places_)
            for (std::size_t i = 0; i < 3; i++) {
                lower[i] = std::min(lower[i], place[i]);
                upper[i] = std::max(upper[i], place[i]);
            }
        const double enlarged =
            kLongestSide / std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
        const auto moved = [&](const std::array<double, 3>& place) {
            std::array<float, 3> to{};
            for (std::size_t i = 0; i < 3; i++)
                to[i] = static_cast<float>(enlarged * (place[i] - lower[i]));
            return to;
        };
        for (const auto& place : places_)
            scene_.positions.push_back(moved(place));
        scene_.size = moved(upper);
    }

    void findRange()
    {
        const auto [low, high] = std::minmax_element(scene_.values.begin(), scene_.values.end());
        scene_.low = *low;
        scene_.high = *high;
    }

    const Mesh& mesh_;
    vo::SplitMesh split_;
    const MeshField& field_;
    bool onCells_;
    int component_;
    std::vector<double> numbers_;
    std::vector<bool> hasValue_;
    std::vector<int> vertexOfPoint_;
    std::vector<std::array<double, 3>> places_; // of vertices
    MeshScene scene_;
};

} // namespace

vo::Result<MeshScene> makeScene(const Mesh& mesh, const FieldChoice& choice)
{
    const auto found = findField(mesh, choice.name);
    if (!found) return found.failure();
    const MeshField& field = *found->field;
    if (choice.component >= field.components)
        return Failure{"option -component: expected 0 to " + std::to_string(field.components - 1) +
                       " of the field '" + field.name + "', found '" + std::to_string(choice.component) +
                       "'"};
    return SceneMaker(mesh, *found, choice.component).make();
}

std::vector<int> outerFaces(const std::vector<int>& faces)
{
    struct Entry
    {
        std::array<int, 4> corners; // in ascending order, -1 in front of three
        std::size_t place;
    };
    std::vector<Entry> entries;
    for (std::size_t at = 0; at < faces.size(); at += std::size_t(faces[at]) + 1) {
        Entry entry{{-1, -1, -1, -1}, at};
        std::copy_n(faces.begin() + std::ptrdiff_t(at) + 1, faces[at], entry.corners.begin());
        std::ranges::sort(entry.corners);
        entries.push_back(entry);
    }
    std::ranges::sort(entries, {}, &Entry::corners);
    std::vector<int> outer;
    for (std::size_t i = 0; i < entries.size(); i++) {
        const bool repeated = (i > 0 && entries[i - 1].corners == entries[i].corners) ||
                              (i + 1 < entries.size() && entries[i + 1].corners == entries[i].corners);
        const auto from = faces.begin() + std::ptrdiff_t(entries[i].place);
        if (!repeated) outer.insert(outer.end(), from, from + *from + 1);
    }
    return outer;
}
