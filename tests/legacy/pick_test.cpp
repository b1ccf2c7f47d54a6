// Picking: where the samples of a line of sight lie, and which voxels they name.

#include "expect_error.h"
#include <vo/Volumizer.h>

#include "support/reference.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <random>

namespace {

using namespace vo::test;
using Format = voInterleavedArrayTypeScope;
using Type = voDataTypeScope;
using External = voExternalFormatTypeScope;
using vo::VoxelSize;

constexpr int kPixels = 64;
constexpr int kCapacity = 1000;

/// A volume whose voxels, byte by byte, are unlike their neighbours.
struct PickVolume
{
    PickVolume(const VoxelSize& volume, int brick, voDataType type = Type::UNSIGNED_BYTE,
               voExternalFormatType format = External::LUMINANCE,
               voInterpolationType interpolation = voInterpolationTypeScope::_3D, int overlap = 1)
        : size(volume),
          bricks(volume.x, volume.y, volume.z, brick, brick, brick, voPartialBrickTypeScope::AUGMENT, overlap,
                 voInternalFormatTypeScope::DEFAULT, format, type, interpolation)
    {
        const bool stacks = interpolation == voInterpolationTypeScope::_2D;
        voBrickSetCollectionIterator sets(&bricks);
        for (voBrickSet* set; (set = sets());) {
            voAppearanceActions::dataAlloc(set);
            for (int i = 0; i < set->getBrickCount() && !(stacks && set != bricks.getBrickSet(0)); ++i)
                fill(*set->getBrick(i));
        }
        voAppearanceActions::volumeMakeTransposed(&bricks);
        expectNoError();
    }

    unsigned char byteOf(int x, int y, int z, std::size_t byte) const
    {
        const bool inside = x < size.x && y < size.y && z < size.z;
        const unsigned hash =
            2654435761u * static_cast<unsigned>(x + 101 * (y + 103 * z) + 77777 * int(byte));
        return inside ? static_cast<unsigned char>(hash >> 16) : static_cast<unsigned char>(0);
    }

    void fill(voBrick& brick)
    {
        int x0, y0, z0, nx, ny, nz;
        brick.getBrickSizes(x0, y0, z0, nx, ny, nz);
        bytes = brick.getDataSize() / static_cast<std::size_t>(nx * ny * nz);
        auto* target = static_cast<unsigned char*>(brick.getDataPtr());
        for (int z = 0; z < nz; ++z)
            for (int y = 0; y < ny; ++y)
                for (int x = 0; x < nx; ++x)
                    for (std::size_t b = 0; b < bytes; ++b)
                        *target++ = byteOf(x0 + x, y0 + y, z0 + z, b);
    }

    /// The voxel around a point, and the outermost one beyond the volume.
    std::vector<unsigned char> voxelAt(const float* p) const
    {
        const int x = std::clamp(int(std::floor(p[0])), 0, size.x - 1);
        const int y = std::clamp(int(std::floor(p[1])), 0, size.y - 1);
        const int z = std::clamp(int(std::floor(p[2])), 0, size.z - 1);
        std::vector<unsigned char> voxel;
        for (std::size_t b = 0; b < bytes; ++b)
            voxel.push_back(byteOf(x, y, z, b));
        return voxel;
    }

    VoxelSize size;
    std::size_t bytes = 1;
    voBrickSetCollection bricks;
};

/// The guide's five tetrahedra over a volume; values in front of a position by function(position).
struct PickGeometry
{
    explicit PickGeometry(const VoxelSize& size)
    {
        for (int i = 0; i < 8; ++i)
            positions.push_back({i % 4 == 1 || i % 4 == 2 ? double(size.x) : 0.0,
                                 i % 4 >= 2 ? double(size.y) : 0.0, i >= 4 ? double(size.z) : 0.0});
    }

    void addRecord(const std::vector<double>& front, const glm::dvec3& position)
    {
        for (const double value : front)
            records.push_back(float(value));
        for (int axis = 0; axis < 3; ++axis)
            records.push_back(float(position[axis]));
        values = int(front.size()) + 3;
    }

    voIndexedTetraSet& tetras()
    {
        if (records.empty())
            for (const glm::dvec3& p : positions)
                addRecord({}, p);
        if (!set)
            set = std::make_unique<voIndexedTetraSet>(records.data(), int(records.size()) / values, values,
                                                      indices, 20);
        return *set;
    }

