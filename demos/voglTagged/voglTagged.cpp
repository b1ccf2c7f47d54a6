// voglTagged: a volume whose voxels have tags, drawn class by class, each with a table of its own (guide,
// page 137). The tags lie in a second volume of the same size. Slice by slice they go into the stencil
// buffer, which then lets each class's table touch that class alone.
#include "voglMain.h"

#include "tag_stencil.h"
#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

#include "volume_view/defaults.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

static const int kMostTags = 255;

static std::map<int, std::string> tableFiles; // by tag
static std::set<int> hidden;

// What the stencil buffer says of the classes: 1, 2, ..., and 0 where there is none.
static std::map<int, VoglLookup> classes; // those that are drawn, by tag

static bool moveRamps(vo::Button button, bool pressed, double x, double y)
{
    if (button != vo::Button::Middle) return false;
    for (auto& [tag, lookup] : classes)
        if (!pressed) lookup.moveRamp(x, 2 * (1 - y));
    return true;
}

static int readTag(vo::Arguments& arguments)
{
    return arguments.integer(0, kMostTags, "a tag");
}

const VoglProgram voglProgram = {
    .purpose = "Draws a volume class by class, as the tags of its voxels say.\n"
               "TAGS is a volume of 8 bits, of the same size: a class for each of its values but 0.",
    .arguments = "VOLUME TAGS",
    .example = "head.tif head-tags.tif -table 2 brain.lut",
    .leastArguments = 2,
    .mostArguments = 2,
    .expected = "the files of a volume and of its tags",
    .options = {{"table",
                 {"TAG", "FILE"},
                 "draw the voxels with this tag, 0 too, through the table in FILE (default: ramps in one\n"
                 "colour each); may be given for each tag",
                 [](vo::Arguments& a) {
                     const int tag = readTag(a);
                     tableFiles[tag] = a.text();
                 }},
                {"hide",
                 {"TAG"},
                 "do not draw the voxels with this tag; may be given for each tag",
                 [](vo::Arguments& a) { hidden.insert(readTag(a)); }}},
    .ownLoop = true,
    .pointer = moveRamps,
};

static VoglVolume volume, tags;
static voIndexedTetraSet* box;
static VoglPolygons* polygons;
static TagStencil* stencil;

static VoglVolume readTags(const char* program, const VoglSource& source)
{
    if (source.diskFormat != voExternalFormatTypeScope::LUMINANCE ||
        source.dataType != voDataTypeScope::UNSIGNED_BYTE)
        voglFail(program, source.name + ": expected tags of one channel of 8 bits, found other voxels");
    if (!std::equal(source.size, source.size + 3, volume.size)) {
        std::string found;
        for (const int size :
             {source.size[0], source.size[1], source.size[2], volume.size[0], volume.size[1]})
            found += std::to_string(size) + " ";
        voglFail(program, source.name + ": expected as many tags as the volume has voxels, found " + found +
                              std::to_string(volume.size[2]));
    }
    // -dataRange and the spacing are the volume's; tags stay what they are.
    const auto range = std::exchange(options.dataRange, std::nullopt);
    const std::array<float, 3> scale{modelScale[0], modelScale[1], modelScale[2]};
    const VoglVolume read = voglReadVolume(program, source, voRenderingModeScope::MONOCHROME);
    options.dataRange = range;
    std::copy_n(scale.begin(), 3, modelScale);
    return read;
}

static std::set<int> findTags()
{
    std::set<int> found;
    voBrickSetIterator bricks(tags.bricks->getCurrentBrickSet());
    for (voBrick* brick; (brick = bricks());) {
        const unsigned char* voxels = static_cast<const unsigned char*>(brick->getDataPtr());
        found.insert(voxels, voxels + brick->getDataSize());
    }
    return found;
}

