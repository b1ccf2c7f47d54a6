#pragma once

#include "core/box.h"
#include "geometry/face_sink.h"
#include "geometry/tetra_view.h"
#include "polygonize/camera.h"
#include "polygonize/sampling_planes.h"

#include "gl_matrices.h"

#include <algorithm>
#include <array>
#include <random>
#include <vector>

/// Tetrahedra, brick lattices and views to cut with.
namespace scenes {

struct TetraSet
{
    std::vector<float> records;
    int values = 3;
    std::vector<int> indices;
    int voxelColumn = -1;

    vo::TetraView view() const { return {records, values, indices, voxelColumn}; }
    void add(const glm::dvec3& p)
    {
        for (int axis = 0; axis < 3; ++axis)
            records.push_back(static_cast<float>(p[axis]));
    }
    /// Puts values before each position: value j is a linear function of the position, `linear(j, p)`.
    TetraSet withValues(int count) const;
    /// The positions become voxel coordinates, behind the values `before`; place(p) is the new position of p.
    template <class Place>
    TetraSet withVoxels(const Place& place, const std::vector<float>& before = {}) const;
};

/// The linear functions that withValues stores, far from zero where coordinates lie between -8 and 64.
inline double linear(int j, const glm::dvec3& p)
{
    return 10.0 + 0.25 * j + (1 + j % 3) * 0.01 * p.x - (1 + j % 5) * 0.02 * p.y + (1 + j % 2) * 0.005 * p.z;
}

inline TetraSet TetraSet::withValues(int count) const
{
    TetraSet result;
    result.values = values + count;
    result.indices = indices;
    for (std::size_t i = 0; i < records.size(); i += static_cast<std::size_t>(values)) {
        const float* p = records.data() + i + values - 3;
        for (int j = 0; j < count; ++j)
            result.records.push_back(static_cast<float>(linear(j, {p[0], p[1], p[2]})));
        result.records.insert(result.records.end(), records.begin() + static_cast<std::ptrdiff_t>(i),
                              records.begin() + static_cast<std::ptrdiff_t>(i) + values);
    }
    return result;
}

template <class Place>
TetraSet TetraSet::withVoxels(const Place& place, const std::vector<float>& before) const
{
    TetraSet result;
    result.values = static_cast<int>(before.size()) + 6;
    result.indices = indices;
    result.voxelColumn = static_cast<int>(before.size());
    for (std::size_t i = 0; i < records.size(); i += static_cast<std::size_t>(values)) {
        const float* p = records.data() + i + values - 3;
        result.records.insert(result.records.end(), before.begin(), before.end());
        result.records.insert(result.records.end(), p, p + 3);
        result.add(place(glm::dvec3(p[0], p[1], p[2])));
    }
    return result;
}

/// A box as five tetrahedra, the corners and indices of a legacy program.
inline TetraSet cube(const glm::dvec3& lower, const glm::dvec3& upper)
{
    TetraSet set;
    for (int i = 0; i < 8; ++i)
        set.add({i % 4 == 1 || i % 4 == 2 ? upper.x : lower.x, i % 4 >= 2 ? upper.y : lower.y,
                 i >= 4 ? upper.z : lower.z});
    set.indices = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
    return set;
}

inline TetraSet cube(double size)
{
    return cube(glm::dvec3(0), glm::dvec3(size));
}

/// One tetrahedron that contains [0, size]^3.
inline TetraSet largeTetra(double size)
{
    TetraSet set;
    set.add(glm::dvec3(-0.3 * size, -0.35 * size, -0.4 * size));
    set.add(glm::dvec3(4.5 * size, -0.5 * size, -0.45 * size));
    set.add(glm::dvec3(-0.55 * size, 4.6 * size, -0.5 * size));
    set.add(glm::dvec3(-0.45 * size, -0.6 * size, 4.7 * size));
    set.indices = {0, 1, 2, 3};
    return set;
}

/// One tetrahedron in the plane z = 5.
inline TetraSet flatTetra()
{
    TetraSet set;
    for (int i = 0; i < 4; ++i)
        set.add({i, i * i, 5});
    set.indices = {0, 1, 2, 3};
    return set;
}

/// cells^3 cells of six tetrahedra round a diagonal, over [lower, upper]^3, every lattice point moved by up
/// to `jitter` cells on each axis. Neighbours share faces.
inline TetraSet jitteredLattice(int cells, double lower, double upper, double jitter, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> offset(-jitter, jitter);
    const double cell = (upper - lower) / cells;
    TetraSet set;
    for (int z = 0; z <= cells; ++z)
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x)
                set.add(lower + cell * (glm::dvec3(x, y, z) +
                                        glm::dvec3(offset(random), offset(random), offset(random))));
    const int row = cells + 1;
    const std::array<int, 3> step{1, row, row * row};
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x) {
                std::array<int, 3> way{0, 1, 2};
                do {
                    int vertex = x + row * (y + row * z);
                    set.indices.push_back(vertex);
                    for (const int axis : way)
                        set.indices.push_back(vertex += step[static_cast<std::size_t>(axis)]);
                } while (std::next_permutation(way.begin(), way.end()));
            }
    return set;
}