    std::vector<glm::dvec3> positions;
    std::vector<float> records;
    int values = 3;
    int indices[20] = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
    std::unique_ptr<voIndexedTetraSet> set;
};

struct PickResult
{
    voBool hit = VO_FALSE;
    std::vector<std::vector<float>> records;
    std::vector<unsigned char> voxels;
};

struct PickCall
{
    int pixel[2] = {kPixels / 2, kPixels / 2};
    int viewport[4] = {0, 0, kPixels, kPixels};
    voInterleavedArrayType format = Format::V3F;
    View view;
    float period[3] = {1, 1, 1};
    int capacity = kCapacity;
    int values = 3;
    voBool drawn = VO_FALSE;

    template <class Bricks>
    PickResult operator()(voIndexedTetraSet& tetras, Bricks* bricks, std::size_t bytes = 1)
    {
        voVertexData coordinates(capacity, values);
        coordinates.setCount(std::min(capacity, 3));
        PickResult result;
        result.voxels.assign(std::size_t(capacity) * bytes, 0xEE);
        result.hit = voGeometryActions::pick(pixel, viewport, &tetras, bricks, format, view.model.data(),
                                             view.projection.data(), period, drawn, &coordinates,
                                             result.voxels.data());
        for (int i = 0; i < coordinates.getCount(); ++i)
            result.records.emplace_back(coordinates[i], coordinates[i] + values);
        const std::size_t used = result.records.size() * bytes;
        for (std::size_t i = used; i < result.voxels.size(); ++i)
            EXPECT_EQ(result.voxels[i], 0xEE) << "written past the last sample";
        result.voxels.resize(used);
        return result;
    }
};

struct Ray
{
    glm::dvec3 start;
    glm::dvec3 way; ///< to the far plane
};

Ray rayOf(const PickCall& call)
{
    const glm::dmat4 fromClip =
        glm::inverse(glm::make_mat4(call.view.projection.data()) * glm::make_mat4(call.view.model.data()));
    const double x = 2 * (call.pixel[0] - call.viewport[0] + 0.5) / call.viewport[2] - 1;
    const double y = 2 * (call.pixel[1] - call.viewport[1] + 0.5) / call.viewport[3] - 1;
    const glm::dvec4 a = fromClip * glm::dvec4(x, y, -1, 1), b = fromClip * glm::dvec4(x, y, 1, 1);
    const glm::dvec3 start = glm::dvec3(a) / a.w;
    return {start, glm::dvec3(b) / b.w - start};
}

ReferencePlanes planesOf(const PickCall& call, const Field& field, int stackAxis = -1)
{
    Scene scene;
    scene.volume = &field;
    scene.view = call.view;
    scene.width = scene.height = kPixels;
    scene.period = glm::dvec3(call.period[0], call.period[1], call.period[2]);
    scene.stackAxis = stackAxis;
    if (stackAxis >= 0) scene.planes = SamplingPlanes::axisAligned;
    return referencePlanes(scene);
}

/// Where the ray meets the planes inside a box, from the viewer on; nothing when rounding would decide.
std::optional<std::vector<glm::dvec3>> expectedPoints(const Ray& ray, const ReferencePlanes& planes,
                                                      const glm::dvec3& lower, const glm::dvec3& upper)
{
    std::vector<glm::dvec3> points;
    const double slope = glm::dot(planes.normal, ray.way);
    for (auto offset = planes.offsets.rbegin(); offset != planes.offsets.rend(); ++offset) {
        const double place = (*offset - glm::dot(planes.normal, ray.start)) / slope;
        if (place < 0 || place > 1) continue;
        const glm::dvec3 p = ray.start + place * ray.way;
        double depth = 1e9;
        for (int axis = 0; axis < 3; ++axis)
            depth = std::min({depth, p[axis] - lower[axis], upper[axis] - p[axis]});
        if (std::abs(depth) < 1e-4) return std::nullopt;
        if (depth > 0) points.push_back(p);
    }
    return points;
}

std::vector<PickCall> randomCalls(const VoxelSize& size, int count, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> pixel(0, kPixels - 1), degrees(10, 80);
    std::uniform_real_distribution<float> period(0.3f, 2.5f);
    std::vector<PickCall> calls;
    for (const Angles& angles : randomViews(count, seed)) {
        PickCall call;
        call.view = calls.size() % 2 ? perspectiveView(angles, size, kPixels, kPixels, degrees(random))
                                     : orthographicView(angles, size, kPixels, kPixels);
        for (int& coordinate : call.pixel)
            coordinate = pixel(random);
        for (float& step : call.period)
            step = period(random);
        calls.push_back(call);
    }
    return calls;
}

void expectRecords(const PickResult& result, const std::vector<glm::dvec3>& expected)
{
    ASSERT_EQ(result.records.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::vector<float>& record = result.records[i];
            EXPECT_NEAR(record[record.size() - 3 + axis], expected[i][int(axis)], 2e-5) << "sample " << i;
        }
}

void expectVoxels(const PickResult& result, const PickVolume& volume, std::size_t column)
{
    ASSERT_EQ(result.voxels.size(), result.records.size() * volume.bytes);
    for (std::size_t i = 0; i < result.records.size(); ++i) {
        const std::vector<unsigned char> expected = volume.voxelAt(result.records[i].data() + column);
        EXPECT_EQ(std::memcmp(expected.data(), result.voxels.data() + i * volume.bytes, volume.bytes), 0)
            << "sample " << i << " at " << result.records[i][column] << " " << result.records[i][column + 1]
            << " " << result.records[i][column + 2];
    }
}

TEST(Pick, samplesLieWhereTheRayMeetsThePlanes)
{
    const VoxelSize size{20, 17, 23};
    const Field field = constantField(size, 0);
    PickGeometry geometry(size);
    for (const int brick : {23, 9, 5}) {
        PickVolume volume(size, brick);
        voBrickSet* set = volume.bricks.getCurrentBrickSet();
        int hits = 0, misses = 0;
        for (PickCall& call : randomCalls(size, 400, unsigned(brick))) {
            const auto expected = expectedPoints(rayOf(call), planesOf(call, field), glm::dvec3(0.5),
                                                 glm::dvec3(19.5, 16.5, 22.5));
            if (!expected) continue;
            const PickResult result = call(geometry.tetras(), set);
            expectRecords(result, *expected);
            EXPECT_EQ(result.hit, expected->empty() ? VO_FALSE : VO_TRUE);
            expectVoxels(result, volume, 0);
            ++(expected->empty() ? misses : hits);
        }
        EXPECT_GT(hits, 100);
        EXPECT_GT(misses, 20);
    }
    expectNoError();
}

/// Head-on planes lie on seams between bricks, and lines in the faces between tetrahedra.
TEST(Pick, seamsOfBricksAndTetrahedraYieldEachSampleOnce)
{
    const VoxelSize size{16, 16, 16};
    PickGeometry geometry(size);
    PickVolume volume(size, 6); // seams at 5.5, 10.5, 15.5
    for (const auto& [turn, x, y, z] : {std::tuple(0, 1, 0, 0),
                                        {90, 1, 0, 0},
                                        {180, 1, 0, 0},
                                        {270, 1, 0, 0},
                                        {90, 0, 1, 0},
                                        {270, 0, 1, 0}})
        for (int row = 1; row < 31; ++row)
            for (const int column : {row, 31 - row, 11, 21}) {
                PickCall call;
                call.view.model = multiply(rotation(turn, x, y, z), translation(-8, -8, -8));
                // 32 pixels over 16 voxels, the first centre on 0: half of them on seams and diagonals.
                call.view.projection = ortho(-8.25, 7.75, -8.25, 7.75, -20, 20);
                call.viewport[2] = call.viewport[3] = 32;
                call.pixel[0] = column;
                call.pixel[1] = row;
                const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
                const bool outside = column < 1 || column > 31;
                ASSERT_EQ(result.records.size(), outside ? 0u : 16u)
                    << turn << " degrees, pixel " << column << " " << row;
                expectVoxels(result, volume, 0);
            }
    expectNoError();
}

/// Cells of six tetrahedra each, whose edges and faces are what lines of whole pixels run in.
TEST(Pick, latticeOfTetrahedraYieldsEachSampleOnce)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16, Type::UNSIGNED_BYTE, External::LUMINANCE, voInterpolationTypeScope::_3D, 0);
    std::vector<float> records;
    std::vector<int> indices;
    for (int i = 0; i < 125; ++i)
        for (const int cell : {i % 5, i / 5 % 5, i / 25})
            records.push_back(4.0f * float(cell));
    for (int i = 0; i < 125; ++i) {
        if (i % 5 == 4 || i / 5 % 5 == 4 || i / 25 == 4) continue;
        int way[3] = {1, 5, 25};
        do {
            int vertex = i;
            indices.push_back(vertex);
            for (const int step : way)
                indices.push_back(vertex += step);
        } while (std::next_permutation(way, way + 3));
    }
    voIndexedTetraSet tetras(records.data(), 125, 3, indices.data(), int(indices.size()));
    for (const auto& [turn, x, y] :
         {std::tuple(0, 1, 0), {90, 1, 0}, {180, 1, 0}, {270, 1, 0}, {90, 0, 1}, {270, 0, 1}})
        for (const int roll : {0, 90, 30}) {
            PickCall call;
            call.view.model =
                multiply(multiply(rotation(roll, 0, 0, 1), rotation(turn, x, y, 0)), translation(-8, -8, -8));
            call.view.projection = ortho(-8.5, 8.5, -8.5, 8.5, -20, 20);
            call.viewport[2] = call.viewport[3] = 17;
            for (call.pixel[1] = 5; call.pixel[1] < 12; ++call.pixel[1])
                for (call.pixel[0] = 5; call.pixel[0] < 12; ++call.pixel[0])
                    ASSERT_EQ(call(tetras, volume.bricks.getCurrentBrickSet()).records.size(), 16u)
                        << turn << " " << roll << ", pixel " << call.pixel[0] << " " << call.pixel[1];
        }
    expectNoError();
}

