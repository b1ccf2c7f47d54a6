#pragma once

#include "vox3d_options.h"

#include <vo/x3d/View.h>

namespace vo {

/// Writes the pictures that the options ask for.
Result<void> writePictures(voX3DView& view, const Vox3dOptions& options);

/// Refuses names of pictures that lead to one file, or to the input.
Result<void> checkPictureNames(const Vox3dOptions& options);

} // namespace vo
