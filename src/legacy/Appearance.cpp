#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include <atomic>
#include <cmath>
#include <cstdint>

using vo::badValue;
using vo::guarded;

namespace {

std::uint64_t nextTextureId()
{
    static std::atomic<std::uint64_t> next{1};
    return next++;
}

vo::VoxelFormat voxelFormat(const voInside::Texture& d);

/// Bytes of the widest voxel: four channels of 32 bits.
constexpr std::uint64_t kMostVoxelBytes = 16;

/// Each size at least 1, and the voxels of any format countable in bytes.
void checkSizes(const vo::VoxelSize& size, const char* what)
{
    const std::string sizes = std::string(what) + " sizes " + std::to_string(size.x) + " x " +
                              std::to_string(size.y) + " x " + std::to_string(size.z);
    if (size.x < 1 || size.y < 1 || size.z < 1) badValue(sizes + ", each must be 1 or more");
    const auto x = static_cast<std::uint64_t>(size.x), y = static_cast<std::uint64_t>(size.y);
    if (x * y > PTRDIFF_MAX / kMostVoxelBytes / static_cast<std::uint64_t>(size.z))
        badValue(sizes + " are more voxels than memory can have");
}

/// Textures that are interleaved have one size.
void letPartnerGo(const vo::VoxelSize& size, voInside::Texture& d)
{
    if (size != vo::VoxelSize{d.size[0], d.size[1], d.size[2]}) d.clique.reset();
}

/// Borrowed voxels are as many as the sizes say, whichever was told first.
void refreshBorrowed(voTexture3D& texture)
{
    const voInside::Texture& d = voInside::of(texture);
    std::byte* const data = d.source->voxels(d.slot).data();
    if (data && !d.source->owns(d.slot)) d.source->borrow(d.slot, {data, texture.getDataSize()});
}

} // namespace

voTexture3D::voTexture3D(voInternalFormatType internalFormat, voExternalFormatType externalFormat,
                         voDataType dataType)
    : d(new Private)
{
    d->id = nextTextureId();
    d->internalFormat = voInternalFormatTypeScope::INTENSITY8_EXT;
    d->externalFormat = voExternalFormatTypeScope::LUMINANCE;
    d->dataType = voDataTypeScope::UNSIGNED_BYTE;
    d->ownSource = std::make_unique<vo::MemoryBrickSource>(1);
    d->source = d->ownSource.get();
    guarded("voTexture3D", [&] {
        const voExternalFormatType external = vo::resolveExternalFormat(externalFormat);
        const voInternalFormatType internal = vo::resolveInternalFormat(internalFormat, external);
        const voDataType type = vo::resolveDataType(dataType);
        vo::texelFormat(internal);
        if (!vo::isValid({vo::channels(external), vo::voxelType(type)}))
            vo::unsupported("a packed data type needs RGBA or ABGR_EXT voxels, 3_3_2 needs RGBA");
        d->internalFormat = internal;
        d->externalFormat = external;
        d->dataType = type;
    });
}

voTexture3D::~voTexture3D()
{
    vo::forgetTexture(d->id);
    delete d;
}

void* voTexture3D::getDataPtr() const
{
    return d->source->voxels(d->slot).data();
}

void voTexture3D::setDataPtr(void* data)
{
    d->source->borrow(d->slot, {static_cast<std::byte*>(data), data ? getDataSize() : 0});
    ++d->version;
}

voInternalFormatType voTexture3D::getInternalFormat() const
{
    return d->internalFormat;
}

voExternalFormatType voTexture3D::getExternalFormat() const
{
    return d->externalFormat;
}

voDataType voTexture3D::getDataType() const
{
    return d->dataType;
}

void voTexture3D::getSizes(int& xSize, int& ySize, int& zSize) const
{
    xSize = d->size[0];
    ySize = d->size[1];
    zSize = d->size[2];
}

void voTexture3D::setSizes(int xSize, int ySize, int zSize)
{
    guarded("voTexture3D::setSizes", [&] {
        checkSizes({xSize, ySize, zSize}, "texture");
        letPartnerGo({xSize, ySize, zSize}, *d);
        d->size[0] = xSize;
        d->size[1] = ySize;
        d->size[2] = zSize;
        ++d->version;
        refreshBorrowed(*this);
    });
}

size_t voTexture3D::getDataSize() const
{
    return vo::VoxelSize{d->size[0], d->size[1], d->size[2]}.count() * vo::voxelBytes(voxelFormat(*d));
}

namespace {

vo::VoxelFormat voxelFormat(const voInside::Texture& d)
{
    return {vo::channels(d.externalFormat), vo::voxelType(d.dataType)};
}

} // namespace

