#ifndef VO_UT_SOLID_ACTIONS_H
#define VO_UT_SOLID_ACTIONS_H

#include <vo/utGeometry.h>

/* Operations on sets of tetrahedra: cuts, unions by tags, transformations (guide, pages 14-16). Of the library vout. */

/** All are static, take sets of any vertex format, change none of them and answer a new set, the caller's to delete; NULL
    with voError set where arguments are wrong. Tetrahedra of either handedness are taken; those without volume, or with a
    vertex whose position is not finite, are left out. An answer may be empty.

    Cuts are exact: tetrahedra that a plane crosses are split along it. Pieces have positive volumes as voutGeometry's
    have, share whole faces with their neighbours, and one vertex for each edge that is cut, whose record is interpolated
    in every value; a piece with too many faces gets one in its middle. What a plane only touches is not split. inside()
    and outside() of the same arguments make the same vertices between them: their sets fit without a crack, and together
    are the whole. Cuts are computed in double precision; a plane that passes a vertex within 2^-20 of the set's largest
    coordinate goes through it, and pieces that are so thin that floats make them flat are left out.

    Planes are {A, B, C, D}, one after the other; Ax + By + Cz + D >= 0 is inside, as with voGeometryActions::clip.
    They cut by the positions, the last three values of a record. */
class VOUT_API voutSolidActions
{
public:
    /** What lies inside of all planes; inside of a box; inside of a convex set of tetrahedra (one that is not convex:
        BAD_VALUE). */
    static voIndexedTetraSet *inside(voIndexedTetraSet *set, const float *planes, int planeCount);
    static voIndexedTetraSet *inside(voIndexedTetraSet *set, const float lowerLeft[3], const float upperRight[3]);
    static voIndexedTetraSet *inside(voIndexedTetraSet *set, voIndexedTetraSet *convex);

    /** The set minus that: what lies outside of at least one of the planes, of a box, of a convex set. */
    static voIndexedTetraSet *outside(voIndexedTetraSet *set, const float *planes, int planeCount);
    static voIndexedTetraSet *outside(voIndexedTetraSet *set, const float lowerLeft[3], const float upperRight[3]);
    static voIndexedTetraSet *outside(voIndexedTetraSet *set, voIndexedTetraSet *convex);

    /** Geometry moves, voxels stay: the set with voxel coordinates (T3F_V3F, T3F_C3F_V3F or T3F_C4F_V3F) that are those of
        the set, or where it has none its positions, and positions multiplied by an affine OpenGL matrix, 16 values column
        by column. A matrix that is singular, projective or not finite, and USER_V3F: BAD_VALUE. */
    static voIndexedTetraSet *transformed(voIndexedTetraSet *set, voInterleavedArrayType format,
                                          const GLdouble matrix[16]);
};

/** Several sets as one: each tetrahedron has a tag, which tells the set that it came from. Sets are copied. */
class VOUT_API voutTaggedSet : public voutGeometry
{
public:
    /** Of records of so many values, 3 or more (else BAD_VALUE). */
    explicit voutTaggedSet(int valuesPerVertex);
    virtual ~voutTaggedSet();

    /** Appends a set with a tag of any number; one that is there already is extended. Returns 0, or non-zero with voError
        set and nothing appended: BAD_VALUE for records of other sizes and indices that are wrong. */
    int append(voIndexedTetraSet *set, int tag);
    /** From now on vertices of equal records are one, whichever set they came from. Returns how many fewer there are. */
    int mergeVertices();

    int getTetraCount() const;
    int getVertexCount() const;
    /** The tag of a tetrahedron of tessellate(), in its order; outside: BAD_VALUE and 0. */
    int getTag(int tetra) const;
    /** Whether any tetrahedron has the tag. */
    voBool hasTag(int tag) const;

    /** All of it as one set. Here tetrahedra keep the handedness that they came with, and may overlap. */
    virtual voIndexedTetraSet *tessellate();
    /** A new set of the tetrahedra of one tag, and the vertices that they use; without any, it is empty. */
    voIndexedTetraSet *extract(int tag) const;

private:
    struct Private;
    Private *d;
};

#endif
