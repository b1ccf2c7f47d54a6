#include "support/reference.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <thread>

namespace vo::test {

namespace {

/// Coordinates this close to a plane of the clip box lie on it (voxels).
constexpr double kSnap = 1e-5;
/// Rasterisers move vertices to a grid of 1/256 pixel.
constexpr double kMaskPixels = 1.0 / 200.0;

using Rgba = std::array<double, 4>;

struct Region
{
    glm::dvec3 lower;
    glm::dvec3 upper;
};

struct HalfSpace
{
    glm::dvec3 inward;
    double offset; ///< inside: dot(inward, p) >= offset
};

/// A convex part of the geometry.
using Solid = std::vector<HalfSpace>;

glm::dvec3 volumeExtent(const Scene& scene)
{
    return {scene.volume->size.x, scene.volume->size.y, scene.volume->size.z};
}

Region visibleRegion(const Scene& scene)
{
    const glm::dvec3 extent = volumeExtent(scene);
    glm::dvec3 margin(0.5 * scene.overlap);
    for (int axis = 0; axis < 3; ++axis) {
        margin[axis] = std::min(margin[axis], 0.5 * (extent[axis] - 1.0));
        if (axis == scene.stackAxis) margin[axis] = 0.0;
    }
    return {margin, extent - margin};
}

std::vector<glm::dvec3> geometryCorners(const Scene& scene)
{
    std::vector<glm::dvec3> corners;
    for (const Tetrahedron& tetrahedron : scene.geometry)
        corners.insert(corners.end(), tetrahedron.begin(), tetrahedron.end());
    if (!corners.empty()) return corners;
    const glm::dvec3 extent = volumeExtent(scene);
    for (int i = 0; i < 8; ++i)
        corners.push_back(extent * glm::dvec3(i & 1, i >> 1 & 1, i >> 2 & 1));
    return corners;
}

// ---- The viewer

/// From the near to the far plane.
struct Ray
{
    glm::dvec3 start;
    glm::dvec3 end;
};

class Screen
{
public:
    explicit Screen(const Scene& scene)
        : width_(scene.width), height_(scene.height), model_(glm::make_mat4(scene.view.model.data())),
          toClip_(glm::make_mat4(scene.view.projection.data()) * model_), fromClip_(glm::inverse(toClip_))
    {
    }

    glm::dvec4 clipCoordinates(const glm::dvec3& p) const { return toClip_ * glm::dvec4(p, 1.0); }

    /// Window coordinates in pixels; pixel (i, j) has its centre at (i + 0.5, j + 0.5).
    glm::dvec2 window(const glm::dvec4& clip) const
    {
        return {(clip.x / clip.w + 1.0) * 0.5 * width_, (clip.y / clip.w + 1.0) * 0.5 * height_};
    }

    Ray rayThrough(const glm::dvec2& pixel) const
    {
        return deviceRay(2.0 * pixel.x / width_ - 1.0, 2.0 * pixel.y / height_ - 1.0);
    }

    Ray middleRay() const { return deviceRay(0.0, 0.0); }

    Ray rayTo(const glm::dvec3& p) const
    {
        const glm::dvec4 clip = clipCoordinates(p);
        return deviceRay(clip.x / clip.w, clip.y / clip.w);
    }

    /// Of a perspective view: where all lines of sight meet.
    glm::dvec3 eye() const
    {
        const glm::dvec4 meeting = fromClip_[2];
        assert(meeting.w != 0.0);
        return glm::dvec3(meeting) / meeting.w;
    }

    /// Normal of the planes of constant eye z, away from the viewer. What single precision leaves of a
    /// quarter turn is no tilt.
    glm::dvec3 depthNormal() const
    {
        std::array<double, 3> turned;
        for (int axis = 0; axis < 3; ++axis)
            turned[static_cast<std::size_t>(axis)] =
                std::abs(model_[axis][2]) / glm::length(glm::dvec3(model_[axis]));
        const double largest = *std::ranges::max_element(turned);
        glm::dvec3 normal(0.0);
        for (int axis = 0; axis < 3; ++axis)
            if (turned[static_cast<std::size_t>(axis)] >= 1e-6 * largest) normal[axis] = -model_[axis][2];
        return normal;
    }

private:
    Ray deviceRay(double x, double y) const
    {
        const glm::dvec4 start = fromClip_ * glm::dvec4(x, y, -1.0, 1.0);
        const glm::dvec4 end = fromClip_ * glm::dvec4(x, y, 1.0, 1.0);
        return {glm::dvec3(start) / start.w, glm::dvec3(end) / end.w};
    }