/// Clip boxes that meet at the given coordinates of each axis, x fastest.
inline std::vector<vo::Box> lattice(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& z)
{
    std::vector<vo::Box> boxes;
    for (std::size_t k = 0; k + 1 < z.size(); ++k)
        for (std::size_t j = 0; j + 1 < y.size(); ++j)
            for (std::size_t i = 0; i + 1 < x.size(); ++i)
                boxes.push_back({{x[i], y[j], z[k]}, {x[i + 1], y[j + 1], z[k + 1]}});
    return boxes;
}

/// Clip boxes of a volume of `size` voxels in perAxis^3 bricks with one voxel of overlap, unequal brick
/// sizes.
inline std::vector<vo::Box> bricks(int perAxis, double size)
{
    std::vector<double> seams{0.5};
    for (int i = 1; i < perAxis; ++i)
        seams.push_back(std::floor(size * (i - 0.2 * (i % 2)) / perAxis) + 0.5);
    seams.push_back(size - 0.5);
    return lattice(seams, seams, seams);
}

inline vo::Box hull(std::span<const vo::Box> boxes)
{
    vo::Box box = boxes[0];
    for (const vo::Box& other : boxes)
        box = {glm::min(box.lower, other.lower), glm::max(box.upper, other.upper)};
    return box;
}

inline glm::dmat4 randomRotation(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> angle(0, 360);
    const double degrees = angle(random);
    const double x = normal(random), y = normal(random), z = normal(random);
    return gl_matrices::rotate(degrees, {x, y, z});
}

/// A viewer who sees [0, size]^3, turned by `rotation` about its centre.
inline vo::Camera camera(double size, const glm::dmat4& rotation, bool perspective)
{
    using namespace gl_matrices;
    const glm::dmat4 model = translate({0, 0, -2.5 * size}) * rotation * translate(glm::dvec3(-0.5 * size));
    const glm::dmat4 projection = perspective ? gl_matrices::perspective(40, 1.25, size, 4 * size)
                                              : ortho(-size, size, -size, size, size, 4 * size);
    return vo::findCamera(model, projection).value();
}

/// A viewer who looks in parallel along `direction`, of unit length.
inline vo::Camera parallelCamera(const glm::dvec3& direction)
{
    vo::Camera view;
    view.direction = view.depthNormal = direction;
    return view;
}

/// Turns by quarters about x and y, with the rounding that cosines and sines bring.
inline glm::dmat4 headOnTurn(double degreesX, double degreesY, double rounding)
{
    glm::dmat4 turn = gl_matrices::rotate(degreesX, {1, 0, 0}) * gl_matrices::rotate(degreesY, {0, 1, 0});
    turn[0][2] += rounding;
    turn[1][2] -= 2 * rounding;
    turn[2][2] += 0.7 * rounding;
    return turn;
}

inline vo::SamplingRequest everyVoxel(int maxSamples = 4096)
{
    vo::SamplingRequest request;
    request.period = glm::dvec3(1.0);
    request.maxSamples = maxSamples;
    return request;
}

/// Planes in the middle of the slices of a stack of two-dimensional textures.
inline vo::SamplingRequest everySlice(int stackAxis)
{
    vo::SamplingRequest request = everyVoxel();
    request.mode = vo::SamplingMode::axisAligned;
    request.stackAxis = stackAxis;
    return request;
}

struct Face
{
    int brick;
    int sample;
    std::vector<float> records;
    int values;

    int count() const { return static_cast<int>(records.size()) / values; }
    const float* position(int i) const { return records.data() + (i + 1) * values - 3; }
    glm::dvec3 point(int i) const { return {position(i)[0], position(i)[1], position(i)[2]}; }
    /// Half the sum of the cross products: as long as the face is large, across it.
    glm::dvec3 area() const
    {
        glm::dvec3 sum(0.0);
        for (int i = 1; i + 1 < count(); ++i)
            sum += 0.5 * glm::cross(point(i) - point(0), point(i + 1) - point(0));
        return sum;
    }
};

/// Keeps every face.
class Faces : public vo::FaceSink
{
public:
    explicit Faces(int values = 3) : values_(values) {}

    bool append(int brick, int sample, std::span<const float> records) override
    {
        all.push_back({brick, sample, {records.begin(), records.end()}, values_});
        return true;
    }
    std::vector<double> areas(int samples) const
    {
        std::vector<double> sums(static_cast<std::size_t>(samples));
        for (const Face& face : all)
            sums.at(static_cast<std::size_t>(face.sample)) += glm::length(face.area());
        return sums;
    }

    std::vector<Face> all;

private:
    int values_;
};

} // namespace scenes
