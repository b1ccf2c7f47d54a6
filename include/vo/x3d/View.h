#ifndef VO_X3D_VIEW_H
#define VO_X3D_VIEW_H

#include <vo/Enums.h>
#include <vo/x3d/Scene.h>

/** What lies under a pixel. */
class VO_X3D_API voX3DPick
{
public:
    /** NOTHING; a SURFACE of a Shape or an isosurface; the BOUNDS of a volume; or in a volume the first VOXEL whose
        opacity is above the threshold. */
    enum Kind VO_ANY_INT { NOTHING, SURFACE, BOUNDS, VOXEL };
    voX3DPick();

    Kind kind;
    /** The Shape, or the volume's node. */
    voX3DNode node;
    /** Where, in the world and in the node's coordinates. */
    float world[3];
    float local[3];
    /** Of a volume: the place in its voxels, 0 to 1 along S, T and R; else 0. */
    float textureCoordinate[3];
    /** Out of the surface or the bounds, or along the volume's gradient to lower values; the node's coordinates, unit.
        0 0 0 where there is none. */
    float normal[3];
    /** Of a VOXEL, by its style: that of a unit of length (docs/x3d.md); else 1, and 0 for NOTHING. */
    float opacity;
    /** From the eye along the view; infinite for NOTHING. */
    double depth;
};

/** A scene as it is seen: from where, at which time, and how large (docs/x3d.md). The scene is borrowed; it may be
    changed, and read anew, which takes the viewpoint and the time back to the first. What cannot be drawn becomes a
    message of the scene, once.

    Angles are radians, times seconds, pixels count from the lower left corner, matrices are 16 values column by column.
    Wrong values are voError's BAD_VALUE: then nothing changes, and the answer is VO_FALSE or NULL. */
class VO_X3D_API voX3DView : public voX3DScope
{
public:
    explicit voX3DView(voX3DScene &scene);
    /** With the context current that draw() was called in, if it was and there is no releaseDrawing() since. */
    ~voX3DView();

    /** Of the picture, in pixels; 1 to 32768 each. Initially 512 x 512. */
    void setSize(int width, int height);
    int getWidth() const;
    int getHeight() const;

    /** Viewpoints and OrthoViewpoints in the order of the scene. */
    int getViewpointCount();
    voX3DNode getViewpoint(int index);
    /** Sees the scene from one of them; the null node: from the one that set_bind chose, else the first, else from where
        all of it is seen. Ends setCamera. */
    void setViewpoint(const voX3DNode &viewpoint);
    /** The same by the name that DEF gave, by its description, or by its number from 1. */
    voBool setViewpoint(const char *name);
    /** Sees it from anywhere: a rigid motion from the world to the eye, which looks along -z, and a projection. Lights of
        the head, LOD and OctTree go by this eye. */
    void setCamera(const GLdouble eyeFromWorld[16], const GLdouble projection[16]);
    /** What draw() and picture() would take now. */
    voBool getCamera(GLdouble eyeFromWorld[16], GLdouble projection[16]);
    /** A sphere round all that is drawn, in the world. VO_FALSE where there is nothing. */
    voBool getBounds(double center[3], double &radius);
    /** Whether a light goes with the eye, as far as the scene's NavigationInfo allows it. Initially it does. */
    void setHeadlight(voBool on);

    /** Distance of the planes on which volumes are sampled, in shortest edges of their voxels, 0.01 to 100. 0, as
        initially: 1, and 1/2 where styles go by normals. Half as far apart takes up to twice as long. docs/x3d.md has
        the limits. */
    void setSampling(double edges);

    /** Lets it be that time on the scene's clock, which begins at 0: TimeSensors send their events. */
    void setTime(double seconds);
    double getTime() const;
    /** Whether a TimeSensor runs. */
    voBool isAnimated() const;
    /** When all has been seen that moves by itself: the longest cycleInterval of enabled TimeSensors with loop, or the end
        of a run of one without; 0 where none moves anything. */
    double getCycle();

    /** Draws into the framebuffer of the current context (OpenGL 3.3 or later, with a depth buffer), over what is there,
        its viewport being the whole size; state is given back. What lies behind the depths that are there is hidden, the
        sky behind all of them; the depths of opaque Shapes are added by SLICES alone. CAST reads depths, computes the
        picture and copies it; AUTOMATIC does that where OpenGL runs on the processor, or VO_ENGINE says cast, else SLICES. VO_FALSE with UNSUPPORTED where
        there is no context or it cannot. */
    voBool draw(voEngine engine = voEngineScope::AUTOMATIC);
    /** Lets go of what draw() keeps in the current context; it may then be called in another. */
    void releaseDrawing();
    /** The picture without OpenGL: width * height * 4 floats, red, green, blue (multiplied by alpha) and alpha, rows from
        the bottom. At most `threads` threads compute it; 0: as many as the machine has. */
    voBool picture(float *rgba, int threads = 0);

    /** What is seen first through the middle of a pixel: surfaces, isosurfaces, and of volumes the first sample that has
        after their styles more than the opacity `threshold`; below 0 their bounds count. Of a projection the voxel that
        it shows, of stipples the point of the pixel or the nearest one up to 3 pixels from it. VO_FALSE where there is
        nothing. */
    voBool pick(int x, int y, float threshold, voX3DPick &hit);
    /** The same for TouchSensors, as a pointing device does it: moved to a pixel (isOver, hitPoint_changed ...), pressed
        (isActive), let go (touchTime). Events have the time of setTime. Whether a sensor is under it. */
    voBool movePointer(int x, int y, float threshold = -1);
    void pressPointer();
    void releasePointer();

    /** Lets an event arrive at a field, as a route does: numbers of any type but strings and nodes. */
    void send(const voX3DNode &node, const char *field, const double *values, int numbers);

private:
    voX3DView(const voX3DView &);
    voX3DView &operator=(const voX3DView &);
    struct Private;
    Private *d;
};

#endif
