#ifndef VO_X3D_SCENE_H
#define VO_X3D_SCENE_H

#include <vo/Enums.h>
#include <vo/x3d/Node.h>

/** A scene of X3D: nodes that files have or a program makes (docs/x3d.md). Nodes that nothing holds any more stay until
    the scene goes. A scene is for one thread at a time. */
class VO_X3D_API voX3DScene : public voX3DScope
{
public:
    /** An empty scene of X3D 4.0. */
    voX3DScene();
    ~voX3DScene();

    /** Lets the scene's Inline nodes and urls name files in and below a folder, beyond those in and below the folder of
        the scene's own file. Before read(). BAD_VALUE where there is no such folder. */
    void allowFolder(const char *folder);
    /** Replaces the scene by that of a file, in XML or ClassicVRML, compressed by gzip or not, and reads the files of its
        Inline nodes. Nothing is fetched from a network. What is unknown or wrong in it becomes a message and is left
        out. Whether there is a scene; if not, the last message says why. */
    voBool read(const char *path);
    /** The same from memory; `name` stands in messages. Files are looked for in the folders that are allowed. */
    voBool readText(const char *text, size_t bytes, const char *name);
    /** Writes the scene into a file that it replaces; BAD_VALUE where it cannot. Files of Inline nodes are not
        written. */
    voBool write(const char *path, voX3DEncoding encoding = XML) const;

    /** What was unknown or wrong, in the order in which it was found: "scene.x3d:12: warning: ...". At most 1000 are
        kept. */
    int getMessageCount() const;
    const char *getMessage(int index) const;
    /** Whether it is wrong by the standard; otherwise it is not supported here. */
    voBool isError(int index) const;
    voX3DMessageTopic getMessageTopic(int index) const;
    /** The file that it is about, "" for nodes that a program made: then its line begins with "warning: " or
        "error: ". */
    const char *getMessageFile(int index) const;
    int getErrorCount() const;
    int getLeftOutMessageCount() const;
    /** Adds messages on all that a picture would tell of, but for what voxels alone show: what is not drawn, values that
        make no sense, limits. And on what the scene needs and does not have: files that urls name, slice atlases that can be cut,
        components that its profile does not bring. */
    void check();

    const char *getVersion() const;
    const char *getProfile() const;
    /** The edition of the version; single nodes may have another. */
    voX3DEdition getEdition() const;

    /** The nodes below none. */
    int getRootCount() const;
    voX3DNode getRoot(int index) const;
    void setRoots(const voX3DNode *nodes, int count);
    /** The node of a name in the scene's own file, the null node where there is none. */
    voX3DNode find(const char *name) const;

    /** A new node below none, with defaults of the scene's edition, or of the one that has this name. BAD_VALUE where
        none has. */
    voX3DNode createNode(const char *typeName);
    /** Names it, for find() and for files; "" takes the name away. BAD_VALUE for a name that files cannot write or that
        another node has. */
    void setName(const voX3DNode &node, const char *name);

    /** Hands over what a program has read of the file of an ImageTexture3D, so that the first picture of it does not
        read it again: voxels as they stand there, x fastest, then y and z, each of `channels` numbers side by side, of
        which the first `components` count; bytes, shorts, with or without a sign, or floats. They are copied. Other
        views, and pictures after a field of the node changed, read the file. BAD_VALUE for other nodes, types and
        sizes. */
    void setReadVoxels(const voX3DNode &texture, const void *voxels, const int size[3], int channels,
                       int components, voDataType type);

    /** Connections between fields. */
    int getRouteCount() const;
    voX3DNode getRouteSource(int index) const;
    const char *getRouteSourceField(int index) const;
    voX3DNode getRouteTarget(int index) const;
    const char *getRouteTargetField(int index) const;
    /** BAD_VALUE where the fields have different types, or give or take no events. */
    void addRoute(const voX3DNode &source, const char *sourceField, const voX3DNode &target,
                  const char *targetField);

private:
    friend class voX3DNode;
    friend class voX3DView;
    friend class voX3DStyledVolume;
    voX3DScene(const voX3DScene &);
    voX3DScene &operator=(const voX3DScene &);
    voX3DNode handle(void *node) const;
    void *own(const voX3DNode &node) const;
    struct Private;
    Private *d;
};

#endif