    double width_;
    double height_;
    glm::dmat4 model_;
    glm::dmat4 toClip_;
    glm::dmat4 fromClip_;
};

glm::dvec3 directionOf(const Ray& ray)
{
    return glm::normalize(ray.end - ray.start);
}

// ---- Where the planes lie

/// The axis that planes of a scene are across: that of its stack, else the one most along the view, the later
/// of equals.
int majorAxis(const Scene& scene, const glm::dvec3& direction)
{
    if (scene.stackAxis >= 0) return scene.stackAxis;
    int best = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(direction[axis]) >= std::abs(direction[best]) - 1e-9) best = axis;
    return best;
}

struct PlaneDirection
{
    glm::dvec3 normal; ///< dot(normal, p) is the length along the line of sight
    double step;       ///< asked for; 0 without a period
};

PlaneDirection planeDirection(const Scene& scene, const Screen& screen, const glm::dvec3& boxCentre)
{
    if (scene.planes == SamplingPlanes::axisAligned) {
        const glm::dvec3 middle = directionOf(screen.middleRay());
        const int axis = majorAxis(scene, middle);
        glm::dvec3 normal(0.0);
        normal[axis] = middle[axis] < 0.0 ? -1.0 : 1.0;
        return {normal, scene.period ? (*scene.period)[axis] : 0.0};
    }
    const glm::dvec3 direction = directionOf(screen.rayTo(boxCentre));
    const glm::dvec3 normal = screen.depthNormal();
    const double step = scene.period ? 1.0 / glm::length(direction / *scene.period) : 0.0;
    return {normal / glm::dot(normal, direction), step};
}

struct Extent
{
    double near;
    double far;
};

Extent extentAlong(const glm::dvec3& normal, const std::vector<glm::dvec3>& corners)
{
    Extent extent{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const glm::dvec3& corner : corners) {
        extent.near = std::min(extent.near, glm::dot(normal, corner));
        extent.far = std::max(extent.far, glm::dot(normal, corner));
    }
    return extent;
}

std::vector<double> spreadOffsets(const Extent& extent, double step, int maxSamples)
{
    const double length = extent.far - extent.near;
    double count = maxSamples;
    if (step > 0.0) {
        const double steps = length / step, forgiven = 1e-6 * std::max(1.0, steps);
        count = std::clamp(std::ceil(steps - forgiven), 1.0, static_cast<double>(maxSamples));
    }
    const double spacing = length / count;
    std::vector<double> offsets;
    for (int k = 0; k < count; ++k)
        offsets.push_back(extent.far - (k + 0.5) * spacing);
    return offsets;
}

/// Positions 1/2 + m * step on the stack's axis, as offsets along a normal that points up or down that axis.
/// What lies on a plane counts as behind it, seen from the viewer: the nearest end of the geometry is not
/// cut, the farthest is.
std::vector<double> stackOffsets(const Extent& extent, double step, double sign)
{
    const double low = sign > 0.0 ? extent.near : -extent.far;
    const double high = sign > 0.0 ? extent.far : -extent.near;
    std::vector<double> offsets;
    for (double m = std::ceil((low - 0.5) / step - 1e-6); 0.5 + m * step <= high + 1e-6 * step; ++m)
        if (const double offset = sign * (0.5 + m * step); offset > extent.near + 1e-6 * step)
            offsets.push_back(offset);
    std::sort(offsets.rbegin(), offsets.rend());
    return offsets;
}

// ---- Samples

/// Linear between the two voxels around `place` (index coordinates, 0 is the first voxel's centre), clamped
/// at the edge.
struct Neighbours
{
    std::size_t below;
    std::size_t above;
    double weight; ///< of the one above
};

Neighbours neighbours(double place, int size)
{
    const double last = size - 1;
    const double inside = std::clamp(place, 0.0, last);
    const double below = std::floor(inside);
    return {static_cast<std::size_t>(below), static_cast<std::size_t>(std::min(below + 1.0, last)),
            inside - below};
}

class Sampler
{
public:
    explicit Sampler(const Scene& scene) : scene_(scene), field_(*scene.volume)
    {
        assert(scene.classification == Classification::none || scene.table.size() >= 4);
        if (scene.classification == Classification::preInterpolation) classifyVoxels();
    }

