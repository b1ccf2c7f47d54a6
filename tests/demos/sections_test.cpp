#include "run_program.h"

#include "support/compare.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>
#include <sstream>

namespace {

using namespace vo::test;

constexpr int kWidth = 96, kHeight = 80;
const vo::VoxelSize kSize{24, 20, 16};
const glm::dvec3 kScale(1, 1, 1.5);
const std::string kCommon = "noise.tif -scale 1 1 1.5 -size 96 80 -view -20 35 ";
const Angles kAngles{-20, 35};

/// A point and a direction in voxels.
struct Ray
{
    glm::dvec3 origin, direction;
};

/// Through the centre of a pixel, y from the bottom.
Ray rayThrough(const View& view, double x, double y)
{
    const glm::dmat4 toVoxels =
        glm::inverse(glm::make_mat4(view.projection.data()) * glm::make_mat4(view.model.data()));
    const glm::dvec2 device(2 * (x + 0.5) / kWidth - 1, 2 * (y + 0.5) / kHeight - 1);
    const glm::dvec4 near = toVoxels * glm::dvec4(device, -1, 1), far = toVoxels * glm::dvec4(device, 1, 1);
    const glm::dvec3 from = glm::dvec3(near) / near.w, to = glm::dvec3(far) / far.w;
    return {from, to - from};
}

/// Where a ray meets a plane {A, B, C, D}.
std::optional<double> meet(const Ray& ray, const glm::dvec4& plane)
{
    const double slope = glm::dot(glm::dvec3(plane), ray.direction);
    if (slope == 0) return {};
    return -(glm::dot(glm::dvec3(plane), ray.origin) + plane.w) / slope;
}

/// Voxels of noise smooth enough to look at, dark at all faces: the edges of sections do not show.
Field noise()
{
    Field field = fieldOf(kSize, [](const glm::dvec3& p) {
        return 0.5 + 0.25 * std::sin(0.9 * p.x + 0.4 * p.y) + 0.2 * std::sin(0.8 * p.z - 0.7 * p.y) +
               0.05 * std::sin(7 * p.x * p.z);
    });
    return quantised(withEmptyBorder(field, 1));
}

class Sections : public testing::Test
{
protected:
    Sections()
    {
        vo::writeBytes(folder / "noise.tif", 24, 20, 16, [this](int x, int y, int z) {
            return int(std::lround(255 * double(field.at(x, y, z))));
        });
        scene.volume = &field;
        scene.overlap = 1;
    }

    /// What a program writes, as floats from the bottom.
    std::vector<float> draw(const std::string& program, const std::string& words)
    {
        const vo::Picture picture = vo::drawnPicture(folder, program, kCommon + words).picture;
        std::vector<float> pixels;
        const int channels = int(picture.bytes.size()) / (kWidth * kHeight);
        for (int y = picture.height - 1; y >= 0; --y)
            for (int x = 0; x < kWidth; ++x)
                for (int c = 0; c < 4; ++c) {
                    const auto at = std::size_t((y * kWidth + x) * channels + std::min(c, channels - 1));
                    pixels.push_back(float(picture.bytes[at]) / 255);
                }
        return pixels;
    }

    /// The voxel value at a point, -1 without one or outside the volume's clip box.
    double valueAt(const std::optional<glm::dvec3>& point) const
    {
        const bool inside = point && glm::all(glm::greaterThan(*point, glm::dvec3(0.5))) &&
                            glm::all(glm::lessThan(*point, glm::dvec3(23.5, 19.5, 15.5)));
        return inside ? referenceSample(scene, *point)[0] : -1;
    }

    /// The voxels where `hit` says that a ray meets something, as a picture; masked where 1/128 pixel to the
    /// side there is something else: rasterisers snap vertices to 1/256.
    template <typename Hit>
    Picture reference(const View& view, Hit hit)
    {
        Picture picture{kWidth, kHeight, {}, {}};
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x) {
                const double found = valueAt(hit(rayThrough(view, x, y)));
                const double value = std::max(found, 0.0);
                picture.rgba.insert(picture.rgba.end(), {value, value, value, found < 0 ? 0.0 : 1.0});
                bool steady = true;
                for (const auto& [dx, dy] :
                     {std::pair(-1, 0), std::pair(1, 0), std::pair(0, -1), std::pair(0, 1)})
                    steady &= std::abs(valueAt(hit(rayThrough(view, x + dx / 128.0, y + dy / 128.0))) -
                                       found) < 0.02;
                picture.unmasked.push_back(steady);
            }
        return picture;
    }

