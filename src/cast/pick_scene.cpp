#include "cast/pick_scene.h"

#include "cast/ray_projection.h"
#include "cast/scene_rays.h"
#include "style/stipple_points.h"
#include "style/styled_voxels.h"
#include "style/tetra_corners.h"
#include "style/uncut_planes.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace vo {

namespace {

constexpr double kMostSamples = 1 << 20;
constexpr float kLeastGradient = 1e-6f;
/// How many pixels a stipple may lie beside the place that is asked for.
constexpr double kStippleReach = 3.0;

/// Part of a ray inside of one cell of a volume: its box, or a tetrahedron.
struct CellSpan
{
    RayPart depths;
    DepthRay place;
    glm::dmat3 placeFromPosition{1.0}; ///< the linear part
    glm::vec3 normal{0.0f};            ///< of the face it enters through, outwards
};

/// Keeps the part of a ray with value + slope * depth not negative; notes the face where it begins there.
void cutAtFace(CellSpan& span, double value, double slope, const glm::dvec3& outwards)
{
    const double before = span.depths.begin;
    span.depths.cut(value, slope);
    if (span.depths.begin > before) span.normal = glm::vec3(glm::normalize(outwards));
}

/// The ray's plane distance as a number that is linear in depth.
void cutAtPlane(CellSpan& span, const DepthRay& ray, const glm::dvec4& plane)
{
    const glm::dvec3 normal(plane);
    cutAtFace(span, glm::dot(normal, ray.origin) + plane.w, glm::dot(normal, ray.direction), -normal);
}

CellSpan boxSpan(const StyledVolume& volume, const DepthRay& local, RayPart depths)
{
    const glm::dvec3 size(volume.dimensions);
    CellSpan span{depths, {local.origin / size + 0.5, local.direction / size}, glm::dmat3(1.0), {}};
    for (int axis = 0; axis < 3; ++axis) {
        span.placeFromPosition[axis] /= size[axis];
        glm::dvec4 plane(0.0, 0.0, 0.0, size[axis] / 2);
        plane[axis] = 1;
        cutAtPlane(span, local, plane);
        plane[axis] = -1;
        cutAtPlane(span, local, plane);
    }
    return span;
}

/// Nothing for tetrahedra that are flat or name corners that are not there.
std::optional<CellSpan> tetraSpan(const StyledTetras& tetras, std::size_t tetra, const DepthRay& local,
                                  RayPart depths)
{
    const std::optional<TetraCorners> corners = cornersOf(tetras, tetra);
    const std::optional<glm::dmat4> place = corners ? corners->placeFromLocal() : std::nullopt;
    if (!place) return {};
    CellSpan span{depths, transformed(*place, local), glm::dmat3(*place), {}};
    const glm::dvec3& first = corners->positions[0];
    const glm::dmat3 parts = glm::inverse(corners->edges());
    const glm::dmat3 rows = glm::transpose(parts);
    const glm::dvec3 sum = rows[0] + rows[1] + rows[2];
    for (int face = 0; face < 4; ++face) {
        const glm::dvec3 normal = face < 3 ? rows[face] : -sum;
        const double rest = face < 3 ? 0.0 : 1.0;
        cutAtPlane(span, local, {normal, rest - glm::dot(normal, first)});
    }
    return span;
}

/// What the ray crosses of a volume, the nearest first.
std::vector<CellSpan> spansOf(const StyledVolume& volume, const DepthRay& world, const DepthRay& local,
                              RayPart depths)
{
    std::vector<CellSpan> spans;
    const auto add = [&](CellSpan span) {
        const glm::dmat3 localFromWorld = glm::inverse(glm::dmat3(volume.worldFromLocal));
        for (const glm::dvec4& plane : volume.clipPlanes) {
            const RayPart before = span.depths;
            span.depths.cut(glm::dot(glm::dvec3(plane), world.origin) + plane.w,
                            glm::dot(glm::dvec3(plane), world.direction));
            if (span.depths.begin > before.begin)
                span.normal = glm::vec3(glm::normalize(localFromWorld * -glm::dvec3(plane)));
        }
        if (!span.depths.empty()) spans.push_back(span);
    };
    if (!volume.tetras) {
        add(boxSpan(volume, local, depths));
        return spans;
    }
    for (std::size_t tetra = 0; 4 * tetra + 3 < volume.tetras->indices.size(); ++tetra)
        if (const auto span = tetraSpan(*volume.tetras, tetra, local, depths)) add(*span);
    std::ranges::sort(spans, {}, [](const CellSpan& span) { return span.depths.begin; });
    return spans;
}

/// Samples one volume at single places.
class VolumeProbe
{
public:
    VolumeProbe(const StyledVolume& volume, const DepthRay& local)
        : volume_(volume), local_(local), view_(glm::normalize(-local.direction))
    {
    }

