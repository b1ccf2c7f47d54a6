#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/face_sets.h"
#include "legacy/report.h"

#include "polygonize/clip_polygon.h"
#include "polygonize/projected_area.h"
#include "polygonize/slice_tetra.h"
#include "sort/brick_order.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

using vo::badValue;
using vo::cameraOf;
using vo::guarded;
using vo::required;

namespace vo {

Camera cameraOf(const GLdouble* model, const GLdouble* projection)
{
    if (!model || !projection) badValue("a matrix is NULL");
    const std::optional<Camera> camera = findCamera(glm::make_mat4(model), glm::make_mat4(projection));
    if (!camera) badValue("the matrices are singular");
    return *camera;
}

SamplingRequest samplingRequest(int mode, int space, const float* period, int maxSamples,
                                voPlaneOrientation orientation)
{
    SamplingRequest request;
    request.mode = vo::samplingMode(mode);
    request.space = vo::samplingSpace(space);
    if (maxSamples < 1) badValue("at most " + std::to_string(maxSamples) + " samples, 1 or more are needed");
    request.maxSamples = maxSamples;
    request.stackAxis = thinAxis(orientation);
    if (!period) return request;
    for (int axis = 0; axis < 3; ++axis)
        if (!(period[axis] > 0) || !std::isfinite(period[axis]))
            badValue("samplingPeriod[" + std::to_string(axis) + "] is " + std::to_string(period[axis]) +
                     ", more than 0 is needed");
    request.period = glm::dvec3(period[0], period[1], period[2]);
    return request;
}

voPlaneOrientation stackAcross(int axis)
{
    return axis == 0   ? voPlaneOrientationScope::YZ
           : axis == 1 ? voPlaneOrientationScope::XZ
                       : voPlaneOrientationScope::XY;
}

} // namespace vo

namespace {

vo::PolygonizeWorkspace& workspace()
{
    thread_local vo::PolygonizeWorkspace instance;
    return instance;
}

void checkFormat(const voVertexData& polygon, int format)
{
    const int values = polygon.getValuesPerVertex();
    const int needed = vo::recordLayout(format, values).values;
    if (needed > values)
        badValue("the vertex format has " + std::to_string(needed) + " values a record, the polygon " +
                 std::to_string(values));
}

} // namespace

int voGeometryActions::polygonize(voIndexedTetraSet* tetraSet, voBrickSet* brickSet,
                                  voInterleavedArrayType format, GLdouble modelMatrix[16],
                                  GLdouble projMatrix[16], voSamplingMode samplingMode,
                                  voSamplingSpace samplingSpace, float samplingPeriod[3],
                                  int maxSamplesNumber, int& samplesNumber, voIndexedFaceSet*** polygonSet)
{
    samplesNumber = 0;
    return guarded("voGeometryActions::polygonize", [&] {
        vo::TetraView tetras = vo::tetraView(required(tetraSet, "tetraSet"));
        tetras.voxelColumn = vo::voxelColumn(format, tetras.valuesPerVertex);
        const voBrickSet& set = required(brickSet, "brickSet");
        const vo::SamplingRequest sampling = vo::samplingRequest(samplingMode, samplingSpace, samplingPeriod,
                                                                 maxSamplesNumber, set.getOrientation());
        const vo::Camera camera = cameraOf(modelMatrix, projMatrix);
        vo::resetFaceSets(polygonSet, set.getBrickCount(), maxSamplesNumber, tetras.valuesPerVertex);
        thread_local std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        vo::FaceSetSink sink(polygonSet, tetras.valuesPerVertex);
        const vo::PolygonizeResult result =
            vo::polygonize(tetras, boxes, camera, sampling, workspace(), sink);
        samplesNumber = result.samples;
        if (!result.complete)
            throw vo::CallerError{voErrorTypeScope::OUT_OF_MEMORY,
                                  "the vertex data that the face sets share is full; the rest is missing"};
    });
}

int voGeometryActions::polygonize(voIndexedTetraSet* tetraSet, voBrickSet* brickSet, GLdouble modelMatrix[16],
                                  GLdouble projMatrix[16], voSamplingMode samplingMode,
                                  voSamplingSpace samplingSpace, int& samplesNumber, float samplingPeriod[3],
                                  voIndexedFaceSet*** polygonSet)
{
    const int maxSamples = samplesNumber;
    return polygonize(tetraSet, brickSet, voInterleavedArrayTypeScope::DEFAULT, modelMatrix, projMatrix,
                      samplingMode, samplingSpace, samplingPeriod, maxSamples, samplesNumber, polygonSet);
}

