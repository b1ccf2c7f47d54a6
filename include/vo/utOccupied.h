#ifndef VO_UT_OCCUPIED_H
#define VO_UT_OCCUPIED_H

#include <vo/Appearance.h>
#include <vo/LookupTable.h>
#include <vo/utGeometry.h>

/** Writes the values of size[0] x size[1] x size[2] voxels from `origin` on, x fastest; answers 0, or anything else where
    it cannot. */
typedef int (*voutReadVoxels)(const int origin[3], const int size[3], double *values, void *user);

/** The parts of a volume in which anything shows, as boxes: what is empty costs nothing where it is not drawn (guide, page
    161). Of the library vout.

    The volume is cut into blocks of blockSize voxels a side. A block is occupied where a voxel in it or next to it is
    visible, or a value that interpolation finds between two such voxels: all visible voxels lie in occupied blocks, and
    all their neighbours. Blocks are joined into boxes that do not overlap, greedily, along the axes in each order, and the
    fewest are taken. All of this is done in the constructor; what changes later is not seen.

    Values are 0 to 1 for a volume of bricks: the voxel of one channel, the alpha of others (always 1 in RGB8_EXT). Those of
    a function are what it gives, of which a table takes 0 to 1. */
class VOUT_API voutOccupied : public voutGeometry
{
public:
    /** Visible is what the table, which was loaded, gives an opacity above 0; without one (NULL) values other than 0, and
        every voxel of LUMINANCE8_EXT. */
    explicit voutOccupied(voBrickSetCollection *volume, voLookupTable *table = NULL, int blockSize = 8);
    /** Visible is what lies from low to high. */
    voutOccupied(voBrickSetCollection *volume, float low, float high, int blockSize);
    /** The same of sizes[0] x sizes[1] x sizes[2] voxels that a function reads, layer by layer. */
    voutOccupied(const int sizes[3], voutReadVoxels read, void *user, voLookupTable *table, int blockSize = 8);
    voutOccupied(const int sizes[3], voutReadVoxels read, void *user, double low, double high, int blockSize);
    virtual ~voutOccupied();

    /** Blocks along x, y and z; 0 where the constructor failed. */
    void getBlockCounts(int &nx, int &ny, int &nz) const;
    int getBlockCount() const;
    int getOccupiedCount() const;
    /** VO_FALSE, too, outside. */
    voBool isOccupied(int i, int j, int k) const;

    /** VO_TRUE, the initial value: blocks are joined. VO_FALSE: each occupied block is a box. */
    void setMerged(voBool merged);
    voBool getMerged() const;
    int getBoxCount() const;
    /** The corners of a box, in voxels. Outside 0 to getBoxCount() - 1: BAD_VALUE, and nothing is written. */
    void getBox(int index, float lower[3], float upper[3]) const;
    /** The boxes' part of the volume, 0 to 1. */
    double getCoveredFraction() const;

    /** Records of V3F. Boxes of all sizes share whole faces: no slice has a seam. Where nothing shows the set is empty.
        Otherwise, unless the boxes fill the volume, the last two tetrahedra are flat: they draw nothing, and hold the volume's
        eight corners, so that sampling planes lie where those of the whole volume do.

        Where blockSize is a multiple of 4, drawUtility draws the set as it would draw the whole volume, to the bit, as
        long as all that the active tables make visible lies inside (docs/vout.md). */
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

#endif
