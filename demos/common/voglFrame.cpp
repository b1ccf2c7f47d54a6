#include "voglFrame.h"

#include "voglMain.h"

#include <algorithm>
#include <cmath>

namespace {

bool is2D(voBrickSetCollection* bricks)
{
    return bricks->getInterpolationType() == voInterpolationTypeScope::_2D;
}

// The longest edge of a tetrahedron, as the sampling planes of any view may cross it.
double longestEdge(voIndexedTetraSet* tetraSet, int tetra)
{
    voVertexData& vertices = *tetraSet->getVertexData();
    voIndices& indices = *tetraSet->getIndices();
    const int values = vertices.getValuesPerVertex();
    double longest = 0;
    for (int a = 0; a < VO_TETRA_VERTICES; a++)
        for (int b = 0; b < a; b++) {
            const float* from = vertices[indices[VO_TETRA_VERTICES * tetra + a]] + values - 3;
            const float* to = vertices[indices[VO_TETRA_VERTICES * tetra + b]] + values - 3;
            double length = 0;
            for (int i = 0; i < 3; i++)
                length = std::hypot(length, double(modelScale[i]) * (double(to[i]) - double(from[i])));
            longest = std::max(longest, length);
        }
    return longest;
}

// Vertices of all polygons of a frame, for any view. A polygon seldom has more than six; a plane crosses at
// most 3 n^2 - 3 n + 1 bricks of a lattice of n x n x n, and cuts what it finds in each into as many
// polygons.
int boundVertices(voIndexedTetraSet* tetraSet, int maxBrickCount, int maxSamplesNumber)
{
    double polygons = 0;
    const int tetraCount = tetraSet->getIndices()->getCount() / VO_TETRA_VERTICES;
    for (int tetra = 0; tetra < tetraCount; tetra++)
        polygons += std::min(longestEdge(tetraSet, tetra) / options.sampling + 2, maxSamplesNumber + 1.0);
    const double n = std::ceil(std::cbrt(maxBrickCount));
    const double crossed = std::min(3 * n * n - 3 * n + 1, double(maxBrickCount));
    if (maxBrickCount > 1) polygons += 5 * crossed * maxSamplesNumber;
    return int(std::min(100000 + 6 * polygons, 5e7));
}

} // namespace

