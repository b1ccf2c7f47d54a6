// Deformed volumes of 256^3 bytes in 512 x 512 pixels: polygons filled by the CPU engine beside the same
// frame drawn by OpenGL (with its textures resident and its polygons kept). Wall and CPU milliseconds,
// medians.
//   fill_bench [PATTERN [ROUNDS [SIZE]]]

#include "cast/fill_scene.h"
#include "draw/draw_scene.h"
#include "support/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <optional>
#include <string>

namespace {

using namespace vo;
using namespace vo::test;

double seconds(clockid_t clock)
{
    timespec now{};
    clock_gettime(clock, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Times
{
    std::vector<double> wall, cpu;

    void add(const std::function<void()>& work)
    {
        const double wallStart = seconds(CLOCK_MONOTONIC), cpuStart = seconds(CLOCK_PROCESS_CPUTIME_ID);
        work();
        wall.push_back(1e3 * (seconds(CLOCK_MONOTONIC) - wallStart));
        cpu.push_back(1e3 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - cpuStart));
    }
};

double median(std::vector<double> values)
{
    std::ranges::sort(values);
    return values[values.size() / 2];
}

void print(const char* name, const char* who, const Times& times)
{
    std::printf("%-22s %-18s wall %8.1f ms  (least %8.1f)  cpu %8.1f ms\n", name, who, median(times.wall),
                *std::ranges::min_element(times.wall), median(times.cpu));
}

/// Every voxel visible, or a twelfth or so.
Field volumeOf(int size, bool dense)
{
    const double period = 40.0 * size / 256.0;
    return quantised(fieldOf({size, size, size}, [&](const glm::dvec3& p) {
        const double waves =
            std::sin(p.x / period) * std::sin(p.y / period + 1.0) * std::sin(p.z / period + 2.0);
        return dense ? 0.5 + 0.5 * waves : std::max(0.0, 2.0 * waves - 0.9);
    }));
}

std::vector<float> tableOf(double opacity)
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        for (const double entry : {v, 0.5 + 0.5 * std::sin(6.0 * v), 1.0 - v, opacity * v})
            table.push_back(static_cast<float>(entry));
    }
    return table;
}

Deformation bend(int size, int cells)
{
    const double middle = 0.5 * size;
    return {cells, [middle](const glm::dvec3& voxel) {
                const glm::dvec3 p = (voxel - middle) / middle;
                const double angle = 0.8 * p.z;
                return middle + middle * glm::dvec3(p.x * std::cos(angle) - p.y * std::sin(angle),
                                                    p.x * std::sin(angle) + p.y * std::cos(angle), p.z);
            }};
}

struct Case
{
    const char* name;
    int cells; ///< 0: in its place
    int bricks = 1;
    bool dense = true;
    double opacity = 0.02;
    double degrees = 0.0;
    int colors = 0;
    CastBlending blending = CastBlending::over;
};

struct Run
{
    int rounds = 7;
    int size = 256;
};

void runCase(const Case& c, const Run& run)
{
    const Field field = volumeOf(run.size, c.dense);
    Scene scene;
    scene.volume = &field;
    scene.width = scene.height = 512;
    scene.overlap = 1;
    scene.classification = Classification::postInterpolation;
    scene.table = tableOf(c.opacity);
    const Angles angles{20, 30};
    scene.view = c.degrees > 0.0 ? perspectiveView(angles, field.size, 512, 512, c.degrees)
                                 : orthographicView(angles, field.size, 512, 512);
    if (c.blending == CastBlending::max) scene.compositing = Compositing::max;
    FillOptions options{.bricks = c.bricks, .colorChannels = c.colors, .blending = c.blending};
    if (c.cells > 0) options.deformation = bend(run.size, c.cells);
    FillScene fill(scene, options);

    setenv("VO_ENGINE", "slices", 1);
    const auto context = openFor(scene, OffscreenProfile::Compatibility);
    DrawOptions drawOptions;
    drawOptions.utility = true;
    drawOptions.bricks = c.bricks;
    SceneDrawing drawing(*context, scene, drawOptions);
    drawing.draw(); // leaves the scene's state behind
    const TetraView& view = fill.request().tetras;
    std::vector<float> records(view.records.begin(), view.records.end());
    std::vector<int> indices(view.indices.begin(), view.indices.end());
    voIndexedTetraSet tetras(records.data(), static_cast<int>(records.size()) / view.valuesPerVertex,
                             view.valuesPerVertex, indices.data(), static_cast<int>(indices.size()));
    float period[3] = {1, 1, 1};
    using Format = voInterleavedArrayTypeScope;
    const voInterleavedArrayType format = c.cells > 0 ? (c.colors ? Format::T3F_C4F_V3F : Format::T3F_V3F)
                                                      : (c.colors ? Format::C4F_V3F : Format::V3F);
    const auto drawSlices = [&] {
        context->gl().Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        voGeometryActions::drawUtility(&tetras, format, &drawing.volume(), nullptr,
                                       voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
        context->gl().Finish();
    };
    CastPicture picture;
    const auto fillWith = [&](int threads) {
        fill.request().threads = threads;
        picture = fill.fill();
    };
    drawSlices();
    const Comparison apart = compareDrawn(fill.drawn(), context->readFloats());
    Times one, two, slices;
    for (int round = 0; round < run.rounds; ++round) {
        two.add([&] { fillWith(2); });
        one.add([&] { fillWith(1); });
        slices.add(drawSlices);
    }
    print(c.name, "fill, 2 threads", two);
    print(c.name, "fill, 1 thread", one);
    print(c.name, "slices, OpenGL", slices);
    std::printf("%-22s apart: %s\n", c.name, apart.summary().c_str());
}

} // namespace

int main(int argc, char** argv)
{
    const std::string pattern = argc > 1 ? argv[1] : "";
    Run run;
    if (argc > 2) run.rounds = std::max(1, std::atoi(argv[2]));
    if (argc > 3) run.size = std::max(8, std::atoi(argv[3]));
    const Case cases[] = {
        {.name = "deformed", .cells = 3},
        {.name = "deformed-sparse", .cells = 3, .dense = false},
        {.name = "deformed-opaque", .cells = 3, .opacity = 0.5},
        {.name = "deformed-perspective", .cells = 3, .degrees = 40},
        {.name = "deformed-fine", .cells = 16},
        {.name = "deformed-bricks", .cells = 3, .bricks = 4},
        {.name = "deformed-max", .cells = 3, .blending = CastBlending::max},
        {.name = "coloured", .cells = 0, .colors = 4},
        {.name = "in-place", .cells = 0},
    };
    for (const Case& c : cases)
        if (std::strstr(c.name, pattern.c_str())) runCase(c, run);
    return 0;
}
