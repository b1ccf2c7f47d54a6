#include "bench_scene.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <system_error>
#include <unistd.h>

namespace bench {

namespace {

/// The same numbers on every machine: those of <random>'s distributions differ by library.
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint32_t next()
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::uint32_t>(state_ >> 32);
    }
    double between(double low, double high) { return low + (high - low) * (next() / 4294967296.0); }

private:
    std::uint64_t state_;
};

std::uint8_t toByte(double value)
{
    return static_cast<std::uint8_t>(std::clamp(value, 0.0, 1.0) * 255.0 + 0.5);
}

std::size_t indexIn(const Volume& volume, int x, int y, int z)
{
    const auto side = static_cast<std::size_t>(volume.side);
    return static_cast<std::size_t>(x) +
           side * (static_cast<std::size_t>(y) + side * static_cast<std::size_t>(z));
}

/// value(x, y, z) of the voxel's number.
template <class Value>
void fill(Volume& volume, const Value& value)
{
    std::size_t i = 0;
    for (int z = 0; z < volume.side; ++z)
        for (int y = 0; y < volume.side; ++y)
            for (int x = 0; x < volume.side; ++x)
                volume.voxels[i++] = toByte(value(x, y, z));
}

/// Raises voxels to 1 - (distance / radius)^2 round a point.
void addBall(Volume& volume, const std::array<double, 3>& centre, double radius)
{
    std::array<int, 3> first{}, last{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        first[axis] = std::max(0, static_cast<int>(std::ceil(centre[axis] - 0.5 - radius)));
        last[axis] = std::min(volume.side - 1, static_cast<int>(std::floor(centre[axis] - 0.5 + radius)));
    }
    for (int z = first[2]; z <= last[2]; ++z)
        for (int y = first[1]; y <= last[1]; ++y)
            for (int x = first[0]; x <= last[0]; ++x) {
                const double dx = x + 0.5 - centre[0], dy = y + 0.5 - centre[1], dz = z + 0.5 - centre[2];
                const double value = 1.0 - (dx * dx + dy * dy + dz * dz) / (radius * radius);
                std::uint8_t& voxel = volume.voxels[indexIn(volume, x, y, z)];
                if (value > 0.0) voxel = std::max(voxel, toByte(value));
            }
}

void fillVessels(Volume& volume)
{
    const double unit = volume.side / 256.0;
    Random random(12);
    for (int vessel = 0; vessel < 90; ++vessel) {
        std::array<double, 3> place{}, heading{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            place[axis] = volume.side * random.between(0.15, 0.85);
            heading[axis] = random.between(-1.0, 1.0);
        }
        double radius = unit * random.between(4.0, 11.0);
        for (double gone = 0.0; gone < 260.0 * unit; gone += 0.4 * radius, radius *= 0.996) {
            const double length = std::hypot(heading[0], heading[1], heading[2]);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                heading[axis] = heading[axis] / length + random.between(-0.25, 0.25);
                place[axis] += heading[axis] * 0.4 * radius;
                const double margin = 0.06 * volume.side;
                if (place[axis] < margin) heading[axis] = std::abs(heading[axis]);
                if (place[axis] > volume.side - margin) heading[axis] = -std::abs(heading[axis]);
            }
            addBall(volume, place, radius);
        }
    }
}

void fillCubes(Volume& volume)
{
    const int period = volume.side / 8;
    const int width = period * 19 / 32;
    const int start = (period - width) / 2;
    fill(volume, [&](int x, int y, int z) {
        const auto inside = [&](int i) { return i % period >= start && i % period < start + width; };
        if (!inside(x) || !inside(y) || !inside(z)) return 0.0;
        const int cube = x / period + 8 * (y / period) + 64 * (z / period);
        return (128.0 + (cube * 37) % 128) / 255.0;
    });
}

void fillFog(Volume& volume)
{
    Random random(34);
    const double wave = 2.0 * std::numbers::pi / volume.side;
    fill(volume, [&](int x, int y, int z) {
        const double smooth =
            std::sin(3.0 * wave * x) * std::sin(2.0 * wave * y + 1.0) + std::sin(4.0 * wave * z + wave * x);
        return 0.5 + 0.2 * smooth + random.between(-0.08, 0.08);
    });
}

