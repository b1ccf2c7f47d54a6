#include "volumizer_frames.h"

#include <algorithm>
#include <stdexcept>

namespace bench {

namespace {

void expectNoError(const std::string& step)
{
    const voErrorType number = voError::getErrorNumber();
    const char* text = voError::getErrorString();
    if (number != voErrorTypeScope::NO_ERROR)
        throw std::runtime_error(step + ": " + (text ? text : "an error without text"));
}

/// Voxels of a brick beyond the volume stay zero.
void fillBrick(voBrick& brick, const Volume& voxels)
{
    int x0, y0, z0, nx, ny, nz;
    brick.getBrickSizes(x0, y0, z0, nx, ny, nz);
    auto* target = static_cast<unsigned char*>(brick.getDataPtr());
    const int side = voxels.side;
    for (int z = 0; z < std::min(nz, side - z0); ++z)
        for (int y = 0; y < std::min(ny, side - y0); ++y) {
            const auto row = static_cast<std::size_t>(x0) +
                             static_cast<std::size_t>(side) *
                                 (static_cast<std::size_t>(y0 + y) +
                                  static_cast<std::size_t>(side) * static_cast<std::size_t>(z0 + z));
            const auto line =
                static_cast<std::size_t>(nx) *
                (static_cast<std::size_t>(y) + static_cast<std::size_t>(ny) * static_cast<std::size_t>(z));
            std::copy_n(voxels.voxels.data() + row, std::min(nx, side - x0), target + line);
        }
}

} // namespace

VolumizerFrames::VolumizerFrames(const FrameOptions& options) : options_(options)
{
    vo::OffscreenRequest request;
    request.width = request.height = kPictureSide;
    request.floatColor = true;
    std::string why;
    context_ = vo::openOffscreen(request, &why);
    if (!context_) throw std::runtime_error("no OpenGL without a window: " + why);
    const Scene& scene = options.scene;
    const Volume voxels = cachedVolume(scene.volume, scene.side, options.folder);
    makeVolume(voxels);
    makeTetras();
    entries_ = makeTable(scene.table, voxels, scene.visible);
    table_ = std::make_unique<voLookupTablePost>(GLenum{voInternalFormatTypeScope::RGBA8_EXT}, 256,
                                                 GLenum{voExternalFormatTypeScope::RGBA},
                                                 GLenum{voDataTypeScope::FLOAT}, entries_.data());
    table_->load();
    table_->enable();
    expectNoError("the table");
    setState();
}

void VolumizerFrames::changeTable(int number)
{
    const float factor = 1.0f - 0.001f * static_cast<float>(number % 5);
    Table changed = entries_;
    for (auto& entry : changed)
        entry[3] *= factor;
    std::swap(changed, entries_);
    table_->load();
    std::swap(changed, entries_);
}

void VolumizerFrames::draw(double turn)
{
    const GladGLContext& gl = context_->gl();
    const vo::test::View view = viewerOf(options_.scene, turn).view;
    gl.MatrixMode(GL_PROJECTION);
    gl.LoadMatrixd(view.projection.data());
    gl.MatrixMode(GL_MODELVIEW);
    gl.LoadMatrixd(view.model.data());
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    float period[3] = {1, 1, 1};
    voGeometryActions::drawUtility(tetras_.get(), voInterleavedArrayTypeScope::V3F, volume_.get(), nullptr,
                                   voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
    gl.Finish();
    expectNoError("drawUtility");
}

std::vector<float> VolumizerFrames::picture()
{
    if (options_.newTables) table_->load();
    draw(0.0);
    return context_->readFloats();
}

std::string VolumizerFrames::engine() const
{
    const bool cast = voState::getFramesDrawn(voEngineScope::CAST) > 0;
    const bool slices = voState::getFramesDrawn(voEngineScope::SLICES) > 0;
    return cast && slices ? "both" : cast ? "cast" : "slices";
}

double VolumizerFrames::countFragments(const std::function<void()>& drawing)
{
    GLuint query = 0, fragments = 0;
    gl().GenQueries(1, &query);
    gl().BeginQuery(GL_SAMPLES_PASSED, query);
    drawing();
    gl().EndQuery(GL_SAMPLES_PASSED);
    gl().GetQueryObjectuiv(query, GL_QUERY_RESULT, &fragments);
    gl().DeleteQueries(1, &query);
    return fragments;
}

void VolumizerFrames::makeVolume(const Volume& voxels)
{
    const int n = voxels.side, count = options_.bricksPerAxis, overlap = 1;
    const int side = count <= 1 ? n : (n - overlap + count - 1) / count + overlap;
    volume_ = std::make_unique<voBrickSetCollection>(
        n, n, n, side, side, side, voPartialBrickTypeScope::AUGMENT, overlap,
        voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
        voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    voBrickSet* set = volume_->getCurrentBrickSet();
    voAppearanceActions::dataAlloc(set);
    voBrickSetIterator bricks(set);
    for (voBrick* brick; (brick = bricks());)
        fillBrick(*brick, voxels);
    voAppearanceActions::volumeOptimize(volume_.get(), voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    expectNoError("loading the volume");
}

void VolumizerFrames::makeTetras()
{
    const auto n = static_cast<float>(options_.scene.side);
    vertices_ = {0, 0, 0, n, 0, 0, n, n, 0, 0, n, 0, 0, 0, n, n, 0, n, n, n, n, 0, n, n};
    indices_ = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
    tetras_ = std::make_unique<voIndexedTetraSet>(vertices_.data(), 8, 3, indices_.data(), 20);
}

void VolumizerFrames::setState()
{
    const GladGLContext& gl = context_->gl();
    gl.Color4f(1, 1, 1, 1);
    gl.ClearColor(0, 0, 0, 0);
    gl.Enable(GL_BLEND);
    gl.BlendEquation(options_.scene.maximum ? GL_MAX : GL_FUNC_ADD);
    gl.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    if (options_.perLength && !options_.scene.maximum) voState::setUnitLength(1.0);
    expectNoError("the state");
}

} // namespace bench
