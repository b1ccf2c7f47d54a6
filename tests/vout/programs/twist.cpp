// A volume of 64 x 64 x 64 voxels, twisted by a quarter turn.

#include <vo/utLattice.h>

int main()
{
    const float lower[3] = {0, 0, 0}, upper[3] = {64, 64, 64};
    voutLattice lattice(8, 8, 8, lower, upper);
    lattice.twist(2, 90); // about z; then any vertex may be moved by setVertex
    voIndexedTetraSet* tetras = lattice.tessellate();
    if (!tetras) {
        fprintf(stderr, "%s\n", voError::getErrorString());
        return 1;
    }
    printf("%d tetrahedra on %d vertices, %d of them inside out\n", tetras->getIndices()->getCount() / 4,
           tetras->getVertexData()->getCount(), lattice.countInverted());
    delete tetras;
    return 0;
}
