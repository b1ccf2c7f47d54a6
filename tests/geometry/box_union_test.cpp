#include "geometry/box_union.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

namespace {

using vo::Box;

/// Tetrahedra with vertices of their own.
struct Tetras
{
    std::vector<float> records;
    std::vector<int> indices;

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d)
    {
        for (const glm::dvec3& p : {a, b, c, d}) {
            indices.push_back(static_cast<int>(indices.size()));
            for (int axis = 0; axis < 3; ++axis)
                records.push_back(static_cast<float>(p[axis]));
        }
    }
    /// In five, or seen in a mirror along x.
    void addBox(const Box& box, bool mirrored = false)
    {
        static constexpr int kFive[5][4] = {
            {0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}};
        const auto corner = [&](int number) {
            if (mirrored) number ^= 1;
            return glm::dvec3(number & 1 ? box.upper.x : box.lower.x, number & 2 ? box.upper.y : box.lower.y,
                              number & 4 ? box.upper.z : box.lower.z);
        };
        for (const auto& t : kFive)
            add(corner(t[0]), corner(t[1]), corner(t[2]), corner(t[3]));
    }
    void addFlat(const Box& box)
    {
        const glm::dvec3 a = box.lower, b = box.upper;
        add(a, {b.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z});
        add(b, {b.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, a.y, b.z});
    }
    std::optional<vo::BoxUnion> boxes() const
    {
        vo::TetraView view;
        view.records = records;
        view.indices = indices;
        return vo::boxUnion(view);
    }
};

TEST(BoxUnion, coversWhatItsBoxesCoverWhereverTheyMeet)
{
    std::mt19937 random(4);
    for (int round = 0; round < 40; ++round) {
        // Columns of boxes of random heights: sides meet at any height, and diagonals do not match.
        Tetras tetras;
        constexpr int kSize = 6;
        bool held[kSize][kSize][kSize] = {};
        for (int y = 0; y < kSize; ++y)
            for (int x = 0; x < kSize; ++x)
                for (int z = 0; z < kSize;) {
                    const int end = std::min(kSize, z + 1 + static_cast<int>(random() % 3));
                    if (random() % 3 == 0) {
                        tetras.addBox({{x, y, z}, {x + 1, y + 1, end}}, random() % 2);
                        for (int k = z; k < end; ++k)
                            held[k][y][x] = true;
                    }
                    z = end;
                }
        tetras.addFlat({{0, 0, 0}, {kSize, kSize, kSize}});
        const std::optional<vo::BoxUnion> found = tetras.boxes();
        ASSERT_TRUE(found);
        EXPECT_EQ(found->bounds.lower, glm::dvec3(0));
        EXPECT_EQ(found->bounds.upper, glm::dvec3(kSize));
        for (int trial = 0; trial < 200; ++trial) {
            Box box;
            bool covered = true;
            for (int axis = 0; axis < 3; ++axis) {
                const int a = static_cast<int>(random() % kSize), b = static_cast<int>(random() % kSize);
                box.lower[axis] = std::min(a, b) + (random() % 2 ? 0.25 : 0.0);
                box.upper[axis] = std::max(a, b) + (random() % 2 ? 0.75 : 1.0);
            }
            for (int z = static_cast<int>(box.lower.z); z < box.upper.z; ++z)
                for (int y = static_cast<int>(box.lower.y); y < box.upper.y; ++y)
                    for (int x = static_cast<int>(box.lower.x); x < box.upper.x; ++x)
                        covered = covered && held[z][y][x];
            EXPECT_EQ(found->covers(box), covered);
        }
    }
}

TEST(BoxUnion, doesNotDependOnHandedness)
{
    Tetras tetras;
    tetras.addBox({{0, 0, 0}, {2, 3, 4}});
    tetras.addBox({{2, 1, 0}, {4, 2, 4}});
    for (std::size_t i = 0; i < tetras.indices.size(); i += 8)
        std::swap(tetras.indices[i], tetras.indices[i + 1]);
    const std::optional<vo::BoxUnion> found = tetras.boxes();
    ASSERT_TRUE(found);
    EXPECT_TRUE(found->covers({{0, 1, 0}, {4, 2, 4}}));
    EXPECT_FALSE(found->covers({{0, 1, 0}, {4, 2.5, 4}}));
}

TEST(BoxUnion, ofAnythingElseIsNone)
{
    const auto isNone = [](auto... boxes) {
        Tetras tetras;
        (tetras.addBox(boxes), ...);
        return !tetras.boxes();
    };
    EXPECT_TRUE(isNone());
    EXPECT_FALSE(isNone(Box{{0, 0, 0}, {1, 2, 3}}));
    EXPECT_FALSE(isNone(Box{{0, 0, 0}, {0.5, 2, 3}}));
    EXPECT_TRUE(isNone(Box{{0, 0, 0}, {0.3, 2, 3}}));
    EXPECT_TRUE(isNone(Box{{0, 0, 0}, {HUGE_VAL, 2, 3}}));
    EXPECT_TRUE(isNone(Box{{0, 0, 0}, {NAN, 2, 3}}));
    EXPECT_TRUE(isNone(Box{{0, 0, 0}, {4, 4, 4}}, Box{{3, 3, 3}, {5, 5, 5}})) << "overlap";
    EXPECT_TRUE(isNone(Box{{0, 0, 0}, {4, 4, 4}}, Box{{0, 0, 0}, {4, 4, 4}})) << "twice";
    Tetras one;
    one.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    EXPECT_FALSE(one.boxes());
    Tetras missing;
    missing.addBox({{0, 0, 0}, {2, 2, 2}});
    missing.indices.resize(16);
    EXPECT_FALSE(missing.boxes()) << "a corner is missing";
    Tetras flat;
    flat.addFlat({{0, 0, 0}, {1, 1, 1}});
    const std::optional<vo::BoxUnion> nothing = flat.boxes();
    ASSERT_TRUE(nothing);
    EXPECT_FALSE(nothing->covers({{0, 0, 0}, {1, 1, 1}}));
}

} // namespace
