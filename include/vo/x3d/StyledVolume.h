#ifndef VO_X3D_STYLED_VOLUME_H
#define VO_X3D_STYLED_VOLUME_H

#include <vo/Appearance.h>
#include <vo/Geometry.h>
#include <vo/x3d/View.h>

/** A volume of a program, in bricks and tetrahedra, drawn in a style of X3D (docs/x3d.md). Voxels and vertices are copied
    when it is made, and by update(). Everything else is borrowed, and needed as long.

    Matrices are 16 values column by column. Wrong values are voError's BAD_VALUE: then nothing changes, and the answer is
    VO_FALSE. */
class VO_X3D_API voX3DStyledVolume : public voX3DScope
{
public:
    /** `style` is a node of `scene`, any X3DVolumeRenderStyleNode, or the null node: opacity as the voxels have it.
        `bricks`: the current set, of INTENSITY, LUMINANCE, LUMINANCE_ALPHA, RGBA or ABGR_EXT voxels of unsigned bytes,
        unsigned shorts or floats; else UNSUPPORTED. `tetras`: records of `format` (the position is the last three
        values; T3F_V3F and others that begin with T3F have voxel coordinates, V3F has its positions for them); NULL:
        the whole volume, in voxels.

        The opacity of a style is that of the shortest edge of a voxel, in the unit of the positions. */
    voX3DStyledVolume(voX3DScene &scene, const voX3DNode &style, voBrickSetCollection *bricks,
                      voIndexedTetraSet *tetras = NULL,
                      voInterleavedArrayType format = voInterleavedArrayTypeScope::V3F);
    /** With the context current that draw() was called in, if it was and there is no releaseDrawing() since. */
    ~voX3DStyledVolume();

    void setStyle(const voX3DNode &style);
    /** Copies voxels and vertices, which the program has changed, anew. */
    void update();
    /** Whether a light goes with the eye, initially it does; and one that shines along a direction of eye space. */
    void setHeadlight(voBool on);
    void addLight(float x, float y, float z, float intensity);
    /** As voX3DView::setSampling. */
    void setSampling(double edges);

    /** As voX3DView::draw, with a model-view and a projection matrix; width and height are those of the viewport. */
    voBool draw(const GLdouble modelMatrix[16], const GLdouble projMatrix[16], int width, int height,
                voEngine engine = voEngineScope::AUTOMATIC);
    void releaseDrawing();
    /** As voX3DView::picture; nothing lies behind the volume. */
    voBool picture(const GLdouble modelMatrix[16], const GLdouble projMatrix[16], int width, int height,
                   float *rgba, int threads = 0);

private:
    voX3DStyledVolume(const voX3DStyledVolume &);
    voX3DStyledVolume &operator=(const voX3DStyledVolume &);
    struct Private;
    Private *d;
};

#endif
