// Programs that draw a scene in several passes, against rays of double precision.
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
using glm::dvec3;

constexpr int kWidth = 96, kHeight = 80;
/// Decibels; all come to 57 or more, which is what 8 bits allow.
constexpr double kBar = 54;

/// Parameters from 0 at the near plane to 1 at the far one.
struct Ray
{
    dvec3 start, along;
    dvec3 at(double place) const { return start + place * along; }
};

/// Through a point of the window, in pixels from the lower left corner.
Ray rayThrough(const View& view, double x, double y)
{
    const glm::dmat4 fromDevice =
        glm::inverse(glm::make_mat4(view.projection.data()) * glm::make_mat4(view.model.data()));
    const glm::dvec2 device(2 * x / kWidth - 1, 2 * y / kHeight - 1);
    const glm::dvec4 near = fromDevice * glm::dvec4(device, -1, 1),
                     far = fromDevice * glm::dvec4(device, 1, 1);
    const dvec3 start = dvec3(near) / near.w;
    return {start, dvec3(far) / far.w - start};
}

/// The demos' view of a box from the origin: a ball `margin` times as large as the one round it fits into the
/// window. Orthographic for 0 degrees.
View demoView(const Angles& angles, const dvec3& size, const dvec3& scale, double margin, double degrees)
{
    Matrix model = multiply(rotation(-angles.latitude - 90, 1, 0, 0), rotation(-angles.longitude, 0, 0, 1));
    model = multiply(model, multiply(scaling(scale.x, scale.y, scale.z),
                                     translation(-size.x / 2, -size.y / 2, -size.z / 2)));
    const double radius = margin * glm::length(size * scale) / 2;
    const double x = double(kWidth) / kHeight;
    if (degrees == 0)
        return {model, ortho(-radius * x, radius * x, -radius, radius, -4 * radius, 4 * radius)};
    const double half = degrees / 2 * std::numbers::pi / 180;
    const double distance = radius / std::sin(half), near = (distance - radius) / 2,
                 side = near * std::tan(half);
    return {multiply(translation(0, 0, -distance), model),
            frustum(-side * x, side * x, -side, side, near, distance + 4 * radius)};
}

std::vector<Tetrahedron> boxTetrahedra(const dvec3& lower, const dvec3& upper)
{
    const auto corner = [&](int i) {
        return dvec3(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z);
    };
    std::vector<Tetrahedron> result;
    for (const auto& [a, b, c, d] :
         {std::array{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}})
        result.push_back({corner(a), corner(b), corner(c), corner(d)});
    return result;
}

/// Calls visit(point, place on the ray) where a ray meets the planes, from the farthest.
template <typename Visit>
void alongRay(const Ray& ray, const ReferencePlanes& planes, Visit visit)
{
    for (const double offset : planes.offsets) {
        const double place =
            (offset - glm::dot(planes.normal, ray.start)) / glm::dot(planes.normal, ray.along);
        if (place >= 0 && place <= 1) visit(ray.at(place), place);
    }
}

/// `color(x, y)`: red, green and blue at a point of the window. Masked where 1/50 pixel aside `thing(x, y)`
/// is another one: rasterisers snap vertices to 1/256.
template <typename Color, typename Thing>
Picture pictureOf(Color color, Thing thing)
{
    Picture picture{kWidth, kHeight, {}, {}};
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const dvec3 rgb = color(x + 0.5, y + 0.5);
            picture.rgba.insert(picture.rgba.end(), {rgb.r, rgb.g, rgb.b, std::max({rgb.r, rgb.g, rgb.b})});
            bool alike = true;
            for (const auto& [dx, dy] : {std::pair{0.48, 0.48}, {0.52, 0.48}, {0.48, 0.52}, {0.52, 0.52}})
                alike = alike && thing(x + dx, y + dy) == thing(x + 0.5, y + 0.5);
            picture.unmasked.push_back(alike);
        }
    return picture;
}

template <typename Color>
Picture pictureOf(Color color)
{
    return pictureOf(color, [](double, double) { return 0; });
}

void over(dvec3& below, const std::array<double, 4>& sample)
{
    below = below * (1 - sample[3]) + dvec3(sample[0], sample[1], sample[2]) * sample[3];
}

