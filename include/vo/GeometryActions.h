#ifndef VO_GEOMETRY_ACTIONS_H
#define VO_GEOMETRY_ACTIONS_H

#include <vo/Appearance.h>
#include <vo/Geometry.h>

class voGeometryActions;
class voDrawActionCache;

/** Order of the bricks of a set, back to front, for the given OpenGL matrices (column by column). Exact for a brick
    lattice in orthographic and perspective views, the eye inside the volume included (guide, pages 56 and 151). */
class VO_API voSortAction
{
public:
    voSortAction(voBrickSet *brickSet, GLdouble modelMatrix[16], GLdouble projMatrix[16]);
    ~voSortAction();
    /** The number of the brick to draw as number brickNo. Outside 0 to count - 1: BAD_VALUE and 0. */
    int operator[](int brickNo) const;

private:
    struct Private;
    Private *d;
    voSortAction(const voSortAction &);
    voSortAction &operator=(const voSortAction &);
};

/** Sampling surfaces of an application (guide, pages 97 and 150): derive from this class and hand an object to
    voGeometryActions::polygonize. Surface 0 is drawn first, so it is the farthest. */
class VO_API voSamplingSurfaceSet
{
public:
    virtual ~voSamplingSurfaceSet();
    virtual int getSurfaceCount() const = 0;
    /** Appends one surface to facets as planar convex polygons; facets has records of 3 values, positions in the space
        of the tetrahedra's vertices, and grows. What may lie in the box is needed, more does no harm. Neighbouring
        facets repeat the same floats where they share a vertex, or the surface has cracks. */
    virtual void getSurface(int surface, float lowerLeft[3], float upperRight[3], voIndexedFaceSet *facets) = 0;

protected:
    voSamplingSurfaceSet();

private:
    voSamplingSurfaceSet(const voSamplingSurfaceSet &);
    voSamplingSurfaceSet &operator=(const voSamplingSurfaceSet &);
};

/** Parallel planes (guide, pages 97 and 150). */
class VO_API voSamplingPlaneSet : public voSamplingSurfaceSet
{
public:
    /** Plane 0 is Ax + By + Cz + D = 0, each further one lies `spacing` (above 0) farther along (A, B, C), which
        points to the viewer. */
    voSamplingPlaneSet(float planeEquation[4], float spacing, int count);
    /** The planes that voGeometryActions::polygonize uses with the same arguments. No planes: SPHERICAL in perspective
        views, and PRIMITIVE; BAD_VALUE and an empty set. */
    voSamplingPlaneSet(voIndexedTetraSet *tetraSet, voBrickSet *brickSet, GLdouble modelMatrix[16],
                       GLdouble projMatrix[16], voSamplingMode samplingMode, voSamplingSpace samplingSpace,
                       float samplingPeriod[3], int maxSamplesNumber);
    virtual ~voSamplingPlaneSet();

    virtual int getSurfaceCount() const;
    /** {A, B, C, D} of a plane, its positive side towards the viewer, (A, B, C) of length 1: what
        voGeometryActions::sample takes. Returns 0; outside 0 to count - 1 non-zero and BAD_VALUE. */
    int getPlane(int plane, float planeEquation[4]) const;
    /** One polygon, counterclockwise for the viewer: the plane inside the box; none when it misses the box. */
    virtual void getSurface(int surface, float lowerLeft[3], float upperRight[3], voIndexedFaceSet *facets);

private:
    struct Private;
    Private *d;
    friend class voGeometryActions;
    voSamplingPlaneSet(const voSamplingPlaneSet &);
    voSamplingPlaneSet &operator=(const voSamplingPlaneSet &);
};

/** Hands out the equations of a plane set one by one, the farthest first, then NULL. What it returns holds until it is
    asked again. */
class VO_API voSamplingPlaneSetIterator
{
public:
    explicit voSamplingPlaneSetIterator(voSamplingPlaneSet *planeSet);
    float *operator()();

private:
    voSamplingPlaneSet *set;
    int next;
    float equation[4];
};

/** Operations on geometry (guide, pages 50-58, 118-127, 149-156). All are static. Matrices are OpenGL's, 16 values
    column by column. Those that return int return 0, or non-zero with voError set. */
