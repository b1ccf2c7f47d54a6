#include <vo/utSolidActions.h>

#include "legacy/report.h"

#include "vout/cut_mesh.h"
#include "vout/tagged_mesh.h"
#include "vout/transform_mesh.h"

#include <cmath>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

std::vector<vo::CutPlane> planesOf(const float* planes, int count)
{
    if (count < 0) badValue(std::to_string(count) + " planes");
    if (count > 0) required(planes, "planes");
    std::vector<vo::CutPlane> result;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const float* p = planes + 4 * i;
        const glm::dvec3 inward(p[0], p[1], p[2]);
        const double length = glm::length(inward);
        if (!(length > 0) || !std::isfinite(length + static_cast<double>(p[3])))
            badValue("plane " + std::to_string(i) + " has no direction, or is not finite");
        result.push_back({inward / length, static_cast<double>(p[3]) / length});
    }
    return result;
}

std::vector<vo::CutPlane> planesOfBox(const float* lower, const float* upper)
{
    required(lower, "lowerLeft");
    required(upper, "upperRight");
    std::vector<vo::CutPlane> planes;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(lower[axis] < upper[axis]) || !std::isfinite(lower[axis]) || !std::isfinite(upper[axis]))
            badValue("the upper end of the box is not above the lower one, or it is not finite");
        glm::dvec3 inward(0);
        inward[axis] = 1;
        planes.push_back({inward, -static_cast<double>(lower[axis])});
        planes.push_back({-inward, static_cast<double>(upper[axis])});
    }
    return planes;
}

enum class Keep { inside, outside };

/// The set cut by planes that `planes` makes: what is inside of all, or the rest.
template <typename Planes>
voIndexedTetraSet* cutSet(Keep keep, voIndexedTetraSet* set, Planes planes)
{
    std::unique_ptr<voIndexedTetraSet> result;
    guarded(keep == Keep::inside ? "voutSolidActions::inside" : "voutSolidActions::outside", [&] {
        vo::CutMesh mesh(vo::meshOf(required(set, "set")));
        for (const vo::CutPlane& plane : planes())
            mesh.cut(plane);
        result = vo::tetraSet(keep == Keep::inside ? mesh.inside() : mesh.outside());
    });
    return result.release();
}

voIndexedTetraSet* cutByPlanes(Keep keep, voIndexedTetraSet* set, const float* planes, int planeCount)
{
    return cutSet(keep, set, [&] { return planesOf(planes, planeCount); });
}

voIndexedTetraSet* cutByBox(Keep keep, voIndexedTetraSet* set, const float* lowerLeft, const float* upperRight)
{
    return cutSet(keep, set, [&] { return planesOfBox(lowerLeft, upperRight); });
}

voIndexedTetraSet* cutByConvexSet(Keep keep, voIndexedTetraSet* set, voIndexedTetraSet* convex)
{
    return cutSet(keep, set, [&] { return vo::planesRound(vo::meshOf(required(convex, "convex"))); });
}

} // namespace

voIndexedTetraSet* voutSolidActions::inside(voIndexedTetraSet* set, const float* planes, int planeCount)
{
    return cutByPlanes(Keep::inside, set, planes, planeCount);
}

voIndexedTetraSet* voutSolidActions::inside(voIndexedTetraSet* set, const float lowerLeft[3],
                                            const float upperRight[3])
{
    return cutByBox(Keep::inside, set, lowerLeft, upperRight);
}

voIndexedTetraSet* voutSolidActions::inside(voIndexedTetraSet* set, voIndexedTetraSet* convex)
{
    return cutByConvexSet(Keep::inside, set, convex);
}

voIndexedTetraSet* voutSolidActions::outside(voIndexedTetraSet* set, const float* planes, int planeCount)
{
    return cutByPlanes(Keep::outside, set, planes, planeCount);
}

voIndexedTetraSet* voutSolidActions::outside(voIndexedTetraSet* set, const float lowerLeft[3],
                                             const float upperRight[3])
{
    return cutByBox(Keep::outside, set, lowerLeft, upperRight);
}

voIndexedTetraSet* voutSolidActions::outside(voIndexedTetraSet* set, voIndexedTetraSet* convex)
{
    return cutByConvexSet(Keep::outside, set, convex);
}

voIndexedTetraSet* voutSolidActions::transformed(voIndexedTetraSet* set, voInterleavedArrayType format,
                                                 const GLdouble matrix[16])
{
    std::unique_ptr<voIndexedTetraSet> result;
    guarded("voutSolidActions::transformed", [&] {
        const vo::TetraMesh mesh = vo::meshOf(required(set, "set"));
        result = vo::tetraSet(vo::placed(mesh, format, vo::affineMatrix(&required(matrix, "matrix"))));
    });
    return result.release();
}

struct voutTaggedSet::Private
{
    vo::TaggedMesh mesh;
};

voutTaggedSet::voutTaggedSet(int valuesPerVertex) : d(new Private)
{
    guarded("voutTaggedSet", [&] { d->mesh = vo::TaggedMesh(valuesPerVertex); });
}

voutTaggedSet::~voutTaggedSet()
{
    delete d;
}

int voutTaggedSet::append(voIndexedTetraSet* set, int tag)
{
    return guarded("voutTaggedSet::append", [&] { d->mesh.append(vo::meshOf(required(set, "set")), tag); });
}

int voutTaggedSet::mergeVertices()
{
    int fewer = 0;
    guarded("voutTaggedSet::mergeVertices", [&] { fewer = d->mesh.mergeVertices(); });
    return fewer;
}

int voutTaggedSet::getTetraCount() const
{
    return static_cast<int>(d->mesh.tags().size());
}

int voutTaggedSet::getVertexCount() const
{
    return static_cast<int>(d->mesh.mesh().vertexCount());
}

int voutTaggedSet::getTag(int tetra) const
{
    int tag = 0;
    guarded("voutTaggedSet::getTag", [&] {
        if (tetra < 0 || tetra >= getTetraCount())
            badValue("tetrahedron " + std::to_string(tetra) + " of " + std::to_string(getTetraCount()));
        tag = d->mesh.tags()[static_cast<std::size_t>(tetra)];
    });
    return tag;
}

voBool voutTaggedSet::hasTag(int tag) const
{
    return d->mesh.hasTag(tag) ? VO_TRUE : VO_FALSE;
}

voIndexedTetraSet* voutTaggedSet::tessellate()
{
    std::unique_ptr<voIndexedTetraSet> result;
    guarded("voutTaggedSet::tessellate", [&] { result = vo::tetraSet(d->mesh.mesh()); });
    return result.release();
}

voIndexedTetraSet* voutTaggedSet::extract(int tag) const
{
    std::unique_ptr<voIndexedTetraSet> result;
    guarded("voutTaggedSet::extract", [&] { result = vo::tetraSet(d->mesh.extract(tag)); });
    return result.release();
}