voBrick::voBrick(voInternalFormatType internalFormat, voExternalFormatType externalFormat,
                 voDataType dataType)
    : voTexture3D(internalFormat, externalFormat, dataType)
{
}

voBrick::~voBrick() = default;

void voBrick::setBrickSizes(float xmin, float ymin, float zmin, float xSize, float ySize, float zSize)
{
    constexpr float kTooFar = 2147483648.0f; // does not fit an int
    guarded("voBrick::setBrickSizes", [&] {
        const float origin[3] = {xmin, ymin, zmin}, size[3] = {xSize, ySize, zSize};
        for (int axis = 0; axis < 3; ++axis)
            if (!(std::abs(origin[axis]) < kTooFar) || !(size[axis] >= 1.0f) || !(size[axis] < kTooFar))
                badValue("axis " + std::to_string(axis) + ": origin " + std::to_string(origin[axis]) +
                         ", size " + std::to_string(size[axis]) + "; a size of 1 or more is needed");
        const vo::VoxelSize voxels{static_cast<int>(xSize), static_cast<int>(ySize), static_cast<int>(zSize)};
        checkSizes(voxels, "brick");
        letPartnerGo(voxels, *d);
        for (int axis = 0; axis < 3; ++axis) {
            d->origin[axis] = origin[axis];
            d->extent[axis] = size[axis];
            d->size[axis] = voxels[axis];
        }
        ++d->version;
        refreshBorrowed(*this);
    });
}

void voBrick::getBrickSizes(int& xmin, int& ymin, int& zmin, int& xSize, int& ySize, int& zSize) const
{
    xmin = static_cast<int>(d->origin[0]);
    ymin = static_cast<int>(d->origin[1]);
    zmin = static_cast<int>(d->origin[2]);
    getSizes(xSize, ySize, zSize);
}

void voBrick::getBrickSizes(float* position, float* size) const
{
    for (int axis = 0; axis < 3; ++axis) {
        if (position) position[axis] = d->origin[axis];
        if (size) size[axis] = d->extent[axis];
    }
}

void voBrick::getClipBrickSizes(float* lowerLeft, float* upperRight) const
{
    const glm::dvec3 origin(d->origin[0], d->origin[1], d->origin[2]);
    const glm::dvec3 size(d->extent[0], d->extent[1], d->extent[2]);
    const vo::Box box =
        d->inVolume ? vo::clipBox(origin, size, d->volume, d->overlap) : vo::Box{origin, origin + size};
    for (int axis = 0; axis < 3; ++axis) {
        if (lowerLeft) lowerLeft[axis] = static_cast<float>(box.lower[axis]);
        if (upperRight) upperRight[axis] = static_cast<float>(box.upper[axis]);
    }
}

voBrickSet::voBrickSet() : d(new Private) {}

voBrickSet::~voBrickSet()
{
    delete d;
}

int voBrickSet::getBrickCount() const
{
    return static_cast<int>(d->bricks.size());
}

voBrick* voBrickSet::getBrick(int index) const
{
    voBrick* brick = nullptr;
    guarded("voBrickSet::getBrick", [&] {
        if (index < 0 || index >= getBrickCount())
            badValue("brick " + std::to_string(index) + " is outside 0 to " +
                     std::to_string(getBrickCount() - 1));
        brick = d->bricks[static_cast<std::size_t>(index)].get();
    });
    return brick;
}

void voBrickSet::getVolumeSizes(int& xSize, int& ySize, int& zSize) const
{
    xSize = d->volume.x;
    ySize = d->volume.y;
    zSize = d->volume.z;
}

void voBrickSet::getBrickSizes(int& xSize, int& ySize, int& zSize) const
{
    xSize = d->requested.x;
    ySize = d->requested.y;
    zSize = d->requested.z;
}

voPlaneOrientation voBrickSet::getOrientation() const
{
    return d->orientation;
}

int voBrickSet::getOverlap() const
{
    return d->overlap;
}

voBrickSetIterator::voBrickSetIterator(voBrickSet* brickSet) : set(brickSet), next(0) {}

voBrick* voBrickSetIterator::operator()()
{
    return set && next < set->getBrickCount() ? set->getBrick(next++) : nullptr;
}

