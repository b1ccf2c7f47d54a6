#include "polygonize/reformat.h"

#include "exact_section.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

using namespace scenes;

namespace {

constexpr double kSize = 32;
const vo::RecordLayout kPlain{3, -1, -1, 0};
const vo::RecordLayout kColors{7, -1, 0, 4};

struct Plane
{
    glm::dvec3 normal;
    double offset;

    glm::dvec4 equation() const { return {normal, -offset}; }
};

Plane randomPlane(std::mt19937& random)
{
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> inside(0.2 * kSize, 0.8 * kSize);
    const glm::dvec3 n(normal(random), normal(random), normal(random));
    return {n, glm::dot(n, glm::dvec3(inside(random), inside(random), inside(random)))};
}

std::vector<Face> cutUp(const vo::CutPolygon& polygon, std::span<const vo::Box> boxes, int stackAxis,
                        const vo::RecordLayout& layout)
{
    vo::BoxCutter cutter;
    Faces faces(layout.values);
    EXPECT_TRUE(vo::reformat(polygon, {boxes, stackAxis, layout}, cutter, faces));
    return faces.all;
}

std::vector<Face> cutPlane(const Plane& plane, std::span<const vo::Box> boxes, int stackAxis,
                           const vo::RecordLayout& layout)
{
    return cutUp(vo::planeThroughBoxes(plane.equation(), boxes, layout), boxes, stackAxis, layout);
}

/// Clip boxes of `size` slices across an axis, each of two bricks a side that meet at 12.5.
std::vector<vo::Box> stack(int axis, double size)
{
    std::vector<std::vector<double>> seams(3, {0.5, 12.5, kSize - 0.5});
    auto& slices = seams[static_cast<std::size_t>(axis)];
    slices.clear();
    for (int i = 0; i <= size; ++i)
        slices.push_back(i);
    return lattice(seams[0], seams[1], seams[2]);
}

/// The weights of a point in a polygon's corners when it lies inside, by a fan of triangles; else empty.
std::vector<double> weightsOf(const Face& face, const glm::dvec3& p)
{
    const glm::dvec3 across = face.area();
    for (int i = 1; i + 1 < face.count(); ++i) {
        const glm::dvec3 a = face.point(0), b = face.point(i), c = face.point(i + 1);
        const double whole = glm::dot(across, glm::cross(b - a, c - a));
        if (!(whole > 0)) continue;
        const double wb = glm::dot(across, glm::cross(p - a, c - a)) / whole;
        const double wc = glm::dot(across, glm::cross(b - a, p - a)) / whole;
        if (wb < 0 || wc < 0 || wb + wc > 1) continue;
        std::vector<double> weights(static_cast<std::size_t>(face.count()));
        weights[0] = 1 - wb - wc;
        weights[static_cast<std::size_t>(i)] = wb;
        weights[static_cast<std::size_t>(i) + 1] = wc;
        return weights;
    }
    return {};
}

double valueAt(const Face& face, const std::vector<double>& weights, int column)
{
    double sum = 0;
    for (int i = 0; i < face.count(); ++i)
        sum += weights[static_cast<std::size_t>(i)] *
               double(face.records[static_cast<std::size_t>(i * face.values + column)]);
    return sum;
}

double areaOf(const std::vector<Face>& faces)
{
    double sum = 0;
    for (const Face& face : faces)
        sum += glm::length(face.area());
    return sum;
}

TEST(Reformat, partsOfAPlaneAddUpToItsSection)
{
    std::mt19937 random(1);
    for (const int perAxis : {1, 2, 3}) {
        const auto boxes = bricks(perAxis, kSize);
        for (int i = 0; i < 50; ++i) {
            const Plane plane = randomPlane(random);
            const std::vector<Face> faces = cutPlane(plane, boxes, -1, kPlain);
            const exact::Section section(plane.normal, plane.offset);
            EXPECT_NEAR(areaOf(faces), exact::boxSectionArea(hull(boxes), section), 1e-3);
            for (const Face& face : faces) {
                EXPECT_GT(glm::dot(face.area(), plane.normal), 0.0);
                for (int v = 0; v < face.count(); ++v)
                    for (int axis = 0; axis < 3; ++axis) {
                        EXPECT_GE(face.position(v)[axis], boxes[std::size_t(face.brick)].lower[axis]);
                        EXPECT_LE(face.position(v)[axis], boxes[std::size_t(face.brick)].upper[axis]);
                    }
            }
        }
    }
}

TEST(Reformat, everyPointOfAPlaneIsYieldedOnce)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<double> inside(0.5, kSize - 0.5);
    const auto boxes = bricks(3, kSize);
    int points = 0;
    for (int i = 0; i < 40; ++i) {
        const Plane plane = randomPlane(random);
        const std::vector<Face> faces = cutPlane(plane, boxes, -1, kPlain);
        for (int j = 0; j < 50; ++j) {
            glm::dvec3 p(inside(random), inside(random), inside(random));
            p -= plane.normal *
                 ((glm::dot(plane.normal, p) - plane.offset) / glm::dot(plane.normal, plane.normal));
            if (glm::any(glm::lessThan(p, glm::dvec3(0.5))) ||
                glm::any(glm::greaterThan(p, glm::dvec3(kSize - 0.5))))
                continue;
            int times = 0;
            for (const Face& face : faces)
                times += !weightsOf(face, p).empty();
            EXPECT_EQ(times, 1);
            ++points;
        }
    }
    EXPECT_GT(points, 500);
}

