#ifndef VO_UT_LATTICE_H
#define VO_UT_LATTICE_H

#include <vo/utGeometry.h>

/** A volume as boxes whose corners may be moved: the picture warps, and no voxel is resampled (guide, pages 14, 161 and
    166). Of the library vout.

    nx x ny x nz boxes fill a box of the volume. Vertex (i, j, k) has the number (k * (ny + 1) + j) * (nx + 1) + i. It has
    voxel coordinates, which stay, and a position, which is moved; both are in voxels (docs/frames.md) and equal at first,
    so that the model matrix of the volume draws the lattice too. Between vertices a warp is interpolated linearly: its
    error falls with the square of the boxes' size.

    Angles are in degrees, lengths in units of the spacing: voxels, unless setSpacing says otherwise. Axes are 0, 1, 2 for
    x, y, z. "The box" is that of the constructor, whatever was moved since. Every warp moves vertices on from where they
    are; one that would take any beyond what floats hold, or whose arguments are wrong, is BAD_VALUE and moves none. */
class VOUT_API voutLattice : public voutGeometry
{
public:
    /** Over the box from `lower` to `upper`, in voxels. BAD_VALUE for less than one box along an axis, for an upper end
        that is not above the lower one, and for more boxes than ints can number: then there are no vertices. */
    voutLattice(int nx, int ny, int nz, const float lower[3], const float upper[3]);
    virtual ~voutLattice();

    /** Boxes along x, y and z. */
    void getSizes(int &nx, int &ny, int &nz) const;
    /** How boxes are split: 5, 6 or 24, as in voutIndexedHexaSet. */
    void setTetrasPerHexa(int count);
    int getTetrasPerHexa() const;
    /** Distances of the voxels along x, y and z, above 0, in any unit; 1 at first. What is turned keeps its shape in
        that unit. */
    void setSpacing(const float spacing[3]);

    int getVertexCount() const;
    /** The number of a vertex, 0 <= i <= nx and so on; outside: BAD_VALUE and -1. */
    int getVertexIndex(int i, int j, int k) const;
    /** By number; outside: BAD_VALUE, and nothing is written. */
    void getVoxelCoordinates(int vertex, float voxel[3]) const;
    void getVertex(int vertex, float position[3]) const;
    void setVertex(int vertex, const float position[3]);
    /** Moves all vertices back to their voxel coordinates. */
    void reset();

    /** Moves each vertex as the function says, which changes a position in voxels. */
    void warp(void (*function)(float position[3], void *user), void *user = NULL);
    /** Turns the upper face across the axis by `degrees` against the lower one, about the box's middle; positive: from
        the next axis (of x, y, z, x) towards the one after it. */
    void twist(int axis, float degrees);
    /** Makes an arc of `degrees` of the axis through the box's middle, its ends towards the upper end of the axis
        `towards`, its length the same. */
    void bend(int axis, int towards, float degrees);
    /** Scales across the axis, by 1 at its lower end to `factor` at its upper one. */
    void taper(int axis, float factor);
    /** Places what lies in polar coordinates: along `depthAxis` are distances from a point, from r0 at the lower face of
        the box to r1 at its upper one; along `beamAxis` are directions, `degrees` in all; along the third axis the fan is
        swung by `elevation` degrees in all, or with 0 stays as thick as it is. The middle of the lower face stays where
        it is. 0 <= r0 < r1. */
    void fan(int depthAxis, int beamAxis, float degrees, float r0, float r1, float elevation = 0);
    /** The same round an axis through the box's middle: a tube of inner radius r0 and outer radius r1 about the third
        axis. The middle of the beam axis goes towards the upper end of the depth axis. */
    void cylinder(int depthAxis, int beamAxis, float r0, float r1, float degrees = 360);
    /** Moves by a field of vectors that spans the box in sizes[0] x sizes[1] x sizes[2] cells, x fastest, three floats
        each: sampled trilinearly where the vertices are, constant beyond the outermost centres. Vectors say how far the
        volume's points move, times `scale`, in units of the spacing. */
    void displace(const float *vectors, const int sizes[3], float scale = 1);
    /** Moves and scales all alike, so that the lattice's extent has its middle where the box has it, and its farthest
        vertex lies on the sphere round the box: views made for the volume show it whole. */
    void fit();

    /** Tetrahedra that are inside out, which draw parts of the volume twice; and those that are flat, which draw
        nothing. -1 where there is no lattice. */
    int countInverted() const;
    int countFlat() const;

    /** Records of T3F_V3F: first the lattice's vertices in order, then those that 24 tetrahedra a box add. The
        tetrahedra depend on the sizes alone; their handedness is that of voutGeometry in voxel coordinates, and in space
        too unless they are inverted or flat. */
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

#endif
