#include "draw/draw_surfaces.h"

#include "draw/scene_view_point.h"
#include "draw/surface_program.h"
#include "style/styled_voxels.h"
#include "style/uncut_planes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

namespace vo {

namespace {

constexpr int kOpaqueValues = 10;      ///< position, normal, colour
constexpr int kTranslucentValues = 21; ///< those, plane, depths and margin, shared plane
/// Slabs into which the depths of translucent triangles are divided at least: triangles that cross are out of
/// order within a slab alone.
constexpr double kLeastSlabs = 512.0;

glm::vec3 normalAt(const StyledSurface& surface, std::size_t vertex)
{
    return vertex < surface.normals.size() ? surface.normals[vertex] : glm::vec3(0.0f);
}

glm::vec4 colorAt(const StyledSurface& surface, std::size_t vertex)
{
    return surface.colors.empty() ? glm::vec4(0.0f) : surface.colors[vertex];
}

/// Triangles that are drawn at once.
struct SurfaceGroup
{
    int plane;           ///< that they share, by number
    std::uint32_t uncut; ///< uncutPlanes()

    auto operator<=>(const SurfaceGroup&) const = default;
};

/// The corners of the triangles that nothing shows through.
std::map<SurfaceGroup, std::vector<std::uint32_t>>
opaqueCorners(const StyledSurface& surface, std::size_t number, const SharedPlanes& planes)
{
    std::map<SurfaceGroup, std::vector<std::uint32_t>> corners;
    for (std::size_t first = 0; first + 2 < surface.triangles.size(); first += 3) {
        if (!surface.isOpaque(first)) continue;
        const SurfaceGroup group{planes.numberOf(number, first), uncutPlanes(surface, first)};
        std::vector<std::uint32_t>& ofGroup = corners[group];
        for (std::size_t i = first; i < first + 3; ++i)
            ofGroup.push_back(static_cast<std::uint32_t>(surface.triangles[i]));
    }
    return corners;
}

void useOpaqueProgram(const StyledScene& scene, const StyledSurface& surface, const SharedPlane* shared,
                      std::uint32_t uncut, ScenePrograms& programs)
{
    const glm::vec4 plane = shared ? windowPlane(shared->plane, scene.clipFromEye) : glm::vec4(0.0f);
    const SurfaceDepths depths = plane.w > 0.0f ? SurfaceDepths::ofPlane : SurfaceDepths::ofCorners;
    SceneProgram& program = useSurfaceProgram(scene, surface, {SurfacePart::whole, depths, uncut}, programs);
    if (plane.w > 0.0f) program.set("windowPlane", plane);
}

/// As programs compare depths: on the same side of a border here and there.
float inSinglePrecision(double depth)
{
    return static_cast<float>(depth);
}

template <class Vector>
void append(std::vector<float>& records, const Vector& values)
{
    for (int i = 0; i < Vector::length(); ++i)
        records.push_back(static_cast<float>(values[i]));
}

/// How much the depth of a plane changes at most from a pixel to the next one, near a point of it in eye
/// space.
double depthPerPixel(const glm::dvec3& normal, const glm::dvec3& eye, const StyledScene& scene,
                     const EyeRays& rays)
{
    const glm::dvec3 way = isPerspective(scene.clipFromEye) ? eye / -eye.z : rays.direction[0];
    const glm::dvec2 pixel(2.0 / scene.width, 2.0 / scene.height);
    const glm::dvec3 right = (rays.origin[1] - eye.z * rays.direction[1]) * pixel.x;
    const glm::dvec3 up = (rays.origin[2] - eye.z * rays.direction[2]) * pixel.y;
    return std::max(std::abs(glm::dot(normal, right)), std::abs(glm::dot(normal, up))) /
           std::abs(glm::dot(normal, way));
}

/// How far from a slab a triangle is drawn at least, so that every pixel of the slab is: corners are moved by
/// parts of a pixel, those of a cut as well, and pixels by an edge that two triangles share could be lost.
/// Triangles of few pixels are not cut.
double marginOf(const glm::dvec3& normal, const std::array<glm::dvec3, 3>& eye, const StyledScene& scene,
                const EyeRays& rays)
{
    constexpr double kPartOfPixel = 1.0 / 16.0, kFewPixels = 16.0;
    const auto [farthest, nearest] = std::minmax({eye[0].z, eye[1].z, eye[2].z});
    double change = 0.0;
    for (const glm::dvec3& corner : eye)
        change = std::max(change, depthPerPixel(normal, corner, scene, rays));
    const double reach = nearest - farthest;
    return (kFewPixels * change < reach ? kPartOfPixel * change : reach) + 1e-5 * std::abs(farthest);
}

} // namespace

void drawOpaqueSurfaces(const StyledScene& scene, const SharedPlanes& planes, SceneResources& resources,
                        SceneArrays& arrays)
{
    std::vector<float> records;
    for (std::size_t number = 0; number < scene.surfaces.size(); ++number) {
        const StyledSurface& surface = scene.surfaces[number];
        if (!isSound(surface)) continue;
        const auto corners = opaqueCorners(surface, number, planes);
        if (corners.empty()) continue;
        records.clear();
        for (std::size_t vertex = 0; vertex < surface.positions.size(); ++vertex) {
            append(records, surface.positions[vertex]);
            append(records, normalAt(surface, vertex));
            append(records, colorAt(surface, vertex));
        }
        arrays.send(records.data(), records.size());
        arrays.attribute(kSurfacePosition, 3, 0, kOpaqueValues);
        arrays.attribute(kSurfaceNormal, 3, 3, kOpaqueValues);
        arrays.attribute(kSurfaceColor, 4, 6, kOpaqueValues);
        for (const auto& [group, indices] : corners) {
            useOpaqueProgram(scene, surface, planes.find(group.plane), group.uncut, resources.programs);
            arrays.sendIndices(indices.data(), indices.size());
            resources.context.gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()),
                                              GL_UNSIGNED_INT, nullptr);
        }
    }
}

