#include "draw/draw_scene.h"

#include <cstring>
#include <iostream>
#include <cstdlib>
#include <stdexcept>

namespace vo::test {

namespace {

void expectNoError(const char* step)
{
    const voErrorType number = voError::getErrorNumber();
    const char* text = voError::getErrorString();
    if (number != voErrorTypeScope::NO_ERROR)
        throw std::runtime_error(std::string(step) + ": " + (text ? text : "an error without text"));
}

voExternalFormatType formatOf(int channels)
{
    return channels == 1   ? voExternalFormatTypeScope::LUMINANCE
           : channels == 2 ? voExternalFormatTypeScope::LUMINANCE_ALPHA
                           : voExternalFormatTypeScope::RGBA;
}

/// Smallest brick size with which `count` bricks cover `size` voxels.
int brickSize(int size, int count, int overlap)
{
    return count <= 1 ? size : (size - overlap + count - 1) / count + overlap;
}

voSamplingMode modeOf(SamplingPlanes planes)
{
    switch (planes) {
    case SamplingPlanes::viewportAligned: return voSamplingModeScope::VIEWPORT_ALIGNED;
    case SamplingPlanes::axisAligned: return voSamplingModeScope::AXIS_ALIGNED;
    case SamplingPlanes::spherical: return voSamplingModeScope::SPHERICAL;
    }
    throw std::logic_error("no such planes");
}

template <typename T>
void fillBrick(voBrick& brick, const Field& field, const std::vector<T>& values)
{
    int x0, y0, z0, nx, ny, nz;
    brick.getBrickSizes(x0, y0, z0, nx, ny, nz);
    T* target = static_cast<T*>(brick.getDataPtr());
    for (int z = z0; z < z0 + nz; ++z)
        for (int y = y0; y < y0 + ny; ++y)
            for (int x = x0; x < x0 + nx; ++x)
                for (int c = 0; c < field.channels; ++c) {
                    const bool inside = x < field.size.x && y < field.size.y && z < field.size.z;
                    *target++ = inside ? values[field.index(x, y, z) + static_cast<std::size_t>(c)] : T(0);
                }
}

} // namespace

SceneDrawing::SceneDrawing(const OffscreenContext& context, const Scene& scene, const DrawOptions& options)
    : context_(&context), scene_(scene), options_(options)
{
    GLint profile = 0;
    context_->gl().GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    core_ = (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) == 0;
    makeVolume();
    makeGeometry();
    makeTable();
}

SceneDrawing::~SceneDrawing() = default;

void SceneDrawing::makeVolume()
{
    const VoxelSize& size = scene_.volume->size;
    voInterpolationType interpolation =
        scene_.stackAxis >= 0 ? voInterpolationTypeScope::_2D : voInterpolationTypeScope::_3D;
    voExternalFormatType external = options_.externalFormat;
    if (external == voExternalFormatTypeScope::DEFAULT) external = formatOf(scene_.volume->channels);
    volume_ = std::make_unique<voBrickSetCollection>(
        size.x, size.y, size.z, brickSize(size.x, options_.bricks, scene_.overlap),
        brickSize(size.y, options_.bricks, scene_.overlap),
        brickSize(size.z, options_.bricks, scene_.overlap), voPartialBrickTypeScope::AUGMENT, scene_.overlap,
        options_.internalFormat, external, options_.dataType, interpolation);
    expectNoError("voBrickSetCollection");
    const std::vector<std::uint8_t> bytes = toBytes(*scene_.volume);
    const std::vector<std::uint16_t> shorts = toShorts(*scene_.volume);
    voBrickSetCollectionIterator sets(volume_.get());
    for (voBrickSet* set; (set = sets());)
        voAppearanceActions::dataAlloc(set);
    volume_->setCurrentBrickSet(voPlaneOrientationScope::XY);
    voBrickSetIterator bricks(volume_->getCurrentBrickSet());
    for (voBrick* brick; (brick = bricks());) {
        if (options_.dataType == voDataTypeScope::UNSIGNED_BYTE)
            fillBrick(*brick, *scene_.volume, bytes);
        else if (options_.dataType == voDataTypeScope::UNSIGNED_SHORT)
            fillBrick(*brick, *scene_.volume, shorts);
        else
            fillBrick(*brick, *scene_.volume, scene_.volume->values);
    }
    voAppearanceActions::volumeMakeTransposed(volume_.get());
    voAppearanceActions::volumeOptimize(volume_.get(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    expectNoError("loading the volume");
}

void SceneDrawing::makeGeometry()
{
    const float x = static_cast<float>(scene_.volume->size.x), y = static_cast<float>(scene_.volume->size.y),
                z = static_cast<float>(scene_.volume->size.z);
    std::vector<float> corners = {0, 0, 0, x, 0, 0, x, y, 0, 0, y, 0, 0, 0, z, x, 0, z, x, y, z, 0, y, z};
    indices_ = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
    if (!scene_.geometry.empty()) {
        corners.clear();
        indices_.clear();
        for (const Tetrahedron& tetra : scene_.geometry)
            for (const glm::dvec3& corner : tetra) {
                indices_.push_back(static_cast<int>(indices_.size()));
                for (int axis = 0; axis < 3; ++axis)
                    corners.push_back(static_cast<float>(corner[axis]));
            }
    }
    const int repeat = options_.explicitTexCoords ? 2 : 1;
    for (std::size_t i = 0; i < corners.size(); i += 3)
        for (int copy = 0; copy < repeat; ++copy)
            vertices_.insert(vertices_.end(), {corners[i], corners[i + 1], corners[i + 2]});
    const int values = 3 * repeat;
    tetras_ =
        std::make_unique<voIndexedTetraSet>(vertices_.data(), static_cast<int>(vertices_.size()) / values,
                                            values, indices_.data(), static_cast<int>(indices_.size()));
    if (options_.utility && scene_.planes == SamplingPlanes::spherical)
        cache_ = std::make_unique<voDrawActionCache>(tetras_.get(), volume_.get(), 4096,
                                                     voSamplingModeScope::SPHERICAL, values, 0);
    if (options_.utility) return;
    maxSamples_ = std::min(scene_.maxSamples, static_cast<int>(4 * std::max({x, y, z})));
    sharedVertices_ = std::make_unique<voVertexData>(1000000, values);
    for (int b = 0; b < volume_->getMaxBrickCount(); ++b) {
        faceSets_.emplace_back();
        faceSetRows_.emplace_back();
        for (int s = 0; s < maxSamples_; ++s) {
            faceSets_.back().push_back(std::make_unique<voIndexedFaceSet>(sharedVertices_.get(), 0));
            faceSetRows_.back().push_back(faceSets_.back().back().get());
        }
    }
    for (auto& row : faceSetRows_)
        faceSetArray_.push_back(row.data());
}

void SceneDrawing::makeTable()
{
    if (scene_.classification == Classification::none) return;
    const int size = static_cast<int>(scene_.table.size() / 4);
    if (scene_.classification == Classification::preInterpolation)
        table_ = std::make_unique<voLookupTablePre>(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, size,
                                                    GLenum{voExternalFormatTypeScope::RGBA},
                                                    GLenum{voDataTypeScope::FLOAT}, scene_.table.data());
    else
        table_ = std::make_unique<voLookupTablePost>(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, size,
                                                     GLenum{voExternalFormatTypeScope::RGBA},
                                                     GLenum{voDataTypeScope::FLOAT}, scene_.table.data());
    table_->load();
    table_->enable();
    expectNoError("the table");
}

void SceneDrawing::setState(const View& view)
{
    const GladGLContext& gl = context_->gl();
    const auto& color = scene_.color;
    if (core_) {
        voState::setModelMatrix(view.model.data());
        voState::setProjectionMatrix(view.projection.data());
        voState::setColor(static_cast<float>(color[0]), static_cast<float>(color[1]),
                          static_cast<float>(color[2]), static_cast<float>(color[3]));
    } else {
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadMatrixd(view.projection.data());
        gl.MatrixMode(GL_MODELVIEW);
        gl.LoadMatrixd(view.model.data());
        gl.Color4d(color[0], color[1], color[2], color[3]);
    }
    gl.Enable(GL_BLEND);
    constexpr GLenum equations[] = {GL_FUNC_ADD, GL_MAX, GL_MIN, GL_FUNC_ADD, GL_FUNC_ADD};
    gl.BlendEquation(equations[static_cast<int>(scene_.compositing)]);
    if (scene_.compositing == Compositing::sum)
        gl.BlendFunc(GL_ONE, GL_ONE);
    else if (scene_.compositing == Compositing::premultiplied)
        gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    else
        gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl.ClearColor(static_cast<float>(scene_.background[0]), static_cast<float>(scene_.background[1]),
                  static_cast<float>(scene_.background[2]), 0.0f);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void SceneDrawing::draw()
{
    draw(scene_.view);
}

void SceneDrawing::draw(const View& view)
{
    setState(view);
    if (!options_.utility) {
        drawLoops(view);
    } else {
        float period[3] = {1, 1, 1};
        for (int axis = 0; scene_.period && axis < 3; ++axis)
            period[axis] = static_cast<float>((*scene_.period)[axis]);
        voState::setEngine(options_.engine);
        voGeometryActions::drawUtility(tetras_.get(),
                                       options_.explicitTexCoords ? voInterleavedArrayTypeScope::T3F_V3F
                                                                  : voInterleavedArrayTypeScope::V3F,
                                       volume_.get(), cache_.get(), voSamplingSpaceScope::OBJECT,
                                       scene_.period ? period : nullptr, voDecorationFlagsScope::NONE);
    }
    expectNoError("drawing");
}

void SceneDrawing::drawIn(const OffscreenContext& other)
{
    context_ = &other;
    draw();
}

/// The guide's my_DrawVolume (pages 77-81).
void SceneDrawing::drawLoops(const View& view)
{
    View v = view;
    const bool stacks = volume_->getInterpolationType() == voInterpolationTypeScope::_2D;
    const voInterleavedArrayType format =
        options_.explicitTexCoords ? voInterleavedArrayTypeScope::T3F_V3F : voInterleavedArrayTypeScope::V3F;
    if (stacks)
        volume_->setCurrentBrickSet(voGeometryActions::findClosestAxisIndex(
            v.model.data(), v.projection.data(), voSamplingModeScope::AXIS_ALIGNED));
    voBrickSet* set = volume_->getCurrentBrickSet();
    float period[3] = {1, 1, 1};
    for (int axis = 0; scene_.period && axis < 3; ++axis)
        period[axis] = static_cast<float>((*scene_.period)[axis]);
    int samples = 0;
    const voSamplingMode mode = stacks ? voSamplingModeScope::AXIS_ALIGNED : modeOf(scene_.planes);
    voGeometryActions::polygonize(tetras_.get(), set, format, v.model.data(), v.projection.data(), mode,
                                  voSamplingSpaceScope::OBJECT, scene_.period ? period : nullptr, maxSamples_,
                                  samples, faceSetArray_.data());
    expectNoError("polygonize");
    if (hasTextureComponent(format))
        voAppearanceActions::xfmVox2TexCoords(set, samples, faceSetArray_.data(), format);
    voSortAction order(set, v.model.data(), v.projection.data());
    voAppearanceActions::textureEnable(volume_->getInterpolationType());
    if (!hasTextureComponent(format)) voAppearanceActions::texgenEnable();
    for (int i = 0; i < set->getBrickCount(); ++i) {
        voBrick* brick = set->getBrick(order[i]);
        if (!hasTextureComponent(format)) voAppearanceActions::texgenSetEquation(brick);
        voAppearanceActions::textureBind(brick);
        for (int sample = 0; sample < samples; ++sample)
            voGeometryActions::draw(faceSetArray_[static_cast<std::size_t>(order[i])][sample], format);
    }
    voAppearanceActions::texgenDisable();
    voAppearanceActions::textureDisable(volume_->getInterpolationType());
}

std::vector<float> drawnPicture(const OffscreenContext& context, const Scene& scene,
                                const DrawOptions& options)
{
    SceneDrawing drawing(context, scene, options);
    drawing.draw();
    return context.readFloats();
}

std::unique_ptr<OffscreenContext> openFor(const Scene& scene, OffscreenProfile profile, bool floatColor)
{
    OffscreenRequest request;
    request.profile = profile;
    request.width = scene.width;
    request.height = scene.height;
    request.floatColor = floatColor;
    std::string why;
    auto context = openOffscreen(request, &why);
    if (!context) throw std::runtime_error("no off-screen context: " + why);
    return context;
}

} // namespace vo::test
