// A volume of 64 x 64 x 64 voxels without its upper right corner, which becomes a set of its own.

#include <vo/utSolidActions.h>
#include <vo/utSolids.h>

int main()
{
    voutBox box(0, 0, 0, 64, 64, 64, 1, 1, 1);
    voIndexedTetraSet* whole = box.tessellate();

    const float lower[3] = {32, 32, 32}, upper[3] = {64, 64, 64};
    voIndexedTetraSet* corner = voutSolidActions::inside(whole, lower, upper);
    voIndexedTetraSet* rest = voutSolidActions::outside(whole, lower, upper);

    voutTaggedSet both(3); // as one set again, whose tetrahedra know where they belong
    both.append(rest, 0);
    both.append(corner, 1);
    const int shared = both.mergeVertices();
    printf("%d tetrahedra in the corner, %d in the rest, %d vertices of both\n",
           corner->getIndices()->getCount() / 4, rest->getIndices()->getCount() / 4, shared);
    delete corner;
    delete rest;
    delete whole;
    return 0;
}
