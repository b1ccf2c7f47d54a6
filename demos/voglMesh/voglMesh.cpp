// voglMesh: a field on an unstructured grid, looked up after it was interpolated.
#include "voglMain.h"

#include "color_bar.h"
#include "mesh_scene.h"
#include "ramp_brick.h"
#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include "volume_view/lookup_ramp.h"
#include "volume_view/value_range.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

static FieldChoice choice;
static bool vertexColors = false, showBar = false;

const VoglProgram voglProgram = {
    .purpose = "Draws a field on an unstructured grid of tetrahedra, hexahedra, prisms and pyramids: a file "
               "of VTK,\n"
               "VTU, Gmsh or TetGen. The longest side counts as 128 units; opacities are those of one unit.",
    .arguments = "MESH",
    .example = "flow.vtu -field pressure -lutFile spectrum.lut -bar -output flow.png",
    .expected = "the file of one mesh",
    .options =
        {{"field",
          {"NAME"},
          "the field that is shown (default: the first of one component)",
          [](vo::Arguments& a) { choice.name = a.text(); }},
         {"component",
          {"N"},
          "one component of it, counted from 0 (default: the length of a vector)",
          [](vo::Arguments& a) { choice.component = a.integer(0, 9999, "a component"); }},
         {"colors",
          {},
          "look up colours at the vertices, and interpolate them",
          [](vo::Arguments&) { vertexColors = true; }},
         {"bar", {}, "a bar of the table's colours, with numbers", [](vo::Arguments&) { showBar = true; }}},
};

static MeshScene scene;
static std::unique_ptr<RampBrick> ramp;
static VoglVolume volume; // the ramp; no bricks where the field has colours
static VoglVolume frame;  // what polygons are cut in: the ramp, or with colours a box round all
static VoglPolygons* polygons;
static std::vector<float> records, table;
static std::vector<float> outlineRecords;
static std::vector<int> outlines;

namespace {

bool drawsColors()
{
    return vertexColors || !scene.colors.empty();
}

voInterleavedArrayType format()
{
    return drawsColors() ? voInterleavedArrayTypeScope::C4F_V3F : voInterleavedArrayTypeScope::T3F_V3F;
}

void refuse(const char* program, const std::vector<std::pair<bool, const char*>>& given, const char* why)
{
    for (const auto& [isGiven, name] : given)
        if (isGiven) voglFail(program, std::string("option -") + name + ": expected none, since " + why);
}

void refuseOptions(const char* program)
{
    refuse(program,
           {{options.textureDimensions == 2, "2D"},
            {options.bricks.has_value(), "bricks"},
            {options.overlap != 1, "overlap"}},
           "a mesh has no voxels");
    if (!scene.colors.empty())
        refuse(program,
               {{options.dataRange.has_value(), "dataRange"},
                {options.lut.has_value(), "lut"},
                {!options.lutFile.empty(), "lutFile"},
                {showBar, "bar"}},
               "the field has colours");
    if (drawsColors())
        refuse(program, {{options.engine.has_value(), "engine"}}, "colours are drawn in a loop of its own");
}

void readScene(const char* program, const std::string& file)
{
    const auto mesh = vo::readMesh(file);
    if (!mesh) voglFail(program, mesh.failure().text);
    auto made = makeScene(*mesh, choice);
    if (!made) voglFail(program, file + ": " + made.failure().text);
    scene = std::move(*made);
    std::vector<std::string> notes = mesh->notes;
    if (const std::string text = mesh->counts.text(); !text.empty()) notes.push_back(text);
    if (scene.cellsWithoutValue > 0)
        notes.push_back(std::to_string(scene.cellsWithoutValue) +
                        " cells without a number of the field left out");
    for (const std::string& note : notes)
        fprintf(stderr, "%s: %s: %s\n", program, file.c_str(), note.c_str());
}

// Polygonize wants bricks to cut its polygons to: one, without voxels, round the whole mesh.
VoglVolume boxAround()
{
    VoglVolume box;
    for (int i = 0; i < 3; i++)
        box.size[i] = std::max(int(std::ceil(scene.size[std::size_t(i)])), 1);
    box.bricks = new voBrickSetCollection(
        box.size[0], box.size[1], box.size[2], box.size[0], box.size[1], box.size[2],
        voPartialBrickTypeScope::AUGMENT, 0, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    box.maxBrickCount = 1;
    return box;
}

} // namespace

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    readScene(argv[0], argv[1]);
    refuseOptions(argv[0]);
    const voRenderingMode renderingMode = readLookupTable(argv[0]);
    if (scene.colors.empty()) {
        if (scene.low == scene.high)
            fprintf(stderr, "%s: %s: all values are %g; nothing to tell apart\n", argv[0], argv[1],
                    scene.low);
        const vo::ValueRange range = options.dataRange
                                         ? vo::ValueRange{options.dataRange->low, options.dataRange->high}
                                         : vo::ValueRange{scene.low, scene.high};
        ramp = std::make_unique<RampBrick>(range.low, range.high, scene.low, scene.high);
        volume = ramp->makeVolume(renderingMode);
        voglLookup().setRampOpacity(vo::sliceOpacity(1, kLongestSide));
    }
    const VoglVolume box = boxAround();
    frame = drawsColors() ? box : volume;
    frame.maxSamplesNumber = voglCountPlanes(argv[0], box.size);
    if (!drawsColors()) delete box.bricks;
    return NULL;
}