void fillSkull(Volume& volume)
{
    const double half = 0.5 * volume.side;
    const double wave = 16.0 * std::numbers::pi / volume.side;
    fill(volume, [&](int x, int y, int z) {
        const double dx = (x + 0.5 - half) / half, dy = (y + 0.5 - half) / half, dz = (z + 0.5 - half) / half;
        const double distance = std::sqrt(1.4 * dx * dx + dy * dy + 1.2 * dz * dz);
        const double bumps =
            std::sin(wave * x) * std::sin(wave * y) + std::sin(wave * y) * std::sin(wave * z);
        const double shell = 1.1 - std::abs(distance - 0.82) / 0.09 + 0.25 * bumps;
        const double soft = distance < 0.95 ? 0.3 + 0.1 * bumps : 0.0;
        return std::max(shell, soft);
    });
}

/// The lowest value at and above which at most `share` of the voxels lie; at least 1.
int valueOfShare(const Volume& volume, double share)
{
    std::array<std::size_t, 256> counts{};
    for (const std::uint8_t voxel : volume.voxels)
        ++counts[voxel];
    const double wanted = share * static_cast<double>(volume.voxels.size());
    std::size_t above = 0;
    for (int value = 255; value >= 1; --value) {
        above += counts[static_cast<std::size_t>(value)];
        if (static_cast<double>(above) > wanted) return std::min(value + 1, 255);
    }
    return 1;
}

std::array<float, 4> entryOf(double red, double green, double blue, double alpha)
{
    return {static_cast<float>(red), static_cast<float>(green), static_cast<float>(blue),
            static_cast<float>(alpha)};
}

/// `side` bytes cubed, or nothing when the file is absent or of another size.
bool readVolume(const std::filesystem::path& path, Volume& volume)
{
    std::error_code error;
    if (std::filesystem::file_size(path, error) != volume.voxels.size() || error) return false;
    std::ifstream file(path, std::ios::binary);
    return static_cast<bool>(file.read(reinterpret_cast<char*>(volume.voxels.data()),
                                       static_cast<std::streamsize>(volume.voxels.size())));
}

} // namespace

Volume makeVolume(const std::string& name, int side)
{
    if (side < 32 || side > 2048)
        throw std::invalid_argument("a volume's side is 32 to 2048, not " + std::to_string(side));
    Volume volume;
    volume.side = side;
    volume.voxels.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                         static_cast<std::size_t>(side));
    if (name == "vessels")
        fillVessels(volume);
    else if (name == "cubes")
        fillCubes(volume);
    else if (name == "fog")
        fillFog(volume);
    else if (name == "skull")
        fillSkull(volume);
    else
        throw std::invalid_argument("no volume is called '" + name + "'");
    return volume;
}

Volume cachedVolume(const std::string& name, int side, const std::filesystem::path& folder)
{
    Volume volume;
    volume.side = side;
    volume.voxels.resize(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) *
                         static_cast<std::size_t>(side));
    const std::filesystem::path path = folder / (name + "-" + std::to_string(side) + ".raw");
    if (readVolume(path, volume)) return volume;
    volume = makeVolume(name, side);
    std::filesystem::create_directories(folder);
    std::filesystem::path part = path;
    part += ".part" + std::to_string(getpid());
    std::ofstream(part, std::ios::binary)
        .write(reinterpret_cast<const char*>(volume.voxels.data()),
               static_cast<std::streamsize>(volume.voxels.size()));
    std::filesystem::rename(part, path);
    return volume;
}

Table makeTable(const std::string& name, const Volume& volume, double visible)
{
    Table table{};
    const int threshold = name == "sparse" ? valueOfShare(volume, visible) : 0;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        std::array<float, 4>& entry = table[static_cast<std::size_t>(i)];
        if (name == "sparse") {
            const double above = std::max(0, i - threshold + 1) / static_cast<double>(256 - threshold);
            entry = entryOf(0.9, 0.25 + 0.6 * v, 0.8 * v * v, i < threshold ? 0.0 : 0.01 + 0.14 * above);
        } else if (name == "dense") {
            entry = entryOf(v, 0.5 + 0.5 * std::sin(5.0 * v), 1.0 - v, (2.0 + 2.0 * v) / 255.0);
        } else if (name == "bone") {
            entry = entryOf(0.95, 0.55 + 0.4 * v, 0.4 + 0.5 * v, std::clamp((v - 0.5) / 0.17, 0.0, 1.0));
        } else if (name == "grey") {
            entry = entryOf(v, v, v, 1.0);
        } else {
            throw std::invalid_argument("no table is called '" + name + "'");
        }
    }
    return table;
}

