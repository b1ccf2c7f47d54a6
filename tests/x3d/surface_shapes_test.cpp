// Triangles, normals, colours and materials of Shapes.

#include <gtest/gtest.h>

#include "view_scene.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace vo {
namespace {

std::string shapeOf(const std::string& geometry, const std::string& appearance = "")
{
    return "<Shape>" + appearance + geometry + "</Shape>";
}

StyledSurface surfaceOf(const std::string& geometry, const std::string& appearance = "")
{
    const ViewedScene scene(shapeOf(geometry, appearance));
    EXPECT_EQ(scene.messages(), "");
    return scene.drawn.surfaces.at(0);
}

glm::dvec3 cornerOf(const StyledSurface& surface, std::size_t i)
{
    return glm::dvec3(surface.positions.at(static_cast<std::size_t>(surface.triangles.at(i))));
}

glm::dvec3 areaOf(const StyledSurface& surface, std::size_t triangle)
{
    const glm::dvec3 a = cornerOf(surface, 3 * triangle);
    return glm::cross(cornerOf(surface, 3 * triangle + 1) - a, cornerOf(surface, 3 * triangle + 2) - a) / 2.0;
}

/// What triangles that turn counterclockwise from outside hold, by the divergence theorem.
double heldVolume(const StyledSurface& surface)
{
    double sum = 0.0;
    for (std::size_t t = 0; 3 * t < surface.triangles.size(); ++t)
        sum += glm::dot(cornerOf(surface, 3 * t), areaOf(surface, t)) / 3.0;
    return sum;
}

double wholeArea(const StyledSurface& surface)
{
    double sum = 0.0;
    for (std::size_t t = 0; 3 * t < surface.triangles.size(); ++t)
        sum += glm::length(areaOf(surface, t));
    return sum;
}

/// Normals are unit and on the side from which their triangles turn counterclockwise.
void expectSoundNormals(const StyledSurface& surface)
{
    ASSERT_EQ(surface.normals.size(), surface.positions.size());
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        const glm::dvec3 normal(surface.normals[static_cast<std::size_t>(surface.triangles[i])]);
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-6);
        EXPECT_GT(glm::dot(normal, areaOf(surface, i / 3)), 0.0);
    }
}

/// Area of a regular polygon of 48 corners on the unit circle.
const double kDisk = 24.0 * std::sin(2.0 * std::numbers::pi / 48.0);

TEST(SurfaceShapes, boxHoldsItsSize)
{
    const StyledSurface box = surfaceOf("<Box size='1 2 3'/>");
    EXPECT_NEAR(heldVolume(box), 6.0, 1e-6);
    EXPECT_NEAR(wholeArea(box), 22.0, 1e-6);
    expectSoundNormals(box);
}

TEST(SurfaceShapes, sphereIsNearlyRound)
{
    const StyledSurface sphere = surfaceOf("<Sphere radius='2'/>");
    for (std::size_t i = 0; i < sphere.positions.size(); ++i) {
        EXPECT_NEAR(glm::length(sphere.positions[i]), 2.0f, 1e-5);
        EXPECT_NEAR(glm::distance(sphere.positions[i], 2.0f * sphere.normals[i]), 0.0f, 1e-5);
    }
    EXPECT_NEAR(heldVolume(sphere), 4.0 / 3.0 * std::numbers::pi * 8.0, 0.4);
    expectSoundNormals(sphere);
}

TEST(SurfaceShapes, cylinderAndConeHoldPrisms)
{
    const StyledSurface cylinder = surfaceOf("<Cylinder radius='2' height='3'/>");
    EXPECT_NEAR(heldVolume(cylinder), 4.0 * kDisk * 3.0, 1e-4);
    expectSoundNormals(cylinder);
    const StyledSurface cone = surfaceOf("<Cone bottomRadius='2' height='3'/>");
    EXPECT_NEAR(heldVolume(cone), 4.0 * kDisk, 1e-4);
    expectSoundNormals(cone);
    double top = -10.0;
    for (const glm::vec3& position : cone.positions)
        if (position.x == 0.0f && position.z == 0.0f) top = std::max(top, static_cast<double>(position.y));
    EXPECT_DOUBLE_EQ(top, 1.5);
}

