// What a scene should look like, in double precision: the integral along the ray through the centre of every
// STRIDE-th pixel of every STRIDE-th row, with steps of 1/8 voxel, and beside it the sum over samples where
// the slices lie, one a voxel.
//
//     ray_integral SCENE FOLDER-OF-VOLUMES STRIDE OUTPUT
//     ray_integral --volumes FOLDER-OF-VOLUMES
//
// The second form only makes the volumes that the other programs read, and beside one of them what a program
// needs that opens files: a header (NRRD) and the table of the scene `sparse`.
//
// OUTPUT gets, for those pixels from the bottom row on, four doubles of the integral (red, green, blue,
// opacity, premultiplied), then four of the sum over slices.
#include "bench_scene.h"
#include "bench_worker.h"

#include "support/reference.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <atomic>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace {

constexpr double kStep = 1.0 / 8.0;

struct Ray
{
    glm::dvec3 start{0.0};
    glm::dvec3 along{0.0}; ///< of length 1, away from the viewer
};

class Integral
{
public:
    Integral(const bench::Scene& scene, const bench::Volume& volume)
        : scene_(scene), volume_(volume), table_(bench::makeTable(scene.table, volume, scene.visible)),
          viewer_(bench::viewerOf(scene))
    {
        vo::test::Field sizes;
        sizes.size = {scene.side, scene.side, scene.side};
        vo::test::Scene planes;
        planes.volume = &sizes;
        planes.view = viewer_.view;
        planes.width = planes.height = bench::kPictureSide;
        planes_ = vo::test::referencePlanes(planes);
        right_ = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), direction()));
        up_ = glm::cross(direction(), right_);
    }

    Ray rayThrough(int x, int y) const
    {
        const auto place = [](int i) { return (i + 0.5) / bench::kPictureSide * 2.0 - 1.0; };
        const glm::dvec3 centre(viewer_.centre);
        const glm::dvec3 eye = centre + viewer_.distance * direction();
        if (!scene_.perspective)
            return {eye + viewer_.radius * (place(x) * right_ + place(y) * up_), -direction()};
        const double half = std::tan(0.5 * bench::kViewAngle * std::acos(-1.0) / 180.0);
        return {eye, glm::normalize(-direction() + half * (place(x) * right_ + place(y) * up_))};
    }

    /// Middle of steps of at most 1/8 voxel, each with its length's opacity.
    glm::dvec4 integral(const Ray& ray) const
    {
        double enter = 0.0, leave = 0.0;
        if (!crossBox(ray, enter, leave)) return glm::dvec4(0.0);
        const int count = std::max(1, static_cast<int>(std::ceil((leave - enter) / kStep)));
        const double step = (leave - enter) / count;
        Sum sum(scene_.maximum);
        for (int i = 0; i < count; ++i)
            sum.add(fragmentAt(ray.start + (enter + (i + 0.5) * step) * ray.along, step));
        return sum.value;
    }

    glm::dvec4 slices(const Ray& ray) const
    {
        double enter = 0.0, leave = 0.0;
        if (!crossBox(ray, enter, leave)) return glm::dvec4(0.0);
        const double slope = glm::dot(planes_.normal, ray.along);
        const double start = glm::dot(planes_.normal, ray.start);
        const double spacing =
            planes_.offsets.size() > 1 ? std::abs(planes_.offsets[1] - planes_.offsets[0]) : 1.0;
        Sum sum(scene_.maximum);
        for (auto offset = planes_.offsets.rbegin(); offset != planes_.offsets.rend(); ++offset) {
            const double place = (*offset - start) / slope;
            if (place < enter - 1e-9 || place > leave + 1e-9) continue;
            sum.add(fragmentAt(ray.start + place * ray.along, spacing / std::abs(slope)));
        }
        return sum.value;
    }

