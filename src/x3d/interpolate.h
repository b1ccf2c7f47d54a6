#pragma once

#include <optional>

#include "x3d/scene.h"

namespace vo {

/// What an interpolator makes of a fraction: the value of its value_changed. Before the first key and behind
/// the last one it stands still; of equal keys the last one counts. Numbers and positions go straight,
/// orientations the shorter way round (slerp), colours through hue, saturation and value, hue the shorter
/// way. Keys without a value, and values without a key, do not count. Nothing where there is none, or no
/// number.
std::optional<FieldValue> interpolated(const Node& interpolator, float fraction);

} // namespace vo