/// The table of the programs without one from a file: a ramp of grey times a colour, and opacity.
std::vector<float> rampTable(double longestSide, const dvec3& tint = dvec3(1))
{
    const double opacity = 1 - std::exp(-10 / longestSide);
    std::vector<float> table;
    for (int i = 0; i < 256; ++i)
        for (const double value : {tint.r, tint.g, tint.b, opacity})
            table.push_back(float(value * i / 255));
    return table;
}

/// Something soft that fades out three voxels before every face.
Field blob(const vo::VoxelSize& size, double phase)
{
    return quantised(fieldOf(size, [&](const dvec3& p) {
        const dvec3 middle(size.x / 2.0, size.y / 2.0, size.z / 2.0);
        const double inside = 1 - glm::dot((p - middle) / (middle - 3.5), (p - middle) / (middle - 3.5));
        if (inside <= 0) return 0.0;
        return inside * (2 - inside) * (0.7 + 0.3 * std::sin(0.5 * p.x + 0.4 * p.y - 0.6 * p.z + phase));
    }));
}

class Passes : public testing::Test
{
protected:
    void write(const std::string& name, const Field& field)
    {
        vo::writeBytes(folder / name, field.size.x, field.size.y, field.size.z, [&](int x, int y, int z) {
            return int(std::lround(255 * double(field.at(x, y, z))));
        });
    }

    /// Writes a table of two entries, and returns it in 256.
    std::vector<float> writeTable(const std::string& name, const std::array<double, 4>& low,
                                  const std::array<double, 4>& high)
    {
        std::ofstream file(folder / name);
        for (const auto& entry : {low, high})
            for (std::size_t c = 0; c < 4; ++c)
                file << std::to_string(entry[c]) << (c == 3 ? "\n" : " ");
        std::vector<float> table;
        for (int i = 0; i < 256; ++i)
            for (std::size_t c = 0; c < 4; ++c)
                table.push_back(float(low[c] + (high[c] - low[c]) * i / 255));
        return table;
    }

    /// What a program draws, as floats from the bottom.
    std::vector<float> draw(const std::string& program, const std::string& words)
    {
        const auto drawn = vo::drawnPicture(folder, program, words + " -size 96 80");
        output = drawn.printed;
        return drawn.pixels();
    }

    /// In contexts of both profiles.
    void expectDrawn(const std::string& program, const std::string& words, const Picture& truth,
                     double bar = kBar)
    {
        for (const char* profile : {"", " -core"}) {
            const auto pixels = draw(program, words + profile);
            if (pixels.empty()) continue;
            const Comparison found = compare(pixels, truth);
            EXPECT_GE(found.psnrMasked, bar) << program << " " << words << profile << ": " << found.summary();
            EXPECT_GT(found.opaquePixels, 200u) << words;
            EXPECT_LT(found.maskedPixels, 200u) << words;
        }
    }

    vo::ScratchFolder folder;
    std::string output;
};

Scene sceneOf(const Field& field, const std::vector<float>& table, const View& view)
{
    Scene scene;
    scene.volume = &field;
    scene.view = view;
    scene.width = kWidth;
    scene.height = kHeight;
    if (table.empty()) return scene;
    scene.classification = Classification::postInterpolation;
    scene.table = table;
    return scene;
}

// ---- voglTwo

struct TwoCase
{
    const char* words;
    dvec3 offset, spacing;
    double degrees = 0;
    int stackAxis = -1;
};

