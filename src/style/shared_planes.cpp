#include "style/shared_planes.h"

#include "style/styled_voxels.h"

#include <glm/geometric.hpp>
#include <glm/mat3x4.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace vo {

namespace {

/// Of the faces of a plane, with each other one.
constexpr std::size_t kMostCompared = 64;

/// A triangle of the world.
struct Face
{
    std::size_t surface, first;
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal; ///< unit, one of both signs
    double offset;     ///< dot(normal, p) on its plane
    double area, height;
    double rounding; ///< how far corners may lie from where they are meant to be
};

struct Plane
{
    glm::dvec3 normal;
    double offset, rounding;
    std::vector<std::size_t> faces{}; ///< where overlaps are looked for
    bool isShared = false;
    int number = -1;
};

/// Of a normal and the opposite one the same: a component that is not small is positive.
glm::dvec3 withoutSign(const glm::dvec3& normal)
{
    constexpr double kSmall = 0.2871;
    for (int axis = 0; axis < 3; ++axis)
        if (std::abs(normal[axis]) > kSmall) return normal[axis] < 0.0 ? -normal : normal;
    return normal;
}

/// False for what has no plane: slivers, and what is not finite.
bool findPlane(Face& face)
{
    constexpr double kRounding = 4e-7, kLeastHeight = 64.0;
    const auto& [a, b, c] = face.corners;
    double most = 0.0;
    for (const glm::dvec3& corner : face.corners)
        for (int axis = 0; axis < 3; ++axis)
            most = std::max(most, std::abs(corner[axis]));
    face.rounding = kRounding * most;
    const glm::dvec3 across = glm::cross(b - a, c - a);
    face.area = glm::length(across);
    face.height = face.area / std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
    if (!(face.height > kLeastHeight * face.rounding) || !std::isfinite(face.area)) return false;
    face.normal = withoutSign(across / face.area);
    face.offset = glm::dot(face.normal, a);
    return true;
}

std::size_t triangleCount(const StyledScene& scene)
{
    std::size_t count = 0;
    for (const StyledSurface& surface : scene.surfaces)
        count += surface.triangles.size() / 3;
    return count;
}

/// Corners of the world, by surface; none of what makes no sense, nor where there is nothing to look for.
std::vector<std::vector<glm::dvec3>> positionsOf(const StyledScene& scene)
{
    const std::size_t count = triangleCount(scene);
    const auto hasTriangles = [](const StyledSurface& surface) { return surface.triangles.size() >= 3; };
    const bool areSeveral = std::ranges::count_if(scene.surfaces, hasTriangles) > 1;
    if (count > (areSeveral ? SharedPlanes::kMostTriangles : SharedPlanes::kMostWithinSurfaces)) return {};
    std::vector<std::vector<glm::dvec3>> positions(scene.surfaces.size());
    for (std::size_t number = 0; number < scene.surfaces.size(); ++number) {
        const StyledSurface& surface = scene.surfaces[number];
        if (!isSound(surface)) continue;
        positions[number].reserve(surface.positions.size());
        for (const glm::vec3& position : surface.positions)
            positions[number].emplace_back(surface.worldFromLocal * glm::dvec4(glm::dvec3(position), 1.0));
    }
    return positions;
}

/// From the origin of the world.
double farthestOf(const std::vector<std::vector<glm::dvec3>>& positions)
{
    double squared = std::numeric_limits<double>::min();
    for (const std::vector<glm::dvec3>& ofSurface : positions)
        for (const glm::dvec3& position : ofSurface)
            squared = std::max(squared, glm::dot(position, position));
    return std::sqrt(squared);
}

/// Calls visit(face) for all that have a plane.
template <class Visit>
void forFaces(const StyledScene& scene, const std::vector<std::vector<glm::dvec3>>& positions,
              const Visit& visit)
{
    for (std::size_t number = 0; number < positions.size(); ++number) {
        if (positions[number].empty()) continue;
        const std::vector<int>& triangles = scene.surfaces[number].triangles;
        const auto corner = [&](std::size_t i) {
            return positions[number][static_cast<std::size_t>(triangles[i])];
        };
        for (std::size_t first = 0; first + 3 <= triangles.size(); first += 3) {
            Face face{number, first, {corner(first), corner(first + 1), corner(first + 2)}, {}, 0, 0, 0, 0};
            if (findPlane(face)) visit(face);
        }
    }
}

/// Cells of normals and offsets in which the plane of a face may be, its own first.
struct Cells
{
    std::array<std::uint64_t, 16> keys;
    std::size_t count = 0;

