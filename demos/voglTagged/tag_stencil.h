#pragma once

#include "gl.h"

#include <vo/Volumizer.h>

/// Draws polygons where their voxels have a certain tag, for the sake of the stencil buffer: an alpha test,
/// which contexts of the core profile lack, on the nearest voxel. A program of shaders of its own, over the
/// same polygons and textures, in contexts of both profiles. All functions need the context that it was made
/// in.
class TagStencil
{
public:
    explicit TagStencil(bool twoDimensional);
    ~TagStencil();
    TagStencil(const TagStencil&) = delete;
    TagStencil& operator=(const TagStencil&) = delete;

    /// `faces`, of the format V3F, with the matrices that are set; `tags`, whose texture is bound, has one
    /// channel of 8 bits. The colour that it draws means nothing.
    void draw(voIndexedFaceSet* faces, voBrick* tags, int tag);

private:
    bool twoDimensional_;
    GLuint program_ = 0, vertexArray_ = 0, vertexBuffer_ = 0, indexBuffer_ = 0;
};
