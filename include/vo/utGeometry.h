#ifndef VO_UT_GEOMETRY_H
#define VO_UT_GEOMETRY_H

#include <vo/Geometry.h>

#if defined(_WIN32)
#if defined(VOUT_BUILDING)
#define VOUT_API __declspec(dllexport)
#else
#define VOUT_API __declspec(dllimport)
#endif
#else
#define VOUT_API VO_API
#endif

/* Higher primitives: solids that become tetrahedra (guide, pages 97-98 and 113-114). They are of the library vout:
   link -lvout beside -lvo. */

/** A solid (guide, page 114). */
class VOUT_API voutGeometry
{
public:
    virtual ~voutGeometry();

    /** A new set at each call, the caller's to delete. All tetrahedra (a, b, c, d) are of one handedness, with
        (b - a) x (c - a) . (d - a) > 0, and share whole faces or none of a face with one another. NULL and BAD_VALUE
        where the solid is none: then its constructor has reported already, or its indices are wrong by now. */
    virtual voIndexedTetraSet *tessellate() = 0;
    /** The same, as one listing spells it. */
    voIndexedTetraSet *tesselate();

protected:
    voutGeometry();

private:
    voutGeometry(const voutGeometry &);
    voutGeometry &operator=(const voutGeometry &);
};

/** Cells of one kind on vertex records: the base of sets and strips (guide, pages 97 and 113). Constructors, records
    and ownership are those of voIndexedTetraSet.

    The tetrahedra's records are the solid's, with all their values, then those that splitting adds: means of corners in
    every value. Cells that share a face agree on how it is cut, so that nothing cracks when vertices move; sets and
    strips that number the same vertices agree too, but for boxes (see voutIndexedHexaSet). Cells may be of either
    handedness and out of shape; one that is partly inside out is BAD_VALUE. Cells and tetrahedra without volume are left
    out. */
class VOUT_API voutIndexedSet : public voutGeometry
{
public:
    virtual ~voutIndexedSet();

    /** The parts, never NULL; they belong to the set, or to whoever passed them to its constructor. */
    voVertexData *getVertexData() const;
    voIndices *getIndices() const;
    /** Sets the counts to 0: that of vertices only where the set owns them. */
    virtual void empty();

protected:
    voutIndexedSet(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedSet(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedSet(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedSet(voVertexData *data, voIndices *indices);
    struct Private;
    Private *d;
};

/** Tetrahedra in a row, each sharing a face with the next: a, b, c, d, then a vertex for each further one. (The guide's
    "at a single point" on page 98 is a slip.) */
class VOUT_API voutIndexedTetraFaceStrip : public voutIndexedSet
{
public:
    voutIndexedTetraFaceStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedTetraFaceStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedTetraFaceStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedTetraFaceStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Tetrahedra in a row, each sharing an edge with the next: a, b, c, d, then two vertices for each further one, which
    begins with the two before. */
class VOUT_API voutIndexedTetraEdgeStrip : public voutIndexedSet
{
public:
    voutIndexedTetraEdgeStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedTetraEdgeStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedTetraEdgeStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedTetraEdgeStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Boxes: eight vertices each, four round the bottom, then the four above them (as the guide's cube has them on page
    76). */
class VOUT_API voutIndexedHexaSet : public voutIndexedSet
{
public:
    voutIndexedHexaSet(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedHexaSet(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedHexaSet(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedHexaSet(voVertexData *data, voIndices *indices);

    /** How boxes are split (guide, pages 23 to 25); other numbers are BAD_VALUE.
        5, the initial one: the guide's cube and its mirror image in turn, so that neighbours match. Boxes that cannot
        take turns (three round an edge) are split as by 6.
        6: each face from the smallest of its vertex numbers, as in prisms and pyramids: sets of different cells that
        number the same vertices match.
        24: from the middle of the box and of each face; colours and voxel coordinates show no diagonals. */
    void setTetrasPerHexa(int count);
    int getTetrasPerHexa() const;
    virtual voIndexedTetraSet *tessellate();
};

/** Boxes in a row, each sharing a face with the next: the four vertices round each face. */
class VOUT_API voutIndexedHexaStrip : public voutIndexedSet
{
public:
    voutIndexedHexaStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedHexaStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedHexaStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedHexaStrip(voVertexData *data, voIndices *indices);

    /** As in voutIndexedHexaSet. */
    void setTetrasPerHexa(int count);
    int getTetrasPerHexa() const;
    virtual voIndexedTetraSet *tessellate();
};

/** Prisms: three vertices of the bottom, then the three above them. */
class VOUT_API voutIndexedPrismSet : public voutIndexedSet
{
public:
    voutIndexedPrismSet(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPrismSet(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPrismSet(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPrismSet(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Prisms side by side, each sharing a side face with the next, as triangles of a strip do: upright edges, the lower
    vertex and the upper one of each; three edges, then one for each further prism. */
class VOUT_API voutIndexedPrismFaceStrip : public voutIndexedSet
{
public:
    voutIndexedPrismFaceStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPrismFaceStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPrismFaceStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPrismFaceStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Prisms on top of one another: the three vertices of each triangle. */
class VOUT_API voutIndexedPrismBaseStrip : public voutIndexedSet
{
public:
    voutIndexedPrismBaseStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPrismBaseStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPrismBaseStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPrismBaseStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Prisms in a row, each sharing an upright edge with the next: upright edges, the lower vertex and the upper one of
    each; three edges, then two for each further prism, which begins with the edge before. */
class VOUT_API voutIndexedPrismEdgeStrip : public voutIndexedSet
{
public:
    voutIndexedPrismEdgeStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPrismEdgeStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPrismEdgeStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPrismEdgeStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Pyramids: four vertices round the base, then the tip. */
class VOUT_API voutIndexedPyramidSet : public voutIndexedSet
{
public:
    voutIndexedPyramidSet(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPyramidSet(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPyramidSet(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPyramidSet(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

/** Pyramids round one tip, each sharing a side face with the next: the tip, then the bases as a strip of
    quadrilaterals: two pairs of vertices, and a pair for each further pyramid. */
class VOUT_API voutIndexedPyramidStrip : public voutIndexedSet
{
public:
    voutIndexedPyramidStrip(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    voutIndexedPyramidStrip(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    voutIndexedPyramidStrip(int countMaxV, int valuesPerVertex, int countMaxI);
    voutIndexedPyramidStrip(voVertexData *data, voIndices *indices);
    virtual voIndexedTetraSet *tessellate();
};

#endif
