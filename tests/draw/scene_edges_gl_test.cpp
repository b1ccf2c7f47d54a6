// What pixels have whose centre lies on an edge, and what is seen in front of opaque surfaces: both engines
// beside closed forms and the reference.

#include "cast/cast_scene.h"
#include "draw/draw_scene.h"
#include "support/float_screen.h"
#include "support/styled_reference.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace vo;
using vo::test::styledReference;

constexpr int kPixels = 20;
/// 204 of 255, as texels are.
constexpr float kDense = 0.8f;

TexturePointer bytes(VoxelSize size, const std::function<double(glm::dvec3)>& value)
{
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = size;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::dvec3 place = (glm::dvec3(x, y, z) + 0.5) / glm::dvec3(size.x, size.y, size.z);
                texture->texels.push_back(static_cast<std::byte>(std::lround(255.0 * value(place))));
            }
    return texture;
}

TexturePointer constant(double value)
{
    return bytes({4, 4, 4}, [=](const glm::dvec3&) { return value; });
}

/// Four voxels of one value a side, each sampled once.
StyledVolume cube(double edge, double value)
{
    StyledVolume volume;
    volume.dimensions = glm::vec3(static_cast<float>(edge));
    volume.voxels = constant(value);
    volume.unitLength = volume.spacing = edge / 4.0;
    return volume;
}

/// Five tetrahedra that fill a cube round the origin.
std::shared_ptr<StyledTetras> tetrasOfCube(double edge)
{
    StyledTetras made;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
        made.places.push_back(place);
        made.positions.push_back((place - 0.5f) * static_cast<float>(edge));
    }
    made.indices = {0, 1, 2, 4, 3, 2, 1, 7, 5, 4, 7, 1, 6, 7, 4, 2, 1, 2, 4, 7};
    return std::make_shared<StyledTetras>(made);
}

StyledSurface glowing(const std::vector<glm::vec3>& positions, const std::vector<int>& triangles)
{
    StyledSurface surface;
    surface.positions = positions;
    surface.triangles = triangles;
    surface.normals.assign(positions.size(), {0.0f, 0.0f, 1.0f});
    surface.lit = surface.solid = false;
    surface.emissive = {0.0f, 0.0f, 1.0f};
    return surface;
}

StyledSurface cubeOfTriangles(double edge)
{
    return glowing(tetrasOfCube(edge)->positions, {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                                   2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5});
}

/// A rectangle, `turn` round its upright axis.
StyledSurface pane(double z, double turn, double half)
{
    const auto h = static_cast<float>(half);
    StyledSurface surface = glowing({{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}}, {0, 1, 2, 0, 2, 3});
    surface.worldFromLocal = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, z)), turn,
                                         glm::dvec3(0.0, 1.0, 0.0));
    return surface;
}

/// A view along -z of a square `edge * 4` wide at the origin, whose pixels are `edge / 5` wide there; the eye
/// is 4.5 edges in front of it.
StyledScene sceneOf(double edge, bool perspective = false)
{
    StyledScene scene;
    scene.width = scene.height = kPixels;
    scene.background.opacity = 0.0f;
    scene.eyeFromWorld = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -4.5 * edge));
    const double half = 2.0 * edge;
    scene.clipFromEye = perspective ? glm::perspective(2.0 * std::atan(0.5), 1.0, edge, 10.0 * edge)
                                    : glm::ortho(-half, half, -half, half, edge, 10.0 * edge);
    return scene;
}

/// Something that is not seen lies between parts of the volumes: they are drawn by slices.
StyledScene sliced(StyledScene scene)
{
    scene.surfaces.push_back(pane(0.0, 1.2, 100.0));
    scene.surfaces.back().transparency = 1.0f;
    return scene;
}

/// The whole scene moved and turned, as the eye is: the picture stays but for rounding.
StyledScene moved(StyledScene scene, double turn)
{
    const glm::dmat4 move = glm::rotate(glm::translate(glm::dmat4(1.0), glm::dvec3(0.3, -0.7, 1.1)), turn,
                                        glm::normalize(glm::dvec3(0.3, 0.2, 1.0)));
    scene.eyeFromWorld = scene.eyeFromWorld * glm::inverse(move);
    for (StyledVolume& volume : scene.volumes) {
        volume.worldFromLocal = move * volume.worldFromLocal;
        for (glm::dvec4& plane : volume.clipPlanes)
            plane = plane * glm::inverse(move);
    }
    for (StyledSurface& surface : scene.surfaces) {
        surface.worldFromLocal = move * surface.worldFromLocal;
        for (glm::dvec4& plane : surface.clipPlanes)
            plane = plane * glm::inverse(move);
    }
    return scene;
}