TEST(Reformat, seamsAndOuterFacesAreYieldedOnce)
{
    const auto boxes = bricks(3, kSize);
    const double full = (kSize - 1) * (kSize - 1);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0})
            for (const double noise : {0.0, 1e-9, -1e-9}) {
                glm::dvec3 normal(0);
                normal[axis] = sign;
                for (const vo::Box& box : boxes)
                    for (const double place : {box.lower[axis], box.upper[axis]})
                        EXPECT_NEAR(areaOf(cutPlane({normal, sign * place + noise}, boxes, -1, kPlain)), full,
                                    1e-3);
                EXPECT_TRUE(cutPlane({normal, sign * 0.49}, boxes, -1, kPlain).empty());
                EXPECT_TRUE(cutPlane({normal, sign * (kSize - 0.49)}, boxes, -1, kPlain).empty());
            }
}

TEST(Reformat, weightsOfAStackAreThoseOfLinearInterpolation)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> inside(0.5, kSize - 0.5);
    int points = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const auto boxes = stack(axis, kSize);
        for (int i = 0; i < 20; ++i) {
            const Plane plane = randomPlane(random);
            const std::vector<Face> faces = cutPlane(plane, boxes, axis, kColors);
            for (int j = 0; j < 30; ++j) {
                glm::dvec3 p(inside(random), inside(random), inside(random));
                p -= plane.normal *
                     ((glm::dot(plane.normal, p) - plane.offset) / glm::dot(plane.normal, plane.normal));
                glm::dvec3 low(0.5), high(kSize - 0.5);
                low[axis] = 0, high[axis] = kSize;
                if (glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high))) continue;
                std::map<int, double> found; // weight by slice
                for (const Face& face : faces) {
                    const std::vector<double> corners = weightsOf(face, p);
                    if (corners.empty()) continue;
                    const vo::Box& box = boxes[std::size_t(face.brick)];
                    EXPECT_TRUE(found.emplace(int(box.lower[axis]), valueAt(face, corners, 3)).second);
                    for (int channel = 0; channel < 3; ++channel)
                        EXPECT_EQ(valueAt(face, corners, channel), valueAt(face, corners, 3));
                    for (int other = 0; other < 3; ++other)
                        if (other != axis) {
                            EXPECT_GE(p[other], box.lower[other] - 1e-4);
                            EXPECT_LE(p[other], box.upper[other] + 1e-4);
                        }
                }
                const double place = std::clamp(p[axis] - 0.5, 0.0, kSize - 1);
                double sum = 0;
                for (const auto& [slice, weight] : found) {
                    EXPECT_NEAR(weight, std::max(0.0, 1 - std::abs(slice - place)), 1e-4);
                    sum += weight;
                }
                EXPECT_NEAR(sum, 1.0, 1e-6);
                ++points;
            }
        }
    }
    EXPECT_GT(points, 500);
}

