// voglSpaceLeap: as voglBasic, but only those parts of the volume are cut into slices that hold anything.
#include "voglMain.h"

#include "sub_cubes.h"
#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <charconv>
#include <cstring>

// Sub-cubes are not joined.
static bool areSeparate = false;

const VoglProgram voglProgram = {
    .purpose =
        "Draws a volume as voglBasic does, but leaves out the sub-cubes of -tessellationSize voxels on\n"
        "each side in which all values lie below LOW, or all above HIGH.",
    .arguments = "VOLUME LOW HIGH",
    .example = "head.tif -tess 8 40 255",
    .leastArguments = 3,
    .mostArguments = 3,
    .expected = "the file of one volume and the range of the values to draw, LOW and HIGH",
    .options =
        {{"separate",
          {},
          "do not join sub-cubes into boxes: more tetrahedra, but neighbours share all vertices, and no\n"
          "pixel of a seam is drawn twice or left out",
          [](vo::Arguments&) { areSeparate = true; }}},
    .keys = "Escape        also prints what was saved in the last frame\n",
};

static VoglVolume volume;
static SubCubes subCubes;
static VoglPolygons* polygons;
static voIndexedFaceSet* sides; // of the boxes, to outline them

static double readValue(const char* program, const char* word)
{
    double value = 0;
    const char* end = word + strlen(word);
    const auto [stopped, error] = std::from_chars(word, end, value);
    if (error != std::errc() || stopped != end)
        voglFail(program, std::string("expected a value of the file for LOW or HIGH, found '") + word + "'");
    return value;
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    const double low = readValue(argv[0], argv[2]), high = readValue(argv[0], argv[3]);
    if (!(low <= high))
        voglFail(argv[0], std::string("expected LOW up to HIGH, found ") + argv[2] + " " + argv[3]);
    const VoglSource source = voglOpenBlended(argv[0], argv[1]);
    const double mostCubes = 1 << 18;
    double cubes = 1;
    for (int size : source.size)
        cubes *= (size - 1) / options.tessellationSize + 1;
    if (cubes > mostCubes)
        voglFail(argv[0], "option -tessellationSize: expected at most " + std::to_string(int(mostCubes)) +
                              " sub-cubes, found " + std::to_string(long(cubes)));
    subCubes = findSubCubes(source, options.tessellationSize, low, high);
    volume = voglReadVolume(argv[0], source);
    return volume.bricks;
}

// Appends the eight corners of a box, and the tetrahedra that `indices` make of them.
static void appendBox(voIndexedTetraSet* aTetraSet, const float corners[2][3], const int* indices,
                      int indexCount)
{
    voVertexData* vertices = aTetraSet->getVertexData();
    voIndices* tetras = aTetraSet->getIndices();
    const int firstVertex = vertices->getCount(), firstIndex = tetras->getCount();
    for (int vertex = 0; vertex < 8; vertex++)
        for (int i = 0; i < 3; i++)
            (*vertices)[firstVertex + vertex][i] = corners[vertex >> i & 1][i];
    for (int index = 0; index < indexCount; index++)
        (*tetras)[firstIndex + index] = firstVertex + indices[index];
    vertices->setCount(firstVertex + 8);
    tetras->setCount(firstIndex + indexCount);
}

// The six sides of each box. They share the vertices of the tetrahedra, whose diagonals they leave out; the
// first eight vertices are the whole volume's.
static voIndexedFaceSet* makeSides(voIndexedTetraSet* aTetraSet, int boxCount)
{
    // Corner number 4 z + 2 y + x.
    static const int corners[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                      {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
    voIndexedFaceSet* faces = new voIndexedFaceSet(aTetraSet->getVertexData(), 6 * 5 * boxCount);
    int count = 0;
    for (int box = 1; box <= boxCount; box++)
        for (const auto& side : corners) {
            (*faces->getIndices())[count++] = 4;
            for (int corner : side)
                (*faces->getIndices())[count++] = 8 * box + corner;
        }
    faces->getIndices()->setCount(count);
    return faces;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    // Corner number 4 z + 2 y + x.
    static const int five[] = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 3, 6, 4, 0, 5, 6, 7, 3, 5, 6};
    // The same mirrored, for every other sub-cube: then the diagonals of neighbours match.
    static const int mirrored[] = {1, 2, 4, 7, 0, 1, 2, 4, 3, 1, 2, 7, 5, 1, 4, 7, 6, 2, 4, 7};
    static const int flat[] = {0, 1, 2, 3, 4, 5, 6, 7};
    const std::vector<SubCubeBox> boxes = areSeparate ? separate(subCubes) : coalesce(subCubes);
    const int boxCount = int(boxes.size());
    voIndexedTetraSet* aTetraSet = new voIndexedTetraSet(8 * (boxCount + 1), 3, 20 * boxCount + 8);

    // Sampling planes are spread over all tetrahedra. Two that are flat, the volume's lowest and highest
    // side, yield no slices, but leave the planes where those of the whole volume lie.
    const float whole[2][3] = {{0, 0, 0},
                               {float(volume.size[0]), float(volume.size[1]), float(volume.size[2])}};
    appendBox(aTetraSet, whole, flat, 8);
    for (const SubCubeBox& box : boxes) {
        float corners[2][3];
        for (std::size_t i = 0; i < 3; i++) {
            corners[0][i] = float(box.lower[i] * subCubes.size);
            corners[1][i] = std::min(float(box.upper[i]) * float(subCubes.size), whole[1][i]);
        }
        const bool odd = (box.lower[0] + box.lower[1] + box.lower[2]) % 2;
        appendBox(aTetraSet, corners, odd ? mirrored : five, 20);
    }
    sides = makeSides(aTetraSet, boxCount);
    polygons = new VoglPolygons(aTetraSet, volume, voInterleavedArrayTypeScope::V3F);
    printf("kept %d of %d sub-cubes, in %d boxes\n",
           int(std::count(subCubes.needed.begin(), subCubes.needed.end(), 1)), int(subCubes.needed.size()),
           boxCount);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voglDrawFrame(aTetraSet, aVolume, *polygons, sides);
}

// Pixels that all slices cover in the frame drawn last.
static double countFragments(VoglPolygons& slices)
{
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    GLint viewport[4] = {0, 0, voglView().width, voglView().height};
    double fragments = 0;
    for (int brickNo = 0; brickNo < volume.bricks->getCurrentBrickSet()->getBrickCount(); brickNo++)
        for (int binNo = 0; binNo < slices.getSamplesNumber(); binNo++)
            fragments += double(voGeometryActions::findProjectedArea(slices.get(brickNo, binNo), modelMatrix,
                                                                     projMatrix, viewport));
    return fragments;
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    const double drawn = countFragments(*polygons);
    voIndexedTetraSet* wholeBox = voglBox(volume);
    {
        VoglPolygons whole(wholeBox, volume, voInterleavedArrayTypeScope::V3F);
        whole.polygonize();
        const double all = countFragments(whole);
        printf("%.0f fragments instead of %.0f: saved %.1f %%\n", drawn, all,
               all > 0 ? 100 * (1 - drawn / all) : 0);
    }
    delete wholeBox;
    delete polygons;
    delete sides;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
