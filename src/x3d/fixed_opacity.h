#pragma once

#include "style/style.h"

#include <memory>

namespace vo {

/// A style that gives samples one opacity and multiplies their colour by it: 1 makes them solid, 0 leaves
/// nothing of them.
std::shared_ptr<const Style> fixedOpacity(float opacity);

} // namespace vo