    /// `scale`: no offset is greater.
    Cells(const Face& face, double scale)
    {
        constexpr double kNormals = 512.0, kOffsets = 4096.0;
        // A face's own plane is as uncertain as it is small.
        const double turned = 2.0 * face.rounding / face.height;
        const std::array<double, 4> place{face.normal.x * kNormals, face.normal.y * kNormals,
                                          face.normal.z * kNormals, face.offset / scale * kOffsets};
        for (std::size_t i = 0; i < 4; ++i) {
            const double noise = i < 3 ? turned * kNormals : (turned + face.rounding / scale) * kOffsets;
            addBeside(place[i], noise + 1e-6);
        }
    }

private:
    /// Another number for all keys: of the cell, and of the one beside where that is within the noise.
    void addBeside(double place, double noise)
    {
        const double cell = std::floor(place), within = place - cell;
        const std::size_t before = std::max(count, std::size_t{1});
        if (count == 0) keys[0] = 0;
        count = before;
        if (std::min(within, 1.0 - within) <= noise) {
            for (std::size_t i = 0; i < before; ++i)
                keys[before + i] = with(keys[i], within < 0.5 ? cell - 1.0 : cell + 1.0);
            count = 2 * before;
        }
        for (std::size_t i = 0; i < before; ++i)
            keys[i] = with(keys[i], cell);
    }
    static std::uint64_t with(std::uint64_t key, double cell)
    {
        return key << 16 | static_cast<std::uint16_t>(static_cast<std::int64_t>(cell));
    }
};

/// Which cells several surfaces may have planes in.
class SeenCells
{
public:
    explicit SeenCells(std::size_t faces) : surfaces_(std::bit_ceil(4 * faces + 1), kNone) {}

    void add(const Cells& cells, std::size_t surface)
    {
        for (std::size_t i = 0; i < cells.count; ++i) {
            std::uint32_t& seen = surfaces_[slotOf(cells.keys[i])];
            const auto number = static_cast<std::uint32_t>(surface);
            seen = seen == kNone || seen == number ? number : kSeveral;
        }
    }
    bool areShared(const Cells& cells) const
    {
        return std::any_of(cells.keys.begin(), cells.keys.begin() + static_cast<std::ptrdiff_t>(cells.count),
                           [this](std::uint64_t key) { return surfaces_[slotOf(key)] == kSeveral; });
    }

private:
    static constexpr std::uint32_t kNone = ~0U, kSeveral = kNone - 1;

    std::size_t slotOf(std::uint64_t key) const
    {
        return static_cast<std::size_t>(key * 0x9e3779b97f4a7c15U >> 32) & (surfaces_.size() - 1);
    }

    std::vector<std::uint32_t> surfaces_;
};

/// Those that may share their planes with others, the largest first, which tell best what plane they
/// are in.
std::vector<Face> facesOf(const StyledScene& scene, const std::vector<std::vector<glm::dvec3>>& positions,
                          double scale)
{
    const std::size_t count = triangleCount(scene);
    const bool areAll = count <= SharedPlanes::kMostWithinSurfaces;
    SeenCells seen(areAll ? 0 : count);
    if (!areAll)
        forFaces(scene, positions, [&](const Face& face) { seen.add(Cells(face, scale), face.surface); });
    std::vector<Face> faces;
    forFaces(scene, positions, [&](const Face& face) {
        if (areAll || seen.areShared(Cells(face, scale))) faces.push_back(face);
    });
    std::ranges::stable_sort(faces, std::ranges::greater(), &Face::area);
    return faces;
}

/// Planes by their cells.
class PlaneList
{
public:
    explicit PlaneList(double scale) : scale_(scale) {}

    /// The plane that a face lies in; one of its own where there is none yet.
    std::size_t planeOf(const Face& face)
    {
        const Cells cells(face, scale_);
        for (std::size_t i = 0; i < cells.count; ++i)
            if (const auto there = byCell_.find(cells.keys[i]); there != byCell_.end())
                for (const std::size_t plane : there->second)
                    if (contains(planes[plane], face)) return plane;
        std::vector<std::size_t>& own = byCell_[cells.keys[0]];
        if (own.size() < kMostInCell) own.push_back(planes.size());
        planes.push_back({face.normal, face.offset, face.rounding});
        return planes.size() - 1;
    }

    std::vector<Plane> planes;

private:
    static constexpr std::size_t kMostInCell = 64;

    static bool contains(const Plane& plane, const Face& face)
    {
        const double rounding = std::max(plane.rounding, face.rounding);
        return std::ranges::all_of(face.corners, [&](const glm::dvec3& corner) {
            return std::abs(glm::dot(plane.normal, corner) - plane.offset) <= rounding;
        });
    }