TEST(SurfaceShapes, partsOfCylinderAndConeMayBeMissing)
{
    EXPECT_NEAR(wholeArea(surfaceOf("<Cylinder side='false' bottom='false'/>")), kDisk, 1e-5);
    EXPECT_NEAR(wholeArea(surfaceOf("<Cylinder side='false'/>")), 2 * kDisk, 1e-5);
    EXPECT_NEAR(wholeArea(surfaceOf("<Cone side='false'/>")), kDisk, 1e-5);
    const StyledSurface foot = surfaceOf("<Cylinder side='false' top='false'/>");
    EXPECT_NEAR(wholeArea(foot), kDisk, 1e-5);
    for (const glm::vec3& normal : foot.normals)
        EXPECT_EQ(normal, glm::vec3(0, -1, 0));
    // 48 triangles from the chords to the top, 2 above the middle of the foot.
    const double angle = std::numbers::pi / 48.0;
    EXPECT_NEAR(wholeArea(surfaceOf("<Cone bottom='false'/>")),
                48.0 * std::sin(angle) * std::hypot(2.0, std::cos(angle)), 1e-5);
}

TEST(SurfaceShapes, concavePolygonIsCutIntoItsArea)
{
    const std::string arrow = "<Coordinate point='0 0 0 4 0 0 4 4 0 2 1 0 0 4 0'/></IndexedFaceSet>";
    const StyledSurface cut = surfaceOf("<IndexedFaceSet convex='false' coordIndex='0 1 2 3 4'>" + arrow);
    ASSERT_EQ(cut.triangles.size(), 9u);
    EXPECT_NEAR(wholeArea(cut), 10.0, 1e-6);
    expectSoundNormals(cut);
    EXPECT_NEAR(cut.normals[0].z, 1.0f, 1e-6);
    const StyledSurface turned =
        surfaceOf("<IndexedFaceSet convex='false' coordIndex='4 3 2 1 0 -1'>" + arrow);
    EXPECT_NEAR(wholeArea(turned), 10.0, 1e-6);
    EXPECT_NEAR(turned.normals[0].z, -1.0f, 1e-6);
}

TEST(SurfaceShapes, concavePolygonsLieOnAnyPlane)
{
    for (const char* const points : {"0 0 0 0 4 0 0 4 4 0 1 2 0 0 4", "0 0 0 0 0 4 4 0 4 2 0 1 4 0 0"}) {
        const StyledSurface cut = surfaceOf(
            std::string("<IndexedFaceSet convex='false' coordIndex='0 1 2 3 4'><Coordinate point='") +
            points + "'/></IndexedFaceSet>");
        glm::dvec3 sum(0.0);
        double area = 0.0;
        for (std::size_t t = 0; t < 3; ++t) {
            sum += areaOf(cut, t);
            area += glm::length(areaOf(cut, t));
        }
        EXPECT_NEAR(glm::length(sum), area, 1e-6) << points;
    }
}

TEST(SurfaceShapes, polygonThatCrossesItselfEnds)
{
    const StyledSurface cut = surfaceOf("<IndexedFaceSet convex='false' coordIndex='0 1 2 3 0 0'>"
                                        "<Coordinate point='0 0 0 1 1 0 1 0 0 0 1 0'/></IndexedFaceSet>");
    EXPECT_EQ(cut.triangles.size(), 12u);
}

TEST(SurfaceShapes, clockwiseFacesAreTurnedRound)
{
    const StyledSurface face = surfaceOf("<IndexedFaceSet ccw='false' solid='false' coordIndex='0 1 2'>"
                                         "<Coordinate point='0 0 0 1 0 0 0 1 0'/></IndexedFaceSet>");
    EXPECT_LT(areaOf(face, 0).z, 0.0);
    EXPECT_FALSE(face.solid);
    expectSoundNormals(face);
}