/// As it is, and moved: matrices round in different ways.
std::vector<StyledScene> allWays(const StyledScene& scene)
{
    return {scene, moved(scene, 0.0), moved(scene, 0.7), moved(scene, -1.9)};
}

/// A square of one colour, lying in a plane that is turned.
StyledSurface square(const glm::vec3& color, float transparency, double half, const glm::dmat4& turn)
{
    StyledSurface surface = pane(0.0, 0.0, half);
    surface.worldFromLocal = turn;
    surface.emissive = color;
    surface.transparency = transparency;
    return surface;
}

/// A pixel that has two faces of one plane.
glm::vec4 togetherOf(const StyledSurface& first, const StyledSurface& second)
{
    const auto seen = [](const StyledSurface& face) {
        return glm::vec4(face.emissive, 1.0f) * (1.0f - face.transparency);
    };
    if (first.transparency <= 0.0f) return seen(first);
    if (second.transparency <= 0.0f) return seen(second);
    return seen(first) + seen(second) * first.transparency;
}

class SceneEdges : public vo::test::FloatScreen<kPixels>
{
protected:
    std::vector<float> drawn(const StyledScene& scene)
    {
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawer_.draw(scene);
        return context_->readFloats();
    }

    /// Pictures of a scene: with OpenGL, with slices, without OpenGL.
    std::vector<std::pair<std::string, std::vector<float>>> picturesOfEngines(const StyledScene& scene)
    {
        ScenePicture cast;
        castScene(scene, 1, cast);
        return {{"OpenGL", drawn(scene)}, {"slices", drawn(sliced(scene))}, {"cast", cast.rgba}};
    }

    /// These, and what is expected of all.
    std::vector<std::pair<std::string, std::vector<float>>> pictures(const StyledScene& scene)
    {
        auto all = picturesOfEngines(scene);
        const std::vector<double> reference = styledReference(scene);
        all.push_back({"reference", {reference.begin(), reference.end()}});
        return all;
    }

    /// Each pixel has an opacity: `expected(x, y)`.
    void expectOpacities(const StyledScene& scene, const std::string& what,
                         const std::function<double(int, int)>& expected, double tolerance = 1e-4)
    {
        for (const auto& [engine, picture] : pictures(scene))
            for (int y = 0; y < kPixels; ++y)
                for (int x = 0; x < kPixels; ++x)
                    ASSERT_NEAR(pixelAt(picture, x, y)[3], expected(x, y), tolerance)
                        << what << ", " << engine << ": " << x << ", " << y;
    }

    /// Where two faces of one plane meet, they have one colour, and each its own elsewhere.
    void expectWhole(StyledScene scene, const StyledSurface& first, const StyledSurface& second)
    {
        const glm::vec4 both = togetherOf(first, second);
        scene.surfaces = {first};
        const auto one = picturesOfEngines(scene);
        scene.surfaces = {second};
        const auto two = picturesOfEngines(scene);
        scene.surfaces = {first, second};
        const auto drawn = picturesOfEngines(scene);
        for (std::size_t engine = 0; engine < drawn.size(); ++engine)
            for (std::size_t i = 0; i < drawn[engine].second.size(); ++i) {
                const std::size_t alpha = i | 3;
                const float a = one[engine].second[i], b = two[engine].second[i];
                const bool meet = one[engine].second[alpha] > 0.0f && two[engine].second[alpha] > 0.0f;
                ASSERT_NEAR(drawn[engine].second[i], meet ? both[static_cast<int>(i % 4)] : a + b, 1e-4)
                    << drawn[engine].first << ": number " << i << ", " << first.transparency << " before "
                    << second.transparency << ", " << scene.volumes.size() << " volumes";
            }
    }

    SceneDrawer drawer_;
};

INSTANTIATE_TEST_SUITE_P(Profiles, SceneEdges, vo::test::kBothProfiles, vo::test::profileName);

