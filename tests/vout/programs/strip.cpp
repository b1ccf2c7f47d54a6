// A wall along a curve: prisms side by side, as triangles of a strip, each edge upright.

#include <vo/utGeometry.h>

int main()
{
    const int edges = 20;
    float places[2 * edges][3];
    int indices[2 * edges];
    for (int i = 0; i < 2 * edges; i++) {
        const int edge = i / 2;
        const float angle = 0.2f * edge, radius = edge % 2 ? 20.f : 25.f;
        places[i][0] = 32 + radius * cosf(angle);
        places[i][1] = 32 + radius * sinf(angle);
        places[i][2] = i % 2 ? 48.f : 16.f;
        indices[i] = i;
    }
    voutIndexedPrismFaceStrip wall(places[0], 2 * edges, 3, indices, 2 * edges);

    voIndexedTetraSet* tetras = wall.tessellate();
    printf("%d tetrahedra on %d vertices\n", tetras->getIndices()->getCount() / 4,
           tetras->getVertexData()->getCount());
    delete tetras;
    return 0;
}
