#ifndef VO_UT_SOLIDS_H
#define VO_UT_SOLIDS_H

#include <vo/utGeometry.h>

/* Solids from a few numbers (guide, pages 97 and 114). Their tetrahedra have V3F records; the vertices of round ones lie
   on the surface, and everything between them inside. Numbers that give no solid are BAD_VALUE in the constructor; such
   an object tessellates into NULL, with BAD_VALUE again. So does one too small, too fine or too far from the origin for
   floats to tell its vertices apart. */

/** A ball about (x, y, z): slices (3 or more) round an axis along z, and stacks (2 or more) along it, as gluSphere has
    them. Tetrahedra from the centre, 2 * slices * (stacks - 1) of them. */
class VOUT_API voutSphere : public voutGeometry
{
public:
    voutSphere(float x, float y, float z, float radius, int slices, int stacks);
    virtual ~voutSphere();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A ball about (x, y, z) of tetrahedra from its centre to an icosahedron whose triangles were each divided into four
    level times (0 to 12): 20 * 4^level tetrahedra of nearly the same shape. */
class VOUT_API voutGeoSphere : public voutGeometry
{
public:
    voutGeoSphere(float x, float y, float z, float radius, int level);
    virtual ~voutGeoSphere();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** What lies between two balls about (x, y, z), 0 < innerRadius < outerRadius; as voutGeoSphere (level 0 to 11), with
    three tetrahedra a triangle. With an outer ball round a whole volume: everything outside of the inner one (guide, page
    113). */
class VOUT_API voutShell : public voutGeometry
{
public:
    voutShell(float x, float y, float z, float innerRadius, float outerRadius, int level);
    virtual ~voutShell();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A cylinder: from its base about (x, y, z) along z, upwards for a positive height, or between the middles of its ends. Slices (3 or more)
    round the axis, stacks (1 or more) along it; 3 * slices * stacks tetrahedra. */
class VOUT_API voutCylinder : public voutGeometry
{
public:
    voutCylinder(float x, float y, float z, float radius, float height, int slices, int stacks);
    voutCylinder(const float base[3], const float top[3], float radius, int slices, int stacks);
    virtual ~voutCylinder();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A cone: from its base about (x, y, z) to a tip along z, above for a positive height, or from the middle of its base to its tip. Slices and
    stacks as in voutCylinder; slices * (3 * stacks - 2) tetrahedra. */
class VOUT_API voutCone : public voutGeometry
{
public:
    voutCone(float x, float y, float z, float radius, float height, int slices, int stacks);
    voutCone(const float base[3], const float tip[3], float radius, int slices, int stacks);
    virtual ~voutCone();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A ring about (x, y, z) and the axis along z: a tube of tubeRadius whose middle lies radius away from the axis, 0 <
    tubeRadius < radius. Slices (3 or more) round the axis, sides (3 or more) round the tube; 3 * slices * sides
    tetrahedra. */
class VOUT_API voutTorus : public voutGeometry
{
public:
    voutTorus(float x, float y, float z, float radius, float tubeRadius, int slices, int sides);
    virtual ~voutTorus();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A box from (x, y, z) along the axes, as wide as xSize, ySize and zSize (more than 0) say, of columns by rows by layers
    smaller ones: vertices to move about, as in a deformation. */
class VOUT_API voutBox : public voutGeometry
{
public:
    voutBox(float x, float y, float z, float xSize, float ySize, float zSize, int columns = 1, int rows = 1,
            int layers = 1);
    virtual ~voutBox();

    /** 5 (the initial one), 6 or 24 tetrahedra in each, as in voutIndexedHexaSet. */
    void setTetrasPerHexa(int count);
    int getTetrasPerHexa() const;
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

/** A polygon of count points (3 or more; three coordinates each, copied), moved along a line: a logo, an organ drawn on a
    slice. It may be concave and go round either way. Seen along the line it must not touch or cross itself; three
    tetrahedra for each of its count - 2 triangles. */
class VOUT_API voutExtrusion : public voutGeometry
{
public:
    voutExtrusion(const float *polygon, int count, const float line[3]);
    virtual ~voutExtrusion();
    virtual voIndexedTetraSet *tessellate();

private:
    struct Private;
    Private *d;
};

#endif