    static View view(bool perspective)
    {
        return perspective ? perspectiveView(kAngles, kSize, kWidth, kHeight, 50, kScale)
                           : orthographicView(kAngles, kSize, kWidth, kHeight, kScale);
    }

    Field field = noise();
    Scene scene;
    vo::ScratchFolder folder;
};

const char* const kWays[] = {"", "-core -2D", "-bricks 2 2 2", "-2D -bricks 2 1 2 -perspective 50"};

TEST_F(Sections, planeShowsTrilinearSamples)
{
    for (const glm::dvec4 plane : {glm::dvec4(1, -2, 1, 10), glm::dvec4(0, 0, 1, -6.3)})
        for (const std::string way : kWays) {
            std::ostringstream words;
            words << "-plane " << plane.x << " " << plane.y << " " << plane.z << " " << plane.w << " " << way;
            const Picture truth = reference(view(way.find("perspective") != way.npos), [&](const Ray& ray) {
                const auto t = meet(ray, plane);
                return t ? std::optional(ray.origin + *t * ray.direction) : std::nullopt;
            });
            const Comparison apart = compare(draw("voglMPR1", words.str()), truth);
            EXPECT_GT(apart.psnrMasked, 45) << words.str() << ": " << apart.summary();
            EXPECT_GT(apart.opaquePixels, 500u);
            EXPECT_LT(apart.maskedPixels, 150u);
        }
}

/// The nearer of the pages {normal, then the direction from the hinge} that a ray meets.
std::optional<glm::dvec3> meetBook(const Ray& ray, double degrees)
{
    std::optional<double> nearest;
    for (const double side : {-0.5, 0.5}) {
        const double angle = side * degrees * std::numbers::pi / 180;
        const glm::dvec3 along(std::sin(angle), -std::cos(angle), 0), hinge(12, 10, 0);
        const glm::dvec3 normal(-along.y, along.x, 0);
        const auto t = meet(ray, glm::dvec4(normal, -glm::dot(normal, hinge)));
        if (!t || *t < 0 || (nearest && *nearest < *t)) continue;
        const glm::dvec3 point = ray.origin + *t * ray.direction;
        const bool inside = glm::all(glm::greaterThan(point, glm::dvec3(0.5))) &&
                            glm::all(glm::lessThan(point, glm::dvec3(23.5, 19.5, 15.5)));
        if (inside && glm::dot(along, point - hinge) >= 0) nearest = *t;
    }
    return nearest ? std::optional(ray.origin + *nearest * ray.direction) : std::nullopt;
}

TEST_F(Sections, pagesShowTrilinearSamplesAndTheNearerOne)
{
    for (const double fold : {40.0, 200.0})
        for (const std::string way : kWays) {
            const std::string words = "-fold " + std::to_string(fold) + " " + way;
            const Picture truth = reference(view(way.find("perspective") != way.npos),
                                            [&](const Ray& ray) { return meetBook(ray, fold); });
            const Comparison apart = compare(draw("voglMPR2", words), truth);
            EXPECT_GT(apart.psnrMasked, 45) << words << ": " << apart.summary();
            EXPECT_GT(apart.opaquePixels, 500u);
            EXPECT_LT(apart.maskedPixels, 150u);
        }
}

/// A leak is a failure where the sanitizers run.
TEST_F(Sections, tenFramesEndAsTheyBegan)
{
    for (const std::string words :
         {"voglBasic", "voglBasic -shells -perspective 40", "voglMPR1", "voglMPR2 -2D",
          "voglPick -pick 48 40", "voglPick -pick 48 40 -core -2D"}) {
        const std::size_t space = std::min(words.find(' '), words.size());
        const auto run = [&](const std::string& more) {
            const vo::ProgramRun ran =
                folder.run(words.substr(0, space), kCommon + words.substr(space) + more + " -output a.png");
            EXPECT_EQ(ran.status, 0) << words << ": " << ran.errors;
            EXPECT_EQ(ran.errors, "") << words;
            return vo::readFile(folder / "a.png");
        };
        EXPECT_EQ(run(" -frames 10"), run("")) << words;
    }
}