TEST_F(Passes, twoVolumesInterleaveSampleBySample)
{
    const Field first = blob({24, 20, 18}, 0), second = blob({16, 18, 14}, 2);
    write("first.tif", first);
    write("second.tif", second);
    const auto table = writeTable("second.lut", {1, 0.2, 0, 0}, {0.2, 0.9, 1, 0.7});
    for (const TwoCase& c :
         {TwoCase{"-offset -5.5 4 6.25 -spacing2 1.2 0.9 1", {-5.5, 4, 6.25}, {1.2, 0.9, 1}},
          TwoCase{"-offset 3 -4 5 -perspective 50 -bricks 2 2 2", {3, -4, 5}, {1, 1, 1}, 50},
          TwoCase{"-offset 3 -4 5 -2D", {3, -4, 5}, {1, 1, 1}, 0, 1}}) {
        const dvec3 lowest = glm::min(c.offset, dvec3(0));
        const dvec3 upper = glm::max(dvec3(24, 20, 18), c.offset + c.spacing * dvec3(16, 18, 14)) - lowest;
        const View view = demoView({20, 30}, upper, dvec3(1), 1, c.degrees);
        Scene firstScene = sceneOf(first, rampTable(24), view), secondScene = sceneOf(second, table, view);
        Scene both = sceneOf(first, {}, view);
        both.geometry = boxTetrahedra(dvec3(0), upper);
        for (Scene* scene : {&both, &firstScene, &secondScene}) {
            scene->stackAxis = c.stackAxis;
            if (c.stackAxis >= 0) scene->planes = SamplingPlanes::axisAligned;
        }
        const ReferencePlanes planes = referencePlanes(both);
        const auto color = [&](double x, double y) {
            dvec3 rgb(0);
            alongRay(rayThrough(view, x, y), planes, [&](dvec3 point, double) {
                // Or rounding decides between slices.
                if (c.stackAxis >= 0) point[c.stackAxis] = std::floor(point[c.stackAxis]) + 0.5;
                over(rgb, referenceSample(firstScene, point + lowest));
                over(rgb, referenceSample(secondScene, (point + lowest - c.offset) / c.spacing));
            });
            return rgb;
        };
        expectDrawn("voglTwo",
                    "first.tif second.tif -view 20 30 -lutFile2 second.lut " + std::string(c.words),
                    pictureOf(color));
    }
}

// ---- voglJaw

#ifdef VOLUMIZER_CGAL

const dvec3 kPartLower(6.3, 5.6, 4.7), kPartUpper(16.4, 13.8, 12.9);

bool isInPart(const dvec3& point)
{
    return glm::all(glm::lessThan(kPartLower, point)) && glm::all(glm::lessThan(point, kPartUpper));
}

/// A box of triangles.
void writePart(const std::string& name)
{
    std::ofstream file(name);
    file << "OFF\n8 12 0\n";
    for (int corner = 0; corner < 8; ++corner)
        file << (corner & 1 ? kPartUpper : kPartLower).x << " " << (corner & 2 ? kPartUpper : kPartLower).y
             << " " << (corner & 4 ? kPartUpper : kPartLower).z << "\n";
    file << "3 0 2 3\n3 0 3 1\n3 4 5 7\n3 4 7 6\n3 0 1 5\n3 0 5 4\n3 2 6 7\n3 2 7 3\n3 0 4 6\n3 0 6 2\n3 1 3 "
            "7\n3 1 7 5\n";
}

TEST_F(Passes, partAndRestTogetherAreTheVolume)
{
    write("volume.tif", blob({24, 20, 18}, 1));
    writePart(folder / "part.off");
    writeTable("red.lut", {1, 0, 0, 0}, {1, 0.5, 0.2, 0.3});
    for (const char* words : {"", " -perspective 40", " -bricks 2 2 2", " -core"}) {
        const std::string both = "volume.tif -view 20 30 -lutFile red.lut" + std::string(words);
        const auto whole = draw("voglBasic", both);
        const auto parts = draw("voglJaw", both + " part.off -partLut red.lut -edge 3");
        EXPECT_GE(compareDrawn(whole, parts).psnrAll, 50) << words;
    }
}

TEST_F(Passes, partsAreOrangeWithoutATableOfTheirOwn)
{
    write("volume.tif", blob({24, 20, 18}, 1));
    writePart(folder / "part.off");
    writeTable("red.lut", {1, 0, 0, 0}, {1, 0.5, 0.2, 0.3});
    writeTable("orange.lut", {1, 0, 0, 0}, {1, 0.5 * 0.55, 0.2 * 0.15, 0.3});
    const std::string words = "volume.tif part.off -edge 3 -view 20 30 -lutFile red.lut ";
    const auto orange = draw("voglJaw", words + "-partLut orange.lut");
    EXPECT_GE(compareDrawn(draw("voglJaw", words), orange).psnrAll, 60);
    EXPECT_LT(compareDrawn(draw("voglJaw", words + "-partLut red.lut"), orange).psnrAll, 40);
}