namespace {

/// What the constructor of a collection was asked for, checked.
struct VolumeRequest
{
    vo::BrickGridRequest grid;
    voInternalFormatType internalFormat = voInternalFormatTypeScope::INTENSITY8_EXT;
    voExternalFormatType externalFormat = voExternalFormatTypeScope::LUMINANCE;
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
};

/// More bricks than this in a set is a mistake in the sizes: each one costs memory, and a texture.
constexpr std::int64_t kMostBricks = 1 << 20;

std::vector<voPlaneOrientation> orientations(voInterpolationType type)
{
    if (type == voInterpolationTypeScope::_3D) return {voPlaneOrientationScope::UNSPECIFIED};
    return {voPlaneOrientationScope::XY, voPlaneOrientationScope::XZ, voPlaneOrientationScope::YZ};
}

vo::BrickGridRequest forOrientation(vo::BrickGridRequest grid, voPlaneOrientation orientation)
{
    const int thin = vo::thinAxis(orientation);
    if (thin == 0) grid.brick.x = 1;
    if (thin == 1) grid.brick.y = 1;
    if (thin == 2) grid.brick.z = 1;
    return grid;
}

std::int64_t countBricks(const VolumeRequest& request, voInterpolationType type)
{
    std::int64_t total = 0;
    for (const voPlaneOrientation orientation : orientations(type)) {
        const std::int64_t count = vo::brickCount(forOrientation(request.grid, orientation));
        if (count > kMostBricks)
            badValue(std::to_string(count) + " bricks, at most " + std::to_string(kMostBricks) +
                     " are possible");
        total += count;
    }
    return total;
}

std::unique_ptr<voBrick> makeBrick(const VolumeRequest& request, const vo::BrickExtent& extent,
                                   voPlaneOrientation orientation, vo::BrickSource& source, std::size_t slot)
{
    auto brick = std::make_unique<voBrick>(request.internalFormat, request.externalFormat, request.dataType);
    voInside::Texture& d = voInside::of(*brick);
    for (int axis = 0; axis < 3; ++axis) {
        d.origin[axis] = static_cast<float>(extent.origin[axis]);
        d.extent[axis] = static_cast<float>(extent.size[axis]);
        d.size[axis] = extent.size[axis];
    }
    d.ownSource.reset();
    d.source = &source;
    d.slot = slot;
    d.volume = request.grid.volume;
    d.overlap = request.grid.overlap;
    d.inVolume = true;
    d.orientation = orientation;
    d.inStack = orientation != voPlaneOrientationScope::UNSPECIFIED;
    return brick;
}

void fillSet(voInside::BrickSet& set, const VolumeRequest& request, voPlaneOrientation orientation,
             vo::BrickSource& source, std::size_t firstSlot)
{
    const vo::BrickGridRequest grid = forOrientation(request.grid, orientation);
    set.volume = grid.volume;
    set.requested = grid.brick;
    set.overlap = grid.overlap;
    set.orientation = orientation;
    for (const vo::BrickExtent& extent : vo::brickGrid(grid))
        set.bricks.push_back(makeBrick(request, extent, orientation, source, firstSlot + set.bricks.size()));
}

VolumeRequest checkedRequest(const vo::BrickGridRequest& grid, int partial, int internalFormat,
                             int externalFormat, int dataType)
{
    VolumeRequest request{grid};
    checkSizes(grid.volume, "volume");
    checkSizes(grid.brick, "brick");
    if (grid.overlap < 0) badValue("overlap is " + std::to_string(grid.overlap) + ", 0 or more is needed");
    request.grid.partial = vo::partialBricks(partial);
    request.externalFormat = vo::resolveExternalFormat(externalFormat);
    request.internalFormat = vo::resolveInternalFormat(internalFormat, request.externalFormat);
    request.dataType = vo::resolveDataType(dataType);
    vo::texelFormat(request.internalFormat);
    if (!vo::isValid({vo::channels(request.externalFormat), vo::voxelType(request.dataType)}))
        vo::unsupported("a packed data type needs RGBA or ABGR_EXT voxels, 3_3_2 needs RGBA");
    return request;
}

} // namespace

voBrickSetCollection::voBrickSetCollection(int xVolumeSize, int yVolumeSize, int zVolumeSize, int xBrickSize,
                                           int yBrickSize, int zBrickSize,
                                           voPartialBrickType fractionalBricks, int overlap,
                                           voInternalFormatType internalFormat,
                                           voExternalFormatType externalFormat, voDataType dataType,
                                           voInterpolationType requestedInterpolation)
    : currentBrickSet(nullptr), interpolationType(voInterpolationTypeScope::_3D), d(new Private)
{
    VolumeRequest request;
    const auto build = [&] {
        d->source = std::make_unique<vo::MemoryBrickSource>(
            static_cast<std::size_t>(countBricks(request, interpolationType)));
        std::size_t slot = 0;
        for (const voPlaneOrientation orientation : orientations(interpolationType)) {
            d->sets.emplace_back(new voBrickSet);
            fillSet(voInside::of(*d->sets.back()), request, orientation, *d->source, slot);
            slot += static_cast<std::size_t>(d->sets.back()->getBrickCount());
        }
    };
    const int failed = guarded("voBrickSetCollection", [&] {
        interpolationType = vo::resolveInterpolation(requestedInterpolation);
        request = checkedRequest(
            {{xVolumeSize, yVolumeSize, zVolumeSize}, {xBrickSize, yBrickSize, zBrickSize}, overlap},
            fractionalBricks, internalFormat, externalFormat, dataType);
        build();
    });
    if (failed) {
        request = VolumeRequest{};
        d->sets.clear();
        build();
    }
    currentBrickSet = d->sets.front().get();
}

