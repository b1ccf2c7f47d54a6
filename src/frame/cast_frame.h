#pragma once

#include "cast/cast_request.h"
#include "draw/compositing_state.h"
#include "draw/draw_state.h"
#include "frame/frame.h"
#include "polygonize/camera.h"

#include <string>

namespace vo {

/// What the context was told; where that is automatic, what the environment's VO_ENGINE says (slices or
/// cast).
EngineChoice engineChoice(const ContextRecord& context);

/// Fragments may have colours outside 0 to 1.
bool isUnbounded(const ContextRecord& context, const FrameRequest& request, const DrawState& draw);

/// What rays need to know of a frame but for its bricks: the view, the tetrahedra, sampling and clip planes.
CastRequest viewRequest(const FrameRequest& request, const DrawState& draw, const CompositingState& state);

/// Draws the frame with the CPU engine: the same samples as slices have, blended into the framebuffer as one
/// picture. Returns an empty text, or why the frame has to be drawn as slices; nothing was drawn then.
std::string drawCastFrame(ContextRecord& context, const FrameRequest& request, const DrawState& draw,
                          const Camera& camera, FrameCache& cache);

} // namespace vo
