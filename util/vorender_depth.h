#pragma once

#include "cast/ray_cast.h"

#include <vector>

namespace vo {

/// Window depths, one a pixel of the request's viewport, rows from the bottom, of what a picture shows: over:
/// of the first sample with which opacity reaches one half. max: of the first of the pixel's largest red,
/// green, blue and alpha. 1 where there is none. Exact to some 1e-7. `picture` is the request's.
/// `interrupted` is asked now and then; then the answer is empty.
std::vector<float> pictureDepths(RayCaster& caster, const CastRequest& request, const CastPicture& picture,
                                 bool (*interrupted)());

} // namespace vo