    double scale_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> byCell_;
};

/// Whether two triangles of one plane have more than an edge in common: no edge has them on its two sides.
bool overlap(const Face& a, const Face& b)
{
    for (const Face* const face : {&a, &b})
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 edge = face->corners[(i + 1) % 3] - face->corners[i];
            const glm::dvec3 across = glm::cross(a.normal, edge);
            const auto rangeOf = [&](const Face& of) {
                return std::minmax({glm::dot(across, of.corners[0]), glm::dot(across, of.corners[1]),
                                    glm::dot(across, of.corners[2])});
            };
            const auto ofA = rangeOf(a), ofB = rangeOf(b);
            const double rounding = 4.0 * std::max(a.rounding, b.rounding) * glm::length(across);
            if (ofA.second <= ofB.first + rounding || ofB.second <= ofA.first + rounding) return false;
        }
    return true;
}

/// Whether a face lies in a plane with others of other surfaces, or of its own that it overlaps.
bool sharesPlane(const Plane& plane, const Face& face, const std::vector<Face>& faces, bool withinSurfaces)
{
    if (plane.isShared || plane.faces.empty()) return plane.isShared;
    return std::ranges::any_of(plane.faces, [&](std::size_t other) {
        if (faces[other].surface != face.surface) return true;
        return withinSurfaces && overlap(faces[other], face);
    });
}

/// The plane of each face; finds which planes are shared.
std::vector<std::size_t> sortIntoPlanes(const std::vector<Face>& faces, bool withinSurfaces, PlaneList& list)
{
    std::vector<std::size_t> planeOfFace;
    planeOfFace.reserve(faces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        planeOfFace.push_back(list.planeOf(faces[i]));
        Plane& plane = list.planes[planeOfFace.back()];
        plane.isShared = sharesPlane(plane, faces[i], faces, withinSurfaces);
        if (plane.faces.size() < (withinSurfaces ? kMostCompared : 1)) plane.faces.push_back(i);
    }
    return planeOfFace;
}

/// A plane of eye space, without triangles so far.
SharedPlane seenPlane(const glm::dvec4& plane, const glm::dmat4& eyeFromClip)
{
    constexpr double kFar = std::numeric_limits<double>::infinity();
    SharedPlane seen{plane, {}, {}, kFar, -kFar};
    const glm::dvec4 clip = plane * eyeFromClip;
    // Where it meets the line of a pixel, a point of clip space is linear in the pixel's place.
    const glm::dmat3x4 points(glm::dvec4(clip.z, 0.0, -clip.x, 0.0), glm::dvec4(0.0, clip.z, -clip.y, 0.0),
                              glm::dvec4(0.0, 0.0, -clip.w, clip.z));
    for (int i = 0; i < 3; ++i) {
        const glm::dvec4 eye = eyeFromClip * points[i];
        seen.depth[i] = -eye.z;
        seen.weight[i] = eye.w;
    }
    return seen;
}

void extend(SharedPlane& plane, const Face& face, const glm::dmat4& eyeFromWorld)
{
    for (const glm::dvec3& corner : face.corners) {
        const double depth = -(eyeFromWorld * glm::dvec4(corner, 1.0)).z;
        plane.nearest = std::min(plane.nearest, depth);
        plane.farthest = std::max(plane.farthest, depth);
    }
}

} // namespace

double SharedPlane::depthAt(double x, double y) const
{
    const glm::dvec3 place(x, y, 1.0);
    const double there = glm::dot(depth, place) / glm::dot(weight, place);
    return there >= nearest ? std::min(there, farthest) : nearest;
}

SharedPlanes::SharedPlanes(const StyledScene& scene)
{
    const std::vector<std::vector<glm::dvec3>> positions = positionsOf(scene);
    const double scale = farthestOf(positions);
    const std::vector<Face> faces = facesOf(scene, positions, scale);
    PlaneList list(scale);
    const std::vector<std::size_t> planeOfFace =
        sortIntoPlanes(faces, triangleCount(scene) <= kMostWithinSurfaces, list);
    const glm::dmat4 worldFromEye = glm::inverse(scene.eyeFromWorld);
    const glm::dmat4 eyeFromClip = glm::inverse(scene.clipFromEye);
    for (Plane& plane : list.planes) {
        if (!plane.isShared || planes_.size() == kMostPlanes) continue;
        plane.number = static_cast<int>(planes_.size());
        planes_.push_back(seenPlane(glm::dvec4(plane.normal, -plane.offset) * worldFromEye, eyeFromClip));
    }
    if (planes_.empty()) return;
    numbers_.resize(scene.surfaces.size());
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const int number = list.planes[planeOfFace[i]].number;
        if (number < 0) continue;
        std::vector<int>& numbers = numbers_[faces[i].surface];
        if (numbers.empty()) numbers.assign(scene.surfaces[faces[i].surface].triangles.size() / 3, -1);
        numbers[faces[i].first / 3] = number;
        extend(planes_[static_cast<std::size_t>(number)], faces[i], scene.eyeFromWorld);
    }
}

} // namespace vo
