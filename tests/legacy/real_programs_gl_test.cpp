// How programs of 1998 to 2002 used the library, written afresh: what they keep, in which order they call,
// and that the picture is right.

#include "draw/draw_scene.h"

#include "expect_error.h"

#include "support/compare.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

namespace {

using namespace vo::test;
using vo::OffscreenProfile;
using vo::VoxelSize;

constexpr int kPixels = 96;
constexpr int kMaxSamples = 150;
const VoxelSize kSize{36, 29, 33};

double barOf(const vo::OffscreenContext& context)
{
    return context.description().find("llvmpipe") != std::string::npos ? 75.0 : 45.0;
}

Field testField()
{
    Field field = ballField(kSize);
    const Field letters = letterFField(kSize), noise = noiseField(kSize, 9);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        field.values[i] =
            std::max(0.7f * letters.values[i], field.values[i] * (0.8f + 0.2f * noise.values[i]));
    return quantised(field);
}

/// A scene-graph node: every enumeration is an int, as in a file, counted from 0 in the order of declaration.
struct VolumeNode
{
    int interpolationTypeField = 2; // _3D
    int renderingModeField = 1;     // MONOCHROME
    int dataFormatField = 1;        // UNSIGNED_BYTE
    int volumeFormatField = 3;      // LUMINANCE
    int partialBrickField = 3;      // AUGMENT_TIGHT
    int lookupTypeField = 2;        // POST_INTERPOLATION
    int samplingModeField = 1;      // VIEWPORT_ALIGNED
    int samplingSpaceField = 2;     // OBJECT
    int vertexFormatField = 0;      // V3F
    int lutCenter = 128, lutWidth = 255;
};

/// The application around it.
class Application
{
public:
    Application(const VolumeNode& node, const Field& field) : node_(node), field_(field) {}
    ~Application()
    {
        delete cache_;
        delete tetras_;
        delete table_;
        voBrickSetCollectionIterator sets(volume_);
        for (voBrickSet* set; (set = sets());) {
            voBrickSetIterator bricks(set);
            for (voBrick* brick; (brick = bricks());)
                voAppearanceActions::dataFree(brick);
        }
        delete volume_;
    }
    Application(const Application&) = delete;
    Application& operator=(const Application&) = delete;

    void load()
    {
        voInterpolationType interpolationType = voInterpolationType(node_.interpolationTypeField);
        voDataType dataType = voDataType(node_.dataFormatField);
        voExternalFormatType diskFormat = voExternalFormatType(node_.volumeFormatField);
        voInternalFormatType internalFormat;
        voExternalFormatType externalFormat;
        int xBrick = 16, yBrick = 16, zBrick = 16;
        voAppearanceActions::getBestParameters(interpolationType, voRenderingMode(node_.renderingModeField),
                                               dataType, diskFormat, internalFormat, externalFormat, xBrick,
                                               yBrick, zBrick);
        volume_ = new voBrickSetCollection(kSize.x, kSize.y, kSize.z, xBrick, yBrick, zBrick,
                                           voPartialBrickType(node_.partialBrickField), 1, internalFormat,
                                           externalFormat, dataType, interpolationType);
        ASSERT_EQ(voError::getErrorNumber(), voError::NO_ERROR);
        voBrickSetCollectionIterator sets(volume_);
        for (voBrickSet* set; (set = sets());) {
            voBrickSetIterator bricks(set);
            for (voBrick* brick; (brick = bricks());)
                voAppearanceActions::dataAlloc(brick);
        }
        volume_->setCurrentBrickSet(voPlaneOrientationScope::XY);
        voBrickSetIterator bricks(volume_->getCurrentBrickSet());
        for (voBrick* brick; (brick = bricks());) {
            readBrick(*brick);
            voAppearanceActions::dataConvert(brick, brick->getDataPtr(), diskFormat);
            float low = -1, high = -1;
            voAppearanceActions::dataScaleRange(brick, low, high);
        }
        if (interpolationType == voInterpolationTypeScope::_2D) {
            voAppearanceActions::volumeMakeTransposed(volume_);
            voAppearanceActions::volumeOptimize(volume_, voOptimizeVolumeTypeScope::PRE_TRANSPOSE);
        }
        expectNoError();
    }

