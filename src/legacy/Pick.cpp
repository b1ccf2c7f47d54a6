#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include "appearance/convert_voxels.h"
#include "draw/draw_state.h"
#include "draw/fragment.h"
#include "lookup/brick_texels.h"
#include "polygonize/line_of_sight.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

vo::LineOfSight lineThrough(const int* pixel, const int* viewport, const GLdouble* model,
                            const GLdouble* projection)
{
    if (!pixel || !viewport) badValue("pixelPosition or viewport is NULL");
    glm::dvec2 device;
    for (int axis = 0; axis < 2; ++axis) {
        const int extent = viewport[2 + axis];
        const double from = static_cast<double>(pixel[axis]) - viewport[axis];
        if (extent < 1)
            badValue("a viewport of " + std::to_string(viewport[2]) + " x " + std::to_string(viewport[3]) +
                     " pixels has none to pick");
        if (from < 0 || from >= extent)
            badValue("pixel (" + std::to_string(pixel[0]) + ", " + std::to_string(pixel[1]) +
                     ") is outside the viewport");
        device[axis] = 2.0 * (from + 0.5) / extent - 1.0;
    }
    const std::optional<vo::LineOfSight> line =
        vo::lineOfSight(glm::make_mat4(model), glm::make_mat4(projection), device);
    if (!line) badValue("the matrices are singular");
    return *line;
}

/// How records lie: those of the tetrahedra, and those that the caller gets.
struct PickLayout
{
    vo::RecordLayout tetras; ///< what draw knows of them; values in front of it are the user's
    bool addVoxel = false;   ///< the caller's get the position as voxel coordinates in front
};

PickLayout pickLayout(int format, int tetraValues, int values)
{
    const vo::RecordLayout wanted = vo::recordLayout(format, tetraValues);
    PickLayout layout;
    layout.addVoxel = tetraValues == 3 && wanted.values == 6 && wanted.texCoord >= 0;
    layout.tetras = layout.addVoxel ? vo::RecordLayout{} : wanted;
    const int front = tetraValues - layout.tetras.values;
    if (front < 0)
        badValue("the vertex format has " + std::to_string(wanted.values) +
                 " values a record, the tetrahedra " + std::to_string(tetraValues));
    if (values != tetraValues + (layout.addVoxel ? 3 : 0))
        badValue("coordinates has " + std::to_string(values) + " values a record, " +
                 std::to_string(tetraValues + (layout.addVoxel ? 3 : 0)) + " are needed");
    layout.tetras.values = tetraValues;
    if (layout.tetras.texCoord >= 0) layout.tetras.texCoord += front;
    if (layout.tetras.color >= 0) layout.tetras.color += front;
    return layout;
}

/// One brick that a line may meet.
class PickedBrick
{
public:
    explicit PickedBrick(const voBrick& brick) : image_(vo::textureImage(brick))
    {
        if (image_.voxels.empty()) badValue("a brick has no voxels; dataAlloc or setDataPtr gives it some");
        float origin[3], extent[3];
        brick.getBrickSizes(origin, extent);
        for (int axis = 0; axis < 3; ++axis) {
            origin_[axis] = origin[axis];
            scale_[axis] = image_.size[axis] / static_cast<double>(extent[axis]);
            if (image_.twoDimensional && image_.size[axis] == 1) thin_[axis] = true;
        }
    }

    const vo::TextureImage& image() const { return image_; }

    /// In voxels from the brick's lower corner.
    glm::dvec3 placeOf(const float* voxel) const
    {
        return (glm::dvec3(voxel[0], voxel[1], voxel[2]) - origin_) * scale_;
    }

    std::span<const std::byte> nearest(const float* voxel) const
    {
        const std::size_t bytes = vo::voxelBytes(image_.format);
        return image_.voxels.subspan(vo::nearestVoxel(image_.size, placeOf(voxel)) * bytes, bytes);
    }