TEST(Reformat, planesAlongASliceTakeTheSlicesBesideThem)
{
    const auto boxes = stack(2, kSize);
    const auto weights = [&](double z) {
        std::map<int, double> found;
        double area = 0;
        for (const Face& face : cutPlane({{0, 0, 1}, z}, boxes, 2, kColors)) {
            const int slice = int(boxes[std::size_t(face.brick)].lower.z);
            found[slice] = double(face.records[3]);
            area += glm::length(face.area()) * double(face.records[3]);
        }
        EXPECT_NEAR(area, (kSize - 1) * (kSize - 1), 1e-3) << z;
        return found;
    };
    using Weights = std::map<int, double>;
    EXPECT_EQ(weights(0.0), (Weights{{0, 1.0}}));
    EXPECT_EQ(weights(0.25), (Weights{{0, 1.0}}));
    EXPECT_EQ(weights(0.5), (Weights{{0, 1.0}}));
    EXPECT_EQ(weights(0.75), (Weights{{0, 0.75}, {1, 0.25}}));
    EXPECT_EQ(weights(1.0), (Weights{{0, 0.5}, {1, 0.5}}));
    EXPECT_EQ(weights(7.5), (Weights{{7, 1.0}}));
    EXPECT_EQ(weights(31.5), (Weights{{31, 1.0}}));
    EXPECT_EQ(weights(32.0), (Weights{{31, 1.0}}));
    EXPECT_TRUE(cutPlane({{0, 0, 1}, 32.01}, boxes, 2, kColors).empty());
    const auto single = stack(2, 1);
    const std::vector<Face> alone = cutPlane({{0, 0, 1}, 0.3}, single, 2, kColors);
    EXPECT_NEAR(areaOf(alone), (kSize - 1) * (kSize - 1), 1e-3);
    EXPECT_EQ(alone[0].records[3], 1.0f);
}

vo::CutPolygon polygonOf(const std::vector<glm::dvec3>& points)
{
    vo::CutPolygon polygon;
    polygon.clear(3);
    for (const glm::dvec3& p : points)
        std::copy_n(&p.x, 3, polygon.grow());
    return polygon;
}

TEST(Reformat, colorsOfAPolygonAreMultipliedByTheWeights)
{
    vo::CutPolygon polygon;
    polygon.clear(7);
    for (const glm::dvec3& p : {glm::dvec3(2, 2, 2), {20, 2, 8}, {20, 20, 8}, {2, 20, 2}}) {
        const double record[] = {0.5, 0.25, 1, 0.75, p.x, p.y, p.z};
        polygon.push(record);
    }
    const auto boxes = stack(2, kSize);
    double area = 0;
    for (const Face& face : cutUp(polygon, boxes, 2, kColors))
        for (int i = 0; i < face.count(); ++i) {
            const float* record = face.records.data() + i * 7;
            const double middle = boxes[std::size_t(face.brick)].lower.z + 0.5;
            const double weight = 1 - std::abs(double(record[6]) - middle);
            EXPECT_NEAR(record[0], 0.5 * weight, 1e-6);
            EXPECT_NEAR(record[1], 0.25 * weight, 1e-6);
            EXPECT_NEAR(record[2], weight, 1e-6);
            EXPECT_NEAR(record[3], 0.75 * weight, 1e-6);
            area += weight * glm::length(face.area()) / face.count();
        }
    // Every part's weights rise from 0 to 1 in one direction, so their mean is not exactly a half.
    EXPECT_NEAR(area, 18 * std::hypot(18.0, 6.0), 0.15 * 18 * 18);
}

