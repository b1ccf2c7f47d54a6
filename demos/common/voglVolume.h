#pragma once

// Before any header of <vo/...>.
#include "gl.h"

#include "voglLookup.h"

#include <vo/Volumizer.h>

#include <functional>
#include <string>

/* A volume in bricks, as the command line asks for it: what my_InitAppearance and my_Cleanup of most vogl
   demos do. */

/** Where voxels come from. */
struct VoglSource
{
    /** For messages. */
    std::string name;
    /** Voxels along x, y, z. */
    int size[3] = {1, 1, 1};
    /** Distances of the voxels along x, y, z, in any unit. */
    double spacing[3] = {1, 1, 1};
    voExternalFormatType diskFormat = voExternalFormatTypeScope::LUMINANCE;
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
    /** Alpha is full everywhere, and none of the file's. */
    bool alphaAdded = false;
    /** Fills `data` with the voxels from `origin`, `brickSize` along each axis, x fastest, zero outside the
        volume. 0, or something else after one line on stderr. */
    std::function<int(void* data, const int origin[3], const int brickSize[3])> readBrick;
};

/** A volume in memory. */
struct VoglVolume
{
    voBrickSetCollection* bricks = nullptr;
    voRenderingMode renderingMode = voRenderingModeScope::MONOCHROME;
    /** The values of the file at which the table begins and ends. */
    float loValue = 0, hiValue = 0;
    /** Bricks of the largest of its sets. */
    int maxBrickCount = 0;
    /** The sampling planes of any view are at most so many. */
    int maxSamplesNumber = 0;
    int size[3] = {1, 1, 1};
};

/** A file in any format that the loaders of brick_io.h read. Leaves by exit(1) after one line on stderr. */
VoglSource voglOpenFile(const char* program, const char* fileName);

/** The same for pictures of slices blended over each other (unless -mip says otherwise). Without a table,
   which would bring opacities, colours whose file has no alpha get their brightness for one: black voxels
   hide nothing. `hasTable`: for volumes that have another table than that of the options. */
VoglSource voglOpenBlended(const char* program, const char* fileName);
VoglSource voglOpenBlended(const char* program, const char* fileName, bool hasTable);

/** Reads a volume into bricks for the textures and brick sizes of the options, its values spread over its
   type's whole range. Sets modelScale to the spacing, the smallest 1, unless -scale says otherwise. Refuses
   what would take minutes or all memory. Leaves by exit(1) after one line on stderr. */
VoglVolume voglReadVolume(const char* program, const VoglSource& source);

/** The same, with a mode of its own, for volumes that have a table of their own too. */
VoglVolume voglReadVolume(const char* program, const VoglSource& source, voRenderingMode renderingMode);

/** The bricks without their voxels, for programs that read these when they need them. The data range is found
    by reading brick after brick, where neither the options nor the type say it. */
VoglVolume voglOpenVolume(const char* program, const VoglSource& source);

/** The most sampling planes that any view of a box has, in voxels. Leaves by exit(1) when they are too many.
 */
int voglCountPlanes(const char* program, const int size[3]);

/** Makes textures and table, that of the options or another one; needs a context. */
void voglInitTextures(const VoglVolume& volume, VoglLookup& lookup = voglLookup());

/** Frees the bricks and their voxels. */
void voglFreeVolume(VoglVolume& volume);

/** Leaves with exit(1) after one line on stderr. */
[[noreturn]] void voglFail(const char* program, const std::string& text);
