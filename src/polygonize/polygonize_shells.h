#pragma once

#include "geometry/face_sink.h"
#include "geometry/tetra_view.h"
#include "polygonize/box_cutter.h"
#include "polygonize/sampling_shells.h"

namespace vo {

/// Cuts the facets of every shell to every tetrahedron and to the cutter's boxes, as polygonize does planes;
/// for SamplingSpace::primitive each tetrahedron has its own shells. Facets are made where tetrahedra are and
/// nowhere else. Returns false when the sink had no room.
bool polygonizeShells(const TetraView& tetras, const ShellFamily& shells, const SamplingRequest& request,
                      BoxCutter& cutter, FaceSink& sink);

} // namespace vo
