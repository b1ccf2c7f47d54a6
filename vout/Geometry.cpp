#include <vo/utGeometry.h>

voutGeometry::voutGeometry() = default;

voutGeometry::~voutGeometry() = default;

voIndexedTetraSet* voutGeometry::tesselate()
{
    return tessellate();
}
