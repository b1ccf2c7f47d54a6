#include "cast/fill_scene.h"

#include "appearance/convert_voxels.h"
#include "sort/brick_order.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vo::test {

namespace {

/// Corner numbers 4 z + 2 y + x of the five tetrahedra of a cell; those of odd cells are mirrored.
constexpr int kCellTetras[5][4] = {{0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}};

std::vector<Tetrahedron> gridTetras(int cells, const std::function<glm::dvec3(const glm::dvec3&)>& place)
{
    std::vector<Tetrahedron> tetras;
    for (int z = 0; z < cells; ++z)
        for (int y = 0; y < cells; ++y)
            for (int x = 0; x < cells; ++x)
                for (const auto& corners : kCellTetras) {
                    Tetrahedron tetra;
                    for (std::size_t i = 0; i < 4; ++i) {
                        const int corner = corners[i] ^ ((x + y + z) & 1);
                        tetra[i] =
                            place(glm::dvec3(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)) /
                                  double(cells));
                    }
                    tetras.push_back(tetra);
                }
    return tetras;
}

glm::dvec3 extentOf(const VoxelSize& size)
{
    return {size.x, size.y, size.z};
}

int brickSize(int size, int count, int overlap)
{
    return count <= 1 ? size : (size - overlap + count - 1) / count + overlap;
}

} // namespace

std::array<double, 4> vertexColorAt(const glm::dvec3& p)
{
    return {0.3 + 0.015 * p.x, 0.9 - 0.01 * p.y - 0.01 * p.x, 0.2 + 0.02 * p.z, 0.1 + 0.004 * p.y};
}

FillScene::FillScene(const Scene& scene, const FillOptions& options) : scene_(scene), options_(options)
{
    if (!scene.table.empty()) table_ = std::make_unique<Table>(Table{scene.table});
    makeBricks();
    makeTetras();
    makeRequest();
}

void FillScene::makeBricks()
{
    const Field& field = *scene_.volume;
    const VoxelSize size = field.size;
    const int n = options_.bricks;
    VoxelSize brick{brickSize(size.x, n, scene_.overlap), brickSize(size.y, n, scene_.overlap),
                    brickSize(size.z, n, scene_.overlap)};
    if (scene_.stackAxis == 0) brick.x = 1;
    if (scene_.stackAxis == 1) brick.y = 1;
    if (scene_.stackAxis == 2) brick.z = 1;
    for (const BrickExtent& extent : brickGrid({size, brick, scene_.overlap, PartialBricks::augment})) {
        std::vector<float> rgba;
        for (int z = extent.origin.z; z < extent.origin.z + extent.size.z; ++z)
            for (int y = extent.origin.y; y < extent.origin.y + extent.size.y; ++y)
                for (int x = extent.origin.x; x < extent.origin.x + extent.size.x; ++x)
                    for (int c = 0; c < 4; ++c) {
                        const bool inside = x < size.x && y < size.y && z < size.z;
                        const int channel = field.channels == 1   ? 0
                                            : field.channels == 4 ? c
                                            : c == 3              ? 1
                                                                  : 0;
                        rgba.push_back(inside ? field.at(x, y, z, channel) : 0.0f);
                    }
        voxels_.emplace_back(rgba.size() / 4 * voxelBytes(options_.format));
        encodeVoxels(rgba.data(), rgba.size() / 4, options_.format, voxels_.back());
        CastBrick cast;
        cast.id = voxels_.size();
        cast.texels = {extent.size, options_.format, options_.texel, voxels_.back(),
                       scene_.classification == Classification::preInterpolation ? table_.get() : nullptr};
        cast.tableSerial = cast.texels.classified ? 1 : 0;
        cast.origin = {extent.origin.x, extent.origin.y, extent.origin.z};
        cast.size = {extent.size.x, extent.size.y, extent.size.z};
        cast.thinAxis = scene_.stackAxis;
        bricks_.push_back(cast);
        boxes_.push_back(clipBox(cast.origin, cast.size, size, scene_.overlap));
    }
}

void FillScene::makeTetras()
{
    const glm::dvec3 extent = extentOf(scene_.volume->size);
    const auto inPlace = [&](const glm::dvec3& share) { return share * extent; };
    const int cells = options_.deformation ? options_.deformation->cells : 1;
    voxelSpace_ = gridTetras(cells, inPlace);
    space_ = !options_.deformation ? voxelSpace_ : gridTetras(cells, [&](const glm::dvec3& share) {
        // As the records hold them: floats.
        return glm::dvec3(glm::vec3(options_.deformation->place(inPlace(share))));
    });
    if (options_.deformation) layout_.texCoord = 0;
    if (options_.colorChannels > 0) layout_.color = options_.deformation ? 3 : 0;
    layout_.colorChannels = options_.colorChannels;
    layout_.values = 3 + options_.colorChannels + (options_.deformation ? 3 : 0);
    const auto push = [&](double value) { records_.push_back(static_cast<float>(value)); };
    for (std::size_t t = 0; t < space_.size(); ++t) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            indices_.push_back(static_cast<int>(indices_.size()));
            for (int axis = 0; options_.deformation && axis < 3; ++axis)
                push(voxelSpace_[t][corner][axis]);
            const std::array<double, 4> color = vertexColorAt(space_[t][corner]);
            for (int c = 0; c < options_.colorChannels; ++c)
                push(color[static_cast<std::size_t>(c)]);
            for (int axis = 0; axis < 3; ++axis)
                push(space_[t][corner][axis]);
        }
        glm::dmat4 corners(1.0);
        for (int corner = 0; corner < 4; ++corner)
            corners[corner] = glm::dvec4(space_[t][static_cast<std::size_t>(corner)], 1.0);
        weights_.push_back(glm::inverse(corners));
    }
}