    glm::dvec4 filtered(const float* voxel, const glm::dmat4& textureMatrix,
                        const vo::Table* classified) const
    {
        const vo::BrickTexels texels{image_.size, image_.format, image_.texel, image_.voxels, classified};
        return vo::filteredTexel(texels, transformed(placeOf(voxel), textureMatrix));
    }

private:
    /// Through the caller's texture matrix, which texture coordinates pass.
    glm::dvec3 transformed(glm::dvec3 place, const glm::dmat4& matrix) const
    {
        if (matrix == glm::dmat4(1.0)) return place;
        int axes[3], count = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (!thin_[axis]) axes[count++] = axis;
        glm::dvec4 coordinate(0, 0, 0, 1);
        for (int i = 0; i < count; ++i)
            coordinate[i] = place[axes[i]] / image_.size[axes[i]];
        coordinate = matrix * coordinate;
        for (int i = 0; i < count; ++i)
            place[axes[i]] = coordinate[i] / coordinate.w * image_.size[axes[i]];
        return place;
    }

    vo::TextureImage image_;
    glm::dvec3 origin_{0.0};
    glm::dvec3 scale_{1.0};
    bool thin_[3] = {false, false, false};
};

/// The samples of a line that are handed out, from the viewer on.
struct PickedLine
{
    vo::LineSamples samples;
    std::size_t count = 0;
    vo::RecordLayout layout;
    std::span<voBrick* const> bricks;

    const float* record(std::size_t i) const
    {
        return samples.records.data() + i * static_cast<std::size_t>(layout.values);
    }
    const float* voxel(std::size_t i) const
    {
        return record(i) + (layout.texCoord >= 0 ? layout.texCoord : layout.position());
    }
};

/// Calls function(sample number, brick) for each sample.
template <typename Function>
void forEachSample(const PickedLine& line, Function function)
{
    std::vector<std::optional<PickedBrick>> bricks(line.bricks.size());
    for (std::size_t i = 0; i < line.count; ++i) {
        const auto number = static_cast<std::size_t>(line.samples.places[i].box);
        if (!bricks[number]) bricks[number].emplace(*line.bricks[number]);
        function(i, *bricks[number]);
    }
}

std::vector<std::byte> originalVoxels(const PickedLine& line)
{
    std::vector<std::byte> voxels;
    forEachSample(line, [&](std::size_t i, const PickedBrick& brick) {
        const std::span<const std::byte> voxel = brick.nearest(line.voxel(i));
        voxels.insert(voxels.end(), voxel.begin(), voxel.end());
    });
    return voxels;
}

std::vector<std::byte> drawnVoxels(const PickedLine& line)
{
    const vo::ContextRecord& context = vo::requireContext();
    vo::DrawState state = vo::readDrawState(context);
    const vo::TableSlot* before = vo::activeTable(context, vo::TableKind::preInterpolation);
    const vo::TableSlot* after = vo::activeTable(context, vo::TableKind::postInterpolation);
    const glm::dmat4 textureMatrix(state.textureMatrix);
    const double unitLength = context.state.unitLength;
    std::vector<std::byte> voxels;
    forEachSample(line, [&](std::size_t i, const PickedBrick& brick) {
        const auto [oneChannel, hasAlpha] = vo::textureAnswer(brick.image().texel, before != nullptr);
        state.oneChannel = oneChannel;
        state.textureHasAlpha = hasAlpha;
        glm::dvec4 color(state.color);
        for (int c = 0; line.layout.color >= 0 && c < 4; ++c)
            color[c] = c < line.layout.colorChannels ? line.record(i)[line.layout.color + c] : 1.0;
        const glm::dvec4 sampled =
            brick.filtered(line.voxel(i), textureMatrix, before ? &before->table : nullptr);
        glm::dvec4 fragment = vo::fragmentOf(state, after ? &after->table : nullptr, sampled, color);
        if (unitLength > 0.0) fragment.a = vo::opacityOver(fragment.a, line.samples.step / unitLength);
        const glm::vec4 rgba(fragment);
        const std::size_t bytes = vo::voxelBytes(brick.image().format);
        voxels.resize(voxels.size() + bytes);
        vo::encodeVoxels(&rgba[0], 1, brick.image().format, std::span(voxels).last(bytes));
    });
    return voxels;
}

void writeCoordinates(const PickedLine& line, bool addVoxel, voVertexData& coordinates)
{
    coordinates.empty();
    for (std::size_t i = 0; i < line.count; ++i) {
        float* record = coordinates[static_cast<int>(i)];
        if (addVoxel) record = std::copy_n(line.voxel(i), 3, record);
        std::copy_n(line.record(i), line.layout.values, record);
    }
    coordinates.setCount(static_cast<int>(line.count));
}