    /// Sets the sample at a depth, its normal too.
    void sample(const CellSpan& span, double depth)
    {
        const glm::dvec3 place = span.place.at(depth), position = local_.at(depth);
        const VoxelSize& size = volume_.voxels->size;
        const glm::dvec3 counts(size.x, size.y, size.z);
        batch_.count = 7;
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            batch_.place[a].fill(static_cast<float>(place[axis]));
            batch_.place[a][std::size_t(1 + 2 * axis)] += static_cast<float>(1 / counts[axis]);
            batch_.place[a][std::size_t(2 + 2 * axis)] -= static_cast<float>(1 / counts[axis]);
            batch_.position[a].fill(static_cast<float>(position[axis]));
            batch_.V[a].fill(static_cast<float>(view_[axis]));
        }
        sampleTexture(*volume_.voxels, batch_.count, batch_.place, batch_.voxel);
        glm::dvec3 change;
        for (int axis = 0; axis < 3; ++axis)
            change[axis] =
                double(brightness(std::size_t(1 + 2 * axis)) - brightness(std::size_t(2 + 2 * axis))) / 2;
        setNormal(glm::transpose(span.placeFromPosition) * (change * counts) * volume_.unitLength);
        batch_.count = 1;
    }

    float value() const { return batch_.voxel[0][0]; }
    float gradient() const { return batch_.gradient[0]; }
    glm::vec3 normal() const { return {batch_.n[0][0], batch_.n[1][0], batch_.n[2][0]}; }

    /// Of the sample, after the styles of its segment.
    float opacity()
    {
        const int chain = chainHere();
        if (chain < 0) return 0;
        firstColor(volume_.voxels->components, batch_);
        for (const auto& style : volume_.chains[static_cast<std::size_t>(chain)])
            style->apply(volume_.surroundings, batch_);
        return batch_.Ov[0];
    }

    /// The same for a projection, which looks at intensity() as well; nothing where no segment is drawn.
    std::optional<float> projectedOpacity()
    {
        const float styled = opacity();
        const int chain = chainHere();
        if (chain < 0) return {};
        if (!volume_.chains[static_cast<std::size_t>(chain)].empty()) return styled;
        const int components = volume_.voxels->components;
        return components % 2 != 0 ? 1.0f : batch_.voxel[static_cast<std::size_t>(components) - 1][0];
    }
    float intensity() const { return (batch_.Cv[0][0] + batch_.Cv[1][0] + batch_.Cv[2][0]) / 3; }

private:
    int chainHere() const
    {
        return chainAt(volume_, {batch_.place[0][0], batch_.place[1][0], batch_.place[2][0]});
    }

    float brightness(std::size_t i) const
    {
        if (volume_.voxels->components < 3) return batch_.voxel[0][i];
        return (batch_.voxel[0][i] + batch_.voxel[1][i] + batch_.voxel[2][i]) / 3;
    }

    void setNormal(const glm::dvec3& change)
    {
        const double length = glm::length(change);
        batch_.gradient[0] = static_cast<float>(length);
        for (int axis = 0; axis < 3; ++axis)
            batch_.n[std::size_t(axis)][0] =
                length < double(kLeastGradient) ? 0.0f : static_cast<float>(-change[axis] / length);
    }

    const StyledVolume& volume_;
    const DepthRay& local_;
    glm::dvec3 view_;
    SampleBatch batch_{};
};

/// Looks for the nearest thing on one ray.
class ScenePicker
{
public:
    ScenePicker(const SceneRays& rays, double x, double y)
        : eyeDepths_(rays.depths()), world_(transformed(rays.worldFromEye(), rays.ray(x, y))), pixel_(x, y),
          front_(eyeDepths_.end), opaque_(eyeDepths_.end)
    {
    }

    void look(const StyledSurface& surface)
    {
        if (!isSound(surface)) return;
        const DepthRay local = transformed(glm::inverse(surface.worldFromLocal), world_);
        for (std::size_t i = 0; i + 2 < surface.triangles.size(); i += 3)
            lookAtTriangle(surface, local, i);
    }

