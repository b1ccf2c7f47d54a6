#include "bench.h"

#include "cast/ray_cast.h"

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

/// Frames of the CPU engine: 256^3 bytes in 512 x 512 pixels, parallel projection that fits the diagonal,
/// azimuth 30, elevation 20, a sample a voxel. Arguments: seconds a case; a part of a case's name.

namespace {

constexpr int kPicture = 512;

struct Volume
{
    int edge = 256;
    std::vector<std::uint8_t> voxels;

    Volume(int size, const std::function<int(int, int, int)>& value) : edge(size)
    {
        voxels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) *
                       static_cast<std::size_t>(size));
        for (int z = 0; z < size; ++z)
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x)
                    voxels.push_back(static_cast<std::uint8_t>(value(x, y, z)));
    }
};

/// A volume in bricks of `split` along each axis, overlapping by one voxel.
struct Bricks
{
    std::vector<std::vector<std::uint8_t>> memory;
    std::vector<vo::CastBrick> bricks;
    std::vector<vo::Box> boxes;

    Bricks(const Volume& volume, int split)
    {
        const int n = volume.edge;
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

vo::Table ramp(double opacity)
{
    vo::Table table;
    for (int i = 0; i < 256; ++i) {
        const auto grey = static_cast<float>(i / 255.0);
        for (int c = 0; c < 3; ++c)
            table.rgba.push_back(grey);
        table.rgba.push_back(i < 64 ? 0.0f : static_cast<float>(opacity * (i - 63) / 192.0));
    }
    return table;
}

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

void run(const Options& options, const std::string& name, const Bricks& bricks, int edge,
         const vo::Table* table, vo::CastBlending blending, bool perspective = false)
{
    if (name.find(options.only) == std::string::npos) return;
    const Cube cube(edge);
    vo::CastRequest request;
    const double half = 0.5 * edge * std::sqrt(3.0);
    request.model = glm::rotate(glm::dmat4(1.0), glm::radians(20.0), glm::dvec3(1, 0, 0));
    request.model = glm::rotate(request.model, glm::radians(30.0), glm::dvec3(0, 1, 0));
    request.model = glm::translate(request.model, glm::dvec3(-0.5 * edge));
    request.projection = glm::ortho(-half, half, -half, half, -2 * half, 2 * half);
    if (perspective) {
        request.projection = glm::perspective(glm::radians(30.0), 1.0, 0.1 * half, 10 * half);
        request.model =
            glm::translate(glm::dmat4(1.0), glm::dvec3(0, 0, -half / std::sin(glm::radians(15.0)))) *
            request.model;
    }
    request.width = request.height = kPicture;
    request.tetras = {cube.records, 3, cube.indices};
    request.clipBoxes = bricks.boxes;
    request.bricks = bricks.bricks;
    request.sampling.period = glm::dvec3(1.0);
    request.sampling.maxSamples = 100000;
    request.shading.table = table;
    request.blending = blending;

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
            options.seconds);
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

} // namespace

int main(int argc, char** argv)
{
    Options options;
    if (argc > 1) options.seconds = std::atof(argv[1]);
    if (argc > 2) options.only = argv[2];
    const auto blob = [](int n, double radius) {
        return [n, radius](int x, int y, int z) {
            const double dx = x - 0.5 * n, dy = y - 0.5 * n, dz = z - 0.5 * n;
            const double r = std::sqrt(dx * dx + dy * dy + dz * dz) / (0.5 * n);
            const double wave = 0.5 + 0.5 * std::sin(0.15 * x) * std::sin(0.13 * y) * std::sin(0.17 * z);
            return static_cast<int>(255.0 * std::max(0.0, 1.0 - r / radius) * wave);
        };
    };
    const Volume sparse(256, blob(256, 1.0));
    const Volume cubes(256, [](int x, int y, int z) {
        return x % 64 < 38 && y % 64 < 38 && z % 64 < 38 ? 128 + (x + y + z) % 64 : 0;
    });
    const Volume dense(256, [](int x, int y, int z) { return 40 + (x * 7 + y * 13 + z * 29) % 200; });
    vo::Table thin, thinColor, bone;
    for (int i = 0; i < 256; ++i) {
        const auto grey = static_cast<float>(i / 255.0);
        thin.rgba.insert(thin.rgba.end(),
                         {grey, grey, grey, static_cast<float>((2.0 + 2.0 * i / 255.0) / 255.0)});
        thinColor.rgba.insert(thinColor.rgba.end(), {grey, 1.0f - grey, 0.5f, thin.rgba.back()});
    }
    const vo::Table soft = ramp(0.2), hard = ramp(1.0);
    using enum vo::CastBlending;
    const Bricks sparse1(sparse, 1), cubes1(cubes, 1), dense1(dense, 1), dense4(dense, 4);
    run(options, "sparse", sparse1, 256, &soft, over);
    run(options, "cubes", cubes1, 256, &soft, over);
    run(options, "dense", dense1, 256, &thin, over);
    run(options, "dense, perspective", dense1, 256, &thin, over, true);
    run(options, "dense, colours", dense1, 256, &thinColor, over);
    const Volume tiny(64, [](int x, int y, int z) { return 40 + (x * 7 + y * 13 + z * 29) % 200; });
    run(options, "tiny", Bricks(tiny, 1), 64, &thin, over);
    run(options, "dense, 64 bricks", dense4, 256, &thin, over);
    run(options, "opaque", sparse1, 256, &hard, over);
    run(options, "mip of sparse", sparse1, 256, nullptr, max);
    run(options, "mip of dense", dense1, 256, nullptr, max);
    run(options, "mip, table", sparse1, 256, &soft, max);
}
