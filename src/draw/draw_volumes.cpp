#include "draw/draw_volumes.h"

#include "cast/clear_space.h"
#include "cast/edge_shift.h"
#include "core/invertible.h"
#include "draw/occupied_layers.h"
#include "draw/scene_view_point.h"
#include "draw/seen_bounds.h"
#include "polygonize/slice_stack.h"
#include "style/styled_voxels.h"
#include "style/texel_list.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace vo {

namespace {

/// A new texture, unless it is the same.
void replaceTexels(VoxelTexture& texture, TexelKind kind, const VoxelSize& size,
                   std::vector<std::byte> texels)
{
    if (texels == texture.texels && size == texture.size) return;
    texture.size = size;
    texture.kind = kind;
    texture.nearest = true;
    texture.texels = std::move(texels);
    texture.serial = newSerial();
}

VolumeWay wayOf(const StyledVolume& volume, VolumePlace place)
{
    if (isProjected(volume)) return volume.tetras ? VolumeWay::planeSamples : VolumeWay::projectedRays;
    return place != VolumePlace::among && !volume.tetras ? VolumeWay::rays : VolumeWay::slices;
}

RayReach partOf(VolumePlace place)
{
    if (place == VolumePlace::betweenHits) return RayReach::betweenHits;
    return place == VolumePlace::ofHits ? RayReach::nextHit : RayReach::whole;
}

/// -1 where there is no such chain.
int chainNumber(int chain, const std::vector<int>& numberOf)
{
    const bool isThere = chain >= 0 && static_cast<std::size_t>(chain) < numberOf.size();
    return isThere ? numberOf[static_cast<std::size_t>(chain)] : -1;
}

/// A list (style/texel_list.h) of floats, or of vectors of them.
template <class Number>
void replaceList(VoxelTexture& texture, std::span<const Number> numbers)
{
    const VoxelSize size = listSize(numbers.size());
    std::vector<std::byte> texels(size.count() * sizeof(Number));
    std::ranges::copy(std::as_bytes(numbers), texels.begin());
    texture.components = sizeof(Number) / sizeof(float);
    replaceTexels(texture, TexelKind::float32, size, std::move(texels));
}

/// The chains of segments as programs number them.
std::vector<float> chainNumbers(const Segments& segments, const std::vector<int>& numberOf)
{
    std::vector<float> numbers;
    for (const int chain : segments.chainOf)
        numbers.push_back(static_cast<float>(chainNumber(chain, numberOf)));
    return numbers;
}

} // namespace

bool isDrawn(const StyledVolume& volume)
{
    if (!volume.voxels || volume.stipple) return false;
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
                          VolumePlace place)
{
    scene_ = &scene;
    volume_ = &volume;
    const bool alone = place == VolumePlace::alone;
    way_ = wayOf(volume, place);
    part_ = partOf(place);
    isMerged_ = isProjected(volume) && place == VolumePlace::among;
    if (way_ != VolumeWay::slices) countPlanes(scene, volume, layers_);
    const bool isOfSamples = !volume.tetras && !volume.surfaces;
    const bool mayLeap = way_ == VolumeWay::rays || (way_ == VolumeWay::slices && isOfSamples);
    const ClearBlocks clear = mayLeap ? findClearBlocks() : ClearBlocks();
    if (!takesRays()) cutSlices(clear, slicer);
    if (layers_.layers.empty()) return;
    // Nothing else lies between parts of it.
    if (alone && way_ != VolumeWay::slices) layers_.layers.front().reach = 0.0;
    leaps_ = way_ == VolumeWay::rays && !clear.empty();
    if (leaps_) keepClearBlocks(clear);
    texts_ = volumeProgram(volume, {way_, leaps_, isMerged_, part_});
    program_ = &resources_.programs.find(texts_.vertexText, texts_.fragmentText);
    fillChainTextures();
    if (takesRays())
        sendRays();
    else
        sendSlices();
}

