// Shadows that volumes throw on themselves, by closed forms.

#include "style/shadow_grid.h"
#include "style/shadow_textures.h"
#include "style/styles.h"
#include "style/tetra_slice.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <stdexcept>

namespace vo {
namespace {

using glm::dvec3;

std::shared_ptr<VoxelTexture> voxelsOf(VoxelSize size, const std::function<double(const dvec3&)>& valueAt)
{
    auto made = std::make_shared<VoxelTexture>();
    made->size = size;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const dvec3 place = (dvec3(x, y, z) + 0.5) / dvec3(size.x, size.y, size.z);
                made->texels.push_back(static_cast<std::byte>(std::lround(255.0 * valueAt(place))));
            }
    return made;
}

std::shared_ptr<const Style> shadedWithShadows()
{
    Shaded shaded;
    shaded.lighting = true;
    shaded.shadows = true;
    return makeStyle(shaded);
}

StyleLight sunOf(const glm::vec3& direction)
{
    StyleLight light;
    light.direction = glm::normalize(direction);
    return light;
}

StyleLight lampAt(const glm::vec3& position)
{
    StyleLight light;
    light.kind = StyleLight::Kind::point;
    light.position = position;
    return light;
}

/// The unit vector from a place to a light.
dvec3 wayTo(const StyleLight& light, const dvec3& from)
{
    return light.kind == StyleLight::Kind::directional ? dvec3(-light.direction)
                                                       : glm::normalize(dvec3(light.position) - from);
}

StyledVolume volumeOf(std::shared_ptr<const VoxelTexture> voxels, const glm::vec3& dimensions,
                      const std::vector<StyleLight>& lights)
{
    StyledVolume volume;
    volume.voxels = std::move(voxels);
    volume.dimensions = dimensions;
    volume.chains = {{shadedWithShadows()}};
    volume.surroundings.lights = lights;
    const VoxelSize& size = volume.voxels->size;
    const glm::vec3 edges = dimensions / glm::vec3(size.x, size.y, size.z);
    volume.unitLength = static_cast<double>(std::min({edges.x, edges.y, edges.z}));
    return volume;
}

/// What Shaded makes of a white sample there, of a normal to the light and no ambient light: what comes
/// through.
double lightAt(const StyledVolume& volume, const dvec3& position)
{
    SampleBatch batch{};
    batch.count = 1;
    const dvec3 way = wayTo(volume.surroundings.lights.at(0), position);
    for (int axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<std::size_t>(axis);
        batch.position[a][0] = static_cast<float>(position[axis]);
        batch.place[a][0] =
            static_cast<float>(position[axis] / static_cast<double>(volume.dimensions[axis]) + 0.5);
        batch.n[a][0] = static_cast<float>(way[axis]);
        batch.Cv[a][0] = 1.0f;
    }
    const StyleChain& chain = volume.surfaces ? volume.surfaces->chains[0] : volume.chains[0];
    chain.back()->apply(volume.surroundings, batch);
    return static_cast<double>(batch.Cv[0][0]);
}

StyledVolume shadowed(StyledVolume volume)
{
    ShadowStore().add(volume, 0);
    return volume;
}

/// Where shadows begin on a way to the light.
double offsetOf(const StyledVolume& volume, const dvec3& way)
{
    const ShadowGrid grid = emptyShadowGrid(volume, shadowBoxOf(volume).value());
    return static_cast<double>(shadowOffset(grid, glm::vec3(way)));
}

/// From a place in a box to where the ray leaves it, or to the light.
double lengthOfWay(const dvec3& dimensions, const dvec3& from, const StyleLight& light)
{
    const bool isFar = light.kind == StyleLight::Kind::directional;
    const dvec3 way = isFar ? dvec3(-light.direction) : dvec3(light.position) - from;
    double length = isFar ? 1e9 : 1.0;
    for (int axis = 0; axis < 3; ++axis)
        if (way[axis] != 0.0)
            length =
                std::min(length, (std::copysign(dimensions[axis] / 2.0, way[axis]) - from[axis]) / way[axis]);
    return length * glm::length(way);
}

TEST(Shadows, ofAConstantVolumeFallWithTheLengthOfTheWay)
{
    const glm::vec3 dimensions(2.0f, 1.5f, 1.0f);
    const double opacity = 51.0 / 255.0;
    for (const StyleLight& light :
         {sunOf({0, 0, -1}), sunOf({0.3f, -0.8f, 0.5f}), sunOf({-1, 0.9f, -0.95f}), lampAt({0, 4, 0}),
          lampAt({-1.5f, 0.3f, 0.9f}), lampAt({0.4f, 0.2f, -0.1f})}) {
        StyledVolume volume =
            volumeOf(voxelsOf({5, 4, 3}, [&](const dvec3&) { return opacity; }), dimensions, {light});
        volume.unitLength = 0.25;
        volume = shadowed(volume);
        // 1.5 voxels of 0.4 x 0.375 x 1/3.
        const auto offsetAt = [&](const dvec3& from) {
            return 1.5 / glm::length(wayTo(light, from) * dvec3(2.5, 4.0 / 1.5, 3.0));
        };
        for (const double x : {-0.9, -0.31, 0.02, 0.77})
            for (const double y : {-0.7, -0.2, 0.55})
                for (const double z : {-0.45, 0.04, 0.4}) {
                    const double length =
                        lengthOfWay(dvec3(dimensions), {x, y, z}, light) - offsetAt({x, y, z});
                    const double expected = std::pow(1.0 - opacity, std::max(length, 0.0) / 0.25);
                    EXPECT_NEAR(lightAt(volume, {x, y, z}), expected, 0.004) << x << " " << y << " " << z;
                }
    }
}

/// A box as five tetrahedra, their corners moved.
std::shared_ptr<StyledTetras> tetrasOf(const glm::vec3& dimensions,
                                       const std::function<glm::vec3(const glm::vec3&)>& moved)
{
    auto tetras = std::make_shared<StyledTetras>();
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 place(corner & 1, corner >> 1 & 1, corner >> 2);
        tetras->places.push_back(place);
        tetras->positions.push_back(moved((place - 0.5f) * dimensions));
    }
    tetras->indices = {0, 3, 5, 6, 1, 3, 5, 0, 2, 3, 0, 6, 4, 5, 6, 0, 7, 3, 6, 5};
    return tetras;
}

