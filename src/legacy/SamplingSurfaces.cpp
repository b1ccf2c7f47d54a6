#include "legacy/inside.h"

#include "legacy/face_sets.h"
#include "legacy/report.h"

#include "polygonize/clip_polygon.h"
#include "polygonize/polygonize.h"
#include "polygonize/reformat.h"

#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <typeinfo>

using vo::badValue;
using vo::guarded;
using vo::required;

struct voSamplingPlaneSet::Private
{
    vo::PlaneFamily planes;
};

namespace {

/// The surfaces of an application.
class CallerSurfaces final : public vo::FacetSource
{
public:
    explicit CallerSurfaces(voSamplingSurfaceSet& surfaces) : surfaces_(surfaces), faces_(0, 3, 0) {}

    void facetsOf(int surface, const vo::Box& box, vo::FacetList& facets) override
    {
        faces_.empty();
        float lower[3], upper[3];
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] = static_cast<float>(box.lower[axis]);
            upper[axis] = static_cast<float>(box.upper[axis]);
        }
        surfaces_.getSurface(surface, lower, upper, &faces_);
        for (voIndexedFaceSetIterator next(&faces_); !next.doneP(); next.nextPrimitive()) {
            int count = 0;
            for (const float* p; (p = next.nextVertex()); ++count)
                facets.corners.emplace_back(p[0], p[1], p[2]);
            if (count >= 3)
                facets.counts.push_back(count);
            else
                facets.corners.resize(facets.corners.size() - static_cast<std::size_t>(count));
        }
    }

private:
    voSamplingSurfaceSet& surfaces_;
    voIndexedFaceSet faces_;
};

/// Surface `k` as the equation whose positive side is the viewer's.
glm::dvec4 equationOf(const vo::PlaneFamily& planes, int k)
{
    return glm::dvec4(-planes.normal, planes.offset(k)) / glm::length(planes.normal);
}

vo::PlaneFamily planesFrom(const float* equation, float spacing, int count)
{
    if (!equation) badValue("planeEquation is NULL");
    const glm::dvec4 plane(glm::make_vec4(equation));
    const double length = glm::length(glm::dvec3(plane));
    if (!(length > 0.0) || !std::isfinite(length + plane.w))
        badValue("planeEquation has no direction, or is not finite");
    if (!(spacing > 0.0f) || !std::isfinite(spacing))
        badValue("the spacing is " + std::to_string(spacing) + ", more than 0 is needed");
    if (count < 0) badValue(std::to_string(count) + " planes");
    return {-glm::dvec3(plane) / length, plane.w / length, static_cast<double>(spacing), count};
}

} // namespace

voSamplingSurfaceSet::voSamplingSurfaceSet() = default;
voSamplingSurfaceSet::~voSamplingSurfaceSet() = default;

voSamplingPlaneSet::voSamplingPlaneSet(float planeEquation[4], float spacing, int count) : d(new Private)
{
    guarded("voSamplingPlaneSet", [&] { d->planes = planesFrom(planeEquation, spacing, count); });
}

voSamplingPlaneSet::voSamplingPlaneSet(voIndexedTetraSet* tetraSet, voBrickSet* brickSet,
                                       GLdouble modelMatrix[16], GLdouble projMatrix[16],
                                       voSamplingMode samplingMode, voSamplingSpace samplingSpace,
                                       float samplingPeriod[3], int maxSamplesNumber)
    : d(new Private)
{
    guarded("voSamplingPlaneSet", [&] {
        const vo::TetraView tetras = vo::tetraView(required(tetraSet, "tetraSet"));
        const voBrickSet& set = required(brickSet, "brickSet");
        const vo::SamplingRequest request = vo::samplingRequest(samplingMode, samplingSpace, samplingPeriod,
                                                                maxSamplesNumber, set.getOrientation());
        const vo::Camera camera = vo::cameraOf(modelMatrix, projMatrix);
        if (request.mode == vo::SamplingMode::spherical && camera.perspective)
            badValue("the surfaces of SPHERICAL sampling in a perspective view are no planes");
        if (request.space == vo::SamplingSpace::primitive)
            badValue("in PRIMITIVE space each tetrahedron has planes of its own");
        d->planes = vo::samplingPlanes(tetras, camera, request);
    });
}

