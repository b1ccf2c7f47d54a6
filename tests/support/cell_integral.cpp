#include "support/cell_integral.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace vo::test {
namespace {

constexpr int kSteps = 48; // within a tetrahedron

struct Ray
{
    glm::dvec3 start, way; // a unit vector
};

/// A tetrahedron, ready to be met by rays.
class Cell
{
public:
    explicit Cell(const Tetrahedron& t)
        : origin_(t[0]), fromSpace_(glm::inverse(glm::dmat3(t[1] - t[0], t[2] - t[0], t[3] - t[0]))),
          centre_(0.25 * (t[0] + t[1] + t[2] + t[3]))
    {
        for (const glm::dvec3& corner : t)
            radius_ = std::max(radius_, glm::distance(corner, centre_));
    }

    bool mayMeet(const Ray& ray) const
    {
        const glm::dvec3 to = centre_ - ray.start;
        const glm::dvec3 aside = to - glm::dot(to, ray.way) * ray.way;
        return glm::dot(aside, aside) <= radius_ * radius_;
    }
    std::array<double, 4> weights(const glm::dvec3& point) const
    {
        const glm::dvec3 w = fromSpace_ * (point - origin_);
        return {1 - w.x - w.y - w.z, w.x, w.y, w.z};
    }
    /// The part of the ray where no weight is below 0.
    bool meets(const Ray& ray, double& from, double& to) const
    {
        const auto begin = weights(ray.start), end = weights(ray.start + ray.way);
        from = 0;
        to = HUGE_VAL;
        for (std::size_t i = 0; i < 4; ++i) {
            const double slope = end[i] - begin[i];
            if (slope == 0 && begin[i] < 0) return false;
            if (slope > 0) from = std::max(from, -begin[i] / slope);
            if (slope < 0) to = std::min(to, -begin[i] / slope);
        }
        return from < to;
    }

private:
    glm::dvec3 origin_;
    glm::dmat3 fromSpace_;
    glm::dvec3 centre_;
    double radius_ = 0;
};

/// What a piece of a ray adds, and what it lets through.
struct Piece
{
    double from;
    std::array<double, 3> light{};
    double through = 1;
};

Piece integrate(const CellScene& scene, std::size_t tetra, const Cell& cell, const Ray& ray, double from,
                double to)
{
    Piece piece{from};
    const double step = (to - from) / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const auto rgba = scene.colorAt(tetra, cell.weights(ray.start + (from + (i + 0.5) * step) * ray.way));
        const double through = std::pow(1 - rgba[3], step);
        for (std::size_t c = 0; c < 3; ++c)
            piece.light[c] += piece.through * (1 - through) * rgba[c];
        piece.through *= through;
    }
    return piece;
}

} // namespace

Picture integrateCells(const CellScene& scene)
{
    const auto pixels = static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
    Picture picture{scene.width, scene.height, std::vector<double>(4 * pixels),
                    std::vector<std::uint8_t>(pixels, 1)};
    const glm::dmat4 fromClip =
        glm::inverse(glm::make_mat4(scene.view.projection.data()) * glm::make_mat4(scene.view.model.data()));
    const auto place = [&](double x, double y, double z) {
        const glm::dvec4 p = fromClip * glm::dvec4(x, y, z, 1);
        return glm::dvec3(p) / p.w;
    };
    std::vector<Cell> cells(scene.tetras.begin(), scene.tetras.end());
    std::vector<Piece> pieces;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
        const double x =
            2 * (static_cast<double>(pixel % static_cast<std::size_t>(scene.width)) + 0.5) / scene.width - 1;
        const double y =
            2 * (static_cast<double>(pixel / static_cast<std::size_t>(scene.width)) + 0.5) / scene.height - 1;
        const Ray ray{place(x, y, -1), glm::normalize(place(x, y, 1) - place(x, y, -1))};
        pieces.clear();
        for (std::size_t i = 0; i < cells.size(); ++i) {
            double from = 0, to = 0;
            if (cells[i].mayMeet(ray) && cells[i].meets(ray, from, to))
                pieces.push_back(integrate(scene, i, cells[i], ray, from, to));
        }
        std::ranges::sort(pieces, {}, &Piece::from);
        double through = 1;
        for (const Piece& piece : pieces) {
            for (std::size_t c = 0; c < 3; ++c)
                picture.rgba[4 * pixel + c] += through * piece.light[c];
            through *= piece.through;
        }
        picture.rgba[4 * pixel + 3] = 1 - through;
    }
    return picture;
}

} // namespace vo::test