TEST_F(Passes, partsAreDrawnEachThroughItsTableAndWhereItWasMoved)
{
    const Field field = blob({24, 20, 18}, 1);
    write("volume.tif", field);
    writePart(folder / "part.off");
    const auto red = writeTable("red.lut", {1, 0, 0, 0}, {1, 0.5, 0.2, 0.3});
    const auto green = writeTable("green.lut", {0, 1, 0, 0}, {0.5, 1, 0.2, 0.9});
    const dvec3 shift(4, -3.5, 2.25), size(24, 20, 18);
    for (const bool isAlone : {false, true}) {
        const View view = demoView({20, 30}, size, dvec3(1), 1, 0);
        Scene rest = sceneOf(field, red, view), part = sceneOf(field, green, view),
              all = sceneOf(field, {}, view);
        all.geometry = boxTetrahedra(kPartLower + shift, kPartUpper + shift);
        if (!isAlone)
            for (const Tetrahedron& tetra : boxTetrahedra(dvec3(0), size))
                all.geometry.push_back(tetra);
        const ReferencePlanes planes = referencePlanes(all);
        const auto color = [&](double x, double y) {
            dvec3 rgb(0);
            alongRay(rayThrough(view, x, y), planes, [&](const dvec3& point, double) {
                if (!isAlone && !isInPart(point)) over(rgb, referenceSample(rest, point));
                if (isInPart(point - shift)) over(rgb, referenceSample(part, point - shift));
            });
            return rgb;
        };
        // Whether a sample at a face belongs to the part is decided by rounding: masked there.
        const auto samples = [&](double x, double y) {
            std::vector<bool> inside;
            alongRay(rayThrough(view, x, y), planes, [&](const dvec3& point, double) {
                inside.push_back(isInPart(point));
                inside.push_back(isInPart(point - shift));
            });
            return inside;
        };
        expectDrawn(
            "voglJaw",
            "volume.tif part.off -view 20 30 -edge 3 -lutFile red.lut -partLut green.lut -move 4 -3.5 2.25" +
                std::string(isAlone ? " -part" : ""),
            pictureOf(color, samples), 42);
    }
}

#endif

// ---- voglTagged

TEST_F(Passes, eachClassIsDrawnThroughItsTable)
{
    const Field field = blob({24, 20, 18}, 1);
    const auto tagAt = [](int x, int y, int z) { return x < 7 ? 0 : z > 9 ? 200 : y > 10 ? 7 : 3; };
    write("volume.tif", field);
    vo::writeBytes(folder / "tags.tif", 24, 20, 18, tagAt);
    const auto red = writeTable("red.lut", {1, 0, 0, 0}, {1, 0.5, 0.2, 0.3});
    const auto green = writeTable("green.lut", {0, 1, 0, 0}, {0.5, 1, 0.2, 0.9});
    for (const auto& [words, degrees, stackAxis] : {std::tuple{"-view 20 30", 0.0, -1},
                                                    {"-view 20 30 -perspective 50 -bricks 2 2 2", 50.0, -1},
                                                    {"-view 20 30 -2D", 0.0, 1}}) {
        const View view = demoView({20, 30}, dvec3(24, 20, 18), dvec3(1), 1, degrees);
        Scene redScene = sceneOf(field, red, view), greenScene = sceneOf(field, green, view);
        for (Scene* scene : {&redScene, &greenScene}) {
            scene->stackAxis = stackAxis;
            if (stackAxis >= 0) scene->planes = SamplingPlanes::axisAligned;
        }
        const ReferencePlanes planes = referencePlanes(redScene);
        const auto color = [&](double x, double y) {
            dvec3 rgb(0);
            alongRay(rayThrough(view, x, y), planes, [&, axis = stackAxis](dvec3 point, double) {
                if (axis >= 0) point[axis] = std::floor(point[axis]) + 0.5;
                const glm::ivec3 voxel(glm::floor(point));
                const bool inside = glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) &&
                                    glm::all(glm::lessThan(voxel, glm::ivec3(24, 20, 18)));
                const int tag = inside ? tagAt(voxel.x, voxel.y, voxel.z) : 0;
                if (tag == 3) over(rgb, referenceSample(redScene, point));
                if (tag == 200) over(rgb, referenceSample(greenScene, point));
            });
            return rgb;
        };
        expectDrawn("voglTagged",
                    "volume.tif tags.tif -table 3 red.lut -table 200 green.lut -hide 7 " + std::string(words),
                    pictureOf(color));
    }
}