void FillScene::makeRequest()
{
    request_.model = glm::make_mat4(scene_.view.model.data());
    request_.projection = glm::make_mat4(scene_.view.projection.data());
    request_.width = scene_.width;
    request_.height = scene_.height;
    request_.tetras = {records_, layout_.values, indices_, layout_.texCoord};
    request_.layout = layout_;
    request_.clipBoxes = boxes_;
    request_.bricks = bricks_;
    constexpr SamplingMode modes[] = {SamplingMode::viewportAligned, SamplingMode::axisAligned,
                                      SamplingMode::spherical};
    request_.sampling = {modes[static_cast<int>(scene_.planes)], SamplingSpace::object, scene_.period,
                         scene_.maxSamples, scene_.stackAxis};
    if (scene_.classification == Classification::postInterpolation) request_.shading.table = table_.get();
    for (int c = 0; c < 4; ++c)
        request_.shading.color[c] = static_cast<float>(scene_.color[static_cast<std::size_t>(c)]);
    request_.blending = options_.blending;
    request_.threads = options_.threads;
}

CastPicture FillScene::fill()
{
    const std::string refusal = fillRefusal(request_);
    if (!refusal.empty()) throw std::runtime_error(refusal);
    const std::optional<Camera> camera = findCamera(request_.model, request_.projection);
    cache_.update({request_.tetras, boxes_, *camera, request_.sampling}, 0.0);
    std::vector<PolygonRun> runs;
    for (const PolygonCache::Run& run : cache_.runs())
        runs.push_back({run.brick, run.first, run.count});
    if (!cache_.bricksInterleave()) {
        std::vector<int> place(boxes_.size());
        const std::vector<int> order = backToFront(boxes_, *camera);
        for (std::size_t i = 0; i < order.size(); ++i)
            place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        std::ranges::sort(runs, {},
                          [&](const PolygonRun& run) { return place[static_cast<std::size_t>(run.brick)]; });
    }
    CastPicture picture;
    filler_.fill(request_, {cache_.records(), cache_.indices(), runs}, picture);
    return picture;
}

std::vector<float> FillScene::drawn()
{
    const CastPicture picture = fill();
    const auto& background = scene_.background;
    std::vector<float> result(4 * static_cast<std::size_t>(scene_.width) *
                              static_cast<std::size_t>(scene_.height));
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = i % 4 < 3 ? static_cast<float>(background[i % 4]) : 0.0f;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const float* from = &picture.rgbt[4 * static_cast<std::size_t>(y * picture.width + x)];
            float* to = &result[4 * static_cast<std::size_t>((picture.y + y) * scene_.width + picture.x + x)];
            for (int c = 0; c < 3; ++c)
                switch (options_.blending) {
                case CastBlending::over:
                case CastBlending::premultiplied: to[c] = from[c] + from[3] * to[c]; break;
                case CastBlending::max: to[c] = std::max(to[c], from[c]); break;
                case CastBlending::min: to[c] = std::min(to[c], from[c]); break;
                case CastBlending::sum:
                case CastBlending::alphaSum: to[c] += from[c]; break;
                }
        }
    return result;
}

std::optional<std::array<double, 4>> FillScene::fragmentAt(const glm::dvec3& point) const
{
    for (std::size_t t = 0; t < space_.size(); ++t) {
        const glm::dvec4 weights = weights_[t] * glm::dvec4(point, 1.0);
        if (std::min({weights.x, weights.y, weights.z, weights.w}) < -1e-9) continue;
        glm::dvec3 voxel(0.0);
        std::array<double, 4> color{1.0, 1.0, 1.0, 1.0};
        for (int i = 0; i < 4; ++i)
            voxel += weights[i] * voxelSpace_[t][static_cast<std::size_t>(i)];
        for (std::size_t c = 0; c < static_cast<std::size_t>(options_.colorChannels); ++c) {
            color[c] = 0.0;
            for (int i = 0; i < 4; ++i)
                color[c] += weights[i] * vertexColorAt(space_[t][static_cast<std::size_t>(i)])[c];
        }
        for (int axis = 0; axis < 3; ++axis) {
            const double margin = 0.5 * scene_.overlap, size = scene_.volume->size[axis];
            if (voxel[axis] < margin - 1e-5 || voxel[axis] > size - margin + 1e-5) return std::nullopt;
        }
        std::array<double, 4> fragment = referenceSample(scene_, voxel);
        for (std::size_t c = 0; c < 4; ++c)
            fragment[c] *= color[c];
        return fragment;
    }
    return std::nullopt;
}

Picture FillScene::reference(const Change& change) const
{
    Scene scene = scene_;
    scene.geometry = space_;
    scene.sampleAt = [&](const glm::dvec3& point) {
        const auto fragment = fragmentAt(point);
        return change && fragment ? change(point, *fragment) : fragment;
    };
    return referencePicture(scene);
}

} // namespace vo::test
