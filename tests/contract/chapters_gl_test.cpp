// The guide's chapters 3, 6, 7 and 8, compiled in two dialects, run on volumes whose pictures have closed
// forms.

#include "offscreen/offscreen.h"

#include "../legacy/expect_error.h"
#include "../legacy/face_scene.h"
#include "gl_names.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#define DIALECT cxx98
#include "chapters.h"
#undef DIALECT
#define DIALECT cxx20
#include "chapters.h"

namespace {

using namespace vo::test;
using Interpolation = voInterpolationTypeScope;
using External = voExternalFormatTypeScope;
using Format = voInterleavedArrayTypeScope;

constexpr int kSize = 8; // voxels a side, and pixels

/// The sizes that the file of myReadBrickIfl with eight arguments has.
int fileSize = kSize;

unsigned char rampVoxel(int x, int y, int z)
{
    return static_cast<unsigned char>(x + 8 * y + 64 * z);
}

/// What a file holds: "ramp", or "constant N".
unsigned char fileVoxel(const char* fileName, int x, int y, int z)
{
    if (std::strncmp(fileName, "constant ", 9) == 0)
        return static_cast<unsigned char>(std::atoi(fileName + 9));
    return rampVoxel(x, y, z);
}

} // namespace

int myReadBrickIfl(char* fileName, void* data, int xO, int yO, int zO, int xB, int yB, int zB, int xV, int yV,
                   int zV)
{
    unsigned char* voxel = static_cast<unsigned char*>(data);
    for (int z = zO; z < zO + zB; ++z)
        for (int y = yO; y < yO + yB; ++y)
            for (int x = xO; x < xO + xB; ++x)
                *voxel++ = x < xV && y < yV && z < zV ? fileVoxel(fileName, x, y, z) : 0;
    return 0;
}

int myReadBrickIfl(char* fileName, void* data, int xO, int yO, int zO, int xB, int yB, int zB)
{
    return myReadBrickIfl(fileName, data, xO, yO, zO, xB, yB, zB, fileSize, fileSize, fileSize);
}

int myReadBrickRaw(char** fileNames, void* data, int xO, int yO, int zO, int xB, int yB, int zB, int xV,
                   int yV, int zV, int headerLength, int bytesPerVoxel)
{
    if (headerLength != 16 || bytesPerVoxel != 1) return 1;
    return myReadBrickIfl(fileNames[0], data, xO, yO, zO, xB, yB, zB, xV, yV, zV);
}

namespace {

// The functions of chapters.h in one dialect.
#define CHAPTER_FUNCTIONS(X)                                                                                 \
    X(readVolume)                                                                                            \
    X(convertThroughBuffer)                                                                                  \
    X(convertInPlace)                                                                                        \
    X(lendMemory)                                                                                            \
    X(readRaw)                                                                                               \
    X(makeCube)                                                                                              \
    X(drawVolume)                                                                                            \
    X(enableTable)                                                                                           \
    X(rampInstead)                                                                                           \
    X(suggestedTable)                                                                                        \
    X(testForError)                                                                                          \
    X(handleError)                                                                                           \
    X(cleanUp)                                                                                               \
    X(useFaceSets)                                                                                           \
    X(makeColouredCube)                                                                                      \
    X(crossSections)                                                                                         \
    X(pickVoxels)                                                                                            \
    X(findCamera)                                                                                            \
    X(initializeVoxels)                                                                                      \
    X(drawGenerated)                                                                                         \
    X(drawThroughTextureMatrix)                                                                              \
    X(interleave)                                                                                            \
    X(brickSizes)                                                                                            \
    X(suggestBrickSizes)                                                                                     \
    X(drawOutline)                                                                                           \
    X(selectStack)                                                                                           \
    X(loadAndBind)                                                                                           \
    X(customDraw)                                                                                            \
    X(visitInOrder)                                                                                          \
    X(sliceAndClip)                                                                                          \
    X(clipToTenPlanes)                                                                                       \
    X(selectClosest)                                                                                         \
    X(drawWithMode)                                                                                          \
    X(projectedArea)

struct Chapters
{
    const char* dialect;
#define MEMBER(name) decltype(&cxx98::name) name;
    CHAPTER_FUNCTIONS(MEMBER)
};
#define OF_98(name) cxx98::name,
#define OF_20(name) cxx20::name,
const Chapters kDialects[] = {{"cxx98", CHAPTER_FUNCTIONS(OF_98)}, {"cxx20", CHAPTER_FUNCTIONS(OF_20)}};

void PrintTo(const Chapters& chapters, std::ostream* out)
{
    *out << chapters.dialect;
}

/// A compatibility context of kSize^2 float pixels over [0, kSize]^2, seen along -z: the centre of pixel (x,
/// y) is (x + 1/2, y + 1/2).
class ChaptersGL : public testing::TestWithParam<Chapters>
{
protected:
    ChaptersGL()
    {
        OffscreenRequest request;
        request.width = request.height = kSize;
        request.floatColor = true;
        std::string whyNot;
        context_ = vo::openOffscreen(request, &whyNot);
        if (!context_) {
            ADD_FAILURE() << whyNot;
            return;
        }
        current_ = context_.get();
        leadOpenGlNames([](const char* name) { return current_->getProcAddress(name); });
        fileSize = kSize;
        gl().MatrixMode(GL_PROJECTION);
        gl().LoadMatrixd(projection_);
        gl().MatrixMode(GL_MODELVIEW);
        gl().Disable(GL_DEPTH_TEST);
        clear();
    }
    ~ChaptersGL() override
    {
        expectNoError();
        EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
    }