    /// After all surfaces.
    void look(const StyledScene& scene, const StyledVolume& volume, float threshold)
    {
        if (!isSound(volume)) return;
        const DepthRay local = transformed(glm::inverse(volume.worldFromLocal), world_);
        if (threshold >= 0 && volume.stipple) {
            lookForStipple(scene, volume, threshold);
            return;
        }
        const bool isProjected = threshold >= 0 && volume.projection && !volume.surfaces;
        const auto spans = spansOf(volume, world_, local, {eyeDepths_.begin, isProjected ? opaque_ : front_});
        if (spans.empty()) return;
        if (threshold < 0) {
            take(SceneHit::Kind::bounds, volume, local, spans.front(), spans.front().depths.begin,
                 spans.front().normal, 1);
            return;
        }
        VolumeProbe probe(volume, local);
        if (isProjected) {
            lookForProjected(volume, local, spans, probe, threshold);
            return;
        }
        for (const CellSpan& span : spans)
            if (volume.surfaces ? lookForSurface(volume, local, span, probe)
                                : lookForVoxel(volume, local, span, probe, threshold))
                return;
    }

    SceneHit hit() const { return hit_.kind == SceneHit::Kind::nothing ? SceneHit() : hit_; }

private:
    void take(SceneHit::Kind kind, const StyledVolume& volume, const DepthRay& local, const CellSpan& span,
              double depth, const glm::vec3& normal, float opacity)
    {
        hit_ = {kind,    volume.id, world_.at(depth), local.at(depth), span.place.at(depth), normal,
                opacity, depth};
        front_ = depth;
    }

    /// The sample that the projection shows.
    void lookForProjected(const StyledVolume& volume, const DepthRay& local,
                          const std::vector<CellSpan>& spans, VolumeProbe& probe, float threshold)
    {
        JoinedSamples joined(*volume.projection);
        for (const CellSpan& span : spans) {
            const double first = std::ceil(span.depths.begin / volume.spacing - 0.5);
            const double last = std::floor(span.depths.end / volume.spacing - 0.5);
            for (double k = first; k <= last && k - first < kMostSamples && !joined.decided(); ++k) {
                probe.sample(span, sampleDepth(volume.spacing, k));
                const auto opacity = probe.projectedOpacity();
                if (opacity) joined.add(sampleDepth(volume.spacing, k), probe.intensity(), *opacity);
            }
        }
        if (joined.empty()) return;
        const double standing = standingDepth(volume, spans.front().depths.begin, joined);
        if (!(standing < front_) || !(joined.opacity() > threshold)) return;
        const double depth = joined.chosenDepth();
        const auto span = std::ranges::find_if(spans, [depth](const CellSpan& each) {
            return each.depths.begin <= depth && depth <= each.depths.end;
        });
        if (span == spans.end()) return;
        probe.sample(*span, depth);
        take(SceneHit::Kind::voxel, volume, local, *span, depth, probe.normal(), joined.opacity());
        front_ = standing;
    }

    /// The point of the pixel, or the nearest one beside it.
    void lookForStipple(const StyledScene& scene, const StyledVolume& volume, float threshold)
    {
        if (!(threshold < 1)) return;
        const glm::dmat4 eyeFromLocal = scene.eyeFromWorld * volume.worldFromLocal;
        const glm::dvec2 size(scene.width, scene.height);
        std::optional<glm::dvec3> found;
        double way = kStippleReach * kStippleReach, nearest = front_;
        for (const StipplePoint& point : stipplePoints(scene, volume, 0)) {
            const glm::dvec4 eye = eyeFromLocal * glm::dvec4(glm::dvec3(point.position), 1.0);
            const glm::dvec4 clip = scene.clipFromEye * eye;
            if (!(clip.w > 0) || !(-eye.z >= eyeDepths_.begin && -eye.z < front_)) continue;
            const glm::dvec2 off =
                glm::floor((0.5 * glm::dvec2(clip) / clip.w + 0.5) * size) - glm::floor(pixel_);
            const double square = glm::dot(off, off);
            if (square > way || (square == way && -eye.z >= nearest)) continue;
            way = square;
            nearest = -eye.z;
            found = glm::dvec3(point.position);
        }
        if (found) takeStipple(volume, *found, nearest);
    }

    void takeStipple(const StyledVolume& volume, const glm::dvec3& position, double depth)
    {
        const glm::dvec3 world(volume.worldFromLocal * glm::dvec4(position, 1.0));
        const DepthRay local = transformed(glm::inverse(volume.worldFromLocal),
                                           {world - world_.direction * depth, world_.direction});
        const CellSpan span = boxSpan(volume, local, {depth, depth});
        VolumeProbe probe(volume, local);
        probe.sample(span, depth);
        take(SceneHit::Kind::voxel, volume, local, span, depth, probe.normal(), 1);
        hit_.world = world;
    }