    /// An empty tetra set, filled by subscripts; the counts come last.
    void makeGeometry()
    {
        const voInterleavedArrayType format = voInterleavedArrayType(node_.vertexFormatField);
        const int values = getValuesPerVertex(format);
        static const int indices[20] = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
        tetras_ = new voIndexedTetraSet(8, values, 20);
        for (int i = 0; i < 8; ++i) {
            const float corner[3] = {i % 4 == 1 || i % 4 == 2 ? float(kSize.x) : 0.0f,
                                     i % 4 >= 2 ? float(kSize.y) : 0.0f, i >= 4 ? float(kSize.z) : 0.0f};
            for (int value = 0; value < values; ++value)
                (*tetras_->getVertexData())[i][value] = corner[value % 3];
        }
        for (int i = 0; i < 20; ++i)
            (*tetras_->getIndices())[i] = indices[i];
        tetras_->getVertexData()->setCount(8);
        tetras_->getIndices()->setCount(20);
        cache_ = new voDrawActionCache(tetras_, volume_, kMaxSamples, voSamplingMode(node_.samplingModeField),
                                       tetras_->getVertexData()->getValuesPerVertex(), 250000);
        cache_->setThreshold(2);
        expectNoError();
    }

    /// On every move of a slider: a table dropped and made anew.
    void makeTable()
    {
        delete table_;
        voLookupTableType type = voLookupTableType(node_.lookupTypeField);
        voInternalFormatType internalFormat;
        voExternalFormatType externalFormat;
        voDataType dataType;
        voLookupTable::getBestParameters(volume_, voRenderingMode(node_.renderingModeField), 256, type,
                                         internalFormat, externalFormat, dataType);
        if (type == voLookupTableTypeScope::POST_INTERPOLATION)
            table_ = new voLookupTablePost(internalFormat, 256, externalFormat, dataType);
        else
            table_ = new voLookupTablePre(internalFormat, 256, externalFormat, dataType);
        table_->set(voLookupTableShapeScope::LINEAR, node_.lutCenter, node_.lutWidth);
        table_->load();
        table_->enable();
        if (table_->getType() == voLookupTableTypeScope::PRE_INTERPOLATION) {
            volume_->setDirtyFlag(VO_TRUE);
            voAppearanceActions::volumeOptimize(volume_, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
        }
        expectNoError();
    }

    void moveSliders(int center, int width)
    {
        node_.lutCenter = center;
        node_.lutWidth = width;
        makeTable();
    }

    /// The library's own way to draw.
    void render(voDecorationFlags decorations = voDecorationFlagsScope::NONE)
    {
        if (firstTime_)
            voAppearanceActions::volumeOptimize(volume_, voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
        firstTime_ = false;
        float period[3] = {1, 1, 1};
        voGeometryActions::drawUtility(tetras_, voInterleavedArrayType(node_.vertexFormatField), volume_,
                                       cache_, voSamplingSpace(node_.samplingSpaceField), period,
                                       decorations);
        expectNoError();
    }

    /// The guide's way: arrays exactly as large as may be used, face sets without room for indices over one
    /// array of vertices.
    void renderByLoops(const View& v)
    {
        View view = v;
        const voInterleavedArrayType format = voInterleavedArrayType(node_.vertexFormatField);
        int maxBricks = 0;
        voBrickSetCollectionIterator sets(volume_);
        for (voBrickSet* set; (set = sets());)
            maxBricks = set->getBrickCount() > maxBricks ? set->getBrickCount() : maxBricks;
        voVertexData* vertices = new voVertexData(100000, getValuesPerVertex(format));
        voIndexedFaceSet*** polygons = new voIndexedFaceSetPtrPtr[maxBricks];
        for (int b = 0; b < maxBricks; ++b) {
            polygons[b] = new voIndexedFaceSetPtr[kMaxSamples];
            for (int s = 0; s < kMaxSamples; ++s)
                polygons[b][s] = new voIndexedFaceSet(vertices, 0);
        }
        voSamplingMode mode = voSamplingMode(node_.samplingModeField);
        if (volume_->interpolationType == voInterpolationTypeScope::_2D) {
            mode = voSamplingModeScope::AXIS_ALIGNED;
            volume_->setCurrentBrickSet(
                voGeometryActions::findClosestAxisIndex(view.model.data(), view.projection.data(), mode));
        }
        float period[3] = {1, 1, 1};
        int samples = 0;
        for (int frame = 0; frame < 2; ++frame) // the second must not pile up on the first
            voGeometryActions::polygonize(
                tetras_, volume_->currentBrickSet, format, view.model.data(), view.projection.data(), mode,
                voSamplingSpace(node_.samplingSpaceField), period, kMaxSamples, samples, polygons);
        if (hasTextureComponent(format))
            voAppearanceActions::xfmVox2TexCoords(volume_->currentBrickSet, samples, polygons, format);
        voSortAction sorted(volume_->currentBrickSet, view.model.data(), view.projection.data());
        voAppearanceActions::textureEnable(volume_->interpolationType);
        if (!hasTextureComponent(format)) voAppearanceActions::texgenEnable();
        for (int i = 0; i < volume_->currentBrickSet->getBrickCount(); ++i) {
            voBrick* brick = volume_->currentBrickSet->getBrick(sorted[i]);
            if (!hasTextureComponent(format)) voAppearanceActions::texgenSetEquation(brick);
            voAppearanceActions::textureBind(brick);
            for (int s = 0; s < samples; ++s)
                voGeometryActions::draw(polygons[sorted[i]][s], format);
        }
        if (!hasTextureComponent(format)) voAppearanceActions::texgenDisable();
        voAppearanceActions::textureDisable(volume_->interpolationType);
        for (int b = 0; b < maxBricks; ++b) {
            for (int s = 0; s < kMaxSamples; ++s)
                delete polygons[b][s];
            delete[] polygons[b];
        }
        delete[] polygons;
        delete vertices;
        expectNoError();
    }

    voBrickSetCollection& volume() { return *volume_; }
    voIndexedTetraSet& tetras() { return *tetras_; }

private:
    void readBrick(voBrick& brick)
    {
        int x0, y0, z0, nx, ny, nz;
        brick.getBrickSizes(x0, y0, z0, nx, ny, nz);
        unsigned char* to = static_cast<unsigned char*>(brick.getDataPtr());
        for (int z = z0; z < z0 + nz; ++z)
            for (int y = y0; y < y0 + ny; ++y)
                for (int x = x0; x < x0 + nx; ++x)
                    *to++ = x < kSize.x && y < kSize.y && z < kSize.z
                                ? static_cast<unsigned char>(std::lround(255 * field_.at(x, y, z)))
                                : 0;
    }

    VolumeNode node_;
    const Field& field_;
    voBrickSetCollection* volume_ = NULL;
    voIndexedTetraSet* tetras_ = NULL;
    voDrawActionCache* cache_ = NULL;
    voLookupTable* table_ = NULL;
    bool firstTime_ = true;
};

struct RealPrograms : testing::Test
{
    RealPrograms()
    {
        scene.volume = &field;
        scene.width = scene.height = kPixels;
        scene.overlap = 1;
        scene.color = {1, 1, 1, 0.3};
        scene.view = orthographicView({25, 35}, kSize, kPixels, kPixels);
        context = openFor(scene, OffscreenProfile::Compatibility);
    }
    ~RealPrograms() override { EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR}); }

