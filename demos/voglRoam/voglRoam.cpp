// voglRoam: a cube of interest that roams through a volume in bricks, which may be larger than memory (guide,
// page 124). The tetrahedra are the cube's. Bricks are read from the file when the cube first meets them, and
// dropped when it has left them.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>

// Of the cube: its middle and its side, in voxels.
struct Interest
{
    std::array<double, 3> middle;
    double side;
};

static std::optional<Interest> interest;
static bool interestMoved = true;

static void readInterest(vo::Arguments& arguments)
{
    interest.emplace();
    for (double& place : interest->middle)
        place = arguments.number(-1e6, 1e6);
    interest->side = arguments.number(1, 1e6, "a side in voxels");
}

static bool moveInterest(int key);

const VoglProgram voglProgram = {
    .purpose = "Draws a cube of a volume; of its bricks, only those that the cube meets are read and kept.",
    .example = "head.tif -voi 90 140 100 80 -bricks 5 5 5",
    .options = {{"voi",
                 {"X", "Y", "Z", "SIDE"},
                 "the cube of interest: its middle and its side, in voxels (default: half of the volume)",
                 readInterest}},
    .ownLoop = true,
    .keys = "j l           move the cube along x, down and up\n"
            "u o           move the cube along y\n"
            "k i           move the cube along z\n"
            "- +           make it smaller or larger\n",
    .key = moveInterest,
};

static VoglSource source;
static VoglVolume volume;
static voIndexedTetraSet* box;
static VoglPolygons* polygons;
// Of the current set's bricks, by number: those that the cube meets. The bricks themselves have no voxels.
static std::map<int, std::unique_ptr<voTexture3D>> resident;
static voBrickSet* residentSet;

// The middle stays in the volume.
static void keepInside()
{
    for (std::size_t i = 0; i < 3; i++)
        interest->middle[i] = std::clamp(interest->middle[i], 0.0, double(volume.size[i]));
    interest->side = std::clamp(interest->side, 1.0, 2.0 * *std::max_element(volume.size, volume.size + 3));
}

static bool moveInterest(int key)
{
    const double step = interest->side / 8;
    switch (key) {
    case 'j': interest->middle[0] -= step; break;
    case 'l': interest->middle[0] += step; break;
    case 'u': interest->middle[1] -= step; break;
    case 'o': interest->middle[1] += step; break;
    case 'k': interest->middle[2] -= step; break;
    case 'i': interest->middle[2] += step; break;
    case '-': interest->side /= 1.25; break;
    case '+':
    case '=': interest->side *= 1.25; break;
    default: return false;
    }
    keepInside();
    interestMoved = true;
    return true;
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    source = voglOpenBlended(argv[0], argv[1]);
    if (!options.bricks) {
        options.bricks.emplace();
        for (std::size_t i = 0; i < 3; i++)
            (*options.bricks)[i] = std::clamp(source.size[i] / 8, 1, 4);
    }
    volume = voglOpenVolume(argv[0], source);
    if (!interest) {
        interest.emplace();
        for (std::size_t i = 0; i < 3; i++)
            interest->middle[i] = volume.size[i] / 2.0;
        interest->side = *std::max_element(volume.size, volume.size + 3) / 2.0;
    }
    keepInside();
    return volume.bricks;
}

static std::array<float, 6> cube()
{
    std::array<float, 6> ends;
    for (std::size_t i = 0; i < 3; i++) {
        ends[i] = float(std::max(interest->middle[i] - interest->side / 2, 0.0));
        ends[3 + i] = float(std::min(interest->middle[i] + interest->side / 2, double(volume.size[i])));
    }
    return ends;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    // Room for polygons of the whole volume.
    box = voglBox(volume);
    polygons = new VoglPolygons(box, volume, voInterleavedArrayTypeScope::V3F);
    return box;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    initLookupTable(volume.bricks, volume.renderingMode, volume.loValue, volume.hiValue);
}