    Rgba operator()(const glm::dvec3& point) const
    {
        const Field& field = classified_.values.empty() ? field_ : classified_;
        Rgba stored{};
        interpolate(field, point, stored);
        Rgba sample = expanded(stored, field.channels);
        if (scene_.classification == Classification::postInterpolation) lookUp(sample);
        return sample;
    }

private:
    void interpolate(const Field& field, const glm::dvec3& point, Rgba& sum) const
    {
        std::array<Neighbours, 3> around;
        for (int axis = 0; axis < 3; ++axis) {
            const double place = axis == scene_.stackAxis ? std::floor(point[axis]) : point[axis] - 0.5;
            around[static_cast<std::size_t>(axis)] = neighbours(place, field.size[axis]);
        }
        const auto channels = static_cast<std::size_t>(field.channels);
        const std::size_t rowLength = static_cast<std::size_t>(field.size.x) * channels;
        const std::size_t sliceLength = static_cast<std::size_t>(field.size.y) * rowLength;
        for (unsigned corner = 0; corner < 8; ++corner) {
            const bool x = corner & 1u;
            const bool y = corner & 2u;
            const bool z = corner & 4u;
            const double weight = (x ? around[0].weight : 1.0 - around[0].weight) *
                                  (y ? around[1].weight : 1.0 - around[1].weight) *
                                  (z ? around[2].weight : 1.0 - around[2].weight);
            const float* voxel = field.values.data() + (x ? around[0].above : around[0].below) * channels +
                                 (y ? around[1].above : around[1].below) * rowLength +
                                 (z ? around[2].above : around[2].below) * sliceLength;
            for (std::size_t c = 0; c < channels; ++c)
                sum[c] += weight * static_cast<double>(voxel[c]);
        }
    }

    Rgba expanded(const Rgba& stored, int channels) const
    {
        Rgba rgba = stored;
        if (channels == 1) rgba = {stored[0], stored[0], stored[0], stored[0]};
        if (channels == 2) rgba = {stored[0], stored[0], stored[0], stored[1]};
        if (scene_.opaqueTexture && scene_.classification != Classification::preInterpolation) rgba[3] = 1.0;
        return rgba;
    }

    void lookUp(Rgba& rgba) const
    {
        const std::size_t last = scene_.table.size() / 4 - 1;
        for (std::size_t c = 0; c < 4; ++c) {
            const double place = std::clamp(rgba[c], 0.0, 1.0) * static_cast<double>(last);
            const auto below = static_cast<std::size_t>(place);
            const std::size_t above = std::min(below + 1, last);
            const double weight = place - static_cast<double>(below);
            rgba[c] = (1.0 - weight) * static_cast<double>(scene_.table[4 * below + c]) +
                      weight * static_cast<double>(scene_.table[4 * above + c]);
        }
    }

    void classifyVoxels()
    {
        const auto channels = static_cast<std::size_t>(field_.channels);
        Field result;
        result.size = field_.size;
        result.channels = 4;
        result.values.reserve(field_.values.size() / channels * 4);
        for (std::size_t i = 0; i < field_.values.size(); i += channels) {
            Rgba stored{};
            std::copy_n(field_.values.begin() + static_cast<std::ptrdiff_t>(i), channels, stored.begin());
            Rgba rgba = expanded(stored, field_.channels);
            lookUp(rgba);
            for (const double value : rgba)
                result.values.push_back(static_cast<float>(value));
        }
        classified_ = std::move(result);
    }