TEST_F(Passes, classesOfOneTableAreTheVolumeItself)
{
    write("volume.tif", blob({24, 20, 18}, 1));
    vo::writeBytes(folder / "tags.tif", 24, 20, 18, [](int x, int y, int z) { return (x + y + z) % 3; });
    writeTable("red.lut", {1, 0, 0, 0}, {1, 0.5, 0.2, 0.3});
    const std::string words = "volume.tif -view 20 30 -lutFile red.lut";
    EXPECT_GE(compareDrawn(draw("voglBasic", words), draw("voglTagged", words + " tags.tif -table 0 red.lut"))
                  .psnrAll,
              60);
}

// ---- voglRoam

TEST_F(Passes, cubeOfInterestIsAllThatIsDrawnAndRead)
{
    const Field field = blob({32, 28, 24}, 1);
    write("volume.tif", field);
    for (const auto& [words, degrees] : {std::pair{"", 0.0}, {" -perspective 50", 50.0}}) {
        const View view = demoView({20, 30}, dvec3(32, 28, 24), dvec3(1), 1, degrees);
        Scene scene = sceneOf(field, rampTable(32), view);
        scene.overlap = 1;
        scene.geometry = boxTetrahedra(dvec3(6.3, 7.3, 0), dvec3(18.3, 19.3, 11));
        expectDrawn("voglRoam",
                    "volume.tif -view 20 30 -voi 12.3 13.3 5 12 -bricks 4 4 4" + std::string(words),
                    referencePicture(scene));
        // Clip boxes begin at 0.5, 8.5, 16.5, 24.5 along x, 7.5, 14.5, 21.5 along y, 6.5, 12.5 along z.
        EXPECT_EQ(output, "18 of 64 bricks: 18 read, 0 dropped\n");
    }
}

TEST_F(Passes, roamingOverAllIsTheVolumeItself)
{
    vo::writeShorts(folder / "ct.tif", 20, 18, 16,
                    [](int x, int y, int z) { return 900 + 40 * std::abs(x - 9) + 3 * y * z; });
    for (const char* words : {"", " -2D", " -dataRange 950 1500"}) {
        const auto basic = draw("voglBasic", "ct.tif -view 20 30 -bricks 2 2 2" + std::string(words));
        const auto roam =
            draw("voglRoam", "ct.tif -view 20 30 -bricks 2 2 2 -voi 10 9 8 40" + std::string(words));
        EXPECT_EQ(basic, roam) << words;
    }
}

// ---- voglShade

/// Of a scene of `field`, whose table is a grey ramp: `shade(point)` and the opacity `opacity(point)` of each
/// sample.
template <typename Shade, typename Opacity>
Picture shadedPicture(const View& view, const ReferencePlanes& planes, Shade shade, Opacity opacity)
{
    return pictureOf([&](double x, double y) {
        dvec3 rgb(0);
        alongRay(rayThrough(view, x, y), planes, [&](const dvec3& point, double) {
            const double s = std::clamp(shade(point), 0.0, 1.0);
            over(rgb, {s, s, s, opacity(point)});
        });
        return rgb;
    });
}

struct ShadeCase
{
    const char* words;
    dvec3 light, scale;
    double degrees = 0;
};

