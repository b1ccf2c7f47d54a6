#pragma once

#include "voglVolume.h"

/* Cross-sections of a volume, drawn opaque: what voglMPR1 and voglMPR2 share (guide, pages 118-121).

   A section needs no opacity: the table's colours are shown as they are. With 2D textures a polygon between
   two slices is drawn twice, fading out towards either, and the two are added. */

/** What a plane or polygon cuts out of a volume: a face set for each brick. */
class VoglSection
{
public:
    explicit VoglSection(const VoglVolume& volume);
    ~VoglSection();
    VoglSection(const VoglSection&) = delete;
    VoglSection& operator=(const VoglSection&) = delete;

    /** Cuts the volume with the plane A x + B y + C z + D = 0, in voxels; not with 0 0 0. */
    void cut(const float plane[4]);
    /** Cuts it with a planar polygon of C4F_V3F records in voxels. */
    void cut(voVertexData* polygon);
    /** Draws what was cut, added to what is there: black is to be there. */
    void draw();
    /** The same into the depth buffer alone, a little behind, so that draw() with the depth test shows the
       nearest of several sections. */
    void drawDepth();

private:
    void chooseStack(const float normal[3]);
    void drawFaces();

    voBrickSetCollection* bricks_;
    int maxBrickCount_;
    voVertexData* vertices_;
    voIndexedFaceSet*** sets_;
};
