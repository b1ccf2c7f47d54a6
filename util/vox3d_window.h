#pragma once

#include "vox3d_options.h"

#include <vo/x3d/View.h>

namespace vo {

/// Shows a scene in a window until it is closed. False, and why, where there is no window to be had.
Result<bool> showInWindow(voX3DScene& scene, voX3DView& view, const Vox3dOptions& options,
                          std::string& whyNot);

/// The keys of the window, for -help.
extern const char* const kWindowKeys;

} // namespace vo
