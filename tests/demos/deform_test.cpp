// voglDeform and voglFan against float64 pictures of the volume resampled by the inverse of each warp.
#include "run_program.h"

#include "support/compare.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <numbers>
#include <optional>

namespace {

using namespace vo::test;
using glm::dvec3;

constexpr int kWidth = 112, kHeight = 96;
const vo::VoxelSize kSize{30, 26, 34};
const dvec3 kVoxels(30, 26, 34), kMiddle = 0.5 * kVoxels;
const Angles kAngles{-20, 35};
constexpr double kDegree = std::numbers::pi / 180;
using Rgba = std::array<double, 4>;
using Map = std::function<dvec3(const dvec3&)>;

/// A warp and its inverse, from the volume's middle in scaled units.
struct Warp
{
    Map forward, inverse;
};

dvec3 turnedAboutZ(const dvec3& p, double angle)
{
    return {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y,
            p.z};
}

Warp twist(double degrees, double height)
{
    const auto by = [=](double sign) -> Map {
        return [=](const dvec3& p) { return turnedAboutZ(p, sign * degrees * kDegree * p.z / height); };
    };
    return {by(1), by(-1)};
}

/// The z axis becomes an arc; its ends go towards x.
Warp bend(double degrees, double height)
{
    const double radius = height / (degrees * kDegree);
    return {[=](const dvec3& p) {
                const double a = p.z / radius;
                return dvec3(radius - (radius - p.x) * std::cos(a), p.y, (radius - p.x) * std::sin(a));
            },
            [=](const dvec3& p) {
                const double side = radius < 0 ? -1 : 1; // of the arc's centre
                return dvec3(radius - side * std::hypot(radius - p.x, p.z), p.y,
                             radius * std::atan2(side * p.z, side * (radius - p.x)));
            }};
}

Warp taper(double factor, double height)
{
    const auto scale = [=](double z) { return 1 + (factor - 1) * (z / height + 0.5); };
    return {[=](const dvec3& p) { return dvec3(p.x * scale(p.z), p.y * scale(p.z), p.z); },
            [=](const dvec3& p) { return dvec3(p.x / scale(p.z), p.y / scale(p.z), p.z); }};
}

/// Depth along y from r0 to r1, directions along x, and swung along z or not.
Warp fan(double degrees, double r0, double r1, double elevation, const dvec3& size)
{
    return {[=](const dvec3& p) {
                const double r = r0 + (r1 - r0) * (p.y / size.y + 0.5);
                const double a = degrees * kDegree * p.x / size.x, e = elevation * kDegree * p.z / size.z;
                return dvec3(r * std::sin(a), r * std::cos(a) * std::cos(e),
                             elevation == 0 ? p.z : r * std::cos(a) * std::sin(e));
            },
            [=](const dvec3& p) {
                const double r = elevation == 0 ? std::hypot(p.x, p.y) : glm::length(p);
                const double e = elevation == 0 ? 0 : std::atan2(p.z, p.y);
                const double a = elevation == 0 ? std::atan2(p.x, p.y) : std::asin(p.x / r);
                return dvec3(a / (degrees * kDegree) * size.x, ((r - r0) / (r1 - r0) - 0.5) * size.y,
                             elevation == 0 ? p.z : e / (elevation * kDegree) * size.z);
            }};
}

Warp after(const Warp& first, const Warp& second)
{
    return {[=](const dvec3& p) { return second.forward(first.forward(p)); },
            [=](const dvec3& p) { return first.inverse(second.inverse(p)); }};
}

/// Moved and scaled so that the lattice's extent has its middle at the origin, and its farthest vertex lies
/// on the sphere round the volume.
Warp fitted(const Warp& warp, const std::array<int, 3>& boxes, const dvec3& size)
{
    std::vector<dvec3> vertices;
    for (int k = 0; k <= boxes[2]; ++k)
        for (int j = 0; j <= boxes[1]; ++j)
            for (int i = 0; i <= boxes[0]; ++i)
                vertices.push_back(
                    warp.forward((dvec3(i, j, k) / dvec3(boxes[0], boxes[1], boxes[2]) - 0.5) * size));
    dvec3 least(HUGE_VAL), most(-HUGE_VAL);
    for (const dvec3& v : vertices) {
        least = glm::min(least, v);
        most = glm::max(most, v);
    }
    const dvec3 from = 0.5 * (least + most);
    double farthest = 0;
    for (const dvec3& v : vertices)
        farthest = std::max(farthest, glm::distance(v, from));
    const double scale = 0.5 * glm::length(size) / farthest;
    return after(warp, {[=](const dvec3& p) { return scale * (p - from); },
                        [=](const dvec3& p) { return p / scale + from; }});
}

/// Vectors at the centres of a grid over the volume, in scaled units: smooth, and small enough to be undone.
struct VectorField
{
    static constexpr int kCells = 9;