TEST(Pick, perspectiveLineThroughACornerOfTetrahedraYieldsEachSampleOnce)
{
    const VoxelSize size{16, 16, 16};
    const Field field = constantField(size, 0);
    PickGeometry geometry(size);
    PickVolume volume(size, 7);
    PickCall call;
    call.viewport[2] = call.viewport[3] = 33; // pixel 16 is the middle
    call.pixel[0] = call.pixel[1] = 16;
    for (const Angles& angles : fixedViews()) {
        call.view = perspectiveView(angles, size, 33, 33, 40);
        const Ray ray = rayOf(call);
        const auto expected = expectedPoints(ray, planesOf(call, field), glm::dvec3(0.5), glm::dvec3(15.5));
        if (!expected) continue;
        expectRecords(call(geometry.tetras(), volume.bricks.getCurrentBrickSet()), *expected);
    }
    // Along the diagonal through two vertices.
    call.view.model = multiply(translation(0, 0, -40), translation(0, 0, 0));
    Matrix turn = rotation(std::acos(1 / std::sqrt(3.0)) * 180 / M_PI, 1, -1, 0);
    call.view.model = multiply(translation(0, 0, -40), multiply(turn, translation(-8, -8, -8)));
    call.view.projection = perspective(40, 1, 10, 80);
    const auto expected =
        expectedPoints(rayOf(call), planesOf(call, field), glm::dvec3(0.5), glm::dvec3(15.5));
    ASSERT_TRUE(expected);
    EXPECT_GT(expected->size(), 20u);
    expectRecords(call(geometry.tetras(), volume.bricks.getCurrentBrickSet()), *expected);
    expectNoError();
}

