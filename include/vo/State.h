#ifndef VO_STATE_H
#define VO_STATE_H

#include <vo/Enums.h>
#include <vo/Error.h>

class voBrickSet;
class voIndexedTetraSet;

/** What a program sets by OpenGL's fixed functions in a compatibility context, for contexts of the core profile that
    have none. One state for each context, the current one; UNSUPPORTED without a context. In a compatibility context
    these values are not used, but for the unit length: there OpenGL's own state counts.

    Matrices are 16 values column by column. Initially: identity matrices, colour (1, 1, 1, 1), no clip planes. */
class VO_API voState
{
public:
    static void setModelMatrix(const GLdouble matrix[16]);
    static void setProjectionMatrix(const GLdouble matrix[16]);
    static void setTextureMatrix(const GLdouble matrix[16]);
    static void getModelMatrix(GLdouble matrix[16]);
    static void getProjectionMatrix(GLdouble matrix[16]);
    static void getTextureMatrix(GLdouble matrix[16]);
    static void setColor(float red, float green, float blue, float alpha);
    /** Clip plane 0 to 7, {A, B, C, D} in eye space; what has Ax + By + Cz + D >= 0 is drawn. Enable
        GL_CLIP_DISTANCE0 + index in OpenGL to use it. */
    static void setClipPlane(int index, const GLdouble plane[4]);

    /** How OpenGL's functions are found in this context; for contexts made neither by GLX, EGL nor OSMesa. Call it
        first, with the context current. NULL goes back to the platform's own. */
    typedef void (*Function)();
    typedef Function (*GetProcAddress)(const char *name);
    static void setGetProcAddress(GetProcAddress getProcAddress);

    /** Opacity per length instead of per slice, so that pictures hardly depend on the sampling period: with a length
        above 0, in the unit of the tetrahedra's positions, the alpha of a fragment (texture, table and colour
        together) is the opacity of that length, and each sample gets 1 - (1 - alpha)^(step / length), step being the
        distance of sampling surfaces along the pixel's own line of sight. 0, the initial value: per slice. drawUtility
        and pick know the step; PRIMITIVE, where it differs by tetrahedron, is then UNSUPPORTED. */
    static void setUnitLength(double length);
    /** Tells the step of face sets that the program polygonized and draws itself, by the arguments that polygonize was
        called with: from now on draw of a face set applies the unit length. Before it is called, after
        resetSampling(), and for what is no sample (cross-sections, the faces of tetrahedra, outlines), alpha counts as
        it is. One for each context. */
    static void setSampling(voIndexedTetraSet *tetraSet, voBrickSet *brickSet, GLdouble modelMatrix[16],
                            GLdouble projMatrix[16], voSamplingMode samplingMode, voSamplingSpace samplingSpace,
                            float samplingPeriod[3], int maxSamplesNumber);
    static void resetSampling();

    /** Who draws the frames of drawUtility in this context; initially AUTOMATIC: who the environment's VO_ENGINE=slices
        or VO_ENGINE=cast names, else CAST where OpenGL runs on the processor and SLICES where it has hardware. SLICES
        and CAST say so for any OpenGL, whatever the environment says. CAST draws slices all the same where the OpenGL
        state that is set, or the volume, would make another picture of it; at debug level 1 the reason is printed. */
    static void setEngine(voEngine engine);
    /** How many frames drawUtility has drawn in this context with SLICES or with CAST; AUTOMATIC: with both. */
    static long getFramesDrawn(voEngine engine);
};

#endif
