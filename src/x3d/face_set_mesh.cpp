#include "x3d/face_set_mesh.h"

#include "x3d/node_values.h"
#include "x3d/polygon_triangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

namespace vo {
namespace {

/// Above these, polygons are cut as if convex, and points get the normal of each face.
constexpr std::size_t kMostCorners = 1000;
constexpr std::size_t kMostFacesAtPoint = 256;

struct Corner
{
    int point;         ///< of the coordinates
    std::size_t place; ///< in the list of indices, where colorIndex and normalIndex have theirs
};

struct Face
{
    std::size_t firstCorner, corners;
    std::size_t number; ///< counted in the file
};

class FaceSet
{
public:
    FaceSet(const Node& node, ViewMessages& messages) : node_(node), messages_(messages)
    {
        if (const Node* const coordinate = nodeOf(node, "coord")) points_ = vec3sOf(*coordinate, "point");
        if (isOf(&node, "IndexedTriangleSet"))
            takeTriangles();
        else
            takePolygons();
        if (leftOut_ > 0)
            messages.warn(node, std::to_string(leftOut_) + " faces of " + node.typeName() +
                                    " name points that are "
                                    "not among the " +
                                    std::to_string(points_.size()) + " or fewer than 3: left out");
    }

    SurfaceMesh mesh()
    {
        SurfaceMesh mesh;
        mesh.solid = boolOf(node_, "solid", true);
        for (const Corner& corner : corners_)
            mesh.positions.push_back(pointOf(corner));
        for (const Face& face : faces_)
            addTriangles(face, mesh);
        addNormals(mesh);
        addColors(mesh);
        if (!boolOf(node_, "ccw", true))
            for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3)
                std::swap(mesh.triangles[i + 1], mesh.triangles[i + 2]);
        return mesh;
    }

private:
    const glm::vec3& pointOf(const Corner& corner) const
    {
        return points_[static_cast<std::size_t>(corner.point)];
    }

    bool isPoint(std::int32_t index) const
    {
        return index >= 0 && static_cast<std::size_t>(index) < points_.size();
    }

    void takeTriangles()
    {
        const auto& indices = integersOf(node_, "index");
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
            takeFace(std::span(indices).subspan(i, 3), i, i / 3);
    }

    void takePolygons()
    {
        const auto& indices = integersOf(node_, "coordIndex");
        std::size_t number = 0;
        for (std::size_t from = 0; from < indices.size(); ++number) {
            const auto end =
                std::find(indices.begin() + static_cast<std::ptrdiff_t>(from), indices.end(), -1);
            const auto to = static_cast<std::size_t>(end - indices.begin());
            takeFace(std::span(indices).subspan(from, to - from), from, number);
            from = to + 1;
        }
    }

    void takeFace(std::span<const std::int32_t> indices, std::size_t place, std::size_t number)
    {
        const bool isThere = std::ranges::all_of(indices, [&](std::int32_t index) { return isPoint(index); });
        if (indices.size() < 3 || !isThere) {
            ++leftOut_;
            return;
        }
        faces_.push_back({corners_.size(), indices.size(), number});
        for (std::size_t i = 0; i < indices.size(); ++i)
            corners_.push_back({indices[i], place + i});
    }

    void addTriangles(const Face& face, SurfaceMesh& mesh) const
    {
        const int first = static_cast<int>(face.firstCorner);
        const bool isFan = face.corners == 3 || boolOf(node_, "convex", true) || face.corners > kMostCorners;
        if (!isFan) {
            const auto corners = std::span(mesh.positions).subspan(face.firstCorner, face.corners);
            for (const auto& [a, b, c] : polygonTriangles(corners))
                mesh.triangles.insert(mesh.triangles.end(), {first + a, first + b, first + c});
            return;
        }
        for (int i = 1; i + 1 < static_cast<int>(face.corners); ++i)
            mesh.triangles.insert(mesh.triangles.end(), {first, first + i, first + i + 1});
    }

    /// Calls put(corner's number, index) with what a list of colours or normals has for each corner or, not
    /// per vertex, for its face: by indices of its own, if there are some.
    template <class Put>
    void forIndices(const std::vector<std::int32_t>& own, bool perVertex, std::size_t listed,
                    const char* what, const Put& put) const
    {
        bool isWhole = true;
        for (const Face& face : faces_)
            for (std::size_t i = face.firstCorner; i < face.firstCorner + face.corners; ++i) {
                const std::size_t at = perVertex ? corners_[i].place : face.number;
                std::int64_t index = perVertex ? corners_[i].point : static_cast<std::int64_t>(face.number);
                if (!own.empty()) index = at < own.size() ? own[at] : -1;
                if (index >= 0 && static_cast<std::size_t>(index) < listed)
                    put(i, static_cast<std::size_t>(index));
                else
                    isWhole = false;
            }
        if (!isWhole)
            messages_.warn(node_, node_.typeName() + ": there are " + std::to_string(listed) + " " + what +
                                      ", fewer than its indices name");
    }