void TranslucentSurfaces::gather(const StyledSurface& surface, std::size_t number,
                                 std::vector<float>& records)
{
    const glm::dmat4 eyeFromLocal = scene_->eyeFromWorld * surface.worldFromLocal;
    const EyeRays rays = eyeRays(scene_->clipFromEye);
    for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3) {
        if (surface.isOpaque(i)) continue;
        std::array<glm::dvec3, 3> eye;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::size_t>(surface.triangles[i + corner]);
            eye[corner] = glm::dvec3(eyeFromLocal * glm::dvec4(glm::dvec3(surface.positions[vertex]), 1.0));
        }
        const auto [farthest, nearest] = std::minmax({eye[0].z, eye[1].z, eye[2].z});
        glm::dvec3 normal = glm::cross(eye[1] - eye[0], eye[2] - eye[0]);
        const double size = glm::length(normal);
        if (!(size > 0.0) || !std::isfinite(size)) continue;
        normal /= size;
        const double margin = marginOf(normal, eye, *scene_, rays);
        const SharedPlane* const shared = planes_->find(planes_->numberOf(number, i));
        const glm::dvec4 plane = shared ? shared->plane : glm::dvec4(normal, -glm::dot(normal, eye[0]));
        const glm::vec4 window = shared ? windowPlane(shared->plane, scene_->clipFromEye) : glm::vec4(0.0f);
        triangles_.push_back(
            {number, inSinglePrecision(-nearest), inSinglePrecision(-farthest),
             shared ? (shared->nearest + shared->farthest) / 2.0 : -(eye[0].z + eye[1].z + eye[2].z) / 3.0,
             uncutPlanes(surface, i)});
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::size_t>(surface.triangles[i + corner]);
            append(records, surface.positions[vertex]);
            append(records, normalAt(surface, vertex));
            append(records, colorAt(surface, vertex));
            append(records, plane);
            append(records, glm::dvec3(-nearest, -farthest, margin));
            append(records, window);
        }
    }
}

