#include "cast/scene_surfaces.h"

#include "style/styled_voxels.h"
#include "style/styles.h"
#include "style/uncut_planes.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace vo {

/// A corner in the picture: pixels times w, w, and eye depth.
struct CastSurfaces::Vertex
{
    glm::dvec3 window;
    double depth;
};

struct CastSurfaces::Prepared
{
    const StyledSurface* styled;
    std::size_t number; ///< of the scene
    std::vector<Vertex> vertices;
    glm::dmat3 normalMatrix; ///< world from local, for normals
    std::shared_ptr<const Style> shading;
    StyleSurroundings surroundings;
    std::vector<glm::dvec4> clipPlanes; ///< world, after the edgeShift()
};

struct CastSurfaces::Triangle
{
    std::uint32_t surface;
    bool isOpaque;
    std::array<std::uint32_t, 3> corners;
    int plane;           ///< of SharedPlanes, or below 0
    std::uint32_t uncut; ///< uncutPlanes()
};

/// The triangles that a tile may have.
struct CastSurfaces::TileTriangles
{
    std::vector<Triangle> all;
    std::size_t mostCrossings = 0; ///< of translucent ones with pixels
};

/// A triangle at a pixel's middle.
struct CastSurfaces::Crossing
{
    double depth = std::numeric_limits<double>::infinity();
    std::uint32_t pixel = 0;    ///< of the part that is drawn
    std::uint32_t triangle = 0; ///< of the tile
    float opacity = 1.0f;
};

/// The rays of pixels, world, each found once.
class CastSurfaces::PixelRays
{
public:
    PixelRays(const SceneRays& rays, const PictureTile& part)
        : rays_(rays), part_(part), found_(part.pixelCount(), {glm::dvec3(0.0), glm::dvec3(0.0)})
    {
    }

    glm::dvec3 placeOf(std::size_t pixel) const
    {
        const auto number = static_cast<int>(pixel);
        return {part_.x + number % part_.width + 0.5, part_.y + number / part_.width + 0.5, 1.0};
    }
    const DepthRay& of(std::size_t pixel)
    {
        DepthRay& ray = found_[pixel];
        if (ray.direction != glm::dvec3(0.0)) return ray;
        const glm::dvec3 place = placeOf(pixel);
        return ray = transformed(rays_.worldFromEye(), rays_.ray(place.x, place.y));
    }

private:
    const SceneRays& rays_;
    PictureTile part_;
    std::vector<DepthRay> found_;
};

/// All crossings of a part of a tile that count.
class CastSurfaces::Covered
{
public:
    explicit Covered(std::size_t pixels) : nearest_(pixels), fronts_(pixels) {}

    bool isHidden(std::size_t pixel, double depth) const
    {
        const Front& front = fronts_[pixel];
        return !(depth < nearest_[pixel].depth) || (front.through < kLeastThrough && depth > front.farthest);
    }
    void addOpaque(const Crossing& crossing) { nearest_[crossing.pixel] = crossing; }
    void addTranslucent(const Crossing& crossing)
    {
        Front& front = fronts_[crossing.pixel];
        front.through *= 1.0f - crossing.opacity;
        front.farthest = std::max(front.farthest, crossing.depth);
        ++front.count;
        translucent_.push_back(crossing);
    }
    std::vector<Crossing> opaque() const;
    /// By pixels, the nearest first.
    std::vector<Crossing> translucent() const;

private:
    /// Rays end earlier (cast/cast_scene.cpp).
    static constexpr float kLeastThrough = 1.0f / 4096.0f;
    /// The translucent ones so far.
    struct Front
    {
        float through = 1.0f;
        double farthest = -std::numeric_limits<double>::infinity();
        std::size_t count = 0;
    };

    std::vector<Crossing> nearest_;
    std::vector<Front> fronts_;
    std::vector<Crossing> translucent_;
};

std::vector<CastSurfaces::Crossing> CastSurfaces::Covered::opaque() const
{
    std::vector<Crossing> found;
    for (const Crossing& crossing : nearest_)
        if (std::isfinite(crossing.depth)) found.push_back(crossing);
    return found;
}

