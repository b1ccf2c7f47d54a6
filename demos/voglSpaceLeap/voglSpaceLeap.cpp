// voglSpaceLeap: as voglBasic, but only those parts of the volume are cut into slices that hold anything.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"
#include "voxel_range.h"

#include <vo/utOccupied.h>

#include <charconv>
#include <cstring>
#include <memory>

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
    .options = {{"separate",
                 {},
                 "do not join sub-cubes into boxes: more tetrahedra, all of one shape",
                 [](vo::Arguments&) { areSeparate = true; }}},
    .keys = "Escape        also prints what was saved in the last frame\n",
};

static VoglVolume volume;
static std::unique_ptr<voutOccupied> occupied;
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

static int channelsOf(voExternalFormatType format)
{
    switch (format) {
    case voExternalFormatTypeScope::LUMINANCE_ALPHA: return 2;
    case voExternalFormatTypeScope::RGBA: return 4;
    default: return 1;
    }
}

// The last channel of each voxel: its value, or its alpha.
static int readValues(const int origin[3], const int size[3], double* values, void* user)
{
    const VoglSource& source = *static_cast<const VoglSource*>(user);
    const auto channels = std::size_t(channelsOf(source.diskFormat));
    const std::size_t count = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]) * channels;
    std::vector<double> voxels(count); // eight bytes are the largest channel
    if (source.readBrick(voxels.data(), origin, size)) return 1;
    const std::vector<double> all = vo::channelValues(source.dataType, voxels.data(), count);
    for (std::size_t last = channels - 1; last < count; last += channels)
        *values++ = all[last];
    return 0;
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    const double low = readValue(argv[0], argv[2]), high = readValue(argv[0], argv[3]);
    if (!(low <= high))
        voglFail(argv[0], std::string("expected LOW up to HIGH, found ") + argv[2] + " " + argv[3]);
    VoglSource source = voglOpenBlended(argv[0], argv[1]);
    const double mostCubes = 1 << 18;
    double cubes = 1;
    for (int size : source.size)
        cubes *= (size - 1) / options.tessellationSize + 1;
    if (cubes > mostCubes)
        voglFail(argv[0], "option -tessellationSize: expected at most " + std::to_string(int(mostCubes)) +
                              " sub-cubes, found " + std::to_string(long(cubes)));
    occupied =
        std::make_unique<voutOccupied>(source.size, readValues, &source, low, high, options.tessellationSize);
    if (occupied->getBlockCount() == 0) {
        if (voError::getErrorNumber() == voErrorTypeScope::BAD_VALUE) exit(1); // reading has said why
        voglFail(argv[0], voError::getErrorString());
    }
    occupied->setMerged(areSeparate ? VO_FALSE : VO_TRUE);
    volume = voglReadVolume(argv[0], source);
    return volume.bricks;
}

// The six sides of each box, without the diagonals of its tetrahedra.
static voIndexedFaceSet* makeSides()
{
    voIndexedFaceSet* faces = new voIndexedFaceSet(8, 3, 8);
    for (int box = 0; box < occupied->getBoxCount(); box++) {
        float ends[2][3];
        occupied->getBox(box, ends[0], ends[1]);
        for (int side = 0; side < 6; side++) {
            const int across = side % 3, u = (across + 1) % 3, v = (across + 2) % 3;
            float corners[4][3];
            for (int corner = 0; corner < 4; corner++) {
                corners[corner][across] = ends[side / 3][across];
                corners[corner][u] = ends[corner == 1 || corner == 2][u];
                corners[corner][v] = ends[corner / 2][v];
            }
            faces->appendPoly(corners[0], 4);
        }
    }
    return faces;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    voIndexedTetraSet* aTetraSet = occupied->tessellate();
    sides = makeSides();
    polygons = new VoglPolygons(aTetraSet, volume, voInterleavedArrayTypeScope::V3F);
    printf("kept %d of %d sub-cubes, in %d boxes\n", occupied->getOccupiedCount(), occupied->getBlockCount(),
           occupied->getBoxCount());
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
    if (polygons->getSamplesNumber() == 0)
        polygons->polygonize(); // the library's engines keep theirs to themselves
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
