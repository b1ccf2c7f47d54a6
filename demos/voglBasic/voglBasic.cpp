// voglBasic: a volume from a file, drawn in grey or colour through a table, with 2D or 3D textures.
#include "voglMain.h"

#include "brick_io.h"
#include "voglLookup.h"
#include "voxel_range.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

static int maxBrickCount = 0;
static int maxSamplesNumber = 0;
static voInterleavedArrayType interleavedArrayFormat = voInterleavedArrayTypeScope::V3F;

static voRenderingMode renderingMode;
static float loValue, hiValue;

static voVertexData* allVertexData;
static voIndexedFaceSet*** aPolygonSetArray;

static void fail(const char* program, const char* text)
{
    fprintf(stderr, "%s: %s\n", program, text);
    exit(1);
}

// Sizes of bricks of which -bricks, the last ones partly empty, cover the volume.
static int brickSizeFor(int volumeSize, int bricks)
{
    return (volumeSize + (bricks - 1) * options.overlap + bricks - 1) / bricks;
}

// Bricks of no more voxels than they share would never get through the volume.
static void checkOverlap(const char* program, int brickSize)
{
    if (brickSize == 1 || brickSize > options.overlap) return;
    const std::string text = "option -overlap: expected fewer voxels than a brick has on each side (" +
                             std::to_string(brickSize) + "), found '" + std::to_string(options.overlap) + "'";
    fail(program, text.c_str());
}

// Reads every brick of the volume; widens `range` by the values that are seen.
static void readBricks(char* fileName, voBrickSetCollection* aVolume, voExternalFormatType diskDataFormat,
                       vo::ValueRange& range)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    aVolume->getCurrentBrickSet()->getVolumeSizes(xVolumeSize, yVolumeSize, zVolumeSize);
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick* brick; (brick = brickSetIter());) {
        int xBrickOrigin, yBrickOrigin, zBrickOrigin;
        int xBrickSize, yBrickSize, zBrickSize;
        void* vdata = brick->getDataPtr();
        brick->getBrickSizes(xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize, zBrickSize);
        if (myReadBrickIfl(fileName, vdata, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize,
                           zBrickSize, xVolumeSize, yVolumeSize, zVolumeSize))
            exit(1);
        if (diskDataFormat == voExternalFormatTypeScope::LUMINANCE)
            vo::growRange(range, *brick, xVolumeSize, yVolumeSize, zVolumeSize);
        voAppearanceActions::dataConvert(brick, vdata, diskDataFormat);
    }
}

// The values of the file that become the ends of the table: what -dataRange says, else those that the file
// has; all values of an 8-bit type, which its files seldom leave unused, and of volumes of several channels.
static void chooseDataRange(const vo::ValueRange& seen, voDataType dataType, const char* program,
                            const char* fileName)
{
    if (seen.low == seen.high)
        fprintf(stderr, "%s: %s: all voxels are %g; nothing to tell apart\n", program, fileName, seen.low);
    vo::ValueRange range = vo::fullRange(dataType);
    const bool isByte = dataType == voDataTypeScope::UNSIGNED_BYTE || dataType == voDataTypeScope::BYTE;
    if (!isByte && seen.low < seen.high) range = seen;
    if (options.dataRange) range = {options.dataRange->low, options.dataRange->high};
    loValue = float(range.low);
    hiValue = float(range.high);
}

// Sampling planes are at most the diagonal of the scaled volume apart from each other; a view volume is a
// little deeper.
static double countPlanes(const int volumeSize[3])
{
    double diagonal = 0;
    for (int i = 0; i < 3; i++)
        diagonal = std::hypot(diagonal, volumeSize[i] * double(modelScale[i]));
    return std::ceil(1.02 * diagonal / options.sampling) + 1;
}

// Bricks of the largest set: all of the volume, or with 2D textures the slices of one of three directions.
static double countBricks(const int volumeSize[3], const int brickSize[3])
{
    double along[3];
    for (int i = 0; i < 3; i++) {
        const int step = std::max(brickSize[i] - options.overlap, 1);
        along[i] = std::max(std::ceil(double(volumeSize[i] - options.overlap) / step), 1.0);
    }
    if (options.textureDimensions == 3) return along[0] * along[1] * along[2];
    double most = 0;
    for (int i = 0; i < 3; i++)
        most = std::max(most, volumeSize[i] * along[(i + 1) % 3] * along[(i + 2) % 3]);
    return most;
}

static std::string whole(double count)
{
    char text[400];
    snprintf(text, sizeof text, "%.0f", count);
    return text;
}

// The options of these that the user gave, to begin a message with.
static std::string optionsGiven(bool withBricks)
{
    std::string names;
    int count = 0;
    const auto add = [&](bool given, const char* name) {
        if (!given) return;
        names += (count++ ? " and " : "") + std::string(name);
    };
    add(options.sampling != 1, "-sampling");
    add(options.scale != vo::Options().scale, "-scale");
    add(withBricks && options.bricks, "-bricks");
    if (count == 0) return "volume: ";
    return (count == 1 ? "option " : "options ") + names + ": ";
}