/// The same volume, its box in tetrahedra.
StyledVolume inTetras(StyledVolume volume)
{
    volume.tetras = tetrasOf(volume.dimensions, [](const glm::vec3& corner) { return corner; });
    return volume;
}

TEST(Shadows, ofTetrahedraThatFillTheBoxAreThoseOfTheBox)
{
    BoundaryEnhancement boundary; // which reads gradients
    boundary.opacityFactor = 1.0f;
    StyledVolume volume = volumeOf(voxelsOf({7, 6, 5}, [](const dvec3& place) { return place.x * place.y; }),
                                   {2.0f, 1.5f, 1.0f}, {sunOf({0.3f, -0.8f, 0.5f})});
    volume.chains = {{makeStyle(boundary), shadedWithShadows()}};
    StyledVolume surfaces = volume;
    surfaces.surfaces = IsoSurfaces{{0.5f}, {{shadedWithShadows()}}, 0.0f, nullptr};
    for (const StyledVolume& each : {volume, surfaces}) {
        const StyledVolume box = shadowed(each), tetras = shadowed(inTetras(each));
        double least = 1.0;
        for (const double x : {-0.9, -0.31, 0.02, 0.77})
            for (const double y : {-0.7, -0.2, 0.55})
                for (const double z : {-0.45, 0.04, 0.4}) {
                    const double expected = lightAt(box, {x, y, z});
                    EXPECT_NEAR(lightAt(tetras, {x, y, z}), expected, 2e-4) << x << " " << y << " " << z;
                    least = std::min(least, expected);
                }
        EXPECT_LT(least, 0.6);
    }
}