    using OffscreenRequest = vo::OffscreenRequest;

    const GladGLContext& gl() const { return context_->gl(); }
    void clear() const
    {
        gl().ClearColor(0, 0, 0, 0);
        gl().Clear(GL_COLOR_BUFFER_BIT);
    }
    float red(int x, int y) const
    {
        return context_->readFloats()[static_cast<std::size_t>(4 * (y * kSize + x))];
    }
    /// The pixels whose centres lie well within the volume all have this red.
    void expectInside(double expected) const
    {
        for (int y = 1; y < kSize - 1; ++y)
            for (int x = 1; x < kSize - 1; ++x)
                EXPECT_NEAR(red(x, y), expected, 2e-4) << x << ' ' << y;
    }

    std::unique_ptr<vo::OffscreenContext> context_;
    Matrix projection_ = ortho(kSize / 2, -100, 100) * translation(-kSize / 2, -kSize / 2, 0);
    Matrix identity_;
    char ramp_[5] = "ramp";
    inline static vo::OffscreenContext* current_ = nullptr;
};

INSTANTIATE_TEST_SUITE_P(Dialects, ChaptersGL, testing::ValuesIn(kDialects),
                         [](const auto& tested) { return std::string(tested.param.dialect); });

/// One face set [0][0]: the square [0, kSize]^2 at this height, in voxels too where the format has room for
/// them.
class Square
{
public:
    Square(float z, voInterleavedArrayType format) : faces_(0, getValuesPerVertex(format), 0)
    {
        std::vector<float> records;
        for (const auto& [x, y] : {std::pair{0.f, 0.f}, {8.f, 0.f}, {8.f, 8.f}, {0.f, 8.f}})
            for (int times = getValuesPerVertex(format) / 3; times > 0; --times)
                records.insert(records.end(), {x, y, z});
        faces_.appendPoly(records.data(), 4);
    }
    voIndexedFaceSet* faces() { return &faces_; }
    operator voIndexedFaceSet***() { return bricks_; }

private:
    voIndexedFaceSet faces_;
    voIndexedFaceSet* samples_[1] = {&faces_};
    voIndexedFaceSet** bricks_[1] = {samples_};
};

/// Opacity a of n slices, each of light v, over black by GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA.
double stacked(double v, double a, int n)
{
    return v * (1 - std::pow(1 - a, n));
}

double areaOf(voIndexedFaceSet& faces)
{
    double area = 0;
    for (const auto& p : polygonsOf(faces))
        for (std::size_t i = 2; i < p.size(); ++i)
            area += 0.5 * ((p[i - 1][0] - p[0][0]) * (p[i][1] - p[0][1]) -
                           (p[i][0] - p[0][0]) * (p[i - 1][1] - p[0][1]));
    return std::fabs(area);
}

// --- chapter 3 ---

/// Every brick of every stack holds the ramp, `copies` bytes a voxel, and zeros outside the volume.
void expectRamp(voBrickSetCollection& volume, int copies)
{
    voBrickSetCollectionIterator sets(&volume);
    while (voBrickSet* set = sets()) {
        voBrickSetIterator bricks(set);
        while (voBrick* brick = bricks()) {
            int xO, yO, zO, xB, yB, zB;
            brick->getBrickSizes(xO, yO, zO, xB, yB, zB);
            std::vector<unsigned char> expected(static_cast<std::size_t>(xB * yB * zB));
            myReadBrickIfl(const_cast<char*>("ramp"), expected.data(), xO, yO, zO, xB, yB, zB, kSize, kSize,
                           kSize);
            const auto* voxels = static_cast<const unsigned char*>(brick->getDataPtr());
            for (std::size_t i = 0; i < expected.size(); ++i)
                for (int copy = 0; copy < copies; ++copy)
                    ASSERT_EQ(*voxels++, expected[i]);
        }
    }
}

TEST_P(ChaptersGL, chapter3ReadsAVolumeInBricksAndStacks)
{
    for (const voInterpolationType type : {Interpolation::_2D, Interpolation::_3D})
        for (const voExternalFormatType wanted : {External::DEFAULT, External::LUMINANCE_ALPHA}) {
            voBrickSetCollection* volume = GetParam().readVolume(ramp_, kSize, 5, type, wanted);
            EXPECT_EQ(volume->getBrickSetCount(), type == Interpolation::_2D ? 3 : 1);
            expectRamp(*volume, wanted == External::DEFAULT ? 1 : 2);
            GetParam().cleanUp(volume, GetParam().makeCube(kSize));
        }
}

TEST_P(ChaptersGL, chapter3ConvertsThroughABufferAsInPlace)
{
    const auto volume = byteVolume(kSize, 5, Interpolation::_3D);
    for (const auto convert : {GetParam().convertThroughBuffer, GetParam().convertInPlace}) {
        voBrickSetIterator bricks(volume->getCurrentBrickSet());
        while (voBrick* brick = bricks())
            convert(ramp_, brick);
        expectRamp(*volume, 1);
    }
}

TEST_P(ChaptersGL, chapter3LendsMemoryAndReadsRawImages)
{
    const auto volume = byteVolume(kSize, kSize, Interpolation::_3D, 0);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(0);
    std::vector<unsigned char> memory(kSize * kSize * kSize, 7);
    GetParam().lendMemory(brick, memory.data());
    EXPECT_EQ(brick->getDataPtr(), memory.data());
    char* names[] = {ramp_};
    EXPECT_EQ(GetParam().readRaw(names, brick, kSize), 0);
    expectRamp(*volume, 1);
    EXPECT_EQ(memory.front(), 7);
}

TEST_P(ChaptersGL, chapter3DrawsAConstantVolumeAsItsClosedForm)
{
    char constant[] = "constant 102";
    for (const voInterpolationType type : {Interpolation::_2D, Interpolation::_3D})
        for (const int brickSize : {kSize, 5}) {
            voBrickSetCollection* volume =
                GetParam().readVolume(constant, kSize, brickSize, type, External::DEFAULT);
            voIndexedTetraSet* cube = GetParam().makeCube(kSize);
            clear();
            gl().Color4f(1, 1, 1, 0.5f);
            EXPECT_EQ(GetParam().drawVolume(cube, volume, Format::V3F, 20, 1), kSize);
            expectInside(stacked(0.4, 0.4 * 0.5, kSize));
            clear();
            // A period that the bound on the samples makes longer: 6 planes of a texture; of a stack every
            // other slice.
            const int samples = type == Interpolation::_3D ? 6 : 4;
            EXPECT_EQ(GetParam().drawVolume(cube, volume, Format::V3F, 6, 1), samples);
            expectInside(stacked(0.4, 0.4 * 0.5, samples));
            GetParam().cleanUp(volume, cube);
        }
}

TEST_P(ChaptersGL, chapter3TablesClassifyBeforeAndAfterInterpolation)
{
    char constant[] = "constant 204";
    voBrickSetCollection* volume =
        GetParam().readVolume(constant, kSize, kSize, Interpolation::_3D, External::DEFAULT);
    voIndexedTetraSet* cube = GetParam().makeCube(kSize);
    const auto expectDrawn = [&](double entry) {
        clear();
        gl().Color4f(1, 1, 1, 1);
        GetParam().drawVolume(cube, volume, Format::V3F, 20, 1);
        expectInside(stacked(entry, entry, kSize));
    };
    std::vector<float> entries(2 * 256);
    std::unique_ptr<voLookupTable> table(GetParam().enableTable(entries.data()));
    expectDrawn(0.5 * 204 / 256);
    GetParam().rampInstead(table.get());
    expectDrawn((204 - 170) / 50.0);
    table.reset();
    expectDrawn(0.8);
    for (const voLookupTableType type :
         {voLookupTableTypeScope::PRE_INTERPOLATION, voLookupTableTypeScope::POST_INTERPOLATION}) {
        std::fill(entries.begin(), entries.end(), 0.25f);
        table.reset(GetParam().suggestedTable(volume, entries.data(), type));
        EXPECT_EQ(table->getType(), type);
        expectDrawn(0.25);
        table.reset();
    }
    GetParam().cleanUp(volume, cube);
}

TEST_P(ChaptersGL, chapter3TellsErrorsAfterTheCallAndThroughAHandler)
{
    const std::string asked = GetParam().testForError(), handled = GetParam().handleError();
    EXPECT_EQ(asked.find("voError "), 0u);
    EXPECT_EQ(handled.find("OpenGL Volumizer error 1: "), 0u);
    EXPECT_EQ(asked.substr(8), handled.substr(26));
    EXPECT_GT(asked.size(), 20u);
}

// --- chapter 6 ---

TEST_P(ChaptersGL, chapter6FaceSetsShareVertices)
{
    char printed[300];
    int vertexCounts[3];
    GetParam().useFaceSets(printed, vertexCounts);
    EXPECT_STREQ(printed, "(100.000000 100.000000 100.000000) (200.000000 100.000000 200.000000) "
                          "(200.000000 100.000000 300.000000) \n");
    EXPECT_EQ(vertexCounts[0], 30);
    EXPECT_EQ(vertexCounts[1], 30);
    EXPECT_EQ(vertexCounts[2], 0);
}

TEST_P(ChaptersGL, chapter6ColoursAreCutWithTheirTetrahedra)
{
    const std::unique_ptr<voIndexedTetraSet> cube(GetParam().makeColouredCube());
    const auto volume = byteVolume(128, 128, Interpolation::_3D, 0);
    FaceSets faces(1, 4, 6);
    int samples;
    float* noPeriod = nullptr;
    ASSERT_EQ(voGeometryActions::polygonize(cube.get(), volume->getCurrentBrickSet(), Format::C3F_V3F,
                                            identity_, projection_, voSamplingModeScope::DEFAULT,
                                            voSamplingSpaceScope::OBJECT, noPeriod, 4, samples, faces),
              0);
    ASSERT_EQ(samples, 4);
    // On the edge from (0, 0, 0), red, to (0, 0, 128), magenta.
    int onTheEdge = 0;
    for (int s = 0; s < samples; ++s)
        for (voIndexedFaceSetIterator next(&faces.at(0, s)); !next.doneP(); next.nextPrimitive())
            while (const float* record = next.nextVertex())
                if (record[3] == 0 && record[4] == 0) {
                    ++onTheEdge;
                    EXPECT_EQ(record[0], 1);
                    EXPECT_EQ(record[1], 0);
                    EXPECT_NEAR(record[2], record[5] / 128, 1e-6);
                }
    EXPECT_GE(onTheEdge, samples);
}

TEST_P(ChaptersGL, chapter6CrossSectionsHaveTheirAreas)
{
    for (const int brickSize : {kSize, 5, 3}) {
        const auto volume = byteVolume(kSize, brickSize);
        float plane, polygon;
        GetParam().crossSections(volume->getCurrentBrickSet(), 3.3f, &plane, &polygon);
        EXPECT_NEAR(plane, 7 * 7, 1e-4);
        EXPECT_NEAR(polygon, 6 * 6, 1e-4);
    }
}

TEST_P(ChaptersGL, chapter6PicksVoxelsNearestFirst)
{
    voBrickSetCollection* volume =
        GetParam().readVolume(ramp_, kSize, 5, Interpolation::_3D, External::DEFAULT);
    voIndexedTetraSet* cube = GetParam().makeCube(kSize);
    voBrickSet* set = volume->getCurrentBrickSet();
    std::vector<unsigned char> voxels(256);
    std::vector<float> positions(3 * 256);
    ASSERT_EQ(GetParam().pickVoxels(2, 3, kSize, cube, set, nullptr, voxels.data(), positions.data()), kSize);
    for (std::size_t i = 0; i < kSize; ++i) {
        EXPECT_EQ(voxels[i], rampVoxel(2, 3, 7 - static_cast<int>(i)));
        EXPECT_NEAR(positions[3 * i], 2.5, 1e-4);
        EXPECT_NEAR(positions[3 * i + 1], 3.5, 1e-4);
        EXPECT_NEAR(positions[3 * i + 2], 7.5 - static_cast<double>(i), 1e-4);
    }
    // The clip box of the first brick is [0.5, 4.5], both ends included for a brick by itself.
    ASSERT_EQ(
        GetParam().pickVoxels(2, 3, kSize, cube, set, set->getBrick(0), voxels.data(), positions.data()), 5);
    EXPECT_EQ(voxels[0], rampVoxel(2, 3, 4));
    EXPECT_EQ(voxels[4], rampVoxel(2, 3, 0));
    EXPECT_EQ(GetParam().pickVoxels(2, 30, kSize, cube, set, nullptr, voxels.data(), positions.data()), 0);
    expectBadValue("pixel");
    GetParam().cleanUp(volume, cube);
}

TEST_P(ChaptersGL, chapter6FindsTheCamera)
{
    double eye[3] = {5, 6, 7}, direction[4], alone[3];
    GetParam().findCamera(identity_, projection_, eye, direction, alone);
    EXPECT_EQ(eye[0], 5);
    EXPECT_EQ(direction[3], 0);
    Matrix perspective = frustum(0.5, 1, 10), away = translation(-1, -2, -3);
    for (const double* found : {direction, alone})
        EXPECT_NEAR(found[2], -1, 1e-9);
    GetParam().findCamera(away, perspective, eye, direction, alone);
    EXPECT_NEAR(eye[0], 1, 1e-9);
    EXPECT_NEAR(eye[1], 2, 1e-9);
    EXPECT_NEAR(eye[2], 3, 1e-9);
    EXPECT_NE(direction[3], 0);
}

// --- chapter 7 ---

TEST_P(ChaptersGL, chapter7InitializesVoxelsToTheWholeRange)
{
    fileSize = 4;
    const auto volume = byteVolume(4, 4, Interpolation::_3D, 0);
    GetParam().initializeVoxels(ramp_, volume->getCurrentBrickSet(), 0, 219);
    const auto* voxel =
        static_cast<const unsigned char*>(volume->getCurrentBrickSet()->getBrick(0)->getDataPtr());
    for (int z = 0; z < 4; ++z)
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 4; ++x)
                EXPECT_EQ(*voxel++, std::lround(rampVoxel(x, y, z) * 255 / 219.0));
}