// Refuses what would take minutes or all memory. Each brick gets a set of faces for each plane; what no
// option asked for may take longer.
static void checkWork(const char* program, const int volumeSize[3], const int brickSize[3])
{
    const double mostPlanes = 65536, mostBricks = 4096;
    const double planes = countPlanes(volumeSize), bricks = countBricks(volumeSize, brickSize);
    const std::string given = optionsGiven(true);
    const double mostFaceSets = given == "volume: " ? 1e7 : 2e6;
    std::string wrong;
    if (planes > mostPlanes)
        wrong = optionsGiven(false) + "expected at most " + whole(mostPlanes) + " sampling planes, found " +
                whole(planes);
    else if (options.bricks && bricks > mostBricks)
        wrong = "option -bricks: expected at most " + whole(mostBricks) + " bricks, found " + whole(bricks);
    else if (planes * bricks > mostFaceSets)
        wrong = given + "expected at most " + whole(mostFaceSets) + " planes times bricks, found " +
                whole(planes) + " planes and " + whole(bricks) + " bricks";
    if (!wrong.empty()) fail(program, wrong.c_str());
}

voBrickSetCollection* my_InitAppearance(int argc, char** argv)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    int xBrickSize, yBrickSize, zBrickSize;
    voExternalFormatType diskDataFormat;
    voExternalFormatType externalFormat;
    voInternalFormatType internalFormat;
    voDataType dataType;
    voInterpolationType interpolationType =
        options.textureDimensions == 2 ? voInterpolationTypeScope::_2D : voInterpolationTypeScope::_3D;

    if (argc < 2) fail(argv[0], "expected the file of a volume");
    char* dataFileName = argv[1];
    if (myGetVolumeSizesIfl(dataFileName, xVolumeSize, yVolumeSize, zVolumeSize, diskDataFormat, dataType))
        exit(1);
    renderingMode = readLookupTable(argv[0]);

    xBrickSize = xVolumeSize;
    yBrickSize = yVolumeSize;
    zBrickSize = zVolumeSize;
    if (options.bricks) {
        xBrickSize = brickSizeFor(xVolumeSize, (*options.bricks)[0]);
        yBrickSize = brickSizeFor(yVolumeSize, (*options.bricks)[1]);
        zBrickSize = brickSizeFor(zVolumeSize, (*options.bricks)[2]);
    }
    voAppearanceActions::getBestParameters(interpolationType, renderingMode, dataType, diskDataFormat,
                                           internalFormat, externalFormat, xBrickSize, yBrickSize,
                                           zBrickSize);

    for (int size : {xBrickSize, yBrickSize, zBrickSize})
        checkOverlap(argv[0], size);
    const int volumeSize[3] = {xVolumeSize, yVolumeSize, zVolumeSize};
    const int brickSize[3] = {xBrickSize, yBrickSize, zBrickSize};
    checkWork(argv[0], volumeSize, brickSize);
    maxSamplesNumber = int(countPlanes(volumeSize));

    // Bricks that do not divide the volume are partly empty: nothing of the volume is dropped.
    voBrickSetCollection* aVolume =
        new voBrickSetCollection(xVolumeSize, yVolumeSize, zVolumeSize, xBrickSize, yBrickSize, zBrickSize,
                                 voPartialBrickTypeScope::AUGMENT, options.overlap, internalFormat,
                                 externalFormat, dataType, interpolationType);

    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            if (!voAppearanceActions::dataAlloc(brick)) exit(1);
        maxBrickCount = std::max(maxBrickCount, brickSet->getBrickCount());
    }

    aVolume->setCurrentBrickSet(voPlaneOrientationScope::XY);
    vo::ValueRange seen;
    readBricks(dataFileName, aVolume, diskDataFormat, seen);
    chooseDataRange(seen, dataType, argv[0], dataFileName);
    voBrickSetIterator brickSetIter(aVolume->getCurrentBrickSet());
    for (voBrick* brick; (brick = brickSetIter());)
        voAppearanceActions::dataScaleRange(brick, loValue, hiValue);

    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_2D)
        voAppearanceActions::volumeMakeTransposed(aVolume);

    return aVolume;
}

