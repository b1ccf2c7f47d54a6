#ifndef VO_APPEARANCE_ACTIONS_H
#define VO_APPEARANCE_ACTIONS_H

#include <vo/Appearance.h>
#include <vo/Geometry.h>

/** Operations on voxels and textures (guide, pages 36-44, 57-58, 129-145). All are static. Those that return int
    return 0, or non-zero with voError set, having done nothing. textureXxx and texgenXxx need a current OpenGL
    context (UNSUPPORTED without one); the rest does not, save that volumeOptimize defers its texture objects to the
    first bind when there is none. */
class VO_API voAppearanceActions
{
public:
    /** Suggests formats and brick sizes, and creates nothing. interpolationType DEFAULT becomes _3D. One channel on
        disk gives LUMINANCE outside and INTENSITY8_EXT inside (alpha = grey, so that the over operator works),
        also in COLOR, where a table adds the colour; LUMINANCE_ALPHA stays; RGBA and ABGR_EXT stay in COLOR and
        become LUMINANCE_ALPHA in MONOCHROME. Brick sizes in: what is wanted; out: at most that, and at most the
        texture limit of the current context (2048 without one). */
    static int getBestParameters(voInterpolationType &interpolationType, voRenderingMode renderingMode,
                                 voDataType dataType, voExternalFormatType diskDataFormat,
                                 voInternalFormatType &internalFormat, voExternalFormatType &externalFormat,
                                 int &xBrickSize, int &yBrickSize, int &zBrickSize);
    static int getBestParameters(const voInterpolationType &interpolationType, voRenderingMode renderingMode,
                                 voDataType dataType, voExternalFormatType diskDataFormat,
                                 voInternalFormatType &internalFormat, voExternalFormatType &externalFormat,
                                 int &xBrickSize, int &yBrickSize, int &zBrickSize);

    /** Allocates voxels, all zero, with room for any disk format of the same data type, since the storage doubles
        as the buffer that files are read into. Returns them; NULL and OUT_OF_MEMORY when there is no room. The second
        form allocates all bricks of a set and returns the first one's voxels. Storage that dataAlloc gave before is
        replaced; memory of the application is let go. */
    static void *dataAlloc(voTexture3D *texture);
    static void *dataAlloc(voBrickSet *brickSet);
    /** Frees what dataAlloc gave; the data pointer is NULL afterwards. Twice does no harm. */
    static void dataFree(voTexture3D *texture);
    static void dataFree(voBrickSet *brickSet);

    /** Maps [loValue, hiValue] linearly to the range that a texture shows as 0 to 1: 0-255 (UNSIGNED_BYTE), 0-127
        (BYTE), 0-65535, 0-32767 (SHORT), 0-2^32-1, 0-2^31-1, 0.0-1.0 (FLOAT); values outside are clamped, and integers
        rounded. hiValue <= loValue leaves the voxels alone. Packed types: UNSUPPORTED. */
    static int dataScaleRange(voTexture3D *texture, float &loValue, float &hiValue);
    static int dataScaleRange(voTexture3D *texture, double loValue, double hiValue);

    /** Reads `data`, voxels in diskFormat of the texture's own data type, and writes the texture's external format.
        In place when data is the texture's own storage. Colours become luminance by 0.30 R + 0.59 G + 0.11 B; one
        channel becomes LUMINANCE_ALPHA as (v, v), RGBA as (v, v, v, v). */
    static int dataConvert(voTexture3D *texture, void *data, voExternalFormatType diskFormat);
    /** The same channels, numbers of another type: normalised values are kept, so that 255 becomes 65535 or 1.0. */
    static int dataConvert(voTexture3D *texture, void *data, voDataType diskType);

    /** Fills the XZ and YZ stacks of a _2D volume from its XY stack; their voxels are allocated when they are not.
        Nothing to do for _3D. */
    static int volumeMakeTransposed(voBrickSetCollection *volume);

