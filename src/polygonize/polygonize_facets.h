#pragma once

#include "polygonize/box_cutter.h"
#include "polygonize/polygonize.h"

namespace vo {

/// Cuts the facets of surfaces 0 to count - 1 to every tetrahedron and to the cutter's boxes. Returns false
/// when the sink had no room.
bool polygonizeFacets(const TetraView& tetras, FacetSource& surfaces, int count, BoxCutter& cutter,
                      FaceSink& sink);

} // namespace vo
