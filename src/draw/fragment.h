#pragma once

#include "draw/draw_state.h"
#include "lookup/table.h"

#include <glm/vec4.hpp>

namespace vo {

/// What the fragment program (programs.cpp) writes for a texture's answer, without the program: the active
/// table after interpolation, if any, then texture environment and colour of `state`. `color` is the
/// vertices', or the current one.
glm::dvec4 fragmentOf(const DrawState& state, const Table* table, glm::dvec4 sampled,
                      const glm::dvec4& color);

/// The opacity of `units` lengths of which one has the opacity `alpha`.
double opacityOver(double alpha, double units);

} // namespace vo
