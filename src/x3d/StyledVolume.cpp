#include <vo/x3d/StyledVolume.h>

#include "x3d/face.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "core/invertible.h"
#include "style/shadow_textures.h"
#include "x3d/node_lights.h"
#include "x3d/node_values.h"
#include "x3d/plane_spacing.h"
#include "x3d/scene_painter.h"
#include "x3d/volume_styles.h"

namespace vo {
namespace {

int componentsOf(voExternalFormatType format)
{
    switch (format) {
    case voExternalFormatTypeScope::INTENSITY:
    case voExternalFormatTypeScope::LUMINANCE: return 1;
    case voExternalFormatTypeScope::LUMINANCE_ALPHA: return 2;
    case voExternalFormatTypeScope::RGBA:
    case voExternalFormatTypeScope::ABGR_EXT: return 4;
    default: unsupported("voxels of this external format cannot have styles");
    }
}

TexelKind kindOf(voDataType type)
{
    switch (type) {
    case voDataTypeScope::UNSIGNED_BYTE: return TexelKind::uint8;
    case voDataTypeScope::UNSIGNED_SHORT: return TexelKind::uint16;
    case voDataTypeScope::FLOAT: return TexelKind::float32;
    default: unsupported("voxels of this data type cannot have styles: unsigned bytes, shorts or floats can");
    }
}

/// Copies the voxels of a brick to where they lie in the volume.
void copyBrick(const voBrick& brick, VoxelTexture& volume)
{
    int origin[3], size[3];
    brick.getBrickSizes(origin[0], origin[1], origin[2], size[0], size[1], size[2]);
    const auto* const from = static_cast<const std::byte*>(brick.getDataPtr());
    if (!from) badValue("a brick has no voxels; dataAlloc or setDataPtr gives it some");
    const std::size_t bytes = bytesOf(volume.kind), voxel = std::size_t(volume.components) * bytes;
    const bool isTurned = brick.getExternalFormat() == voExternalFormatTypeScope::ABGR_EXT;
    const int length = std::min(size[0], volume.size.x - origin[0]);
    for (int z = 0; z < size[2] && origin[2] + z < volume.size.z; ++z)
        for (int y = 0; y < size[1] && origin[1] + y < volume.size.y && length > 0; ++y) {
            const std::byte* const row = from + std::size_t(z * size[1] + y) * std::size_t(size[0]) * voxel;
            std::byte* const to =
                volume.texels.data() +
                ((std::size_t(origin[2] + z) * std::size_t(volume.size.y) + std::size_t(origin[1] + y)) *
                     std::size_t(volume.size.x) +
                 std::size_t(origin[0])) *
                    voxel;
            std::copy_n(row, std::size_t(length) * voxel, to);
            for (std::size_t i = 0; isTurned && i < std::size_t(length); ++i)
                for (std::size_t c = 0; c < 4; ++c)
                    std::copy_n(row + i * voxel + (3 - c) * bytes, bytes, to + i * voxel + c * bytes);
        }
}

std::shared_ptr<const VoxelTexture> voxelsOf(const voBrickSet& set)
{
    auto volume = std::make_shared<VoxelTexture>();
    set.getVolumeSizes(volume->size.x, volume->size.y, volume->size.z);
    const voBrick& first = *set.getBrick(0);
    volume->components = componentsOf(first.getExternalFormat());
    volume->kind = kindOf(first.getDataType());
    volume->texels.resize(volume->size.count() * std::size_t(volume->components) * bytesOf(volume->kind));
    for (int i = 0; i < set.getBrickCount(); ++i)
        copyBrick(*set.getBrick(i), *volume);
    return volume;
}

bool hasVoxelCoordinates(voInterleavedArrayType format)
{
    return format == voInterleavedArrayTypeScope::T3F_V3F ||
           format == voInterleavedArrayTypeScope::T3F_C3F_V3F ||
           format == voInterleavedArrayTypeScope::T3F_C4F_V3F;
}

/// Where the voxel coordinates begin in a record.
int coordinatesAt(voInterleavedArrayType format, int values)
{
    const int needed = format == voInterleavedArrayTypeScope::T3F_V3F       ? 6
                       : format == voInterleavedArrayTypeScope::T3F_C3F_V3F ? 9
                       : format == voInterleavedArrayTypeScope::T3F_C4F_V3F ? 10
                                                                            : 3;
    if (values < needed)
        badValue("the vertex format has " + std::to_string(needed) + " values a record, the tetrahedra " +
                 std::to_string(values));
    return hasVoxelCoordinates(format) ? values - needed : values - 3;
}

std::shared_ptr<const StyledTetras> tetrasOf(const voIndexedTetraSet& set, voInterleavedArrayType format,
                                             const VoxelSize& size)
{
    auto tetras = std::make_shared<StyledTetras>();
    const voVertexData& vertices = *set.getVertexData();
    const voIndices& indices = *set.getIndices();
    const int values = vertices.getValuesPerVertex(), at = coordinatesAt(format, values);
    const glm::vec3 counts(size.x, size.y, size.z);
    for (int i = 0; i < vertices.getCount(); ++i) {
        tetras->positions.push_back(glm::make_vec3(vertices[i] + values - 3));
        tetras->places.push_back(glm::make_vec3(vertices[i] + at) / counts);
    }
    if (indices.getCount() % 4 != 0) badValue("the indices are no multiple of four");
    tetras->indices.assign(indices.getDataPtr(), indices.getDataPtr() + indices.getCount());
    for (const int index : tetras->indices)
        if (index < 0 || index >= vertices.getCount())
            badValue("index " + std::to_string(index) + " names no vertex of " +
                     std::to_string(vertices.getCount()));
    return tetras;
}

/// What is made of the nodes of a scene, for as long as the style is one of them. The scene is kept, too.
struct KeptStyles
{
    explicit KeptStyles(std::shared_ptr<Scene> whole) : scene(std::move(whole)) {}

