// VolPack: frames of a scene by its shear-warp factorization of the classified volume, in one thread.
//
// It classifies voxels before interpolation, keeps opacities in 8 bits and draws into 8 bits. Opacities are
// those of the distance of its slices along the line of sight, so that they are per length, as in the others.
#include "bench_scene.h"
#include "bench_worker.h"

#include <volpack.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace {

void expect(vpContext* context, vpResult result, const char* call)
{
    if (result != VP_OK)
        throw std::runtime_error(std::string(call) + ": " + vpGetErrorString(vpGetError(context)));
}

class ShearWarp
{
public:
    ShearWarp(const bench::Scene& scene, const bench::Volume& volume)
        : scene_(scene), context_(vpCreateContext()),
          image_(4 * static_cast<std::size_t>(bench::kPictureSide) * bench::kPictureSide)
    {
        if (scene.perspective || scene.maximum)
            throw std::invalid_argument("VolPack has neither perspective nor maxima");
        setVolume(volume);
        setTables(volume);
        setPicture();
        const double begin = bench::clocks().wall;
        expect(context_, vpClassifyVolume(context_), "vpClassifyVolume");
        classification_ = bench::clocks().wall - begin;
    }
    ~ShearWarp() { vpDestroyContext(context_); }
    ShearWarp(const ShearWarp&) = delete;
    ShearWarp& operator=(const ShearWarp&) = delete;

    void draw(double turn)
    {
        setView(turn);
        expect(context_, vpRenderClassifiedVolume(context_), "vpRenderClassifiedVolume");
    }

    std::vector<float> picture()
    {
        draw(0.0);
        std::vector<float> pixels;
        for (const unsigned char byte : image_)
            pixels.push_back(static_cast<float>(byte) / 255.0f);
        return pixels;
    }

    double classification() const { return classification_; }

private:
    /// The number of its colour, which VolPack wants in 16 bits, and of its opacity.
    struct Voxel
    {
        std::uint16_t color;
        std::uint8_t opacity;
    };

    void setVolume(const bench::Volume& volume)
    {
        const int n = volume.side, size = sizeof(Voxel);
        for (const std::uint8_t value : volume.voxels)
            voxels_.push_back({value, value});
        expect(context_, vpSetVolumeSize(context_, n, n, n), "vpSetVolumeSize");
        expect(context_, vpSetVoxelSize(context_, size, 2, 1, 1), "vpSetVoxelSize");
        expect(context_, vpSetVoxelField(context_, 0, 2, offsetof(Voxel, color), 255), "vpSetVoxelField");
        expect(context_, vpSetVoxelField(context_, 1, 1, offsetof(Voxel, opacity), 255), "vpSetVoxelField");
        expect(context_,
               vpSetRawVoxels(context_, voxels_.data(), size * n * n * n, size, size * n, size * n * n),
               "vpSetRawVoxels");
    }

    void setTables(const bench::Volume& volume)
    {
        const bench::Table table = bench::makeTable(scene_.table, volume, scene_.visible);
        const auto [x, y, z] = bench::viewerOf(scene_).direction;
        const double spacing = 1.0 / std::max({std::abs(x), std::abs(y), std::abs(z)});
        for (std::size_t i = 0; i < 256; ++i) {
            opacities_[i] =
                static_cast<float>(1.0 - std::pow(1.0 - static_cast<double>(table[i][3]), spacing));
            for (std::size_t channel = 0; channel < 3; ++channel)
                colors_[3 * i + channel] = 255.0f * table[i][channel];
        }
        expect(context_, vpSetClassifierTable(context_, 0, 1, opacities_.data(), sizeof opacities_),
               "vpSetClassifierTable");
        expect(context_, vpSetd(context_, VP_MIN_VOXEL_OPACITY, 0.5 / 255.0), "VP_MIN_VOXEL_OPACITY");
        expect(context_, vpSetd(context_, VP_MAX_RAY_OPACITY, 0.999), "VP_MAX_RAY_OPACITY");
        expect(context_, vpSetLookupShader(context_, 3, 1, 0, colors_.data(), sizeof colors_, 0, nullptr, 0),
               "vpSetLookupShader");
    }

    void setPicture()
    {
        const int side = bench::kPictureSide;
        expect(context_, vpSetImage(context_, image_.data(), side, side, 4 * side, VP_RGBA), "vpSetImage");
    }

    /// The centres of VolPack's outermost voxels lie on a cube of side 1 round the origin; its viewer looks
    /// along +z.
    void setView(double turn)
    {
        const bench::Viewer viewer = bench::viewerOf(scene_, turn);
        const double half = viewer.radius / (scene_.side - 1);
        vpCurrentMatrix(context_, VP_PROJECT);
        vpIdentityMatrix(context_);
        vpWindow(context_, VP_PARALLEL, -half, half, -half, half, -2.0, 2.0);
        vpCurrentMatrix(context_, VP_VIEW);
        vpIdentityMatrix(context_);
        vpCurrentMatrix(context_, VP_MODEL);
        vpMatrix4 matrix{};
        for (std::size_t row = 0; row < 3; ++row)
            for (std::size_t column = 0; column < 3; ++column)
                matrix[row][column] = (row == 2 ? -1.0 : 1.0) * viewer.view.model[4 * column + row];
        matrix[3][3] = 1.0;
        expect(context_, vpSetMatrix(context_, matrix), "vpSetMatrix");
    }

    bench::Scene scene_;
    std::vector<Voxel> voxels_;
    vpContext* context_;
    std::vector<unsigned char> image_;
    std::array<float, 256> opacities_{};
    std::array<float, 768> colors_{};
    double classification_ = 0.0;
};

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 2) throw std::invalid_argument("arguments: SCENE FOLDER-OF-VOLUMES");
    const bench::Scene scene = bench::sceneNamed(arguments[0]);
    ShearWarp shearWarp(scene, bench::cachedVolume(scene.volume, scene.side, arguments[1]));
    bench::Worker worker;
    worker.work = [&](int number) { shearWarp.draw(bench::turnOf(number)); };
    worker.picture = [&] { return shearWarp.picture(); };
    worker.facts = [&] {
        return bench::jsonPair("version", std::string("VolPack 1.0")) + ", " +
               bench::jsonPair("classification", shearWarp.classification());
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
