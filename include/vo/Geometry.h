#ifndef VO_GEOMETRY_H
#define VO_GEOMETRY_H

#include <vo/Enums.h>
#include <vo/Error.h>

/** Array of vertex records, each of getValuesPerVertex() floats; the last three are the position (guide, pages
    47-48 and 102-104). Contiguous, record after record. */
class VO_API voVertexData
{
public:
    /** Room for countMax records. With data (countMax * valuesPerVertex floats): used by reference, never freed,
        count = countMax. Without: allocated, count = 0. BAD_VALUE for a negative count or fewer than 1 value. */
    voVertexData(int countMax, int valuesPerVertex, float *data = NULL);
    ~voVertexData();

    /** Sets the count to 0; storage and capacity stay. */
    void empty();

    /** Record i, for any 0 <= i < getCountMax(), also when the count is 0. Outside: BAD_VALUE and NULL. */
    float *operator[](int i);
    const float *operator[](int i) const;

    /** Records in use. setCount takes 0 to getCountMax(), else BAD_VALUE. */
    int getCount() const;
    void setCount(int count);
    int getCountMax() const;
    int getValuesPerVertex() const;
    float *getDataPtr();
    const float *getDataPtr() const;

private:
    struct Private;
    Private *d;
    friend struct voInside;
    voVertexData(const voVertexData &);
    voVertexData &operator=(const voVertexData &);
};

/** Array of indices (guide, page 104), with the ownership rules of voVertexData. */
class VO_API voIndices
{
public:
    voIndices(int countMax, int *indices = NULL);
    ~voIndices();

    void empty();
    /** Entry i, for any 0 <= i < getCountMax(). Outside: BAD_VALUE, and a reference to a scratch entry. */
    int &operator[](int i);
    int operator[](int i) const;
    int getCount() const;
    void setCount(int count);
    int getCountMax() const;
    int *getDataPtr();
    const int *getDataPtr() const;

private:
    struct Private;
    Private *d;
    friend struct voInside;
    voIndices(const voIndices &);
    voIndices &operator=(const voIndices &);
};

/** One voVertexData and one voIndices: the base of tetra sets and face sets (guide, page 105). */
class VO_API voIndexedSet
{
public:
    virtual ~voIndexedSet() = 0;

    /** The parts, never NULL; they belong to the set, or to whoever passed them to its constructor. */
    voVertexData *getVertexData() const;
    voIndices *getIndices() const;

    virtual void empty();
    /** The vertex record that index entry i points at. Outside, or an entry that points nowhere: BAD_VALUE, NULL. */
    virtual float *operator[](int i);

protected:
    voIndexedSet();
    struct Private;
    Private *d;
    friend struct voInside;

private:
    voIndexedSet(const voIndexedSet &);
    voIndexedSet &operator=(const voIndexedSet &);
};

/** Visits the primitives of a set one by one (guide, page 105). */
class VO_API voIndexedSetIterator
{
public:
    virtual ~voIndexedSetIterator();
    /** The next vertex record of the current primitive, NULL after its last. */
    virtual float *nextVertex() = 0;
    /** Steps to the next primitive and restarts its vertices. */
    virtual void nextPrimitive() = 0;
    /** True once the whole set was traversed. */
    virtual voBool doneP() const = 0;
    /** The same, under the name of one listing (guide, page 108). */
    voBool done() const;

protected:
    explicit voIndexedSetIterator(voIndexedSet *set);
    voIndexedSet *set;
    int next;
    int vertex;
};

/** A collection of polygons (guide, pages 49 and 106-108). The indices are groups: a vertex count, then that many
    vertex numbers. Index storage grows on demand. */
class VO_API voIndexedFaceSet : public voIndexedSet
{
public:
    /** Own vertex storage, which grows on demand. */
    voIndexedFaceSet(int countMaxV, int valuesPerVertex, int countMaxI);
    /** Shares vertexData, which is borrowed and must outlive the set; its storage does not grow. */
    voIndexedFaceSet(voVertexData *vertexData, int countMaxI);
    virtual ~voIndexedFaceSet();

    /** Own vertices: both counts become 0. Shared vertices: only the index count does. */
    virtual void empty();

    /** Appends one polygon of count >= 3 vertices. vdata NULL or equal to the first free record of the vertex data:
        the records are already there, starting at it. Else count records are copied there. No room left in shared
        storage: OUT_OF_MEMORY, nothing is appended. */
    void appendPoly(float *vdata, int count);

private:
    friend struct voInside;
};

typedef voIndexedFaceSet *voIndexedFaceSetPtr;
typedef voIndexedFaceSet **voIndexedFaceSetPtrPtr;
typedef voIndexedFaceSet voFaceSet;

/** Visits the polygons of a face set in the order in which they were appended. */
class VO_API voIndexedFaceSetIterator : public voIndexedSetIterator
{
public:
    explicit voIndexedFaceSetIterator(voIndexedFaceSet *faceSet);
    virtual float *nextVertex();
    virtual void nextPrimitive();
    virtual voBool doneP() const;
};

/** A collection of tetrahedra: four vertex numbers each, of any handedness; degenerate ones are ignored (guide,
    pages 45-47 and 109-110). */
class VO_API voIndexedTetraSet : public voIndexedSet
{
public:
    /** By reference: countV records of valuesPerVertex floats, countI indices (a multiple of 4, else BAD_VALUE);
        both must outlive the set. */
    voIndexedTetraSet(float *data, int countV, int valuesPerVertex, int *indices, int countI);
    /** The same from arrays that may not be changed: copied. */
    voIndexedTetraSet(const float *data, int countV, int valuesPerVertex, const int *indices, int countI);
    /** Empty, with room; fill it through getVertexData() and getIndices(), then set their counts. */
    voIndexedTetraSet(int countMaxV, int valuesPerVertex, int countMaxI);
    /** Borrows both parts. */
    voIndexedTetraSet(voVertexData *data, voIndices *indices);
    virtual ~voIndexedTetraSet();
};

/** Visits the tetrahedra of a set: four vertices each. */
class VO_API voIndexedTetraSetIterator : public voIndexedSetIterator
{
public:
    explicit voIndexedTetraSetIterator(voIndexedTetraSet *tetraSet);
    virtual float *nextVertex();
    virtual void nextPrimitive();
    virtual voBool doneP() const;
};

/** Upper bound of the indices that one sampling surface yields in one brick: 11 for each tetrahedron, a polygon of
    ten vertices and its count (guide, page 76). */
VO_API int boundFaceCount(int tetraCount);

/** True for the T3F_* layouts. */
VO_API voBool hasTextureComponent(voInterleavedArrayType format);

/** Floats in a record: 3, 6, 6, 7, 9, 10 for V3F, T3F_V3F, C3F_V3F, C4F_V3F, T3F_C3F_V3F, T3F_C4F_V3F.
    USER_V3F: BAD_VALUE and 0. */
VO_API int getValuesPerVertex(voInterleavedArrayType format);

#endif