TEST(Pick, everyDataTypeComesBackAsItLies)
{
    const VoxelSize size{9, 12, 10};
    PickGeometry geometry(size);
    int kinds = 0;
    for (int type = Type::UNSIGNED_BYTE; type <= Type::FLOAT; ++type)
        for (int format = External::INTENSITY; format <= External::ABGR_EXT; ++format) {
            const bool packed =
                type == Type::UNSIGNED_BYTE_3_3_2_EXT || type == Type::UNSIGNED_SHORT_4_4_4_4_EXT ||
                type == Type::UNSIGNED_SHORT_5_5_5_1_EXT || type == Type::UNSIGNED_INT_8_8_8_8_EXT ||
                type == Type::UNSIGNED_INT_10_10_10_2_EXT;
            if (packed && format < External::RGBA) continue;
            if (type == Type::UNSIGNED_BYTE_3_3_2_EXT && format == External::ABGR_EXT) continue;
            PickVolume volume(size, 6, static_cast<voDataType>(type),
                              static_cast<voExternalFormatType>(format));
            std::size_t samples = 0;
            for (PickCall& call : randomCalls(size, 80, unsigned(type * 8 + format))) {
                const PickResult result =
                    call(geometry.tetras(), volume.bricks.getCurrentBrickSet(), volume.bytes);
                expectVoxels(result, volume, 0);
                samples += result.records.size();
            }
            EXPECT_GT(samples, 20u) << type << " " << format;
            ++kinds;
        }
    EXPECT_EQ(kinds, 7 * 5 + 4 * 2 + 1);
    expectNoError();
}