    const GladGLContext& gl() const { return context->gl(); }

    /// What such a program sets before it draws.
    void prepare()
    {
        gl().MatrixMode(GL_PROJECTION);
        gl().LoadMatrixd(scene.view.projection.data());
        gl().MatrixMode(GL_MODELVIEW);
        gl().LoadMatrixd(scene.view.model.data());
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        gl().Color4dv(scene.color.data());
        gl().Enable(GL_BLEND);
        gl().BlendEquation(scene.compositing == Compositing::max ? GL_MAX : GL_FUNC_ADD);
        gl().BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }

    void setView(const Angles& angles, bool stacks)
    {
        scene.view = orthographicView(angles, kSize, kPixels, kPixels);
        if (!stacks) return;
        View v = scene.view;
        scene.planes = SamplingPlanes::axisAligned;
        scene.stackAxis = 3 - static_cast<int>(voGeometryActions::findClosestAxisIndex(
                                  v.model.data(), v.projection.data(), voSamplingModeScope::AXIS_ALIGNED));
    }

    void setTable(Classification classification, int center, int width)
    {
        scene.classification = classification;
        scene.table.clear();
        for (int i = 0; i < 256; ++i)
            scene.table.insert(
                scene.table.end(), 4,
                static_cast<float>(std::clamp((i - (center - width / 2.0)) / width, 0.0, 1.0)));
    }