/// Of pixels beside the volume drivers may compute all that those in it need.
void DrawnVolume::sendRays()
{
    const SeenBounds bounds = seenBounds(*scene_, *volume_);
    const glm::dvec2 pixel(2.0 / scene_->width, 2.0 / scene_->height);
    arrays_.sendRectangle(glm::clamp(bounds.lower - pixel, -1.0, 1.0),
                          glm::clamp(bounds.upper + pixel, -1.0, 1.0));
}

void DrawnVolume::fillChainTextures()
{
    replaceList(chainRows_, std::span<const glm::vec4>(texts_.chainRows));
    const auto& tables = texts_.chains.tableStack();
    std::vector<std::uint64_t> serials = tables ? tables->serials() : std::vector<std::uint64_t>();
    if (serials == tablesStacked_) return;
    if (tables && tables->size().z > resources_.context.most3dTexels)
        throw std::runtime_error("the transfer functions of a volume's styles fill " +
                                 sizeText(tables->size()) + " texels: this driver takes " +
                                 std::to_string(resources_.context.most3dTexels) + " on an axis");
    stackedTables_ = serials.empty() ? VoxelTexture() : tables->texture();
    tablesStacked_ = std::move(serials);
}

/// None where it is not known.
ClearBlocks DrawnVolume::findClearBlocks()
{
    if (!isSound(*volume_)) return {};
    const VoxelTexture& voxels = *volume_->voxels;
    const VoxelBlocks& blocks = resources_.textures.blocks(voxels);
    std::span<const std::uint64_t> chainsIn;
    if (volume_->segments && !volume_->surfaces) {
        const auto chains = static_cast<int>(volume_->chains.size());
        if (!segmentBlocks_ || !segmentBlocks_->isOf(blocks, voxels.size, *volume_->segments, chains))
            segmentBlocks_.emplace(blocks, voxels.size, *volume_->segments, chains, 0);
        chainsIn = segmentBlocks_->chainsIn();
    }
    return clearBlocksOf(*volume_, blocks, chainsIn);
}

void DrawnVolume::keepClearBlocks(const ClearBlocks& clear)
{
    const VoxelSize size{clear.count().x, clear.count().y, clear.count().z};
    std::vector<std::byte> texels(size.count());
    std::ranges::copy(std::as_bytes(std::span(clear.distances()).first(texels.size())), texels.begin());
    replaceTexels(clearBlocks_, TexelKind::uint8, size, std::move(texels));
}

/// Where nothing is clear, or little, all of the planes.
void DrawnVolume::cutSlices(const ClearBlocks& clear, StackSlicer& slicer)
{
    const bool isCut =
        !clear.empty() && cutOccupiedLayers(*scene_, *volume_, clear, occupiedSlicer_, layers_);
    if (!isCut) cutLayers(*scene_, *volume_, slicer, isJoined() ? planes_ : layers_);
}

void DrawnVolume::sendSlices()
{
    const VolumeLayers& cut = isJoined() ? planes_ : layers_;
    const int values = cut.valuesPerRecord;
    arrays_.send(cut.stack.records.data(), cut.stack.records.size());
    arrays_.attribute(kSliceVoxel, 3, values - 3, values);
    if (volume_->tetras)
        for (GLuint column = 0; column < 4; ++column)
            arrays_.attribute(kSlicePlace + column, 3, static_cast<int>(3 * column), values);
    arrays_.sendIndices(cut.stack.indices.data(), cut.stack.indices.size());
}

void DrawnVolume::bindTextures(const TranslucentTarget& target)
{
    const auto& textures = texts_.chains.textures();
    const bool hasRows = !texts_.chainRows.empty(), hasTables = !stackedTables_.texels.empty();
    const int units = 1 + static_cast<int>(textures.size()) + (volume_->segments ? 2 : 0) + unitsOfPicture() +
                      (leaps_ ? 1 : 0) + (hasRows ? 1 : 0) + (hasTables ? 1 : 0);
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
    unit = bindPicture(target, unit);
    if (leaps_) {
        resources_.textures.bind(unit, clearBlocks_);
        program_->set("clearBlocks", unit++);
    }
    if (hasRows) {
        resources_.textures.bind(unit, chainRows_);
        program_->set("chainNumbers", unit++);
    }
    if (hasTables) {
        resources_.textures.bind(unit, stackedTables_);
        program_->set("stackedTables", unit++);
    }
    if (volume_->segments) bindSegments(*volume_->segments, unit);
}

