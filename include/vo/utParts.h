#ifndef VO_UT_PARTS_H
#define VO_UT_PARTS_H

#include <vo/LookupTable.h>
#include <vo/utGeometry.h>

/** Parts of a scene that are drawn together: sets of tetrahedra in one volume or in several, each with a matrix, a colour
    and a lookup table of its own if it likes (guide, pages 14 to 16: the jaw). Of the library vout.

    All parts are cut by the same planes, and drawn plane by plane, the farthest first: they blend in the right order
    wherever they lie, also where they overlap. On one plane the part that was added first is drawn first.

    A part's matrix moves its geometry, not its voxels: drawn is what voutSolidActions::transformed makes of its set. All
    parts lie in one space, that of the model matrix, in whose unit the sampling period and voState::setUnitLength count.

    Sets, volumes and tables are borrowed, and read when parts are drawn. Part numbers that are none are BAD_VALUE. */
class VOUT_API voutParts
{
public:
    voutParts();
    ~voutParts();

    /** Adds a part of a volume; returns its number, from 0 on, or -1 with BAD_VALUE for NULL, BAD_ENUM for no format. */
    int add(voIndexedTetraSet *tetraSet, voInterleavedArrayType format, voBrickSetCollection *volume);
    int getCount() const;

    /** An affine OpenGL matrix, 16 values column by column, from the set's positions to the space of all; NULL, as at
        first: the same place. */
    void setMatrix(int part, const GLdouble matrix[16]);
    /** Multiplies what is drawn, the vertices' own colours included, and stands for OpenGL's current colour. */
    void setColor(int part, float red, float green, float blue, float alpha);
    /** As at first: the vertices' own colours, or where they have none OpenGL's current one. */
    void resetColor(int part);
    /** NULL, as at first: no table, whichever is active elsewhere. Tables after interpolation are meant; one before it is
        applied anew to the whole volume whenever parts change turns. */
    void setLookupTable(int part, voLookupTable *table);
    /** Whether it is drawn, and counts where planes are spread; VO_TRUE at first. */
    void setVisible(int part, voBool visible);

    /** Draws all, with the blending and the framebuffer that are set, by slices through OpenGL, whatever
        voState::setEngine says. The matrices are those that OpenGL has, or voState in the core profile. The sampling
        arguments are those of voGeometryActions::polygonize; the surfaces are those that it would use for one set of all
        visible parts. Texturing, texture coordinates, tables and voState::setSampling are off afterwards.

        Stacks of two-dimensional bricks are cut AXIS_ALIGNED, along the axis of the space of all that is most along the
        view; a matrix that tilts their slices against it is UNSUPPORTED, and so is PRIMITIVE space. Returns 0, or non-zero
        with voError set. */
    int draw(GLdouble modelMatrix[16], GLdouble projMatrix[16], voSamplingMode samplingMode,
             voSamplingSpace samplingSpace, float samplingPeriod[3], int maxSamplesNumber);

private:
    struct Private;
    Private *d;
    voutParts(const voutParts &);
    voutParts &operator=(const voutParts &);
};

#endif