class VO_API voGeometryActions
{
public:
    typedef ::voSortAction voSortAction;

    /** Slices every tetrahedron with every sampling surface, clips to the clip box of every brick, and fills
        polygonSet[brick][sample]; sample 0 is the farthest. All face sets up to maxSamplesNumber, and the vertex data
        that they share, are emptied first. samplesNumber is written, never read. Every value of a record is
        interpolated linearly; the position is its last three. A format with voxel coordinates (T3F_...) is clipped by
        these, others by the position.

        samplingPeriod NULL: maxSamplesNumber surfaces. Else the step along the view direction d, in voxels, is
        1 / sqrt(sum (d_i / period_i)^2), the number of surfaces max(1, ceil(extent / step - 1e-6)), at most
        maxSamplesNumber, and surface k lies at far - (k + 1/2) extent / n (OBJECT; docs/frames.md has the others).
        SPHERICAL surfaces are made of flat facets within 0.02 steps of the shell: a tetrahedron yields many polygons a
        surface, more than boundFaceCount() says; face sets grow.
        Too little room in caller-owned storage: OUT_OF_MEMORY, and a shorter but valid result. */
    static int polygonize(voIndexedTetraSet *tetraSet, voBrickSet *brickSet, voInterleavedArrayType format,
                          GLdouble modelMatrix[16], GLdouble projMatrix[16], voSamplingMode samplingMode,
                          voSamplingSpace samplingSpace, float samplingPeriod[3], int maxSamplesNumber,
                          int &samplesNumber, voIndexedFaceSet ***polygonSet);
    /** The same, clipped by the position; samplesNumber in is the most (or, without a period, the exact) number of
        surfaces, out the number used. */
    static int polygonize(voIndexedTetraSet *tetraSet, voBrickSet *brickSet, GLdouble modelMatrix[16],
                          GLdouble projMatrix[16], voSamplingMode samplingMode, voSamplingSpace samplingSpace,
                          int &samplesNumber, float samplingPeriod[3], voIndexedFaceSet ***polygonSet);

    /** The same with surfaces of the application, or planes that it chose. At most maxSamplesNumber of them, else
        BAD_VALUE; polygons run round as the surface's facets do. Planes give what polygonize makes of them, bit for
        bit. */
    static int polygonize(voIndexedTetraSet *tetraSet, voBrickSet *brickSet, voInterleavedArrayType format,
                          voSamplingSurfaceSet *surfaces, int maxSamplesNumber, int &samplesNumber,
                          voIndexedFaceSet ***polygonSet);

    /** Cross-sections (guide, pages 118-121): fills polygonSet[brick][0] with what the bricks' clip boxes leave of the
        plane Ax + By + Cz + D = 0, given in voxels and seen counterclockwise from its positive side, or of a planar
        polygon, its records in order, which may be concave but must not cross itself. The caller allocates one face
        set a brick, with as many values a record as the format has; they, and the vertex data that they share, are
        emptied first. A format with voxel coordinates is cut by these; a plane has them equal to the positions, and
        colours of 1. USER_V3F goes with polygons only.

        A three-dimensional volume: bind, texgenSetEquation (or, for T3F, xfmVox2TexCoords once) and draw brick by
        brick, in any order. A stack of two-dimensional bricks: any of the three stacks will do, best the one that lies
        most across the polygon's normal; every polygon appears in the two slices on both sides of it, with its colours
        multiplied by weights that add up to 1. Draw with smooth shading, modulating textures, depth test off, and
        additive blending, glBlendFunc(GL_ONE, GL_ONE), over black: the sum is the trilinear picture. The weights are
        in all channels of C4F, alpha too; C3F leaves the alpha alone; a format without colours cannot carry them:
        BAD_VALUE. Half a voxel at either end of the stack repeats the outermost slice. */
    static int polygonizeMPR(float planeEquation[4], voBrickSet *brickSet, voIndexedFaceSet ***polygonSet,
                             voInterleavedArrayType format);
    static int polygonizeMPR(voVertexData *polygon, voBrickSet *brickSet, voIndexedFaceSet ***polygonSet,
                             voInterleavedArrayType format);