voSamplingPlaneSet::~voSamplingPlaneSet()
{
    delete d;
}

int voSamplingPlaneSet::getSurfaceCount() const
{
    return d->planes.count;
}

int voSamplingPlaneSet::getPlane(int plane, float planeEquation[4]) const
{
    return guarded("voSamplingPlaneSet::getPlane", [&] {
        if (!planeEquation) badValue("planeEquation is NULL");
        if (plane < 0 || plane >= d->planes.count)
            badValue("plane " + std::to_string(plane) + " is outside 0 to " +
                     std::to_string(d->planes.count - 1));
        const glm::dvec4 equation = equationOf(d->planes, plane);
        for (int i = 0; i < 4; ++i)
            planeEquation[i] = static_cast<float>(equation[i]);
    });
}

void voSamplingPlaneSet::getSurface(int surface, float lowerLeft[3], float upperRight[3],
                                    voIndexedFaceSet* facets)
{
    guarded("voSamplingPlaneSet::getSurface", [&] {
        voIndexedFaceSet& target = required(facets, "facets");
        float equation[4];
        if (getPlane(surface, equation)) return;
        if (!lowerLeft || !upperRight) badValue("lowerLeft or upperRight is NULL");
        const vo::Box box{glm::make_vec3(lowerLeft), glm::make_vec3(upperRight)};
        const vo::CutPolygon square =
            vo::planeThroughBoxes(equationOf(d->planes, surface), {&box, 1}, {3, -1, -1, 0});
        vo::CutPolygon scratch, part;
        vo::clipToBox(square, box, scratch, part);
        vo::appendCut(part, target);
    });
}

voSamplingPlaneSetIterator::voSamplingPlaneSetIterator(voSamplingPlaneSet* planeSet) : set(planeSet), next(0)
{
}

float* voSamplingPlaneSetIterator::operator()()
{
    if (!set || next >= set->getSurfaceCount()) return nullptr;
    set->getPlane(next++, equation);
    return equation;
}

int voGeometryActions::polygonize(voIndexedTetraSet* tetraSet, voBrickSet* brickSet,
                                  voInterleavedArrayType format, voSamplingSurfaceSet* surfaces,
                                  int maxSamplesNumber, int& samplesNumber, voIndexedFaceSet*** polygonSet)
{
    samplesNumber = 0;
    return guarded("voGeometryActions::polygonize", [&] {
        vo::TetraView tetras = vo::tetraView(required(tetraSet, "tetraSet"));
        tetras.voxelColumn = vo::voxelColumn(format, tetras.valuesPerVertex);
        const voBrickSet& set = required(brickSet, "brickSet");
        voSamplingSurfaceSet& given = required(surfaces, "surfaces");
        const int count = given.getSurfaceCount();
        if (count < 0 || count > maxSamplesNumber)
            badValue(std::to_string(count) + " surfaces, there is room for " +
                     std::to_string(maxSamplesNumber));
        vo::resetFaceSets(polygonSet, set.getBrickCount(), maxSamplesNumber, tetras.valuesPerVertex);
        std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        thread_local vo::PolygonizeWorkspace workspace;
        vo::FaceSetSink sink(polygonSet, tetras.valuesPerVertex);
        vo::PolygonizeResult result;
        if (typeid(given) ==
            typeid(voSamplingPlaneSet)) { // a class derived from it may have surfaces of its own
            const auto& planes = static_cast<voSamplingPlaneSet&>(given);
            result = vo::polygonize(tetras, boxes, planes.d->planes, workspace, sink);
        } else {
            CallerSurfaces facets(given);
            result = vo::polygonize(tetras, boxes, facets, count, workspace, sink);
        }
        samplesNumber = result.samples;
        if (!result.complete)
            throw vo::CallerError{voErrorTypeScope::OUT_OF_MEMORY,
                                  "the vertex data that the face sets share is full; the rest is missing"};
    });
}
