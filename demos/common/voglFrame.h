#pragma once

#include "voglVolume.h"

/* A frame of a volume, step by step: what my_InitGeometry and my_DrawVolume of most vogl demos are made of.
 */

/** The box from `lower` to `upper` as five tetrahedra: one in the middle, four at its corners. */
voIndexedTetraSet* voglBox(const float lower[3], const float upper[3]);
/** The box of the whole volume. */
voIndexedTetraSet* voglBox(const VoglVolume& volume);

/** What the sampling planes cut out of tetrahedra: a face set for each brick and plane. */
class VoglPolygons
{
public:
    VoglPolygons(voIndexedTetraSet* tetraSet, const VoglVolume& volume, voInterleavedArrayType format);
    ~VoglPolygons();
    VoglPolygons(const VoglPolygons&) = delete;
    VoglPolygons& operator=(const VoglPolygons&) = delete;

    /** Slices the tetrahedra anew for the matrices that are set, against the current set of bricks. The time
       is added to polygonizeTimer. */
    void polygonize();
    /** Draws what polygonize left, back to front, each brick with its texture; the times go to uploadTimer
       and drawTimer. For formats with voxel coordinates these are turned into texture coordinates once. */
    void draw();
    /** Draws one plane, if it has polygons: for programs that draw other things between the planes. */
    void drawPlane(int sampleNo);
    /** Makes a brick's texture current, with its texture coordinates: for programs that draw polygons
        themselves. */
    void bind(int brickNo);
    /** Polygons of a brick and a plane; planes from 0, the farthest, to getSamplesNumber() - 1. */
    voIndexedFaceSet* get(int brickNo, int sampleNo) { return sets_[brickNo][sampleNo]; }
    int getSamplesNumber() const { return samplesNumber_; }
    /** A frame by one call of drawUtility, with the engine of the options; state as voglBeginBlending sets
     * it. */
    void drawAtOnce();
    voInterleavedArrayType getFormat() const { return format_; }

private:
    bool isEmpty(int brickNo) const;
    void drawByBricks(const voSortAction& order);

    voIndexedTetraSet* tetraSet_;
    voBrickSetCollection* bricks_;
    voInterleavedArrayType format_;
    int maxBrickCount_, maxSamplesNumber_;
    int samplesNumber_ = 0;
    voVertexData* vertices_ = nullptr;
    voIndexedFaceSet*** sets_ = nullptr;
    voDrawActionCache* cache_ = nullptr; // of drawAtOnce
};

/** The distance of the sampling planes along each axis, in voxels. */
void voglSamplingPeriod(float samplingPeriod[3]);

/** Planes across the view, across an axis for 2D textures, or with -shells shells round the eye. */
voSamplingMode voglSamplingMode(voBrickSetCollection* bricks);

/** With 2D textures: makes the stack current whose slices the viewer sees least obliquely. */
void voglChooseStack(voBrickSetCollection* bricks);

/** Outlines of tetrahedra (yellow) and, with 3D textures, of bricks (blue), if -wireframe asks for them. */
void voglDrawOutlines(voIndexedTetraSet* tetraSet, voBrickSetCollection* bricks,
                      voInterleavedArrayType format);
/** The same with polygons in place of the tetrahedra. */
void voglDrawOutlines(voIndexedFaceSet* faceSet, voBrickSetCollection* bricks, voInterleavedArrayType format);

/** Sets how slices are blended: over what is there, or the maximum with -mip; filled, white, and without
   writing depths. */
void voglBeginBlending();
/** Takes it back. */
void voglEndBlending();

/** Sets what slices are drawn with: textures, texture coordinates (from positions, for formats that have none
   of their own), and blending. */
void voglBeginSlices(voBrickSetCollection* bricks, voInterleavedArrayType format);
/** Takes it back. */
void voglEndSlices(voBrickSetCollection* bricks);

/** All of the above: a whole frame. With -engine the library draws it, else our own loop over slices.
   `outlines`, if any, is outlined instead of the tetrahedra. */
void voglDrawFrame(voIndexedTetraSet* tetraSet, voBrickSetCollection* bricks, VoglPolygons& polygons,
                   voIndexedFaceSet* outlines = nullptr);
/** The part of it that comes after the stack was chosen and outlines were drawn. */
void voglDrawPolygons(voBrickSetCollection* bricks, VoglPolygons& polygons);