static void moveBox()
{
    const std::array<float, 6> ends = cube();
    const std::unique_ptr<voIndexedTetraSet> moved(voglBox(&ends[0], &ends[3]));
    std::copy_n(moved->getVertexData()->getDataPtr(), 3 * moved->getVertexData()->getCount(),
                box->getVertexData()->getDataPtr());
}

// What lies beyond the clip box is drawn with another brick.
static bool meets(voBrick* brick)
{
    const std::array<float, 6> ends = cube();
    float lower[3], upper[3];
    brick->getClipBrickSizes(lower, upper);
    for (std::size_t i = 0; i < 3; i++)
        if (upper[i] <= ends[i] || lower[i] >= ends[3 + i]) return false;
    return true;
}

// The brick's voxels as a texture; once that is resident, memory need not hold them.
static std::unique_ptr<voTexture3D> readTexture(voBrick* brick)
{
    auto texture = std::make_unique<voTexture3D>(brick->getInternalFormat(), brick->getExternalFormat(),
                                                 brick->getDataType());
    int origin[3], size[3];
    brick->getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
    texture->setSizes(size[0], size[1], size[2]);
    void* data = voAppearanceActions::dataAlloc(texture.get());
    if (!data || source.readBrick(data, origin, size)) exit(1);
    voAppearanceActions::dataConvert(texture.get(), data, source.diskFormat);
    voAppearanceActions::dataScaleRange(texture.get(), volume.loValue, volume.hiValue);
    voAppearanceActions::textureBind(texture.get());
    voAppearanceActions::dataFree(texture.get());
    return texture;
}

// The four steps of the guide: which bricks have come into the cube, read them, which have left it, drop
// them.
static void updateResident(voBrickSet* brickSet)
{
    if (residentSet != brickSet) resident.clear(); // another stack
    residentSet = brickSet;
    const auto dropped = std::erase_if(
        resident, [brickSet](const auto& entry) { return !meets(brickSet->getBrick(entry.first)); });
    int read = 0;
    for (int brickNo = 0; brickNo < brickSet->getBrickCount(); brickNo++) {
        if (resident.count(brickNo) || !meets(brickSet->getBrick(brickNo))) continue;
        resident[brickNo] = readTexture(brickSet->getBrick(brickNo));
        read++;
    }
    printf("%zu of %d bricks: %d read, %zu dropped\n", resident.size(), brickSet->getBrickCount(), read,
           size_t(dropped));
    fflush(stdout);
}

static void drawOutlines()
{
    if (!options.wireframe) return;
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(box, GL_LINE, polygons->getFormat());
    if (volume.bricks->getInterpolationType() == voInterpolationTypeScope::_2D) return;
    vo::setColor(0, 0, 1, 1);
    for (const auto& [brickNo, texture] : resident)
        voGeometryActions::draw(residentSet->getBrick(brickNo));
}

static void drawSlices()
{
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    const voSortAction order(residentSet, modelMatrix, projMatrix);
    for (int i = 0; i < residentSet->getBrickCount(); i++) {
        const auto texture = resident.find(order[i]);
        if (texture == resident.end()) continue;
        voAppearanceActions::texgenSetEquation(residentSet->getBrick(order[i]));
        voAppearanceActions::textureBind(texture->second.get());
        drawTimer.start();
        for (int sampleNo = 0; sampleNo < polygons->getSamplesNumber(); sampleNo++)
            voGeometryActions::draw(polygons->get(order[i], sampleNo), polygons->getFormat());
        drawTimer.stop();
    }
}

void my_DrawVolume(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglChooseStack(volume.bricks);
    voBrickSet* brickSet = volume.bricks->getCurrentBrickSet();
    if (interestMoved || brickSet != residentSet) {
        moveBox();
        uploadTimer.start();
        updateResident(brickSet);
        uploadTimer.stop();
        interestMoved = false;
    }
    drawOutlines();
    polygons->polygonize();
    voglBeginSlices(volume.bricks, polygons->getFormat());
    drawSlices();
    voglEndSlices(volume.bricks);
}

void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*)
{
    resident.clear();
    delete polygons;
    delete box;
    deleteLookupTable();
    voglFreeVolume(volume);
}