    const Scene& scene_;
    const Field& field_;
    Field classified_; ///< empty unless voxels are looked up before interpolation
};

// ---- What is drawn

Solid solidOf(const Tetrahedron& corners)
{
    Solid solid;
    for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3& a = corners[(i + 1) % 4];
        const glm::dvec3 across = glm::cross(corners[(i + 2) % 4] - a, corners[(i + 3) % 4] - a);
        if (glm::length(across) == 0.0) return {};
        glm::dvec3 inward = glm::normalize(across);
        if (glm::dot(inward, corners[i] - a) < 0.0) inward = -inward;
        solid.push_back({inward, glm::dot(inward, a)});
    }
    return solid;
}

Solid solidOf(const Region& region)
{
    Solid solid;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 inward(0.0);
        inward[axis] = 1.0;
        solid.push_back({inward, region.lower[axis] - kSnap});
        solid.push_back({-inward, -region.upper[axis] - kSnap});
    }
    return solid;
}

bool contains(const Solid& solid, const glm::dvec3& point, double slack)
{
    return std::all_of(solid.begin(), solid.end(),
                       [&](const HalfSpace& h) { return glm::dot(h.inward, point) >= h.offset - slack; });
}

/// Adds fragments, the farthest first, to one pixel.
class Pixel
{
public:
    explicit Pixel(const Scene& scene) : mode_(scene.compositing)
    {
        std::copy(scene.background.begin(), scene.background.end(), value_.begin());
    }

    void add(const Rgba& fragment)
    {
        const double alpha = fragment[3];
        for (std::size_t c = 0; c < 3; ++c)
            value_[c] = hides() ? value_[c] * (1.0 - alpha) +
                                      (mode_ == Compositing::over ? fragment[c] * alpha : fragment[c])
                                : combine(value_[c], fragment[c]);
        if (hides())
            value_[3] = 1.0 - (1.0 - value_[3]) * (1.0 - alpha);
        else
            value_[3] = drawn_ ? combine(value_[3], alpha) : alpha;
        drawn_ = true;
    }

    const Rgba& value() const { return value_; }

private:
    bool hides() const { return mode_ == Compositing::over || mode_ == Compositing::premultiplied; }

    double combine(double destination, double source) const
    {
        if (mode_ == Compositing::max) return std::max(destination, source);
        if (mode_ == Compositing::min) return std::min(destination, source);
        return destination + source;
    }

    Compositing mode_;
    bool drawn_ = false;
    Rgba value_{0.0, 0.0, 0.0, 0.0};
};

class Renderer
{
public:
    explicit Renderer(const Scene& scene)
        : scene_(scene), screen_(scene), sampler_(scene),
          region_(scene.sampleAt ? Solid{} : solidOf(visibleRegion(scene)))
    {
        if (scene.planes == SamplingPlanes::spherical)
            shells_ = referenceShells(scene);
        else
            planes_ = referencePlanes(scene);
        const glm::dvec3 extent = volumeExtent(scene);
        slack_ = 1e-9 * std::max({extent.x, extent.y, extent.z});
        for (int axis = 0; scene.planes == SamplingPlanes::axisAligned && axis < 3; ++axis)
            if (planes_.normal[axis] != 0.0) axis_ = axis;
        for (const Tetrahedron& tetrahedron : scene.geometry)
            if (Solid solid = solidOf(tetrahedron); !solid.empty()) parts_.push_back(std::move(solid));
    }

    Rgba pixelAt(int x, int y) const
    {
        if (scene_.planes == SamplingPlanes::spherical) return pixelOnShells(x, y);
        const Ray ray = screen_.rayThrough({x + 0.5, y + 0.5});
        const glm::dvec3 along = ray.end - ray.start;
        const double slope = glm::dot(planes_.normal, along);
        const double start = glm::dot(planes_.normal, ray.start);
        Pixel pixel(scene_);
        for (const double offset : planes_.offsets) {
            const double place = (offset - start) / slope;
            if (!(place >= 0.0 && place <= 1.0)) continue; // not between the near and the far plane
            glm::dvec3 point = ray.start + place * along;
            if (axis_ >= 0)
                point[axis_] = offset / planes_.normal[axis_]; // or rounding decides between slices
            if (const std::optional<Rgba> fragment = fragmentAt(point)) pixel.add(*fragment);
        }
        return pixel.value();
    }