TEST(Shadows, ofTetrahedraFallWithTheLengthOfTheWayInTheirOwnSpace)
{
    const double opacity = 51.0 / 255.0;
    const glm::vec3 low(3.0f, -2.0f, 1.0f);
    StyledVolume volume = volumeOf(voxelsOf({4, 4, 4}, [&](const dvec3&) { return opacity; }),
                                   glm::vec3(0.4f), {sunOf({0, -1, 0})});
    // One tetrahedron, its edges of three lengths.
    auto tetra = std::make_shared<StyledTetras>();
    tetra->places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetra->positions = {low, low + glm::vec3(2, 0, 0), low + glm::vec3(0, 3, 0), low + glm::vec3(0, 0, 1)};
    tetra->indices = {0, 1, 2, 3};
    volume.tetras = tetra;
    for (const StyleLight& light :
         {sunOf({0, -1, 0}), sunOf({-1, 0, 0}), lampAt(low + glm::vec3(0.5f, 4.0f, 0.2f))}) {
        volume.surroundings.lights = {light};
        const StyledVolume seen = shadowed(volume);
        for (const dvec3 at : {dvec3(0.2, 0.3, 0.2), dvec3(1.0, 0.5, 0.1), dvec3(0.3, 1.2, 0.3)}) {
            const dvec3 from = dvec3(low) + at;
            const dvec3 way = wayTo(light, from);
            // To the face where x / 2 + y / 3 + z is 1; none of the ways leaves by another one.
            const dvec3 slope(0.5, 1.0 / 3.0, 1.0);
            const double length = (1.0 - glm::dot(slope, at)) / glm::dot(slope, way) - offsetOf(volume, way);
            EXPECT_NEAR(lightAt(seen, from), std::pow(1.0 - opacity, std::max(length, 0.0) / 0.1), 0.015)
                << at.x << " " << at.y;
        }
    }
}

TEST(Shadows, ofTetrahedraThatOverlapAreThoseOfTheFirst)
{
    // A flat one, and two in one place: of the second T is S of the first.
    StyledTetras tetras;
    tetras.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                        {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetras.places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    tetras.indices = {0, 1, 2, 2, 0, 1, 2, 3, 4, 5, 6, 7};
    ShadowGrid grid;
    grid.box = {{0, 0, 0}, {1, 1, 1}};
    grid.size = {10, 10, 10};
    grid.edges = glm::vec3(0.1f);
    const TetraSlice slice = TetraSlicer(tetras, grid).slice(2);
    int within = 0;
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            const auto texel = static_cast<std::size_t>(10 * y + x);
            const dvec3 center(0.1 * x + 0.05, 0.1 * y + 0.05, 0.25);
            const bool isWithin = center.x + center.y + center.z < 1.0 - 1e-6;
            if (std::abs(center.x + center.y + center.z - 1.0) < 1e-6) continue;
            ASSERT_EQ(slice.tetras[texel], isWithin ? 1 : -1) << x << ", " << y;
            if (!isWithin) continue;
            EXPECT_LT(glm::distance(dvec3(slice.places[texel]), center), 1e-6) << x << ", " << y;
            ++within;
        }
    EXPECT_EQ(within, 28);
}