/// The picture is slice z of the ramp, as light.
#define EXPECT_SLICE(z)                                                                                      \
    for (int y = 0; y < kSize; ++y)                                                                          \
        for (int x = 0; x < kSize; ++x)                                                                      \
    EXPECT_NEAR(red(x, y), rampVoxel(x, y, z) / 255.0, 2e-4) << x << ' ' << y

TEST_P(ChaptersGL, chapter7GeneratedAndRewrittenCoordinatesShowTheSameVoxels)
{
    voBrickSetCollection* volume =
        GetParam().readVolume(ramp_, kSize, kSize, Interpolation::_3D, External::DEFAULT);
    gl().Color4f(1, 1, 1, 1);
    Square plain(2.5f, Format::V3F), withVoxels(2.5f, Format::T3F_V3F);
    GetParam().drawGenerated(volume, plain, 1, Format::V3F);
    EXPECT_SLICE(2);
    clear();
    GetParam().drawGenerated(volume, withVoxels, 1, Format::T3F_V3F);
    EXPECT_SLICE(2);
    EXPECT_EQ((*withVoxels.faces())[3][0],
              1.0f); // entry 3 of the indices is the third corner, now in the texture
    GetParam().cleanUp(volume, GetParam().makeCube(kSize));
}

TEST_P(ChaptersGL, chapter7LoadSendsVoxelsThatBindWouldNot)
{
    voBrickSetCollection* volume =
        GetParam().readVolume(ramp_, kSize, kSize, Interpolation::_3D, External::DEFAULT);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(0);
    gl().Color4f(1, 1, 1, 1);
    Square square(2.5f, Format::V3F);
    std::memset(brick->getDataPtr(), 51, kSize * kSize * kSize);
    GetParam().drawGenerated(volume, square, 1, Format::V3F);
    EXPECT_SLICE(2);
    GetParam().loadAndBind(brick);
    clear();
    GetParam().drawGenerated(volume, square, 1, Format::V3F);
    expectInside(0.2);
    GetParam().cleanUp(volume, GetParam().makeCube(kSize));
}

