#pragma once

#include "voglMain.h"

#include "voglFrame.h"
#include "voglVolume.h"

#include <vo/utLattice.h>

#include <memory>

/* A lattice of boxes over a volume, for programs that warp it. Programs link vout beside. */

/** -lattice NX NY NZ, into three numbers that hold what it is without. */
vo::OwnOption voglLatticeOption(int boxes[3]);

/** A lattice over the whole volume. Its unit of length is that of the file's spacing, or of -scale. */
std::unique_ptr<voutLattice> voglMakeLattice(const int boxes[3], const VoglVolume& volume,
                                             const VoglSource& source);

/** Takes the vertices that were moved into a set that tessellate made of the same lattice. */
void voglMoveTetras(voutLattice& lattice, voIndexedTetraSet* tetraSet);

/** One line on stderr where the number of tetrahedra that are inside out is another than at the last call. */
void voglReportFolds(const char* program, const voutLattice& lattice);

/** voglDrawFrame, with the boxes of the lattice instead of tetrahedra where -wireframe asks for outlines. */
void voglDrawLatticeFrame(const voutLattice& lattice, voIndexedTetraSet* tetraSet,
                          voBrickSetCollection* bricks, VoglPolygons& polygons);