/// How many textures say where rays begin and end.
int DrawnVolume::unitsOfPicture() const
{
    if (!takesRays()) return 0;
    return part_ == RayReach::whole ? 1 : part_ == RayReach::nextHit ? 2 : 3;
}

/// Those, from this unit on; returns the unit that follows.
int DrawnVolume::bindPicture(const TranslucentTarget& target, int unit)
{
    const GladGLContext& gl = resources_.context.gl;
    const auto bind = [&](GLuint texture, const char* name) {
        gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        gl.BindTexture(GL_TEXTURE_2D, texture);
        program_->set(name, unit++);
    };
    if (takesRays()) bind(target.depths(), "windowDepths");
    if (part_ == RayReach::whole) return unit;
    bind(hits_->reached(), "reached");
    if (part_ == RayReach::betweenHits) bind(hits_->next(), "next");
    program_->set("source", source_);
    return unit;
}

void DrawnVolume::bindSegments(const Segments& segments, int unit)
{
    const std::vector<int>& numberOf = texts_.chainNumberOf;
    const std::vector<float> numbers = chainNumbers(segments, numberOf);
    replaceList(chainTable_, std::span<const float>(numbers));
    resources_.textures.bind(unit, *segments.identifiers);
    resources_.textures.bind(unit + 1, chainTable_);
    program_->set("identifiers", unit);
    program_->set("chainTable", unit + 1);
    program_->set("identifierScale", segments.scale);
    program_->set("chainsGiven", static_cast<int>(segments.chainOf.size()));
    program_->set("chainBeyond", chainNumber(segments.beyond, numberOf));
}

void DrawnVolume::setView(SceneProgram& program) const
{
    const glm::dmat4& worldFromLocal = volume_->worldFromLocal;
    const glm::dmat4 clipFromLocal = scene_->clipFromEye * scene_->eyeFromWorld * worldFromLocal;
    const VoxelSize& size = volume_->voxels->size;
    const glm::vec3 count(size.x, size.y, size.z), edges = volume_->dimensions / count;
    program.set("clipFromVoxel", glm::mat4(clipFromLocal * localFromVoxel(*volume_)));
    const glm::dmat4 eyeFromLocal = scene_->eyeFromWorld * worldFromLocal;
    const glm::dmat4 shift = glm::inverse(eyeFromLocal) * edgeShift(*scene_) * eyeFromLocal;
    program.set("clipFromLocal", glm::mat4(clipFromLocal));
    program.set("edgeShift", glm::mat4(shift));
    program.set("voxelCount", count);
    program.set("dimensions", volume_->dimensions);
    program.set("viewer", glm::vec4(viewerIn(*scene_, worldFromLocal)));
    program.set("depthRow", glm::vec4(depthRowOf(*scene_, worldFromLocal)));
    program.set("spacing", static_cast<float>(volume_->spacing));
    program.set("unitLength", static_cast<float>(volume_->unitLength));
    program.set("shortestEdge", std::min({edges.x, edges.y, edges.z}));
    if (takesRays()) setRays(program);
    std::vector<glm::vec4> planes;
    for (const glm::dvec4& plane : volume_->clipPlanes)
        planes.emplace_back(plane * worldFromLocal * shift);
    program.set("clipPlanes", std::span<const glm::vec4>(planes));
}

void DrawnVolume::drawApart(const TranslucentTarget& target)
{
    if (!isJoined() || layers_.layers.empty()) return;
    if (!joiner_) joiner_ = std::make_unique<PlaneJoiner>(resources_);
    const std::vector<SliceLayer>& cut = planes_.layers;
    const auto fromNearest = [&cut](std::size_t i) -> const SliceLayer& { return cut[cut.size() - 1 - i]; };
    joiner_->join(*volume_->projection,
                  {scene_->width, scene_->height, target.depths(), cut.size(),
                   [&](std::size_t i) { return planeOf(fromNearest(i), *volume_); },
                   [&] { useProgram(target); },
                   [&](std::size_t i) { drawSlice(fromNearest(i).first, fromNearest(i).count); }});
}