TEST_P(ChaptersGL, chapter7BrickSizesAreOriginAndSize)
{
    voBrick brick(voInternalFormatTypeScope::INTENSITY8_EXT, External::LUMINANCE,
                  voDataTypeScope::UNSIGNED_BYTE);
    int six[6];
    float position[3], size[3];
    GetParam().brickSizes(&brick, six, position, size);
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(six[i], i + 1);
        EXPECT_EQ(i < 3 ? position[i] : size[i - 3], static_cast<float>(i + 1));
    }
    int suggested[3];
    GetParam().suggestBrickSizes(100, 50, 25, suggested);
    EXPECT_EQ(suggested[0], 100);
    EXPECT_EQ(suggested[1], 50);
    EXPECT_EQ(suggested[2], 25);
}

TEST_P(ChaptersGL, chapter7OutlineIsDrawnInTheCurrentColour)
{
    const auto volume = byteVolume(kSize, kSize, Interpolation::_3D, 0);
    gl().Color4f(0.75f, 0, 0, 1);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(0);
    brick->setBrickSizes(1.5f, 1.5f, 0, 5, 5, 5);
    GetParam().drawOutline(brick);
    EXPECT_EQ(red(1, 4), 0.75f);
    EXPECT_EQ(red(4, 6), 0.75f);
    EXPECT_EQ(red(4, 4), 0.0f);
}