/// A cube whose corners were moved, twisted and exchanged, with colours.
TEST(Pick, deformedGeometryInterpolatesVoxelCoordinatesAndColours)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 7);
    PickGeometry geometry(size);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> jitter(-2, 2), color(0, 1);
    for (const glm::dvec3& p : geometry.positions)
        geometry.addRecord({p.z, p.x, p.y, color(random), color(random), color(random), color(random)},
                           p + glm::dvec3(jitter(random), jitter(random), jitter(random)));
    std::size_t samples = 0;
    for (PickCall& call : randomCalls(size, 300, 11)) {
        call.format = Format::T3F_C4F_V3F;
        call.values = 10;
        const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
        const Ray ray = rayOf(call);
        double last = -1;
        for (const std::vector<float>& r : result.records) {
            // In one of the tetrahedra, whose corners weigh all ten values alike.
            const glm::dvec3 p(r[7], r[8], r[9]);
            bool agrees = false;
            for (int t = 0; t < 20 && !agrees; t += 4) {
                const auto value = [&](int corner, int column) {
                    return double(geometry.records[std::size_t(10 * geometry.indices[t + corner] + column)]);
                };
                const auto position = [&](int corner) {
                    return glm::dvec3(value(corner, 7), value(corner, 8), value(corner, 9));
                };
                const glm::dmat3 edges(position(1) - position(0), position(2) - position(0),
                                       position(3) - position(0));
                const glm::dvec3 w = glm::inverse(edges) * (p - position(0));
                const double weights[4] = {1 - w.x - w.y - w.z, w.x, w.y, w.z};
                agrees = *std::min_element(weights, weights + 4) > -1e-4;
                for (int column = 0; agrees && column < 7; ++column) {
                    double sum = 0;
                    for (int corner = 0; corner < 4; ++corner)
                        sum += weights[corner] * value(corner, column);
                    agrees = std::abs(sum - r[std::size_t(column)]) < 1e-3;
                }
            }
            EXPECT_TRUE(agrees);
            const double along = glm::dot(p - ray.start, ray.way) / glm::dot(ray.way, ray.way);
            EXPECT_LT(glm::length(p - ray.start - along * ray.way), 1e-4) << "beside the line";
            EXPECT_GT(along, last) << "not from the viewer on";
            last = along;
            for (int axis = 0; axis < 3; ++axis) {
                EXPECT_GE(r[std::size_t(axis)], 0.5f - 1e-4f);
                EXPECT_LE(r[std::size_t(axis)], 15.5f + 1e-4f);
            }
        }
        expectVoxels(result, volume, 0);
        samples += result.records.size();
    }
    EXPECT_GT(samples, 1000u);
    expectNoError();
}

/// The same samples as with position records; and all of them, whichever tetrahedron they fall into.
TEST(Pick, deformedGeometryLosesNoSample)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16, Type::UNSIGNED_BYTE, External::LUMINANCE, voInterpolationTypeScope::_3D, 0);
    PickGeometry plain(size), mapped(size);
    for (const glm::dvec3& p : mapped.positions)
        mapped.addRecord({p.x, p.y, p.z}, p);
    for (PickCall& call : randomCalls(size, 100, 3)) {
        const PickResult expected = call(plain.tetras(), volume.bricks.getCurrentBrickSet());
        call.format = Format::T3F_V3F;
        call.values = 6;
        const PickResult result = call(mapped.tetras(), volume.bricks.getCurrentBrickSet());
        ASSERT_EQ(result.records.size(), expected.records.size());
        for (std::size_t i = 0; i < result.records.size(); ++i)
            for (std::size_t axis = 0; axis < 3; ++axis) {
                EXPECT_NEAR(result.records[i][axis], expected.records[i][axis], 1e-4);
                EXPECT_NEAR(result.records[i][axis + 3], expected.records[i][axis], 1e-4);
            }
    }
}

TEST(Pick, positionsAreTheVoxelCoordinatesOfRecordsWithoutOthers)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    PickGeometry geometry(size);
    PickCall call;
    call.view = orthographicView({20, 30}, size, kPixels, kPixels);
    call.format = Format::T3F_V3F;
    call.values = 6;
    const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    ASSERT_GT(result.records.size(), 10u);
    for (const std::vector<float>& r : result.records)
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_EQ(r[axis], r[axis + 3]);
    expectVoxels(result, volume, 3);
    expectNoError();
}

