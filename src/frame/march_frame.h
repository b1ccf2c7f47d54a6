#pragma once

#include "draw/compositing_state.h"
#include "draw/march_samples.h"
#include "frame/frame.h"

#include <optional>
#include <span>
#include <vector>

namespace vo {

/// A frame of slices of which each pixel's samples can be taken at once, where something may be seen.
struct MarchedFrame
{
    CompositingState state;
    SampleRamps ramps;
    CellDistances cells; ///< in the frame's cache
    struct Part
    {
        int brick;
        MarchedBrick place;
        PixelRectangle pixels;
    };
    std::vector<Part> parts; ///< from back to front
};

/// Nothing where polygons have to be drawn one by one, or cost less: OpenGL does not run on the processor,
/// the state is none in which fragments can be joined, there is a depth test, most of the volume is seen, the
/// volume is not in its place or no box, planes are not even in the picture or shells, frames share polygons.
std::optional<MarchedFrame> marchedFrame(ContextRecord& context, const FrameRequest& request,
                                         const DrawState& draw, const Camera& camera, SpaceLeaping& leaping);

} // namespace vo