std::vector<CastSurfaces::Crossing> CastSurfaces::Covered::translucent() const
{
    std::vector<Crossing> sorted(translucent_.size());
    std::vector<std::size_t> end(fronts_.size() + 1, 0);
    for (std::size_t pixel = 0; pixel < fronts_.size(); ++pixel)
        end[pixel + 1] = end[pixel] + fronts_[pixel].count;
    std::vector<std::size_t> next = end;
    for (const Crossing& crossing : translucent_)
        sorted[next[crossing.pixel]++] = crossing;
    // What comes first in the scene is in front at one depth.
    const auto isBefore = [](const Crossing& a, const Crossing& b) {
        return a.depth != b.depth ? a.depth < b.depth : a.triangle < b.triangle;
    };
    for (std::size_t pixel = 0; pixel < fronts_.size(); ++pixel) {
        const auto its = std::span(sorted).subspan(end[pixel], fronts_[pixel].count);
        if (!std::ranges::is_sorted(its, isBefore)) std::ranges::sort(its, isBefore);
    }
    return sorted;
}

namespace {

/// The lines through a triangle's corners: dot(edge, (x, y, 1)) is not negative inside.
struct Edges
{
    std::array<glm::dvec3, 3> edge;
    bool flat = false;

    Edges(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
        : edge{glm::cross(b, c), glm::cross(c, a), glm::cross(a, b)}
    {
        const double area = glm::dot(a, edge[0]);
        flat = !(std::abs(area) > 0.0) || !std::isfinite(area);
        if (area < 0.0)
            for (glm::dvec3& e : edge)
                e = -e;
    }

    /// Of the corners, at the middle of a pixel that may lie a little outside.
    glm::dvec3 weightsAt(const glm::dvec3& place) const
    {
        const glm::dvec3 inside(std::max(glm::dot(edge[0], place), 0.0),
                                std::max(glm::dot(edge[1], place), 0.0),
                                std::max(glm::dot(edge[2], place), 0.0));
        return inside / (inside.x + inside.y + inside.z);
    }

    /// Where two triangles share an edge, a pixel on it belongs to one of them.
    bool contain(const glm::dvec3& place) const
    {
        const glm::dvec3 seen = place + glm::dvec3(kPixelsPastCenter, kPixelsAboveCenter, 0.0);
        return std::all_of(edge.begin(), edge.end(), [&seen](const glm::dvec3& e) {
            const double value = glm::dot(e, seen);
            return value > 0.0 || (value == 0.0 && (e.x > 0.0 || (e.x == 0.0 && e.y > 0.0)));
        });
    }
};

std::shared_ptr<const Style> shadingOf(const StyledSurface& surface)
{
    Shaded fields;
    fields.lighting = surface.lit;
    fields.ambientIntensity = surface.ambientIntensity;
    fields.shininess = surface.shininess;
    fields.emissive = surface.emissive;
    fields.specular = surface.specular;
    return makeStyle(fields);
}

template <class Vector>
Vector weighted(const std::vector<Vector>& of, const std::array<std::uint32_t, 3>& corners,
                const glm::dvec3& weights)
{
    return of[corners[0]] * static_cast<float>(weights.x) + of[corners[1]] * static_cast<float>(weights.y) +
           of[corners[2]] * static_cast<float>(weights.z);
}

/// Of the outside, local, of some length.
glm::dvec3 faceNormal(const StyledSurface& surface, const std::array<std::uint32_t, 3>& corners)
{
    const glm::dvec3 a(surface.positions[corners[0]]), b(surface.positions[corners[1]]),
        c(surface.positions[corners[2]]);
    return glm::cross(b - a, c - a);
}

glm::dvec3 normalAt(const StyledSurface& surface, const std::array<std::uint32_t, 3>& corners,
                    const glm::dvec3& weights)
{
    if (surface.normals.empty()) return faceNormal(surface, corners);
    return weighted(surface.normals, corners, weights);
}

} // namespace

CastSurfaces::CastSurfaces(const StyledScene& scene, const SceneRays& rays, const TileGrid& grid)
    : scene_(scene), rays_(rays), planes_(scene), grid_(grid)
{
    for (std::size_t number = 0; number < scene.surfaces.size(); ++number)
        if (isSound(scene.surfaces[number])) prepare(number);
    if (surfaces_.empty()) return;
    tiles_.resize(grid_.count());
    for (std::uint32_t surface = 0; surface < surfaces_.size(); ++surface)
        for (std::size_t i = 0; i + 3 <= surfaces_[surface].styled->triangles.size(); i += 3)
            sortIntoTiles(surface, i);
}

CastSurfaces::~CastSurfaces() = default;

void CastSurfaces::prepare(std::size_t number)
{
    const StyledSurface& surface = scene_.surfaces[number];
    const glm::dmat4 eyeFromLocal = scene_.eyeFromWorld * surface.worldFromLocal;
    const glm::dmat3 linear(surface.worldFromLocal);
    Prepared prepared{&surface,           number,           {}, glm::transpose(glm::inverse(linear)),
                      shadingOf(surface), {surface.lights}, {}};
    const glm::dmat4 worldShift = rays_.worldFromEye() * rays_.shift() * scene_.eyeFromWorld;
    for (const glm::dvec4& plane : surface.clipPlanes)
        prepared.clipPlanes.push_back(plane * worldShift);
    prepared.vertices.reserve(surface.positions.size());
    for (const glm::vec3& position : surface.positions) {
        const glm::dvec4 eye = eyeFromLocal * glm::dvec4(position, 1.0);
        prepared.vertices.push_back({windowOf(scene_, eye), -eye.z});
    }
    surfaces_.push_back(std::move(prepared));
}

void CastSurfaces::sortIntoTiles(std::uint32_t surface, std::size_t first)
{
    const Prepared& prepared = surfaces_[surface];
    Triangle triangle{surface,
                      prepared.styled->isOpaque(first),
                      {},
                      planes_.numberOf(prepared.number, first),
                      uncutPlanes(*prepared.styled, first)};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.corners[i] = static_cast<std::uint32_t>(prepared.styled->triangles[first + i]);
    const std::array<glm::dvec3, 3> windows = windowsOf(triangle);
    const auto& [a, b, c] = windows;
    if (!(std::max({a.z, b.z, c.z}) > 0.0) || Edges(a, b, c).flat) return;
    grid_.forTilesOf(pixelsOf(windows, grid_.picture()), [&](std::size_t number) {
        TileTriangles& tile = tiles_[number];
        tile.all.push_back(triangle);
        if (!triangle.isOpaque) tile.mostCrossings += pixelsOf(windows, grid_.tile(number)).pixelCount();
    });
}

std::array<glm::dvec3, 3> CastSurfaces::windowsOf(const Triangle& triangle) const
{
    const std::vector<Vertex>& vertices = surfaces_[triangle.surface].vertices;
    const auto& [a, b, c] = triangle.corners;
    return {vertices[a].window, vertices[b].window, vertices[c].window};
}

PictureTile CastSurfaces::partFrom(const PictureTile& tile, int row) const
{
    constexpr std::size_t kMost = 1 << 17;
    PictureTile part{tile.x, row, tile.width, tile.y + tile.height - row};
    if (tiles_.empty()) return part;
    const std::size_t crossings = tiles_[grid_.numberAt(tile.x, tile.y)].mostCrossings;
    if (crossings <= kMost) return part;
    const auto rows = static_cast<int>(kMost * static_cast<std::size_t>(tile.height) / crossings);
    part.height = std::clamp(rows, 1, part.height);
    return part;
}

/// Of those with pixels in the part: what is behind many others is then known to be hidden.
std::vector<std::uint32_t> CastSurfaces::translucentNearestFirst(const PictureTile& part) const
{
    const std::vector<Triangle>& triangles = tiles_[grid_.numberAt(part.x, part.y)].all;
    std::vector<std::pair<double, std::uint32_t>> found;
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        if (triangles[i].isOpaque || pixelsOf(windowsOf(triangles[i]), part).pixelCount() == 0) continue;
        const std::vector<Vertex>& vertices = surfaces_[triangles[i].surface].vertices;
        const auto& [a, b, c] = triangles[i].corners;
        found.emplace_back(std::min({vertices[a].depth, vertices[b].depth, vertices[c].depth}), i);
    }
    std::ranges::sort(found);
    std::vector<std::uint32_t> numbers;
    std::ranges::transform(found, std::back_inserter(numbers), [](const auto& one) { return one.second; });
    return numbers;
}

