// A letter filled with smoke: a polygon, moved along a line.

#include <vo/utSolids.h>

int main()
{
    const float outline[][3] = {{10, 10, 20}, {50, 10, 20}, {50, 20, 20},
                                {20, 20, 20}, {20, 54, 20}, {10, 54, 20}};
    const float line[3] = {0, 0, 24};
    voutExtrusion letter(outline[0], 6, line);

    voIndexedTetraSet* tetras = letter.tessellate();
    printf("%d tetrahedra on %d vertices\n", tetras->getIndices()->getCount() / 4,
           tetras->getVertexData()->getCount());
    delete tetras;
    return 0;
}