voIndexedTetraSet* voglBox(const float lower[3], const float upper[3])
{
    static const int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                      {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    static const int cubeIndices[] = {
        0, 2, 5, 7, // the middle
        3, 2, 0, 7, //
        1, 2, 5, 0, //
        2, 7, 6, 5, //
        5, 4, 0, 7, //
    };
    const int indexCount = sizeof(cubeIndices) / sizeof(cubeIndices[0]);
    voIndexedTetraSet* tetraSet = new voIndexedTetraSet(8, 3, indexCount);
    for (int vertex = 0; vertex < 8; vertex++)
        for (int i = 0; i < 3; i++)
            (*tetraSet->getVertexData())[vertex][i] = corners[vertex][i] ? upper[i] : lower[i];
    for (int index = 0; index < indexCount; index++)
        (*tetraSet->getIndices())[index] = cubeIndices[index];
    tetraSet->getVertexData()->setCount(8);
    tetraSet->getIndices()->setCount(indexCount);
    return tetraSet;
}

voIndexedTetraSet* voglBox(const VoglVolume& volume)
{
    const float lower[3] = {0, 0, 0};
    const float upper[3] = {float(volume.size[0]), float(volume.size[1]), float(volume.size[2])};
    return voglBox(lower, upper);
}

VoglPolygons::VoglPolygons(voIndexedTetraSet* tetraSet, const VoglVolume& volume,
                           voInterleavedArrayType format)
    : tetraSet_(tetraSet), bricks_(volume.bricks), format_(format), maxBrickCount_(volume.maxBrickCount),
      maxSamplesNumber_(volume.maxSamplesNumber)
{
    const int values = tetraSet->getVertexData()->getValuesPerVertex();
    // Shells have as many facets as it takes to be round: there each set has vertices of its own, that grow.
    if (!options.shells)
        vertices_ = new voVertexData(boundVertices(tetraSet, maxBrickCount_, maxSamplesNumber_), values);
    sets_ = new voIndexedFaceSetPtrPtr[maxBrickCount_];
    for (int j1 = 0; j1 < maxBrickCount_; j1++) {
        sets_[j1] = new voIndexedFaceSetPtr[maxSamplesNumber_];
        for (int j2 = 0; j2 < maxSamplesNumber_; j2++)
            sets_[j1][j2] = vertices_ ? new voIndexedFaceSet(vertices_, 0) // indices grow on demand
                                      : new voIndexedFaceSet(0, values, 0);
    }
}

VoglPolygons::~VoglPolygons()
{
    for (int j1 = 0; j1 < maxBrickCount_; j1++) {
        for (int j2 = 0; j2 < maxSamplesNumber_; j2++)
            delete sets_[j1][j2];
        delete[] sets_[j1];
    }
    delete[] sets_;
    delete vertices_;
    delete cache_;
}

void VoglPolygons::polygonize()
{
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    float samplingPeriod[3];
    voglSamplingPeriod(samplingPeriod);
    polygonizeTimer.start();
    voGeometryActions::polygonize(
        tetraSet_, bricks_->getCurrentBrickSet(), format_, modelMatrix, projMatrix, voglSamplingMode(bricks_),
        options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME : voSamplingSpaceScope::OBJECT, samplingPeriod,
        maxSamplesNumber_, samplesNumber_, sets_);
    if (hasTextureComponent(format_))
        voAppearanceActions::xfmVox2TexCoords(bricks_->getCurrentBrickSet(), samplesNumber_, sets_, format_);
    polygonizeTimer.stop();
}

void VoglPolygons::bind(int brickNo)
{
    voBrick* aBrick = bricks_->getCurrentBrickSet()->getBrick(brickNo);
    uploadTimer.start();
    if (!hasTextureComponent(format_)) voAppearanceActions::texgenSetEquation(aBrick);
    voAppearanceActions::textureBind(aBrick);
    uploadTimer.stop();
}

bool VoglPolygons::isEmpty(int brickNo) const
{
    for (int binNo = 0; binNo < samplesNumber_; binNo++)
        if (sets_[brickNo][binNo]->getIndices()->getCount() > 0) return false;
    return true;
}

void VoglPolygons::drawByBricks(const voSortAction& order)
{
    for (int brickNo = 0; brickNo < bricks_->getCurrentBrickSet()->getBrickCount(); brickNo++) {
        const int brickSortedNo = order[brickNo];
        if (isEmpty(brickSortedNo)) continue;
        bind(brickSortedNo);
        drawTimer.start();
        for (int binNo = 0; binNo < samplesNumber_; binNo++)
            voGeometryActions::draw(sets_[brickSortedNo][binNo], format_);
        drawTimer.stop();
    }
}

void VoglPolygons::drawPlane(int sampleNo)
{
    for (int brickNo = 0; brickNo < bricks_->getCurrentBrickSet()->getBrickCount(); brickNo++) {
        if (sets_[brickNo][sampleNo]->getIndices()->getCount() == 0) continue;
        bind(brickNo);
        drawTimer.start();
        voGeometryActions::draw(sets_[brickNo][sampleNo], format_);
        drawTimer.stop();
    }
}

void VoglPolygons::draw()
{
    voBrickSet* aBrickSet = bricks_->getCurrentBrickSet();
    if (hasTextureComponent(format_) && aBrickSet->getBrickCount() > 1) {
        // Bricks of a deformed volume are no boxes in space, and have no order; planes always do.
        for (int binNo = 0; binNo < samplesNumber_; binNo++)
            drawPlane(binNo);
        return;
    }
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    polygonizeTimer.start();
    const voSortAction aSortAction(aBrickSet, modelMatrix, projMatrix);
    polygonizeTimer.stop();
    drawByBricks(aSortAction);
}

void VoglPolygons::drawAtOnce()
{
    if (!cache_)
        cache_ = new voDrawActionCache(tetraSet_, bricks_, maxSamplesNumber_, voglSamplingMode(bricks_),
                                       tetraSet_->getVertexData()->getValuesPerVertex(), 0);
    voState::setEngine(options.engine == vo::Options::Engine::Cast ? voEngineScope::CAST
                                                                   : voEngineScope::SLICES);
    float samplingPeriod[3];
    voglSamplingPeriod(samplingPeriod);
    drawTimer.start();
    voGeometryActions::drawUtility(tetraSet_, format_, bricks_, cache_,
                                   options.viewSpace ? voSamplingSpaceScope::VIEW_VOLUME
                                                     : voSamplingSpaceScope::OBJECT,
                                   samplingPeriod, voDecorationFlagsScope::NONE);
    drawTimer.stop();
}

void voglSamplingPeriod(float samplingPeriod[3])
{
    for (int i = 0; i < 3; i++)
        samplingPeriod[i] = float(options.sampling) / modelScale[i];
}

voSamplingMode voglSamplingMode(voBrickSetCollection* bricks)
{
    if (is2D(bricks)) return voSamplingModeScope::AXIS_ALIGNED;
    return options.shells ? voSamplingModeScope::SPHERICAL : voSamplingModeScope::VIEWPORT_ALIGNED;
}

void voglChooseStack(voBrickSetCollection* bricks)
{
    if (!is2D(bricks)) return;
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    bricks->setCurrentBrickSet(
        voGeometryActions::findClosestAxisIndex(modelMatrix, projMatrix, voSamplingModeScope::AXIS_ALIGNED));
}

template <class GeometrySet>
static void drawOutlines(GeometrySet* set, voBrickSetCollection* bricks, voInterleavedArrayType format)
{
    if (!options.wireframe) return;
    voAppearanceActions::textureDisable(bricks->getInterpolationType());
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(set, GL_LINE, format);
    if (is2D(bricks)) return;
    vo::setColor(0, 0, 1, 1);
    voGeometryActions::draw(bricks->getCurrentBrickSet());
}

void voglDrawOutlines(voIndexedTetraSet* tetraSet, voBrickSetCollection* bricks,
                      voInterleavedArrayType format)
{
    drawOutlines(tetraSet, bricks, format);
}

void voglDrawOutlines(voIndexedFaceSet* faceSet, voBrickSetCollection* bricks, voInterleavedArrayType format)
{
    drawOutlines(faceSet, bricks, format);
}

void voglBeginBlending()
{
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->BlendEquation(options.mip ? GL_MAX : GL_FUNC_ADD);
    gl->PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    gl->DepthMask(GL_FALSE);
    vo::setColor(1, 1, 1, 1);
}

void voglEndBlending()
{
    gl->Disable(GL_BLEND);
    gl->DepthMask(GL_TRUE);
    gl->BlendEquation(GL_FUNC_ADD);
}

void voglBeginSlices(voBrickSetCollection* bricks, voInterleavedArrayType format)
{
    voAppearanceActions::textureEnable(bricks->getInterpolationType());
    if (!hasTextureComponent(format)) voAppearanceActions::texgenEnable();
    voglBeginBlending();
}

void voglEndSlices(voBrickSetCollection* bricks)
{
    voAppearanceActions::textureDisable(bricks->getInterpolationType());
    voAppearanceActions::texgenDisable();
    voglEndBlending();
}

void voglDrawFrame(voIndexedTetraSet* tetraSet, voBrickSetCollection* bricks, VoglPolygons& polygons,
                   voIndexedFaceSet* outlines)
{
    voglChooseStack(bricks);
    if (outlines)
        voglDrawOutlines(outlines, bricks, polygons.getFormat());
    else
        voglDrawOutlines(tetraSet, bricks, polygons.getFormat());
    voglDrawPolygons(bricks, polygons);
}

void voglDrawPolygons(voBrickSetCollection* bricks, VoglPolygons& polygons)
{
    if (options.engine) {
        voglBeginBlending();
        polygons.drawAtOnce();
        voglEndBlending();
        return;
    }
    polygons.polygonize();
    voglBeginSlices(bricks, polygons.getFormat());
    polygons.draw();
    voglEndSlices(bricks);
}