TEST_F(Passes, shadeIsTheDifferenceAlongTheLight)
{
    const Field field = blob({28, 26, 24}, 1);
    write("volume.tif", field);
    for (const ShadeCase& c : {ShadeCase{"-light -2 1 2", dvec3(-2, 1, 2) / 3.0, dvec3(1)},
                               ShadeCase{"-light 3 0 4 -perspective 40 -scale 1 1.5 2 -bricks 2 2 2",
                                         dvec3(3, 0, 4) / 5.0, dvec3(1, 1.5, 2), 40}}) {
        const dvec3 size(28, 26, 24);
        const View view = demoView({20, 30}, size, c.scale, 1, c.degrees);
        Scene scene = sceneOf(field, rampTable(std::max({28.0, 26 * c.scale.y, 24 * c.scale.z})), view);
        scene.period = 1.0 / c.scale;
        const dvec3 step = glm::inverse(glm::dmat3(glm::make_mat4(view.model.data()))) * c.light;
        const auto at = [&](const dvec3& p, std::size_t i) { return referenceSample(scene, p)[i]; };
        const Picture truth = shadedPicture(
            view, referencePlanes(scene),
            [&](const dvec3& p) {
                const double away = at(p - step, 0), towards = at(p + step, 0);
                return 0.875 * (away - towards) + 0.25 * (away + towards) / 2;
            },
            [&](const dvec3& p) { return (at(p - step, 3) + at(p + step, 3)) / 2; });
        expectDrawn("voglShade", "volume.tif -view 20 30 " + std::string(c.words), truth);
    }
}

TEST_F(Passes, shadeOfSoftThingsIsNormalTimesLight)
{
    const Field field = quantised(fieldOf({32, 32, 32}, [](const dvec3& p) {
        const double inside = 1 - glm::dot(p - 16.0, p - 16.0) / (12.5 * 12.5);
        return inside > 0 ? inside * inside * (3 - 2 * inside) : 0.0;
    }));
    write("ball.tif", field);
    const View view = demoView({20, 30}, dvec3(32), dvec3(1), 1, 0);
    const Scene scene = sceneOf(field, rampTable(32), view);
    const dvec3 light = glm::inverse(glm::dmat3(glm::make_mat4(view.model.data()))) * dvec3(0.6, 0, 0.8);
    const auto value = [&](const dvec3& p) { return referenceSample(scene, p)[0]; };
    const Picture truth = shadedPicture(
        view, referencePlanes(scene),
        [&](const dvec3& p) {
            dvec3 gradient;
            for (int i = 0; i < 3; ++i) {
                dvec3 step(0);
                step[i] = 1;
                gradient[i] = (value(p + step) - value(p - step)) / 2;
            }
            const dvec3 normal = -gradient; // as long as the slope is steep
            return 0.875 * 2 * glm::dot(normal, light) + 0.25 * value(p);
        },
        [&](const dvec3& p) { return referenceSample(scene, p)[3]; });
    expectDrawn("voglShade", "ball.tif -view 20 30 -light 3 0 4", truth, 45);
}

// ---- voglMirror

/// The scene of the program: a volume, a ball, a mirror below both.
class MirrorScene
{
public:
    MirrorScene(const Field& field, const Angles& angles, const dvec3& scale, const dvec3& ball,
                double degrees)
        : size_(field.size.x, field.size.y, field.size.z), scale_(scale), ball_(ball),
          view_(demoView(angles, size_, scale, 1.5, degrees)), mirrored_(view_)
    {
        const dvec3 sides = size_ * scale;
        radius_ = 0.2 * std::min({sides.x, sides.y, sides.z});
        mirrored_.model = multiply(view_.model, multiply(translation(0, 0, 2 * height()), scaling(1, 1, -1)));
        scene_ = sceneOf(field, rampTable(std::max({sides.x, sides.y, sides.z})), view_);
        scene_.period = 1.0 / scale;
        planes_ = referencePlanes(scene_);
        Scene mirroredScene = scene_;
        mirroredScene.view = mirrored_;
        mirroredPlanes_ = referencePlanes(mirroredScene);
    }

    dvec3 color(double x, double y) const
    {
        const Ray ray = rayThrough(view_, x, y), image = rayThrough(mirrored_, x, y);
        dvec3 rgb(0);
        const auto mirror = mirrorHit(ray);
        if (mirror) {
            const bool above = ray.along.z < 0;
            if (above) rgb = through(image, mirroredPlanes_, rgb, {});
            const double shown = above ? 0.5 : 0.0;
            rgb = rgb * shown + tile(ray.at(*mirror)) * (1 - shown);
        }
        return through(ray, planes_, rgb, mirror);
    }

