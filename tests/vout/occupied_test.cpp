// Boxes round what shows, against every voxel read one by one.
#include "tetra_checks.h"

#include "../legacy/expect_error.h"

#include <vo/AppearanceActions.h>
#include <vo/utOccupied.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <set>
#include <vector>

namespace {

using namespace vo::test;
using Place = std::array<int, 3>;

/// A volume of bytes in memory.
struct Bytes
{
    Place size{};
    std::vector<unsigned char> values;

    explicit Bytes(const Place& s, unsigned char value = 0)
        : size(s), values(std::size_t(s[0]) * std::size_t(s[1]) * std::size_t(s[2]), value)
    {
    }
    unsigned char& at(int x, int y, int z) { return values[std::size_t((z * size[1] + y) * size[0] + x)]; }
    unsigned char at(int x, int y, int z) const
    {
        return values[std::size_t((z * size[1] + y) * size[0] + x)];
    }
    template <typename Visit>
    void forEach(Visit visit) const
    {
        for (int z = 0; z < size[2]; ++z)
            for (int y = 0; y < size[1]; ++y)
                for (int x = 0; x < size[0]; ++x)
                    visit(x, y, z);
    }
};

/// Mostly nothing, with runs of anything.
Bytes randomBytes(const Place& size, std::mt19937& random)
{
    Bytes bytes(size);
    for (unsigned char& value : bytes.values)
        if (random() % 40 == 0) value = static_cast<unsigned char>(random() & 255u);
    return bytes;
}

std::unique_ptr<voBrickSetCollection>
bricksOf(const Bytes& bytes, const Place& brick, int overlap,
         voInternalFormatType internal = voInternalFormatTypeScope::INTENSITY8_EXT)
{
    auto volume = std::make_unique<voBrickSetCollection>(
        bytes.size[0], bytes.size[1], bytes.size[2], brick[0], brick[1], brick[2],
        voPartialBrickTypeScope::AUGMENT, overlap, internal, voExternalFormatTypeScope::LUMINANCE,
        voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    voBrickSet* set = volume->getCurrentBrickSet();
    voAppearanceActions::dataAlloc(set);
    voBrickSetIterator bricks(set);
    for (voBrick* each; (each = bricks());) {
        int x0, y0, z0, nx, ny, nz;
        each->getBrickSizes(x0, y0, z0, nx, ny, nz);
        auto* target = static_cast<unsigned char*>(each->getDataPtr());
        for (int z = z0; z < z0 + nz; ++z)
            for (int y = y0; y < y0 + ny; ++y)
                for (int x = x0; x < x0 + nx; ++x, ++target)
                    if (x < bytes.size[0] && y < bytes.size[1] && z < bytes.size[2])
                        *target = bytes.at(x, y, z);
    }
    return volume;
}

/// A table of 256 entries of which some are visible.
struct ByteTable
{
    std::array<bool, 256> visible{};
    std::vector<float> entries;
    std::unique_ptr<voLookupTable> table;

    explicit ByteTable(const std::function<bool(int)>& isVisible, bool pre = false)
    {
        for (int i = 0; i < 256; ++i) {
            visible[std::size_t(i)] = isVisible(i);
            entries.insert(entries.end(), {1.0f, visible[std::size_t(i)] ? 0.3f : 0.0f});
        }
        const GLenum internal = voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT,
                     external = voExternalFormatTypeScope::LUMINANCE_ALPHA, type = voDataTypeScope::FLOAT;
        if (pre)
            table = std::make_unique<voLookupTablePre>(internal, 256, external, type, entries.data());
        else
            table = std::make_unique<voLookupTablePost>(internal, 256, external, type, entries.data());
        table->load();
    }
    bool shows(int low, int high) const
    {
        return std::any_of(visible.begin() + low, visible.begin() + high + 1, [](bool v) { return v; });
    }
};

/// By the lowest and the highest voxel in a block and next to it.
std::set<Place> expectedBlocks(const Bytes& bytes, int side, const std::function<bool(int, int)>& shows)
{
    std::set<Place> blocks;
    const auto count = [&](std::size_t axis) { return (bytes.size[axis] + side - 1) / side; };
    for (int k = 0; k < count(2); ++k)
        for (int j = 0; j < count(1); ++j)
            for (int i = 0; i < count(0); ++i) {
                int low = 255, high = 0;
                bytes.forEach([&](int x, int y, int z) {
                    if (x < i * side - 1 || x > (i + 1) * side || y < j * side - 1 || y > (j + 1) * side ||
                        z < k * side - 1 || z > (k + 1) * side)
                        return;
                    low = std::min<int>(low, bytes.at(x, y, z));
                    high = std::max<int>(high, bytes.at(x, y, z));
                });
                if (shows(low, high)) blocks.insert({i, j, k});
            }
    return blocks;
}

std::set<Place> foundBlocks(const voutOccupied& occupied)
{
    std::set<Place> blocks;
    int nx = 0, ny = 0, nz = 0;
    occupied.getBlockCounts(nx, ny, nz);
    for (int k = -1; k <= nz; ++k)
        for (int j = -1; j <= ny; ++j)
            for (int i = -1; i <= nx; ++i)
                if (occupied.isOccupied(i, j, k)) blocks.insert({i, j, k});
    EXPECT_EQ(int(blocks.size()), occupied.getOccupiedCount());
    return blocks;
}

/// How many boxes hold each voxel.
std::vector<int> boxesRoundVoxels(const voutOccupied& occupied, const Bytes& bytes)
{
    std::vector<int> count(bytes.values.size(), 0);
    for (int box = 0; box < occupied.getBoxCount(); ++box) {
        float lower[3], upper[3];
        occupied.getBox(box, lower, upper);
        for (int z = int(lower[2]); z < int(upper[2]); ++z)
            for (int y = int(lower[1]); y < int(upper[1]); ++y)
                for (int x = int(lower[0]); x < int(upper[0]); ++x)
                    ++count[std::size_t((z * bytes.size[1] + y) * bytes.size[0] + x)];
    }
    return count;
}

/// Faces of voxels in boxes whose neighbour is in none.
double surfaceOf(const std::vector<int>& held, const Bytes& bytes)
{
    double area = 0;
    const auto isHeld = [&](int x, int y, int z) {
        const bool inside =
            x >= 0 && y >= 0 && z >= 0 && x < bytes.size[0] && y < bytes.size[1] && z < bytes.size[2];
        return inside && held[std::size_t((z * bytes.size[1] + y) * bytes.size[0] + x)] > 0;
    };
    bytes.forEach([&](int x, int y, int z) {
        if (!isHeld(x, y, z)) return;
        for (const int step : {-1, 1})
            area += !isHeld(x + step, y, z) + !isHeld(x, y + step, z) + !isHeld(x, y, z + step);
    });
    return area;
}

/// Takes the two that hold the volume's corners away; false where they are not there.
bool takeFlatOnes(Tetras& tetras, const Place& size)
{
    if (tetras.corners.size() < 2) return false;
    std::set<std::array<double, 3>> corners;
    for (std::size_t i = tetras.corners.size() - 2; i < tetras.corners.size(); ++i) {
        Tetras one = tetras;
        one.corners = {tetras.corners[i]};
        if (volumeOf(one) != 0) return false;
        for (const int corner : tetras.corners[i]) {
            const glm::dvec3 p = tetras.position(corner);
            corners.insert({p.x, p.y, p.z});
        }
    }
    for (int corner = 0; corner < 8; ++corner)
        EXPECT_TRUE(corners.contains({corner & 1 ? double(size[0]) : 0, corner & 2 ? double(size[1]) : 0,
                                      corner & 4 ? double(size[2]) : 0}));
    tetras.corners.resize(tetras.corners.size() - 2);
    return true;
}

/// Boxes hold each voxel of the blocks once, and their tetrahedra fill them, face to face.
void expectBoxesOf(voutOccupied& occupied, const Bytes& bytes, const std::set<Place>& blocks, int side)
{
    EXPECT_EQ(foundBlocks(occupied), blocks);
    const std::vector<int> held = boxesRoundVoxels(occupied, bytes);
    double volume = 0;
    bytes.forEach([&](int x, int y, int z) {
        const bool needed = blocks.contains({x / side, y / side, z / side});
        volume += needed;
        ASSERT_EQ(held[std::size_t((z * bytes.size[1] + y) * bytes.size[0] + x)], needed)
            << x << ' ' << y << ' ' << z;
    });
    EXPECT_DOUBLE_EQ(occupied.getCoveredFraction(), volume / double(bytes.values.size()));
    Tetras tetras = taken(occupied.tessellate());
    EXPECT_EQ(takeFlatOnes(tetras, bytes.size), volume > 0 && volume < double(bytes.values.size()));
    if (volume == 0) {
        EXPECT_TRUE(tetras.corners.empty());
        return;
    }
    EXPECT_EQ(wrongHandedness(tetras), "");
    EXPECT_EQ(unmatchedFaces(tetras), "");
    EXPECT_NEAR(volumeOf(tetras), volume, 1e-6 * volume);
    // A face inside that does not match, vertex for vertex, would count as surface.
    const double area = surfaceOf(held, bytes);
    EXPECT_NEAR(areaOf(tetras), area, 1e-6 * area);
    if (tetras.corners.size() < 200) {
        EXPECT_EQ(overlaps(tetras), "");
    }
}

/// All that a table shows is inside, and so are its neighbours.
void expectSkirt(const voutOccupied& occupied, const Bytes& bytes, const ByteTable& table)
{
    const std::vector<int> held = boxesRoundVoxels(occupied, bytes);
    bytes.forEach([&](int x, int y, int z) {
        if (!table.visible[bytes.at(x, y, z)]) return;
        bytes.forEach([&](int i, int j, int k) {
            if (std::max({std::abs(i - x), std::abs(j - y), std::abs(k - z)}) > 1) return;
            EXPECT_EQ(held[std::size_t((k * bytes.size[1] + j) * bytes.size[0] + i)], 1)
                << i << ' ' << j << ' ' << k;
        });
    });
}

int readBytes(const int origin[3], const int size[3], double* values, void* user)
{
    const Bytes& bytes = *static_cast<const Bytes*>(user);
    for (int z = origin[2]; z < origin[2] + size[2]; ++z)
        for (int y = origin[1]; y < origin[1] + size[1]; ++y)
            for (int x = origin[0]; x < origin[0] + size[0]; ++x)
                *values++ = bytes.at(x, y, z);
    return 0;
}

int readParts(const int origin[3], const int size[3], double* values, void* user)
{
    readBytes(origin, size, values, user);
    for (int i = 0; i < size[0] * size[1] * size[2]; ++i)
        values[i] /= 255;
    return 0;
}

Place randomSize(std::mt19937& random)
{
    const auto length = [&] { return 1 + int(random() % 17); };
    return {length(), length(), length()};
}

TEST(VoutOccupied, holdsWhatATableShowsAndItsSkirt)
{
    std::mt19937 random(5);
    for (int round = 0; round < 60; ++round) {
        SCOPED_TRACE(round);
        Bytes bytes = randomBytes(randomSize(random), random);
        const int side = 1 + int(random() % 6);
        const auto first = int(random() % 200), last = first + int(random() % 60);
        const ByteTable table([&](int i) { return i >= first && i <= last; }, round % 2 == 0);
        const auto volume = bricksOf(bytes, bytes.size, 0);
        const auto shows = [&](int low, int high) { return table.shows(low, high); };
        const std::set<Place> blocks = expectedBlocks(bytes, side, shows);
        voutOccupied occupied(volume.get(), table.table.get(), side);
        expectBoxesOf(occupied, bytes, blocks, side);
        expectSkirt(occupied, bytes, table);
        voutOccupied read(bytes.size.data(), readParts, &bytes, table.table.get(), side);
        EXPECT_EQ(foundBlocks(read), blocks);
        occupied.setMerged(VO_FALSE);
        EXPECT_EQ(occupied.getBoxCount(), int(blocks.size()));
        expectBoxesOf(occupied, bytes, blocks, side);
    }
    expectNoError();
}

TEST(VoutOccupied, bricksChangeNothingButWhereTheyArePadded)
{
    std::mt19937 random(6);
    for (int round = 0; round < 30; ++round) {
        SCOPED_TRACE(round);
        const Bytes bytes = randomBytes({13, 9, 17}, random);
        const int side = 1 + int(random() % 6);
        const ByteTable table([](int i) { return i > 20 && i < 140; });
        const auto shows = [&](int low, int high) { return table.shows(low, high); };
        const std::set<Place> blocks = expectedBlocks(bytes, side, shows);
        // 13, 9 and 17 are 1 + a multiple of 4: with an overlap of 1 bricks of 5 fill them.
        const auto fitting = bricksOf(bytes, {5, 5, 5}, 1);
        EXPECT_EQ(foundBlocks(voutOccupied(fitting.get(), table.table.get(), side)), blocks);
        const auto padded = bricksOf(bytes, {4, 6, 7}, round % 3);
        const voutOccupied more(padded.get(), table.table.get(), side);
        EXPECT_TRUE(std::ranges::includes(foundBlocks(more), blocks));
        expectSkirt(more, bytes, table);
    }
    expectNoError();
}

TEST(VoutOccupied, intervalsCountTheirEnds)
{
    std::mt19937 random(7);
    for (int round = 0; round < 20; ++round) {
        Bytes bytes = randomBytes(randomSize(random), random);
        const int side = 1 + int(random() % 5), low = int(random() % 250), high = low + int(random() % 4);
        const std::set<Place> blocks =
            expectedBlocks(bytes, side, [&](int least, int most) { return least <= high && most >= low; });
        voutOccupied read(bytes.size.data(), readBytes, &bytes, double(low), double(high), side);
        EXPECT_EQ(foundBlocks(read), blocks);
        const auto volume = bricksOf(bytes, bytes.size, 0);
        const voutOccupied bricks(volume.get(), (float(low) - 0.5f) / 255, (float(high) + 0.5f) / 255, side);
        EXPECT_EQ(foundBlocks(bricks), blocks);
    }
    expectNoError();
}

TEST(VoutOccupied, fullVolumeIsOneBox)
{
    const Bytes bytes({12, 9, 20}, 7);
    const auto volume = bricksOf(bytes, bytes.size, 0);
    for (const int side : {1, 4, 8, 100, 2000000000}) {
        voutOccupied occupied(volume.get(), NULL, side);
        EXPECT_EQ(occupied.getBoxCount(), 1);
        EXPECT_EQ(occupied.getCoveredFraction(), 1);
        const Tetras tetras = taken(occupied.tessellate());
        EXPECT_EQ(tetras.corners.size(), 6u);
        EXPECT_EQ(tetras.records.size(), 8u);
        expectSolid(tetras, 12 * 9 * 20, 2 * (12 * 9 + 9 * 20 + 20 * 12));
    }
}

TEST(VoutOccupied, anLIsTwoBoxesHoweverItLies)
{
    // Two bars that meet at a corner of the volume, deep inside a block each, so that none has a skirt
    // beyond.
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (const bool mirrored : {false, true}) {
            Bytes bytes({30, 30, 30});
            const auto set = [&](int along, int other) {
                Place p{5, 5, 5};
                p[axis] = mirrored ? 29 - along : along;
                p[(axis + 1) % 3] = other;
                bytes.at(p[0], p[1], p[2]) = 255;
            };
            for (const int i : {5, 15, 25})
                set(i, 5);
            set(5, 15);
            const auto volume = bricksOf(bytes, bytes.size, 0);
            voutOccupied occupied(volume.get(), NULL, 10);
            EXPECT_EQ(occupied.getOccupiedCount(), 4);
            EXPECT_EQ(occupied.getBoxCount(), 2);
            expectBoxesOf(occupied, bytes, foundBlocks(occupied), 10);
        }
}

TEST(VoutOccupied, ofNothingIsAnEmptySet)
{
    const Bytes bytes({12, 9, 20});
    const auto volume = bricksOf(bytes, bytes.size, 0);
    const ByteTable table([](int i) { return i > 0; });
    voutOccupied occupied(volume.get(), table.table.get());
    EXPECT_EQ(occupied.getBoxCount(), 0);
    EXPECT_EQ(occupied.getOccupiedCount(), 0);
    EXPECT_EQ(occupied.getCoveredFraction(), 0);
    const std::unique_ptr<voIndexedTetraSet> tetras(occupied.tessellate());
    ASSERT_NE(tetras, nullptr);
    EXPECT_EQ(tetras->getIndices()->getCount(), 0);
    expectNoError();
}

TEST(VoutOccupied, oneVoxelIsABox)
{
    for (const int value : {0, 1}) {
        const Bytes bytes({1, 1, 1}, static_cast<unsigned char>(value));
        const auto volume = bricksOf(bytes, bytes.size, 0);
        voutOccupied occupied(volume.get());
        EXPECT_EQ(occupied.getBoxCount(), value);
        const Tetras tetras = taken(occupied.tessellate());
        if (value) expectSolid(tetras, 1, 6);
    }
    expectNoError();
}

TEST(VoutOccupied, withoutATableGoesByWhatTexturesShow)
{
    Bytes bytes({16, 16, 16});
    bytes.at(3, 3, 3) = 1;
    EXPECT_EQ(voutOccupied(bricksOf(bytes, bytes.size, 0).get()).getOccupiedCount(), 1);
    const auto opaque = bricksOf(bytes, bytes.size, 0, voInternalFormatTypeScope::LUMINANCE8_EXT);
    EXPECT_EQ(voutOccupied(opaque.get()).getOccupiedCount(), 8);
    const ByteTable table([](int i) { return i == 1; });
    EXPECT_EQ(voutOccupied(opaque.get(), table.table.get()).getOccupiedCount(), 1);

    const auto colours = [](voInternalFormatType internal) {
        auto volume = std::make_unique<voBrickSetCollection>(
            16, 16, 16, 16, 16, 16, voPartialBrickTypeScope::AUGMENT, 0, internal,
            voExternalFormatTypeScope::RGBA, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
        auto* voxels =
            static_cast<unsigned char*>(voAppearanceActions::dataAlloc(volume->getCurrentBrickSet()));
        std::fill_n(voxels, 4 * 4096, static_cast<unsigned char>(0));
        voxels[0] = 200; // a red voxel without alpha
        voxels[4 * 4095 + 3] = 1;
        return volume;
    };
    const auto rgba = colours(voInternalFormatTypeScope::RGBA8_EXT);
    const voutOccupied byAlpha(rgba.get());
    EXPECT_EQ(byAlpha.getOccupiedCount(), 1);
    EXPECT_TRUE(byAlpha.isOccupied(1, 1, 1));
    EXPECT_EQ(voutOccupied(colours(voInternalFormatTypeScope::RGB8_EXT).get()).getOccupiedCount(), 8);
    expectNoError();
}

int failToRead(const int[3], const int[3], double*, void*)
{
    return 3;
}

TEST(VoutOccupied, mistakesAreReportedAndGiveNothing)
{
    Bytes bytes({4, 4, 4}, 9);
    const auto volume = bricksOf(bytes, bytes.size, 0);
    const auto expectNone = [](voutOccupied&& occupied, const char* why) {
        expectBadValue(why);
        EXPECT_EQ(occupied.getBoxCount(), 0);
        EXPECT_EQ(occupied.getCoveredFraction(), 0);
        int nx = 7, ny = 7, nz = 7;
        occupied.getBlockCounts(nx, ny, nz);
        EXPECT_EQ(nx + ny + nz, 0);
        EXPECT_FALSE(occupied.isOccupied(0, 0, 0));
        occupied.setMerged(VO_FALSE);
        expectNoError();
        EXPECT_EQ(occupied.tessellate(), nullptr);
        expectBadValue("no volume");
    };
    expectNone(voutOccupied(NULL, NULL, 8), "volume");
    expectNone(voutOccupied(volume.get(), NULL, 0), "0 voxels a side");
    expectNone(voutOccupied(volume.get(), 0.5f, 0.4f, 8), "values from");
    expectNone(voutOccupied(volume.get(), NAN, 1.0f, 8), "values from");
    expectNone(voutOccupied(bytes.size.data(), NULL, NULL, NULL), "read");
    expectNone(voutOccupied(static_cast<const int*>(NULL), readBytes, &bytes, NULL), "sizes");
    expectNone(voutOccupied(bytes.size.data(), failToRead, NULL, NULL), "answered 3");
    const int flat[3] = {4, 0, 4}, large[3] = {3000, 3000, 3000};
    expectNone(voutOccupied(flat, readBytes, &bytes, NULL), "0 voxels along");
    expectNone(voutOccupied(large, readBytes, &bytes, NULL, 2), "blocks");
    voLookupTablePost unloaded(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                               GLenum{voExternalFormatTypeScope::RGBA}, GLenum{voDataTypeScope::FLOAT});
    expectNone(voutOccupied(volume.get(), &unloaded), "not loaded");
    voBrickSetCollection noVoxels(
        4, 4, 4, 4, 4, 4, voPartialBrickTypeScope::AUGMENT, 0, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    expectNone(voutOccupied(&noVoxels), "no voxels");

    const voutOccupied one(volume.get());
    float lower[3] = {9, 9, 9}, upper[3] = {9, 9, 9};
    one.getBox(1, lower, upper);
    expectBadValue("box 1 of 1");
    one.getBox(-1, lower, upper);
    expectBadValue("box -1");
    one.getBox(0, NULL, upper);
    expectBadValue("lower");
    EXPECT_EQ(lower[0], 9);
    noVoxels.getCurrentBrickSet()->getBrick(0)->setBrickSizes(0.5f, 0, 0, 4, 4, 4);
    expectNone(voutOccupied(&noVoxels), "whole voxels");
    EXPECT_NE(voAppearanceActions::volumeFindRanges(volume.get(), 4, NULL), 0);
    expectBadValue("ranges");
}

} // namespace