namespace {

// A record: the place of the value in the ramp, or a colour, which may come later, then the position.
void fillRecords()
{
    const auto values = std::size_t(getValuesPerVertex(format()));
    records.assign(scene.positions.size() * values, 0);
    for (std::size_t vertex = 0; vertex < scene.positions.size(); vertex++) {
        float* record = records.data() + vertex * values;
        std::copy_n(scene.positions[vertex].begin(), 3, record + values - 3);
        if (!scene.colors.empty()) {
            std::copy_n(scene.colors[vertex].begin(), 4, record);
            if (!options.color.value_or(true))
                std::fill_n(record, 3, 0.30f * record[0] + 0.59f * record[1] + 0.11f * record[2]);
        } else if (!vertexColors) {
            record[0] = ramp->placeOf(scene.values[vertex]);
            record[1] = record[2] = RampBrick::kAcross;
        }
    }
}

// Gives vertices the colours of the table at their values.
void colorVertices()
{
    const std::vector<float> now = voglLookup().rgbaEntries();
    if (now == table) return;
    table = now;
    const int last = int(table.size() / 4) - 1;
    for (std::size_t vertex = 0; vertex < scene.values.size(); vertex++) {
        const double across = double(volume.hiValue) - double(volume.loValue);
        const double place =
            std::clamp((scene.values[vertex] - double(volume.loValue)) / across, 0.0, 1.0) * last;
        const int entry = std::min(int(place), last - 1);
        for (int i = 0; i < 4; i++) {
            const double below = double(table[std::size_t(4 * entry + i)]);
            const double above = double(table[std::size_t(4 * entry + 4 + i)]);
            records[7 * vertex + std::size_t(i)] = float(below + (place - entry) * (above - below));
        }
    }
}

// Lines round the faces of cells where the mesh ends.
void drawOutlines()
{
    if (!options.wireframe) return;
    if (outlines.empty()) {
        outlines = outerFaces(scene.faces);
        for (const auto& position : scene.positions)
            outlineRecords.insert(outlineRecords.end(), position.begin(), position.end());
    }
    voVertexData vertices(int(scene.positions.size()), 3, outlineRecords.data());
    vertices.setCount(int(scene.positions.size()));
    voIndexedFaceSet faces(&vertices, int(outlines.size()));
    std::copy(outlines.begin(), outlines.end(), faces.getIndices()->getDataPtr());
    faces.getIndices()->setCount(int(outlines.size()));
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(&faces, GL_LINE, voInterleavedArrayTypeScope::V3F);
}

// From now on the opacities of slices are those of their distance.
void beginSampling(voIndexedTetraSet* aTetraSet)
{
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    float samplingPeriod[3];
    voglSamplingPeriod(samplingPeriod);
    voState::setSampling(aTetraSet, frame.bricks->getCurrentBrickSet(), modelMatrix, projMatrix,
                         voglSamplingMode(frame.bricks),
                         options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME : voSamplingSpaceScope::OBJECT,
                         samplingPeriod, frame.maxSamplesNumber);
}

void drawColors()
{
    if (volume.bricks) colorVertices();
    polygons->polygonize();
    voglBeginBlending();
    drawTimer.start();
    for (int binNo = 0; binNo < polygons->getSamplesNumber(); binNo++)
        voGeometryActions::draw(polygons->get(0, binNo), format());
    drawTimer.stop();
    voglEndBlending();
}

void drawValues()
{
    polygons->polygonize();
    voglBeginSlices(volume.bricks, format());
    polygons->draw();
    voglEndSlices(volume.bricks);
}

} // namespace

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    fillRecords();
    voIndexedTetraSet* aTetraSet =
        new voIndexedTetraSet(records.data(), int(scene.positions.size()), getValuesPerVertex(format()),
                              scene.tetras.data(), int(scene.tetras.size()));
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    voState::setUnitLength(1);
    if (volume.bricks) voglInitTextures(volume);
    if (drawsColors()) VoglLookup::disable();
    polygons = new VoglPolygons(aTetraSet, frame, format());
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    drawOutlines();
    if (options.engine) {
        voglBeginBlending();
        polygons->drawAtOnce();
        voglEndBlending();
    } else {
        beginSampling(aTetraSet);
        drawsColors() ? drawColors() : drawValues();
        voState::resetSampling();
    }
    if (showBar) drawColorBar(voglLookup().rgbaEntries(), double(volume.loValue), double(volume.hiValue));
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete polygons;
    delete aTetraSet;
    deleteLookupTable();
    if (drawsColors()) delete frame.bricks;
    if (volume.bricks) voglFreeVolume(volume);
}