    /// What a point of the window shows of surfaces.
    int thing(double x, double y) const
    {
        const Ray ray = rayThrough(view_, x, y);
        const auto mirror = mirrorHit(ray);
        int number = ballHit(ray) ? 1 : 0;
        if (!mirror) return number;
        if (ballHit(rayThrough(mirrored_, x, y))) number += 2;
        return number + 4 * (1 + tileNumber(ray.at(*mirror)));
    }

private:
    double height() const { return -0.1 * size_.z; }

    std::optional<double> mirrorHit(const Ray& ray) const
    {
        const double place = (height() - ray.start.z) / ray.along.z;
        const dvec3 point = ray.at(place) / size_;
        const bool hit = place >= 0 && place <= 1 && std::min(point.x, point.y) >= -0.25 &&
                         std::max(point.x, point.y) <= 1.25;
        return hit ? std::optional(place) : std::nullopt;
    }

    int tileNumber(const dvec3& point) const
    {
        const dvec3 place = (point / size_ + 0.25) / 1.5 * 8.0;
        return int(std::floor(place.x)) * 8 + int(std::floor(place.y));
    }

    dvec3 tile(const dvec3& point) const
    {
        const int number = tileNumber(point);
        return (number / 8 + number % 8) % 2 ? dvec3(0.3, 0.35, 0.4) : dvec3(0.1, 0.12, 0.15);
    }

    /// The first point of the ball, whose space is scaled.
    std::optional<double> ballHit(const Ray& ray) const
    {
        const dvec3 from = (ray.start - ball_) * scale_, along = ray.along * scale_;
        const double a = glm::dot(along, along), b = glm::dot(from, along),
                     c = glm::dot(from, from) - radius_ * radius_;
        const double root = b * b - a * c;
        return root > 0 ? std::optional((-b - std::sqrt(root)) / a) : std::nullopt;
    }

    dvec3 ballColor(const dvec3& point) const
    {
        const dvec3 normal = (point - ball_) * scale_ / radius_;
        const double bright = 0.25 + 0.75 * std::max(glm::dot(normal, dvec3(-0.48, -0.6, 0.64)), 0.0);
        return bright * dvec3(1, 0.4, 0.15);
    }

    /// The ball and the volume before `behind`, at `end` of the ray if it ends there.
    dvec3 through(const Ray& ray, const ReferencePlanes& planes, const dvec3& behind,
                  std::optional<double> end) const
    {
        dvec3 rgb = behind;
        if (const auto hit = ballHit(ray); hit && (!end || *hit < *end)) {
            rgb = ballColor(ray.at(*hit));
            end = hit;
        }
        alongRay(ray, planes, [&](const dvec3& point, double place) {
            const bool inside =
                glm::all(glm::greaterThan(point, dvec3(0))) && glm::all(glm::lessThan(point, size_));
            if (inside && (!end || place < *end)) over(rgb, referenceSample(scene_, point));
        });
        return rgb;
    }

    dvec3 size_, scale_, ball_;
    double radius_ = 0;
    View view_, mirrored_;
    Scene scene_;
    ReferencePlanes planes_, mirroredPlanes_;
};

struct MirrorCase
{
    const char* words;
    Angles angles;
    dvec3 ball, scale{1, 1, 1};
    double degrees = 0;
};

TEST_F(Passes, mirrorShowsTheSceneFromBelow)
{
    const Field field = blob({28, 26, 24}, 1);
    write("volume.tif", field);
    for (const MirrorCase& c :
         {MirrorCase{"-view -25 30 -sphere 14 13 8 -perspective 40", {-25, 30}, {14, 13, 8}, {1, 1, 1}, 40},
          MirrorCase{
              "-view -35 200 -sphere 4 -2 4 -scale 1 1.25 1.5", {-35, 200}, {4, -2, 4}, {1, 1.25, 1.5}},
          MirrorCase{"-view 30 30 -sphere 20 2 3", {30, 30}, {20, 2, 3}}}) {
        const MirrorScene scene(field, c.angles, c.scale, c.ball, c.degrees);
        expectDrawn("voglMirror", "volume.tif " + std::string(c.words),
                    pictureOf([&](double x, double y) { return scene.color(x, y); },
                              [&](double x, double y) { return scene.thing(x, y); }));
    }
}

