#pragma once

#include "vorender_options.h"

#include "cast/cast_picture.h"

#include <vector>

namespace vo {

/// A failure where a file of that name must not be replaced: an input, or a .raw file of another size than
/// the one to be written (`bytes`): voxels are called .raw too.
Result<void> checkPictureName(const std::string& name, std::uintmax_t bytes,
                              const std::vector<std::string>& inputs);

/// Writes a whole frame of width x height pixels over black: PNG, or floats (docs/man/vorender.1).
Result<void> writeFrame(const std::string& name, int width, int height, const CastPicture& picture,
                        bool isOver);

/// Writes depths from 0 to 1, rows from the bottom.
Result<void> writeDepths(const std::string& name, int width, int height, const std::vector<float>& depths);

} // namespace vo
