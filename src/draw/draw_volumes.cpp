#include "draw/draw_volumes.h"

#include "core/invertible.h"
#include "draw/scene_view_point.h"
#include "polygonize/slice_stack.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace vo {

namespace {

constexpr int kTableWidth = 1024;

/// chainOf as texels, in rows.
void fillChainTable(const std::vector<int>& chainOf, VoxelTexture& table)
{
    const int count = std::max(static_cast<int>(chainOf.size()), 1);
    const VoxelSize size{std::min(count, kTableWidth), (count + kTableWidth - 1) / kTableWidth, 1};
    std::vector<float> values(size.count(), 0.0f);
    std::ranges::transform(chainOf, values.begin(), [](int chain) { return static_cast<float>(chain); });
    std::vector<std::byte> texels(values.size() * sizeof(float));
    std::memcpy(texels.data(), values.data(), texels.size());
    if (texels == table.texels && size == table.size) return;
    table.size = size;
    table.kind = TexelKind::float32;
    table.nearest = true;
    table.texels = std::move(texels);
    table.serial = newSerial();
}

} // namespace

bool isDrawn(const StyledVolume& volume)
{
    if (!volume.voxels || volume.stipple || (volume.tetras && isProjected(volume))) return false;
    if (!isInvertible(volume.worldFromLocal) || volume.chains.empty()) return false;
    for (const double length :
         {static_cast<double>(volume.dimensions.x), static_cast<double>(volume.dimensions.y),
          static_cast<double>(volume.dimensions.z), volume.unitLength, volume.spacing})
        if (!(length > 0.0) || !std::isfinite(length)) return false;
    if (volume.segments && !volume.segments->identifiers) return false;
    return !volume.surfaces || (!volume.surfaces->values.empty() && !volume.surfaces->chains.empty());
}

DrawnVolume::DrawnVolume(SceneResources& resources) : resources_(resources), arrays_(resources.context) {}

void DrawnVolume::prepare(const StyledScene& scene, const StyledVolume& volume, StackSlicer& slicer,
                          const OpaqueDepths* opaqueDepths)
{
    scene_ = &scene;
    volume_ = &volume;
    opaqueDepths_ = opaqueDepths;
    if (isProjected(volume))
        countLayers(scene, volume, layers_);
    else
        cutLayers(scene, volume, slicer, layers_);
    if (layers_.layers.empty()) return;
    texts_ = volumeProgram(volume, opaqueDepths != nullptr);
    program_ = &resources_.programs.find(texts_.vertexText, texts_.fragmentText);
    if (isProjected(volume))
        arrays_.sendPictureTriangle();
    else
        sendSlices();
}

void DrawnVolume::sendSlices()
{
    const int values = layers_.valuesPerRecord;
    arrays_.send(layers_.stack.records.data(), layers_.stack.records.size());
    arrays_.attribute(kSliceVoxel, 3, values - 3, values);
    if (volume_->tetras)
        for (GLuint column = 0; column < 4; ++column)
            arrays_.attribute(kSlicePlace + column, 3, static_cast<int>(3 * column), values);
    arrays_.sendIndices(layers_.stack.indices.data(), layers_.stack.indices.size());
}

void DrawnVolume::bindTextures()
{
    const auto& textures = texts_.chains.textures();
    const int units =
        1 + static_cast<int>(textures.size()) + (volume_->segments ? 2 : 0) + (opaqueDepths_ ? 1 : 0);
    if (units > resources_.context.mostUnits)
        throw std::runtime_error("a volume reads " + std::to_string(units) + " textures, this driver takes " +
                                 std::to_string(resources_.context.mostUnits));
    resources_.textures.bind(0, *volume_->voxels);
    program_->set("voxels", 0);
    int unit = 1;
    for (const GlslChain::Texture& texture : textures) {
        resources_.textures.bind(unit, *texture.texture);
        program_->set(texture.name, unit++);
    }
    if (opaqueDepths_) {
        opaqueDepths_->bind(unit);
        program_->set("opaqueDepths", unit++);
    }
    if (volume_->segments) bindSegments(*volume_->segments, unit);
}