void CastSurfaces::cover(const PictureTile& part, std::uint32_t number, PixelRays& rays,
                         Covered& covered) const
{
    const Triangle& triangle = tiles_[grid_.numberAt(part.x, part.y)].all[number];
    const std::array<glm::dvec3, 3> windows = windowsOf(triangle);
    const PictureTile pixels = pixelsOf(windows, part);
    if (pixels.pixelCount() == 0) return;
    const Prepared& prepared = surfaces_[triangle.surface];
    const auto& [a, b, c] = triangle.corners;
    const glm::dvec3 depths(prepared.vertices[a].depth, prepared.vertices[b].depth,
                            prepared.vertices[c].depth);
    const Edges edges(windows[0], windows[1], windows[2]);
    const bool isWhole = !prepared.styled->solid && prepared.clipPlanes.empty();
    const SharedPlane* const plane = planes_.find(triangle.plane);
    const RayPart& seen = rays_.depths();
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
        for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
            const glm::dvec3 place(x + 0.5, y + 0.5, 1.0);
            if (!edges.contain(place)) continue;
            const glm::dvec3 weights = edges.weightsAt(place);
            const double depth = plane ? plane->depthAt(2.0 * place.x / scene_.width - 1.0,
                                                        2.0 * place.y / scene_.height - 1.0)
                                       : glm::dot(weights, depths);
            const std::size_t pixel = part.pixelAt(x, y);
            if (!(depth >= seen.begin && depth <= seen.end) || covered.isHidden(pixel, depth)) continue;
            if (!isWhole && !isSeen(triangle, rays.of(pixel), depth)) continue;
            Crossing crossing{depth, static_cast<std::uint32_t>(pixel), number};
            if (triangle.isOpaque) {
                covered.addOpaque(crossing);
            } else {
                crossing.opacity = opacityOf(triangle, weights);
                covered.addTranslucent(crossing);
            }
        }
}

