#pragma once

#include "cast/cast_picture.h"
#include "draw/compositing_state.h"
#include "draw/context_record.h"
#include "draw/draw_state.h"

namespace vo {

/// Blends a finished picture into the caller's framebuffer as its fragments would have been one by one; the
/// depth test and the clip planes were applied to them before. Colour mask, scissor and stencil test of the
/// caller hold; everything is given back.
void compositePicture(ContextRecord& context, const DrawState& draw, const CompositingState& state,
                      const CastPicture& picture);

} // namespace vo