TEST(Shadows, beginBeyondTheLongerOfTexelsAndVoxelsOfTheWay)
{
    const auto one = [](const dvec3&) { return 1.0; };
    // Voxels of 1/8 x 1/8 x 1/2, then of 1/256; texels of 1/64.
    const StyledVolume coarse = volumeOf(voxelsOf({16, 8, 2}, one), {2.0f, 1.0f, 1.0f}, {});
    EXPECT_NEAR(offsetOf(coarse, {1, 0, 0}), 1.5 / 8.0, 1e-6);
    EXPECT_NEAR(offsetOf(coarse, {0, 0, -5}), 1.5 / 2.0, 1e-6);
    EXPECT_NEAR(offsetOf(coarse, {0, 0.6, 0.8}), 1.5 / std::hypot(4.8, 1.6), 1e-6)
        << "4.8 voxels of y, 1.6 of z";
    EXPECT_NEAR(offsetOf(coarse, {0, 0.6, 0}), 1.5 / 8.0, 1e-6);
    const StyledVolume fine = volumeOf(voxelsOf({512, 1, 1}, one), {2.0f, 1.0f / 256, 1.0f / 256}, {});
    EXPECT_NEAR(offsetOf(fine, {1, 0, 0}), 1.5 / 64.0, 1e-6);
}

/// What samples a voxel apart from `start` on show of their light, seen from it: front to back.
double shownTowardsTheLight(const StyledVolume& volume, const dvec3& start, const dvec3& away, double phase,
                            const std::function<double(const dvec3&)>& opacityAt)
{
    double shown = 0.0, clear = 1.0;
    for (double step = phase; clear > 1e-3 && step < 200.0; step += 1.0) {
        const dvec3 at = start + away * (step * volume.unitLength);
        const double opacity = opacityAt(at);
        if (opacity > 0.0) shown += clear * opacity * lightAt(volume, at);
        clear *= 1.0 - opacity;
    }
    return shown / (1.0 - clear);
}

// A floor below y = 0, in a cube of 1: its opacity rises over the voxel between two centres, which may be
// four times as high as wide.
TEST(Shadows, ofAFaceDoNotFallOnItself)
{
    for (const auto& [size, height] : {std::pair(16, 16), {40, 40}, {40, 10}, {64, 16}})
        for (const glm::vec3 direction : {glm::vec3(0, -1, 0), glm::vec3(0.3f, -1, 0.2f)}) {
            const StyleLight light = sunOf(direction);
            const StyledVolume volume = shadowed(volumeOf(
                voxelsOf({size, height, size}, [](const dvec3& place) { return place.y < 0.5 ? 1.0 : 0.0; }),
                glm::vec3(1.0f), {light}));
            const auto opacityAt = [&](const dvec3& at) { return std::clamp(0.5 - at.y * height, 0.0, 1.0); };
            const dvec3 away(light.direction);
            for (double phase = 0.0; phase < 1.0; phase += 0.05)
                EXPECT_GT(shownTowardsTheLight(volume, -away * (4.0 / height), away, phase, opacityAt),
                          1.0 - 4.0 / 255.0)
                    << size << " x " << height << ", " << phase;
        }
}

// Between the light and the floor, 2 voxels thick.
TEST(Shadows, ofABlockAreAsDarkAsItIsThick)
{
    const double opacity = 102.0 / 255.0;
    for (const int size : {16, 40}) {
        const double low = 0.7, voxel = 1.0 / size;
        const auto valueAt = [&](const dvec3& place) {
            if (place.y < 0.5) return 1.0;
            const bool isBlock = place.x > 0.5 && place.y > low && place.y < low + 2.0 * voxel;
            return isBlock ? opacity : 0.0;
        };
        const StyledVolume volume =
            shadowed(volumeOf(voxelsOf({size, size, size}, valueAt), glm::vec3(1.0f), {sunOf({0, -1, 0})}));
        // A voxel between the two centres, and one at either side over which the opacity goes from 0 to O.
        const double clear = 1.0 - opacity;
        const double ramp = (clear * std::log(clear) + opacity) / opacity;
        const double expected = clear * std::exp(-2.0 * ramp);
        for (const double x : {0.15, 0.3}) {
            EXPECT_NEAR(lightAt(volume, {x, 0.02, 0.1}), expected, 0.02) << size << ", " << x;
            EXPECT_GT(lightAt(volume, {-x, 0.02, 0.1}), 0.99) << size << ", " << x;
        }
    }
}

