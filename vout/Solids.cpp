#include <vo/utSolids.h>

#include "legacy/report.h"

#include "vout/geodesic_solids.h"
#include "vout/round_solids.h"
#include "vout/straight_solids.h"

#include <cmath>

using vo::guarded;

struct voutSphere::Private : vo::Ball
{
};
struct voutGeoSphere::Private : vo::GeodesicBall
{
};
struct voutShell::Private : vo::GeodesicShell
{
};
struct voutCylinder::Private : vo::Column
{
};
struct voutCone::Private : vo::Column
{
};
struct voutTorus::Private : vo::Torus
{
};
struct voutBox::Private : vo::BoxGrid
{
};
struct voutExtrusion::Private : vo::Extrusion
{
};

namespace {

template <typename Shape>
void checkOrReport(const char* action, const Shape& shape)
{
    guarded(action, [&] { check(shape); });
}

template <typename Shape>
voIndexedTetraSet* tetrasOf(const char* action, const Shape& shape)
{
    std::unique_ptr<voIndexedTetraSet> tetras;
    guarded(action, [&] {
        check(shape);
        tetras = vo::tetraSet(vo::tessellated(solidOf(shape)));
    });
    return tetras.release();
}

/// A column from a base point and a top point, which NULL leaves without a place.
vo::Column columnBetween(const char* action, const float* base, const float* top, float radius, int slices, int stacks,
                         bool isCone)
{
    const double nowhere = NAN;
    vo::Column column{glm::dvec3(nowhere), glm::dvec3(nowhere), double(radius), slices, stacks, isCone};
    guarded(action, [&] {
        vo::required(base, "base");
        vo::required(top, isCone ? "tip" : "top");
        column.base = {base[0], base[1], base[2]};
        column.top = {top[0], top[1], top[2]};
        check(column);
    });
    return column;
}

} // namespace

voutSphere::voutSphere(float x, float y, float z, float radius, int slices, int stacks)
    : d(new Private{{{x, y, z}, radius, slices, stacks}})
{
    checkOrReport("voutSphere", *d);
}

voutSphere::~voutSphere()
{
    delete d;
}

voIndexedTetraSet* voutSphere::tessellate()
{
    return tetrasOf("voutSphere::tessellate", *d);
}

voutGeoSphere::voutGeoSphere(float x, float y, float z, float radius, int level)
    : d(new Private{{{x, y, z}, radius, level}})
{
    checkOrReport("voutGeoSphere", *d);
}

voutGeoSphere::~voutGeoSphere()
{
    delete d;
}

voIndexedTetraSet* voutGeoSphere::tessellate()
{
    return tetrasOf("voutGeoSphere::tessellate", *d);
}

voutShell::voutShell(float x, float y, float z, float innerRadius, float outerRadius, int level)
    : d(new Private{{{x, y, z}, innerRadius, outerRadius, level}})
{
    checkOrReport("voutShell", *d);
}

voutShell::~voutShell()
{
    delete d;
}

voIndexedTetraSet* voutShell::tessellate()
{
    return tetrasOf("voutShell::tessellate", *d);
}

voutCylinder::voutCylinder(float x, float y, float z, float radius, float height, int slices, int stacks)
    : d(new Private{{{x, y, z}, {x, y, double(z) + double(height)}, radius, slices, stacks, false}})
{
    checkOrReport("voutCylinder", *d);
}

voutCylinder::voutCylinder(const float base[3], const float top[3], float radius, int slices, int stacks)
    : d(new Private{columnBetween("voutCylinder", base, top, radius, slices, stacks, false)})
{
}

voutCylinder::~voutCylinder()
{
    delete d;
}

voIndexedTetraSet* voutCylinder::tessellate()
{
    return tetrasOf("voutCylinder::tessellate", *d);
}

voutCone::voutCone(float x, float y, float z, float radius, float height, int slices, int stacks)
    : d(new Private{{{x, y, z}, {x, y, double(z) + double(height)}, radius, slices, stacks, true}})
{
    checkOrReport("voutCone", *d);
}

voutCone::voutCone(const float base[3], const float tip[3], float radius, int slices, int stacks)
    : d(new Private{columnBetween("voutCone", base, tip, radius, slices, stacks, true)})
{
}

voutCone::~voutCone()
{
    delete d;
}

voIndexedTetraSet* voutCone::tessellate()
{
    return tetrasOf("voutCone::tessellate", *d);
}

voutTorus::voutTorus(float x, float y, float z, float radius, float tubeRadius, int slices, int sides)
    : d(new Private{{{x, y, z}, radius, tubeRadius, slices, sides}})
{
    checkOrReport("voutTorus", *d);
}

voutTorus::~voutTorus()
{
    delete d;
}

voIndexedTetraSet* voutTorus::tessellate()
{
    return tetrasOf("voutTorus::tessellate", *d);
}

voutBox::voutBox(float x, float y, float z, float xSize, float ySize, float zSize, int columns, int rows, int layers)
    : d(new Private{{{x, y, z}, {xSize, ySize, zSize}, {columns, rows, layers}}})
{
    checkOrReport("voutBox", *d);
}

voutBox::~voutBox()
{
    delete d;
}

void voutBox::setTetrasPerHexa(int count)
{
    guarded("voutBox::setTetrasPerHexa", [&] { d->split = vo::hexaSplit(count); });
}

int voutBox::getTetrasPerHexa() const
{
    return static_cast<int>(d->split);
}

voIndexedTetraSet* voutBox::tessellate()
{
    return tetrasOf("voutBox::tessellate", *d);
}

voutExtrusion::voutExtrusion(const float* polygon, int count, const float line[3])
    : d(new Private{{{}, glm::dvec3(0)}})
{
    guarded("voutExtrusion", [&] {
        vo::requireAtLeast("points", count, 3);
        vo::required(polygon, "polygon");
        vo::required(line, "line");
        for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
            d->polygon.push_back({polygon[3 * i], polygon[3 * i + 1], polygon[3 * i + 2]});
        d->line = {line[0], line[1], line[2]};
        check(*d);
    });
}

voutExtrusion::~voutExtrusion()
{
    delete d;
}

voIndexedTetraSet* voutExtrusion::tessellate()
{
    return tetrasOf("voutExtrusion::tessellate", *d);
}
