#ifndef VO_X3D_NODE_H
#define VO_X3D_NODE_H

#include <vo/Api.h>

#if defined(_WIN32)
#if defined(VO_X3D_BUILDING)
#define VO_X3D_API __declspec(dllexport)
#else
#define VO_X3D_API __declspec(dllimport)
#endif
#else
#define VO_X3D_API VO_API
#endif

/** Enumerations of scenes. */
class voX3DScope
{
public:
    /** Types of fields, as in the standard. */
    enum voX3DFieldType VO_ANY_INT {
        SF_BOOL,
        MF_BOOL,
        SF_INT32,
        MF_INT32,
        SF_FLOAT,
        MF_FLOAT,
        SF_DOUBLE,
        MF_DOUBLE,
        SF_TIME,
        MF_TIME,
        SF_STRING,
        MF_STRING,
        SF_VEC2F,
        MF_VEC2F,
        SF_VEC3F,
        MF_VEC3F,
        SF_VEC4F,
        MF_VEC4F,
        SF_ROTATION,
        MF_ROTATION,
        SF_COLOR,
        MF_COLOR,
        SF_COLOR_RGBA,
        MF_COLOR_RGBA,
        SF_IMAGE,
        SF_NODE,
        MF_NODE
    };
    /** Who may use a field: a file, events that come in, events that go out, or all of them. */
    enum voX3DAccess VO_ANY_INT { INITIALIZE_ONLY, INPUT_ONLY, OUTPUT_ONLY, INPUT_OUTPUT };
    /** Whose nodes, fields and defaults hold: the volume rendering proposal of 2005 (in files of X3D 3.0 to 3.2), or
        those of X3D 3.3 or 4.0. */
    enum voX3DEdition VO_ANY_INT { PROPOSAL_2005, X3D_33, X3D_40 };
    /** How scenes are written. */
    enum voX3DEncoding VO_ANY_INT { XML, CLASSIC_VRML };
    /** What a message tells of: that no voxel can be seen of a volume or of a surface, whatever the view is; anything
        else. */
    enum voX3DMessageTopic VO_ANY_INT { NOTHING_SEEN, ANYTHING_ELSE };
};

class voX3DScene;

/** A node of a scene, as a small value that may be copied. The node itself belongs to its scene and lives as long as
    that. Fields go by their names, in the edition of the node. What is wrong (no such field, another type, an index
    outside, the null node) is voError's BAD_VALUE: then nothing is written and the answer is 0, NULL or the null node.

    Pointers that are returned are valid until the field is set, and strings until the node's name is. */
class VO_X3D_API voX3DNode : public voX3DScope
{
public:
    /** The null node, which SFNode fields hold that hold none. */
    voX3DNode();
    voBool isNull() const;
    bool operator==(const voX3DNode &other) const;
    bool operator!=(const voX3DNode &other) const;

    /** "VolumeData"; where editions differ, the name in the node's. */
    const char *getTypeName() const;
    /** Whether it is a node of this type or of one derived from it: "X3DVolumeRenderStyleNode". The names of all editions
        mean the same type. */
    voBool isType(const char *name) const;
    voX3DEdition getEdition() const;
    /** The name that DEF gave, "" without one. */
    const char *getName() const;
    /** Where it stands; "" and 0 where no file has it. */
    const char *getFile() const;
    int getLine() const;

    /** The fields of the node's edition, in no order that counts. */
    int getFieldCount() const;
    const char *getFieldName(int index) const;
    voBool hasField(const char *field) const;
    voX3DFieldType getFieldType(const char *field) const;
    voX3DAccess getFieldAccess(const char *field) const;
    /** Whether a file or a caller gave the value, which is the default otherwise. */
    voBool isSet(const char *field) const;

    /** Elements of a value: 1 in SF fields other than SF_NODE, which has 0 where it is NULL; vectors, not their numbers,
        in MF fields. Of SF_IMAGE: its numbers. */
    int getCount(const char *field) const;
    /** The numbers of a value, element after element: bool (0 or 1), int32 and image; float, vectors, rotation and
        colours; double and time. NULL where the value has none. */
    const int *getInts(const char *field) const;
    const float *getFloats(const char *field) const;
    const double *getDoubles(const char *field) const;
    const char *getString(const char *field, int index = 0) const;
    /** The null node where the field is NULL. */
    voX3DNode getNode(const char *field, int index = 0) const;

    /** Set a field of any access but OUTPUT_ONLY and INPUT_ONLY. `numbers` counts numbers, not vectors. Beyond what all
        calls answer, BAD_VALUE is a number that the standard does not allow there, a word that is none of its choices,
        an image whose sizes are not those of its pixels, a node that may not stand there, is of another scene, or would
        stand below itself. All of it is copied. */
    void setInts(const char *field, const int *values, int numbers);
    void setFloats(const char *field, const float *values, int numbers);
    void setDoubles(const char *field, const double *values, int numbers);
    void setStrings(const char *field, const char *const *values, int count);
    void setNodes(const char *field, const voX3DNode *nodes, int count);
    /** For one. */
    void setInt(const char *field, int value);
    void setFloat(const char *field, float value);
    void setDouble(const char *field, double value);
    void setString(const char *field, const char *value);
    /** The null node makes the field NULL. */
    void setNode(const char *field, const voX3DNode &node);
    /** Back to the default. */
    void reset(const char *field);

    /** Of an Inline: the nodes of its file, if that was read. */
    int getInlinedCount() const;
    voX3DNode getInlined(int index) const;
    /** The file that the url of this index names, with links resolved, in the folders that the scene may read; NULL, with
        voError's text that says why, where there is none. */
    const char *getPath(const char *field, int index = 0) const;

private:
    friend class voX3DScene;
    friend class voX3DView;
    friend class voX3DStyledVolume;
    voX3DNode(voX3DScene *scene, void *node);
    voX3DScene *scene_;
    void *node_;
};

#endif
