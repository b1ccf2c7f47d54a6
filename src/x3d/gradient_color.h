#pragma once

#include "style/style.h"

namespace vo {

/// The gradientColor of BoundaryEnhancementVolumeStyle: Cg = Cv (1 - w) + color w with w = alpha min(2 |Df|,
/// 1). The opacity stays.
std::shared_ptr<const Style> gradientColor(const glm::vec4& color);

} // namespace vo