/// Solid within the ball, else clear.
double ball(const dvec3& place, const dvec3& center, double radius)
{
    return glm::distance(place, center) < radius ? 1.0 : 0.0;
}

// A ball of radius 0.2 at a height of 0.2, with a plate at -0.4, in a cube of 1.
TEST(Shadows, ofABallLieOnThePlateBehindIt)
{
    const auto valueAt = [](const dvec3& place) {
        return place.y < 0.1 ? 1.0 : ball(place, {0.5, 0.7, 0.5}, 0.2);
    };
    const dvec3 center(0.0, 0.2, 0.0);
    const double plate = -0.38;
    for (const StyleLight& light : {sunOf({0.4f, -1, 0.2f}), lampAt({-0.3f, 1.4f, 0.2f})}) {
        StyledVolume volume = volumeOf(voxelsOf({64, 64, 64}, valueAt), glm::vec3(1.0f), {light});
        volume.unitLength = 1.0 / 64.0;
        volume = shadowed(volume);
        const bool isFar = light.kind == StyleLight::Kind::directional;
        const dvec3 way = isFar ? dvec3(light.direction) : center - dvec3(light.position);
        const dvec3 middle = center + way * ((plate - center.y) / way.y);
        EXPECT_LT(lightAt(volume, middle), 0.02);
        int dark = 0, lit = 0;
        for (double x = -0.45; x < 0.46; x += 0.05)
            for (double z = -0.45; z < 0.46; z += 0.05) {
                const dvec3 at(x, plate, z);
                // How far the straight way to the light passes the ball.
                const dvec3 L = glm::normalize(isFar ? -way : dvec3(light.position) - at);
                const double distance = glm::length(glm::cross(center - at, L));
                if (distance < 0.18) {
                    EXPECT_LT(lightAt(volume, at), 0.02) << x << " " << z;
                    ++dark;
                } else if (distance > 0.23) {
                    EXPECT_GT(lightAt(volume, at), 0.98) << x << " " << z;
                    ++lit;
                }
            }
        EXPECT_GT(dark, 20);
        EXPECT_GT(lit, 100);
    }
}

/// Long, so that shadows along x have few texels.
const glm::vec3 kLong(1.0f, 0.5f, 0.5f), kThin(1.0f, 0.25f, 0.125f);

/// One half solid: x above 0.
std::shared_ptr<VoxelTexture> halfSolid()
{
    return voxelsOf({32, 32, 32}, [](const dvec3& place) { return place.x > 0.5 ? 1.0 : 0.0; });
}

TEST(Shadows, ofWhatIsNotDrawnAreNone)
{
    const StyleLight light = sunOf({-1, 0, 0});
    const dvec3 behind(-0.3, 0, 0);
    StyledVolume solid = volumeOf(halfSolid(), kLong, {light});
    solid.unitLength = 0.25; // of which the rise of a voxel is little
    EXPECT_LT(lightAt(shadowed(solid), behind), 0.01);
    StyledVolume clipped = solid;
    clipped.worldFromLocal[3] = {5, 0, 0, 1};
    clipped.clipPlanes = {{-1, 0, 0, 5}};
    EXPECT_GT(lightAt(shadowed(clipped), behind), 0.95);
    StyledVolume segmented = solid;
    segmented.segments = Segments{halfSolid(), 0, 1.0f, {0, -1}, 0};
    EXPECT_GT(lightAt(shadowed(segmented), behind), 0.95);
    segmented.segments->chainOf = {0, 0};
    EXPECT_LT(lightAt(shadowed(segmented), behind), 0.01);
    OpacityMap reversed;
    reversed.opaqueAtZero = true;
    segmented.chains.push_back({makeStyle(reversed)});
    segmented.segments->chainOf = {0, 1};
    EXPECT_GT(lightAt(shadowed(segmented), behind), 0.95);
}