    explicit VectorField(const dvec3& volume) : size(volume)
    {
        for (int k = 0; k < kCells; ++k)
            for (int j = 0; j < kCells; ++j)
                for (int i = 0; i < kCells; ++i)
                    vectors.push_back(smooth((dvec3(i, j, k) + 0.5) / double(kCells)));
    }
    static dvec3 smooth(const dvec3& part)
    {
        return {2.5 * std::sin(5 * part.y + 1), 2 * std::sin(4 * part.z - 3 * part.x),
                2.2 * std::cos(5 * part.x)};
    }
    dvec3 size;
    std::vector<dvec3> vectors;

    /// Trilinear between centres, constant beyond the outermost.
    dvec3 at(const dvec3& p) const
    {
        const dvec3 cell = glm::clamp((p / size + 0.5) * double(kCells) - 0.5, dvec3(0), dvec3(kCells - 1));
        const glm::ivec3 first(glm::min(glm::floor(cell), dvec3(kCells - 2)));
        dvec3 sum(0);
        for (int corner = 0; corner < 8; ++corner) {
            const glm::ivec3 at = first + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
            const dvec3 hat = 1.0 - glm::abs(cell - dvec3(at));
            sum += hat.x * hat.y * hat.z * vectors[std::size_t((at.z * kCells + at.y) * kCells + at.x)];
        }
        return sum;
    }
    Warp warp() const
    {
        const VectorField field = *this;
        return {[=](const dvec3& p) { return p + field.at(p); },
                [=](const dvec3& p) {
                    dvec3 q = p;
                    for (int i = 0; i < 40; ++i)
                        q = p - field.at(q);
                    return q;
                }};
    }
    void write(const std::filesystem::path& path, const dvec3& factor) const
    {
        std::ofstream file(path, std::ios::binary);
        file << "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 9 9 9\nendian: little\nencoding: raw\n\n";
        for (const dvec3& vector : vectors)
            for (int part = 0; part < 3; ++part) {
                const float number = float(vector[part] / factor[part]);
                file.write(reinterpret_cast<const char*>(&number), sizeof number);
            }
    }
};

class Deform : public testing::Test
{
protected:
    Deform()
    {
        vo::writeBytes(folder / "soft.tif", kSize.x, kSize.y, kSize.z, [this](int x, int y, int z) {
            return int(std::lround(255 * double(field.at(x, y, z))));
        });
        table = vo::writeSmoothTable(folder / "smooth.lut",
                                     [](double v) { return 0.12 * std::clamp(4 * v - 0.4, 0.0, 1.0); });
    }

    std::vector<float> draw(const std::string& program, const std::string& words)
    {
        return vo::drawnPicture(folder, program,
                                "soft.tif -lutFile smooth.lut -size 112 96 -view -20 35 " + words)
            .pixels();
    }

    Scene scene(const dvec3& scale = dvec3(1), double degrees = 0) const
    {
        Scene s;
        s.volume = &field;
        s.width = kWidth;
        s.height = kHeight;
        s.overlap = 1;
        s.table = table;
        s.classification = Classification::postInterpolation;
        s.period = 1.0 / scale;
        s.view = degrees > 0 ? perspectiveView(kAngles, kSize, kWidth, kHeight, degrees, scale)
                             : orthographicView(kAngles, kSize, kWidth, kHeight, scale);
        return s;
    }

