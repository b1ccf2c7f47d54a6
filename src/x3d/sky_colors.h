#pragma once

#include "style/styled_scene.h"
#include "x3d/scene_walk.h"
#include "x3d/view_messages.h"

namespace vo {

/// The colours of a Background.
SkyColors skyColors(const PlacedNode& background, ViewMessages& messages);

} // namespace vo
