#pragma once

#include "core/record_layout.h"
#include "draw/brick_texture.h"
#include "draw/context_record.h"
#include "frame/polygon_cache.h"
#include "frame/space_leaping.h"

#include <span>
#include <vector>

namespace vo {

/// One brick of a frame.
struct FrameBrick
{
    TextureImage image;
    glm::vec3 origin{0.0f};
    glm::vec3 size{1.0f};
    int thinAxis = -1; ///< of a two-dimensional brick
};

/// Seconds spent in the phases of frames, added up.
struct FrameTimes
{
    double polygonize = 0.0;
    double sort = 0.0;
    double load = 0.0; ///< sending textures
    double draw = 0.0;
};

struct FrameRequest
{
    TetraView tetras;
    RecordLayout layout; ///< texCoord >= 0: voxel coordinates; else the position is the voxel coordinate
    std::span<const Box> clipBoxes;
    std::span<const FrameBrick> bricks;
    SamplingRequest sampling;
    double threshold = 0.0; ///< degrees, see PolygonCache
    bool outlineBricks = false;
    bool outlineTetras = false;
    FrameTimes* times = nullptr; ///< measured where given; OpenGL is then waited for
};

enum class FrameResult {
    ok,
    singularMatrices,
    incompleteFramebuffer,
    textureTooLarge,
    outOfMemory,
    noVoxels
};

/// What frames of one volume keep from one to the next.
struct FrameCache
{
    PolygonCache polygons;
    SpaceLeaping leaping;

    void invalidate()
    {
        polygons.invalidate();
        leaping.invalidate();
    }
};

/// Draws a volume in the state of the context: polygons (from the cache while they are current), bricks back
/// to front, each with its texture. The caller's texture bindings and all else are given back.
FrameResult drawFrame(ContextRecord& context, const FrameRequest& request, FrameCache& cache);

/// Runs of bricks whose order is that of boxes (PolygonCache::bricksInterleave says of which it is not).
void sortBackToFront(std::span<PolygonCache::Run> runs, std::span<const Box> boxes, const Camera& camera);

/// Corners of the twelve edges of a box: 24 positions, 72 floats.
void appendBoxEdges(const glm::vec3& origin, const glm::vec3& size, std::vector<float>& positions);

/// The six edges of each tetrahedron: 12 positions, 36 floats.
void appendTetraEdges(const TetraView& tetras, std::vector<float>& positions);

} // namespace vo