int voGeometryActions::sample(float tetraVerts[4][3], float planeEquation[4], voVertexData* polygonVerts)
{
    return guarded("voGeometryActions::sample", [&] {
        voVertexData& polygon = required(polygonVerts, "polygonVerts");
        if (!tetraVerts || !planeEquation) badValue("tetraVerts or planeEquation is NULL");
        const int values = polygon.getValuesPerVertex();
        if (values < 3 || polygon.getCountMax() < 4)
            badValue("polygonVerts needs room for 4 records of 3 or more values");
        double vertices[4][3], distances[4];
        const double* records[4];
        for (int i = 0; i < 4; ++i) {
            distances[i] = planeEquation[3];
            for (int axis = 0; axis < 3; ++axis) {
                vertices[i][axis] = tetraVerts[i][axis];
                distances[i] += static_cast<double>(planeEquation[axis]) * vertices[i][axis];
            }
            records[i] = vertices[i];
        }
        vo::CutPolygon cut;
        vo::sliceTetra(records, distances, 3, cut);
        polygon.empty();
        for (int i = 0; i < cut.count; ++i) {
            float* record = polygon[i];
            for (int axis = 0; axis < 3; ++axis)
                record[values - 3 + axis] = static_cast<float>(cut.record(i)[axis]);
        }
        polygon.setCount(cut.count);
    });
}

int voGeometryActions::clip(voVertexData* polygon, voInterleavedArrayType format, float lowerLeft[3],
                            float upperRight[3], voIndexedFaceSet* faceSet)
{
    return guarded("voGeometryActions::clip", [&] {
        checkFormat(required(polygon, "polygon"), format);
        voIndexedFaceSet& faces = required(faceSet, "faceSet");
        if (!lowerLeft || !upperRight) badValue("lowerLeft or upperRight is NULL");
        const vo::Box box{glm::make_vec3(lowerLeft), glm::make_vec3(upperRight)};
        vo::CutPolygon scratch, out;
        vo::clipToBox(vo::cutPolygon(*polygon), box, scratch, out);
        vo::appendCut(out, faces);
    });
}

int voGeometryActions::clip(voVertexData* polygon, float lowerLeft[3], float upperRight[3],
                            voIndexedFaceSet* faceSet)
{
    return clip(polygon, voInterleavedArrayTypeScope::DEFAULT, lowerLeft, upperRight, faceSet);
}

int voGeometryActions::clip(voVertexData* polygon, voInterleavedArrayType format, float* planes,
                            int planeCount, voIndexedFaceSet* faceSet)
{
    return guarded("voGeometryActions::clip", [&] {
        checkFormat(required(polygon, "polygon"), format);
        voIndexedFaceSet& faces = required(faceSet, "faceSet");
        if (planeCount < 0 || (planeCount > 0 && !planes)) badValue("planes is NULL or planeCount negative");
        vo::CutPolygon cut = vo::cutPolygon(*polygon), out;
        for (int i = 0; i < planeCount && cut.count >= 3; ++i) {
            vo::clipToHalfSpace(cut, glm::dvec4(glm::make_vec4(planes + 4 * i)), out);
            std::swap(cut, out);
        }
        vo::appendCut(cut, faces);
    });
}

voPlaneOrientation voGeometryActions::findClosestAxisIndex(GLdouble modelMatrix[16], GLdouble projMatrix[16],
                                                           int samplingMode)
{
    voPlaneOrientation orientation = voPlaneOrientationScope::UNSPECIFIED;
    guarded("voGeometryActions::findClosestAxisIndex", [&] {
        if (samplingMode < -1 || samplingMode > voSamplingModeScope::SPHERICAL)
            vo::badEnum("voSamplingMode has no value " + std::to_string(samplingMode));
        if (samplingMode != voSamplingModeScope::AXIS_ALIGNED) return;
        orientation = vo::stackAcross(vo::closestAxis(cameraOf(modelMatrix, projMatrix)));
    });
    return orientation;
}

void voGeometryActions::findCameraPosition(double eyePos[3], double viewDir[4], GLdouble modelMatrix[16],
                                           GLdouble projMatrix[16])
{
    guarded("voGeometryActions::findCameraPosition", [&] {
        const vo::Camera camera = cameraOf(modelMatrix, projMatrix);
        for (int axis = 0; axis < 3; ++axis) {
            if (viewDir) viewDir[axis] = camera.direction[axis];
            if (eyePos && camera.perspective) eyePos[axis] = camera.eye[axis];
        }
        if (viewDir) viewDir[3] = camera.perspective ? 1.0 : 0.0;
    });
}