    /// The volume resampled by the inverse warp, on the planes of a lattice of so many boxes.
    Picture resampled(const Warp& warp, const std::array<int, 3>& boxes, const dvec3& scale = dvec3(1),
                      double degrees = 0) const
    {
        const Scene volume = scene(scale, degrees);
        Scene warped = volume;
        for (int k = 0; k <= boxes[2]; ++k)
            for (int j = 0; j <= boxes[1]; ++j)
                for (int i = 0; i <= boxes[0]; ++i) {
                    const dvec3 part = dvec3(i, j, k) / dvec3(boxes[0], boxes[1], boxes[2]);
                    const dvec3 place = warp.forward((part - 0.5) * kVoxels * scale) / scale + kMiddle;
                    warped.geometry.push_back({place, place, place, place});
                }
        warped.sampleAt = [&](const dvec3& point) -> std::optional<Rgba> {
            const dvec3 voxel = warp.inverse((point - kMiddle) * scale) / scale + kMiddle;
            if (!glm::all(glm::greaterThan(voxel, dvec3(0.5))) ||
                !glm::all(glm::lessThan(voxel, kVoxels - 0.5)))
                return {};
            return referenceSample(volume, voxel);
        };
        return referencePicture(warped);
    }

    double psnr(const std::string& program, const std::string& words, const Picture& truth)
    {
        const Comparison apart = compare(draw(program, words), truth);
        EXPECT_GT(apart.opaquePixels, std::size_t(kWidth * kHeight / 20)) << words;
        if (std::getenv("VO_TEST_PRINT")) std::printf("%s: %s\n", words.c_str(), apart.summary().c_str());
        return apart.psnrAll;
    }