namespace {

const std::array<Scene, 6> kScenes{{
    {.name = "sparse", .volume = "vessels", .table = "sparse", .visible = 0.12},
    {.name = "cubes", .volume = "cubes", .table = "sparse", .visible = 0.25},
    {.name = "dense", .volume = "fog", .table = "dense"},
    {.name = "bone", .volume = "skull", .table = "bone"},
    {.name = "mip", .volume = "vessels", .table = "grey", .maximum = true},
    {.name = "mip-dense", .volume = "fog", .table = "grey", .maximum = true},
}};

} // namespace

std::vector<std::string> sceneNames()
{
    std::vector<std::string> names;
    for (const Scene& scene : kScenes)
        names.push_back(scene.name);
    return names;
}

Scene sceneNamed(const std::string& name)
{
    const std::string stem = name.substr(0, name.find_first_of("/@"));
    const auto found = std::ranges::find(kScenes, stem, &Scene::name);
    if (found == kScenes.end()) throw std::invalid_argument("no scene is called '" + name + "'");
    Scene scene = *found;
    std::string rest = name.substr(stem.size());
    if (rest.starts_with("@")) {
        std::size_t digits = 0;
        scene.side = std::stoi(rest.substr(1), &digits);
        rest = rest.substr(1 + digits);
    }
    if (rest == "/perspective")
        scene.perspective = true;
    else if (!rest.empty())
        throw std::invalid_argument("'" + rest + "' says nothing of a scene; '/perspective' or '@SIDE' does");
    scene.name = name;
    return scene;
}

Viewer viewerOf(const Scene& scene, double turn)
{
    using namespace vo::test;
    constexpr double kAzimuth = 30.0, kElevation = 20.0;
    const double degree = std::numbers::pi / 180.0;
    const double azimuth = (kAzimuth + turn) * degree, elevation = kElevation * degree;
    Viewer viewer;
    viewer.centre = 0.5 * scene.side;
    viewer.radius = 0.5 * std::sqrt(3.0) * scene.side;
    viewer.direction = {std::cos(elevation) * std::sin(azimuth), std::sin(elevation),
                        std::cos(elevation) * std::cos(azimuth)};
    viewer.distance =
        scene.perspective ? viewer.radius / std::sin(0.5 * kViewAngle * degree) : 2.0 * viewer.radius;
    const double near = viewer.distance - 1.01 * viewer.radius, far = viewer.distance + 1.01 * viewer.radius;
    viewer.view.projection =
        scene.perspective ? perspective(kViewAngle, 1.0, near, far)
                          : ortho(-viewer.radius, viewer.radius, -viewer.radius, viewer.radius, near, far);
    const Matrix turned = multiply(rotation(kElevation, 1, 0, 0), rotation(-(kAzimuth + turn), 0, 1, 0));
    viewer.view.model = multiply(multiply(translation(0, 0, -viewer.distance), turned),
                                 translation(-viewer.centre, -viewer.centre, -viewer.centre));
    return viewer;
}

Tetras makeTetras(int cells, double side)
{
    Tetras tetras;
    Random random(56);
    const double cell = side / cells;
    const int row = cells + 1;
    const auto place = [&](int i) {
        const double jitter = i == 0 || i == cells ? 0.0 : random.between(-0.1, 0.1);
        return static_cast<float>(cell * (i + jitter));
    };
    for (int z = 0; z <= cells; ++z)
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x)
                for (const int i : {x, y, z})
                    tetras.positions.push_back(place(i));
    // Corners as bits x, y, z; the other cut of a cell is its mirror image.
    constexpr int kCut[5][4] = {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}};
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                for (const auto& tetra : kCut)
                    for (const int corner : tetra) {
                        const int bits = (x + y + z) % 2 ? corner ^ 1 : corner;
                        tetras.indices.push_back(x + (bits & 1) +
                                                 row * (y + (bits >> 1 & 1) + row * (z + (bits >> 2))));
                    }
    return tetras;
}

} // namespace bench