    void expectRightPicture(const char* what)
    {
        const Comparison comparison = compare(context->readFloats(), referencePicture(scene));
        EXPECT_GT(comparison.opaquePixels, 500u) << what;
        EXPECT_GE(comparison.psnrMasked, barOf(*context)) << what << ": " << comparison.summary();
    }

    Field field = testField();
    Scene scene;
    std::unique_ptr<vo::OffscreenContext> context;
};

TEST_F(RealPrograms, nodeThatKeepsEnumerationsAsNumbersDrawsRight)
{
    for (const int interpolation : {1, 2, 0, -1}) // _2D, _3D, DEFAULT twice
        for (const int lookup : {1, 2}) {
            VolumeNode node;
            node.interpolationTypeField = interpolation;
            node.lookupTypeField = lookup;
            Application application(node, field);
            application.load();
            application.makeGeometry();
            application.makeTable();
            const bool stacks = interpolation == 1;
            if (!stacks) scene.planes = SamplingPlanes::viewportAligned;
            if (!stacks) scene.stackAxis = -1;
            setTable(lookup == 1 ? Classification::preInterpolation : Classification::postInterpolation, 128,
                     255);
            for (const Angles& angles : {Angles{0, 0}, Angles{25, 35}, Angles{0, 90}, Angles{90, 0}}) {
                setView(angles, stacks);
                prepare();
                application.render();
                expectRightPicture("drawUtility");
            }
        }
}

TEST_F(RealPrograms, loopsOverFaceSetsWithoutRoomForIndicesDrawRight)
{
    for (const int interpolation : {1, 2})
        for (const int format : {0, 1}) { // V3F, T3F_V3F
            VolumeNode node;
            node.interpolationTypeField = interpolation;
            node.vertexFormatField = format;
            Application application(node, field);
            application.load();
            application.makeGeometry();
            application.makeTable();
            setTable(Classification::postInterpolation, 128, 255);
            if (interpolation == 2) scene.planes = SamplingPlanes::viewportAligned;
            if (interpolation == 2) scene.stackAxis = -1;
            for (const Angles& angles : {Angles{25, 35}, Angles{-70, 200}}) {
                setView(angles, interpolation == 1);
                prepare();
                application.renderByLoops(scene.view);
                expectRightPicture("own loops");
                prepare();
                application.render();
                expectRightPicture("drawUtility after own loops");
            }
        }
}

TEST_F(RealPrograms, tableRebuiltOnEverySliderMoveShowsAtOnce)
{
    for (const int lookup : {1, 2}) {
        VolumeNode node;
        node.lookupTypeField = lookup;
        Application application(node, field);
        application.load();
        application.makeGeometry();
        application.makeTable();
        prepare();
        application.render();
        for (const auto& [center, width] : {std::pair(128, 255), {60, 40}, {200, 90}, {128, 255}}) {
            application.moveSliders(center, width);
            setTable(lookup == 1 ? Classification::preInterpolation : Classification::postInterpolation,
                     center, width);
            for (int frame = 0; frame < 2; ++frame) {
                prepare();
                application.render();
                expectRightPicture(lookup == 1 ? "pre" : "post");
            }
        }
    }
}

/// Outlines are blue and yellow: what they leave of each colour is the volume's, and half of all is cut away.
TEST_F(RealPrograms, decorationsUnderAClipPlaneAndTheMaximum)
{
    Application application(VolumeNode(), field);
    application.load();
    application.makeGeometry();
    scene.compositing = Compositing::max;
    scene.color = {0.5, 0.5, 0.5, 1};
    const Picture reference = referencePicture(scene);
    prepare();
    gl().MatrixMode(GL_MODELVIEW);
    gl().LoadIdentity();
    const GLdouble plane[4] = {-1, 0, 0, 0}; // the left half of the picture stays
    gl().ClipPlane(GL_CLIP_PLANE3, plane);
    gl().Enable(GL_CLIP_PLANE3);
    const double bar = barOf(*context) > 60 ? 1e-3 : 1e-2;
    for (const voDecorationFlags decorations :
         {voDecorationFlagsScope::NONE, voDecorationFlagsScope::BRICKS, voDecorationFlagsScope::TETRAS,
          voDecorationFlagsScope::ALL}) {
        prepare();
        application.render(decorations);
        const std::vector<float> picture = context->readFloats();
        int lines[3] = {0, 0, 0}, wrong[3] = {0, 0, 0};
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x)
                for (int c = 0; c < 3; ++c) {
                    const float found = picture[std::size_t(4 * (y * kPixels + x) + c)];
                    if (x >= kPixels / 2 + 1) {
                        EXPECT_EQ(found, 0.0f) << "not cut away: " << x << " " << y;
                        continue;
                    }
                    if (x >= kPixels / 2 - 1 || !reference.isUnmasked(x, y)) continue;
                    if (found == 1.0f)
                        ++lines[c];
                    else if (std::abs(found - reference.pixel(x, y)[c]) > bar)
                        ++wrong[c];
                }
        const bool bricks = decorations & voDecorationFlagsScope::BRICKS;
        const bool tetras = decorations & voDecorationFlagsScope::TETRAS;
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(wrong[c], 0) << "decorations " << decorations << ", colour " << c;
            const bool lined = c == 2 ? bricks : tetras;
            EXPECT_EQ(lines[c] > 50, lined) << "decorations " << decorations << ", colour " << c;
            EXPECT_EQ(lines[c] > 0, lined);
        }
    }
    gl().Disable(GL_CLIP_PLANE3);
    prepare();
    application.render();
    expectRightPicture("without the clip plane");
}