TEST(Pick, valuesOfTheUserInFrontAreInterpolatedToo)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    for (const voInterleavedArrayType format : {Format::V3F, Format::USER_V3F}) {
        PickGeometry geometry(size);
        for (const glm::dvec3& p : geometry.positions)
            geometry.addRecord({2 * p.x + p.y - p.z + 1}, p);
        PickCall call;
        call.view = orthographicView({20, 30}, size, kPixels, kPixels);
        call.format = format;
        call.values = 4;
        const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
        ASSERT_GT(result.records.size(), 10u);
        for (const std::vector<float>& r : result.records)
            EXPECT_NEAR(r[0], 2 * r[1] + r[2] - r[3] + 1, 1e-3);
        expectVoxels(result, volume, 1);
        expectNoError();
    }
}

TEST(Pick, voxelCoordinatesMayFollowValuesOfTheUser)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 7);
    PickGeometry geometry(size);
    for (const glm::dvec3& p : geometry.positions)
        geometry.addRecord({1000, p.y, p.z, p.x}, 3.0 * p);
    PickCall call;
    call.view = orthographicView({20, 30}, {48, 48, 48}, kPixels, kPixels);
    call.format = Format::T3F_V3F;
    call.values = 7;
    const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    ASSERT_GT(result.records.size(), 10u);
    for (const std::vector<float>& r : result.records) {
        EXPECT_NEAR(r[0], 1000, 1e-2);
        EXPECT_NEAR(r[1], r[5] / 3, 1e-4);
    }
    expectVoxels(result, volume, 1);
    expectNoError();
}

/// Surfaces of a stack lie on both ends of the geometry, and those belong to it.
TEST(Pick, bothEndsOfTheGeometryAreSampled)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16, Type::UNSIGNED_BYTE, External::LUMINANCE, voInterpolationTypeScope::_2D);
    volume.bricks.setCurrentBrickSet(voPlaneOrientationScope::XY);
    PickGeometry geometry(size);
    for (const glm::dvec3& p : geometry.positions)
        geometry.addRecord({}, {p.x, p.y, p.z == 0 ? 2.5 : 12.5});
    PickCall call;
    call.view.projection = ortho(0, 16, 0, 16, -17, 1);
    for (const int pixel : {20, 31, 40}) {
        call.pixel[0] = pixel;
        const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
        ASSERT_EQ(result.records.size(), 11u);
        EXPECT_EQ(result.records.front()[2], 12.5f);
        EXPECT_EQ(result.records.back()[2], 2.5f);
    }
    expectNoError();
}

TEST(Pick, stacksAreSampledInTheirSlices)
{
    const VoxelSize size{12, 14, 16};
    const Field field = constantField(size, 0);
    PickVolume volume(size, 8, Type::UNSIGNED_BYTE, External::LUMINANCE, voInterpolationTypeScope::_2D);
    PickGeometry geometry(size);
    int stacks[4] = {0, 0, 0, 0};
    for (PickCall& call : randomCalls(size, 60, 21)) {
        std::fill_n(call.period, 3, 1.0f);
        const voPlaneOrientation across = voGeometryActions::findClosestAxisIndex(
            call.view.model.data(), call.view.projection.data(), voSamplingModeScope::AXIS_ALIGNED);
        volume.bricks.setCurrentBrickSet(across);
        const int axis = across == voPlaneOrientationScope::XY   ? 2
                         : across == voPlaneOrientationScope::XZ ? 1
                                                                 : 0;
        glm::dvec3 lower(0.5), upper(11.5, 13.5, 15.5);
        lower[axis] -= 0.5;
        upper[axis] += 0.5;
        const auto expected = expectedPoints(rayOf(call), planesOf(call, field, axis), lower, upper);
        if (!expected) continue;
        const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
        expectRecords(result, *expected);
        for (const std::vector<float>& r : result.records)
            EXPECT_EQ(r[std::size_t(axis)] - std::floor(r[std::size_t(axis)]), 0.5f);
        expectVoxels(result, volume, 0);
        if (!result.records.empty()) ++stacks[across];
    }
    for (const voPlaneOrientation stack :
         {voPlaneOrientationScope::XY, voPlaneOrientationScope::XZ, voPlaneOrientationScope::YZ})
        EXPECT_GT(stacks[stack], 3);
    expectNoError();
}