    std::shared_ptr<Scene> scene;
    ViewMessages messages{*scene};
    VoxelTextures textures{*scene, messages};
    VolumeStyles styles{textures, messages};
};

/// Edges of the tetrahedra against the same in voxels, on average: how large a voxel is.
double voxelEdge(const StyledTetras& tetras, const VoxelSize& size)
{
    const glm::vec3 counts(size.x, size.y, size.z);
    double space = 0, voxels = 0;
    for (std::size_t i = 0; i + 3 < tetras.indices.size(); i += 4)
        for (std::size_t k = 1; k < 4; ++k) {
            const auto a = std::size_t(tetras.indices[i]), b = std::size_t(tetras.indices[i + k]);
            space += double(glm::length(tetras.positions[a] - tetras.positions[b]));
            voxels += double(glm::length((tetras.places[a] - tetras.places[b]) * counts));
        }
    return space > 0 && voxels > 0 ? space / voxels : 1;
}

} // namespace
} // namespace vo

using namespace vo;

struct voX3DStyledVolume::Private
{
    voX3DScene& face;
    voBrickSetCollection* bricks;
    voIndexedTetraSet* tetras;
    voInterleavedArrayType format;

    std::unique_ptr<KeptStyles> kept;
    const Node* style = nullptr;
    bool headlight = true;
    std::vector<StyleLight> lights; // of eye space
    std::optional<double> sampling;
    bool isToldOfGaps = false;
    StyledVolume volume;
    ShadowStore shadows;
    ScenePainter painter;

    void setStyle(const Node* node)
    {
        if (!kept || kept->scene != face.d->scene) kept = std::make_unique<KeptStyles>(face.d->scene);
        style = node;
    }

    void copy()
    {
        const voBrickSet* const set = required(bricks, "bricks").getCurrentBrickSet();
        StyledVolume made;
        made.voxels = voxelsOf(*set);
        const VoxelSize& size = made.voxels->size;
        if (tetras) {
            made.tetras = tetrasOf(*tetras, format, size);
            made.unitLength = voxelEdge(*made.tetras, size);
        }
        made.dimensions = glm::vec3(size.x, size.y, size.z) * static_cast<float>(made.unitLength);
        volume = std::move(made);
    }