int handled = 0;
void countErrors()
{
    ++handled;
}

/// Code of an application that extends the library reports as the library does.
int extension(bool possible)
{
    if (possible) return 0;
    voError::setErrorNumber(voErrorTypeScope::UNSUPPORTED);
    voError::setErrorString("extension: not on this machine");
    voError::callErrorHandler();
    return 1;
}

TEST_F(RealPrograms, errorsOfTheApplicationGoTheLibrarysWay)
{
    void (*before)(void) = voError::setErrorHandler(countErrors);
    handled = 0;
    EXPECT_EQ(extension(true), 0);
    EXPECT_EQ(handled, 0);
    EXPECT_EQ(extension(false), 1);
    EXPECT_EQ(handled, 1);
    expectUnsupported("extension: not on this machine");
    expectNoError();

    Application application(VolumeNode(), field);
    application.load();
    application.makeGeometry();
    // A mistake of the program's in between: the handler hears of it, and the next frame is right.
    voGeometryActions::drawUtility(NULL, voInterleavedArrayTypeScope::V3F, &application.volume(), NULL,
                                   voSamplingSpaceScope::OBJECT, NULL, voDecorationFlagsScope::NONE);
    EXPECT_EQ(handled, 2);
    EXPECT_EQ(voError::getErrorNumber(), voError::BAD_VALUE);
    voError::getErrorString();
    prepare();
    application.render();
    expectRightPicture("after an error");
    EXPECT_EQ(handled, 2);
    voError::setErrorHandler(before);
}

