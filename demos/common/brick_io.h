#pragma once

/// The loaders that the guide's programs call (pages 40, 41 and 146). They are sample code, not part of the
/// library: a program may define its own functions of these names instead.
///
/// All return 0 when they succeed; otherwise they print one line, with the program's name in front, to
/// standard error and return 1, and `data` holds no useful values. Voxels arrive x fastest, in this machine's
/// byte order, zero where the brick leaves the volume. `data` belongs to the caller and has room for the
/// brick. File names are not changed, whatever their type says.

#include <vo/Enums.h>

/// Sizes of a volume in voxels, in any format that volume_io reads (docs/formats.md; a folder stands for the
/// DICOM series in it), the channels of a voxel (1: LUMINANCE, 2: LUMINANCE_ALPHA, 3 or 4: RGBA)
/// and the type of a channel. After a failure the references are unchanged.
int myGetVolumeSizesIfl(char* fileName, int& xSize, int& ySize, int& zSize,
                        voExternalFormatType& diskDataFormat, voDataType& dataType);

/// Distance of the voxels along x, y and z in mm, 1 each where the file does not say. After a failure the
/// references are unchanged.
int myGetVolumeSpacing(char* fileName, double& xSpacing, double& ySpacing, double& zSpacing);

/// Whether the file has no alpha although voxels arrive with one: then it is full everywhere. After a failure
/// the reference is unchanged.
int myGetVolumeAlphaAdded(char* fileName, bool& added);

/// Reads the brick with this origin and these sizes, in voxels. The volume's sizes are those that
/// myGetVolumeSizesIfl gave; others are a failure, since then the caller speaks of another file. The files
/// read last stay open, so that the bricks of a volume open it once.
int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize);

/// The same, with the volume's sizes taken from the file.
int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize);

/// Reads a brick of a volume whose slice z is the raw image fileNames[z], zVolumeSize of them, each after
/// headerLength bytes that are passed over. bytesPerVoxel is 1, 2, 4, 8 or 16; bytes arrive in the order of
/// the file.
int myReadBrickRaw(char** fileNames, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize, int headerLength, int bytesPerVoxel);

/// The same for channels of bytesPerChannel bytes (1, 2 or 4), which the files hold with the highest byte
/// first (bigEndian not 0, as IRIX wrote them) or the lowest.
int myReadBrickRaw(char** fileNames, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize, int headerLength, int bytesPerVoxel, int bytesPerChannel, int bigEndian);