/// A scene, how it is called, and the opacity of a pixel that has it.
struct Case
{
    std::string name;
    StyledScene scene;
    double opacity;
};

/// One thing each whose sides pass through the centres of pixels 7 and 12, in rows and columns.
std::vector<Case> cubesOnCenters(double edge)
{
    const double through = std::pow(1.0 - static_cast<double>(kDense), 4.0);
    std::vector<Case> cases;
    StyledScene scene = sceneOf(edge);
    scene.surfaces = {cubeOfTriangles(edge)};
    cases.push_back({"triangles", scene, 1.0});
    scene.surfaces[0].transparency = 0.5f;
    scene.surfaces[0].solid = true;
    cases.push_back({"translucent triangles", scene, 0.5});
    scene.surfaces.clear();
    scene.volumes = {cube(edge, kDense)};
    cases.push_back({"volume", scene, 1.0 - through});
    scene.volumes[0].tetras = tetrasOfCube(edge);
    cases.push_back({"tetrahedra", scene, 1.0 - through});
    scene.volumes[0].projection = RayProjection{};
    cases.push_back({"projected tetrahedra", scene, 1.0});
    scene.volumes[0].tetras.reset();
    cases.push_back({"projection", scene, 1.0});
    scene.volumes = {cube(edge, 0.0)};
    scene.volumes[0].voxels = bytes({4, 4, 4}, [](const glm::dvec3& place) { return place.z; });
    scene.volumes[0].surfaces = IsoSurfaces{{0.5f}, {StyleChain{}}, 0.0f, {}};
    cases.push_back({"surface of a value", scene, 0.5});
    return cases;
}

TEST_P(SceneEdges, pixelsBelongToWhatIsOnTheRightAndAbove)
{
    for (const double edge : {5.0, 0.3})
        for (const Case& one : cubesOnCenters(edge))
            for (const StyledScene& way : allWays(one.scene)) {
                const auto expected = [&one](int x, int y) {
                    return x >= 7 && x < 12 && y >= 7 && y < 12 ? one.opacity : 0.0;
                };
                expectOpacities(way, one.name + std::to_string(edge), expected, 2e-3);
            }
}

TEST_P(SceneEdges, pixelsBelongToWhatIsOnTheRightAndAboveInPerspective)
{
    for (const double edge : {5.0, 0.3}) {
        StyledScene scene = sceneOf(edge, true);
        scene.surfaces = {cubeOfTriangles(edge)};
        for (const StyledScene& way : allWays(scene))
            expectOpacities(way, "triangles",
                            [](int x, int y) { return x >= 7 && x < 12 && y >= 7 && y < 12 ? 1.0 : 0.0; });
        // Rays leave a volume at once where they enter it at the front's edge.
        scene.surfaces.clear();
        scene.volumes = {cube(edge, 1.0)};
        for (const StyledScene& way : allWays(scene))
            expectOpacities(way, "volume",
                            [](int x, int y) { return x >= 8 && x < 12 && y >= 8 && y < 12 ? 1.0 : 0.0; });
    }
}

/// Two cubes side by side, or two halves of one at clip planes: no pixel twice, none missing.
TEST_P(SceneEdges, neighboursHaveEachPixelOnce)
{
    const double edge = 0.3, opacity = 1.0 - std::pow(1.0 - 0.2, 4.0);
    for (const bool upright : {false, true}) {
        const glm::dvec3 side = upright ? glm::dvec3(0.0, 0.5, 0.0) : glm::dvec3(0.5, 0.0, 0.0);
        const auto expected = [&](int x, int y) {
            const int along = upright ? y : x, across = upright ? x : y;
            return along >= 5 && along < 15 && across >= 7 && across < 12 ? opacity : 0.0;
        };
        StyledScene scene = sceneOf(edge);
        // The face that both have is in the middle, through centres of pixels once the picture is moved by
        // half of one.
        scene.clipFromEye =
            glm::translate(glm::dmat4(1.0), side * 2.0 / static_cast<double>(kPixels)) * scene.clipFromEye;
        scene.volumes = {cube(edge, 0.2), cube(edge, 0.2)};
        scene.volumes[0].worldFromLocal[3] += glm::dvec4(-side * edge, 0.0);
        scene.volumes[1].worldFromLocal[3] += glm::dvec4(side * edge, 0.0);
        for (const StyledScene& way : allWays(scene))
            expectOpacities(way, "cubes", expected);
        for (StyledVolume& volume : scene.volumes)
            volume.tetras = tetrasOfCube(edge);
        for (const StyledScene& way : allWays(scene))
            expectOpacities(way, "tetrahedra", expected);
        for (std::size_t half = 0; half < 2; ++half) {
            StyledVolume& volume = scene.volumes[half];
            volume.tetras.reset();
            volume.worldFromLocal = glm::dmat4(1.0);
            volume.dimensions *= 1.0f + 2.0f * glm::vec3(side);
            volume.clipPlanes = {glm::dvec4(half == 0 ? -side : side, 0.0)};
        }
        for (const StyledScene& way : allWays(scene))
            expectOpacities(way, "halves", expected);
    }
}