    /// Nothing where the volume ends, so that no outline of a lattice counts.
    Field field =
        quantised(withEmptyBorder(fieldOf(kSize,
                                          [](const dvec3& p) {
                                              const dvec3 part = (p - kMiddle) / (kMiddle - 3.0);
                                              double fade = 1;
                                              for (int axis = 0; axis < 3; ++axis)
                                                  fade *= std::max(0.0, 1 - std::pow(part[axis], 4));
                                              return fade * (0.6 + 0.25 * std::sin(0.5 * p.x + 0.3 * p.y) +
                                                             0.15 * std::sin(0.6 * p.z - 0.4 * p.y));
                                          }),
                                  2));
    std::vector<float> table;
    vo::ScratchFolder folder;
};

TEST_F(Deform, unmovedIsTheVolume)
{
    const Picture truth = referencePicture(scene());
    for (const char* words : {"", "-lattice 1 1 1", "-lattice 5 3 7 -split 24", "-split 6 -core",
                              "-bricks 2 2 2", "-engine cast", "-warp twist 0 -warp bend 0 -warp taper 1"})
        EXPECT_GE(psnr("voglDeform", words, truth), 50);
    const auto deformed = draw("voglDeform", "-2D -lattice 3 3 3");
    EXPECT_GE(compareDrawn(deformed, draw("voglBasic", "-2D")).psnrAll, 50);
}

struct Case
{
    const char* words;
    Warp warp;
    std::array<int, 3> boxes{16, 16, 16};
    dvec3 scale{1};
    double degrees = 0; ///< perspective
};

TEST_F(Deform, warpsEqualTheirInverseResampled)
{
    const dvec3 tall(1, 1, 1.5);
    const Case cases[] = {
        {"-warp twist 90", twist(90, 34)},
        {"-warp bend 60 -core", bend(60, 34)},
        {"-warp taper 0.4 -split 24", taper(0.4, 34)},
        {"-warp twist 60 -warp bend -50 -split 6 -perspective 40",
         after(twist(60, 34), bend(-50, 34)),
         {16, 16, 16},
         dvec3(1),
         40},
        {"-warp bend 70 -warp taper 0.6 -scale 1 1 1.5 -bricks 2 1 2",
         after(bend(70, 34 * 1.5), taper(0.6, 34 * 1.5)),
         {16, 16, 16},
         tall},
        {"-warp twist 80 -engine cast", twist(80, 34)},
    };
    for (const Case& c : cases) {
        const Picture truth =
            resampled(fitted(c.warp, c.boxes, kVoxels * c.scale), c.boxes, c.scale, c.degrees);
        EXPECT_GE(psnr("voglDeform", "-lattice 16 16 16 " + std::string(c.words), truth), 42) << c.words;
    }
}

TEST_F(Deform, fieldsMoveByMillimetresAlongTheAxes)
{
    const dvec3 scale(1, 2, 1);
    const VectorField displacement(kVoxels * scale);
    displacement.write(folder / "field.nrrd", {1, -2, 0.5});
    const std::array<int, 3> boxes{20, 20, 20};
    const Picture truth = resampled(fitted(displacement.warp(), boxes, kVoxels * scale), boxes, scale);
    EXPECT_GE(psnr("voglDeform", "-lattice 20 20 20 -warp field field.nrrd -fieldScale 1 -2 0.5 -scale 1 2 1",
                   truth),
              42);
}

TEST_F(Deform, errorFallsAsTheLatticeIsRefined)
{
    const std::pair<const char*, Warp> cases[] = {{"-warp twist 120", twist(120, 34)},
                                                  {"-warp bend 120", bend(120, 34)}};
    for (const auto& [words, warp] : cases) {
        double before = 0;
        for (const int n : {4, 8, 16}) {
            // Fitted by its own vertices: each lattice has a truth of its own.
            const std::array<int, 3> boxes{n, n, n};
            const std::string side = std::to_string(n) + " ";
            const double now = psnr("voglDeform", "-lattice " + side + side + side + words,
                                    resampled(fitted(warp, boxes, kVoxels), boxes));
            EXPECT_GE(now, before + 6) << words << " " << n;
            before = now;
        }
    }
}

TEST_F(Deform, fansEqualTheirInverseResampled)
{
    const Case cases[] = {
        {"-angle 80 -radius 10 30 -lattice 24 12 1", fan(80, 10, 30, 0, kVoxels), {24, 12, 1}},
        {"-angle 70 -radius 15 50 -elevation 50 -lattice 20 12 16",
         fan(70, 15, 50, 50, kVoxels),
         {20, 12, 16}},
        {"-angle 80 -radius 10 30 -scale 1 1 1.5",
         fan(80, 10, 30, 0, kVoxels * dvec3(1, 1, 1.5)),
         {26, 12, 1},
         dvec3(1, 1, 1.5)},
        {"", fan(75, 26 / 3.0, 26 + 26 / 3.0, 0, kVoxels), {25, 12, 1}},
    };
    for (const Case& c : cases) {
        const Picture truth = resampled(fitted(c.warp, c.boxes, kVoxels * c.scale), c.boxes, c.scale);
        EXPECT_GE(psnr("voglFan", c.words, truth), 42) << c.words;
    }
}

TEST_F(Deform, fansTakeAnyAxes)
{
    // The same volume with its axes exchanged: x is the depth, z the beams.
    vo::writeBytes(folder / "turned.tif", kSize.y, kSize.z, kSize.x,
                   [this](int x, int y, int z) { return int(std::lround(255 * double(field.at(z, x, y)))); });
    const std::string words = "-lutFile smooth.lut -size 96 96 -radius 10 40 -sampling 0.5 ";
    const auto drawn = [&](const std::string& more) {
        return vo::drawnPicture(folder, "voglFan", words + more).pixels();
    };
    // One with the beams to the right and the depth down, the other with the depth to the right and the beams
    // up.
    const auto down = drawn("soft.tif -view 90 0"), right = drawn("turned.tif -axes x z -view 0 0");
    std::vector<float> turned(down.size());
    for (std::size_t row = 0; row < 96; ++row)
        for (std::size_t column = 0; column < 96; ++column)
            std::copy_n(&right[4 * (column * 96 + 95 - row)], 4, &turned[4 * (row * 96 + column)]);
    const Comparison apart = compareDrawn(turned, down);
    EXPECT_GE(apart.psnrAll, 42) << apart.summary();
    EXPECT_GT(apart.opaquePixels, 500u);
}

/// The picture moved by whole pixels, to the right and up.
std::vector<float> moved(const std::vector<float>& picture, int right, int up)
{
    std::vector<float> result(picture.size());
    for (int y = up; y < kHeight; ++y)
        for (int x = right; x < kWidth; ++x)
            std::copy_n(&picture[4 * std::size_t((y - up) * kWidth + x - right)], 4,
                        &result[4 * std::size_t(y * kWidth + x)]);
    return result;
}

TEST_F(Deform, draggedVerticesFollowThePointerAtTheirDepth)
{
    // Level, and looked at along y: two vertices at each corner of the picture, the nearer one goes first.
    const double pixel = glm::length(kVoxels) / kHeight;
    std::string drags = "-lattice 1 1 1 -view 0 0";
    for (int round = 0; round < 2; ++round)
        for (const double x : {-15 / pixel, 15 / pixel})
            for (const double y : {-17 / pixel, 17 / pixel}) {
                char text[100];
                std::snprintf(text, sizeof text, " -drag %.6f %.6f %.6f %.6f", kWidth / 2 + x,
                              kHeight / 2 + y, kWidth / 2 + x + 6, kHeight / 2 + y + 4);
                drags += text;
            }
    const auto picture = draw("voglDeform", drags);
    const Comparison apart = compareDrawn(picture, moved(draw("voglBasic", "-view 0 0"), 6, 4));
    EXPECT_GE(apart.psnrAll, 50) << apart.summary();
    EXPECT_GT(apart.opaquePixels, 500u);
}

TEST_F(Deform, foldsAreReportedAndDrawn)
{
    for (const std::string words : {"-warp twist 480 -lattice 3 3 3", "-warp bend 700",
                                    "-lattice 2 2 2 -drag 56 48 -400 48 -wireframe"}) {
        const auto run = folder.run("voglDeform", "soft.tif -size 112 96 -output folded.png " + words);
        EXPECT_EQ(run.status, 0) << words;
        EXPECT_NE(run.errors.find("tetrahedra are inside out"), std::string::npos) << words << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
        EXPECT_TRUE(vo::readPng(folder / "folded.png")) << words;
    }
}

TEST_F(Deform, wireframeShowsTheBoxes)
{
    const auto picture = draw("voglDeform", "-lattice 2 1 1 -wireframe -view 0 0");
    // Looked at along y: lines at a quarter, a half and three quarters would be those of tetrahedra; the
    // boxes have one in the middle.
    const double pixel = glm::length(kVoxels) / kHeight;
    const auto yellow = [&](double x, double y) {
        for (int right = -1; right <= 1; ++right) {
            const int column = int(kWidth / 2 + x / pixel) + right, row = int(kHeight / 2 + y / pixel);
            const float* rgba = &picture[4 * std::size_t(row * kWidth + column)];
            if (rgba[0] > 0.9f && rgba[1] > 0.9f && rgba[2] < 0.5f) return true;
        }
        return false;
    };
    for (const double z : {-16.0, -9.0, 5.0, 16.0}) {
        EXPECT_TRUE(yellow(0, z)) << z;
        EXPECT_TRUE(yellow(-15, z)) << z;
        EXPECT_TRUE(yellow(15, z)) << z;
        EXPECT_FALSE(yellow(-7.5, z)) << z;
    }
}

TEST_F(Deform, badOptionsAreNamed)
{
    vo::writeBytes(folder / "grey.tif", 3, 3, 3, [](int x, int, int) { return x; });
    std::ofstream(folder / "nan.nrrd", std::ios::binary)
        << "NRRD0004\ntype: float\ndimension: 4\nsizes: 3 1 1 1\nendian: little\nencoding: ascii\n\n0 nan "
           "0\n";
    struct Refused
    {
        const char *program, *option, *named;
    };
    for (const auto& [program, option, named] :
         {Refused{"voglDeform", "-warp spin 3", "twist, bend, taper or field"},
          {"voglDeform", "-warp twist much", "-warp"},
          {"voglDeform", "-lattice 0 1 1", "-lattice"},
          {"voglDeform", "-lattice 1 1 1000", "-lattice"},
          {"voglDeform", "-split 7", "5, 6 or 24"},
          {"voglDeform", "-warp field none.nrrd", "none.nrrd"},
          {"voglDeform", "-warp field grey.tif", "vectors of 3 parts"},
          {"voglDeform", "-warp field nan.nrrd", "range of floats"},
          {"voglFan", "-radius 5 5", "R0 below R1"},
          {"voglFan", "-axes x x", "two axes"},
          {"voglFan", "-axes a x", "x, y or z"},
          {"voglFan", "-angle 0", "-angle"}})
        vo::expectOneLine(folder, program, std::string("soft.tif ") + option, named);
}

} // namespace