/// Two faces that meet at a right angle along the y axis, the first looking to +z, the second to +x.
const std::string kFold = "<Coordinate point='-1 0 0 0 0 0 0 1 0 -1 1 0 0 0 -1 0 1 -1'/></IndexedFaceSet>";

TEST(SurfaceShapes, creaseAngleSmoothsWhatIsFlatterThanIt)
{
    const std::string start = "<IndexedFaceSet coordIndex='0 1 2 3 -1 1 4 5 2 -1' creaseAngle='";
    const StyledSurface sharp = surfaceOf(start + "1.5'>" + kFold);
    const StyledSurface smooth = surfaceOf(start + "1.6'>" + kFold);
    const float half = std::sqrt(0.5f);
    EXPECT_NEAR(glm::distance(sharp.normals[1], glm::vec3(0, 0, 1)), 0.0f, 1e-6);
    EXPECT_NEAR(glm::distance(sharp.normals[4], glm::vec3(1, 0, 0)), 0.0f, 1e-6);
    EXPECT_NEAR(glm::distance(smooth.normals[1], glm::vec3(half, 0, half)), 0.0f, 1e-6);
    EXPECT_NEAR(glm::distance(smooth.normals[4], glm::vec3(half, 0, half)), 0.0f, 1e-6);
    EXPECT_NEAR(glm::distance(smooth.normals[0], glm::vec3(0, 0, 1)), 0.0f, 1e-6);
}

TEST(SurfaceShapes, colorsGoByVertexFaceAndIndex)
{
    const std::string rest = "<Color color='1 0 0 0 1 0 0 0 1'/><Coordinate point='0 0 0 1 0 0 0 1 0 1 1 0'/>"
                             "</IndexedFaceSet>";
    const glm::vec4 red(1, 0, 0, 1), green(0, 1, 0, 1), blue(0, 0, 1, 1);
    const auto colorsOf = [&](const std::string& attributes) {
        return surfaceOf("<IndexedFaceSet coordIndex='0 1 2 -1 2 1 3' " + attributes + ">" + rest).colors;
    };
    EXPECT_EQ(colorsOf("colorPerVertex='false'"),
              (std::vector<glm::vec4>{red, red, red, green, green, green}));
    EXPECT_EQ(colorsOf("colorPerVertex='false' colorIndex='2 0'"),
              (std::vector<glm::vec4>{blue, blue, blue, red, red, red}));
    EXPECT_EQ(colorsOf("colorIndex='0 1 2 -1 2 1 0'"),
              (std::vector<glm::vec4>{red, green, blue, blue, green, red}));
}

TEST(SurfaceShapes, triangleSetsHaveNormalsAndColorsOfTheirPoints)
{
    const StyledSurface given =
        surfaceOf("<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
                  "<Normal vector='0 0 2 1 0 0 0 3 4'/><ColorRGBA color='1 0 0 0.5 0 1 0 1 0 0 1 0.25'/>"
                  "</IndexedTriangleSet>");
    EXPECT_NEAR(glm::distance(given.normals[0], glm::vec3(0, 0, 1)), 0.0f, 1e-6);
    EXPECT_NEAR(glm::distance(given.normals[2], glm::vec3(0, 0.6f, 0.8f)), 0.0f, 1e-6);
    EXPECT_EQ(given.colors.at(2), glm::vec4(0, 0, 1, 0.25f));
    const StyledSurface smooth =
        surfaceOf("<IndexedTriangleSet index='0 1 2 1 3 2'>"
                  "<Coordinate point='-1 0 0 0 0 0 0 1 0 0 0 -1'/></IndexedTriangleSet>");
    const float half = std::sqrt(0.5f);
    EXPECT_NEAR(glm::distance(smooth.normals[1], glm::vec3(half, 0, half)), 0.0f, 1e-6);
}

