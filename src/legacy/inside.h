#pragma once

// What the classes of include/vo hold behind their private pointer, and the way from there to the inner
// stages.

#include "draw/context_record.h"

#include <vo/Appearance.h>
#include <vo/Geometry.h>
#include <vo/GeometryActions.h>
#include <vo/LookupTable.h>

#include "appearance/brick_grid.h"
#include "appearance/brick_source.h"
#include "core/record_layout.h"
#include "draw/brick_texture.h"
#include "frame/frame.h"
#include "lookup/visible_values.h"

#include <memory>
#include <optional>
#include <vector>

struct voVertexData::Private
{
    std::vector<float> own;
    float* data = nullptr;
    int countMax = 0;
    int count = 0;
    int values = 1;
};

struct voIndices::Private
{
    std::vector<int> own;
    int* data = nullptr;
    int countMax = 0;
    int count = 0;
    int scratch = 0; ///< what operator[] refers to outside
};

struct voIndexedSet::Private
{
    std::unique_ptr<voVertexData> ownVertices;
    std::unique_ptr<voIndices> ownIndices;
    voVertexData* vertices = nullptr;
    voIndices* indices = nullptr;
};

struct voTexture3D::Private
{
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    voDataType dataType;
    int size[3] = {1, 1, 1};
    std::unique_ptr<vo::BrickSource> ownSource; ///< of a texture outside any collection
    vo::BrickSource* source = nullptr;
    std::size_t slot = 0; ///< number in the source
    std::uint64_t id = 0;
    std::uint64_t version = 1;

    // Of a brick.
    float origin[3] = {0, 0, 0};
    float extent[3] = {1, 1, 1};
    vo::VoxelSize volume;
    int overlap = 0;
    bool inVolume = false; ///< the two above mean something
    voPlaneOrientation orientation = voPlaneOrientationScope::UNSPECIFIED;
    bool inStack = false; ///< drawn as GL_TEXTURE_2D

    std::shared_ptr<char> clique; ///< shared with the texture that this one is interleaved with
};

struct voBrickSet::Private
{
    std::vector<std::unique_ptr<voBrick>> bricks;
    vo::VoxelSize volume;
    vo::VoxelSize requested;
    int overlap = 0;
    voPlaneOrientation orientation = voPlaneOrientationScope::UNSPECIFIED;
};

struct voBrickSetCollection::Private
{
    // Declared before the sets: bricks let their storage go when they die.
    std::unique_ptr<vo::BrickSource> source;
    std::vector<std::unique_ptr<voBrickSet>> sets;
};

struct voLookupTable::Private
{
    GLenum internalFormat = 0;
    GLenum externalFormat = 0;
    GLenum dataType = 0;
    int width = 0;
    const void* data = nullptr;
    bool ramp = false; ///< set() was called: the ramp below counts, not data
    float rampCenter = 0;
    float rampWidth = 1;
    std::shared_ptr<vo::TableSlot> slot;
    std::optional<vo::VisibleValues> visible; ///< since load()
};

struct voDrawActionCache::Private
{
    int maxSamples = 1;
    voSamplingMode samplingMode = voSamplingModeScope::DEFAULT;
    double threshold = 0.0;
    vo::FrameCache frames;
};

/// The friend of every class of the face: hands out what is private.
struct voInside
{
    using VertexData = voVertexData::Private;
    using Indices = voIndices::Private;
    using Texture = voTexture3D::Private;
    using BrickSet = voBrickSet::Private;
    using DrawCache = voDrawActionCache::Private;

    static voVertexData::Private& of(voVertexData& v) { return *v.d; }
    static voIndices::Private& of(voIndices& i) { return *i.d; }
    static voIndexedSet::Private& of(voIndexedSet& s) { return *s.d; }
    static voTexture3D::Private& of(voTexture3D& t) { return *t.d; }
    static const voTexture3D::Private& of(const voTexture3D& t) { return *t.d; }
    static voBrickSet::Private& of(voBrickSet& s) { return *s.d; }
    static voBrickSetCollection::Private& of(voBrickSetCollection& c) { return *c.d; }
    static voDrawActionCache::Private& of(voDrawActionCache& c) { return *c.d; }
};

namespace vo {

/// The tetrahedra of a legacy set. Throws CallerError when the indices are no multiple of four or point
/// outside.
TetraView tetraView(voIndexedTetraSet& set);

/// The clip boxes of a set's bricks.
void clipBoxes(const voBrickSet& set, std::vector<Box>& boxes);

/// A texture as the draw stage takes it. Throws CallerError when its voxels are fewer than its sizes need.
TextureImage textureImage(const voTexture3D& texture);

/// Axis on which a brick of a stack is one voxel thick: 2, 1, 0 for XY, XZ, YZ; -1 for UNSPECIFIED.
int thinAxis(voPlaneOrientation orientation);

/// The view of these matrices. Throws CallerError when they are NULL or singular.
Camera cameraOf(const GLdouble* model, const GLdouble* projection);

/// What a program asks of the sampling surfaces. Throws CallerError for values without meaning.
SamplingRequest samplingRequest(int mode, int space, const float* period, int maxSamples,
                                voPlaneOrientation orientation);

/// The stack whose slices lie across an axis (0, 1, 2).
voPlaneOrientation stackAcross(int axis);

/// A frame of more samples than this would never end: "no bound" from a program means this many.
constexpr int kMostFrameSamples = 1 << 16;

/// The context that is current. Throws CallerError (UNSUPPORTED) without one, or when it is too old.
ContextRecord& requireContext();

} // namespace vo
