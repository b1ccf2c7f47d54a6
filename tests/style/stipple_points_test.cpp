#include "style/stipple_points.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <tuple>

namespace {

using vo::StippleFactors;
using vo::StyledScene;

/// Luminance of a place in the box.
template <class Value>
std::shared_ptr<vo::VoxelTexture> voxelsOf(int size, const Value& value)
{
    auto texture = std::make_shared<vo::VoxelTexture>();
    texture->size = {size, size, size};
    texture->kind = vo::TexelKind::float32;
    std::vector<float> texels;
    for (int z = 0; z < size; ++z)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                texels.push_back(
                    static_cast<float>(value((x + 0.5) / size, (y + 0.5) / size, (z + 0.5) / size)));
    texture->texels.resize(texels.size() * sizeof(float));
    std::memcpy(texture->texels.data(), texels.data(), texture->texels.size());
    return texture;
}

/// Factors that are all 1, but Td, which is 2.
StippleFactors plainFactors()
{
    StippleFactors factors;
    factors.distanceFactor = 0.0f;
    factors.interiorFactor = 0.0f;
    return factors;
}

/// A box of 1 seen from 10 along +z.
StyledScene sceneOf(std::shared_ptr<const vo::VoxelTexture> voxels, const StippleFactors& factors)
{
    StyledScene scene;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -10.0});
    scene.clipFromEye = glm::ortho(-1.0, 1.0, -1.0, 1.0, 1.0, 20.0);
    vo::StyledVolume volume;
    volume.voxels = std::move(voxels);
    volume.stipple = factors;
    scene.volumes.push_back(volume);
    return scene;
}

std::vector<vo::StipplePoint> pointsOf(const StyledScene& scene, int threads = 1)
{
    return vo::stipplePoints(scene, scene.volumes[0], threads);
}

/// Mean N of a voxel, of 16^3.
double densityOf(const StyledScene& scene)
{
    return static_cast<double>(pointsOf(scene).size()) / (16.0 * 16.0 * 16.0);
}

void expectDensity(const StyledScene& scene, double expected)
{
    EXPECT_NEAR(densityOf(scene), expected, 0.05 * expected);
}

using Place = std::tuple<float, float, float>;

std::set<Place> placesOf(const std::vector<vo::StipplePoint>& points)
{
    std::set<Place> places;
    for (const vo::StipplePoint& point : points)
        places.insert({point.position.x, point.position.y, point.position.z});
    return places;
}

const auto kConstant = [](double value) {
    return voxelsOf(16, [=](double, double, double) { return value; });
};
const auto kSlope = [] { return voxelsOf(16, [](double x, double, double) { return 0.25 + 0.5 * x; }); };

TEST(stipplePoints, constantRegionsHaveTheDensityOfTheEquations)
{
    for (const double value : {0.2, 0.5, 1.0})
        expectDensity(sceneOf(kConstant(value), plainFactors()), 16.0 * value * value * 2.0);
    StippleFactors factors = plainFactors();
    factors.gradientRetainedOpacity = 0.3f;
    factors.silhouetteRetainedOpacity = 0.7f;
    expectDensity(sceneOf(kConstant(0.5), factors), 16.0 * 0.15 * 0.35 * 2.0);
}

TEST(stipplePoints, voxelsHave64AtMost)
{
    StippleFactors factors = plainFactors();
    factors.gradientRetainedOpacity = 100.0f;
    expectDensity(sceneOf(kConstant(1.0), factors), 64.0);
}