struct PickArguments
{
    const int* pixel;
    const int* viewport;
    voIndexedTetraSet* tetraSet;
    int format;
    const GLdouble* model;
    const GLdouble* projection;
    const float* period;
    voBool drawn;
    voVertexData* coordinates;
    void* voxels;
};

bool pickFrom(std::span<voBrick* const> bricks, std::span<const vo::Box> boxes,
              voPlaneOrientation orientation, const PickArguments& a)
{
    vo::TetraView tetras = vo::tetraView(required(a.tetraSet, "tetraSet"));
    voVertexData& coordinates = required(a.coordinates, "coordinates");
    const PickLayout layout = pickLayout(a.format, tetras.valuesPerVertex, coordinates.getValuesPerVertex());
    tetras.voxelColumn = layout.tetras.texCoord;
    if (coordinates.getCountMax() < 1) badValue("coordinates has no room for a sample");
    if (a.drawn && a.voxels && a.format == voInterleavedArrayTypeScope::USER_V3F)
        vo::unsupported("USER_V3F records are drawn by the application");
    const vo::Camera camera = vo::cameraOf(a.model, a.projection);
    const vo::LineOfSight sight = lineThrough(a.pixel, a.viewport, a.model, a.projection);
    const bool stack = orientation != voPlaneOrientationScope::UNSPECIFIED;
    const vo::SamplingRequest sampling =
        vo::samplingRequest(stack ? voSamplingModeScope::AXIS_ALIGNED : voSamplingModeScope::VIEWPORT_ALIGNED,
                            voSamplingSpaceScope::OBJECT, a.period,
                            a.period ? vo::kMostFrameSamples : coordinates.getCountMax(), orientation);

    PickedLine line;
    line.samples = vo::sampleLine(tetras, boxes, camera, sampling, sight);
    line.count = std::min(line.samples.places.size(), static_cast<std::size_t>(coordinates.getCountMax()));
    line.layout = layout.tetras;
    line.bricks = bricks;
    if (a.voxels) {
        const std::vector<std::byte> voxels = a.drawn ? drawnVoxels(line) : originalVoxels(line);
        std::copy(voxels.begin(), voxels.end(), static_cast<std::byte*>(a.voxels));
    }
    writeCoordinates(line, layout.addVoxel, coordinates);
    return line.count > 0;
}

} // namespace

voBool voGeometryActions::pick(int* pixelPosition, int* viewport, voIndexedTetraSet* tetraSet,
                               voBrickSet* brickSet, voInterleavedArrayType format, GLdouble* modelMatrix,
                               GLdouble* projMatrix, float* samplingPeriod, voBool flag,
                               voVertexData* coordinates, void* voxels)
{
    bool hit = false;
    guarded("voGeometryActions::pick", [&] {
        const voBrickSet& set = required(brickSet, "brickSet");
        std::vector<voBrick*> bricks;
        for (int i = 0; i < set.getBrickCount(); ++i)
            bricks.push_back(set.getBrick(i));
        std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        hit = pickFrom(bricks, boxes, set.getOrientation(),
                       {pixelPosition, viewport, tetraSet, format, modelMatrix, projMatrix, samplingPeriod,
                        flag, coordinates, voxels});
    });
    return hit ? VO_TRUE : VO_FALSE;
}

voBool voGeometryActions::pick(int* pixelPosition, int* viewport, voIndexedTetraSet* tetraSet, voBrick* brick,
                               voInterleavedArrayType format, GLdouble* modelMatrix, GLdouble* projMatrix,
                               float* samplingPeriod, voBool flag, voVertexData* coordinates, void* voxels)
{
    bool hit = false;
    guarded("voGeometryActions::pick", [&] {
        voBrick* const bricks[] = {&required(brick, "brick")};
        float lower[3], upper[3];
        brick->getClipBrickSizes(lower, upper);
        const vo::Box boxes[] = {{glm::dvec3(glm::make_vec3(lower)), glm::dvec3(glm::make_vec3(upper))}};
        hit = pickFrom(bricks, boxes, voInside::of(*brick).orientation,
                       {pixelPosition, viewport, tetraSet, format, modelMatrix, projMatrix, samplingPeriod,
                        flag, coordinates, voxels});
    });
    return hit ? VO_TRUE : VO_FALSE;
}