    /// False where a sample of the pixel's ray is about to enter or leave what is drawn.
    bool isFarFromEdges(int x, int y) const
    {
        constexpr double kShellError = 1.0 / 48.0;
        const glm::dvec2 centre(x + 0.5, y + 0.5);
        const Ray ray = screen_.rayThrough(centre);
        for (const double radius : shells_.radii) {
            const auto drawn = [&](const Ray& line, double r) {
                const std::optional<glm::dvec3> point = onShell(line, r);
                return point && isDrawn(*point);
            };
            const bool here = drawn(ray, radius);
            for (const double side : {-1.0, 1.0}) {
                if (drawn(ray, radius + side * kShellError * shells_.spacing) != here) return false;
                for (const glm::dvec2& aside : {glm::dvec2(side, 0.0), glm::dvec2(0.0, side)})
                    if (drawn(screen_.rayThrough(centre + kMaskPixels * aside), radius) != here) return false;
            }
        }
        return true;
    }

    const Screen& screen() const { return screen_; }
    const ReferencePlanes& planes() const { return planes_; }
    const Solid& region() const { return region_; }
    const std::vector<Solid>& parts() const { return parts_; }

private:
    /// Nothing where the line of sight has ended, or not begun.
    std::optional<glm::dvec3> onShell(const Ray& ray, double radius) const
    {
        const glm::dvec3 direction = directionOf(ray);
        const glm::dvec3 point = shells_.eye + direction * (radius / glm::length(direction / shells_.scale));
        const double place = glm::dot(direction, point - ray.start);
        if (!(place >= 0.0 && place <= glm::length(ray.end - ray.start))) return std::nullopt;
        return point;
    }

    Rgba pixelOnShells(int x, int y) const
    {
        const Ray ray = screen_.rayThrough({x + 0.5, y + 0.5});
        Pixel pixel(scene_);
        for (const double radius : shells_.radii) {
            const std::optional<glm::dvec3> point = onShell(ray, radius);
            if (!point) continue;
            if (const std::optional<Rgba> fragment = fragmentAt(*point)) pixel.add(*fragment);
        }
        return pixel.value();
    }

    /// Nothing where nothing is drawn.
    std::optional<Rgba> fragmentAt(const glm::dvec3& point) const
    {
        std::optional<Rgba> fragment;
        if (scene_.sampleAt)
            fragment = scene_.sampleAt(point);
        else if (isDrawn(point))
            fragment = sampler_(point);
        for (std::size_t c = 0; fragment && c < 4; ++c)
            (*fragment)[c] *= scene_.color[c];
        return fragment;
    }

    bool isDrawn(const glm::dvec3& point) const
    {
        if (!contains(region_, point, 0.0)) return false;
        if (scene_.geometry.empty()) return true;
        return std::any_of(parts_.begin(), parts_.end(),
                           [&](const Solid& part) { return contains(part, point, slack_); });
    }

    const Scene& scene_;
    Screen screen_;
    ReferencePlanes planes_;
    ReferenceShells shells_;
    Sampler sampler_;
    Solid region_;
    std::vector<Solid> parts_; ///< of the geometry, when the scene gives one
    int axis_ = -1;            ///< that axis-aligned planes are across
    double slack_;
};

// ---- The mask

template <class Point, class Distance>
std::vector<Point> clipped(const std::vector<Point>& polygon, Distance distance)
{
    std::vector<Point> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point& a = polygon[i];
        const Point& b = polygon[(i + 1) % polygon.size()];
        const double da = distance(a);
        const double db = distance(b);
        if (da >= 0.0) kept.push_back(a);
        if ((da >= 0.0) != (db >= 0.0)) kept.push_back(a + (da / (da - db)) * (b - a));
    }
    return kept;
}