// Colours that are far apart, whatever tags there are.
static void tint(VoglLookup& lookup, int number)
{
    static const float colors[6][3] = {{1, 0.75f, 0.6f}, {0.3f, 0.7f, 1},  {1, 0.35f, 0.25f},
                                       {0.4f, 1, 0.4f},  {1, 0.9f, 0.25f}, {0.85f, 0.45f, 1}};
    const float* color = colors[number % 6];
    lookup.setTint(color[0], color[1], color[2]);
}

// Tags that options speak of and nobody has are slips of the pen.
static void checkTag(const char* program, const char* option, int tag, const std::set<int>& found)
{
    if (found.count(tag)) return;
    voglFail(program, std::string("option ") + option + ": expected a tag that voxels have, found '" +
                          std::to_string(tag) + "'");
}

static void makeClasses(const char* program)
{
    const std::set<int> found = findTags();
    for (const auto& [tag, file] : tableFiles)
        checkTag(program, "-table", tag, found);
    for (const int tag : hidden)
        checkTag(program, "-hide", tag, found);
    for (const int tag : found) {
        const auto file = tableFiles.find(tag);
        if (hidden.count(tag) || (tag == 0 && file == tableFiles.end())) continue;
        const int number = int(classes.size());
        VoglLookup& lookup = classes[tag];
        tint(lookup, number);
        lookup.read(program, file == tableFiles.end() ? options.lutFile : file->second, options.lut);
    }
    if (classes.size() > 255)
        voglFail(program, "expected at most 255 classes, found " + std::to_string(classes.size()));
}

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    const bool hasTable = vo::hasTable(options) || !tableFiles.empty();
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1], hasTable));
    tags = readTags(argv[0], voglOpenFile(argv[0], argv[2]));
    makeClasses(argv[0]);
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
    for (auto& [tag, lookup] : classes)
        lookup.make(volume.bricks, lookup.renderingMode(), volume.loValue, volume.hiValue);
    for (const VoglVolume* each : {&volume, &tags})
        voAppearanceActions::volumeOptimize(each->bricks, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    stencil = new TagStencil(volume.bricks->getInterpolationType() == voInterpolationTypeScope::_2D);
}

// Writes each class's number into the stencil buffer, and nothing else.
static void drawTags(int sampleNo)
{
    voBrickSet* brickSet = tags.bricks->getCurrentBrickSet();
    gl->Clear(GL_STENCIL_BUFFER_BIT);
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    for (int brickNo = 0; brickNo < brickSet->getBrickCount(); brickNo++) {
        voIndexedFaceSet* faces = polygons->get(brickNo, sampleNo);
        if (faces->getIndices()->getCount() == 0) continue;
        voAppearanceActions::textureBind(brickSet->getBrick(brickNo));
        int number = 0;
        for (const auto& [tag, lookup] : classes) {
            gl->StencilFunc(GL_ALWAYS, ++number, 255);
            stencil->draw(faces, brickSet->getBrick(brickNo), tag);
        }
    }
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

static void drawClasses(int sampleNo)
{
    gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    int number = 0;
    for (auto& [tag, lookup] : classes) {
        gl->StencilFunc(GL_EQUAL, ++number, 255);
        lookup.enable();
        polygons->drawPlane(sampleNo);
    }
}

void my_DrawVolume(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglChooseStack(volume.bricks);
    voglChooseStack(tags.bricks);
    voglDrawOutlines(box, volume.bricks, polygons->getFormat());
    polygons->polygonize();
    voglBeginSlices(volume.bricks, polygons->getFormat());
    gl->Enable(GL_STENCIL_TEST);
    for (int sampleNo = 0; sampleNo < polygons->getSamplesNumber(); sampleNo++) {
        drawTags(sampleNo);
        drawClasses(sampleNo);
    }
    gl->Disable(GL_STENCIL_TEST);
    voglEndSlices(volume.bricks);
}

void my_Cleanup(voIndexedTetraSet*, voBrickSetCollection*)
{
    delete stencil;
    delete polygons;
    delete box;
    classes.clear();
    voglFreeVolume(volume);
    voglFreeVolume(tags);
}