// ---- What a cache keeps

/// drawUtility through a cache, which tells by its debug messages whether it made polygons.
struct CachedDrawing : RealPrograms
{
    CachedDrawing()
    {
        VolumeNode node;
        application.reset(new Application(node, field));
        application->load();
        application->makeGeometry();
        voState::setEngine(voEngineScope::SLICES);
        voError::setDebugLevel(2);
        voError::setDebugStream(messages);
    }
    ~CachedDrawing() override
    {
        voError::setDebugLevel(0);
        voError::setDebugStream(stderr);
    }

    std::string draw(voDrawActionCache* kept, voBrickSetCollection& volume)
    {
        messages.str("");
        prepare();
        EXPECT_EQ(voGeometryActions::drawUtility(&application->tetras(), voInterleavedArrayTypeScope::V3F,
                                                 &volume, kept, space, period, voDecorationFlagsScope::NONE),
                  0);
        expectNoError();
        return messages.str().find("new polygons") != std::string::npos    ? "new"
               : messages.str().find("kept polygons") != std::string::npos ? "kept"
                                                                           : "neither";
    }
    std::string draw() { return draw(&cache, application->volume()); }

    /// Polygons were made, and the picture is that of a cache which has never drawn.
    void expectNewAndRight(const char* what)
    {
        EXPECT_EQ(draw(), "new") << what;
        const std::vector<float> picture = context->readFloats();
        EXPECT_EQ(draw(), "kept") << what;
        EXPECT_EQ(context->readFloats(), picture) << what;
        voDrawActionCache fresh(&application->tetras(), &application->volume(), kMaxSamples,
                                voSamplingModeScope::VIEWPORT_ALIGNED, 3, 250000);
        EXPECT_EQ(draw(&fresh, application->volume()), "new");
        EXPECT_EQ(context->readFloats(), picture) << what;
    }

    /// Turns the view from where it began, round an axis across it.
    void turn(double degrees)
    {
        scene.view = orthographicView({25, 35}, kSize, kPixels, kPixels);
        scene.view.model = multiply(rotation(degrees, 0.6, 0.8, 0), scene.view.model);
    }

    std::ostringstream messages;
    std::unique_ptr<Application> application;
    voDrawActionCache cache{NULL, NULL, kMaxSamples, voSamplingModeScope::VIEWPORT_ALIGNED, 3, 250000};
    voSamplingSpace space = voSamplingSpaceScope::OBJECT;
    float period[3] = {1, 1, 1};
};

TEST_F(CachedDrawing, withoutAThresholdAnyChangeOfTheViewCounts)
{
    EXPECT_EQ(draw(), "new");
    EXPECT_EQ(draw(), "kept");
    turn(0.001);
    expectNewAndRight("a turn");
    scene.view.model = multiply(translation(0, 0, 0.25), scene.view.model);
    EXPECT_EQ(draw(), "new") << "a shift";
}

TEST_F(CachedDrawing, thresholdIsInDegreesOfTheViewTheyWereMadeFor)
{
    cache.setThreshold(2);
    EXPECT_EQ(draw(), "new");
    for (const double degrees : {1.0, 1.9, -1.9, 0.5}) {
        turn(degrees);
        EXPECT_EQ(draw(), "kept") << degrees;
    }
    turn(2.1);
    expectNewAndRight("2.1 degrees");
    turn(0.2); // 1.9 from there
    EXPECT_EQ(draw(), "kept");
    turn(-0.2);
    EXPECT_EQ(draw(), "new") << "small steps add up";
    cache.setThreshold(0);
    turn(-0.3);
    EXPECT_EQ(draw(), "new");
    cache.setThreshold(-1);
    expectBadValue("threshold");
}

