#pragma once

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

/// Draws the frame with the CPU engine: the same samples as slices have, blended into the framebuffer as one
/// picture. Returns an empty text, or why the frame has to be drawn as slices; nothing was drawn then.
std::string drawCastFrame(ContextRecord& context, const FrameRequest& request, const DrawState& draw,
                          const Camera& camera, FrameCache& cache);

} // namespace vo