TEST(SurfaceShapes, materialIsTaken)
{
    const StyledSurface box = surfaceOf(
        "<Box/>", "<Appearance><Material ambientIntensity='0.1' diffuseColor='0.1 0.2 0.3' shininess='0.4' "
                  "specularColor='0.5 0.6 0.7' emissiveColor='0.8 0.9 1' transparency='0.25'/></Appearance>");
    EXPECT_TRUE(box.lit);
    EXPECT_EQ(box.diffuse, glm::vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(box.specular, glm::vec3(0.5f, 0.6f, 0.7f));
    EXPECT_EQ(box.emissive, glm::vec3(0.8f, 0.9f, 1.0f));
    EXPECT_EQ(glm::vec3(box.ambientIntensity, box.shininess, box.transparency), glm::vec3(0.1f, 0.4f, 0.25f));
}

TEST(SurfaceShapes, withoutMaterialIsUnlitWhite)
{
    for (const char* const appearance : {"", "<Appearance/>"}) {
        const StyledSurface box = surfaceOf("<Box/>", appearance);
        EXPECT_FALSE(box.lit);
        EXPECT_EQ(box.emissive, glm::vec3(1.0f));
    }
}

TEST(SurfaceShapes, withoutMaterialColorsAreTheirOwnLight)
{
    const StyledSurface face =
        surfaceOf("<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
                  "<Color color='1 0 0 0 1 0 0 0 1'/></IndexedTriangleSet>");
    ASSERT_EQ(face.lights.size(), 1u);
    EXPECT_EQ(face.lights[0].intensity, 0.0f);
    EXPECT_EQ(face.lights[0].ambientIntensity * face.ambientIntensity, 1.0f);
    EXPECT_EQ(face.lights[0].color, glm::vec3(1.0f));
}

TEST(SurfaceShapes, transparencyIsOfColorsWithoutAlpha)
{
    const StyledSurface face =
        surfaceOf("<IndexedTriangleSet index='0 1 2'><Coordinate point='0 0 0 1 0 0 0 1 0'/>"
                  "<Color color='1 0 0 0 1 0 0 0 1'/></IndexedTriangleSet>",
                  "<Appearance><Material transparency='0.75'/></Appearance>");
    EXPECT_EQ(face.colors.at(0), glm::vec4(1, 0, 0, 0.25f));
}

TEST(SurfaceShapes, wrongIndicesAreLeftOutAndTold)
{
    const ViewedScene scene(
        shapeOf("\n<IndexedFaceSet coordIndex='0 1 2 -1 0 1 7 -1 0 1' colorIndex='0 1 9 -1'>"
                "<Coordinate point='0 0 0 1 0 0 0 1 0'/><Color color='1 0 0 0 1 0'/>"
                "</IndexedFaceSet>"));
    EXPECT_EQ(scene.drawn.surfaces.at(0).triangles.size(), 3u);
    EXPECT_EQ(scene.drawn.surfaces[0].colors.at(2), glm::vec4(1.0f));
    EXPECT_EQ(
        scene.messages(),
        "s.x3d:3: warning: 2 faces of IndexedFaceSet name points that are not among the 3 or fewer than 3: "
        "left out\n"
        "s.x3d:3: warning: IndexedFaceSet: there are 2 colours, fewer than its indices name\n");
}

TEST(SurfaceShapes, texturesAreToldOf)
{
    ViewedScene scene(shapeOf("<Box/>", "<Appearance><PixelTexture image='1 1 1 0'/></Appearance>"));
    scene.draw();
    EXPECT_EQ(scene.messages(), "s.x3d:2: warning: Appearance.texture is not drawn\n");
}

TEST(SurfaceShapes, geometryThatChangesIsMadeAnew)
{
    ViewedScene scene(
        "<Shape><IndexedTriangleSet index='0 1 2'><Coordinate DEF='C' point='0 0 0 1 0 0 0 1 0'/>"
        "</IndexedTriangleSet></Shape>");
    Node& coordinate = *scene.scene.names.at("C");
    coordinate.put(coordinate.field("point")->slot, std::vector<float>{0, 0, 0, 2, 0, 0, 0, 1, 0});
    EXPECT_EQ(scene.draw().surfaces.at(0).positions.at(1), glm::vec3(2, 0, 0));
}

} // namespace
} // namespace vo
