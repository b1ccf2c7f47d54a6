#include "voglVolume.h"

#include "brick_io.h"
#include "data_type.h"
#include "voglMain.h"
#include "voxel_range.h"

#include "volume_view/brightness_alpha.h"
#include "volume_view/defaults.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

double countPlanes(const int volumeSize[3])
{
    return vo::samplingPlaneCount(options,
                                  {double(volumeSize[0]), double(volumeSize[1]), double(volumeSize[2])},
                                  {modelScale[0], modelScale[1], modelScale[2]}, voglProgram.margin);
}

std::array<std::int64_t, 3> sizes(const int size[3])
{
    return {size[0], size[1], size[2]};
}

std::string whole(double count)
{
    char text[400];
    snprintf(text, sizeof text, "%.0f", count);
    return text;
}

void checkPlanes(const char* program, double planes)
{
    if (planes > vo::kMostSamplingPlanes)
        voglFail(program, vo::planeOptionsGiven(options, false) + "expected at most " +
                              whole(vo::kMostSamplingPlanes) + " sampling planes, found " + whole(planes));
}

// Refuses what would take minutes or all memory. Each brick gets a set of faces for each plane; what no
// option asked for may take longer.
void checkWork(const char* program, const int volumeSize[3], const int brickSize[3])
{
    const double planes = countPlanes(volumeSize);
    const double bricks = vo::brickCount(options, sizes(volumeSize), sizes(brickSize));
    const std::string given = vo::planeOptionsGiven(options, true);
    const double mostFaceSets = given == "volume: " ? 1e7 : 2e6;
    if (const auto fit = vo::checkBricks(options, sizes(volumeSize), sizes(brickSize)); !fit)
        voglFail(program, fit.failure().text);
    checkPlanes(program, planes);
    if (planes * bricks > mostFaceSets)
        voglFail(program, given + "expected at most " + whole(mostFaceSets) + " planes times bricks, found " +
                              whole(planes) + " planes and " + whole(bricks) + " bricks");
}

void useSpacing(const VoglSource& source)
{
    const auto scale = vo::voxelScale(options, {source.spacing[0], source.spacing[1], source.spacing[2]});
    std::copy(scale.begin(), scale.end(), modelScale);
}

// The bricks, without voxels; `internalFormat` and the others are chosen for this machine.
voBrickSetCollection* makeBricks(const char* program, const VoglSource& source, voRenderingMode renderingMode)
{
    voExternalFormatType externalFormat;
    voInternalFormatType internalFormat;
    voInterpolationType interpolationType =
        options.textureDimensions == 2 ? voInterpolationTypeScope::_2D : voInterpolationTypeScope::_3D;
    int brickSize[3];
    for (std::size_t i = 0; i < 3; i++)
        brickSize[i] = options.bricks
                           ? int(vo::brickSizeFor(source.size[i], (*options.bricks)[i], options.overlap))
                           : source.size[i];
    voAppearanceActions::getBestParameters(interpolationType, renderingMode, source.dataType,
                                           source.diskFormat, internalFormat, externalFormat, brickSize[0],
                                           brickSize[1], brickSize[2]);
    checkWork(program, source.size, brickSize);

    // Bricks that do not divide the volume are partly empty: nothing of the volume is dropped.
    return new voBrickSetCollection(source.size[0], source.size[1], source.size[2], brickSize[0],
                                    brickSize[1], brickSize[2], voPartialBrickTypeScope::AUGMENT,
                                    options.overlap, internalFormat, externalFormat, source.dataType,
                                    interpolationType);
}

// Reads a brick, as the file has it, and widens the range by its values, of volumes of one channel.
void readBrick(const VoglSource& source, voBrick* brick, vo::ValueRange& seen)
{
    int origin[3], size[3];
    brick->getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
    if (source.readBrick(brick->getDataPtr(), origin, size)) exit(1);
    if (source.diskFormat == voExternalFormatTypeScope::LUMINANCE)
        vo::growRange(seen, *brick, source.size[0], source.size[1], source.size[2]);
}

// Reads every brick of a set, and keeps them.
vo::ValueRange readBricks(const VoglSource& source, voBrickSet* brickSet)
{
    vo::ValueRange seen;
    voBrickSetIterator brickSetIter(brickSet);
    for (voBrick* brick; (brick = brickSetIter());) {
        readBrick(source, brick, seen);
        voAppearanceActions::dataConvert(brick, brick->getDataPtr(), source.diskFormat);
    }
    return seen;
}

// Reads every brick of a set, and keeps none.
vo::ValueRange scanBricks(const VoglSource& source, voBrickSet* brickSet)
{
    vo::ValueRange seen;
    voBrickSetIterator brickSetIter(brickSet);
    for (voBrick* brick; (brick = brickSetIter());) {
        if (!voAppearanceActions::dataAlloc(brick)) exit(1);
        readBrick(source, brick, seen);
        voAppearanceActions::dataFree(brick);
    }
    return seen;
}

bool isByte(voDataType dataType)
{
    return dataType == voDataTypeScope::UNSIGNED_BYTE || dataType == voDataTypeScope::BYTE;
}

// The values of the file that become the ends of the table.
vo::ValueRange chooseDataRange(const vo::ValueRange& seen, const char* program, const VoglSource& source)
{
    if (seen.low == seen.high)
        fprintf(stderr, "%s: %s: all voxels are %g; nothing to tell apart\n", program, source.name.c_str(),
                seen.low);
    return vo::dataRange(options, seen, vo::fullRange(source.dataType), isByte(source.dataType));
}

