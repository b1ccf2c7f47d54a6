// Styles of nodes with their defaults in all editions, by what they make of a sample.

#include <gtest/gtest.h>

#include "view_scene.h"

#include <array>
#include <cmath>

namespace vo {
namespace {

const std::string kGrey = "<PixelTexture3D image='1 2 2 2 0 255 0 0 0 0 0 0'/>";

/// A sample of a grey voxel that is seen from +z.
struct Sample
{
    float value = 0.25f;
    glm::vec3 n{0, 0, 1};
    float gradient = 0.5f;
};

glm::vec4 madeOf(const StyleChain& chain, const StyleSurroundings& surroundings, const Sample& sample)
{
    SampleBatch batch{};
    batch.count = 1;
    for (BatchFloats& component : batch.voxel)
        component.fill(sample.value);
    batch.place[0].fill(0.5f);
    batch.place[1].fill(0.5f);
    batch.place[2].fill(0.5f);
    batch.V[2].fill(1.0f);
    for (int axis = 0; axis < 3; ++axis)
        batch.n[static_cast<std::size_t>(axis)].fill(sample.n[axis]);
    batch.gradient.fill(sample.gradient);
    firstColor(1, batch);
    for (const auto& style : chain)
        style->apply(surroundings, batch);
    return {batch.Cv[0][0], batch.Cv[1][0], batch.Cv[2][0], batch.Ov[0]};
}

void expectNear(const glm::vec4& found, const glm::vec4& expected)
{
    for (int i = 0; i < 4; ++i)
        EXPECT_NEAR(found[i], expected[i], 2e-5f) << "component " << i;
}

/// A volume of greys with a style, in a version of X3D; the headlight is off.
struct StyledGrey : ViewedScene
{
    StyledGrey(const std::string& style, const std::string& version, const std::string& more = "")
        : ViewedScene("<NavigationInfo headlight='false'/>" + more + "<VolumeData>" + kGrey + style +
                          "</VolumeData>",
                      version)
    {
        EXPECT_EQ(messages(), "");
    }

