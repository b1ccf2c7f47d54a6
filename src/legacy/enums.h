#pragma once

// Legacy enumerations to inner ones: one switch each, without default, so that the compiler finds what is
// missing. -1 counts as DEFAULT; other values outside throw CallerError (BAD_ENUM).

#include "appearance/brick_grid.h"
#include "appearance/voxel_format.h"
#include "core/record_layout.h"
#include "draw/context_record.h"
#include "polygonize/sampling_planes.h"

#include <vo/Enums.h>

namespace vo {

voInterpolationType resolveInterpolation(int type);
voDataType resolveDataType(int type);
voExternalFormatType resolveExternalFormat(int format);
/// DEFAULT becomes the format that fits the external one.
voInternalFormatType resolveInternalFormat(int format, voExternalFormatType external);

VoxelType voxelType(voDataType type);
Channels channels(voExternalFormatType format);
/// The packed SGIS formats: CallerError (UNSUPPORTED).
TexelFormat texelFormat(voInternalFormatType format);
PartialBricks partialBricks(int type);
SamplingMode samplingMode(int mode);
SamplingSpace samplingSpace(int space);
EngineChoice engineChoiceOf(int engine);
/// USER_V3F: nothing but the position, the last three of `values` floats.
RecordLayout recordLayout(int format, int values);

} // namespace vo