TEST(Shadows, ofStylesThatLookAtTheEyeAreThoseOfTheirFaces)
{
    StyledVolume volume = volumeOf(voxelsOf({32, 1, 1}, [](const dvec3& place) { return place.x; }), kLong,
                                   {sunOf({-1, 0, 0})});
    const dvec3 at(-0.3, 0, 0);
    SilhouetteEnhancement rim;
    rim.retainedOpacity = 0.0f;
    rim.boundaryOpacity = 1.0f;
    volume.chains = {{makeStyle(rim), shadedWithShadows()}};
    EXPECT_GT(lightAt(shadowed(volume), at), 0.99);
    rim.retainedOpacity = 1.0f;
    volume.chains = {{makeStyle(rim), shadedWithShadows()}};
    EXPECT_LT(lightAt(shadowed(volume), at), 0.5);
}

TEST(Shadows, ofSurfacesFallBehindThem)
{
    StyledVolume volume = volumeOf(halfSolid(), kLong, {sunOf({-1, 0, 0})});
    volume.surfaces = IsoSurfaces{{0.5f}, {{makeStyle(OpacityMap{}), shadedWithShadows()}}, 0.0f, nullptr};
    const StyledVolume shown = shadowed(volume);
    EXPECT_NEAR(lightAt(shown, {-0.3, 0.1, 0.2}), 0.5, 0.003);
    EXPECT_GT(lightAt(shown, {0.3, 0.1, 0.2}), 0.99);
    volume.clipPlanes = {{-1, 0, 0, -0.1}};
    EXPECT_GT(lightAt(shadowed(volume), {-0.3, 0.1, 0.2}), 0.99);
}

/// Takes what a style is given.
class Recorder final : public Style
{
public:
    explicit Recorder(ShadowTextures given = {}) : textures(std::move(given)) {}
    bool asksForShadows() const override { return true; }
    std::shared_ptr<const Style> withShadows(const ShadowTextures& given) const override
    {
        return std::make_shared<Recorder>(given);
    }
    void apply(const StyleSurroundings&, SampleBatch&) const override {}
    void write(GlslChain&) const override {}

    ShadowTextures textures;
};

/// Of a volume whose first style records.
std::shared_ptr<const VoxelTexture> textureOf(const StyledVolume& volume, std::size_t number = 0)
{
    return dynamic_cast<const Recorder&>(*volume.chains[0][0]).textures.textures.at(number);
}

TEST(Shadows, areKeptWhileNothingChanges)
{
    StyledVolume plain = volumeOf(halfSolid(), kThin, {sunOf({-1, 0, 0}), lampAt({2, 3, 4})});
    plain.chains = {{std::make_shared<Recorder>(), makeStyle(OpacityMap{})}};
    ShadowStore store;
    const auto textureFor = [&](StyledVolume volume) {
        store.add(volume, 0);
        return textureOf(volume);
    };
    const auto first = textureFor(plain);
    EXPECT_EQ(textureFor(plain), first);
    StyledVolume changed = plain;
    changed.chains[0][1] = makeStyle(OpacityMap{}); // the same in another place
    changed.surroundings.lights[0].intensity = 0.3f;
    EXPECT_EQ(textureFor(changed), first);
    OpacityMap reversed;
    reversed.opaqueAtZero = true;
    changed.chains[0][1] = makeStyle(reversed);
    EXPECT_NE(textureFor(changed), first);
    EXPECT_EQ(textureFor(plain), first);
    changed = plain;
    changed.unitLength *= 2.0;
    EXPECT_NE(textureFor(changed), first);
    changed = plain;
    changed.clipPlanes = {{1, 0, 0, 0}};
    EXPECT_NE(textureFor(changed), first);
    changed = plain;
    changed.voxels = halfSolid();
    EXPECT_NE(textureFor(changed), first);
    changed = inTetras(plain);
    const auto ofTetras = textureFor(changed);
    EXPECT_NE(ofTetras, first);
    EXPECT_EQ(textureFor(changed), ofTetras);
    EXPECT_NE(textureFor(inTetras(plain)), ofTetras);
    changed = plain;
    changed.surroundings.lights[1].position.x = 7.0f;
    EXPECT_NE(textureFor(changed), first);
}