void DrawnVolume::bindSegments(const Segments& segments, int unit)
{
    fillChainTable(segments.chainOf, chainTable_);
    resources_.textures.bind(unit, *segments.identifiers);
    resources_.textures.bind(unit + 1, chainTable_);
    program_->set("identifiers", unit);
    program_->set("chainTable", unit + 1);
    program_->set("identifierScale", segments.scale);
    program_->set("chainsGiven", static_cast<int>(segments.chainOf.size()));
    program_->set("chainBeyond", segments.beyond);
}

void DrawnVolume::setView(SceneProgram& program) const
{
    const glm::dmat4& worldFromLocal = volume_->worldFromLocal;
    const glm::dmat4 clipFromLocal = scene_->clipFromEye * scene_->eyeFromWorld * worldFromLocal;
    const VoxelSize& size = volume_->voxels->size;
    const glm::vec3 count(size.x, size.y, size.z), edges = volume_->dimensions / count;
    program.set("clipFromVoxel", glm::mat4(clipFromLocal * localFromVoxel(*volume_)));
    program.set("clipFromLocal", glm::mat4(clipFromLocal));
    program.set("voxelCount", count);
    program.set("dimensions", volume_->dimensions);
    program.set("viewer", glm::vec4(viewerIn(*scene_, worldFromLocal)));
    program.set("depthRow", glm::vec4(depthRowOf(*scene_, worldFromLocal)));
    program.set("spacing", static_cast<float>(volume_->spacing));
    program.set("unitLength", static_cast<float>(volume_->unitLength));
    program.set("shortestEdge", std::min({edges.x, edges.y, edges.z}));
    if (isProjected(*volume_)) setRays(program);
    std::vector<glm::vec4> planes;
    for (const glm::dvec4& plane : volume_->clipPlanes)
        planes.emplace_back(plane * worldFromLocal);
    program.set("clipPlanes", std::span<const glm::vec4>(planes));
}

void DrawnVolume::use()
{
    program_->use();
    arrays_.bind();
    bindTextures();
    setView(*program_);
    program_->set(volume_->surroundings.lights);
    for (const GlslChain::Uniform& uniform : texts_.chains.uniforms())
        program_->set(uniform);
    if (!volume_->surfaces) return;
    program_->set("surfaceValues", std::span<const float>(volume_->surfaces->values));
    program_->set("surfaceTolerance", volume_->surfaces->surfaceTolerance);
}

void DrawnVolume::setRays(SceneProgram& program) const
{
    const glm::dmat4 localFromEye = glm::inverse(scene_->eyeFromWorld * volume_->worldFromLocal);
    const EyeRays rays = eyeRays(scene_->clipFromEye);
    glm::dmat3 origins = glm::dmat3(localFromEye) * rays.origin;
    origins[0] += glm::dvec3(localFromEye[3]);
    program.set("rayOrigins", glm::mat3(origins));
    program.set("rayDirections", glm::mat3(glm::dmat3(localFromEye) * rays.direction));
    const DepthsSeen seen = depthsSeen(scene_->clipFromEye);
    program.set("depthsSeen", glm::vec2(seen.nearest, std::min(seen.farthest, 1e30)));
    program.set("intensityThreshold", volume_->projection->intensityThreshold);
}

void DrawnVolume::draw(std::size_t first, std::size_t count) const
{
    const GladGLContext& gl = resources_.context.gl;
    if (!isProjected(*volume_)) {
        gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                        reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
        return;
    }
    const double last = layers_.lastPlane - static_cast<double>(first);
    program_->set("band", glm::vec2(last - static_cast<double>(count) + 0.5, last + 0.5));
    gl.DrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace vo