/// A square in the plane around its point nearest to `centre`, `reach` to each side.
std::vector<glm::dvec3> squareInPlane(const glm::dvec3& normal, double offset, const glm::dvec3& centre,
                                      double reach)
{
    const double squared = glm::dot(normal, normal);
    const glm::dvec3 middle = centre + normal * ((offset - glm::dot(normal, centre)) / squared);
    const glm::dvec3 size = glm::abs(normal);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1, 0, 0)
                             : size.y <= size.z                   ? glm::dvec3(0, 1, 0)
                                                                  : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(glm::cross(normal, other)) * reach;
    const glm::dvec3 v = glm::normalize(glm::cross(normal, u)) * reach;
    return {middle - u - v, middle + u - v, middle + u + v, middle - u + v};
}

class Mask
{
public:
    Mask(int width, int height)
        : width_(width), height_(height),
          unmasked_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 1)
    {
    }

    void addPolygon(std::vector<glm::dvec4> clip, const Screen& screen)
    {
        clip = clipped(clip, [](const glm::dvec4& p) { return p.z + p.w; });
        clip = clipped(clip, [](const glm::dvec4& p) { return p.w - p.z; });
        for (std::size_t i = 0; i < clip.size(); ++i)
            addEdge(screen.window(clip[i]), screen.window(clip[(i + 1) % clip.size()]));
    }

    std::vector<std::uint8_t> take() { return std::move(unmasked_); }

private:
    /// Visits the pixel nearest to the edge in each column (or row, where it is steep) that the edge meets.
    void addEdge(const glm::dvec2& a, const glm::dvec2& b)
    {
        const bool steep = std::abs(b.y - a.y) > std::abs(b.x - a.x);
        const int along = steep ? 1 : 0;
        const int across = 1 - along;
        const int last = (steep ? height_ : width_) - 1;
        const double low = std::clamp(std::min(a[along], b[along]) - kMaskPixels - 0.5, -1.0, last + 1.0);
        const double high = std::clamp(std::max(a[along], b[along]) + kMaskPixels - 0.5, -1.0, last + 1.0);
        const double length = b[along] - a[along];
        for (int i = std::max(0, static_cast<int>(std::ceil(low))); i <= std::min(high, double(last)); ++i) {
            const double place = length == 0.0 ? 0.0 : std::clamp((i + 0.5 - a[along]) / length, 0.0, 1.0);
            const double nearest = std::floor(a[across] + place * (b[across] - a[across]));
            if (!(nearest >= 0.0 && nearest < (steep ? width_ : height_))) continue;
            glm::dvec2 centre;
            centre[along] = i + 0.5;
            centre[across] = nearest + 0.5;
            if (distanceToEdge(centre, a, b) >= kMaskPixels) continue;
            const auto x = static_cast<std::size_t>(centre.x);
            const auto y = static_cast<std::size_t>(centre.y);
            unmasked_[y * static_cast<std::size_t>(width_) + x] = 0;
        }
    }

    static double distanceToEdge(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
    {
        const glm::dvec2 edge = b - a;
        const double squared = glm::dot(edge, edge);
        const double place = squared == 0.0 ? 0.0 : std::clamp(glm::dot(p - a, edge) / squared, 0.0, 1.0);
        return glm::length(p - (a + place * edge));
    }

    int width_;
    int height_;
    std::vector<std::uint8_t> unmasked_;
};