TEST(Shadows, ofFourLightsAreInOneTexture)
{
    StyledVolume volume = volumeOf(halfSolid(), kThin, {});
    for (int i = 0; i < 9; ++i)
        volume.surroundings.lights.push_back(i == 5 ? sunOf({-1, 0, 0}) : sunOf({1, 0, 0}));
    volume.chains = {{std::make_shared<Recorder>()}};
    const StyledVolume nine = shadowed(volume);
    EXPECT_EQ(textureOf(nine)->components, 4);
    const VoxelTexture& second = *textureOf(nine, 1);
    EXPECT_EQ(second.components, 4);
    EXPECT_THROW(textureOf(nine, 2), std::out_of_range);
    EXPECT_EQ(second.size, (VoxelSize{128, 32, 16}));
    std::array<std::uint16_t, 4> texel{};
    std::memcpy(texel.data(), second.texels.data(), sizeof texel);
    EXPECT_LT(texel[1], 100);
    texel[1] = 0;
    EXPECT_EQ(texel, (std::array<std::uint16_t, 4>{65535, 0, 65535, 65535}));
    volume.surroundings.lights.resize(5);
    EXPECT_EQ(textureOf(shadowed(volume), 1)->components, 1);
}

TEST(Shadows, haveTexelsByTheSidesOfTheBox)
{
    StyledVolume volume = volumeOf(halfSolid(), {0.5f, 2.0f, 0.001f}, {sunOf({-1, 0, 0})});
    volume.chains = {{std::make_shared<Recorder>()}};
    EXPECT_EQ(textureOf(shadowed(volume))->size, (VoxelSize{32, 128, 1}));
}

TEST(Shadows, areForStylesThatAskForThem)
{
    Shaded shaded;
    EXPECT_FALSE(makeStyle(shaded)->asksForShadows());
    shaded.shadows = true;
    EXPECT_FALSE(makeStyle(shaded)->asksForShadows());
    EXPECT_EQ(makeStyle(shaded)->withShadows({}), nullptr);
    EXPECT_TRUE(shadedWithShadows()->asksForShadows());
    Blended blended;
    EXPECT_FALSE(makeStyle(blended)->asksForShadows());
    blended.chain = {shadedWithShadows()};
    EXPECT_TRUE(makeStyle(blended)->asksForShadows());
    EXPECT_TRUE(makeStyle(blended)->withShadows({})->asksForShadows());
}

TEST(Shadows, ofVolumesWithoutSenseAreNone)
{
    const auto recorded = [](StyledVolume volume) {
        volume.chains = {{std::make_shared<Recorder>()}};
        ShadowStore().add(volume, 0);
        return dynamic_cast<const Recorder&>(*volume.chains[0][0]).textures.textures.size();
    };
    const StyledVolume whole = volumeOf(halfSolid(), kThin, {sunOf({-1, 0, 0})});
    EXPECT_EQ(recorded(whole), 1u);
    StyledVolume volume = whole;
    volume.voxels = nullptr;
    EXPECT_EQ(recorded(volume), 0u);
    volume = whole;
    volume.dimensions.x = 0.0f;
    EXPECT_EQ(recorded(volume), 0u);
    auto few = std::make_shared<VoxelTexture>();
    few->size = {4, 4, 4};
    volume = whole;
    volume.voxels = few;
    EXPECT_EQ(recorded(volume), 0u);
    volume = whole;
    volume.tetras = std::make_shared<StyledTetras>();
    EXPECT_EQ(recorded(volume), 0u);
    volume = whole;
    const float none = std::numeric_limits<float>::quiet_NaN();
    volume.surroundings.lights = {lampAt({none, 0, 0}), sunOf({0, 0, 0}), lampAt({0, none, 1})};
    EXPECT_EQ(recorded(volume), 1u);
}

} // namespace
} // namespace vo
