#ifndef VO_APPEARANCE_H
#define VO_APPEARANCE_H

#include <vo/Enums.h>
#include <vo/Error.h>

/* Voxels in bricks (guide, pages 25-29, 39-41, 129-147).

   Frame: edge-based. A volume spans [0, size] on each axis and voxel i is centred at i + 0.5; a brick at `origin`
   of `size` voxels spans [origin, origin + size]. Voxels of a brick lie in memory x fastest, then y, then z. */

/** A chunk of texture: formats, sizes, and a pointer to voxels. No position. */
class VO_API voTexture3D
{
public:
    voTexture3D(voInternalFormatType internalFormat, voExternalFormatType externalFormat, voDataType dataType);
    virtual ~voTexture3D();

    /** The voxels in the external format; NULL until voAppearanceActions::dataAlloc or setDataPtr. setDataPtr
        borrows memory of the application, which is never freed here. */
    void *getDataPtr() const;
    void setDataPtr(void *data);

    /** Formats as resolved by the constructor: never DEFAULT. */
    voInternalFormatType getInternalFormat() const;
    voExternalFormatType getExternalFormat() const;
    voDataType getDataType() const;

    /** Sizes in voxels, each at least 1. The texture of an application: BAD_VALUE for a size below 1. */
    void getSizes(int &xSize, int &ySize, int &zSize) const;
    void setSizes(int xSize, int ySize, int zSize);

    /** Bytes of the voxels in the external format. */
    size_t getDataSize() const;

protected:
    struct Private;
    Private *d;
    friend struct voInside;

private:
    voTexture3D(const voTexture3D &);
    voTexture3D &operator=(const voTexture3D &);
};

/** A texture with a position. A size of 1 on one axis makes it a two-dimensional texture. */
class VO_API voBrick : public voTexture3D
{
public:
    voBrick(voInternalFormatType internalFormat, voExternalFormatType externalFormat, voDataType dataType);
    virtual ~voBrick();

    /** Origin, then sizes (not the far corner). Sizes need not be powers of two. BAD_VALUE for a size below 1. */
    void setBrickSizes(float xmin, float ymin, float zmin, float xSize, float ySize, float zSize);
    void getBrickSizes(int &xmin, int &ymin, int &zmin, int &xSize, int &ySize, int &zSize) const;
    void getBrickSizes(float *position, float *size) const;

    /** The clip box as two corners: the brick less half the overlap on each side. The boxes of adjacent bricks meet
        exactly; [o + overlap/2, o + size - overlap/2], clipped to [overlap/2, volume - overlap/2]. */
    void getClipBrickSizes(float *lowerLeft, float *upperRight) const;

private:
    friend struct voInside;
};

/** The bricks of one orientation of a volume. */
class VO_API voBrickSet
{
public:
    ~voBrickSet();

    int getBrickCount() const;
    /** Brick 0 to getBrickCount() - 1. Outside: BAD_VALUE and NULL. */
    voBrick *getBrick(int index) const;
    void getVolumeSizes(int &xSize, int &ySize, int &zSize) const;
    /** The sizes that the bricks were asked to have. */
    void getBrickSizes(int &xSize, int &ySize, int &zSize) const;
    /** UNSPECIFIED for the set of a _3D collection, else XY, XZ or YZ. */
    voPlaneOrientation getOrientation() const;
    int getOverlap() const;

private:
    voBrickSet();
    struct Private;
    Private *d;
    friend struct voInside;
    friend class voBrickSetCollection;
    voBrickSet(const voBrickSet &);
    voBrickSet &operator=(const voBrickSet &);
};

/** Hands out the bricks of a set one by one, then NULL. */
class VO_API voBrickSetIterator
{
public:
    explicit voBrickSetIterator(voBrickSet *brickSet);
    voBrick *operator()();

private:
    voBrickSet *set;
    int next;
};

/** A volume: one brick set (_3D), or three, one an axis (_2D), of which one is current. Computes the bricks, allocates
    no voxels and needs no OpenGL context. Sizes below 1, a negative overlap, or more than 2^20 bricks in a set:
    BAD_VALUE, and a collection of one 1 x 1 x 1 brick; formats that today's OpenGL cannot hold: UNSUPPORTED. */
class VO_API voBrickSetCollection
{
public:
    voBrickSetCollection(int xVolumeSize, int yVolumeSize, int zVolumeSize, int xBrickSize, int yBrickSize,
                         int zBrickSize, voPartialBrickType fractionalBricks, int overlap,
                         voInternalFormatType internalFormat, voExternalFormatType externalFormat,
                         voDataType dataType, voInterpolationType interpolationType);
    /** Deletes sets and bricks, and voxels that dataAlloc gave and nobody freed. */
    ~voBrickSetCollection();

    /** Makes a stack current. On a _3D collection any value is accepted and changes nothing; UNSPECIFIED changes
        nothing on a _2D one. */
    void setCurrentBrickSet(voPlaneOrientation orientation);
    /** Never NULL. */
    voBrickSet *getCurrentBrickSet() const;
    /** _2D or _3D, never DEFAULT. */
    voInterpolationType getInterpolationType() const;

    int getBrickSetCount() const;
    voBrickSet *getBrickSet(int index) const;
    /** The largest getBrickCount() of the sets: what one buffer for transient geometry must hold. */
    int getMaxBrickCount() const;

    /** VO_TRUE: what is resident of this volume is stale, the next optimize or bind downloads it again. */
    void setDirtyFlag(voBool dirty);

    /** The values that the get functions return, for programs that read the members. Read only. */
    voBrickSet *currentBrickSet;
    voInterpolationType interpolationType;

private:
    struct Private;
    Private *d;
    friend struct voInside;
    voBrickSetCollection(const voBrickSetCollection &);
    voBrickSetCollection &operator=(const voBrickSetCollection &);
};

/** Hands out every set of a collection once, in the order XY, XZ, YZ, then NULL. */
class VO_API voBrickSetCollectionIterator
{
public:
    explicit voBrickSetCollectionIterator(voBrickSetCollection *collection);
    voBrickSet *operator()();

private:
    voBrickSetCollection *collection;
    int next;
};

#endif
