// U: timers (page 98) and higher primitives (pages 97-98 and 113-114).

#include <vo/utGeometry.h>
#include <vo/utOccupied.h>
#include <vo/utPerfMeter.h>
#include <vo/utSolids.h>

#include <sstream>

#include "rows.h"

namespace DIALECT {

/// The constructors of a set, which are those of voIndexedTetraSet, and what it makes of no cells.
template <class Set>
static void indexedSet()
{
    static float vertices[8 * 3];
    static int numbers[8];
    const static float constantVertices[8 * 3] = {0};
    const static int constantNumbers[8] = {0};
    Set* aSet = new Set(vertices, 8, 3, numbers, 0);
    voutIndexedSet* set = aSet;
    voutGeometry* geometry = set;
    voIndexedTetraSet* tetras = geometry->tessellate();
    delete tetras;
    is<voVertexData*>(set->getVertexData());
    is<voIndices*>(set->getIndices());
    set->empty();
    delete geometry;
    Set copied(constantVertices, 8, 3, constantNumbers, 0);
    Set room(8, 3, 8);
    voVertexData data(8, 3, vertices);
    voIndices indices(0, numbers);
    Set parts(&data, &indices);
    is<voIndexedTetraSet* (Set::*)()>(&Set::tessellate);
}

static void solids()
{
    ROW(U5);
    voutSphere* aSphere = new voutSphere(0, 0, 0, 100, 32, 32); // new is not the guide's
    voIndexedTetraSet* tetras = aSphere->tesselate();
    delete tetras;
    delete aSphere;
    ROW(U6);
    voutGeoSphere geodesic(0, 0, 0, 100, 2);
    voutShell shell(0, 0, 0, 50, 100, 2);
    ROW(U7);
    const float from[3] = {0, 0, 0}, to[3] = {1, 2, 3};
    voutCylinder cylinder(0, 0, 0, 1, 2, 16, 1), leaning(from, to, 1, 16, 1);
    voutCone cone(0, 0, 0, 1, 2, 16, 1), leaningCone(from, to, 1, 16, 1);
    voutTorus torus(0, 0, 0, 2, 1, 16, 8);
    voutBox box(0, 0, 0, 1, 1, 1);
    const float triangle[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    voutExtrusion extrusion(triangle, 3, to);
    voutGeometry* geometry = &extrusion;
    delete geometry->tessellate();
}

static void indexedSets()
{
    ROW(U3);
    is<voIndexedTetraSet* (voutGeometry::*)()>(&voutGeometry::tessellate);
    ROW(U4);
    ROW(U8);
    indexedSet<voutIndexedHexaSet>();
    indexedSet<voutIndexedHexaStrip>();
    voutIndexedHexaSet boxes(8, 3, 8);
    boxes.setTetrasPerHexa(24);
    ROW(U9);
    indexedSet<voutIndexedPrismSet>();
    indexedSet<voutIndexedPrismFaceStrip>();
    indexedSet<voutIndexedPrismBaseStrip>();
    indexedSet<voutIndexedPrismEdgeStrip>();
    ROW(U10);
    indexedSet<voutIndexedPyramidSet>();
    indexedSet<voutIndexedPyramidStrip>();
    ROW(U11);
    indexedSet<voutIndexedTetraFaceStrip>();
    indexedSet<voutIndexedTetraEdgeStrip>();
}

void utilities()
{
    ROW(U1);
    voutTimer timer;
    timer.start();
    timer.stop();
    std::ostringstream out;
    out << timer;
    is<std::ostream& (*)(std::ostream&, const voutTimer&)>(&operator<<);
    ROW(U2);
    voutPerfMeter meter;
    meter.enable();
    meter.getTimer(voutPerfMeter::DRAW).start();
    meter.getTimer(voutPerfMeter::DRAW).stop();
    meter.countFrame();
    meter.disable();
    out << meter;
    is<std::ostream& (*)(std::ostream&, const voutPerfMeter&)>(&operator<<);
    solids();
    indexedSets();
}

} // namespace DIALECT