TEST(stipplePoints, interiorBoundaryAndSilhouetteGoByTheGradient)
{
    // Df is 1/32 everywhere but at the two faces across x, where it is half of that.
    const double gradient = 1.0 / 32.0;
    const double Cv2 = 1.0 / 4.0 + 1.0 / 48.0; // mean square of 1/4 to 3/4
    StippleFactors factors = plainFactors();
    factors.interiorFactor = 1.0f;
    factors.gradientRetainedOpacity = 10.0f;
    StyledScene scene = sceneOf(kSlope(), factors);
    // The faces' voxels: 0.2656 and 0.7344 squared, half the gradient.
    const double faces = (0.2656 * 0.2656 + 0.7344 * 0.7344) / 16.0;
    expectDensity(scene, 16.0 * 2.0 * 10.0 * gradient * (Cv2 - 0.5 * faces));

    factors = plainFactors();
    factors.gradientBoundaryOpacity = 100.0f;
    scene = sceneOf(kSlope(), factors);
    scene.volumes[0].stipple->gradientRetainedOpacity = 0.0f;
    expectDensity(scene, 16.0 * 2.0 * 100.0 * gradient * (Cv2 - 0.5 * faces));
    // Seen along the normals, they are turned away less than the threshold.
    scene.eyeFromWorld = glm::rotate(scene.eyeFromWorld, std::acos(-1.0) / 2.0, {0.0, 1.0, 0.0});
    EXPECT_EQ(densityOf(scene), 0.0);

    factors = plainFactors();
    factors.silhouetteRetainedOpacity = 0.0f;
    factors.silhouetteBoundaryOpacity = 1.0f;
    scene = sceneOf(kSlope(), factors);
    expectDensity(scene, 16.0 * 2.0 * Cv2);
    scene.eyeFromWorld = glm::rotate(scene.eyeFromWorld, std::acos(-1.0) / 3.0, {0.0, 1.0, 0.0});
    expectDensity(scene, 16.0 * 2.0 * Cv2 * (1.0 - std::sin(std::acos(-1.0) / 3.0)));
}

TEST(stipplePoints, nearerVoxelsHaveMore)
{
    StippleFactors factors = plainFactors();
    factors.distanceFactor = 1.0f;
    const StyledScene scene = sceneOf(kConstant(1.0), factors);
    double near = 0.0, far = 0.0;
    for (const vo::StipplePoint& point : pointsOf(scene))
        (point.position.z > 0.0f ? near : far) += 2.0 / (16.0 * 16.0 * 16.0);
    EXPECT_NEAR(near, 16.0 * 1.75, 16.0 * 1.75 * 0.05);
    EXPECT_NEAR(far, 16.0 * 1.25, 16.0 * 1.25 * 0.05);
}

TEST(stipplePoints, litSidesHaveFewer)
{
    StyledScene scene = sceneOf(kSlope(), plainFactors());
    const double dark = densityOf(scene);
    vo::StyleLight light;
    light.direction = {0.8f, 0.0f, -0.6f}; // normals are -1 0 0
    scene.volumes[0].surroundings.lights = {light};
    EXPECT_NEAR(densityOf(scene), 0.2 * dark, 0.05 * 0.2 * dark);
    scene.volumes[0].stipple->lightingFactor = 2.0f;
    EXPECT_NEAR(densityOf(scene), 0.36 * dark, 0.05 * 0.36 * dark);
    scene.volumes[0].surroundings.lights[0].direction.x = -0.8f;
    EXPECT_EQ(densityOf(scene), dark);
}

TEST(stipplePoints, resolutionGoesByTheDistanceAtFirst)
{
    StyledScene scene = sceneOf(kConstant(0.5), plainFactors());
    scene.volumes[0].stipple->originalDistance = 20.0f;
    expectDensity(scene, 16.0 * 0.25 * 2.0 / 2.0);
    scene.volumes[0].stipple->resolutionFactor = 2.0f;
    expectDensity(scene, 16.0 * 0.25 * 2.0 / 4.0);
}

TEST(stipplePoints, allVoxelsHaveFewerWhereThereWouldBeTooMany)
{
    StippleFactors factors = plainFactors();
    factors.gradientRetainedOpacity = 100.0f;
    StyledScene scene = sceneOf(voxelsOf(128, [](double, double, double) { return 1.0; }), factors);
    // 128^3 voxels of 64 would be 2^27 points, eight times the most; a sixteenth of the box is kept.
    scene.volumes[0].clipPlanes = {{1.0, 0.0, 0.0, -0.4375}};
    EXPECT_NEAR(static_cast<double>(pointsOf(scene, 0).size()), double(vo::kStipplePoints) / 16.0, 100.0);
}