TEST_P(ChaptersGL, chapter7And8SelectTheStackMostAcrossTheView)
{
    for (const auto select : {GetParam().selectStack, GetParam().selectClosest}) {
        const auto stacks = byteVolume(kSize, kSize, Interpolation::_2D);
        Matrix fromAbove = rotation(90, 1, 0, 0), fromAside = rotation(90, 0, 1, 0);
        select(stacks.get(), fromAbove, projection_);
        EXPECT_EQ(stacks->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::XZ);
        select(stacks.get(), fromAside, projection_);
        EXPECT_EQ(stacks->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::YZ);
        select(stacks.get(), identity_, projection_);
        EXPECT_EQ(stacks->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::XY);
        const auto texture = byteVolume(kSize, kSize, Interpolation::_3D);
        select(texture.get(), fromAside, projection_);
        EXPECT_EQ(texture->getCurrentBrickSet()->getOrientation(), voPlaneOrientationScope::UNSPECIFIED);
    }
}

TEST_P(ChaptersGL, chapter7TextureMatrixStandsForRewrittenCoordinates)
{
    voBrickSetCollection* volume =
        GetParam().readVolume(ramp_, kSize, kSize, Interpolation::_3D, External::DEFAULT);
    gl().Color4f(1, 1, 1, 1);
    Square square(2.5f, Format::T3F_V3F);
    GetParam().drawThroughTextureMatrix(volume->getCurrentBrickSet()->getBrick(0), square.faces());
    EXPECT_SLICE(2);
    EXPECT_EQ((*square.faces())[3][0], 8.0f); // still in voxels
    GetParam().cleanUp(volume, GetParam().makeCube(kSize));
}

