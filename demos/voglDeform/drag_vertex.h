#pragma once

#include "voglMain.h"

#include <vo/utLattice.h>

/** A vertex of a lattice under the pointer; it keeps its depth. Places are in pixels from the lower left
   corner of a frame. */
class VertexDrag
{
public:
    /** Takes the vertex that the view shows nearest to a place; of several at one place, the nearest to the
     * viewer. */
    VertexDrag(const voutLattice& lattice, const VoglView& view, double x, double y);
    /** Moves it as far as the pointer went from there. */
    void dragTo(voutLattice& lattice, const VoglView& view, double x, double y) const;

private:
    int vertex_ = 0;
    double startX_, startY_;
    float position_[3];
};
