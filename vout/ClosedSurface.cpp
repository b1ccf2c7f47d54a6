#include <vo/utClosedSurface.h>

#include "legacy/report.h"

#include "vout/closed_solid.h"
#include "vout/solid.h"

using vo::guarded;

struct voutClosedSurface::Private : vo::ClosedSolid
{
};

namespace {

vo::TriangleSurface surfaceOf(const float* vertices, int countV, const int* triangles, int countI)
{
    vo::requireAtLeast("vertices", countV, 4);
    vo::requireAtLeast("indices", countI, 12);
    if (countI % 3 != 0) vo::badValue(std::to_string(countI) + " indices are not three for each triangle");
    vo::required(vertices, "vertices");
    vo::required(triangles, "triangles");
    vo::TriangleSurface surface;
    for (std::size_t i = 0; i < static_cast<std::size_t>(countV); ++i)
        surface.vertices.push_back({vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]});
    for (int i = 0; i < countI; i++)
        if (triangles[i] < 0 || triangles[i] >= countV)
            vo::badValue("index " + std::to_string(i) + " is " + std::to_string(triangles[i]) +
                         ", there are " + std::to_string(countV) + " vertices");
    for (int i = 0; i < countI; i += 3)
        surface.triangles.push_back({triangles[i], triangles[i + 1], triangles[i + 2]});
    return surface;
}

} // namespace

voutClosedSurface::voutClosedSurface(const float* vertices, int countV, const int* triangles, int countI)
    : d(new Private)
{
    guarded("voutClosedSurface",
            [&] { d->surface = vo::checkedSurface(surfaceOf(vertices, countV, triangles, countI)); });
}

voutClosedSurface::voutClosedSurface(const char* fileName) : d(new Private)
{
    guarded("voutClosedSurface", [&] {
        vo::TriangleSurface surface = vo::merged(vo::readSurface(&vo::required(fileName, "fileName")));
        vo::alignNeighbours(surface);
        d->surface = vo::checkedSurface(surface);
    });
}

voutClosedSurface::~voutClosedSurface()
{
    delete d;
}

void voutClosedSurface::setEdgeLength(float length)
{
    guarded("voutClosedSurface::setEdgeLength", [&] {
        vo::requirePositive("the edge length", double(length));
        d->edge = length;
    });
}

float voutClosedSurface::getEdgeLength() const
{
    return d->surface.triangles.empty() && !d->edge ? 0 : static_cast<float>(d->sizes().edge);
}

void voutClosedSurface::setFacetDistance(float distance)
{
    guarded("voutClosedSurface::setFacetDistance", [&] {
        vo::requirePositive("the facet distance", double(distance));
        d->distance = distance;
    });
}

float voutClosedSurface::getFacetDistance() const
{
    return d->surface.triangles.empty() && !d->edge && !d->distance ? 0
                                                                    : static_cast<float>(d->sizes().distance);
}

void voutClosedSurface::setSharpAngle(float degrees)
{
    guarded("voutClosedSurface::setSharpAngle", [&] {
        if (!(degrees >= 1 && degrees <= 180))
            vo::badValue("the angle is " + std::to_string(degrees) + " degrees, from 1 to 180 is needed");
        d->sharpAngle = degrees;
    });
}

float voutClosedSurface::getSharpAngle() const
{
    return static_cast<float>(d->sharpAngle);
}

double voutClosedSurface::getVolume() const
{
    return d->surface.volume();
}

void voutClosedSurface::getBounds(float lower[3], float upper[3]) const
{
    guarded("voutClosedSurface::getBounds", [&] {
        vo::required(lower, "lower");
        vo::required(upper, "upper");
        if (d->surface.triangles.empty()) vo::badValue("there is no surface");
        for (int axis = 0; axis < 3; ++axis) {
            lower[axis] = static_cast<float>(d->surface.lower()[axis]);
            upper[axis] = static_cast<float>(d->surface.upper()[axis]);
        }
    });
}

float voutClosedSurface::getSmallestAngle()
{
    return static_cast<float>(vo::kSmallestDihedral);
}

voIndexedTetraSet* voutClosedSurface::tessellate()
{
    std::unique_ptr<voIndexedTetraSet> tetras;
    guarded("voutClosedSurface::tessellate",
            [&] { tetras = vo::tetraSet(vo::tessellated(*d, std::nullopt)[0]); });
    return tetras.release();
}

int voutClosedSurface::tessellateInBox(const float lower[3], const float upper[3], voIndexedTetraSet*& inside,
                                       voIndexedTetraSet*& rest)
{
    inside = rest = NULL;
    return guarded("voutClosedSurface::tessellateInBox", [&] {
        vo::required(lower, "lower");
        vo::required(upper, "upper");
        const vo::Box box{{lower[0], lower[1], lower[2]}, {upper[0], upper[1], upper[2]}};
        const auto regions = vo::tessellated(*d, box);
        auto within = vo::tetraSet(regions[0]);
        rest = vo::tetraSet(regions[1]).release();
        inside = within.release();
    });
}
