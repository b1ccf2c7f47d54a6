#ifndef VO_LOOKUP_TABLE_H
#define VO_LOOKUP_TABLE_H

#include <vo/Appearance.h>
#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

/** A table of grey and opacity (LUMINANCE8_ALPHA8_EXT) or of colours and opacity (RGBA8_EXT): guide, pages 59-62.

    A voxel of one channel looks up all four components; of several, each component its own. Between entries the value
    is interpolated linearly; entry i of n stands for the value i / (n - 1). Alpha is the opacity of one slice,
    whatever the spacing; colours are not multiplied by it.

    Formats: vo enumerations or the OpenGL constants of the same meaning (GL_LUMINANCE8_ALPHA8, GL_RGBA8;
    GL_LUMINANCE_ALPHA, GL_RGBA; GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT, GL_FLOAT). Others: UNSUPPORTED at load(). The width
    is 2 to 16384 entries, else BAD_VALUE. The
    entries are borrowed and read by load(): they may be filled after construction. */
class VO_API voLookupTable : public voLookupTableShapeScope
{
public:
    /** Switches itself off if it is active. */
    virtual ~voLookupTable();

    /** Takes the entries over; without a current context they go to the GPU at the next draw. For a table applied
        before interpolation all resident volumes become stale. */
    void load();
    /** At most one table of each kind is active in a context; another one is replaced. disable() switches the kind
        off, whichever table was active. Without a current context both are done at the next draw. */
    void enable();
    void disable();
    /** A grey ramp 0 to 1 over [center - width/2, center + width/2] in entry numbers, in all components; it replaces
        the entries, those of the application are not written. A width below 1 counts as 1. */
    void set(voLookupTableShape shape, float center, float width);
    virtual voLookupTableType getType() const = 0;
    /** VO_FALSE where all values from `low` to `high`, of 0 to 1 as textures show them, have an opacity of exactly 0 by
        the entries that load() took. Before load(): BAD_VALUE and VO_TRUE. */
    voBool isVisible(float low, float high) const;

    /** In: the preferred type; out: what will be done, and formats for the table. COLOR gives RGBA8_EXT and RGBA,
        MONOCHROME LUMINANCE8_ALPHA8_EXT and LUMINANCE_ALPHA; FLOAT entries. */
    static int getBestParameters(voBrickSetCollection *volume, voRenderingMode renderingMode, int lookupLength,
                                 voLookupTableType &lookupType, voInternalFormatType &internalFormat,
                                 voExternalFormatType &externalFormat, voDataType &dataType);

protected:
    voLookupTable(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType, void *data = NULL);
    struct Private;
    Private *d;
    friend struct voInside;

private:
    voLookupTable(const voLookupTable &);
    voLookupTable &operator=(const voLookupTable &);
};

/** Classifies voxels when they are downloaded, before interpolation. */
class VO_API voLookupTablePre : public voLookupTable
{
public:
    voLookupTablePre(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType, void *data = NULL);
    virtual ~voLookupTablePre();
    virtual voLookupTableType getType() const;
};

/** Classifies the interpolated sample. */
class VO_API voLookupTablePost : public voLookupTable
{
public:
    voLookupTablePost(GLenum internalFormat, int width, GLenum externalFormat, GLenum dataType, void *data = NULL);
    virtual ~voLookupTablePost();
    virtual voLookupTableType getType() const;
};

typedef voLookupTable voTextureLookup;
typedef voLookupTablePre voTextureLookupPre;
typedef voLookupTablePost voTextureLookupPost;

#endif