    glm::vec4 of(const Sample& sample = {}) const
    {
        const StyledVolume& volume = drawn.volumes.at(0);
        return madeOf(volume.chains.at(0), volume.surroundings, sample);
    }
};

/// The sample's normal at 60 degrees to the view.
const Sample kTurned{0.25f, {std::sqrt(0.75f), 0, 0.5f}, 0.5f};
const std::array kVersions{"3.0", "3.3", "4.0"};

TEST(VolumeStyles, withoutStyleAnOpacityMapOfTheEditionDraws)
{
    expectNear(StyledGrey("", "3.0").of(), {0.25f, 0.25f, 0.25f, 0.75f});
    expectNear(StyledGrey("", "3.3").of(), {0.25f, 0.25f, 0.25f, 0.25f});
    expectNear(StyledGrey("", "4.0").of(), {0.25f, 0.25f, 0.25f, 0.25f});
}

TEST(VolumeStyles, opacityMapHasItsEditionsDefault)
{
    expectNear(StyledGrey("<OpacityMapVolumeStyle/>", "3.2").of(), {0.25f, 0.25f, 0.25f, 0.75f});
    expectNear(StyledGrey("<OpacityMapVolumeStyle/>", "3.3").of(), {0.25f, 0.25f, 0.25f, 0.25f});
    expectNear(StyledGrey("<OpacityMapVolumeStyle/>", "4.0").of(), {0.25f, 0.25f, 0.25f, 0.25f});
}

TEST(VolumeStyles, transferFunctionIsATableWhoseEndsStay)
{
    // Two texels with centres at 1/4 and 3/4; what is repeated would mix both at 0.
    for (const char* const version : kVersions) {
        const StyledGrey s("<OpacityMapVolumeStyle><PixelTexture image='2 1 4 0xFF000080 0x0000FF40' "
                           "containerField='transferFunction'/></OpacityMapVolumeStyle>",
                           version);
        expectNear(s.of({0.0f}), {1, 0, 0, 128 / 255.0f});
        expectNear(s.of({0.5f}), {0.5f, 0, 0.5f, 96 / 255.0f});
        expectNear(s.of({1.0f}), {0, 0, 1, 64 / 255.0f});
    }
}

TEST(VolumeStyles, boundaryEnhancementHasItsEditionsDefaults)
{
    const std::string style = "<BoundaryEnhancementVolumeStyle/>";
    expectNear(StyledGrey(style, "3.0").of(), {0.25f, 0.25f, 0.25f, 0.25f});
    const float iso = 0.25f * (0.2f + 0.9f * 0.25f);
    expectNear(StyledGrey(style, "3.3").of(), {0.25f, 0.25f, 0.25f, iso});
    expectNear(StyledGrey(style, "4.0").of(), {0.25f, 0.25f, 0.25f, iso});
    expectNear(StyledGrey("<BoundaryEnhancementVolumeStyle retainedOpacity='0.5' boundaryOpacity='0.25' "
                          "opacityFactor='3'/>",
                          "4.0")
                   .of(),
               {0.25f, 0.25f, 0.25f, 0.25f * (0.5f + 0.25f * 0.125f)});
}

TEST(VolumeStyles, boundaryEnhancementOf2005HasATransferFunctionFirst)
{
    const StyledGrey s(
        "<BoundaryEnhancementVolumeStyle retainedOpacity='0.5'><PixelTexture image='1 1 4 0x00FF0080' "
        "containerField='transferFunction'/></BoundaryEnhancementVolumeStyle>",
        "3.0");
    expectNear(s.of(), {0, 1, 0, 64 / 255.0f});
}

TEST(VolumeStyles, gradientColorIsMixedInWhereTheValueChanges)
{
    const StyledGrey s("<BoundaryEnhancementVolumeStyle retainedOpacity='0.5' gradientColor='1 0.5 0 0.5'/>",
                       "3.0");
    expectNear(s.of({0.25f, {0, 0, 1}, 0.0f}), {0.25f, 0.25f, 0.25f, 0.125f});
    expectNear(s.of({0.25f, {0, 0, 1}, 0.25f}),
               {0.75f * 0.25f + 0.25f, 0.75f * 0.25f + 0.125f, 0.75f * 0.25f, 0.125f});
    // A leap between neighbours is 1/2, along several edges more.
    for (const float gradient : {0.5f, 0.8f})
        expectNear(s.of({0.25f, {0, 0, 1}, gradient}), {0.625f, 0.375f, 0.125f, 0.125f});
}

TEST(VolumeStyles, boundaryEnhancementTellsOfNormalsOfAnotherSize)
{
    const ViewedScene s("<VolumeData>" + kGrey +
                            "<BoundaryEnhancementVolumeStyle><PixelTexture3D "
                            "containerField='surfaceNormals' image='3 1 1 1 0'/>"
                            "</BoundaryEnhancementVolumeStyle></VolumeData>",
                        "3.0");
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: BoundaryEnhancementVolumeStyle.surfaceNormals is in no equation and changes "
              "nothing\n"
              "s.x3d:2: warning: BoundaryEnhancementVolumeStyle: expected normals of the voxels' size, "
              "2 x 2 x 2, with 3 components, found 1 x 1 x 1 with 3: computed from the voxels instead\n");
}

TEST(VolumeStyles, cartoonIsTheSameInAllEditions)
{
    for (const char* const version : kVersions) {
        const StyledGrey s("<CartoonVolumeStyle/>", version);
        expectNear(s.of(), {1, 1, 1, 0.25f});
        // The third of four parts of the right angle.
        expectNear(s.of(kTurned), {0.375f, 0.375f, 0.375f, 0.25f});
        expectNear(s.of({0.25f, {0, 0, -1}, 0.5f}), {0, 0, 0, 0});
        const StyledGrey two("<CartoonVolumeStyle colorSteps='2' parallelColor='1 0 0 0.5'/>", version);
        expectNear(two.of(kTurned), {1, 0, 0, 0.125f});
    }
}

TEST(VolumeStyles, edgeEnhancementIsTheSameInAllEditions)
{
    for (const char* const version : kVersions) {
        const StyledGrey s("<EdgeEnhancementVolumeStyle/>", version);
        expectNear(s.of(), {0.25f, 0.25f, 0.25f, 0.25f});
        expectNear(s.of(kTurned), {0.125f, 0.125f, 0.125f, 0.25f});
        const StyledGrey wide("<EdgeEnhancementVolumeStyle gradientThreshold='1.1' edgeColor='1 0 0 1'/>",
                              version);
        expectNear(wide.of(kTurned), {0.25f, 0.25f, 0.25f, 0.25f});
    }
}

TEST(VolumeStyles, silhouetteHasItsEditionsEquation)
{
    const std::string style = "<SilhouetteEnhancementVolumeStyle/>";
    expectNear(StyledGrey(style, "3.0").of(kTurned), {0.25f, 0.25f, 0.25f, 0.25f * std::sqrt(0.5f)});
    expectNear(StyledGrey(style, "3.3").of(kTurned), {0.25f, 0.25f, 0.25f, 0.25f});
    expectNear(StyledGrey(style, "4.0").of(kTurned), {0.25f, 0.25f, 0.25f, 0.25f});
    expectNear(StyledGrey("<SilhouetteEnhancementVolumeStyle silhouetteFactor='2'/>", "3.0").of(kTurned),
               {0.25f, 0.25f, 0.25f, 0.0625f});
    expectNear(
        StyledGrey(
            "<SilhouetteEnhancementVolumeStyle silhouetteSharpness='2' silhouetteRetainedOpacity='0.5' "
            "silhouetteBoundaryOpacity='1'/>",
            "4.0")
            .of(kTurned),
        {0.25f, 0.25f, 0.25f, 0.25f * 0.75f});
}

TEST(VolumeStyles, toneMappedGoesByTheLight)
{
    const std::string light = "<DirectionalLight direction='0 0 -1'/>";
    for (const char* const version : kVersions) {
        const StyledGrey s("<ToneMappedVolumeStyle/>", version, light);
        expectNear(s.of(), {1, 1, 0, 0.25f});
        expectNear(s.of({0.25f, {0, 0, -1}, 0.5f}), {0, 0, 1, 0.25f});
        const StyledGrey own("<ToneMappedVolumeStyle warmColor='1 0 0 0' coolColor='0 1 0 0'/>", version,
                             light);
        expectNear(own.of(kTurned), {0.75f, 0.25f, 0, 0.25f});
    }
}

TEST(VolumeStyles, shadedTakesItsMaterial)
{
    const std::string light = "<DirectionalLight direction='0 0 -1' intensity='0.5'/>";
    for (const char* const version : {"3.3", "4.0"}) {
        expectNear(StyledGrey("<ShadedVolumeStyle/>", version, light).of(kTurned),
                   {0.25f, 0.25f, 0.25f, 0.25f});
        expectNear(StyledGrey("<ShadedVolumeStyle lighting='true'/>", version, light).of(kTurned),
                   {0.0625f, 0.0625f, 0.0625f, 0.25f});
        const StyledGrey own("<ShadedVolumeStyle lighting='true'><Material diffuseColor='1 0.5 0' "
                             "emissiveColor='0 0 0.25' transparency='0.5'/></ShadedVolumeStyle>",
                             version, light);
        expectNear(own.of(kTurned), {0.25f, 0.125f, 0.25f, 0.125f});
    }
}

TEST(VolumeStyles, isoSurfaceOf2005IsSolidAtTheMiddle)
{
    const StyledGrey s("<ISOSurfaceVolumeStyle lighting='true'/>", "3.0",
                       "<DirectionalLight direction='0 0 -1'/>");
    const StyledVolume& volume = s.drawn.volumes.at(0);
    ASSERT_TRUE(volume.surfaces);
    EXPECT_EQ(volume.surfaces->values, std::vector<float>{0.5f});
    EXPECT_FALSE(volume.surfaces->chains.at(0).at(0)->keepsClear()) << "clear voxels become solid";
    Sample sample = kTurned;
    sample.value = 0.5f;
    expectNear(madeOf(volume.surfaces->chains.at(0), volume.surroundings, sample), {0.25f, 0.25f, 0.25f, 1});
}

TEST(VolumeStyles, projectionIsNoChain)
{
    for (const char* const version : {"3.3", "4.0"}) {
        const StyledGrey s("<ProjectionVolumeStyle/>", version);
        const StyledVolume& volume = s.drawn.volumes.at(0);
        EXPECT_TRUE(volume.chains.at(0).empty());
        ASSERT_TRUE(volume.projection);
        EXPECT_EQ(volume.projection->type, RayProjection::Type::max);
        EXPECT_EQ(volume.projection->intensityThreshold, 0.0f);
        const StyledGrey min("<ProjectionVolumeStyle type='MIN' intensityThreshold='0.25'/>", version);
        EXPECT_EQ(min.drawn.volumes.at(0).projection->type, RayProjection::Type::min);
        EXPECT_EQ(min.drawn.volumes.at(0).projection->intensityThreshold, 0.25f);
        const StyledGrey mean("<ProjectionVolumeStyle type='AVERAGE'/>", version);
        EXPECT_EQ(mean.drawn.volumes.at(0).projection->type, RayProjection::Type::average);
    }
}

TEST(VolumeStyles, stippleHasTheFactorsOfTheProposal)
{
    const StyledGrey usual("<StippleVolumeStyle/>", "3.0");
    ASSERT_TRUE(usual.drawn.volumes.at(0).stipple);
    const StippleFactors one = *usual.drawn.volumes[0].stipple;
    EXPECT_EQ(glm::vec4(one.distanceFactor, one.interiorFactor, one.lightingFactor, one.resolutionFactor),
              glm::vec4(1.0f));
    EXPECT_EQ(one.gradientThreshold, 0.4f);
    EXPECT_EQ(glm::vec3(one.gradientRetainedOpacity, one.gradientBoundaryOpacity, one.gradientOpacityFactor),
              glm::vec3(1, 0, 1));
    EXPECT_EQ(
        glm::vec3(one.silhouetteRetainedOpacity, one.silhouetteBoundaryOpacity, one.silhouetteOpacityFactor),
        glm::vec3(1, 0, 1));
    const StyledGrey own(
        "<StippleVolumeStyle distanceFactor='2' interiorFactor='3' lightingFactor='4' "
        "resolutionFactor='5' gradientThreshold='0.5' gradientRetainedOpacity='0.1' "
        "gradientBoundaryOpacity='0.2' gradientOpacityFactor='6' silhouetteRetainedOpacity='0.3' "
        "silhouetteBoundaryOpacity='0.4' silhouetteOpacityFactor='7'/>",
        "3.0");
    const StippleFactors two = *own.drawn.volumes.at(0).stipple;
    EXPECT_EQ(glm::vec4(two.distanceFactor, two.interiorFactor, two.lightingFactor, two.resolutionFactor),
              glm::vec4(2, 3, 4, 5));
    EXPECT_EQ(two.gradientThreshold, 0.5f);
    EXPECT_EQ(glm::vec3(two.gradientRetainedOpacity, two.gradientBoundaryOpacity, two.gradientOpacityFactor),
              glm::vec3(0.1f, 0.2f, 6));
    EXPECT_EQ(
        glm::vec3(two.silhouetteRetainedOpacity, two.silhouetteBoundaryOpacity, two.silhouetteOpacityFactor),
        glm::vec3(0.3f, 0.4f, 7));
}

TEST(VolumeStyles, stipplesKnowHowFarTheyWereInTheFirstPicture)
{
    const std::string stippled = "<VolumeData>" + kGrey + "<StippleVolumeStyle/></VolumeData>";
    ViewedScene s("<Viewpoint position='0 0 7'/><Transform translation='0 0 -3'>" + stippled +
                      "</Transform><Transform translation='2 0 1' scale='2 2 2'>" + stippled + "</Transform>",
                  "3.0");
    const auto distance = [&](std::size_t volume) {
        return s.drawn.volumes.at(volume).stipple->originalDistance;
    };
    ViewRequest nearer;
    nearer.camera.emplace();
    nearer.camera->eyeFromWorld[3].z = -5.0;
    for (const ViewRequest& request : {ViewRequest(), nearer}) {
        s.draw(request);
        EXPECT_FLOAT_EQ(distance(0), 10);
        EXPECT_FLOAT_EQ(distance(1), 6);
    }
}

TEST(VolumeStyles, blendedHasOtherVoxelsWithAStyleOfTheirOwn)
{
    const std::string other = "<PixelTexture3D image='1 1 1 1 255'/>";
    for (const char* const version : {"3.3", "4.0"}) {
        expectNear(StyledGrey("<BlendedVolumeStyle>" + other + "</BlendedVolumeStyle>", version).of(),
                   {0.625f, 0.625f, 0.625f, 0.625f});
        const std::string green = "<OpacityMapVolumeStyle><PixelTexture image='1 1 4 0x00FF0080' "
                                  "containerField='transferFunction'/></OpacityMapVolumeStyle>";
        const StyledGrey own("<BlendedVolumeStyle weightConstant1='1' weightFunction2='ONE_MINUS_ALPHA0'>" +
                                 other + green + "</BlendedVolumeStyle>",
                             version);
        expectNear(own.of(), {0.25f, 1, 0.25f, 0.25f + 0.75f * 128 / 255.0f});
        const StyledGrey table("<BlendedVolumeStyle weightFunction1='TABLE' weightConstant2='0'>" + other +
                                   "<PixelTexture image='1 1 1 51' containerField='weightTransferFunction1'/>"
                                   "</BlendedVolumeStyle>",
                               version);
        expectNear(table.of(), {0.05f, 0.05f, 0.05f, 0.05f});
    }
}

TEST(VolumeStyles, blendedWithAnInnerStyleThatIsOffBlendsWithNothing)
{
    const StyledGrey s("<BlendedVolumeStyle><PixelTexture3D image='1 1 1 1 255'/><OpacityMapVolumeStyle "
                       "enabled='false'/></BlendedVolumeStyle>",
                       "4.0");
    expectNear(s.of(), {0.125f, 0.125f, 0.125f, 0.125f});
}

TEST(VolumeStyles, composedStylesFollowEachOther)
{
    const std::string styles =
        "<EdgeEnhancementVolumeStyle/><BoundaryEnhancementVolumeStyle retainedOpacity='0.5' "
        "boundaryOpacity='0' opacityFactor='1'/>";
    expectNear(StyledGrey("<ComposedVolumeStyle>" + styles + "</ComposedVolumeStyle>", "4.0").of(kTurned),
               {0.125f, 0.125f, 0.125f, 0.125f});
    expectNear(StyledGrey("<ComposedVolumeStyle><ComposedVolumeStyle>" + styles +
                              "</ComposedVolumeStyle></ComposedVolumeStyle>",
                          "3.3")
                   .of(kTurned),
               {0.125f, 0.125f, 0.125f, 0.125f});
    for (const char* const ordered : {"true", "false"})
        expectNear(StyledGrey("<CompositeVolumeStyle ordered='" + std::string(ordered) + "'>" + styles +
                                  "</CompositeVolumeStyle>",
                              "3.0")
                       .of(kTurned),
                   {0.125f, 0.125f, 0.125f, 0.125f});
}

TEST(VolumeStyles, styleThatIsOffLeavesTheVolumeOut)
{
    EXPECT_TRUE(StyledGrey("<EdgeEnhancementVolumeStyle enabled='false'/>", "4.0").drawn.volumes.empty());
    EXPECT_TRUE(StyledGrey("<ProjectionVolumeStyle enabled='false'/>", "4.0").drawn.volumes.empty());
    EXPECT_TRUE(StyledGrey("<ComposedVolumeStyle enabled='false'/>", "4.0").drawn.volumes.empty());
    EXPECT_TRUE(
        StyledGrey("<ComposedVolumeStyle><EdgeEnhancementVolumeStyle enabled='false'/></ComposedVolumeStyle>",
                   "4.0")
            .drawn.volumes.empty());
}

TEST(VolumeStyles, surfaceNormalsOfTheVoxelsSizeAreTaken)
{
    const auto styleWith = [](const std::string& image) {
        return "<EdgeEnhancementVolumeStyle>\n<PixelTexture3D containerField='surfaceNormals' image='" +
               image + "'/></EdgeEnhancementVolumeStyle>";
    };
    const std::string right = "0xFF8080 0xFF8080 0xFF8080 0xFF8080 ";
    const StyledGrey s(styleWith("3 2 2 2 " + right + right), "4.0");
    const glm::vec4 made = s.of();
    EXPECT_LT(made.r, 0.01f);
    ViewedScene wrong("<VolumeData>" + kGrey + styleWith("3 2 2 1 " + right) + "</VolumeData>");
    EXPECT_EQ(wrong.drawn.volumes.size(), 1u);
    EXPECT_EQ(wrong.messages(),
              "s.x3d:2: warning: EdgeEnhancementVolumeStyle: expected normals of the voxels' size, "
              "2 x 2 x 2, with 3 components, found 2 x 2 x 1 with 3: computed from the voxels "
              "instead\n");
}

TEST(VolumeStyles, whatChangesNothingIsToldOf)
{
    const ViewedScene s(
        "<VolumeData>" + kGrey +
            "<CompositeVolumeStyle><EdgeEnhancementVolumeStyle contribution='0.5'/>"
            "<BoundaryEnhancementVolumeStyle contribution='0.1'/>"
            "<ISOSurfaceVolumeStyle lighting='true' shadows='true'/></CompositeVolumeStyle></VolumeData>",
        "3.0");
    EXPECT_EQ(s.messages(),
              "s.x3d:2: warning: EdgeEnhancementVolumeStyle.contribution is in no equation and changes "
              "nothing\n"
              "s.x3d:2: warning: BoundaryEnhancementVolumeStyle.contribution is in no equation and "
              "changes nothing\n");
}

// Half of the opaque voxel lies between the sample and the light.
TEST(VolumeStyles, shadedMayBeInItsOwnShadow)
{
    const std::string light = "<DirectionalLight direction='-0.5 0.5 0.5'/>";
    const std::string map = "<ComposedVolumeStyle><OpacityMapVolumeStyle/>";
    const std::string shaded = "<ShadedVolumeStyle lighting='true' ";
    const std::string end = "/></ComposedVolumeStyle>";
    const glm::vec4 lit = StyledGrey(map + shaded + end, "4.0", light).of({1.0f, {1, 0, 0}, 0.5f});
    EXPECT_GT(lit.r, 0.5f);
    const auto red = [&](const std::string& style, const char* version) {
        return StyledGrey(style, version, light).of({1.0f, {1, 0, 0}, 0.5f}).r;
    };
    EXPECT_LT(red(map + shaded + "shadows='true'" + end, "4.0"), 0.8f * lit.r);
    EXPECT_FLOAT_EQ(red(map + "<ShadedVolumeStyle shadows='true'" + end, "4.0"), 1.0f);
}

} // namespace
} // namespace vo