/// A square at z = 0 whose corners have opacities of their own.
StyledSurface colored(const std::vector<float>& opacities)
{
    StyledSurface surface = pane(0.0, 0.0, 10.0);
    surface.transparency = 0.5f; // of no account beside colours
    for (const float opacity : opacities)
        surface.colors.emplace_back(0.0f, 0.0f, 1.0f, opacity);
    return surface;
}

/// Values rise away from the eye: a projection that ends at the square shows what is just before it.
TEST_P(SceneEdges, trianglesWithOpaqueCornersHideWhatIsBehindAlsoInProjections)
{
    StyledScene scene = sceneOf(4.0);
    scene.volumes = {cube(4.0, 0.0)};
    scene.volumes[0].voxels = bytes({4, 4, 4}, [](const glm::dvec3& place) { return 0.8 - 0.6 * place.z; });
    scene.volumes[0].projection = RayProjection{};
    const double before = 0.8 - 0.6 * 0.625, last = 0.8 - 0.6 * 0.125;
    const std::vector<std::pair<std::vector<float>, double>> cases{
        {{1.0f, 1.0f, 1.0f, 1.0f}, before},
        {{0.9f, 0.9f, 0.9f, 0.9f}, last},
        // The first triangle is below the diagonal, and opaque.
        {{1.0f, 1.0f, 1.0f, 0.5f}, before}};
    for (const auto& [opacities, value] : cases) {
        scene.surfaces = {colored(opacities)};
        for (const auto& [engine, picture] : pictures(scene))
            EXPECT_NEAR(pixelAt(picture, 11, 8)[0], value, 0.5 / 255.0 + 1e-4)
                << engine << ", " << opacities[3];
    }
    scene.surfaces = {colored({1.0f, 1.0f, 1.0f, 0.5f})};
    for (const auto& [engine, picture] : pictures(scene))
        EXPECT_NEAR(pixelAt(picture, 8, 11)[0], last, 0.5 / 255.0 + 1e-4) << engine;
    // Without a projection, too: as if opaque surfaces had no colours of corners.
    scene.volumes[0].projection.reset();
    for (const std::vector<float>& opacities :
         {std::vector<float>(4, 1.0f), std::vector<float>{1, 1, 1, 0.5f}}) {
        scene.surfaces = {colored(opacities)};
        StyledScene plain = scene;
        plain.surfaces = {pane(0.0, 0.0, 10.0)};
        const auto expected = pictures(plain).back().second;
        for (const auto& [engine, picture] : pictures(scene))
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_NEAR(pixelAt(picture, 11, 8)[c], pixelAt(expected, 11, 8)[c], 1e-4) << engine;
    }
}

/// Two faces of one plane that are turned the same way, in each order.
TEST_P(SceneEdges, facesOfOnePlaneDoNotMix)
{
    const glm::dmat4 straight(1.0), turned = glm::rotate(straight, 0.7, glm::dvec3(0.6, 0.8, 0.0)),
                                    steep = glm::rotate(straight, 1.2, glm::dvec3(0.3, 0.8, 0.52));
    for (const glm::dmat4& turn : {straight, turned, steep})
        for (const bool perspective : {false, true})
            for (const auto& [large, small] :
                 {std::pair(0.0f, 0.0f), {0.0f, 0.5f}, {0.6f, 0.0f}, {0.6f, 0.5f}}) {
                const StyledSurface a = square({1, 0, 0}, large, 0.4, turn),
                                    b = square({0, 1, 0}, small, 0.34, turn);
                StyledScene scene = sceneOf(0.3, perspective);
                expectWhole(scene, a, b);
                expectWhole(scene, b, a);
                // Not seen, but rays go from hit to hit, or slices lie between.
                scene.volumes = {cube(0.3, 0.0)};
                expectWhole(scene, b, a);
                scene.volumes[0].tetras = tetrasOfCube(0.3);
                expectWhole(scene, b, a);
            }
}

