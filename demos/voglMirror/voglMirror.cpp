// voglMirror: several passes over a scene of a volume and an opaque ball above a mirror (guide, page 161). It
// is drawn as the eye's image behind the mirror sees it, where the mirror is, and again as the eye itself
// does. Depth tells what the ball hides of the volume, and the slices that lie before it.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

using Point = std::array<double, 3>;

// The mirror lies level, a tenth of the volume's height below it, and reaches a quarter of its sides beyond
// it.
static const double kBelow = 0.1, kBeyond = 0.25;
// Of the smallest side.
static const double kRadius = 0.2;

static std::optional<Point> ball; // its middle, in voxels

static bool moveBall(vo::Button button, bool pressed, double x, double y);

const VoglProgram voglProgram = {
    .purpose = "Draws a volume and a ball above a mirror.",
    .example = "head.tif -view -20 200 -perspective 30 -sphere 150 220 40",
    .options = {{"sphere",
                 {"X", "Y", "Z"},
                 "the ball's middle, in voxels (default: before the volume, to the right)",
                 [](vo::Arguments& a) {
                     ball.emplace();
                     for (double& place : *ball)
                         place = a.number(-1e6, 1e6);
                 }}},
    // The mirror's corners are 1.5 times as far from the volume's middle as the volume's, at most.
    .margin = 1.5,
    .keys = "Middle drag   move the ball, in a plane that faces the viewer\n",
    .pointer = moveBall,
};

static VoglVolume volume;
static voIndexedTetraSet* box;
static VoglPolygons* polygons;

static double mirrorHeight()
{
    return -kBelow * volume.size[2];
}

// In units of modelScale.
static double radius()
{
    double smallest = INFINITY;
    for (int i = 0; i < 3; i++)
        smallest = std::min(smallest, kRadius * volume.size[i] * double(modelScale[i]));
    return smallest;
}

// Where the ball's middle may be, so that all of it is above the mirror and in the picture.
static Point keptInside(Point middle)
{
    for (std::size_t i = 0; i < 3; i++) {
        const double room = radius() / double(modelScale[i]);
        const double low = i == 2 ? mirrorHeight() : -kBeyond * volume.size[i];
        middle[i] = std::clamp(middle[i], low + room, (1 + kBeyond) * volume.size[i] - room);
    }
    return middle;
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    // The view volume is deeper than usual, since it holds what the mirror shows.
    const int deep[3] = {2 * volume.size[0], 2 * volume.size[1], 2 * volume.size[2]};
    volume.maxSamplesNumber = voglCountPlanes(argv[0], deep);
    if (ball && keptInside(*ball) != *ball)
        voglFail(argv[0], "option -sphere: expected a place above the mirror (z " +
                              std::to_string(mirrorHeight()) +
                              ") and within a quarter of the volume's sides around it");
    if (!ball) ball = keptInside({1.0 * volume.size[0], 0, 0.2 * volume.size[2]});
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    box = voglBox(volume);
    polygons = new VoglPolygons(box, volume, voInterleavedArrayTypeScope::V3F);
    return box;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

// The pointer takes the ball along, as far from the viewer as it is.
static bool moveBall(vo::Button button, bool, double x, double y)
{
    if (button != vo::Button::Middle) return false;
    const VoglView& view = voglView();
    const vo::Matrix m = vo::modelViewMatrix(view.model, view.orientation, view.volume);
    Point eye;
    for (std::size_t row = 0; row < 3; row++)
        eye[row] = m[row] * (*ball)[0] + m[4 + row] * (*ball)[1] + m[8 + row] * (*ball)[2] + m[12 + row];
    const double grown = view.volume.distance > 0 ? -eye[2] / view.volume.distance : 1;
    eye[0] = (2 * x - 1) * view.volume.halfWidth * grown;
    eye[1] = (2 * y - 1) * view.volume.halfHeight * grown;
    Point moved;
    for (std::size_t i = 0; i < 3; i++) {
        double sum = 0, square = 0;
        for (std::size_t row = 0; row < 3; row++) {
            sum += m[4 * i + row] * (eye[row] - m[12 + row]);
            square += m[4 * i + row] * m[4 * i + row];
        }
        moved[i] = sum / square;
    }
    ball = keptInside(moved);
    return true;
}

// Appends a vertex of the format C4F_V3F.
static void addVertex(std::vector<float>& vertices, const std::array<float, 4>& color, const Point& place)
{
    vertices.insert(vertices.end(), color.begin(), color.end());
    for (const double value : place)
        vertices.push_back(float(value));
}

// A point of the ball, lit from above on the left.
static void addBallVertex(std::vector<float>& vertices, double latitude, double longitude)
{
    const Point light{-0.48, -0.6, 0.64};
    const Point normal{std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
                       std::sin(latitude)};
    const double cosine = normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2];
    const float bright = float(0.25 + 0.75 * std::max(cosine, 0.0));
    Point place;
    for (std::size_t i = 0; i < 3; i++)
        place[i] = (*ball)[i] + radius() * normal[i] / double(modelScale[i]);
    addVertex(vertices, {bright, 0.4f * bright, 0.15f * bright, 1}, place);
}