// All but voxels and the data range.
VoglVolume layOut(const char* program, const VoglSource& source, voRenderingMode renderingMode)
{
    VoglVolume volume;
    std::copy_n(source.size, 3, volume.size);
    if (options.shells && options.textureDimensions == 2)
        voglFail(program, "option -shells: expected 3D textures, found -2D");
    volume.renderingMode = renderingMode;
    useSpacing(source);
    volume.bricks = makeBricks(program, source, volume.renderingMode);
    volume.bricks->setCurrentBrickSet(voPlaneOrientationScope::XY);
    volume.maxSamplesNumber = int(countPlanes(source.size));
    volume.maxBrickCount = volume.bricks->getMaxBrickCount();
    return volume;
}

void setDataRange(VoglVolume& volume, const vo::ValueRange& range)
{
    volume.loValue = float(range.low);
    volume.hiValue = float(range.high);
}

} // namespace

void voglFail(const char* program, const std::string& text)
{
    fprintf(stderr, "%s: %s\n", program, text.c_str());
    exit(1);
}

VoglSource voglOpenFile(const char* program, const char* fileName)
{
    if (!fileName) voglFail(program, "expected the file of a volume");
    VoglSource source;
    source.name = fileName;
    char* name = const_cast<char*>(fileName); // the loaders of 1998 do not write to it
    if (myGetVolumeSizesIfl(name, source.size[0], source.size[1], source.size[2], source.diskFormat,
                            source.dataType))
        exit(1);
    myGetVolumeSpacing(name, source.spacing[0], source.spacing[1], source.spacing[2]);
    myGetVolumeAlphaAdded(name, source.alphaAdded);
    source.readBrick = [name, size = std::array{source.size[0], source.size[1], source.size[2]}](
                           void* data, const int origin[3], const int brick[3]) {
        return myReadBrickIfl(name, data, origin[0], origin[1], origin[2], brick[0], brick[1], brick[2],
                              size[0], size[1], size[2]);
    };
    return source;
}

VoglSource voglOpenBlended(const char* program, const char* fileName)
{
    return voglOpenBlended(program, fileName, vo::hasTable(options));
}

VoglSource voglOpenBlended(const char* program, const char* fileName, bool hasTable)
{
    VoglSource source = voglOpenFile(program, fileName);
    const auto type = channelTypeOf(source.dataType);
    if (!source.alphaAdded || options.mip || hasTable || !type) return source;
    source.readBrick = [read = source.readBrick, type = *type](void* data, const int origin[3],
                                                               const int size[3]) {
        const int failed = read(data, origin, size);
        const std::size_t voxels = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
        const std::size_t bytes = voxels * 4 * std::size_t(vo::bytesPerChannel(type));
        if (!failed) vo::setBrightnessAlpha(type, {static_cast<std::byte*>(data), bytes});
        return failed;
    };
    return source;
}

VoglVolume voglReadVolume(const char* program, const VoglSource& source)
{
    return voglReadVolume(program, source, readLookupTable(program));
}

VoglVolume voglReadVolume(const char* program, const VoglSource& source, voRenderingMode renderingMode)
{
    VoglVolume volume = layOut(program, source, renderingMode);
    voBrickSetCollectionIterator collectionIter(volume.bricks);
    for (voBrickSet* brickSet; (brickSet = collectionIter());)
        if (!voAppearanceActions::dataAlloc(brickSet)) exit(1);

    const vo::ValueRange seen = readBricks(source, volume.bricks->getCurrentBrickSet());
    setDataRange(volume, chooseDataRange(seen, program, source));
    voBrickSetIterator brickSetIter(volume.bricks->getCurrentBrickSet());
    for (voBrick* brick; (brick = brickSetIter());)
        voAppearanceActions::dataScaleRange(brick, volume.loValue, volume.hiValue);

    if (volume.bricks->getInterpolationType() == voInterpolationTypeScope::_2D)
        voAppearanceActions::volumeMakeTransposed(volume.bricks);
    return volume;
}

VoglVolume voglOpenVolume(const char* program, const VoglSource& source)
{
    VoglVolume volume = layOut(program, source, readLookupTable(program));
    vo::ValueRange seen = vo::fullRange(source.dataType);
    if (!isByte(source.dataType) && !options.dataRange)
        seen = scanBricks(source, volume.bricks->getCurrentBrickSet());
    setDataRange(volume, chooseDataRange(seen, program, source));
    return volume;
}

int voglCountPlanes(const char* program, const int size[3])
{
    const double planes = countPlanes(size);
    checkPlanes(program, planes);
    return int(planes);
}

void voglInitTextures(const VoglVolume& volume, VoglLookup& lookup)
{
    lookup.make(volume.bricks, volume.renderingMode, volume.loValue, volume.hiValue);
    voAppearanceActions::volumeOptimize(volume.bricks, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
}

void voglFreeVolume(VoglVolume& volume)
{
    voAppearanceActions::volumeUnoptimize(volume.bricks);
    voBrickSetCollectionIterator collectionIter(volume.bricks);
    for (voBrickSet* brickSet; (brickSet = collectionIter());) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; (brick = brickSetIter());)
            voAppearanceActions::dataFree(brick);
    }
    delete volume.bricks;
    volume.bricks = nullptr;
}
