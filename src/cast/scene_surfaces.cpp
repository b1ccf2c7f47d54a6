#include "cast/scene_surfaces.h"

#include "style/styled_voxels.h"
#include "style/styles.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
};

/// A triangle in a pixel.
struct CastSurfaces::Hit
{
    double depth = std::numeric_limits<double>::infinity();
    std::uint32_t pixel = 0; ///< of the tile
    Triangle triangle{};
    glm::dvec3 weights{0.0}; ///< of the corners
    bool front = true;
};

struct CastSurfaces::Covered
{
    std::vector<Hit> opaque; ///< one a pixel
    std::vector<Hit> translucent;
};

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
    : scene_(scene), rays_(rays), grid_(grid)
{
    for (const StyledSurface& surface : scene.surfaces)
        if (isSound(surface)) prepare(surface);
    if (surfaces_.empty()) return;
    tiles_.resize(grid_.count());
    for (std::uint32_t surface = 0; surface < surfaces_.size(); ++surface)
        for (std::size_t i = 0; i + 3 <= surfaces_[surface].styled->triangles.size(); i += 3)
            sortIntoTiles(surface, i);
}

CastSurfaces::~CastSurfaces() = default;

void CastSurfaces::prepare(const StyledSurface& surface)
{
    const glm::dmat4 eyeFromLocal = scene_.eyeFromWorld * surface.worldFromLocal;
    const glm::dmat3 linear(surface.worldFromLocal);
    Prepared prepared{&surface,         {}, glm::transpose(glm::inverse(linear)), shadingOf(surface),
                      {surface.lights}, {}};
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
    Triangle triangle{surface, prepared.styled->isOpaque(first), {}};
    std::array<glm::dvec3, 3> windows;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.corners[i] = static_cast<std::uint32_t>(prepared.styled->triangles[first + i]);
        windows[i] = prepared.vertices[triangle.corners[i]].window;
    }
    const auto& [a, b, c] = windows;
    if (!(std::max({a.z, b.z, c.z}) > 0.0) || Edges(a, b, c).flat) return;
    grid_.forTilesOf(pixelsOf(windows, grid_.picture()),
                     [&](std::size_t tile) { tiles_[tile].push_back(triangle); });
}

void CastSurfaces::cover(const Triangle& triangle, const PictureTile& tile, Covered& covered) const
{
    const Prepared& prepared = surfaces_[triangle.surface];
    std::array<glm::dvec3, 3> windows;
    glm::dvec3 depths;
    for (int corner = 0; corner < 3; ++corner) {
        const auto i = static_cast<std::size_t>(corner);
        windows[i] = prepared.vertices[triangle.corners[i]].window;
        depths[corner] = prepared.vertices[triangle.corners[i]].depth;
    }
    const Edges edges(windows[0], windows[1], windows[2]);
    const glm::dvec3 outward = prepared.normalMatrix * faceNormal(*prepared.styled, triangle.corners);
    const PictureTile pixels = pixelsOf(windows, tile);
    for (int y = pixels.y; y < pixels.y + pixels.height; ++y)
        for (int x = pixels.x; x < pixels.x + pixels.width; ++x) {
            const glm::dvec3 place(x + 0.5, y + 0.5, 1.0);
            if (!edges.contain(place)) continue;
            // The middle of the pixel may lie a little outside.
            const glm::dvec3 inside(std::max(glm::dot(edges.edge[0], place), 0.0),
                                    std::max(glm::dot(edges.edge[1], place), 0.0),
                                    std::max(glm::dot(edges.edge[2], place), 0.0));
            Hit hit;
            hit.pixel = static_cast<std::uint32_t>(tile.pixelAt(x, y));
            hit.triangle = triangle;
            hit.weights = inside / (inside.x + inside.y + inside.z);
            hit.depth = glm::dot(hit.weights, depths);
            if (!(hit.depth < covered.opaque[hit.pixel].depth)) continue;
            const DepthRay ray = transformed(rays_.worldFromEye(), rays_.ray(place.x, place.y));
            hit.front = glm::dot(outward, ray.direction) < 0.0;
            if (!isSeen(prepared, hit, ray)) continue;
            if (triangle.isOpaque)
                covered.opaque[hit.pixel] = hit;
            else
                covered.translucent.push_back(hit);
        }
}