    /** Prepares the volume for drawing by OR-ed flags of voOptimizeVolumeTypeScope. TEXTURE_OBJECTS makes the current
        brick set resident. INTERLEAVE pairs the bricks of each set as textureInterleave does, as far as they fit; it is
        remembered, and today's OpenGL gains nothing by it. PRE_TRANSPOSE does nothing. Repeatable. */
    static int volumeOptimize(voBrickSetCollection *volume, int flags);
    /** Releases the texture objects and takes interleaved bricks apart. */
    static int volumeUnoptimize(voBrickSetCollection *volume);

    /** The lowest and the highest value of each block of blockSize voxels a side, one voxel round it included, as
        textures show them: 0 to 1. Of one channel the value itself, of several alpha, which is 1 for RGB8_EXT and RGB4_EXT.
        Two floats for each block, blocks along x fastest, as many along an axis as hold the volume. Needs voxels in all
        bricks, which are where the collection put them. */
    static int volumeFindRanges(voBrickSetCollection *volume, int blockSize, float *ranges);

    /** Declares two textures of equal sizes, formats and data type, of one or two channels, to be interleaved. What is
        drawn stays the same. Others, one texture twice, or one that is interleaved with a third: BAD_VALUE. */
    static int textureInterleave(voTexture3D *texture1, voTexture3D *texture2);
    /** VO_TRUE while two different textures are interleaved: by textureInterleave or volumeOptimize, until
        volumeUnoptimize, one of them is deleted, or their sizes differ. */
    static voBool cliqueTest(voTexture3D *texture1, voTexture3D *texture2);

    /** Switch 2D or 3D texturing on and off for what is drawn next. In a compatibility context this is the real
        state of OpenGL, which polygons of the application see too. */
    static void textureEnable(voInterpolationType interpolationType);
    static void textureDisable(voInterpolationType interpolationType);
    /** Texture coordinates from the vertex position, by the equation of texgenSetEquation. */
    static void texgenEnable();
    static void texgenDisable();
    /** Object-linear map from a vertex, in voxels, to the brick's texture coordinates: s = (x - origin) / size. */
    static void texgenSetEquation(voBrick *brick);

    /** Makes the texture current, and resident before if it is not. */
    static int textureBind(voTexture3D *texture);
    /** Downloads the voxels whether or not they are resident, and makes the texture current. */
    static int textureLoad(voTexture3D *texture);
    /** 16 floats, column by column, that take voxel coordinates to the brick's texture coordinates as
        xfmVox2TexCoords does, for glMultMatrixf on GL_TEXTURE. The brick of a stack has s and t for its two axes in
        their order, and r = 0. */
    static void textureMakeMatrix(voBrick *brick, float *matrix);

    /** Rewrites the T3F of each vertex that the face set uses from voxels to the brick's texture coordinates, once a
        vertex. The second form does bricks x samples, polygonSet[brick][sample]. A format without T3F: BAD_VALUE. */
    static void xfmVox2TexCoords(voBrick *brick, voIndexedFaceSet *faceSet, voInterleavedArrayType format,
                                 voPlaneOrientation orientation);
    static void xfmVox2TexCoords(voBrickSet *brickSet, int samplesNumber, voIndexedFaceSet ***polygonSet,
                                 voInterleavedArrayType format);

    /** As on voGeometryActions, where the guide prints them too. */
    static int clip(voVertexData *polygon, voInterleavedArrayType format, float lowerLeft[3], float upperRight[3],
                    voIndexedFaceSet *faceSet);
    static int clip(voVertexData *polygon, float lowerLeft[3], float upperRight[3], voIndexedFaceSet *faceSet);
    static int clip(voVertexData *polygon, voInterleavedArrayType format, float *planes, int planeCount,
                    voIndexedFaceSet *faceSet);
    static int sample(float tetraVerts[4][3], float planeEquation[4], voVertexData *polygonVerts);
};

typedef voAppearanceActions voTexture3DActions;
typedef voAppearanceActions Texture3DActions;

#endif