static void drawBall()
{
    const int rings = 64, sectors = 128;
    const auto latitude = [](int ring) { return std::numbers::pi * (double(ring) / rings - 0.5); };
    const auto longitude = [](int sector) { return 2 * std::numbers::pi * sector / sectors; };
    voIndexedFaceSet faces(4 * rings * sectors, getValuesPerVertex(voInterleavedArrayTypeScope::C4F_V3F), 0);
    for (int ring = 0; ring < rings; ring++)
        for (int sector = 0; sector < sectors; sector++) {
            std::vector<float> vertices;
            addBallVertex(vertices, latitude(ring), longitude(sector));
            addBallVertex(vertices, latitude(ring), longitude(sector + 1));
            addBallVertex(vertices, latitude(ring + 1), longitude(sector + 1));
            addBallVertex(vertices, latitude(ring + 1), longitude(sector));
            faces.appendPoly(vertices.data(), 4);
        }
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::C4F_V3F);
}

// Tiles, light and dark; alpha is what they hide of what they mirror.
static void drawMirror(float alpha)
{
    const int tiles = 8;
    voIndexedFaceSet faces(4 * tiles * tiles, getValuesPerVertex(voInterleavedArrayTypeScope::C4F_V3F), 0);
    const auto place = [](int axis, int tile) {
        return volume.size[axis] * ((1 + 2 * kBeyond) * tile / tiles - kBeyond);
    };
    for (int i = 0; i < tiles; i++)
        for (int j = 0; j < tiles; j++) {
            const bool light = (i + j) % 2;
            const std::array<float, 4> color{light ? 0.3f : 0.1f, light ? 0.35f : 0.12f, light ? 0.4f : 0.15f,
                                             alpha};
            std::vector<float> vertices;
            addVertex(vertices, color, {place(0, i), place(1, j), mirrorHeight()});
            addVertex(vertices, color, {place(0, i + 1), place(1, j), mirrorHeight()});
            addVertex(vertices, color, {place(0, i + 1), place(1, j + 1), mirrorHeight()});
            addVertex(vertices, color, {place(0, i), place(1, j + 1), mirrorHeight()});
            faces.appendPoly(vertices.data(), 4);
        }
    voGeometryActions::draw(&faces, voInterleavedArrayTypeScope::C4F_V3F);
}

// Surfaces first, then the volume, which does not change depth (guide, page 115).
static void drawScene()
{
    gl->Disable(GL_BLEND);
    drawBall();
    voglDrawFrame(box, volume.bricks, *polygons);
}

// The scene behind the mirror: heights above it become depths below it.
static void drawMirroredScene()
{
    gl->Enable(GL_STENCIL_TEST);
    gl->StencilFunc(GL_ALWAYS, 1, 1);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    drawMirror(1);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl->Clear(GL_DEPTH_BUFFER_BIT);
    gl->StencilFunc(GL_EQUAL, 1, 1);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    GLdouble model[16], projection[16], mirrored[16];
    vo::getMatrices(model, projection);
    std::copy_n(model, 16, mirrored);
    for (int row = 0; row < 4; row++) {
        mirrored[8 + row] = -model[8 + row];
        mirrored[12 + row] += 2 * mirrorHeight() * model[8 + row];
    }
    vo::loadMatrices(mirrored, projection);
    drawScene();
    vo::loadMatrices(model, projection);
    gl->Disable(GL_STENCIL_TEST);
    gl->Clear(GL_DEPTH_BUFFER_BIT);
}

static bool isSeenFromAbove()
{
    GLdouble model[16], projection[16];
    double eye[3], direction[4];
    vo::getMatrices(model, projection);
    voGeometryActions::findCameraPosition(eye, direction, model, projection);
    return direction[3] == 0 ? direction[2] < 0 : eye[2] > mirrorHeight();
}

void my_DrawVolume(voIndexedTetraSet*, voBrickSetCollection*)
{
    vo::ViewVolume deeper = voglView().volume;
    deeper.farDistance += 2 * vo::boundingRadius(voglView().model);
    vo::loadProjection(deeper);
    gl->Clear(GL_STENCIL_BUFFER_BIT);
    const bool above = isSeenFromAbove();
    if (above) drawMirroredScene();
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    drawMirror(above ? 0.5f : 1); // from below, its back
    drawScene();
}

void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*)
{
    delete polygons;
    delete box;
    deleteLookupTable();
    voglFreeVolume(volume);
}
