#ifndef VO_COMPAT_IFL_TYPES_H
#define VO_COMPAT_IFL_TYPES_H

/* The part of the Image Format Library (IFL) that loaders of volumes use, over today's readers; link with -lifl. C++98.
   Whatever is not declared in ifl/ is not there. */

#if defined(__GNUC__)
#define IFL_API __attribute__((visibility("default")))
#else
#define IFL_API
#endif

/** Numeric type of a channel. */
typedef enum {
    iflBit = 1,
    iflUChar = 2,
    iflChar = 4,
    iflUShort = 8,
    iflShort = 16,
    iflUInt = 32,
    iflInt = 64,
    iflULong = 32,
    iflLong = 64,
    iflFloat = 128,
    iflDouble = 256
} iflDataType;

/** Where the channels of a pixel lie: side by side, row by row (a row of each channel), or image by image. */
typedef enum { iflInterleaved = 1, iflSequential = 2, iflSeparate = 4 } iflOrder;

/** What the channels mean. */
typedef enum { iflLuminance = 2, iflRGB = 3, iflRGBA = 5, iflLuminanceAlpha = 13 } iflColorModel;

#endif