private:
    /// From the nearest sample on; colours come premultiplied.
    struct Sum
    {
        explicit Sum(bool isMaximum) : maximum(isMaximum) {}
        void add(const glm::dvec4& fragment)
        {
            value = maximum ? glm::max(value, fragment) : value + (1.0 - value.a) * fragment;
        }
        bool maximum;
        glm::dvec4 value{0.0};
    };

    glm::dvec3 direction() const
    {
        return {viewer_.direction[0], viewer_.direction[1], viewer_.direction[2]};
    }

    bool crossBox(const Ray& ray, double& enter, double& leave) const
    {
        enter = 0.0;
        leave = 1e9;
        for (int axis = 0; axis < 3; ++axis) {
            if (ray.along[axis] == 0.0) continue;
            const double a = (0.5 - ray.start[axis]) / ray.along[axis];
            const double b = (scene_.side - 0.5 - ray.start[axis]) / ray.along[axis];
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        return enter < leave;
    }

    double valueAt(const glm::dvec3& point) const
    {
        std::size_t low[3], step[3] = {1, 0, 0};
        double weight[3];
        const auto side = static_cast<std::size_t>(volume_.side);
        step[1] = side;
        step[2] = side * side;
        for (int axis = 0; axis < 3; ++axis) {
            const double place = std::clamp(point[axis] - 0.5, 0.0, static_cast<double>(volume_.side - 1));
            low[axis] = std::min(static_cast<std::size_t>(place), side - 2);
            weight[axis] = place - static_cast<double>(low[axis]);
        }
        const std::uint8_t* voxel = volume_.voxels.data() + low[0] + low[1] * step[1] + low[2] * step[2];
        double layers[2];
        for (std::size_t z = 0; z < 2; ++z) {
            double rows[2];
            for (std::size_t y = 0; y < 2; ++y) {
                const std::uint8_t* pair = voxel + y * step[1] + z * step[2];
                rows[y] = pair[0] + weight[0] * (pair[1] - pair[0]);
            }
            layers[z] = rows[0] + weight[1] * (rows[1] - rows[0]);
        }
        return layers[0] + weight[2] * (layers[1] - layers[0]);
    }

    /// Premultiplied, of a stretch of so many voxels.
    glm::dvec4 fragmentAt(const glm::dvec3& point, double length) const
    {
        const double value = valueAt(point);
        const auto below = std::min(static_cast<std::size_t>(value), std::size_t{254});
        const double weight = value - static_cast<double>(below);
        glm::dvec4 entry(0.0);
        for (std::size_t column = 0; column < 4; ++column) {
            const double a = static_cast<double>(table_[below][column]),
                         b = static_cast<double>(table_[below + 1][column]);
            entry[static_cast<int>(column)] = a + weight * (b - a);
        }
        if (scene_.maximum) return entry;
        const double opacity = entry.a > 0.0 ? 1.0 - std::pow(1.0 - entry.a, length) : 0.0;
        return {opacity * entry.r, opacity * entry.g, opacity * entry.b, opacity};
    }

    bench::Scene scene_;
    const bench::Volume& volume_;
    bench::Table table_;
    bench::Viewer viewer_;
    vo::test::ReferencePlanes planes_;
    glm::dvec3 right_{0.0};
    glm::dvec3 up_{0.0};
};

void makeFiles(const std::filesystem::path& folder)
{
    for (const std::string& name : bench::sceneNames()) {
        const bench::Scene scene = bench::sceneNamed(name);
        bench::cachedVolume(scene.volume, scene.side, folder);
    }
    const bench::Scene scene = bench::sceneNamed("sparse");
    const std::string stem = scene.volume + "-" + std::to_string(scene.side);
    std::ofstream header(folder / (stem + ".nhdr"));
    header << "NRRD0004\ntype: uchar\ndimension: 3\nsizes: " << scene.side << ' ' << scene.side << ' '
           << scene.side << "\nencoding: raw\ndata file: " << stem << ".raw\n";
    const bench::Volume volume = bench::cachedVolume(scene.volume, scene.side, folder);
    std::ofstream table(folder / (scene.table + ".lut"));
    table << std::fixed;
    for (const auto& [red, green, blue, alpha] : bench::makeTable(scene.table, volume, scene.visible))
        table << red << ' ' << green << ' ' << blue << ' ' << alpha << '\n';
    if (!header.flush() || !table.flush()) throw std::runtime_error("cannot write into " + folder.string());
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() == 2 && arguments[0] == "--volumes") {
        makeFiles(arguments[1]);
        return 0;
    }
    if (arguments.size() != 4)
        throw std::invalid_argument("arguments: SCENE FOLDER-OF-VOLUMES STRIDE OUTPUT");
    const bench::Scene scene = bench::sceneNamed(arguments[0]);
    const int stride = std::stoi(arguments[2]);
    if (stride < 1 || stride > bench::kPictureSide)
        throw std::invalid_argument("a stride is 1 to 512, not " + arguments[2]);
    const bench::Volume volume = bench::cachedVolume(scene.volume, scene.side, arguments[1]);
    const Integral integral(scene, volume);
    const int count = (bench::kPictureSide + stride - 1) / stride;
    const auto pixels = static_cast<std::size_t>(count) * static_cast<std::size_t>(count);
    std::vector<glm::dvec4> values(2 * pixels);
    std::atomic<int> next{0};
    const auto rows = [&] {
        for (int row; (row = next++) < count;)
            for (int column = 0; column < count; ++column) {
                const Ray ray = integral.rayThrough(stride * column, stride * row);
                const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(count) +
                                      static_cast<std::size_t>(column);
                values[i] = integral.integral(ray);
                values[pixels + i] = integral.slices(ray);
            }
    };
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(rows);
    threads.clear();
    std::ofstream file(arguments[3], std::ios::binary);
    file.write(reinterpret_cast<const char*>(values.data()),
               static_cast<std::streamsize>(values.size() * sizeof(glm::dvec4)));
    if (!file.flush()) throw std::runtime_error("cannot write " + arguments[3]);
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