// ---- All

TEST_F(Passes, tenFramesComeAndLeaveNothing)
{
    write("volume.tif", blob({16, 14, 12}, 1));
    vo::writeBytes(folder / "tags.tif", 16, 14, 12, [](int x, int, int) { return x / 4; });
    for (const char* words : {"voglTwo volume.tif volume.tif -offset 4 4 4", "voglTagged volume.tif tags.tif",
                              "voglRoam volume.tif", "voglShade volume.tif", "voglMirror volume.tif"}) {
        const std::string line = words;
        const auto space = line.find(' ');
        for (const char* more : {"", " -core -mip -wireframe -bricks 2 1 2 -space view"}) {
            const vo::ProgramRun run =
                folder.run(line.substr(0, space),
                           line.substr(space) + " -frames 10 -size 48 48 -output turn.png" + more);
            EXPECT_EQ(run.status, 0) << words << more << ": " << run.errors;
            EXPECT_EQ(run.errors, "") << words << more;
            EXPECT_NE(run.output.find("10 frames, median "), std::string::npos) << run.output;
            EXPECT_TRUE(std::filesystem::remove(folder / "turn.png")) << words;
        }
    }
}

TEST_F(Passes, wrongArgumentsAreNamedInOneLine)
{
    write("volume.tif", blob({16, 14, 12}, 1));
    write("small.tif", blob({12, 12, 12}, 1));
    vo::writeShorts(folder / "shorts.tif", 16, 14, 12, [](int x, int, int) { return x; });
    const auto before = folder.files();
    using Case = std::array<const char*, 3>;
    for (const auto& [program, words, named] :
         {Case{"voglTwo", "volume.tif", "expected the files of two volumes"},
          {"voglTwo", "volume.tif small.tif -offset 16 0 0", "-offset"},
          {"voglTwo", "volume.tif small.tif -spacing2 0 1 1", "-spacing2"},
          {"voglTwo", "volume.tif small.tif -lutFile2 missing.lut", "missing.lut"},
          {"voglTwo", "volume.tif small.tif -spacing2 1000 1000 1000 -sampling 0.01", "sampling planes"},
          {"voglJaw", "volume.tif", "expected the files of one volume and one surface"},
          {"voglJaw", "volume.tif missing.off", "missing.off"},
          {"voglTagged", "volume.tif small.tif", "small.tif"},
          {"voglTagged", "volume.tif shorts.tif", "shorts.tif"},
          {"voglTagged", "volume.tif volume.tif -table 256 a.lut", "-table"},
          {"voglTagged", "volume.tif volume.tif -table 0 missing.lut", "missing.lut"},
          {"voglTagged", "volume.tif volume.tif -table 255 missing.lut", "-table"},
          {"voglTagged", "volume.tif volume.tif -hide 255", "-hide"},
          {"voglRoam", "volume.tif -voi 1 2 3 0.5", "-voi"},
          {"voglRoam", "missing.tif", "missing.tif"},
          {"voglShade", "volume.tif -2D", "-2D"},
          {"voglShade", "volume.tif -shells", "-shells"},
          {"voglShade", "volume.tif -light 0 0 0", "-light"},
          {"voglMirror", "volume.tif -sphere 8 7 0", "-sphere"},
          {"voglMirror", "volume.tif -sphere 8 x 0", "-sphere"}}) {
        const vo::ProgramRun run = folder.run(program, "-output picture.png " + std::string(words));
        EXPECT_EQ(run.status, 1) << program << " " << words;
        EXPECT_NE(run.errors.find(named), std::string::npos) << words << ": " << run.errors;
        EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << words << ": " << run.errors;
        EXPECT_EQ(run.output, "") << words;
        EXPECT_EQ(folder.files(), before) << words;
    }
}

} // namespace