TEST(stipplePoints, linesOfSightOfAPerspectiveMeetInTheEye)
{
    StippleFactors factors = plainFactors();
    factors.silhouetteRetainedOpacity = 0.0f;
    factors.silhouetteBoundaryOpacity = 1.0f;
    StyledScene scene = sceneOf(kSlope(), factors);
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), {0.0, 0.0, -0.7});
    scene.clipFromEye = glm::perspective(1.0, 1.0, 0.1, 20.0);
    // Ts = 1 - |n.V| with n along x.
    double expected = 0.0;
    for (int z = 0; z < 16; ++z)
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const glm::dvec3 place = (glm::dvec3(x, y, z) + 0.5) / 16.0;
                const double Cv = 0.25 + 0.5 * place.x;
                const glm::dvec3 V = glm::normalize(glm::dvec3(0.0, 0.0, 0.7) - (place - 0.5));
                expected += 16.0 * 2.0 * Cv * Cv * (1.0 - std::abs(V.x));
            }
    expectDensity(scene, expected / (16.0 * 16.0 * 16.0));
}

TEST(stipplePoints, fewerPointsAreTheFirstOfMore)
{
    const StyledScene scene = sceneOf(kConstant(0.5), plainFactors());
    StyledScene fewer = scene;
    fewer.volumes[0].stipple->gradientRetainedOpacity = 0.4f;
    fewer.eyeFromWorld = glm::rotate(scene.eyeFromWorld, 1.0, {0.3, 1.0, 0.2});
    const auto all = placesOf(pointsOf(scene));
    const auto few = placesOf(pointsOf(fewer));
    EXPECT_GT(few.size(), all.size() / 3);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), few.begin(), few.end()));
}

TEST(stipplePoints, threadsChangeNothing)
{
    const StyledScene scene = sceneOf(kSlope(), plainFactors());
    const auto one = pointsOf(scene, 1), many = pointsOf(scene, 4);
    ASSERT_EQ(one.size(), many.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        ASSERT_EQ(one[i].position, many[i].position);
}

TEST(stipplePoints, fillTheBoxEvenlyWithinClipPlanes)
{
    StyledScene scene = sceneOf(kConstant(0.5), plainFactors());
    scene.volumes[0].dimensions = {2.0f, 3.0f, 4.0f};
    scene.volumes[0].clipPlanes = {{1.0, 0.0, 0.0, 0.5}};
    const auto points = pointsOf(scene);
    glm::dvec3 sum(0.0);
    for (const vo::StipplePoint& point : points) {
        EXPECT_TRUE(std::abs(point.position.y) <= 1.5f && std::abs(point.position.z) <= 2.0f);
        EXPECT_GE(point.position.x, -0.5f);
        EXPECT_EQ(point.color, glm::vec3(0.5f));
        sum += glm::dvec3(point.position);
    }
    sum /= static_cast<double>(points.size());
    EXPECT_NEAR(sum.x, 0.25, 0.02);
    EXPECT_NEAR(sum.y, 0.0, 0.04);
    EXPECT_NEAR(sum.z, 0.0, 0.05);
}

TEST(stipplePoints, nonsenseHasNone)
{
    const StyledScene scene = sceneOf(kConstant(1.0), plainFactors());
    for (int i = 0; i < 6; ++i) {
        StyledScene spoiled = scene;
        vo::StyledVolume& volume = spoiled.volumes[0];
        if (i == 0) volume.voxels = nullptr;
        if (i == 1) volume.voxels = std::make_shared<vo::VoxelTexture>();
        if (i == 2) volume.worldFromLocal = glm::dmat4(0.0);
        if (i == 3) volume.dimensions.z = std::numeric_limits<float>::quiet_NaN();
        if (i == 4) volume.stipple.reset();
        if (i == 5) volume.stipple->gradientRetainedOpacity = std::numeric_limits<float>::quiet_NaN();
        EXPECT_TRUE(pointsOf(spoiled).empty()) << i;
    }
}

} // namespace
