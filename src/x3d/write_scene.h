#pragma once

#include <string>

#include "x3d/scene.h"
#include "x3d/value_text.h"

namespace vo {

/// The text of a scene: what was set in its nodes, and its routes; not what Inline nodes brought. A node that
/// stands in several places is written once and then named; it gets a name where it has none.
std::string sceneText(const Scene& scene, Encoding encoding);

} // namespace vo
