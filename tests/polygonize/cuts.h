#pragma once

#include "polygonize/polygonize.h"
#include "polygonize/sampling_planes.h"

#include "exact_section.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <tuple>

/// Scenes cut by planes, and what is true of the faces whoever cut them.
namespace cuts {

using scenes::Face;
using scenes::Faces;

constexpr double kSize =
    48.0; // voxels a side; coordinates from 32 to 64: four units in the last place 1.5e-5

/// Calls check(camera) for `count` random directions, each seen in parallel and in perspective.
template <class Check>
void forViews(int count, unsigned seed, const Check& check)
{
    std::mt19937 random(seed);
    for (int i = 0; i < count; ++i) {
        const glm::dmat4 rotation = scenes::randomRotation(random);
        for (const bool perspective : {false, true}) {
            SCOPED_TRACE(testing::Message() << "view " << i << (perspective ? " perspective" : " parallel"));
            check(scenes::camera(kSize, rotation, perspective));
        }
    }
}

/// A place of voxel coordinates: the whole volume in a unit cube, its z axis along x.
inline glm::dvec3 turnedIntoUnitCube(const glm::dvec3& voxel)
{
    return glm::dvec3(voxel.z, voxel.x, voxel.y) / kSize;
}

struct Cut
{
    vo::PlaneFamily planes;
    Faces faces;
};

/// What polygonize() gives.
inline Cut cutUp(const scenes::TetraSet& set, std::span<const vo::Box> boxes, const vo::Camera& camera,
                 const vo::SamplingRequest& request)
{
    Cut cut{vo::samplingPlanes(set.view(), camera, request), Faces(set.values)};
    vo::PolygonizeWorkspace workspace;
    const vo::PolygonizeResult result =
        vo::polygonize(set.view(), boxes, camera, request, workspace, cut.faces);
    EXPECT_TRUE(result.complete);
    EXPECT_EQ(result.samples, cut.planes.count);
    EXPECT_EQ(result.spacing, cut.planes.spacing);
    return cut;
}

inline exact::Section sectionOf(const vo::PlaneFamily& planes, int k)
{
    return {planes.normal, planes.offset(k)};
}

/// The faces of a plane have the area of its section of the tetrahedra inside the box.
inline void expectAreasOfSections(const Cut& cut, const scenes::TetraSet& set, const vo::Box& box,
                                  int everyNth = 1)
{
    const std::vector<double> areas = cut.faces.areas(cut.planes.count);
    for (int k = 0; k < cut.planes.count; k += everyNth) {
        const double area = exact::sectionArea(set.view(), box, sectionOf(cut.planes, k));
        EXPECT_NEAR(areas[static_cast<std::size_t>(k)], area, 1e-5 * area + 1e-6 * kSize * kSize)
            << "plane " << k;
    }
}

/// A side of a face: its plane and the bits of its two ends.
using Side = std::tuple<int, std::array<std::uint32_t, 3>, std::array<std::uint32_t, 3>>;

inline Side side(const Face& face, int from, int to)
{
    Side result{face.sample, {}, {}};
    std::memcpy(std::get<1>(result).data(), face.position(from), sizeof std::get<1>(result));
    std::memcpy(std::get<2>(result).data(), face.position(to), sizeof std::get<2>(result));
    return result;
}

/// No side occurs twice, and each from a to b with shared(face, a, b) is the reverse of one other, bit for
/// bit. Returns how many of those there are.
template <class Shared>
int expectClosedSeams(const Faces& faces, const Shared& shared)
{
    std::map<Side, int> sides;
    for (const Face& face : faces.all)
        for (int i = 0; i < face.count(); ++i)
            ++sides[side(face, i, (i + 1) % face.count())];
    int count = 0;
    for (const Face& face : faces.all)
        for (int i = 0; i < face.count(); ++i) {
            const int next = (i + 1) % face.count();
            EXPECT_EQ(sides.at(side(face, i, next)), 1) << "plane " << face.sample;
            if (!shared(face, face.point(i), face.point(next))) continue;
            EXPECT_TRUE(sides.contains(side(face, next, i)))
                << "plane " << face.sample << " brick " << face.brick;
            ++count;
        }
    return count;
}

/// Whether a side lies in an outer face of the box.
inline bool liesInFace(const vo::Box& box, const glm::dvec3& a, const glm::dvec3& b)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double face : {box.lower[axis], box.upper[axis]})
            if (a[axis] == face && b[axis] == face) return true;
    return false;
}

} // namespace cuts
