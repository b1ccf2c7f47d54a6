#pragma once

#include <string_view>

#include "x3d/scene_builder.h"

namespace vo {

/// Reads the text of a scene in XML. No entity but XML's own five and numbered characters is known, and
/// nothing is fetched. What is no scene at all ends in SceneBuilder::giveUp.
void readXml(std::string_view text, SceneBuilder& builder);

/// The same in ClassicVRML, which begins with "#X3D V3.0 utf8" or a later version.
void readClassic(std::string_view text, SceneBuilder& builder);

} // namespace vo