/// It is in front, wherever the face stands in its plane.
TEST_P(SceneEdges, surfacesOfValuesInOnePlaneWithOpaqueFacesAreWhole)
{
    for (const double angle : {0.0, 0.7, 1.2})
        for (const bool perspective : {false, true}) {
            const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0.6, 0.8, 0.0));
            StyledScene scene = sceneOf(0.3, perspective);
            scene.volumes = {cube(0.6, 0.0)};
            // Bytes 30, 90, 150 and 210, linear between all of them.
            scene.volumes[0].voxels =
                bytes({4, 4, 4}, [](const glm::dvec3& place) { return 240.0 / 255.0 * place.z; });
            scene.volumes[0].worldFromLocal = turn;
            scene.volumes[0].surfaces = IsoSurfaces{{120.0f / 255.0f}, {StyleChain{}}, 0.0f, {}};
            const auto surface = picturesOfEngines(scene);
            scene.surfaces = {square({1, 0, 0}, 0.0f, 0.25, turn)};
            const auto drawn = picturesOfEngines(scene);
            scene.volumes.clear();
            const auto face = picturesOfEngines(scene);
            int seen = 0;
            for (std::size_t engine = 0; engine < drawn.size(); ++engine)
                for (std::size_t i = 0; i < drawn[engine].second.size(); ++i) {
                    const float opacity = surface[engine].second[i | 3];
                    if (opacity == 0.0f) continue;
                    const float expected =
                        surface[engine].second[i] + (1.0f - opacity) * face[engine].second[i];
                    EXPECT_NEAR(drawn[engine].second[i], expected, 1e-4)
                        << drawn[engine].first << ": " << angle << ", " << i;
                    ++seen;
                }
            EXPECT_GT(seen, 100);
        }
}

/// Two panes that cross along the upright line through the middle, at an angle of 0.001: red in front on the
/// left. Slabs of the whole depth are thicker than they are apart.
TEST_P(SceneEdges, panesThatCrossAtASmallAngleAreInOrder)
{
    StyledSurface red = pane(0.0, 0.0005, 5.0), green = pane(0.0, -0.0005, 5.0),
                  behind = pane(-1.0, 0.0, 5.0);
    red.emissive = {1, 0, 0};
    green.emissive = {0, 1, 0};
    red.transparency = green.transparency = behind.transparency = 0.5f;
    StyledScene scene = sceneOf(0.3, true);
    for (const bool isFirst : {true, false}) {
        scene.surfaces = isFirst ? std::vector{red, green, behind} : std::vector{green, red, behind};
        for (const auto& [engine, picture] : picturesOfEngines(scene))
            for (int x = 0; x < kPixels; ++x) {
                const bool left = x < kPixels / 2;
                EXPECT_NEAR(pixelAt(picture, x, 9)[0], left ? 0.5f : 0.25f, 1e-5) << engine << ": " << x;
                EXPECT_NEAR(pixelAt(picture, x, 9)[1], left ? 0.25f : 0.5f, 1e-5) << engine << ": " << x;
            }
    }
}

