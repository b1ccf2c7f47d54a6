#include "sort/brick_order.h"

#include "../polygonize/scenes.h"

#include <gtest/gtest.h>

#include <numeric>

using namespace scenes;

namespace {

struct Passage
{
    double enter;
    double leave;
};

/// Where a ray is inside a box; enter >= leave: nowhere.
Passage through(const vo::Box& box, const glm::dvec3& origin, const glm::dvec3& direction, bool fromOrigin)
{
    Passage passage{fromOrigin ? 0.0 : -1e300, 1e300};
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < box.lower[axis] || origin[axis] > box.upper[axis]) return {1, 0};
            continue;
        }
        double a = (box.lower[axis] - origin[axis]) / direction[axis];
        double b = (box.upper[axis] - origin[axis]) / direction[axis];
        if (a > b) std::swap(a, b);
        passage = {std::max(passage.enter, a), std::min(passage.leave, b)};
    }
    return passage;
}

class Rays
{
public:
    explicit Rays(unsigned seed) : random_(seed) {}

    double uniform(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    glm::dvec3 point(double low, double high)
    {
        const double x = uniform(low, high), y = uniform(low, high), z = uniform(low, high);
        return {x, y, z};
    }
    std::vector<double> seams(int intervals)
    {
        std::vector<double> result{uniform(-20, 20)};
        for (int i = 0; i < intervals; ++i)
            result.push_back(result.back() + uniform(0.5, 20));
        return result;
    }
    std::vector<vo::Box> lattice()
    {
        auto boxes = scenes::lattice(seams(count()), seams(count()), seams(count()));
        std::shuffle(boxes.begin(), boxes.end(), random_);
        return boxes;
    }
    int count() { return std::uniform_int_distribution<int>(1, 5)(random_); }

    void expectBackToFront(std::span<const vo::Box> boxes, const vo::Camera& camera, int rays)
    {
        const std::vector<int> order = vo::backToFront(boxes, camera);
        std::vector<std::size_t> place(boxes.size());
        ASSERT_EQ(order.size(), boxes.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            place[static_cast<std::size_t>(order[i])] = i;
        const vo::Box all = hull(boxes);
        for (int ray = 0; ray < rays; ++ray) {
            const glm::dvec3 target = all.lower + point(0, 1) * (all.upper - all.lower);
            const glm::dvec3 origin = camera.perspective ? camera.eye : target;
            const glm::dvec3 direction = camera.perspective ? target - camera.eye : camera.direction;
            expectOrderAlong(boxes, place, origin, direction, camera.perspective);
        }
    }

private:
    static void expectOrderAlong(std::span<const vo::Box> boxes, const std::vector<std::size_t>& place,
                                 const glm::dvec3& origin, const glm::dvec3& direction, bool fromOrigin)
    {
        std::vector<std::pair<double, std::size_t>> entered;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const Passage passage = through(boxes[i], origin, direction, fromOrigin);
            if (passage.leave - passage.enter > 1e-9) entered.emplace_back(passage.enter, place[i]);
        }
        std::sort(entered.begin(), entered.end());
        for (std::size_t i = 1; i < entered.size(); ++i)
            EXPECT_LT(entered[i].second, entered[i - 1].second) << "a box behind must come first";
    }

    std::mt19937 random_;
};

vo::Camera eyeAt(const glm::dvec3& eye)
{
    vo::Camera camera;
    camera.perspective = true;
    camera.eye = eye;
    return camera;
}

vo::Camera along(const glm::dvec3& direction)
{
    vo::Camera camera;
    camera.direction = camera.depthNormal = glm::normalize(direction);
    return camera;
}

} // namespace

TEST(BrickOrder, raysFromAnyEyeEnterBoxesInReverseOrder)
{
    Rays rays(1);
    for (int i = 0; i < 300; ++i) {
        const auto boxes = rays.lattice();
        rays.expectBackToFront(boxes, eyeAt(rays.point(-60, 120)), 40);
    }
}

TEST(BrickOrder, raysFromEyesInsideEnterBoxesInReverseOrder)
{
    Rays rays(2);
    for (int i = 0; i < 300; ++i) {
        const auto boxes = rays.lattice();
        const vo::Box& box = boxes[boxes.size() / 2];
        rays.expectBackToFront(boxes, eyeAt(box.lower + rays.point(0, 1) * (box.upper - box.lower)), 40);
        rays.expectBackToFront(boxes, eyeAt(box.lower), 40);
        rays.expectBackToFront(boxes, eyeAt(box.upper), 40);
    }
}

TEST(BrickOrder, parallelRaysEnterBoxesInReverseOrder)
{
    Rays rays(3);
    for (int i = 0; i < 300; ++i) {
        const auto boxes = rays.lattice();
        glm::dvec3 direction = rays.point(-1, 1);
        if (i % 3 == 0) direction[i % 2] = 0.0;
        if (i % 6 == 0) direction = {0, 0, i % 4 ? 1 : -1};
        rays.expectBackToFront(boxes, along(direction), 40);
    }
}

TEST(BrickOrder, latticesWithHolesAndGapsKeepTheOrder)
{
    Rays rays(4);
    for (int i = 0; i < 300; ++i) {
        auto boxes = rays.lattice();
        boxes.resize((boxes.size() + 1) / 2);
        for (vo::Box& box : boxes)
            box.upper -= 0.2;
        rays.expectBackToFront(boxes, eyeAt(rays.point(-40, 80)), 40);
        rays.expectBackToFront(boxes, along(rays.point(-1, 1)), 40);
    }
}

TEST(BrickOrder, veryDistantEyeOrdersLikeParallelRays)
{
    const auto boxes = bricks(3, 64);
    const glm::dvec3 direction = glm::normalize(glm::dvec3(1, -2, 3));
    EXPECT_EQ(vo::backToFront(boxes, eyeAt(-1e25 * direction)), vo::backToFront(boxes, along(direction)));
}

TEST(BrickOrder, isAPermutationAlsoOfEqualBoxes)
{
    std::vector<vo::Box> boxes(5, vo::Box{{0, 0, 0}, {1, 1, 1}});
    for (const vo::Camera& camera : {eyeAt({0.5, 0.5, 3}), along({1, 1, 1})}) {
        std::vector<int> order = vo::backToFront(boxes, camera);
        std::sort(order.begin(), order.end());
        EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 3, 4}));
    }
    EXPECT_TRUE(vo::backToFront({}, along({0, 0, 1})).empty());
}

TEST(BrickOrder, nearestOfTwoComesLast)
{
    const auto boxes = lattice({0, 1}, {0, 1}, {0, 1, 2});
    EXPECT_EQ(vo::backToFront(boxes, along({0, 0, -1})), (std::vector<int>{0, 1}));
    EXPECT_EQ(vo::backToFront(boxes, along({0, 0, 1})), (std::vector<int>{1, 0}));
    EXPECT_EQ(vo::backToFront(boxes, eyeAt({0, 0, 9})), (std::vector<int>{0, 1}));
    EXPECT_EQ(vo::backToFront(boxes, eyeAt({0, 0, -9})), (std::vector<int>{1, 0}));
}
