// voglTwo: two volumes that overlap. They are parts of one scene, cut by the same planes, so that their
// slices interleave in depth order and the volumes shine through each other (guide, pages 116-118).
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <vo/utParts.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

static float offset[3];
static std::optional<std::array<float, 3>> spacing;
static std::string lutFile2;

const VoglProgram voglProgram = {
    .purpose = "Draws two volumes that overlap.\n-lutFile, -lut and -dataRange speak of the first volume.",
    .arguments = "VOLUME1 VOLUME2",
    .example = "head.tif skull.tif -spacing2 3 3 3 -offset -6 14 -8",
    .leastArguments = 2,
    .mostArguments = 2,
    .expected = "the files of two volumes",
    .options =
        {{"offset",
          {"X", "Y", "Z"},
          "where the second volume begins, in voxels of the first (default 0 0 0)",
          [](vo::Arguments& a) {
              for (float& value : offset)
                  value = float(a.number(-1e6, 1e6));
          }},
         {"spacing2",
          {"X", "Y", "Z"},
          "distances of the second volume's voxels, in voxels of the first (default: as the files say)",
          [](vo::Arguments& a) {
              spacing.emplace();
              for (float& value : *spacing)
                  value = float(a.number(1e-3, 1e3));
          }},
         {"lutFile2",
          {"FILE"},
          "the second volume's table (default: an orange ramp)",
          [](vo::Arguments& a) { lutFile2 = a.text(); }}},
    .ownLoop = true,
};

// One of the two. Object space has the voxels of the first volume for unit, and begins at the lower corner of
// the box round both.
struct Part
{
    VoglVolume volume;
    VoglLookup* lookup;
    float origin[3] = {0, 0, 0}, spacing[3] = {1, 1, 1};
    voIndexedTetraSet *box, *outline;

    float end(int axis) const { return origin[axis] + spacing[axis] * float(volume.size[axis]); }
};

static VoglLookup secondLookup;
static Part parts[2];
static voutParts* scene;
static voIndexedTetraSet* sceneBox;

static void readFirst(const char* program, const VoglSource& source)
{
    parts[0].lookup = &voglLookup();
    parts[0].volume = voglReadVolume(program, source);
}

// Takes no options but those of its own, and leaves the first volume's spacing that of the scene.
static void readSecond(const char* program, const VoglSource& source)
{
    const auto rangeOfFirst = std::exchange(options.dataRange, std::nullopt);
    const std::array<float, 3> scale{modelScale[0], modelScale[1], modelScale[2]};
    secondLookup.setTint(1, 0.55f, 0.1f);
    secondLookup.read(program, lutFile2, std::nullopt);
    parts[1].lookup = &secondLookup;
    parts[1].volume = voglReadVolume(program, source, secondLookup.renderingMode());
    std::copy_n(scale.begin(), 3, modelScale);
    options.dataRange = rangeOfFirst;
}

static void place(const char* program, const VoglSource& first, const VoglSource& second)
{
    for (int i = 0; i < 3; i++) {
        parts[1].spacing[i] =
            spacing ? (*spacing)[std::size_t(i)] : float(second.spacing[i] / first.spacing[i]);
        parts[1].origin[i] = offset[i];
        if (offset[i] >= parts[0].end(i) || parts[1].end(i) <= 0)
            voglFail(program, "option -offset: expected a place where the volumes overlap; along axis " +
                                  std::to_string(i) + " the second is at " + std::to_string(offset[i]) +
                                  " to " + std::to_string(parts[1].end(i)) + ", the first at 0 to " +
                                  std::to_string(parts[0].end(i)));
        const float lowest = std::min(0.0f, offset[i]);
        for (Part& part : parts)
            part.origin[i] -= lowest;
    }
    int size[3];
    for (int i = 0; i < 3; i++)
        size[i] = int(std::ceil(std::max(parts[0].end(i), parts[1].end(i))));
    for (Part& part : parts)
        part.volume.maxSamplesNumber = voglCountPlanes(program, size);
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    const VoglSource first = voglOpenBlended(argv[0], argv[1]);
    const VoglSource second = voglOpenBlended(argv[0], argv[2], !lutFile2.empty());
    readFirst(argv[0], first);
    readSecond(argv[0], second);
    place(argv[0], first, second);
    return NULL; // neither of the two: the view shows the tetrahedra round both
}

// The box round both volumes, where the matrix of the part puts it. Planes lie where the tetrahedra are, and
// voxel coordinates outside the volume are clipped away.
static voIndexedTetraSet* makeBox(const Part& part)
{
    float lower[3], upper[3];
    for (int i = 0; i < 3; i++) {
        lower[i] = -part.origin[i] / part.spacing[i];
        upper[i] = (std::max(parts[0].end(i), parts[1].end(i)) - part.origin[i]) / part.spacing[i];
    }
    return voglBox(lower, upper);
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    scene = new voutParts;
    for (Part& part : parts) {
        part.box = makeBox(part);
        part.outline = voglBox(part.volume);
        const int number = scene->add(part.box, voInterleavedArrayTypeScope::V3F, part.volume.bricks);
        const GLdouble toScene[16] = {part.spacing[0],
                                      0,
                                      0,
                                      0,
                                      0,
                                      part.spacing[1],
                                      0,
                                      0,
                                      0,
                                      0,
                                      part.spacing[2],
                                      0,
                                      part.origin[0],
                                      part.origin[1],
                                      part.origin[2],
                                      1};
        scene->setMatrix(number, toScene);
    }
    const float lower[3] = {0, 0, 0};
    float upper[3];
    for (int i = 0; i < 3; i++)
        upper[i] = std::max(parts[0].end(i), parts[1].end(i));
    return sceneBox = voglBox(lower, upper);
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    for (Part& part : parts)
        voglInitTextures(part.volume, *part.lookup);
}

// In the frame of the volume's own voxels.
static void drawOutlines(const Part& part)
{
    GLdouble model[16], projection[16], own[16];
    vo::getMatrices(model, projection);
    for (int row = 0; row < 4; row++) {
        own[12 + row] = model[12 + row];
        for (int i = 0; i < 3; i++) {
            own[4 * i + row] = model[4 * i + row] * double(part.spacing[i]);
            own[12 + row] += model[4 * i + row] * double(part.origin[i]);
        }
    }
    vo::loadMatrices(own, projection);
    voglDrawOutlines(part.outline, part.volume.bricks, voInterleavedArrayTypeScope::V3F);
    vo::loadMatrices(model, projection);
}

void my_DrawVolume(voIndexedTetraSet*, voBrickSetCollection*)
{
    for (int i = 0; i < 2; i++) {
        voglChooseStack(parts[i].volume.bricks);
        drawOutlines(parts[i]);
        scene->setLookupTable(i, parts[i].lookup->get());
    }
    GLdouble model[16], projection[16];
    vo::getMatrices(model, projection);
    float period[3];
    voglSamplingPeriod(period);
    voglBeginBlending();
    drawTimer.start();
    scene->draw(model, projection, voglSamplingMode(parts[0].volume.bricks),
                options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME : voSamplingSpaceScope::OBJECT, period,
                parts[0].volume.maxSamplesNumber);
    drawTimer.stop();
    voglEndBlending();
}

void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*)
{
    delete scene;
    delete sceneBox;
    for (Part& part : parts) {
        delete part.outline;
        delete part.box;
        part.lookup->free();
        voglFreeVolume(part.volume);
    }
}