bool CastSurfaces::isSeen(const Prepared& prepared, const Hit& hit, const DepthRay& ray) const
{
    if (prepared.styled->solid && !hit.front) return false;
    if (!(hit.depth >= rays_.depths().begin && hit.depth <= rays_.depths().end)) return false;
    const glm::dvec4 position(ray.at(hit.depth), 1.0);
    // A face that lies in a plane is whole, however places on rays are rounded.
    const double rounding = 1e-12 * (glm::length(ray.origin) + glm::length(glm::dvec3(position)));
    return std::all_of(prepared.clipPlanes.begin(), prepared.clipPlanes.end(), [&](const glm::dvec4& plane) {
        return glm::dot(plane, position) >= -rounding * glm::length(glm::dvec3(plane));
    });
}

void CastSurfaces::draw(const PictureTile& tile, SurfaceTile& result) const
{
    result.opaque_.clear();
    result.translucent_.clear();
    result.first_.clear();
    if (tiles_.empty()) return;
    const auto& triangles = tiles_[grid_.numberAt(tile.x, tile.y)];
    if (triangles.empty()) return;
    const std::size_t pixels = tile.pixelCount();
    Covered covered;
    covered.opaque.resize(pixels);
    for (const bool opaque : {true, false})
        for (const Triangle& triangle : triangles)
            if (triangle.isOpaque == opaque) cover(triangle, tile, covered);
    std::stable_sort(covered.translucent.begin(), covered.translucent.end(), [](const Hit& a, const Hit& b) {
        return a.pixel != b.pixel ? a.pixel < b.pixel : a.depth < b.depth;
    });
    result.opaque_.resize(pixels);
    std::vector<Hit> opaque;
    for (const Hit& hit : covered.opaque)
        if (std::isfinite(hit.depth)) opaque.push_back(hit);
    const std::vector<glm::vec4> opaqueColors = colorsOf(tile, opaque);
    for (std::size_t i = 0; i < opaque.size(); ++i)
        result.opaque_[opaque[i].pixel] = {opaque[i].depth, opaqueColors[i]};
    const std::vector<glm::vec4> colors = colorsOf(tile, covered.translucent);
    result.first_.assign(pixels + 1, 0);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        result.translucent_.push_back({covered.translucent[i].depth, colors[i]});
        ++result.first_[covered.translucent[i].pixel + 1];
    }
    std::partial_sum(result.first_.begin(), result.first_.end(), result.first_.begin());
}

/// Fragments of one surface are lit together.
std::vector<glm::vec4> CastSurfaces::colorsOf(const PictureTile& tile, std::span<const Hit> hits) const
{
    std::vector<glm::vec4> colors(hits.size());
    std::vector<std::size_t> order(hits.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return hits[a].triangle.surface < hits[b].triangle.surface;
    });
    for (std::size_t first = 0; first < order.size();) {
        std::size_t end = first;
        while (end < order.size() && end - first < kBatchSize &&
               hits[order[end]].triangle.surface == hits[order[first]].triangle.surface)
            ++end;
        shade(tile, hits, std::span(order).subspan(first, end - first), colors);
        first = end;
    }
    return colors;
}

void CastSurfaces::shade(const PictureTile& tile, std::span<const Hit> hits,
                         std::span<const std::size_t> which, std::span<glm::vec4> colors) const
{
    const Prepared& prepared = surfaces_[hits[which[0]].triangle.surface];
    const StyledSurface& styled = *prepared.styled;
    SampleBatch batch{};
    batch.count = static_cast<int>(which.size());
    for (std::size_t i = 0; i < which.size(); ++i) {
        const Hit& hit = hits[which[i]];
        const auto pixel = static_cast<int>(hit.pixel);
        const DepthRay ray = transformed(rays_.worldFromEye(), rays_.ray(tile.x + pixel % tile.width + 0.5,
                                                                         tile.y + pixel / tile.width + 0.5));
        const glm::vec3 position(ray.at(hit.depth));
        const glm::vec3 V(glm::normalize(-ray.direction));
        glm::dvec3 normal = prepared.normalMatrix * normalAt(styled, hit.triangle.corners, hit.weights);
        if (!hit.front) normal = -normal;
        const double length = glm::length(normal);
        const glm::vec3 n(length > 0.0 ? normal / length : glm::dvec3(0.0));
        const glm::vec4 color = styled.colors.empty()
                                    ? glm::vec4(styled.diffuse, 1.0f - styled.transparency)
                                    : weighted(styled.colors, hit.triangle.corners, hit.weights);
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