TEST_P(ChaptersGL, chapter7InterleavesBricksOfOneSizeAndFormat)
{
    voBrickSetCollection volume(8, 4, 4, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 0,
                                voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT, External::LUMINANCE_ALPHA,
                                voDataTypeScope::UNSIGNED_BYTE, Interpolation::_3D);
    voBrickSet* set = volume.getCurrentBrickSet();
    voAppearanceActions::dataAlloc(set);
    int before, after;
    EXPECT_EQ(GetParam().interleave(set->getBrick(0), set->getBrick(1), &before, &after), 0);
    EXPECT_EQ(before, VO_FALSE);
    EXPECT_EQ(after, VO_TRUE);
}

// --- chapter 8 ---

TEST_P(ChaptersGL, chapter8DrawsByAProcedureOfItsOwn)
{
    char constant[] = "constant 102";
    voBrickSetCollection* volume =
        GetParam().readVolume(constant, kSize, kSize, Interpolation::_3D, External::DEFAULT);
    voIndexedTetraSet* cube = GetParam().makeCube(kSize);
    gl().Color4f(1, 1, 1, 0.5f);
    GetParam().customDraw(cube, volume);
    expectInside(stacked(0.4, 0.4 * 0.5, kSize));
    GetParam().cleanUp(volume, cube);
}