/// Two squares of one surface, with colours of their own.
TEST_P(SceneEdges, facesOfOneSurfaceDoNotMix)
{
    for (const double angle : {0.0, 0.7, 1.2}) {
        const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), angle, glm::dvec3(0.6, 0.8, 0.0));
        StyledScene scene = sceneOf(0.3, true);
        scene.surfaces = {square({1, 0, 0}, 0.0f, 0.4, turn), square({0, 1, 0}, 0.0f, 0.34, turn)};
        const auto expected = picturesOfEngines(scene);
        StyledSurface both = scene.surfaces[0];
        both.triangles.insert(both.triangles.end(), {4, 5, 6, 4, 6, 7});
        for (const glm::vec3& position : scene.surfaces[1].positions)
            both.positions.push_back(position);
        both.normals.resize(8, both.normals[0]);
        both.emissive = glm::vec3(0.0f);
        both.lit = true;
        scene.surfaces = {both};
        for (std::size_t i = 0; i < 8; ++i)
            scene.surfaces[0].colors.emplace_back(i < 4 ? 1.0f : 0.0f, i < 4 ? 0.0f : 1.0f, 0.0f, 1.0f);
        scene.surfaces[0].lights = {StyleLight{}};
        const auto drawn = picturesOfEngines(scene);
        for (std::size_t engine = 0; engine < drawn.size(); ++engine)
            for (std::size_t i = 0; i < drawn[engine].second.size(); i += 4)
                ASSERT_EQ(drawn[engine].second[i + 1] > 0.0f, expected[engine].second[i + 1] > 0.0f)
                    << drawn[engine].first << ": number " << i << ", angle " << angle;
    }
}

/// Of one depth the projection is in front, and hides the pane.
TEST_P(SceneEdges, panesOnTheFrontOfAProjectionAreBehindIt)
{
    for (const double edge : {5.0, 0.3})
        for (const bool perspective : {false, true})
            for (const double half : {0.9, 0.2}) {
                StyledScene scene = sceneOf(edge, perspective);
                scene.volumes = {cube(edge, kDense)};
                scene.volumes[0].projection = RayProjection{};
                const auto alone = picturesOfEngines(scene);
                scene.surfaces = {pane(0.5 * edge, 0.0, half * edge)};
                scene.surfaces[0].transparency = 0.5f;
                for (const StyledScene& way : allWays(scene)) {
                    const auto drawn = picturesOfEngines(way);
                    for (std::size_t engine = 0; engine < drawn.size(); ++engine)
                        for (std::size_t i = 0; i < drawn[engine].second.size(); i += 4)
                            if (alone[engine].second[i + 3] > 0.0f) {
                                ASSERT_NEAR(drawn[engine].second[i], kDense, 2e-3)
                                    << drawn[engine].first << ": number " << i << ", edge " << edge;
                            }
                }
            }
}

/// A clip plane, in numbers of single precision, that a square lies in, or is behind by a part of its size.
glm::dvec4 planeOf(const StyledSurface& square, bool facesEye, double behind)
{
    const glm::dvec3 normal(square.worldFromLocal[2] * (facesEye ? 1.0 : -1.0));
    const glm::dvec3 point(square.worldFromLocal[3]);
    return glm::vec4(glm::dvec4(normal, -glm::dot(normal, point) - behind));
}

TEST_P(SceneEdges, facesThatLieInSlantedClipPlanesAreWhole)
{
    const glm::dmat4 away = glm::translate(glm::dmat4(1.0), glm::dvec3(0.03, -0.05, 0.1));
    for (const double angle : {0.0, 0.3, -0.7, 1.2})
        for (const float transparency : {0.0f, 0.5f})
            for (const bool perspective : {false, true})
                for (const bool among : {false, true}) {
                    StyledScene scene = sceneOf(0.3, perspective);
                    if (among) scene.volumes = {cube(0.3, 0.0)};
                    scene.surfaces = {
                        square({1, 0, 0}, transparency, 0.4, glm::rotate(away, angle, {0.3, 0.8, 0.52}))};
                    const auto whole = picturesOfEngines(scene);
                    for (const bool facesEye : {false, true})
                        for (const double behind : {0.0, 1e-4}) {
                            StyledScene cut = scene;
                            cut.surfaces[0].clipPlanes = {planeOf(scene.surfaces[0], facesEye, behind)};
                            const auto drawn = picturesOfEngines(cut);
                            for (std::size_t engine = 0; engine < drawn.size(); ++engine)
                                for (std::size_t i = 0; i < drawn[engine].second.size(); ++i)
                                    ASSERT_EQ(drawn[engine].second[i],
                                              behind > 0.0 ? 0.0f : whole[engine].second[i])
                                        << drawn[engine].first << ": number " << i << ", angle " << angle
                                        << ", behind by " << behind;
                        }
                }
}

} // namespace