    StyledScene styledScene(const GLdouble* model, const GLdouble* projection, int width, int height)
    {
        ScenePainter::checkSize(width, height);
        if (!volume.voxels) badValue("there are no voxels");
        StyledScene made;
        made.width = width;
        made.height = height;
        made.clipFromEye = givenMatrix(projection, "projMatrix");
        made.background.opacity = 0;
        StyledVolume placed = volume;
        placed.worldFromLocal = givenMatrix(model, "modelMatrix");
        if (!placed.tetras) // whose corner is the origin, in the tetrahedra's space
            placed.worldFromLocal =
                glm::translate(placed.worldFromLocal, glm::dvec3(placed.dimensions) * 0.5);
        if (!applyStyle(placed)) return made;
        const PlaneSpacing planes = planeSpacing(made, placed, sampling.value_or(usualSampling(placed)));
        placed.spacing = planes.distance;
        if (!planes.meetsVolume && !std::exchange(isToldOfGaps, true))
            kept->scene->messages.push_back(
                {Severity::warning, style ? style->place : TextPlace(), kPlanesMissVolume});
        light(placed);
        shadows.add(placed, 0);
        made.volumes.push_back(std::move(placed));
        return made;
    }

private:
    /// False: it is not enabled.
    bool applyStyle(StyledVolume& placed)
    {
        if (!style) {
            placed.chains = {{}};
            return true;
        }
        DrawnStyle drawn = kept->styles.of(style, style->edition(), {*placed.voxels, placed.dimensions});
        if (drawn.isSurface) placed.surfaces = IsoSurfaces{{0.5f}, {drawn.chain}, 0.0f, nullptr};
        placed.chains = {std::move(drawn.chain)};
        placed.projection = drawn.projection;
        placed.stipple = std::move(drawn.stipple);
        return drawn.isEnabled;
    }

    void light(StyledVolume& placed) const
    {
        const glm::dmat4 localFromEye = glm::inverse(placed.worldFromLocal);
        if (headlight)
            placed.surroundings.lights.push_back(localLight(vo::headlight(glm::dmat4(1.0)), localFromEye));
        for (const StyleLight& each : lights)
            placed.surroundings.lights.push_back(localLight(each, localFromEye));
    }
};

voX3DStyledVolume::voX3DStyledVolume(voX3DScene& scene, const voX3DNode& style, voBrickSetCollection* bricks,
                                     voIndexedTetraSet* tetras, voInterleavedArrayType format)
    : d(new Private{scene, bricks, tetras, format, nullptr, nullptr, true, {}, {}, false, {}, {}, {}})
{
    d->setStyle(nullptr);
    update();
    setStyle(style);
}

voX3DStyledVolume::~voX3DStyledVolume()
{
    delete d;
}

void voX3DStyledVolume::setStyle(const voX3DNode& style)
{
    guarded("setStyle", [&] {
        const Node* node = nullptr;
        if (!style.isNull()) {
            node = static_cast<const Node*>(d->face.own(style));
            if (!isOf(node, "X3DVolumeRenderStyleNode")) badValue(node->typeName() + " is no style");
        }
        d->setStyle(node);
    });
}

void voX3DStyledVolume::update()
{
    guarded("update", [&] { d->copy(); });
}

void voX3DStyledVolume::setHeadlight(voBool on)
{
    d->headlight = on;
}

void voX3DStyledVolume::setSampling(double edges)
{
    guarded("setSampling", [&] { d->sampling = samplingOf(edges); });
}

void voX3DStyledVolume::addLight(float x, float y, float z, float intensity)
{
    guarded("addLight", [&] {
        const float length = std::hypot(x, y, z);
        if (!(length > 0) || !std::isfinite(length) || !(intensity >= 0))
            badValue("expected a direction and an intensity of at least 0");
        StyleLight light;
        light.direction = glm::vec3(x, y, z) / length;
        light.intensity = intensity;
        d->lights.push_back(light);
    });
}

voBool voX3DStyledVolume::draw(const GLdouble modelMatrix[16], const GLdouble projMatrix[16], int width,
                               int height, voEngine engine)
{
    return !guarded("draw", [&] {
        d->painter.draw(engine, [&] { return d->styledScene(modelMatrix, projMatrix, width, height); });
    });
}

void voX3DStyledVolume::releaseDrawing()
{
    d->painter.releaseDrawing();
}

voBool voX3DStyledVolume::picture(const GLdouble modelMatrix[16], const GLdouble projMatrix[16], int width,
                                  int height, float* rgba, int threads)
{
    return !guarded("picture", [&] {
        d->painter.picture(rgba, threads,
                           [&] { return d->styledScene(modelMatrix, projMatrix, width, height); });
    });
}