TEST(Pick, bricksOneByOneMakeTheSet)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 7);
    PickGeometry geometry(size);
    voBrickSet* set = volume.bricks.getCurrentBrickSet();
    for (PickCall& call : randomCalls(size, 50, 8)) {
        const PickResult all = call(geometry.tetras(), set);
        std::vector<std::vector<float>> pieces;
        for (int i = 0; i < set->getBrickCount(); ++i) {
            const PickResult part = call(geometry.tetras(), set->getBrick(i));
            EXPECT_EQ(part.hit, part.records.empty() ? VO_FALSE : VO_TRUE);
            expectVoxels(part, volume, 0);
            pieces.insert(pieces.end(), part.records.begin(), part.records.end());
        }
        EXPECT_TRUE(
            std::is_permutation(pieces.begin(), pieces.end(), all.records.begin(), all.records.end()));
    }
    expectNoError();
}

TEST(Pick, nearestSamplesAreKeptWhereRoomIsShort)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 7);
    PickGeometry geometry(size);
    PickCall call;
    call.view = orthographicView({20, 30}, size, kPixels, kPixels);
    PickResult all = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    ASSERT_GT(all.records.size(), 10u);
    call.capacity = 4;
    const PickResult some = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    EXPECT_EQ(some.hit, VO_TRUE);
    all.records.resize(4);
    EXPECT_EQ(some.records, all.records);
    expectNoError();
}

TEST(Pick, withoutAPeriodSurfacesAreAsManyAsThereIsRoom)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16, Type::UNSIGNED_BYTE, External::LUMINANCE, voInterpolationTypeScope::_3D, 0);
    PickGeometry geometry(size);
    int pixel[2] = {30, 20}, viewport[4] = {0, 0, kPixels, kPixels};
    View view;
    view.projection = ortho(0, 16, 0, 16, -17, 1);
    voVertexData coordinates(40, 3);
    EXPECT_EQ(voGeometryActions::pick(pixel, viewport, &geometry.tetras(), volume.bricks.getCurrentBrickSet(),
                                      Format::V3F, view.model.data(), view.projection.data(), NULL, VO_FALSE,
                                      &coordinates, NULL),
              VO_TRUE);
    ASSERT_EQ(coordinates.getCount(), 40);
    for (int i = 0; i < 40; ++i)
        EXPECT_NEAR(coordinates[i][2], 16 - (i + 0.5) * 16 / 40, 1e-5);
    expectNoError();
}

TEST(Pick, pixelsCountFromTheViewportsLowerLeftCorner)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    PickGeometry geometry(size);
    PickCall call;
    call.view.projection = ortho(0, 16, 0, 16, -17, 1);
    const int viewport[4] = {100, -7, 32, 16};
    std::copy_n(viewport, 4, call.viewport);
    call.pixel[0] = 100 + 9;
    call.pixel[1] = -7 + 4;
    const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    ASSERT_FALSE(result.records.empty());
    EXPECT_FLOAT_EQ(result.records[0][0], 9.5f / 2);
    EXPECT_FLOAT_EQ(result.records[0][1], 4.5f);
    EXPECT_GT(result.records.front()[2], result.records.back()[2]) << "the viewer looks along -z";
    expectNoError();
}

TEST(Pick, volumeOutsideTheViewVolumeIsNotSeen)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    PickGeometry geometry(size);
    PickCall call;
    // From the middle of the volume: what lies behind the near plane is not seen.
    call.view.model = translation(-8, -8, -8);
    call.view.projection = perspective(60, 1, 2, 100);
    const PickResult result = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    EXPECT_EQ(result.hit, VO_TRUE);
    for (const std::vector<float>& r : result.records)
        EXPECT_LE(r[2], 6.0f);
    call.view.model = multiply(rotation(180, 0, 1, 0), translation(-8, -8, 20));
    EXPECT_EQ(call(geometry.tetras(), volume.bricks.getCurrentBrickSet()).hit, VO_TRUE);
    call.view.model = translation(-8, -8, 20);
    const PickResult behind = call(geometry.tetras(), volume.bricks.getCurrentBrickSet());
    EXPECT_EQ(behind.hit, VO_FALSE);
    EXPECT_TRUE(behind.records.empty()) << "the count is 0 after a miss";
    expectNoError();
}

