#ifndef VO_ENUMS_H
#define VO_ENUMS_H

#include <vo/Api.h>

/* The enumerations of the API (guide, pages 37-63, 103, 130-133, 155). Each lives in a class of its own, so that
   DEFAULT, INT or _2D stay out of the global namespace: voDataTypeScope::FLOAT is a value, voDataType the type.
   Legacy programs store the values as int and map 0, 1, 2, ... back in the order of declaration: the order is part
   of the contract. -1 is read as DEFAULT wherever an enumeration is consumed. */

/** Two-dimensional stacks or one three-dimensional texture. DEFAULT is _3D (OpenGL 3.3 always has 3D textures). */
class voInterpolationTypeScope
{
public:
    enum voInterpolationType VO_ANY_INT { DEFAULT, _2D, _3D };
};
typedef voInterpolationTypeScope::voInterpolationType voInterpolationType;

/** Grey scale or RGBA pipeline. DEFAULT is MONOCHROME. */
class voRenderingModeScope
{
public:
    enum voRenderingMode VO_ANY_INT { DEFAULT, MONOCHROME, COLOR };
};
typedef voRenderingModeScope::voRenderingMode voRenderingMode;

/** Numeric representation of one voxel channel, or of a packed voxel. DEFAULT is UNSIGNED_BYTE. */
class voDataTypeScope
{
public:
    enum voDataType VO_ANY_INT {
        DEFAULT,
        UNSIGNED_BYTE,
        BYTE,
        UNSIGNED_BYTE_3_3_2_EXT,
        UNSIGNED_SHORT,
        SHORT,
        UNSIGNED_SHORT_4_4_4_4_EXT,
        UNSIGNED_SHORT_5_5_5_1_EXT,
        UNSIGNED_INT,
        INT,
        UNSIGNED_INT_8_8_8_8_EXT,
        UNSIGNED_INT_10_10_10_2_EXT,
        FLOAT,
        INT_8_8_8_8_EXT = UNSIGNED_INT_8_8_8_8_EXT,
        INT_10_10_10_2_EXT = UNSIGNED_INT_10_10_10_2_EXT
    };
};
typedef voDataTypeScope::voDataType voDataType;

/** Format kept in texture memory. INTENSITY answers (I,I,I,I) when sampled, LUMINANCE (L,L,L,1), LUMINANCE_ALPHA
    (L,L,L,A). DEFAULT is INTENSITY8_EXT for one channel, LUMINANCE8_ALPHA8_EXT for two, RGBA8_EXT for four. */
class voInternalFormatTypeScope
{
public:
    enum voInternalFormatType VO_ANY_INT {
        DEFAULT,
        INTENSITY8_EXT,
        LUMINANCE8_EXT,
        LUMINANCE8_ALPHA8_EXT,
        RGBA8_EXT,
        RGB8_EXT,
        RGBA4_EXT,
        QUAD_LUMINANCE8_SGIS,
        DUAL_LUMINANCE_ALPHA8_SGIS,
        RGB4_EXT,
        DUAL_INTENSITY8_SGIS,
        RGB88_EXT = RGBA8_EXT,
        RGB84_EXT = RGBA4_EXT,
        RGB44_EXT = RGB4_EXT
    };
};
typedef voInternalFormatTypeScope::voInternalFormatType voInternalFormatType;

/** Channels in application memory and on disk: 1, 2, 1, 4, 4 of them. DEFAULT is LUMINANCE. */
class voExternalFormatTypeScope
{
public:
    enum voExternalFormatType VO_ANY_INT { DEFAULT, INTENSITY, LUMINANCE_ALPHA, LUMINANCE, RGBA, ABGR_EXT };
};
typedef voExternalFormatTypeScope::voExternalFormatType voExternalFormatType;

/** What to do where bricks do not divide the volume (guide, page 29). TRUNCATE drops the rest, AUGMENT adds bricks
    that are partly empty, AUGMENT_TIGHT shrinks those to the next power of two. DEFAULT is TRUNCATE. */
class voPartialBrickTypeScope
{
public:
    enum voPartialBrickType VO_ANY_INT { DEFAULT, TRUNCATE, AUGMENT, AUGMENT_TIGHT };
};
typedef voPartialBrickTypeScope::voPartialBrickType voPartialBrickType;

