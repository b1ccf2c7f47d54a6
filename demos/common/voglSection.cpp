#include "voglSection.h"

#include "voglMain.h"

#include <algorithm>
#include <cmath>

namespace {

constexpr voInterleavedArrayType kFormat = voInterleavedArrayTypeScope::C4F_V3F;
constexpr int kValues = 7;

bool is2D(voBrickSetCollection* bricks)
{
    return bricks->getInterpolationType() == voInterpolationTypeScope::_2D;
}

void normalOf(voVertexData& polygon, float normal[3])
{
    std::fill_n(normal, 3, 0.0f);
    for (int i = 0; i < polygon.getCount(); i++) {
        const float* a = polygon[i] + 4;
        const float* b = polygon[(i + 1) % polygon.getCount()] + 4;
        for (int axis = 0; axis < 3; axis++) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] += (a[u] - b[u]) * (a[v] + b[v]);
        }
    }
}

} // namespace

VoglSection::VoglSection(const VoglVolume& volume)
    : bricks_(volume.bricks), maxBrickCount_(volume.maxBrickCount)
{
    // A plane leaves a polygon of at most six corners in a brick, a stack's slices take one of them more.
    vertices_ = new voVertexData(1000 + 32 * maxBrickCount_, kValues);
    sets_ = new voIndexedFaceSetPtrPtr[maxBrickCount_];
    for (int brickNo = 0; brickNo < maxBrickCount_; brickNo++) {
        sets_[brickNo] = new voIndexedFaceSetPtr[1];
        sets_[brickNo][0] = new voIndexedFaceSet(vertices_, 0);
    }
}

VoglSection::~VoglSection()
{
    for (int brickNo = 0; brickNo < maxBrickCount_; brickNo++) {
        delete sets_[brickNo][0];
        delete[] sets_[brickNo];
    }
    delete[] sets_;
    delete vertices_;
}

// The stack whose slices the section crosses most steeply needs the fewest of them.
void VoglSection::chooseStack(const float normal[3])
{
    if (!is2D(bricks_)) return;
    static const voPlaneOrientation stacks[3] = {voPlaneOrientationScope::YZ, voPlaneOrientationScope::XZ,
                                                 voPlaneOrientationScope::XY};
    int axis = 2;
    for (int other : {1, 0})
        if (std::abs(normal[other]) > std::abs(normal[axis])) axis = other;
    bricks_->setCurrentBrickSet(stacks[axis]);
}

void VoglSection::cut(const float plane[4])
{
    chooseStack(plane);
    float planeEquation[4];
    std::copy_n(plane, 4, planeEquation);
    polygonizeTimer.start();
    voGeometryActions::polygonizeMPR(planeEquation, bricks_->getCurrentBrickSet(), sets_, kFormat);
    polygonizeTimer.stop();
}

void VoglSection::cut(voVertexData* polygon)
{
    float normal[3];
    normalOf(*polygon, normal);
    chooseStack(normal);
    polygonizeTimer.start();
    voGeometryActions::polygonizeMPR(polygon, bricks_->getCurrentBrickSet(), sets_, kFormat);
    polygonizeTimer.stop();
}

void VoglSection::drawFaces()
{
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    voBrickSet* aBrickSet = bricks_->getCurrentBrickSet();
    for (int brickNo = 0; brickNo < aBrickSet->getBrickCount(); brickNo++) {
        if (sets_[brickNo][0]->getIndices()->getCount() == 0) continue;
        uploadTimer.start();
        voAppearanceActions::texgenSetEquation(aBrickSet->getBrick(brickNo));
        voAppearanceActions::textureBind(aBrickSet->getBrick(brickNo));
        uploadTimer.stop();
        drawTimer.start();
        voGeometryActions::draw(sets_[brickNo][0], kFormat);
        drawTimer.stop();
    }
}

void VoglSection::draw()
{
    voAppearanceActions::textureEnable(bricks_->getInterpolationType());
    voAppearanceActions::texgenEnable();
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    gl->DepthMask(GL_FALSE);
    drawFaces();
    gl->DepthMask(GL_TRUE);
    gl->Disable(GL_BLEND);
    voAppearanceActions::textureDisable(bricks_->getInterpolationType());
    voAppearanceActions::texgenDisable();
}

void VoglSection::drawDepth()
{
    gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl->Enable(GL_POLYGON_OFFSET_FILL);
    // More than the depths of two polygons in one plane differ by rounding, less than anything that shows.
    gl->PolygonOffset(0, 64);
    drawFaces();
    gl->Disable(GL_POLYGON_OFFSET_FILL);
    gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}