void DrawnVolume::keep(const TranslucentTarget& target, const ProjectionMerger& merger, std::size_t layer)
{
    const GladGLContext& gl = resources_.context.gl;
    merger.bind(layer);
    gl.Disable(GL_DEPTH_TEST);
    gl.Disable(GL_BLEND);
    if (isJoined()) {
        joiner_->keep(*volume_->projection, volume_->spacing);
    } else {
        useProgram(target);
        drawRays();
    }
    gl.Enable(GL_BLEND);
}

void DrawnVolume::use(const TranslucentTarget& target)
{
    if (takesRays() || isJoined())
        target.bindWithoutDepths();
    else
        target.bindWithDepths();
    const GladGLContext& gl = resources_.context.gl;
    if (way_ == VolumeWay::slices)
        gl.Enable(GL_DEPTH_TEST);
    else
        gl.Disable(GL_DEPTH_TEST);
    if (!isJoined()) useProgram(target);
}

void DrawnVolume::useProgram(const TranslucentTarget& target)
{
    program_->use();
    arrays_.bind();
    bindTextures(target);
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
    const glm::dmat4& clip = scene_->clipFromEye;
    const double base = layers_.middlePlane * volume_->spacing;
    const EyeRays rays = eyeRays(clip);
    glm::dmat3 origins = glm::dmat3(localFromEye) * (rays.origin + base * rays.direction);
    origins[0] += glm::dvec3(localFromEye[3]);
    program.set("rayOrigins", glm::mat3(origins));
    program.set("rayDirections", glm::mat3(glm::dmat3(localFromEye) * rays.direction));
    const glm::dmat4 shift = edgeShift(*scene_);
    const glm::dvec3 way = -glm::dvec3(shift[2]) - glm::dvec3(0.0, 0.0, -1.0);
    program.set("originShift", glm::vec3(glm::dmat3(localFromEye) * (glm::dvec3(shift[3]) + base * way)));
    program.set("wayShift", glm::vec3(glm::dmat3(localFromEye) * way));
    const DepthsSeen seen = depthsSeen(clip);
    program.set("depthsSeen", glm::vec2(seen.nearest - base, std::min(seen.farthest - base, 1e30)));
    program.set("depthBase", static_cast<float>(base));
    program.set("depthsInWindow", glm::vec4(clip[2][2], clip[2][3], clip[3][2], clip[3][3]));
    if (volume_->projection) program.set("intensityThreshold", volume_->projection->intensityThreshold);
}

void DrawnVolume::drawSlice(std::size_t first, std::size_t count) const
{
    resources_.context.gl.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                                       reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
}

void DrawnVolume::drawRays() const
{
    resources_.context.gl.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void DrawnVolume::drawBetween(const RayHits& hits, float source, const TranslucentTarget& target)
{
    if (layers_.layers.empty()) return;
    hits_ = &hits;
    source_ = source;
    target.bindWithoutDepths();
    useProgram(target);
    drawRays();
}

void DrawnVolume::findHits(const RayHits& hits, std::size_t source, const TranslucentTarget& target)
{
    if (layers_.layers.empty()) return;
    hits_ = &hits;
    source_ = static_cast<float>(source);
    useProgram(target);
    drawRays();
}

void DrawnVolume::draw(const SceneStep& step)
{
    if (isJoined()) return joiner_->draw(*volume_->projection);
    if (takesRays()) return drawRays();
    if (volume_->surfaces) {
        const auto partTo = [&](double depth) {
            constexpr double kBeyond = 2.0;
            return static_cast<float>(
                std::clamp((depth - step.layer.depth) / step.layer.reach, -kBeyond, kBeyond));
        };
        program_->set("part", glm::vec2(partTo(step.nearest), partTo(step.farthest)));
    }
    drawSlice(step.layer.first, step.layer.count);
}

} // namespace vo