    void addNormals(SurfaceMesh& mesh)
    {
        const bool perVertex = boolOf(node_, "normalPerVertex", true);
        mesh.normals = computedNormals(perVertex);
        const Node* const given = nodeOf(node_, "normal");
        if (!given) return;
        const auto vectors = vec3sOf(*given, "vector");
        forIndices(integersOf(node_, "normalIndex"), perVertex, vectors.size(), "normals",
                   [&](std::size_t corner, std::size_t index) {
                       const float length = glm::length(vectors[index]);
                       if (length > 0.0f) mesh.normals[corner] = vectors[index] / length;
                   });
    }

    /// Of each corner: the mean of the faces round its point that turn away by less than the crease angle.
    std::vector<glm::vec3> computedNormals(bool perVertex) const
    {
        const double turn = boolOf(node_, "ccw", true) ? 1.0 : -1.0;
        std::vector<glm::dvec3> areas;
        for (const Face& face : faces_)
            areas.push_back(faceArea(face) * turn);
        // An IndexedTriangleSet has no crease angle: its faces are smooth.
        const double crease = isOf(&node_, "IndexedTriangleSet")
                                  ? std::numbers::pi
                                  : static_cast<double>(floatOf(node_, "creaseAngle"));
        std::vector<glm::vec3> normals(corners_.size());
        if (!perVertex || crease <= 0.0)
            for (std::size_t f = 0; f < faces_.size(); ++f)
                for (std::size_t i = 0; i < faces_[f].corners; ++i)
                    normals[faces_[f].firstCorner + i] = unit(areas[f]);
        else
            smooth(areas, crease, normals);
        return normals;
    }

    void smooth(const std::vector<glm::dvec3>& areas, double crease, std::vector<glm::vec3>& normals) const
    {
        // Faces by the points of their corners, points in order.
        struct Use
        {
            int point;
            std::size_t face, corner;
        };
        std::vector<Use> uses;
        for (std::size_t f = 0; f < faces_.size(); ++f)
            for (std::size_t i = faces_[f].firstCorner; i < faces_[f].firstCorner + faces_[f].corners; ++i)
                uses.push_back({corners_[i].point, f, i});
        std::ranges::stable_sort(uses, {}, &Use::point);
        const double least = crease >= std::numbers::pi ? -1.0 - 1e-9 : std::cos(crease);
        for (std::size_t from = 0, to = 0; from < uses.size(); from = to) {
            while (to < uses.size() && uses[to].point == uses[from].point)
                ++to;
            const bool isCrowded = to - from > kMostFacesAtPoint;
            for (std::size_t i = from; i < to; ++i) {
                glm::dvec3 sum = isCrowded ? areas[uses[i].face] : glm::dvec3(0.0);
                const glm::dvec3 own(unit(areas[uses[i].face]));
                for (std::size_t j = from; j < to && !isCrowded; ++j) {
                    const glm::dvec3& other = areas[uses[j].face];
                    if (i == j || glm::dot(own, glm::dvec3(unit(other))) >= least) sum += other;
                }
                normals[uses[i].corner] = unit(sum);
            }
        }
    }

    static glm::vec3 unit(const glm::dvec3& vector)
    {
        const double length = glm::length(vector);
        return length > 0.0 ? glm::vec3(vector / length) : glm::vec3(0.0f, 0.0f, 1.0f);
    }

    glm::dvec3 faceArea(const Face& face) const
    {
        std::vector<glm::vec3> corners;
        for (std::size_t i = 0; i < face.corners; ++i)
            corners.push_back(pointOf(corners_[face.firstCorner + i]));
        return areaVector(corners);
    }

    void addColors(SurfaceMesh& mesh) const
    {
        const Node* const given = nodeOf(node_, "color");
        if (!given) return;
        mesh.colorsHaveAlpha = isOf(given, "ColorRGBA");
        std::vector<glm::vec4> colors;
        if (mesh.colorsHaveAlpha)
            colors = vec4sOf(*given, "color");
        else
            for (const glm::vec3& color : vec3sOf(*given, "color"))
                colors.emplace_back(color, 1.0f);
        mesh.colors.assign(corners_.size(), glm::vec4(1.0f));
        forIndices(integersOf(node_, "colorIndex"), boolOf(node_, "colorPerVertex", true), colors.size(),
                   "colours",
                   [&](std::size_t corner, std::size_t index) { mesh.colors[corner] = colors[index]; });
    }

    const Node& node_;
    ViewMessages& messages_;
    std::vector<glm::vec3> points_;
    std::vector<Corner> corners_;
    std::vector<Face> faces_;
    std::size_t leftOut_ = 0;
};

} // namespace

SurfaceMesh faceSetMesh(const Node& node, ViewMessages& messages)
{
    return FaceSet(node, messages).mesh();
}

} // namespace vo
