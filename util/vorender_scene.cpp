#include "vorender_scene.h"

#include "volume_view/camera.h"
#include "volume_view/defaults.h"
#include "volume_view/lookup_ramp.h"

#include "appearance/brick_grid.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace vo {
namespace {

constexpr int kEntries = 256;

/// The box of a volume as five tetrahedra, one in the middle, four at its corners: vertices by bits x, y, z.
constexpr std::array<int, 20> kTetras{0, 3, 5, 6, 2, 3, 0, 6, 1, 3, 5, 0, 3, 6, 7, 5, 5, 4, 0, 6};

/// OpenGL, which draws the same picture, keeps its matrices in single precision.
glm::dmat4 singlePrecision(const Matrix& matrix)
{
    return glm::dmat4(glm::mat4(glm::make_mat4(matrix.data())));
}

Model modelOf(const VoxelSize& size, const std::array<float, 3>& scale)
{
    Model model;
    for (std::size_t i = 0; i < 3; ++i) {
        model.size[i] = size[static_cast<int>(i)];
        model.scale[i] = double(scale[i]);
    }
    return model;
}

/// Refuses what voglBasic refuses, and bricks that would show seams.
Result<void> checkCuts(const Options& options, const VoxelSize& size)
{
    std::array<std::int64_t, 3> volume{}, brick{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        volume[axis] = size[static_cast<int>(axis)];
        brick[axis] = options.bricks ? brickSizeFor(volume[axis], (*options.bricks)[axis], options.overlap)
                                     : volume[axis];
    }
    if (auto fit = checkBricks(options, volume, brick); !fit) return fit;
    if (options.overlap == 0 && brick != volume)
        return Failure{"option -bricks: expected an -overlap of 1 or more, without which bricks show seams, "
                       "found '0'"};
    return {};
}

} // namespace

Result<VolumeScene> VolumeScene::make(LoadedVolume volume, const Options& options,
                                      const std::optional<LookupFile>& table)
{
    VolumeScene scene(std::move(volume), options);
    const VoxelSize& size = scene.volume_.size;
    if (auto fit = checkCuts(options, size); !fit) return fit.failure();
    scene.scale_ = voxelScale(options, scene.volume_.spacing);
    const double planes =
        samplingPlaneCount(options, {double(size.x), double(size.y), double(size.z)}, scene.scale_);
    if (planes > kMostSamplingPlanes) {
        char found[400];
        std::snprintf(found, sizeof found, "expected at most %.0f sampling planes, found %.0f",
                      kMostSamplingPlanes, planes);
        return Failure{planeOptionsGiven(options, false) + found};
    }
    scene.maxSamples_ = static_cast<int>(planes);
    scene.makeTable(table);
    scene.makeCorners();
    return scene;
}

/// Volumes of several channels bring their own colours and opacities, and get no table unless one is asked
/// for.
void VolumeScene::makeTable(const std::optional<LookupFile>& file)
{
    if (!file && !options_.lut && channelCount(volume_.format.channels) != 1) return;
    const int components = inColor(options_, file && file->isColor) ? 4 : 2;
    std::vector<float> entries;
    if (file) {
        entries = tableEntries(*file, components);
    } else {
        const double low = double(volume_.low), high = double(volume_.high);
        const auto wanted = options_.lut.value_or(Options::Ramp{(low + high) / 2, high - low});
        double longest = 0;
        for (int axis = 0; axis < 3; ++axis)
            longest = std::max(longest, double(float(volume_.size[axis]) * scale_[std::size_t(axis)]));
        entries = rampEntries({wanted.center, wanted.width, sliceOpacity(options_.sampling, longest)}, low,
                              high, kEntries, components);
    }
    Table& table = table_.emplace();
    for (std::size_t i = 0; i < entries.size(); i += std::size_t(components)) {
        const float* entry = &entries[i];
        const std::array<float, 4> rgba = components == 4
                                              ? std::array{entry[0], entry[1], entry[2], entry[3]}
                                              : std::array{entry[0], entry[0], entry[0], entry[1]};
        for (const float value : rgba)
            table.rgba.push_back(std::clamp(value, 0.0f, 1.0f));
    }
}

void VolumeScene::makeCorners()
{
    for (unsigned corner = 0; corner < 8; ++corner)
        for (int axis = 0; axis < 3; ++axis)
            corners_[3 * corner + unsigned(axis)] = corner >> axis & 1u ? float(volume_.size[axis]) : 0.0f;
}

SceneView::SceneView(const VolumeScene& scene, double degrees)
{
    setMatrices(scene, degrees);
    request_.tetras = {scene.corners_, 3, kTetras, -1};
    setSampling(scene);
    setBrick(scene);
    request_.clipBoxes = {&clipBox_, 1};
    request_.bricks = {&brick_, 1};
    if (scene.table_) {
        request_.shading.table = &*scene.table_;
        request_.shading.tableSerial = 1;
    }
    if (scene.options_.mip) request_.blending = CastBlending::max;
}

void SceneView::setMatrices(const VolumeScene& scene, double degrees)
{
    const Options& options = scene.options_;
    const Model model = modelOf(scene.volume_.size, scene.scale_);
    const ViewVolume view = viewVolume(model, options.perspective, options.width, options.height);
    request_.model =
        singlePrecision(modelViewMatrix(model, {options.latitude, options.longitude + degrees}, view));
    request_.projection = singlePrecision(projectionMatrix(view));
    request_.width = options.width;
    request_.height = options.height;
}

void SceneView::setSampling(const VolumeScene& scene)
{
    const Options& options = scene.options_;
    SamplingRequest& sampling = request_.sampling;
    sampling.space = options.viewSpace ? SamplingSpace::viewVolume : SamplingSpace::object;
    glm::dvec3 period;
    for (int axis = 0; axis < 3; ++axis)
        period[axis] = double(float(options.sampling) / scene.scale_[std::size_t(axis)]);
    sampling.period = period;
    sampling.maxSamples = scene.maxSamples_;
    if (options.textureDimensions == 3) {
        sampling.mode = options.shells ? SamplingMode::spherical : SamplingMode::viewportAligned;
        return;
    }
    // The stack whose slices the viewer sees least obliquely.
    sampling.mode = SamplingMode::axisAligned;
    const auto camera = findCamera(request_.model, request_.projection);
    sampling.stackAxis = camera ? closestAxis(*camera) : 2;
}

void SceneView::setBrick(const VolumeScene& scene)
{
    const VoxelSize& size = scene.volume_.size;
    const int thin = request_.sampling.stackAxis;
    brick_.texels = scene.volume_.texels();
    brick_.id = static_cast<std::uint64_t>(2 + thin); // stacks are bricks of their own
    brick_.version = 1;
    brick_.size = {float(size.x), float(size.y), float(size.z)};
    brick_.thinAxis = thin;
    clipBox_ = clipBox(glm::dvec3(0.0), glm::dvec3(brick_.size), size, scene.options_.overlap);
    // A slice of a stack is one voxel thick: none is cut.
    if (thin >= 0) {
        clipBox_.lower[thin] = 0.0;
        clipBox_.upper[thin] = size[thin];
    }
}

} // namespace vo