// Vertices of all polygons of a frame. A plane crosses at most this many bricks of a lattice of n bricks (of
// 3 n^2 - 3 n + 1 among n x n x n), and five tetrahedra in each; few polygons have more than six vertices.
static int boundVertices(int brickCount)
{
    const double n = std::ceil(std::cbrt(brickCount));
    const double crossed = std::min(3 * n * n - 3 * n + 1, double(brickCount));
    return int(std::min(100000 + 5 * 6 * crossed * maxSamplesNumber, 5e7));
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    int xVolumeSize, yVolumeSize, zVolumeSize;
    aVolume->getCurrentBrickSet()->getVolumeSizes(xVolumeSize, yVolumeSize, zVolumeSize);
    const float x = float(xVolumeSize), y = float(yVolumeSize), z = float(zVolumeSize);
    const float vtxData[8][3] = {
        {0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}, {0, 0, z}, {x, 0, z}, {x, y, z}, {0, y, z},
    };
    // Five tetrahedra are a cube: one in the middle, four at its corners.
    static const int cubeIndices[] = {
        0, 2, 5, 7, // the middle
        3, 2, 0, 7, //
        1, 2, 5, 0, //
        2, 7, 6, 5, //
        5, 4, 0, 7, //
    };
    const int indexCount = sizeof(cubeIndices) / sizeof(cubeIndices[0]);
    const int tetraCount = indexCount / VO_TETRA_VERTICES;
    const int valuesPerVtx = getValuesPerVertex(interleavedArrayFormat);
    voIndexedTetraSet* aTetraSet =
        new voIndexedTetraSet(vtxData[0], 8, valuesPerVtx, cubeIndices, indexCount);

    allVertexData = new voVertexData(boundVertices(maxBrickCount), valuesPerVtx);
    aPolygonSetArray = new voIndexedFaceSetPtrPtr[maxBrickCount];
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        aPolygonSetArray[j1] = new voIndexedFaceSetPtr[maxSamplesNumber + 1];
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            aPolygonSetArray[j1][j2] = new voIndexedFaceSet(allVertexData, boundFaceCount(tetraCount));
    }
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection* aVolume)
{
    initLookupTable(aVolume, renderingMode, loValue, hiValue);
    voAppearanceActions::volumeOptimize(aVolume, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
}

static void drawOutlines(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(aTetraSet, GL_LINE, interleavedArrayFormat);
    if (aVolume->getInterpolationType() == voInterpolationTypeScope::_3D) {
        vo::setColor(0, 0, 1, 1);
        for (int brickNo = 0; brickNo < aVolume->getCurrentBrickSet()->getBrickCount(); brickNo++)
            voGeometryActions::draw(aVolume->getCurrentBrickSet()->getBrick(brickNo));
    }
}

static void drawFaces(voBrickSet* aBrickSet, const voSortAction& aSortAction, int samplesNumber)
{
    for (int brickNo = 0; brickNo < aBrickSet->getBrickCount(); brickNo++) {
        const int brickSortedNo = aSortAction[brickNo];
        voBrick* aBrick = aBrickSet->getBrick(brickSortedNo);

        uploadTimer.start();
        voAppearanceActions::texgenSetEquation(aBrick);
        voAppearanceActions::textureBind(aBrick);
        uploadTimer.stop();

        drawTimer.start();
        for (int binNo = 0; binNo < samplesNumber; binNo++)
            voGeometryActions::draw(aPolygonSetArray[brickSortedNo][binNo], interleavedArrayFormat);
        drawTimer.stop();
    }
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);

    const bool is2D = aVolume->getInterpolationType() == voInterpolationTypeScope::_2D;
    if (is2D)
        aVolume->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
    if (options.wireframe) drawOutlines(aTetraSet, aVolume);

    polygonizeTimer.start();
    int samplesNumber;
    const float period = float(options.sampling);
    float samplingPeriod[3] = {period / modelScale[0], period / modelScale[1], period / modelScale[2]};
    voGeometryActions::polygonize(
        aTetraSet, aVolume->getCurrentBrickSet(), interleavedArrayFormat, modelMatrix, projMatrix,
        is2D ? voSamplingModeScope::AXIS_ALIGNED : voSamplingModeScope::VIEWPORT_ALIGNED,
        options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME : voSamplingSpaceScope::OBJECT, samplingPeriod,
        maxSamplesNumber, samplesNumber, aPolygonSetArray);
    const voSortAction aSortAction(aVolume->getCurrentBrickSet(), modelMatrix, projMatrix);
    polygonizeTimer.stop();

    voAppearanceActions::textureEnable(aVolume->getInterpolationType());
    voAppearanceActions::texgenEnable();
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->BlendEquation(options.mip ? GL_MAX : GL_FUNC_ADD);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl->DepthMask(GL_FALSE);
    vo::setColor(1, 1, 1, 1);

    drawFaces(aVolume->getCurrentBrickSet(), aSortAction, samplesNumber);

    voAppearanceActions::textureDisable(aVolume->getInterpolationType());
    voAppearanceActions::texgenDisable();
    gl->DepthMask(GL_TRUE);
    gl->BlendEquation(GL_FUNC_ADD);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    for (int j1 = 0; j1 < maxBrickCount; j1++) {
        for (int j2 = 0; j2 < maxSamplesNumber + 1; j2++)
            delete aPolygonSetArray[j1][j2];
        delete[] aPolygonSetArray[j1];
    }
    delete[] aPolygonSetArray;
    delete allVertexData;

    deleteLookupTable();
    voAppearanceActions::volumeUnoptimize(aVolume);
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            voAppearanceActions::dataFree(brick);
    }
    delete aVolume;
    delete aTetraSet;
}