float CastSurfaces::opacityOf(const Triangle& triangle, const glm::dvec3& weights) const
{
    const StyledSurface& styled = *surfaces_[triangle.surface].styled;
    const float opacity = styled.colors.empty() ? 1.0f - styled.transparency
                                                : weighted(styled.colors, triangle.corners, weights).a;
    return std::clamp(opacity, 0.0f, 1.0f);
}

glm::dvec3 CastSurfaces::outwardOf(const Triangle& triangle) const
{
    const Prepared& prepared = surfaces_[triangle.surface];
    return prepared.normalMatrix * faceNormal(*prepared.styled, triangle.corners);
}

bool CastSurfaces::isSeen(const Triangle& triangle, const DepthRay& ray, double depth) const
{
    const Prepared& prepared = surfaces_[triangle.surface];
    if (prepared.styled->solid && !(glm::dot(outwardOf(triangle), ray.direction) < 0.0)) return false;
    const glm::dvec4 position(ray.at(depth), 1.0);
    for (std::size_t i = 0; i < prepared.clipPlanes.size(); ++i)
        if (!isUncut(triangle.uncut, i) && !(glm::dot(prepared.clipPlanes[i], position) >= 0.0)) return false;
    return true;
}

void CastSurfaces::draw(const PictureTile& part, SurfaceTile& result) const
{
    result.opaque_.clear();
    result.translucent_.clear();
    result.first_.clear();
    if (tiles_.empty()) return;
    const std::vector<Triangle>& triangles = tiles_[grid_.numberAt(part.x, part.y)].all;
    if (triangles.empty()) return;
    const std::size_t pixels = part.pixelCount();
    Covered covered(pixels);
    PixelRays rays(rays_, part);
    for (std::uint32_t i = 0; i < triangles.size(); ++i)
        if (triangles[i].isOpaque) cover(part, i, rays, covered);
    for (const std::uint32_t i : translucentNearestFirst(part))
        cover(part, i, rays, covered);
    result.opaque_.resize(pixels);
    const std::vector<Crossing> opaque = covered.opaque();
    const std::vector<glm::vec4> opaqueColors = colorsOf(part, opaque, rays);
    for (std::size_t i = 0; i < opaque.size(); ++i)
        result.opaque_[opaque[i].pixel] = {opaque[i].depth, opaqueColors[i]};
    const std::vector<Crossing> translucent = covered.translucent();
    const std::vector<glm::vec4> colors = colorsOf(part, translucent, rays);
    result.first_.assign(pixels + 1, 0);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        result.translucent_.push_back({translucent[i].depth, colors[i]});
        ++result.first_[translucent[i].pixel + 1];
    }
    std::partial_sum(result.first_.begin(), result.first_.end(), result.first_.begin());
}