    bool lookForVoxel(const StyledVolume& volume, const DepthRay& local, const CellSpan& span,
                      VolumeProbe& probe, float threshold)
    {
        const double first = std::ceil(span.depths.begin / volume.spacing - 0.5);
        const double last = std::floor(span.depths.end / volume.spacing - 0.5);
        for (double k = first; k <= last && k - first < kMostSamples; ++k) {
            const double depth = sampleDepth(volume.spacing, k);
            probe.sample(span, depth);
            const float opacity = probe.opacity();
            if (!(opacity > threshold)) continue;
            take(SceneHit::Kind::voxel, volume, local, span, depth, probe.normal(), opacity);
            return true;
        }
        return false;
    }

    /// Where the value goes through one of the surfaces' on its way from sample to sample.
    bool lookForSurface(const StyledVolume& volume, const DepthRay& local, const CellSpan& span,
                        VolumeProbe& probe)
    {
        const double count =
            std::min(std::ceil((span.depths.end - span.depths.begin) / volume.spacing), kMostSamples);
        const double step = (span.depths.end - span.depths.begin) / std::max(count, 1.0);
        probe.sample(span, span.depths.begin);
        for (double k = 1; k <= count; ++k) {
            const double before = span.depths.begin + (k - 1) * step;
            const float from = probe.value();
            probe.sample(span, before + step);
            const float to = probe.value();
            if (!crossed(*volume.surfaces, from, to)) continue;
            const double depth =
                before + step * double((*crossed(*volume.surfaces, from, to) - from) / (to - from));
            probe.sample(span, depth);
            if (probe.gradient() >= volume.surfaces->surfaceTolerance) {
                const bool faces = glm::dot(glm::dvec3(probe.normal()), local.direction) <= 0;
                take(SceneHit::Kind::surface, volume, local, span, depth,
                     faces ? probe.normal() : -probe.normal(), 1);
                return true;
            }
            probe.sample(span, before + step);
        }
        return false;
    }

    /// The value that is met first on the way.
    static std::optional<float> crossed(const IsoSurfaces& surfaces, float from, float to)
    {
        std::optional<float> first;
        for (const float value : surfaces.values) {
            if ((from < value) == (to < value)) continue;
            if (!first || std::abs(value - from) < std::abs(*first - from)) first = value;
        }
        return first;
    }

    void lookAtTriangle(const StyledSurface& surface, const DepthRay& local, std::size_t first)
    {
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(surface.positions[static_cast<std::size_t>(surface.triangles[first + i])]);
        };
        const glm::dvec3 a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
        const glm::dvec3 normal = glm::cross(ab, ac);
        const double against = -glm::dot(local.direction, normal);
        if (against == 0 || (surface.solid && against < 0)) return;
        const glm::dvec3 from = local.origin - a;
        const double depth = glm::dot(from, normal) / against;
        if (!(depth >= eyeDepths_.begin && depth < eyeDepths_.end)) return;
        const glm::dvec3 turn = glm::cross(from, local.direction);
        const double u = glm::dot(ac, turn) / against, v = -glm::dot(ab, turn) / against;
        if (u < 0 || v < 0 || u + v > 1) return;
        const glm::dvec3 world = world_.at(depth);
        const std::uint32_t uncut = uncutPlanes(surface, first);
        for (std::size_t i = 0; i < surface.clipPlanes.size(); ++i)
            if (!isUncut(uncut, i) && glm::dot(surface.clipPlanes[i], glm::dvec4(world, 1.0)) < 0) return;
        // Of one depth what is opaque is seen, else the first.
        const double same = 4e-7 * std::abs(depth);
        const bool isSeenFirst = surface.isOpaque(first) && !(opaque_ <= depth + same);
        if (surface.isOpaque(first)) opaque_ = std::min(opaque_, depth);
        if (!(depth < front_ + (isSeenFirst ? same : -same))) return;
        front_ = depth;
        const glm::dvec3 unit = glm::normalize(against > 0 ? normal : -normal);
        hit_ = {SceneHit::Kind::surface, surface.id, world, local.at(depth), {}, glm::vec3(unit), 1, depth};
    }

    RayPart eyeDepths_;
    DepthRay world_;
    glm::dvec2 pixel_;
    double front_;  ///< where what is hit stands: hides what is behind
    double opaque_; ///< of the nearest opaque surface
    SceneHit hit_;
};

} // namespace

SceneHit pickScene(const StyledScene& scene, double x, double y, float threshold)
{
    const auto rays = SceneRays::of(scene);
    if (!rays) return {};
    ScenePicker picker(*rays, x, y);
    for (const StyledSurface& surface : scene.surfaces)
        picker.look(surface);
    for (const StyledVolume& volume : scene.volumes)
        picker.look(scene, volume, threshold);
    return picker.hit();
}

} // namespace vo