    /** The vertices of tetrahedron and plane {A, B, C, D}, Ax + By + Cz + D = 0: none, 3 or 4, in order round the
        polygon. A vertex on the plane counts as in front (Ax + By + Cz + D >= 0). polygonVerts is emptied first and
        needs room for 4 records, of which the last three values are written. */
    static int sample(float tetraVerts[4][3], float planeEquation[4], voVertexData *polygonVerts);

    /** A convex polygon (its records in order) cut by its positions to a box, both faces included, or to the positive
        sides of planes {A, B, C, D}; what is left, if anything, is appended to faceSet with every value interpolated. */
    static int clip(voVertexData *polygon, voInterleavedArrayType format, float lowerLeft[3], float upperRight[3],
                    voIndexedFaceSet *faceSet);
    static int clip(voVertexData *polygon, float lowerLeft[3], float upperRight[3], voIndexedFaceSet *faceSet);
    static int clip(voVertexData *polygon, voInterleavedArrayType format, float *planes, int planeCount,
                    voIndexedFaceSet *faceSet);

    /** Draw in the current state of OpenGL, which is given back as it was. USER_V3F: UNSUPPORTED. The mode, GL_FILL,
        GL_LINE or GL_POINT, holds for the call. draw of a tetra set draws the faces of its tetrahedra, of a brick or
        a brick set their outlines in the current colour. */
    static void draw(voIndexedFaceSet *faceSet, voInterleavedArrayType format);
    static void draw(voIndexedFaceSet *faceSet, GLenum mode, voInterleavedArrayType format);
    static void draw(voIndexedTetraSet *tetraSet, voInterleavedArrayType format);
    static void draw(voIndexedTetraSet *tetraSet, GLenum mode, voInterleavedArrayType format);
    static void draw(voBrick *brick);
    static void draw(voBrickSet *brickSet);

    /** A whole frame: chooses the stack, polygonizes through the cache, sorts, binds and draws with the current
        matrices, colour and blending. cache may be NULL. Tetrahedra with a vertex whose position is not finite are
        left out. Returns 0, or non-zero with voError set: BAD_VALUE for singular matrices, bricks without voxels, and
        an incomplete framebuffer, into which nothing is drawn. */
    static int drawUtility(voIndexedTetraSet *tetraSet, voInterleavedArrayType format, voBrickSetCollection *volume,
                           voDrawActionCache *cache, voSamplingSpace samplingSpace, float samplingPeriod[3],
                           voDecorationFlags decorations);

    /** What the viewer sees along the line of sight through the centre of a pixel. pixelPosition is {x, y} in OpenGL's
        window coordinates, from the lower left, within viewport {x, y, width, height}.

        The samples lie where polygonize has VIEWPORT_ALIGNED surfaces in OBJECT space (for a stack, and a brick of one,
        AXIS_ALIGNED ones) with the same samplingPeriod, inside the tetrahedra, the bricks' clip boxes and the view
        volume, each once; samplingPeriod NULL: as many surfaces as coordinates has room for records. The nearest comes
        first; of more samples than coordinates has room for, the nearest are kept. Returns VO_TRUE when there is one.

        coordinates gets a record a sample, interpolated like polygonize's, and their number as its count, 0 after a
        miss. Its records are those of the tetrahedra (values of the user in front included); where these are positions
        alone, T3F_V3F adds voxel coordinates equal to them.

        voxels, unless NULL, gets a voxel a sample, packed one after the other, in the bricks' external format and data
        type; it needs room for as many as coordinates. flag VO_FALSE: the voxel of the containing brick that holds the
        sample's voxel coordinates (T3F, else the position), as it lies. flag VO_TRUE: what draw would make of the sample,
        before blending: the texture filtered, the active lookup table, the vertices' colours or the current one, texture
        environment and texture matrix, with smooth shading, from the voxels as they are now. It is converted to the
        external format as dataConvert does, one channel taking luminance 0.30 R + 0.59 G + 0.11 B, and clamped to what
        the data type holds. It needs a current context (else UNSUPPORTED), and another format than USER_V3F.

        A pixel outside the viewport, singular matrices, records that do not fit, a brick that is met without voxels:
        BAD_VALUE, VO_FALSE, and nothing is written. The form with one brick looks at that brick alone, all faces of its
        clip box included. */
    static voBool pick(int pixelPosition[2], int viewport[4], voIndexedTetraSet *tetraSet, voBrickSet *brickSet,
                       voInterleavedArrayType format, GLdouble modelMatrix[16], GLdouble projMatrix[16],
                       float samplingPeriod[3], voBool flag, voVertexData *coordinates, void *voxels);
    static voBool pick(int pixelPosition[2], int viewport[4], voIndexedTetraSet *tetraSet, voBrick *brick,
                       voInterleavedArrayType format, GLdouble modelMatrix[16], GLdouble projMatrix[16],
                       float samplingPeriod[3], voBool flag, voVertexData *coordinates, void *voxels);