TEST_P(ChaptersGL, chapter8VisitsBricksFromBackToFront)
{
    voBrickSetCollection volume(4, 4, 12, 4, 4, 4, voPartialBrickTypeScope::TRUNCATE, 0,
                                voInternalFormatTypeScope::DEFAULT, External::DEFAULT,
                                voDataTypeScope::DEFAULT, Interpolation::_3D);
    EXPECT_EQ(GetParam().visitInOrder(&volume, identity_, projection_), 1 * 0 + 2 * 4 + 3 * 8);
    Matrix fromBehind = rotation(180, 0, 1, 0);
    EXPECT_EQ(GetParam().visitInOrder(&volume, fromBehind, projection_), 1 * 8 + 2 * 4 + 3 * 0);
}

TEST_P(ChaptersGL, chapter8SlicingAndClippingEqualsTenHalfSpaces)
{
    const auto volume = byteVolume(4, 4, Interpolation::_3D, 0);
    voBrick* brick = volume->getCurrentBrickSet()->getBrick(0);
    for (const float edge : {20.f, 6.f, 3.f}) {
        const float z = 2.2f;
        float tetra[4][3] = {{0, 0, 0}, {edge, 0, 0}, {0, edge, 0}, {0, 0, edge}}, plane[4] = {0, 0, 1, -z};
        voIndexedFaceSet sliced(0, 3, 0), clipped(0, 3, 0);
        GetParam().sliceAndClip(plane, tetra, brick, &sliced);

        float planes[] = {1,  0, 0, 0, 0, 1,  0, 0, 0, 0, 1,  0, -1, -1, -1, edge, // the tetrahedron
                          1,  0, 0, 0, 0, 1,  0, 0, 0, 0, 1,  0,                   // the brick
                          -1, 0, 0, 4, 0, -1, 0, 4, 0, 0, -1, 4};
        float corners[] = {-50, -50, z, 50, -50, z, 50, 50, z, -50, 50, z};
        voVertexData square(4, 3, corners);
        GetParam().clipToTenPlanes(&square, planes, &clipped);

        // The triangle x + y <= edge - z in the square [0, 4]^2.
        const double leg = edge - z, cut = std::max(leg - 4, 0.0);
        const double area = leg >= 8 ? 16 : (leg * leg - 2 * cut * cut) / 2;
        EXPECT_NEAR(areaOf(sliced), area, 1e-4);
        EXPECT_NEAR(areaOf(clipped), area, 1e-4);
    }
}

TEST_P(ChaptersGL, chapter8ModeHoldsForOneDraw)
{
    voIndexedFaceSet square(0, 3, 0);
    float corners[] = {1.5f, 1.5f, 0, 6.5f, 1.5f, 0, 6.5f, 6.5f, 0, 1.5f, 6.5f, 0};
    square.appendPoly(corners, 4);
    gl().Color4f(1, 1, 1, 1);
    GetParam().drawWithMode(&square, GL_LINE);
    EXPECT_EQ(red(4, 4), 0);
    EXPECT_EQ(red(1, 4), 1);
    GetParam().drawWithMode(&square, GL_FILL);
    EXPECT_EQ(red(4, 4), 1);
}

TEST_P(ChaptersGL, chapter8ProjectedAreaCountsPixels)
{
    voIndexedFaceSet square(0, 3, 0);
    float corners[] = {1, 2, 0, 5, 2, 0, 5, 4, 0, 1, 4, 0};
    square.appendPoly(corners, 4);
    GLint viewport[4] = {0, 0, kSize, kSize};
    EXPECT_NEAR(GetParam().projectedArea(&square, identity_, projection_, viewport), 4 * 2, 1e-4);
}

} // namespace
