#include "style_cases.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <random>
#include <span>

namespace vo::test {

namespace {

using Random = std::mt19937;

float unit(Random& random)
{
    // Not std::uniform_real_distribution: the same numbers everywhere.
    return static_cast<float>(random() >> 8) / 16777216.0f;
}

glm::vec3 direction(Random& random)
{
    for (;;) {
        const glm::vec3 at(2.0f * unit(random) - 1.0f, 2.0f * unit(random) - 1.0f,
                           2.0f * unit(random) - 1.0f);
        const float length = glm::length(at);
        if (length > 0.1f && length < 1.0f) return at / length;
    }
}

TexturePointer randomTexture(VoxelSize size, int components, unsigned seed)
{
    Random random(seed);
    std::vector<float> values(size.count() * static_cast<std::size_t>(components));
    for (float& value : values)
        value = unit(random);
    auto made = std::make_shared<VoxelTexture>();
    made->size = size;
    made->components = components;
    made->kind = TexelKind::float32;
    const auto bytes = std::as_bytes(std::span(values));
    made->texels.assign(bytes.begin(), bytes.end());
    return made;
}

StyleSurroundings threeLights()
{
    StyleLight sun;
    sun.direction = {0.6f, 0.0f, -0.8f};
    sun.color = {0.9f, 0.8f, 0.3f};
    sun.intensity = 0.4f;
    sun.ambientIntensity = 0.3f;
    StyleLight lamp;
    lamp.kind = StyleLight::Kind::point;
    lamp.position = {0.7f, 1.5f, 0.2f};
    lamp.attenuation = {0.5f, 0.3f, 0.9f};
    lamp.radius = 1.6f;
    lamp.intensity = 0.7f;
    StyleLight spot;
    spot.kind = StyleLight::Kind::spot;
    spot.position = {-1.0f, 0.0f, 1.0f};
    spot.direction = glm::normalize(glm::vec3(1.0f, 0.1f, -1.0f));
    spot.beamWidth = 0.2f;
    spot.cutOffAngle = 0.5f;
    spot.color = {0.2f, 0.5f, 1.0f};
    spot.ambientIntensity = 0.2f;
    return {{sun, lamp, spot}};
}

void addOpacityMaps(std::vector<StyleCase>& cases)
{
    for (int components = 1; components <= 4; ++components) {
        const std::string voxel = "voxels of " + std::to_string(components);
        cases.push_back({"OpacityMap, " + voxel, {OpacityMap{{}, false, components}}, {}});
        cases.push_back({"OpacityMap of 2005, " + voxel, {OpacityMap{{}, true, components}}, {}});
        for (int texels = 1; texels <= 4; ++texels) {
            const TexturePointer function = randomTexture({7, 4, 3}, texels, 5);
            cases.push_back({"OpacityMap, function of " + std::to_string(texels) + ", " + voxel,
                             {OpacityMap{function, false, components}},
                             {}});
        }
    }
    auto nearest = std::make_shared<VoxelTexture>(*randomTexture({16, 1, 1}, 4, 6));
    nearest->nearest = true;
    nearest->repeats = {true, true, true};
    cases.push_back({"OpacityMap, nearest texel", {OpacityMap{nearest, false, 1}}, {}});
}

void addGradientStyles(std::vector<StyleCase>& cases)
{
    const TexturePointer normals = randomTexture({3, 4, 5}, 3, 7);
    const StyleSurroundings lights = threeLights();
    cases.push_back({"Boundary", {BoundaryEnhancement{}}, {}});
    cases.push_back({"Boundary, factor 0", {BoundaryEnhancement{0.1f, 0.6f, 0.0f}}, {}});
    cases.push_back({"Boundary, steep", {BoundaryEnhancement{0.5f, 20.0f, 0.7f}}, {}});
    cases.push_back({"Edge", {EdgeEnhancement{{0.9f, 0.1f, 0.3f, 1}, 0.4f, {}}}, {}});
    cases.push_back({"Edge, threshold 0", {EdgeEnhancement{{0.9f, 0.1f, 0.3f, 1}, 0.0f, {}}}, {}});
    cases.push_back({"Edge, normals given", {EdgeEnhancement{{0.9f, 0.1f, 0.3f, 1}, 1.0f, normals}}, {}});
    cases.push_back({"Silhouette", {SilhouetteEnhancement{}}, {}});
    cases.push_back({"Silhouette, rim", {SilhouetteEnhancement{0.2f, 0.9f, 0.5f, {}}}, {}});
    cases.push_back({"Silhouette, sharpness 0", {SilhouetteEnhancement{0.2f, 0.3f, 0.0f, {}}}, {}});
    cases.push_back({"Silhouette, normals given", {SilhouetteEnhancement{0.1f, 1.0f, 3.0f, normals}}, {}});
    cases.push_back({"ToneMapped", {ToneMapped{}}, {{lights.lights[1]}}});
    cases.push_back({"ToneMapped, no light", {ToneMapped{}}, {}});
    cases.push_back({"ToneMapped, three lights",
                     {ToneMapped{{0.1f, 0.2f, 0.4f, 0}, {0.3f, 0.3f, 0.1f, 0}, normals}},
                     lights});
}

void addCartoons(std::vector<StyleCase>& cases)
{
    const TexturePointer normals = randomTexture({3, 4, 5}, 3, 7);
    const glm::vec4 orange(1, 0.6f, 0.1f, 0.9f);
    const glm::vec4 purple(0.5f, 0.1f, 0.8f, 0.4f);
    cases.push_back({"Cartoon", {Cartoon{}}, {}});
    for (const int steps : {1, 2, 3, 7, 64}) {
        const std::string name = "Cartoon of " + std::to_string(steps);
        cases.push_back({name, {Cartoon{orange, purple, steps, {}}}, {}});
        cases.push_back({name + ", the other way", {Cartoon{purple, orange, steps, {}}}, {}});
    }
    cases.push_back({"Cartoon, grey", {Cartoon{{0.5f, 0.5f, 0.5f, 1}, {0, 0.8f, 0.8f, 1}, 5, {}}}, {}});
    cases.push_back({"Cartoon, normals given", {Cartoon{orange, purple, 6, normals}}, {}});
}

Shaded material()
{
    Shaded shaded;
    shaded.lighting = true;
    shaded.hasMaterial = true;
    shaded.diffuse = {0.6f, 0.3f, 0.2f};
    shaded.emissive = {0.0f, 0.1f, 0.05f};
    shaded.specular = {0.8f, 0.7f, 0.6f};
    shaded.transparency = 0.25f;
    return shaded;
}

void addShaded(std::vector<StyleCase>& cases)
{
    const StyleSurroundings lights = threeLights();
    Shaded shaded = material();
    cases.push_back({"Shaded, material", {shaded}, lights});
    cases.push_back({"Shaded, no light", {shaded}, {}});
    shaded.shininess = 0.0f;
    cases.push_back({"Shaded, shininess 0", {shaded}, lights});
    shaded.shininess = 1.0f;
    cases.push_back({"Shaded, shininess 1", {shaded}, lights});
    shaded.surfaceNormals = randomTexture({3, 4, 5}, 4, 8);
    cases.push_back({"Shaded, normals given", {shaded}, lights});
    shaded.lighting = false;
    cases.push_back({"Shaded, not lit, material", {shaded}, lights});
    cases.push_back({"Shaded, not lit", {Shaded{}}, lights});
    shaded = Shaded{};
    shaded.lighting = true;
    cases.push_back({"Shaded", {shaded}, lights});
}

void addShadows(std::vector<StyleCase>& cases)
{
    StyleSurroundings lights = threeLights();
    Shaded shaded = material();
    shaded.shadows = true;
    const LocalBox box{{-0.7f, -1.1f, -0.4f}, {1.2f, 2.0f, 0.9f}};
    shaded.shadowTextures = {{randomTexture({6, 5, 4}, 3, 14)}, box};
    cases.push_back({"Shaded, shadows of three lights", {shaded}, lights});
    lights.lights.insert(lights.lights.end(), lights.lights.begin(), lights.lights.begin() + 2);
    shaded.shadowTextures.textures = {randomTexture({6, 5, 4}, 4, 15), randomTexture({6, 5, 4}, 1, 16)};
    cases.push_back({"Shaded, shadows of five lights", {shaded}, lights});
    for (StyleLight& light : lights.lights)
        light.intensity *= 0.3f;
    cases.push_back({"Shaded, shadows of five dim lights", {shaded}, lights});
}

void addBlended(std::vector<StyleCase>& cases)
{
    using Weight = Blended::Weight;
    Blended blended;
    blended.voxels = randomTexture({5, 6, 7}, 1, 9);
    blended.dimensions = {2.0f, 3.0f, 1.5f};
    cases.push_back({"Blended", {blended}, {}});
    blended.voxels = randomTexture({5, 6, 7}, 4, 10);
    blended.weightConstant2 = 0.9f;
    blended.chain = {
        styleWithReference(BoundaryEnhancement{0.2f, 2.0f, 0.5f}),
        styleWithReference(EdgeEnhancement{{0.9f, 0.1f, 0.3f, 1}, 0.4f, {}}),
        styleWithReference(material()),
    };
    int number = 0;
    for (const Weight weight : {Weight::constant, Weight::alpha0, Weight::alpha1, Weight::oneMinusAlpha0,
                                Weight::oneMinusAlpha1, Weight::table}) {
        const std::string name = "Blended, weight " + std::to_string(number++);
        blended.weightTransferFunction1 = randomTexture({4, 3, 1}, 1, 11);
        blended.weightTransferFunction2 = randomTexture({3, 5, 1}, 3, 12);
        blended.weightFunction1 = weight;
        blended.weightFunction2 = Weight::constant;
        cases.push_back({name + " of the first", {blended}, threeLights()});
        blended.weightFunction1 = Weight::constant;
        blended.weightFunction2 = weight;
        cases.push_back({name + " of the second", {blended}, threeLights()});
    }
    blended.weightTransferFunction2.reset();
    cases.push_back({"Blended, table missing", {blended}, threeLights()});
    Blended outer;
    outer.voxels = randomTexture({3, 3, 3}, 2, 13);
    outer.chain = {styleWithReference(OpacityMap{{}, true, 2}), styleWithReference(blended)};
    cases.push_back({"Blended in Blended", {OpacityMap{}, outer, Cartoon{}}, threeLights()});
}

double rounded(double value)
{
    return static_cast<double>(static_cast<float>(value));
}

} // namespace

StyleChain StyleCase::chain() const
{
    StyleChain made;
    for (const ReferenceStyle& style : styles)
        made.push_back(styleWithReference(style));
    return made;
}

std::vector<StyleCase> styleCases()
{
    std::vector<StyleCase> cases;
    addOpacityMaps(cases);
    addGradientStyles(cases);
    addCartoons(cases);
    addShaded(cases);
    addShadows(cases);
    addBlended(cases);
    cases.push_back({"composed",
                     {OpacityMap{randomTexture({32, 1, 1}, 4, 3)}, BoundaryEnhancement{}, EdgeEnhancement{},
                      SilhouetteEnhancement{0.5f, 0.5f, 1.0f, {}}, material()},
                     threeLights()});
    return cases;
}

std::vector<ReferenceSample> caseSamples()
{
    Random random(1);
    std::vector<ReferenceSample> samples(1000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        ReferenceSample& sample = samples[i];
        for (int c = 0; c < 4; ++c)
            sample.voxel[c] = rounded(static_cast<double>(unit(random)));
        if (i % 20 == 0) sample.voxel = glm::dvec4(i % 40 == 0 ? 0.0 : 1.0);
        for (int axis = 0; axis < 3; ++axis) {
            sample.place[axis] = static_cast<double>(unit(random));
            sample.Cv[axis] = static_cast<double>(unit(random));
        }
        sample.position = sample.place * glm::dvec3(2.0, 3.0, 1.5) - glm::dvec3(1.0, 1.5, 0.75);
        for (int axis = 0; axis < 3; ++axis)
            sample.position[axis] = rounded(sample.position[axis]);
        sample.V = glm::dvec3(direction(random));
        sample.n = glm::dvec3(direction(random));
        if (i % 16 == 1) sample.n = sample.V;
        sample.gradient = rounded(0.8 * static_cast<double>(unit(random)));
        sample.Ov = i % 10 == 3 ? 0.0 : static_cast<double>(unit(random));
        if (i % 16 != 0) continue;
        sample.n = glm::dvec3(0.0);
        sample.gradient = 0.0;
    }
    return samples;
}

std::vector<glm::dvec4> referenceColors(const StyleCase& styleCase,
                                        const std::vector<ReferenceSample>& samples)
{
    std::vector<glm::dvec4> colors;
    for (ReferenceSample sample : samples) {
        for (const ReferenceStyle& style : styleCase.styles)
            referenceStep(style, styleCase.surroundings, sample);
        colors.emplace_back(sample.Cv, sample.Ov);
    }
    return colors;
}

double psnr(const std::vector<glm::dvec4>& expected, const std::vector<glm::vec4>& found)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const glm::dvec4 difference = glm::dvec4(found.at(i)) - expected[i];
        sum += glm::dot(difference, difference) / 4.0;
    }
    // A number that is none counts as no likeness at all.
    if (!(sum >= 0.0)) return 0.0;
    if (sum == 0.0) return std::numeric_limits<double>::infinity();
    return -10.0 * std::log10(sum / static_cast<double>(expected.size()));
}

} // namespace vo::test
