#include "bench.h"
#include "bench_scene.h"

#include "cast/ray_cast.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <vector>

/// Frames of the CPU engine alone, of the scenes of ./dev bench. Arguments: seconds a case; a part of a
/// case's name.

namespace {

/// A volume in bricks of `split` along each axis, overlapping by one voxel.
struct Bricks
{
    std::vector<std::vector<std::uint8_t>> memory;
    std::vector<vo::CastBrick> bricks;
    std::vector<vo::Box> boxes;

    Bricks(const bench::Volume& volume, int split)
    {
        const int n = volume.side;
        const auto start = [&](int i) { return i * (n - 1) / split; };
        for (int z = 0; z < split; ++z)
            for (int y = 0; y < split; ++y)
                for (int x = 0; x < split; ++x) {
                    const glm::ivec3 lower(start(x), start(y), start(z));
                    const glm::ivec3 upper = glm::ivec3(start(x + 1), start(y + 1), start(z + 1)) + 1;
                    const glm::ivec3 size = upper - lower;
                    std::vector<std::uint8_t>& own = memory.emplace_back();
                    for (int k = lower.z; k < upper.z; ++k)
                        for (int j = lower.y; j < upper.y; ++j) {
                            const auto* row =
                                volume.voxels.data() + (static_cast<std::ptrdiff_t>(k) * n + j) * n;
                            own.insert(own.end(), row + lower.x, row + upper.x);
                        }
                    vo::CastBrick brick;
                    brick.id = memory.size();
                    brick.texels.size = {size.x, size.y, size.z};
                    brick.texels.format = {vo::Channels::intensity, vo::VoxelType::uint8};
                    brick.origin = lower;
                    brick.size = size;
                    bricks.push_back(brick);
                    boxes.push_back({glm::dvec3(lower) + 0.5, glm::dvec3(upper) - 0.5});
                }
        for (std::size_t i = 0; i < bricks.size(); ++i)
            bricks[i].texels.voxels = std::as_bytes(std::span(memory[i]));
    }
};

/// The five tetrahedra of a cube.
struct Cube
{
    std::vector<float> records;
    std::vector<int> indices{0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 6, 3, 4, 0, 5, 6, 7, 3, 6, 5};

    explicit Cube(int edge)
    {
        for (int corner = 0; corner < 8; ++corner)
            for (int axis = 0; axis < 3; ++axis)
                records.push_back(corner >> axis & 1 ? static_cast<float>(edge) : 0.0f);
    }
};

double cpuSeconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Options
{
    double seconds = 1.0;
    std::string only;
};

void time(const std::string& name, vo::CastRequest& request, double seconds)
{
    vo::RayCaster caster;
    vo::CastPicture picture;
    if (const std::string why = caster.refusal(request); !why.empty()) {
        std::printf("%s: %s\n", name.c_str(), why.c_str());
        return;
    }
    for (const int threads : {2, 1}) {
        request.threads = threads;
        long frames = 0;
        const double before = cpuSeconds();
        const bench::Timing timing = bench::measure(
            [&] {
                caster.cast(request, picture);
                ++frames;
            },
            seconds);
        const double cpu = (cpuSeconds() - before) / static_cast<double>(frames);
        double sum = 0.0;
        for (const float value : picture.rgbt)
            sum += std::abs(value) < 1e6f ? value : 0.0f;
        char text[80];
        std::snprintf(text, sizeof text, "%d thread%s, cpu %.1f ms, sum %.0f", threads,
                      threads > 1 ? "s" : "", 1e3 * cpu, sum);
        bench::printLine(name, text, timing);
    }
}

void run(const Options& options, const std::string& name, int bricksPerAxis = 1)
{
    const std::string shown = name + (bricksPerAxis > 1 ? ", bricks" : "");
    if (shown.find(options.only) == std::string::npos) return;
    const bench::Scene scene = bench::sceneNamed(name);
    const bench::Volume volume = bench::makeVolume(scene.volume, scene.side);
    const bench::Table entries = bench::makeTable(scene.table, volume, scene.visible);
    vo::Table table;
    for (const auto& entry : entries)
        table.rgba.insert(table.rgba.end(), entry.begin(), entry.end());
    const Bricks bricks(volume, bricksPerAxis);
    const Cube cube(scene.side);
    const bench::Viewer viewer = bench::viewerOf(scene);

    vo::CastRequest request;
    request.model = glm::make_mat4(viewer.view.model.data());
    request.projection = glm::make_mat4(viewer.view.projection.data());
    request.width = request.height = bench::kPictureSide;
    request.tetras = {cube.records, 3, cube.indices};
    request.clipBoxes = bricks.boxes;
    request.bricks = bricks.bricks;
    request.sampling.period = glm::dvec3(1.0);
    request.sampling.maxSamples = 100000;
    request.shading.table = &table;
    if (!scene.maximum) request.opacityGauge = glm::dmat3(1.0);
    request.blending = scene.maximum ? vo::CastBlending::max : vo::CastBlending::over;
    time(shown, request, options.seconds);
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    if (argc > 1) options.seconds = std::atof(argv[1]);
    if (argc > 2) options.only = argv[2];
    for (const std::string& name : bench::sceneNames())
        run(options, name);
    for (const char* name : {"sparse/perspective", "cubes/perspective", "dense/perspective", "dense@64"})
        run(options, name);
    run(options, "dense", 4);
}