    /** AXIS_ALIGNED: the stack most perpendicular to the view, XY, XZ or YZ. Any other mode: UNSPECIFIED. */
    static voPlaneOrientation findClosestAxisIndex(GLdouble modelMatrix[16], GLdouble projMatrix[16],
                                                   int samplingMode);
    /** Eye position and unit view direction in object space. Orthographic: viewDir[3] = 0 and eyePos is left alone;
        perspective: viewDir[3] = 1. Singular matrices: BAD_VALUE, nothing is written. */
    static void findCameraPosition(double eyePos[3], double viewDir[4], GLdouble modelMatrix[16],
                                   GLdouble projMatrix[16]);
    /** Unit view direction in object space. Singular matrices: BAD_VALUE and (0, 0, 1). */
    static void findViewDirection(double viewDir[3], GLdouble modelMatrix[16], GLdouble projMatrix[16]);
    /** Area in pixels that the polygons of the face set cover on the screen, the sum over all polygons, whichever
        side faces the viewer: the fragments that they cost. Each is cut to the view volume first, as OpenGL does, so
        that nothing outside the viewport, before the near or beyond the far plane counts. viewport as of glViewport:
        only its sizes matter. Singular matrices, negative sizes: BAD_VALUE and 0. */
    static float findProjectedArea(voIndexedFaceSet *faceSet, GLdouble modelMatrix[16], GLdouble projMatrix[16],
                                   GLint viewport[4]);
};

typedef voGeometryActions voGeometryAction;

/** Base of what is kept from frame to frame (guide, page 98). */
class VO_API voCache
{
public:
    virtual ~voCache();
    /** Everything kept is stale. */
    virtual void invalidate() = 0;

protected:
    voCache();
};

/** The polygons of the last frame, for drawUtility (guide, pages 98 and 115). They are made anew when the volume's
    current set, the tetrahedra (compared by content), the sampling period or space, or the matrices change: the view
    direction by more than the threshold, or with SPHERICAL the eye by more than that seen from the middle of the
    tetrahedra. maxSamplesNumber bounds the surfaces; the other sizes are hints. The
    objects are borrowed. */
class VO_API voDrawActionCache : public voCache
{
public:
    voDrawActionCache(voIndexedTetraSet *tetraSet, voBrickSetCollection *volume, int maxSamplesNumber,
                      voSamplingMode samplingMode, int valuesPerVertex, int maxVertices);
    virtual ~voDrawActionCache();
    /** Degrees that the view direction may turn before the polygons are made again; 0, the initial value: with any
        change. */
    void setThreshold(double degrees);
    virtual void invalidate();

private:
    struct Private;
    Private *d;
    friend struct voInside;
    voDrawActionCache(const voDrawActionCache &);
    voDrawActionCache &operator=(const voDrawActionCache &);
};

/** The names that the guide also uses without their class (pages 143, 153-155). */
VO_API voPlaneOrientation findClosestAxisIndex(GLdouble modelMatrix[16], GLdouble projMatrix[16], int samplingMode);
VO_API int sample(float tetraVerts[4][3], float planeEquation[4], voVertexData *polygonVerts);
VO_API int clip(voVertexData *polygon, float lowerLeft[3], float upperRight[3], voIndexedFaceSet *faceSet);

#endif
