#pragma once

#include "voglMain.h"

#include "voglFrame.h"
#include "voglVolume.h"

#include <vo/utLattice.h>

#include <array>
#include <memory>
#include <string>

/** -lattice NX NY NZ, into three numbers that hold what it is without. */
vo::OwnOption voglLatticeOption(int boxes[3]);

/** A volume under a lattice of boxes, for programs that warp it. Programs link vout beside. */
class VoglWarpedVolume
{
public:
    /** Leaves by exit(1) after one line on stderr. */
    voBrickSetCollection* read(const char* program, const char* fileName);
    /** Lays a lattice over the whole volume. Its unit of length is that of getSpacing. */
    voutLattice& makeLattice(const int boxes[3]);
    /** The lattice's tetrahedra, the caller's to delete. */
    voIndexedTetraSet* tessellate();
    void initTextures();

    /** Takes the vertices that were moved since into the set that tessellate made. */
    void moveTetras(voIndexedTetraSet* tetraSet);
    /** With the boxes of the lattice where -wireframe asks for outlines. */
    void draw(voIndexedTetraSet* tetraSet);

    /** All but the tetrahedra. */
    void free();

    voutLattice& getLattice() { return *lattice_; }
    /** Voxels along an axis. */
    int getSize(int axis) const { return volume_.size[axis]; }
    /** Of the voxels along an axis: the file's, or that of -scale. */
    double getSpacing(int axis) const { return spacing_[std::size_t(axis)]; }

private:
    void drawBoxes(voIndexedTetraSet* tetraSet);
    void reportFolds();

    std::string program_;
    VoglVolume volume_;
    std::array<double, 3> spacing_{1, 1, 1};
    std::unique_ptr<voutLattice> lattice_;
    std::unique_ptr<VoglPolygons> polygons_;
    std::unique_ptr<voIndexedFaceSet> boxes_; // to outline them
    int foldsReported_ = 0;
};