void TranslucentSurfaces::divide(std::vector<double>& depths)
{
    constexpr double kEnd = std::numeric_limits<double>::infinity();
    double nearest = kEnd, farthest = -kEnd;
    for (const Triangle& triangle : triangles_) {
        nearest = std::min(nearest, static_cast<double>(triangle.nearest));
        farthest = std::max(farthest, static_cast<double>(triangle.farthest));
    }
    depths.push_back(nearest);
    depths.push_back(farthest);
    std::ranges::sort(depths);
    const double most = (farthest - nearest) / kLeastSlabs;
    for (std::size_t i = depths.size() - 1; i-- > 0 && most > 0.0;) {
        const double from = std::max(depths[i], nearest), to = std::min(depths[i + 1], farthest);
        const auto parts = static_cast<int>(std::ceil((to - from) / most));
        for (int part = 1; part < parts; ++part)
            depths.push_back(to - part * most);
    }
    std::ranges::sort(depths);
    borders_ = {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
    std::ranges::transform(depths, std::back_inserter(borders_), inSinglePrecision);
    std::ranges::sort(borders_, std::greater<>());
    borders_.erase(std::unique(borders_.begin(), borders_.end()), borders_.end());
}

void TranslucentSurfaces::gatherParts()
{
    parts_.clear();
    for (std::size_t triangle = 0; triangle < triangles_.size(); ++triangle) {
        const float nearest = triangles_[triangle].nearest, farthest = triangles_[triangle].farthest;
        // The last border that is farther begins the slab.
        auto slab = static_cast<std::size_t>(std::ranges::lower_bound(borders_, farthest, std::greater<>()) -
                                             borders_.begin() - 1);
        for (; slab + 1 < borders_.size() && borders_[slab] > nearest; ++slab)
            parts_.push_back({slab, triangle});
    }
    std::ranges::sort(parts_, [this](const Part& a, const Part& b) {
        const Triangle &first = triangles_[a.triangle], &second = triangles_[b.triangle];
        // What comes first in the scene is drawn last.
        return std::tuple(a.slab, -first.middle, second.surface, b.triangle) <
               std::tuple(b.slab, -second.middle, first.surface, a.triangle);
    });
}

void TranslucentSurfaces::sendParts()
{
    std::vector<std::uint32_t> indices;
    indices.reserve(3 * parts_.size());
    for (const Part& part : parts_)
        for (std::size_t corner = 0; corner < 3; ++corner)
            indices.push_back(static_cast<std::uint32_t>(3 * part.triangle + corner));
    arrays_.sendIndices(indices.data(), indices.size());
}

void TranslucentSurfaces::gatherTriangles(std::vector<float>& records)
{
    triangles_.clear();
    for (std::size_t number = 0; number < scene_->surfaces.size(); ++number)
        if (const StyledSurface& surface = scene_->surfaces[number]; isSound(surface))
            gather(surface, number, records);
}

void TranslucentSurfaces::prepare(const StyledScene& scene, const SharedPlanes& planes,
                                  std::vector<double>& depths)
{
    scene_ = &scene;
    planes_ = &planes;
    next_ = 0;
    parts_.clear();
    std::vector<float> records;
    gatherTriangles(records);
    if (triangles_.empty()) return;
    divide(depths);
    gatherParts();
    sendTriangles(records);
    sendParts();
}

void TranslucentSurfaces::sendTriangles(const std::vector<float>& records)
{
    arrays_.send(records.data(), records.size());
    constexpr std::array<std::array<int, 2>, 6> kLayout{{{3, 0}, {3, 3}, {4, 6}, {4, 10}, {3, 14}, {4, 17}}};
    for (GLuint location = 0; location < kLayout.size(); ++location)
        arrays_.attribute(location, kLayout[location][0], kLayout[location][1], kTranslucentValues);
}

bool TranslucentSurfaces::prepareHits(const StyledScene& scene, const SharedPlanes& planes)
{
    scene_ = &scene;
    planes_ = &planes;
    next_ = 0;
    parts_.clear();
    std::vector<float> records;
    gatherTriangles(records);
    if (triangles_.empty()) return false;
    sendTriangles(records);
    return true;
}

SceneProgram& TranslucentSurfaces::useProgram(const Triangle& triangle, SurfacePart part) const
{
    const SurfaceDepths depths =
        planes_->anyOf(triangle.surface) ? SurfaceDepths::ofPlane : SurfaceDepths::ofCorners;
    return useSurfaceProgram(*scene_, scene_->surfaces[triangle.surface], {part, depths, triangle.uncut},
                             resources_.programs);
}

void TranslucentSurfaces::findHits(const RayHits& hits, const TranslucentTarget& target, std::size_t source)
{
    const GladGLContext& gl = resources_.context.gl;
    arrays_.bind();
    for (std::size_t first = 0; first < triangles_.size();) {
        std::size_t end = first;
        while (end < triangles_.size() && triangles_[end].isDrawnWith(triangles_[first]))
            ++end;
        SceneProgram& program = useProgram(triangles_[first], SurfacePart::hit);
        hits.bindReached(0, source, program);
        target.bindDepths(1);
        program.set("windowDepths", 1);
        program.set("firstTriangle", static_cast<int>(first));
        gl.DrawArrays(GL_TRIANGLES, static_cast<GLint>(3 * first), static_cast<GLsizei>(3 * (end - first)));
        first = end;
    }
}

bool TranslucentSurfaces::anyBehind(double depth) const
{
    return next_ < parts_.size() && borders_[parts_[next_].slab + 1] >= inSinglePrecision(depth);
}

/// All parts of the next slab, run by run of one surface.
void TranslucentSurfaces::drawSlab()
{
    const std::size_t slab = parts_[next_].slab;
    const float farthest = borders_[slab], nearest = borders_[slab + 1];
    const auto finite = [](float depth) { return std::clamp(depth, -1e30f, 1e30f); };
    while (next_ < parts_.size() && parts_[next_].slab == slab) {
        const std::size_t first = next_;
        const Triangle& triangle = triangles_[parts_[first].triangle];
        while (next_ < parts_.size() && parts_[next_].slab == slab &&
               triangles_[parts_[next_].triangle].isDrawnWith(triangle))
            ++next_;
        if (!used_ || !triangle.isDrawnWith(*used_)) program_ = &useProgram(triangle, SurfacePart::slab);
        used_ = &triangle;
        program_->set("slab", glm::vec2(finite(nearest), finite(farthest)));
        resources_.context.gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (next_ - first)),
                                           GL_UNSIGNED_INT,
                                           reinterpret_cast<const void*>(3 * first * sizeof(std::uint32_t)));
    }
}

bool TranslucentSurfaces::drawBehind(double depth)
{
    if (!anyBehind(depth)) return false;
    const GladGLContext& gl = resources_.context.gl;
    arrays_.bind();
    used_ = nullptr;
    gl.Enable(GL_CLIP_DISTANCE0);
    gl.Enable(GL_CLIP_DISTANCE1);
    while (anyBehind(depth))
        drawSlab();
    gl.Disable(GL_CLIP_DISTANCE0);
    gl.Disable(GL_CLIP_DISTANCE1);
    return true;
}

} // namespace vo