/// Every edge of every slice, those between tetrahedra too.
std::vector<std::uint8_t> maskOf(const Scene& scene, const Renderer& renderer)
{
    if (scene.planes == SamplingPlanes::spherical) {
        std::vector<std::uint8_t> unmasked;
        for (int y = 0; y < scene.height; ++y)
            for (int x = 0; x < scene.width; ++x)
                unmasked.push_back(renderer.isFarFromEdges(x, y));
        return unmasked;
    }
    Mask mask(scene.width, scene.height);
    const glm::dvec3 centre = 0.5 * volumeExtent(scene);
    double reach = glm::length(centre);
    for (const glm::dvec3& corner : geometryCorners(scene))
        reach = std::max(reach, glm::length(corner - centre));
    reach = 2.0 * reach + 1.0;
    const std::vector<Solid> whole{Solid{}};
    for (const double offset : renderer.planes().offsets) {
        const auto square = squareInPlane(renderer.planes().normal, offset, centre, reach);
        for (const Solid& part : scene.geometry.empty() ? whole : renderer.parts()) {
            std::vector<glm::dvec3> polygon = square;
            for (const Solid* solid : {&renderer.region(), &part})
                for (const HalfSpace& h : *solid)
                    polygon = clipped(polygon,
                                      [&](const glm::dvec3& p) { return glm::dot(h.inward, p) - h.offset; });
            std::vector<glm::dvec4> clip;
            for (const glm::dvec3& corner : polygon)
                clip.push_back(renderer.screen().clipCoordinates(corner));
            mask.addPolygon(std::move(clip), renderer.screen());
        }
    }
    return mask.take();
}

} // namespace

const double* Picture::pixel(int x, int y) const
{
    return rgba.data() +
           4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
}

bool Picture::isUnmasked(int x, int y) const
{
    return unmasked[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)] != 0;
}

ReferencePlanes referencePlanes(const Scene& scene)
{
    const Screen screen(scene);
    const std::vector<glm::dvec3> corners = geometryCorners(scene);
    glm::dvec3 lower = corners.front();
    glm::dvec3 upper = corners.front();
    for (const glm::dvec3& corner : corners) {
        lower = glm::min(lower, corner);
        upper = glm::max(upper, corner);
    }
    const PlaneDirection direction = planeDirection(scene, screen, 0.5 * (lower + upper));
    const Extent extent = extentAlong(direction.normal, corners);
    if (scene.stackAxis < 0)
        return {direction.normal, spreadOffsets(extent, direction.step, scene.maxSamples)};
    assert(scene.planes == SamplingPlanes::axisAligned && scene.period);
    return {direction.normal, stackOffsets(extent, direction.step, direction.normal[scene.stackAxis])};
}

ReferenceShells referenceShells(const Scene& scene)
{
    assert(scene.geometry.empty());
    ReferenceShells shells;
    shells.eye = Screen(scene).eye();
    if (scene.period) shells.scale = *scene.period;
    const glm::dvec3 extent = volumeExtent(scene);
    const glm::dvec3 nearest = glm::clamp(shells.eye, glm::dvec3(0.0), extent);
    Extent range{glm::length((nearest - shells.eye) / shells.scale), 0.0};
    for (const glm::dvec3& corner : geometryCorners(scene))
        range.far = std::max(range.far, glm::length((corner - shells.eye) / shells.scale));
    shells.radii = spreadOffsets(range, scene.period ? 1.0 : 0.0, scene.maxSamples);
    shells.spacing = (range.far - range.near) / static_cast<double>(shells.radii.size());
    return shells;
}

Picture referencePicture(const Scene& scene)
{
    assert(scene.volume && scene.width > 0 && scene.height > 0);
    const Renderer renderer(scene);
    Picture picture;
    picture.width = scene.width;
    picture.height = scene.height;
    picture.rgba.resize(4 * static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height));
    const auto drawRows = [&](int first, int step) {
        for (int y = first; y < scene.height; y += step)
            for (int x = 0; x < scene.width; ++x) {
                const Rgba value = renderer.pixelAt(x, y);
                const auto pixel = static_cast<std::ptrdiff_t>(y) * scene.width + x;
                std::copy(value.begin(), value.end(), picture.rgba.begin() + 4 * pixel);
            }
    };
    std::thread other(drawRows, 1, 2);
    drawRows(0, 2);
    other.join();
    picture.unmasked = maskOf(scene, renderer);
    return picture;
}

Rgba referenceSample(const Scene& scene, const glm::dvec3& point)
{
    return Sampler(scene)(point);
}

} // namespace vo::test