/** Flags of voAppearanceActions::volumeOptimize, to be OR-ed (guide, page 44). */
class voOptimizeVolumeTypeScope
{
public:
    enum voOptimizeVolumeType VO_ANY_INT {
        NONE = 0,
        INTERLEAVE = 1,
        TEXTURE_OBJECTS = 2,
        PRE_TRANSPOSE = 4,
        BEST_PERFORMANCE = INTERLEAVE | TEXTURE_OBJECTS,
        BEST = BEST_PERFORMANCE
    };
};
typedef voOptimizeVolumeTypeScope::voOptimizeVolumeType voOptimizeVolumeType;

inline voOptimizeVolumeType operator|(voOptimizeVolumeType a, voOptimizeVolumeType b)
{
    return static_cast<voOptimizeVolumeType>(static_cast<int>(a) | static_cast<int>(b));
}

/** Which stack of a collection (guide, page 155). */
class voPlaneOrientationScope
{
public:
    enum voPlaneOrientation VO_ANY_INT { UNSPECIFIED, XY, XZ, YZ };
};
typedef voPlaneOrientationScope::voPlaneOrientation voPlaneOrientation;

/** Family of sampling surfaces (guide, page 52). DEFAULT is VIEWPORT_ALIGNED. SPHERICAL: concentric shells round
    the eye in a perspective view, VIEWPORT_ALIGNED in an orthographic one. */
class voSamplingModeScope
{
public:
    enum voSamplingMode VO_ANY_INT {
        DEFAULT,
        VIEWPORT_ALIGNED,
        AXIS_ALIGNED,
        SPHERICAL,
        BEST_PERFORMANCE = DEFAULT
    };
};
typedef voSamplingModeScope::voSamplingMode voSamplingMode;

/** Extent over which the samples are spread (guide, page 54). DEFAULT is OBJECT. */
class voSamplingSpaceScope
{
public:
    enum voSamplingSpace VO_ANY_INT { DEFAULT, VIEW_VOLUME, OBJECT, PRIMITIVE };
};
typedef voSamplingSpaceScope::voSamplingSpace voSamplingSpace;

/** Layout of a vertex record (guide, page 103); the position is always the last three floats. T3F are voxel
    coordinates. DEFAULT behaves as V3F. */
class voInterleavedArrayTypeScope
{
public:
    enum voInterleavedArrayType VO_ANY_INT {
        DEFAULT = -1,
        V3F = 0,
        T3F_V3F,
        C3F_V3F,
        C4F_V3F,
        T3F_C3F_V3F,
        T3F_C4F_V3F,
        USER_V3F
    };
};
typedef voInterleavedArrayTypeScope::voInterleavedArrayType voInterleavedArrayType;

#pragma push_macro("NO_ERROR")
#undef NO_ERROR
/** Codes of voError (guide, page 63). */
class voErrorTypeScope
{
public:
    enum voErrorType VO_ANY_INT { NO_ERROR, BAD_VALUE, BAD_ENUM, OUT_OF_MEMORY, UNSUPPORTED };
};
#pragma pop_macro("NO_ERROR")
typedef voErrorTypeScope::voErrorType voErrorType;

/** Classification before or after interpolation (guide, page 62). DEFAULT is POST_INTERPOLATION. */
class voLookupTableTypeScope
{
public:
    enum voLookupTableType VO_ANY_INT { DEFAULT, PRE_INTERPOLATION, POST_INTERPOLATION };
};
typedef voLookupTableTypeScope::voLookupTableType voLookupTableType;

/** Shape for voLookupTable::set (guide, page 61). */
class voLookupTableShapeScope
{
public:
    enum voLookupTableShape VO_ANY_INT { LINEAR };
};
typedef voLookupTableShapeScope::voLookupTableShape voLookupTableShape;

/** Outlines that voGeometryActions::drawUtility adds. */
class voDecorationFlagsScope
{
public:
    enum voDecorationFlags VO_ANY_INT { NONE = 0, BRICKS = 1, TETRAS = 2, ALL = BRICKS | TETRAS };
};
typedef voDecorationFlagsScope::voDecorationFlags voDecorationFlags;

/** Who draws the frames of voGeometryActions::drawUtility: slices through OpenGL, or the CPU engine, which computes the
    same samples and draws them as one picture. AUTOMATIC: the CPU engine where OpenGL runs on the processor. */
class voEngineScope
{
public:
    enum voEngine VO_ANY_INT { AUTOMATIC, SLICES, CAST };
};
typedef voEngineScope::voEngine voEngine;

/* Every header of the face brings voError in. */
#include <vo/Error.h>

#endif