TEST_F(Sections, badPlanesAndFoldsAreRefused)
{
    for (const std::string words : {"voglMPR1 -plane 0 0 0 1", "voglMPR1 -plane 1 2 3", "voglMPR2 -fold 400",
                                    "voglPick -pick 96 3", "voglPick -pick 3 -1", "voglPick -values a.txt"}) {
        const std::size_t space = words.find(' ');
        const vo::ProgramRun run = folder.run(words.substr(0, space), "noise.tif -size 96 80 -output a.png " +
                                                                          words.substr(space + 1));
        EXPECT_EQ(run.status, 1) << words;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << words << ": " << run.errors;
        EXPECT_NE(run.errors.find("expected"), std::string::npos) << run.errors;
    }
    EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
}

struct Sample
{
    glm::dvec3 position;
    double value;
};

std::vector<Sample> readSamples(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    std::vector<Sample> samples;
    for (Sample s; file >> s.position.x >> s.position.y >> s.position.z >> s.value;)
        samples.push_back(s);
    return samples;
}

TEST_F(Sections, pickedSignalIsTheVoxelsOnTheLineOfSight)
{
    for (const std::string way : {"", "-core", "-bricks 2 2 2", "-perspective 50"}) {
        draw("voglPick", "-pick 45 37 -values signal.txt " + way);
        const std::vector<Sample> samples = readSamples(folder / "signal.txt");
        ASSERT_GT(samples.size(), 10u) << way;
        const Ray ray = rayThrough(view(way.find("perspective") != way.npos), 45, 37);
        double last = -1;
        for (const Sample& s : samples) {
            const glm::dvec3 from = s.position - ray.origin;
            const double t = glm::dot(from, ray.direction) / glm::dot(ray.direction, ray.direction);
            EXPECT_GT(t, last) << "nearest first";
            last = t;
            EXPECT_LT(glm::length(from - t * ray.direction), 1e-3) << way;
            const glm::ivec3 voxel(glm::floor(s.position));
            EXPECT_NEAR(s.value, 255 * double(field.at(voxel.x, voxel.y, voxel.z)), 1e-4) << way;
        }
    }
}

TEST_F(Sections, signalIsPlottedAtTheBottom)
{
    const std::string plain = "-size 200 200 ";
    const auto drawn = [&](const std::string& program, const std::string& words) {
        EXPECT_EQ(folder.run(program, "noise.tif -view -20 35 " + plain + words + " -output p.png").status,
                  0);
        const auto picture = vo::readPng(folder / "p.png");
        return picture ? *picture : vo::Picture{};
    };
    const vo::Picture with = drawn("voglPick", "-pick 100 110 -values s.txt");
    const vo::Picture without = drawn("voglBasic", "");
    const std::vector<Sample> samples = readSamples(folder / "s.txt");
    ASSERT_GT(samples.size(), 10u);
    // The plot: 8 pixels of margin round the lowest 50 rows; sample i in the middle of its share of the
    // width.
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double x = 8 + 184 * (double(i) + 0.5) / double(samples.size());
        const double y = 8 + 34 * samples[i].value / 255;
        int brightest = 0; // the line is two pixels wide, whichever way it goes
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                brightest = std::max(brightest, vo::channel(with, int(x) + dx, 199 - int(y) + dy, 1));
        EXPECT_GT(brightest, 200) << "sample " << i;
    }
    EXPECT_LT(vo::channel(with, 2, 198, 0), 30) << "ground";
    EXPECT_EQ(vo::channel(with, 100, 199 - 110, 2), 0) << "yellow cross";
    EXPECT_EQ(vo::channel(with, 100, 199 - 110, 0), 255);
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 200; ++x)
            ASSERT_EQ(vo::channel(with, x, y, 0), vo::channel(without, x, y, 0)) << "above, all is as it was";
    const vo::Picture missed = drawn("voglPick", "-pick 1 1");
    EXPECT_EQ(vo::difference(missed, without).largest, 0) << "no signal outside the volume";
}

} // namespace
