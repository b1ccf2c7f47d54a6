// A program's own bricks and tetrahedra in styles: opacities by closed forms, bricks, formats, and what is
// refused.

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include <vo/Error.h>
#include <vo/x3d/StyledVolume.h>

namespace {

constexpr int kSize = 20;
/// Of 255, the value of all voxels.
constexpr int kValue = 51;

/// Voxels of one value, or rising along x.
class Bricks
{
public:
    explicit Bricks(int brickSize, bool isRamp = false)
        : set_(8, 4, 4, brickSize, brickSize, brickSize, voPartialBrickTypeScope::AUGMENT, 1,
               voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
               voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D)
    {
        voBrickSet* const bricks = set_.getCurrentBrickSet();
        memory_.resize(std::size_t(bricks->getBrickCount()));
        for (int i = 0; i < bricks->getBrickCount(); ++i) {
            voBrick* const brick = bricks->getBrick(i);
            int o[3], s[3];
            brick->getBrickSizes(o[0], o[1], o[2], s[0], s[1], s[2]);
            auto& memory = memory_[std::size_t(i)];
            for (int at = 0; at < s[0] * s[1] * s[2]; ++at)
                memory.push_back(static_cast<unsigned char>(isRamp ? 30 * (o[0] + at % s[0]) : kValue));
            brick->setDataPtr(memory.data());
        }
    }
    operator voBrickSetCollection*() { return &set_; }
    void fill(unsigned char value)
    {
        for (auto& memory : memory_)
            std::fill(memory.begin(), memory.end(), value);
    }

private:
    std::vector<std::vector<unsigned char>> memory_;
    voBrickSetCollection set_;
};

/// Looks along -z at a square of `side` about (x, y), orthographic.
std::vector<float> picture(voX3DStyledVolume& volume, double x, double y, double side)
{
    const GLdouble model[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x, -y, -50, 1};
    const GLdouble projection[16] = {2 / side, 0, 0, 0, 0, 2 / side, 0, 0, 0, 0, -0.02, 0, 0, 0, -1, 1};
    std::vector<float> rgba(4 * kSize * kSize);
    EXPECT_TRUE(volume.picture(model, projection, kSize, kSize, rgba.data())) << voError::getErrorString();
    return rgba;
}

float opacity(const std::vector<float>& rgba, int x, int y)
{
    return rgba[std::size_t(4 * (y * kSize + x) + 3)];
}

/// Of so many voxels behind each other.
double opacityOf(double voxels, double value = kValue)
{
    return 1 - std::pow(1 - value / 255, voxels);
}

TEST(StyledVolume, theWholeVolumeIsOpaqueByItsDepth)
{
    Bricks bricks(8);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), bricks);
    const auto seen = picture(volume, 4, 2, 10);
    EXPECT_NEAR(opacity(seen, 10, 10), opacityOf(4), 1e-5);
    EXPECT_NEAR(opacity(seen, 3, 7), opacityOf(4), 1e-5) << "x from 0 to 8";
    EXPECT_EQ(opacity(seen, 1, 10), 0);
    EXPECT_EQ(opacity(seen, 10, 4), 0) << "y from 0 to 4";
    bricks.fill(102);
    volume.update();
    EXPECT_NEAR(opacity(picture(volume, 4, 2, 10), 10, 10), opacityOf(4, 102), 1e-5);
}

TEST(StyledVolume, bricksMakeNoDifference)
{
    Bricks one(8, true), many(3, true);
    voX3DScene scene;
    const voX3DNode style = scene.createNode("CartoonVolumeStyle");
    voX3DStyledVolume first(scene, style, one), second(scene, style, many);
    EXPECT_EQ(picture(first, 4, 2, 10), picture(second, 4, 2, 10));
}

/// The box from (0, 0, 0) to (8, 4, 4) as five tetrahedra; positions are voxels times `scale`.
struct Box
{
    explicit Box(float scale)
    {
        for (int corner = 0; corner < 8; ++corner) {
            const float at[3] = {corner & 1 ? 8.0f : 0.0f, corner & 2 ? 4.0f : 0.0f,
                                 corner & 4 ? 4.0f : 0.0f};
            for (const float each : at)
                records.push_back(each);
            for (const float each : at)
                records.push_back(scale * each);
        }
    }
    std::vector<float> records;
    int indices[20] = {0, 3, 5, 6, 1, 3, 5, 0, 2, 3, 0, 6, 4, 5, 6, 0, 7, 3, 6, 5};
};