/// Crossings of one surface are lit together.
std::vector<glm::vec4> CastSurfaces::colorsOf(const PictureTile& part, std::span<const Crossing> crossings,
                                              PixelRays& rays) const
{
    const std::vector<Triangle>& triangles = tiles_[grid_.numberAt(part.x, part.y)].all;
    const auto surfaceOf = [&](std::size_t i) { return triangles[crossings[i].triangle].surface; };
    std::vector<glm::vec4> colors(crossings.size());
    std::vector<std::size_t> order(crossings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto isBefore = [&](std::size_t a, std::size_t b) { return surfaceOf(a) < surfaceOf(b); };
    if (!std::is_sorted(order.begin(), order.end(), isBefore))
        std::stable_sort(order.begin(), order.end(), isBefore);
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first;
        while (end < order.size() && end - first < kBatchSize &&
               surfaceOf(order[end]) == surfaceOf(order[first]))
            ++end;
        shade(triangles, crossings, std::span(order).subspan(first, end - first), rays, colors);
        first = end;
    }
    return colors;
}

void CastSurfaces::shade(std::span<const Triangle> triangles, std::span<const Crossing> crossings,
                         std::span<const std::size_t> which, PixelRays& rays,
                         std::span<glm::vec4> colors) const
{
    const Prepared& prepared = surfaces_[triangles[crossings[which[0]].triangle].surface];
    const StyledSurface& styled = *prepared.styled;
    SampleBatch batch{};
    batch.count = static_cast<int>(which.size());
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Crossing& crossing = crossings[which[i]];
        const Triangle& triangle = triangles[crossing.triangle];
        const DepthRay& ray = rays.of(crossing.pixel);
        const std::array<glm::dvec3, 3> windows = windowsOf(triangle);
        const glm::dvec3 weights =
            Edges(windows[0], windows[1], windows[2]).weightsAt(rays.placeOf(crossing.pixel));
        const glm::vec3 position(ray.at(crossing.depth));
        const glm::vec3 V(glm::normalize(-ray.direction));
        glm::dvec3 normal = prepared.normalMatrix * normalAt(styled, triangle.corners, weights);
        if (!(glm::dot(outwardOf(triangle), ray.direction) < 0.0)) normal = -normal;
        const double length = glm::length(normal);
        const glm::vec3 n(length > 0.0 ? normal / length : glm::dvec3(0.0));
        const glm::vec4 color = styled.colors.empty() ? glm::vec4(styled.diffuse, 1.0f - styled.transparency)
                                                      : weighted(styled.colors, triangle.corners, weights);
        const glm::vec3 begun = styled.lit ? glm::vec3(color) : styled.emissive;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            batch.position[a][i] = position[axis];
            batch.V[a][i] = V[axis];
            batch.n[a][i] = n[axis];
            batch.Cv[a][i] = begun[axis];
        }
        batch.Ov[i] = std::clamp(color.a, 0.0f, 1.0f);
    }
    prepared.shading->apply(prepared.surroundings, batch);
    for (std::size_t i = 0; i < which.size(); ++i)
        colors[which[i]] =
            glm::vec4(glm::vec3(batch.Cv[0][i], batch.Cv[1][i], batch.Cv[2][i]) * batch.Ov[i], batch.Ov[i]);
}

} // namespace vo