voBrickSetCollection::~voBrickSetCollection()
{
    delete d;
}

void voBrickSetCollection::setCurrentBrickSet(voPlaneOrientation orientation)
{
    guarded("voBrickSetCollection::setCurrentBrickSet", [&] {
        const int value = orientation;
        if (value < -1 || value > voPlaneOrientationScope::YZ)
            vo::badEnum("voPlaneOrientation has no value " + std::to_string(value));
        for (const auto& set : d->sets)
            if (set->getOrientation() == orientation) currentBrickSet = set.get();
    });
}

voBrickSet* voBrickSetCollection::getCurrentBrickSet() const
{
    return currentBrickSet;
}

voInterpolationType voBrickSetCollection::getInterpolationType() const
{
    return interpolationType;
}

int voBrickSetCollection::getBrickSetCount() const
{
    return static_cast<int>(d->sets.size());
}

voBrickSet* voBrickSetCollection::getBrickSet(int index) const
{
    voBrickSet* set = nullptr;
    guarded("voBrickSetCollection::getBrickSet", [&] {
        if (index < 0 || index >= getBrickSetCount())
            badValue("set " + std::to_string(index) + " is outside 0 to " +
                     std::to_string(getBrickSetCount() - 1));
        set = d->sets[static_cast<std::size_t>(index)].get();
    });
    return set;
}

int voBrickSetCollection::getMaxBrickCount() const
{
    int most = 0;
    for (const auto& set : d->sets)
        most = std::max(most, set->getBrickCount());
    return most;
}

void voBrickSetCollection::setDirtyFlag(voBool dirty)
{
    if (!dirty) return;
    for (const auto& set : d->sets)
        for (const auto& brick : voInside::of(*set).bricks)
            ++voInside::of(*brick).version;
}

voBrickSetCollectionIterator::voBrickSetCollectionIterator(voBrickSetCollection* aCollection)
    : collection(aCollection), next(0)
{
}

voBrickSet* voBrickSetCollectionIterator::operator()()
{
    return collection && next < collection->getBrickSetCount() ? collection->getBrickSet(next++) : nullptr;
}

namespace vo {

void clipBoxes(const voBrickSet& set, std::vector<Box>& boxes)
{
    boxes.clear();
    for (int i = 0; i < set.getBrickCount(); ++i) {
        float lower[3], upper[3];
        set.getBrick(i)->getClipBrickSizes(lower, upper);
        boxes.push_back({{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}});
    }
}

int thinAxis(voPlaneOrientation orientation)
{
    switch (orientation) {
    case voPlaneOrientationScope::UNSPECIFIED: return -1;
    case voPlaneOrientationScope::XY: return 2;
    case voPlaneOrientationScope::XZ: return 1;
    case voPlaneOrientationScope::YZ: return 0;
    }
    return -1;
}

TextureImage textureImage(const voTexture3D& texture)
{
    const voInside::Texture& d = voInside::of(texture);
    TextureImage image;
    image.id = d.id;
    image.version = d.version;
    const bool thin = d.size[0] == 1 || d.size[1] == 1 || d.size[2] == 1;
    image.twoDimensional = d.inVolume ? d.inStack : thin;
    image.size = {d.size[0], d.size[1], d.size[2]};
    image.format = voxelFormat(d);
    image.texel = texelFormat(d.internalFormat);
    image.voxels = d.source->voxels(d.slot);
    image.voxels = image.voxels.first(std::min(image.voxels.size(), texture.getDataSize()));
    if (!image.voxels.empty() && image.voxels.size() < texture.getDataSize())
        badValue("the texture has " + std::to_string(image.voxels.size()) + " bytes of voxels, " +
                 std::to_string(texture.getDataSize()) + " are needed");
    return image;
}

ContextRecord& requireContext()
{
    ContextRecord* context = currentContext();
    if (!context) unsupported("no OpenGL context is current");
    if (!context->usable()) unsupported(context->failure());
    return *context;
}

} // namespace vo