TEST(StyledVolume, tetrahedraWithVoxelCoordinatesAreOpaqueByTheirVoxels)
{
    Bricks bricks(8);
    Box box(2);
    voIndexedTetraSet tetras(box.records.data(), 8, 6, box.indices, 20);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), bricks, &tetras, voInterleavedArrayTypeScope::T3F_V3F);
    const auto seen = picture(volume, 8, 4, 20);
    EXPECT_NEAR(opacity(seen, 10, 10), opacityOf(4), 0.02);
    EXPECT_NEAR(opacity(seen, 16, 12), opacityOf(4), 0.02);
    EXPECT_EQ(opacity(seen, 1, 10), 0);
}

TEST(StyledVolume, flatMatricesMakeSheetsOfTheSameOpacity)
{
    Bricks bricks(8);
    voX3DScene scene;
    voX3DStyledVolume volume(scene, voX3DNode(), bricks);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto seen = [&](double flat) {
        // The box from 0 to 8, 4, 4, flat along z and turned about x.
        const GLdouble model[16] = {1, 0, 0, 0, 0, c, s, 0, 0, -s * flat, c * flat, 0, -4, -c * 2, -50, 1};
        const GLdouble projection[16] = {0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, -0.02, 0, 0, 0, -1, 1};
        std::vector<float> rgba(4 * kSize * kSize);
        EXPECT_TRUE(volume.picture(model, projection, kSize, kSize, rgba.data()))
            << voError::getErrorString();
        return opacity(rgba, 10, 10);
    };
    // 4 voxels of a unit of length that stays 1 in the volume's space; the way in it is along z.
    for (const double flat : {1e-3, 1e-4}) {
        const double along = std::hypot(s * flat, c) / c;
        EXPECT_NEAR(seen(flat), opacityOf(4 * along), 0.02) << flat;
    }
    EXPECT_EQ(scene.getMessageCount(), 0);
    seen(1e-7);
    seen(1e-7);
    EXPECT_EQ(scene.getMessageCount(), 1) << "too thin for any planes, told once";
    voError::getErrorNumber();
    volume.setSampling(1000);
    EXPECT_EQ(voError::getErrorNumber(), voError::BAD_VALUE);
}

TEST(StyledVolume, aStyleThatIsChangedIsSeen)
{
    Bricks bricks(8);
    voX3DScene scene;
    voX3DNode style = scene.createNode("OpacityMapVolumeStyle");
    voX3DStyledVolume volume(scene, style, bricks);
    EXPECT_NEAR(opacity(picture(volume, 4, 2, 10), 10, 10), opacityOf(4), 1e-5);
    style.setInt("enabled", 0);
    EXPECT_EQ(opacity(picture(volume, 4, 2, 10), 10, 10), 0);
}

TEST(StyledVolume, whatCannotBeDrawnIsRefused)
{
    Bricks bricks(8);
    voX3DScene scene;
    voError::getErrorNumber();
    const auto refused = [] { return voError::getErrorNumber() == voError::BAD_VALUE; };
    voX3DStyledVolume volume(scene, scene.createNode("Group"), bricks);
    EXPECT_TRUE(refused()) << "no style";
    const GLdouble identity[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, zero[16] = {};
    float rgba[4];
    EXPECT_FALSE(volume.picture(identity, zero, 1, 1, rgba));
    EXPECT_TRUE(refused());
    EXPECT_FALSE(volume.picture(NULL, identity, 1, 1, rgba));
    EXPECT_TRUE(refused());
    EXPECT_FALSE(volume.picture(identity, identity, 0, 1, rgba));
    EXPECT_TRUE(refused());
    Box box(1);
    voIndexedTetraSet narrow(box.records.data(), 8, 3, box.indices, 20);
    voX3DStyledVolume wrong(scene, voX3DNode(), bricks, &narrow, voInterleavedArrayTypeScope::T3F_V3F);
    EXPECT_TRUE(refused()) << "three values a record";
    EXPECT_FALSE(wrong.picture(identity, identity, 1, 1, rgba));
    EXPECT_TRUE(refused());
    voX3DStyledVolume none(scene, voX3DNode(), NULL);
    EXPECT_TRUE(refused());
    volume.addLight(0, 0, 0, 1);
    EXPECT_TRUE(refused());
}

} // namespace