TEST(Pick, badArgumentsAreRefused)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    PickGeometry geometry(size);
    voBrickSet* set = volume.bricks.getCurrentBrickSet();
    PickCall call;
    call.view = orthographicView({20, 30}, size, kPixels, kPixels);
    const auto refused = [&](PickCall bad, const char* part) {
        const PickResult result = bad(geometry.tetras(), set);
        EXPECT_EQ(result.hit, VO_FALSE);
        EXPECT_EQ(result.records.size(), std::size_t(std::min(3, bad.capacity)))
            << "coordinates were touched";
        expectBadValue(part);
    };
    for (const auto& [x, y] : {std::pair(-1, 5), {kPixels, 5}, {5, -1}, {5, kPixels}}) {
        PickCall bad = call;
        bad.pixel[0] = x;
        bad.pixel[1] = y;
        const PickResult result = bad(geometry.tetras(), set);
        EXPECT_EQ(result.hit, VO_FALSE);
        expectBadValue("outside the viewport");
    }
    PickCall bad = call;
    bad.viewport[2] = 0;
    voVertexData coordinates(10, 3);
    float period[3] = {1, 1, 1};
    const auto pick = [&](int* pixel, int* viewport, voIndexedTetraSet* tetras, voBrickSet* bricks,
                          GLdouble* model, GLdouble* projection, voVertexData* c) {
        EXPECT_EQ(voGeometryActions::pick(pixel, viewport, tetras, bricks, Format::V3F, model, projection,
                                          period, VO_FALSE, c, NULL),
                  VO_FALSE);
    };
    GLdouble* model = call.view.model.data();
    GLdouble* projection = call.view.projection.data();
    voIndexedTetraSet* tetras = &geometry.tetras();
    pick(call.pixel, bad.viewport, tetras, set, model, projection, &coordinates);
    expectBadValue("viewport");
    pick(NULL, call.viewport, tetras, set, model, projection, &coordinates);
    expectBadValue("NULL");
    pick(call.pixel, NULL, tetras, set, model, projection, &coordinates);
    expectBadValue("NULL");
    pick(call.pixel, call.viewport, NULL, set, model, projection, &coordinates);
    expectBadValue("tetraSet is NULL");
    pick(call.pixel, call.viewport, tetras, NULL, model, projection, &coordinates);
    expectBadValue("brickSet is NULL");
    pick(call.pixel, call.viewport, tetras, set, NULL, projection, &coordinates);
    expectBadValue("matrix is NULL");
    pick(call.pixel, call.viewport, tetras, set, model, NULL, &coordinates);
    expectBadValue("matrix is NULL");
    pick(call.pixel, call.viewport, tetras, set, model, projection, NULL);
    expectBadValue("coordinates is NULL");
    GLdouble flat[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
    pick(call.pixel, call.viewport, tetras, set, flat, projection, &coordinates);
    expectBadValue("singular");
    voVertexData none(0, 3);
    pick(call.pixel, call.viewport, tetras, set, model, projection, &none);
    expectBadValue("no room");
    EXPECT_EQ(voGeometryActions::pick(call.pixel, call.viewport, tetras, static_cast<voBrick*>(NULL),
                                      Format::V3F, model, projection, period, VO_FALSE, &coordinates, NULL),
              VO_FALSE);
    expectBadValue("brick is NULL");

    PickCall wide = call;
    wide.values = 6;
    refused(wide, "coordinates has 6 values");
    PickCall colored = call;
    colored.format = Format::C4F_V3F;
    colored.values = 7;
    refused(colored, "the tetrahedra 3");
    PickCall stepless = call;
    stepless.period[1] = 0;
    refused(stepless, "samplingPeriod[1]");
    voAppearanceActions::dataFree(set);
    refused(call, "no voxels");
    PickCall unknown = call;
    unknown.format = static_cast<voInterleavedArrayType>(55);
    EXPECT_EQ(unknown(geometry.tetras(), set).hit, VO_FALSE);
    expectBadEnum();
}

TEST(Pick, voxelsOfTheGraphicsStateNeedAContext)
{
    const VoxelSize size{16, 16, 16};
    PickVolume volume(size, 16);
    PickGeometry geometry(size);
    PickCall call;
    call.view = orthographicView({20, 30}, size, kPixels, kPixels);
    call.drawn = VO_TRUE;
    EXPECT_EQ(call(geometry.tetras(), volume.bricks.getCurrentBrickSet()).hit, VO_FALSE);
    expectUnsupported("no OpenGL context");
    // Coordinates alone need none.
    voVertexData coordinates(100, 3);
    EXPECT_EQ(voGeometryActions::pick(call.pixel, call.viewport, &geometry.tetras(),
                                      volume.bricks.getCurrentBrickSet(), Format::V3F, call.view.model.data(),
                                      call.view.projection.data(), call.period, VO_TRUE, &coordinates, NULL),
              VO_TRUE);
    EXPECT_GT(coordinates.getCount(), 10);
    expectNoError();
}

} // namespace