void voGeometryActions::findViewDirection(double viewDir[3], GLdouble modelMatrix[16],
                                          GLdouble projMatrix[16])
{
    const int failed = guarded("voGeometryActions::findViewDirection", [&] {
        if (!viewDir) badValue("viewDir is NULL");
        const vo::Camera camera = cameraOf(modelMatrix, projMatrix);
        for (int axis = 0; axis < 3; ++axis)
            viewDir[axis] = camera.direction[axis];
    });
    if (!failed || !viewDir) return;
    viewDir[0] = viewDir[1] = 0.0;
    viewDir[2] = 1.0;
}

float voGeometryActions::findProjectedArea(voIndexedFaceSet* faceSet, GLdouble modelMatrix[16],
                                           GLdouble projMatrix[16], GLint viewport[4])
{
    double pixels = 0.0;
    guarded("voGeometryActions::findProjectedArea", [&] {
        voIndexedFaceSet& faces = required(faceSet, "faceSet");
        cameraOf(modelMatrix, projMatrix);
        if (!viewport) badValue("viewport is NULL");
        if (viewport[2] < 0 || viewport[3] < 0)
            badValue("a viewport of " + std::to_string(viewport[2]) + " x " + std::to_string(viewport[3]) +
                     " pixels");
        const int values = faces.getVertexData()->getValuesPerVertex();
        if (values < 3) badValue("records of " + std::to_string(values) + " values have no position");
        const glm::dmat4 toClip = glm::make_mat4(projMatrix) * glm::make_mat4(modelMatrix);
        const double perUnit = 0.25 * viewport[2] * viewport[3];
        std::vector<glm::dvec3> polygon;
        double area = 0.0;
        for (voIndexedFaceSetIterator next(&faces); !next.doneP(); next.nextPrimitive()) {
            polygon.clear();
            while (const float* record = next.nextVertex())
                polygon.push_back(glm::make_vec3(record + values - 3));
            area += vo::projectedArea(polygon, toClip);
        }
        pixels = area * perUnit;
    });
    return static_cast<float>(pixels);
}

struct voSortAction::Private
{
    std::vector<int> order;
};

voSortAction::voSortAction(voBrickSet* brickSet, GLdouble modelMatrix[16], GLdouble projMatrix[16])
    : d(new Private)
{
    guarded("voSortAction", [&] {
        const voBrickSet& set = required(brickSet, "brickSet");
        for (int i = 0; i < set.getBrickCount(); ++i)
            d->order.push_back(i);
        std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        d->order = vo::backToFront(boxes, cameraOf(modelMatrix, projMatrix));
    });
}

voSortAction::~voSortAction()
{
    delete d;
}

int voSortAction::operator[](int brickNo) const
{
    int brick = 0;
    guarded("voSortAction", [&] {
        if (brickNo < 0 || static_cast<std::size_t>(brickNo) >= d->order.size())
            badValue("number " + std::to_string(brickNo) + " is outside 0 to " +
                     std::to_string(static_cast<long long>(d->order.size()) - 1));
        brick = d->order[static_cast<std::size_t>(brickNo)];
    });
    return brick;
}

voCache::voCache() = default;
voCache::~voCache() = default;

voDrawActionCache::voDrawActionCache(voIndexedTetraSet*, voBrickSetCollection*, int maxSamplesNumber,
                                     voSamplingMode samplingMode, int, int)
    : d(new Private)
{
    guarded("voDrawActionCache", [&] {
        vo::samplingMode(samplingMode);
        d->samplingMode = samplingMode;
        if (maxSamplesNumber < 1)
            badValue("at most " + std::to_string(maxSamplesNumber) + " samples, 1 or more are needed");
        d->maxSamples = std::min(maxSamplesNumber, vo::kMostFrameSamples);
    });
}

voDrawActionCache::~voDrawActionCache()
{
    delete d;
}

void voDrawActionCache::setThreshold(double degrees)
{
    guarded("voDrawActionCache::setThreshold", [&] {
        if (!(degrees >= 0))
            badValue("the threshold is " + std::to_string(degrees) + ", 0 or more degrees are needed");
        d->threshold = degrees;
    });
}

void voDrawActionCache::invalidate()
{
    d->frames.invalidate();
}

voPlaneOrientation findClosestAxisIndex(GLdouble modelMatrix[16], GLdouble projMatrix[16], int samplingMode)
{
    return voGeometryActions::findClosestAxisIndex(modelMatrix, projMatrix, samplingMode);
}

int sample(float tetraVerts[4][3], float planeEquation[4], voVertexData* polygonVerts)
{
    return voGeometryActions::sample(tetraVerts, planeEquation, polygonVerts);
}

int clip(voVertexData* polygon, float lowerLeft[3], float upperRight[3], voIndexedFaceSet* faceSet)
{
    return voGeometryActions::clip(polygon, lowerLeft, upperRight, faceSet);
}