TEST(Reformat, boxesCutVoxelCoordinatesWhereThereAreAny)
{
    const vo::RecordLayout layout{6, 0, -1, 0};
    vo::CutPolygon polygon;
    polygon.clear(6, 0);
    // A unit square far away shows the plane z = 10 of the volume.
    for (const glm::dvec3& p : {glm::dvec3(0, 0, 0), {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) {
        const double record[] = {kSize * p.x, kSize * p.y, 10, p.x + 100, p.y + 100, p.z};
        polygon.push(record);
    }
    const auto boxes = bricks(3, kSize);
    const std::vector<Face> faces = cutUp(polygon, boxes, -1, layout);
    EXPECT_EQ(faces.size(), 9u);
    EXPECT_NEAR(areaOf(faces), (kSize - 1) * (kSize - 1) / kSize / kSize, 1e-4);
}

TEST(ConvexParts, concavePolygonsBecomeTrianglesOfTheSameArea)
{
    const auto areaOfParts = [](const std::vector<vo::CutPolygon>& parts) {
        glm::dvec3 sum(0);
        for (const vo::CutPolygon& part : parts)
            for (int i = 1; i + 1 < part.count; ++i) {
                const auto at = [&](int v) {
                    return glm::dvec3(part.position(v)[0], part.position(v)[1], part.position(v)[2]);
                };
                const glm::dvec3 twice = glm::cross(at(i) - at(0), at(i + 1) - at(0));
                EXPECT_GE(twice.z, 0);
                sum += 0.5 * twice;
            }
        return sum.z;
    };
    const auto square =
        vo::convexParts(polygonOf({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {4, 4, 1}, {0, 4, 1}, {0, 2, 1}}));
    ASSERT_TRUE(square);
    EXPECT_EQ(square->size(), 1u);
    EXPECT_EQ(square->front().count, 5);
    const auto corner =
        vo::convexParts(polygonOf({{0, 0, 1}, {4, 0, 2}, {4, 2, 2}, {2, 2, 1.5}, {2, 4, 1.5}, {0, 4, 1}}));
    ASSERT_TRUE(corner);
    EXPECT_EQ(corner->size(), 4u);
    EXPECT_NEAR(areaOfParts(*corner), 12, 1e-12);
    // A star of ten corners, seen either way round.
    std::vector<glm::dvec3> star;
    for (int i = 0; i < 10; ++i)
        star.push_back(
            {(i % 2 ? 1 : 3) * std::cos(i * 0.2 * M_PI), (i % 2 ? 1 : 3) * std::sin(i * 0.2 * M_PI), 0});
    const auto parts = vo::convexParts(polygonOf(star));
    ASSERT_TRUE(parts);
    EXPECT_NEAR(areaOfParts(*parts), 10 * 0.5 * 3 * std::sin(0.2 * M_PI), 1e-12);
    std::reverse(star.begin(), star.end());
    EXPECT_EQ(vo::convexParts(polygonOf(star))->size(), 8u);
}

TEST(ConvexParts, crossingEdgesAndNoAreaGiveNothing)
{
    std::vector<glm::dvec3> pentagram;
    for (int i = 0; i < 5; ++i)
        pentagram.push_back({std::cos(i * 0.8 * M_PI), std::sin(i * 0.8 * M_PI), 0});
    EXPECT_FALSE(vo::convexParts(polygonOf(pentagram)));
    EXPECT_FALSE(vo::convexParts(polygonOf({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {5, 4, 0}})));
    // Ears could be cut off these all the same.
    EXPECT_FALSE(vo::convexParts(polygonOf({{4, 3, 0}, {4, 0, 0}, {0, 5, 0}, {6, 0, 0}, {3, 2, 0}})));
    EXPECT_FALSE(
        vo::convexParts(polygonOf({{0, 3, 0}, {0, 0, 0}, {4, 6, 0}, {1, 6, 0}, {1, 2, 0}, {3, 4, 0}})));
    EXPECT_TRUE(vo::convexParts(polygonOf({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}))->empty());
    EXPECT_TRUE(vo::convexParts(polygonOf({{0, 0, 0}, {1, 1, 1}}))->empty());
    EXPECT_TRUE(vo::convexParts(polygonOf({{0, 0, 0}, {std::nan(""), 1, 1}, {2, 0, 2}}))->empty());
}

} // namespace