TEST_F(CachedDrawing, keptPolygonsAreNearlyRight)
{
    cache.setThreshold(2);
    EXPECT_EQ(draw(), "new");
    turn(1.5);
    EXPECT_EQ(draw(), "kept");
    const Comparison comparison = compare(context->readFloats(), referencePicture(scene));
    EXPECT_GE(comparison.psnrMasked, 25.0) << comparison.summary();
}

TEST_F(CachedDrawing, tetrahedraCountByTheirContent)
{
    EXPECT_EQ(draw(), "new");
    voVertexData& vertices = *application->tetras().getVertexData();
    for (int i = 0; i < 8; ++i) // as programs do each frame
        for (int axis = 0; axis < 3; ++axis)
            vertices[i][axis] = vertices[i][axis] + 0.0f;
    EXPECT_EQ(draw(), "kept");
    vertices[6][0] -= 3;
    expectNewAndRight("a vertex");
    std::swap((*application->tetras().getIndices())[0], (*application->tetras().getIndices())[4]);
    expectNewAndRight("indices");
    application->tetras().getIndices()->setCount(16);
    expectNewAndRight("a tetrahedron less");
}

TEST_F(CachedDrawing, changedPeriodSpaceAndSetCount)
{
    EXPECT_EQ(draw(), "new");
    period[1] = 1.5f;
    expectNewAndRight("period");
    space = voSamplingSpaceScope::VIEW_VOLUME;
    expectNewAndRight("space");
    space = voSamplingSpaceScope::DEFAULT;
    EXPECT_EQ(draw(), "new");
    space = voSamplingSpaceScope::OBJECT; // which is the default
    EXPECT_EQ(draw(), "kept");

    VolumeNode node;
    node.interpolationTypeField = 1;
    Application stacks(node, field);
    stacks.load();
    EXPECT_EQ(draw(&cache, stacks.volume()), "new");
    EXPECT_EQ(draw(&cache, stacks.volume()), "kept");
    const voBrickSet* before = stacks.volume().getCurrentBrickSet();
    cache.setThreshold(180); // the view does not count now
    for (const Angles& angles : {Angles{0, 0}, Angles{0, 90}, Angles{90, 0}}) {
        scene.view = orthographicView(angles, kSize, kPixels, kPixels);
        const std::string made = draw(&cache, stacks.volume());
        EXPECT_EQ(made, stacks.volume().getCurrentBrickSet() == before ? "kept" : "new");
        before = stacks.volume().getCurrentBrickSet();
        EXPECT_EQ(draw(&cache, stacks.volume()), "kept");
    }
}

TEST_F(CachedDrawing, invalidateMakesThemAnew)
{
    EXPECT_EQ(draw(), "new");
    EXPECT_EQ(draw(), "kept");
    voCache& base = cache;
    base.invalidate();
    expectNewAndRight("invalidate");
    voCache* owned = new voDrawActionCache(&application->tetras(), &application->volume(), kMaxSamples,
                                           voSamplingModeScope::VIEWPORT_ALIGNED, 3, 250000);
    EXPECT_EQ(draw(static_cast<voDrawActionCache*>(owned), application->volume()), "new");
    delete owned;
}

TEST_F(CachedDrawing, samplesAreBoundedByTheCache)
{
    voDrawActionCache few(&application->tetras(), &application->volume(), 7,
                          voSamplingModeScope::VIEWPORT_ALIGNED, 3, 250000);
    EXPECT_EQ(draw(&few, application->volume()), "new");
    EXPECT_NE(messages.str().find(" 7 samples"), std::string::npos) << messages.str();
    scene.maxSamples = 7;
    expectRightPicture("seven samples");
}

TEST_F(CachedDrawing, samplingModeIsThatOfTheCache)
{
    voDrawActionCache axes(&application->tetras(), &application->volume(), kMaxSamples,
                           voSamplingModeScope::AXIS_ALIGNED, 3, 250000);
    EXPECT_EQ(draw(&axes, application->volume()), "new");
    scene.planes = SamplingPlanes::axisAligned;
    expectRightPicture("across an axis");
}

} // namespace
