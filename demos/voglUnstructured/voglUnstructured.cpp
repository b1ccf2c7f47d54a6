// voglUnstructured: tetrahedra with a colour at each vertex, and no texture.
#include "voglMain.h"

#include "mesh.h"
#include "voglFrame.h"
#include "voglVolume.h"

#include <algorithm>
#include <cmath>

const VoglProgram voglProgram = {
    .purpose =
        "Draws tetrahedra with a colour and an opacity at each vertex: those of a text file, or, without\n"
        "one, the pressure in a flow round a cylinder. The longest side counts as 128 units.",
    .arguments = "[MESH]",
    .example = "-view -30 150 -output flow.png",
    .leastArguments = 0,
    .mostArguments = 1,
    .expected = "at most one file of tetrahedra",
    .ownLoop = true,
};

static Mesh mesh;
static VoglPolygons* polygons;
static const voInterleavedArrayType format = voInterleavedArrayTypeScope::C4F_V3F;

// What is left of voglMain's appearance without voxels: nothing that these options could change.
static void refuseOptions(const char* program)
{
    const std::pair<bool, const char*> given[] = {
        {options.textureDimensions == 2, "2D"}, {options.dataRange.has_value(), "dataRange"},
        {options.lut.has_value(), "lut"},       {!options.lutFile.empty(), "lutFile"},
        {options.bricks.has_value(), "bricks"}, {options.overlap != 1, "overlap"}};
    for (const auto& [isGiven, name] : given)
        if (isGiven)
            voglFail(program, std::string("option -") + name +
                                  ": expected none, since there are no voxels; the vertices have colours");
}

// Moves and enlarges the mesh: its longest side becomes 128, its corner the origin. The sizes of the box that
// it fills.
static std::array<int, 3> fitMesh()
{
    const float longestSide = 128;
    std::array<float, 3> lower, upper;
    lower = upper = mesh.vertices[std::size_t(mesh.tetras[0])].position;
    for (const int vertex : mesh.tetras)
        for (std::size_t i = 0; i < 3; i++) {
            lower[i] = std::min(lower[i], mesh.vertices[std::size_t(vertex)].position[i]);
            upper[i] = std::max(upper[i], mesh.vertices[std::size_t(vertex)].position[i]);
        }
    const float longest = std::max({upper[0] - lower[0], upper[1] - lower[1], upper[2] - lower[2]});
    const float enlarged = longest > 0 ? longestSide / longest : 1;
    std::array<int, 3> size;
    for (std::size_t i = 0; i < 3; i++)
        size[i] = std::max(int(std::ceil(enlarged * (upper[i] - lower[i]))), 1);
    for (Mesh::Vertex& vertex : mesh.vertices)
        for (std::size_t i = 0; i < 3; i++)
            vertex.position[i] =
                enlarged * (vertex.position[i] - (lower[i] + upper[i]) / 2) + float(size[i]) / 2;
    return size;
}

// No voxels, but polygonize wants bricks to cut its polygons to: one, without voxels, round the whole mesh.
voBrickSetCollection* my_InitAppearance(int argc, char** argv)
{
    refuseOptions(argv[0]);
    if (argc > 1) {
        auto read = readMesh(argv[1]);
        if (!read) voglFail(argv[0], read.failure().text);
        mesh = std::move(*read);
    } else {
        mesh = flowMesh();
    }
    const std::array<int, 3> size = fitMesh();
    return new voBrickSetCollection(
        size[0], size[1], size[2], size[0], size[1], size[2], voPartialBrickTypeScope::AUGMENT, 0,
        voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
        voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    const int vertexCount = int(mesh.vertices.size()), indexCount = int(mesh.tetras.size());
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(vertexCount, getValuesPerVertex(format), indexCount);
    for (int vertex = 0; vertex < vertexCount; vertex++) {
        const Mesh::Vertex& from = mesh.vertices[std::size_t(vertex)];
        float* to = (*aTetraSet->getVertexData())[vertex];
        std::copy(from.color.begin(), from.color.end(), to);
        if (!options.color.value_or(true))
            std::fill(to, to + 3, 0.30f * from.color[0] + 0.59f * from.color[1] + 0.11f * from.color[2]);
        std::copy(from.position.begin(), from.position.end(), to + 4);
    }
    std::copy(mesh.tetras.begin(), mesh.tetras.end(), aTetraSet->getIndices()->getDataPtr());
    aTetraSet->getVertexData()->setCount(vertexCount);
    aTetraSet->getIndices()->setCount(indexCount);

    VoglVolume box;
    box.bricks = aVolume;
    box.maxBrickCount = 1;
    aVolume->getCurrentBrickSet()->getVolumeSizes(box.size[0], box.size[1], box.size[2]);
    box.maxSamplesNumber = voglCountPlanes("voglUnstructured", box.size);
    polygons = new VoglPolygons(aTetraSet, box, format);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*) {}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voglDrawOutlines(aTetraSet, aVolume, format);
    polygons->polygonize();
    voglBeginBlending();
    drawTimer.start();
    for (int binNo = 0; binNo < polygons->getSamplesNumber(); binNo++)
        voGeometryActions::draw(polygons->get(0, binNo), format);
    drawTimer.stop();
    voglEndBlending();
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    delete polygons;
    delete aTetraSet;
    delete aVolume;
}
