// voglShade: shading without gradients, in tangent space (guide, page 123). Each slice is drawn twice into a
// picture of its own, moved away from the light and towards it, and subtracted: where less lies towards the
// light, the difference is bright. It is the component along the light of the gradient, times two voxels.
#include "voglMain.h"

#include "slice_target.h"
#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include <algorithm>
#include <array>
#include <cmath>

// Towards the light, in eye space: x to the right, y up, z to the viewer; length 1.
static std::array<double, 3> light{-0.48, 0.6, 0.64};

static void setLight(double x, double y, double z)
{
    const double length = std::hypot(x, y, z);
    light = {x / length, y / length, z / length};
}

// The pointer moves on a ball that fills the window: in its middle the light comes from the viewer.
static bool moveLight(vo::Button button, bool, double x, double y)
{
    if (button != vo::Button::Right) return false;
    x = 2 * x - 1;
    y = 2 * y - 1;
    setLight(x, y, std::sqrt(std::max(1 - x * x - y * y, 0.0)));
    return true;
}

static void readLight(vo::Arguments& arguments)
{
    const double x = arguments.number(-1e6, 1e6), y = arguments.number(-1e6, 1e6),
                 z = arguments.number(-1e6, 1e6);
    if (x == 0 && y == 0 && z == 0) return arguments.fail("a direction", arguments.typed());
    setLight(x, y, z);
}

const VoglProgram voglProgram = {
    .purpose = "Draws a volume lit from one side. With 3D textures only.",
    .example = "head.tif -lut 70 60 -view 0 180 -light -1 1 1",
    .options = {{"light",
                 {"X", "Y", "Z"},
                 "the light comes from there: x to the right, y up, z to the viewer (default -3 4 4)",
                 readLight}},
    .ownLoop = true,
    .keys = "Right drag    move the light: as on a ball that fills the window\n",
    .pointer = moveLight,
};

static VoglVolume volume;
static VoglPolygons* polygons;
static vo::SliceTarget* slice;

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    if (options.textureDimensions == 2)
        voglFail(argv[0], "option -2D: expected 3D textures; a slice of a stack cannot be moved across it");
    if (options.shells)
        voglFail(argv[0], "option -shells: expected planes, each of one depth, as its slice is drawn");
    // A slice that is moved by a voxel must stay on the brick's voxels.
    options.overlap = std::max(options.overlap, 3);
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    voIndexedTetraSet* aTetraSet = voglBox(volume);
    polygons = new VoglPolygons(aTetraSet, volume, voInterleavedArrayTypeScope::V3F);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

// One step towards the light, in voxels, as long as the voxels are close together: at most one along each
// axis. The inverse of a turn is its transpose.
static std::array<double, 3> findStep()
{
    GLdouble model[16], projection[16];
    vo::getMatrices(model, projection);
    const double length = std::min({modelScale[0], modelScale[1], modelScale[2]});
    std::array<double, 3> step;
    for (std::size_t i = 0; i < 3; i++) {
        const double scale = double(modelScale[i]);
        const double towards =
            (model[4 * i] * light[0] + model[4 * i + 1] * light[1] + model[4 * i + 2] * light[2]);
        step[i] = length * towards / scale / scale;
    }
    return step;
}

// The polygons of a plane, with the voxels that lie `steps` steps away from them.
static void drawMoved(int sampleNo, const std::array<double, 3>& step, double steps)
{
    voBrickSet* brickSet = volume.bricks->getCurrentBrickSet();
    for (int brickNo = 0; brickNo < brickSet->getBrickCount(); brickNo++) {
        voIndexedFaceSet* faces = polygons->get(brickNo, sampleNo);
        if (faces->getIndices()->getCount() == 0) continue;
        int size[3];
        brickSet->getBrick(brickNo)->getSizes(size[0], size[1], size[2]);
        polygons->bind(brickNo);
        vo::setTextureShift(steps * step[0] / size[0], steps * step[1] / size[1], steps * step[2] / size[2]);
        drawTimer.start();
        voGeometryActions::draw(faces, polygons->getFormat());
        drawTimer.stop();
    }
}

// Colours: 7/8 of the difference of both drawings and 1/4 of their mean; what is lit from behind has less
// than nothing, that is 0. Opacity: the mean.
static void makeSlice(int sampleNo, const std::array<double, 3>& step)
{
    const float shaded = 0.875f, ambient = 0.25f;
    slice->begin();
    gl->BlendFunc(GL_ONE, GL_ONE);
    gl->BlendEquation(GL_FUNC_ADD);
    vo::setColor(shaded + ambient / 2, shaded + ambient / 2, shaded + ambient / 2, 0.5f);
    drawMoved(sampleNo, step, -1);
    gl->BlendEquationSeparate(GL_FUNC_REVERSE_SUBTRACT, GL_FUNC_ADD);
    vo::setColor(shaded - ambient / 2, shaded - ambient / 2, shaded - ambient / 2, 0.5f);
    drawMoved(sampleNo, step, 1);
    vo::setTextureShift(0, 0, 0);
    slice->end();
}

// How deep a plane lies, from -1 to 1; all its points are as deep.
static double findDepth(int sampleNo)
{
    GLdouble model[16], projection[16];
    vo::getMatrices(model, projection);
    for (int brickNo = 0; brickNo < volume.bricks->getCurrentBrickSet()->getBrickCount(); brickNo++) {
        voIndexedFaceSet* faces = polygons->get(brickNo, sampleNo);
        if (faces->getIndices()->getCount() == 0) continue;
        const float* vertex = (*faces)[1]; // entry 0 is the first polygon's count
        double z = model[14];
        for (int i = 0; i < 3; i++)
            z += model[4 * i + 2] * double(vertex[i]);
        return (projection[10] * z + projection[14]) / (projection[11] * z + projection[15]);
    }
    return 1;
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    const VoglView& view = voglView();
    if (!slice || slice->getWidth() != view.width || slice->getHeight() != view.height) {
        delete slice;
        slice = new vo::SliceTarget(view.width, view.height);
    }
    voglDrawOutlines(aTetraSet, aVolume, polygons->getFormat());
    polygons->polygonize();
    const std::array<double, 3> step = findStep();
    for (int sampleNo = 0; sampleNo < polygons->getSamplesNumber(); sampleNo++) {
        voglLookup().enable();
        voglBeginSlices(aVolume, polygons->getFormat());
        makeSlice(sampleNo, step);
        voglBeginSlices(aVolume, polygons->getFormat()); // the blending of the frame
        voAppearanceActions::textureDisable(aVolume->getInterpolationType());
        voAppearanceActions::texgenDisable();
        VoglLookup::disable();
        slice->draw(findDepth(sampleNo));
    }
    voglEndSlices(aVolume);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete slice;
    delete polygons;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
