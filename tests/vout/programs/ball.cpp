// A ball in a volume of 64 x 64 x 64 voxels.

#include <vo/utSolids.h>

int main()
{
    voutGeoSphere ball(32, 32, 32, 30, 3); // centre, radius, and how fine
    voIndexedTetraSet* tetras = ball.tessellate();
    if (!tetras) {
        fprintf(stderr, "%s\n", voError::getErrorString());
        return 1;
    }
    printf("%d tetrahedra on %d vertices\n", tetras->getIndices()->getCount() / 4,
           tetras->getVertexData()->getCount());
    delete tetras;
    return 0;
}
