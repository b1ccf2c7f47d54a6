// An octahedron as a surface of triangles, and what a box has round it.

#include <vo/utClosedSurface.h>

static double volumeOf(voIndexedTetraSet* tetras)
{
    double sixfold = 0;
    voVertexData& vertices = *tetras->getVertexData();
    voIndices& corners = *tetras->getIndices();
    for (int t = 0; t < corners.getCount(); t += 4) {
        double edge[3][3];
        for (int e = 0; e < 3; e++)
            for (int i = 0; i < 3; i++)
                edge[e][i] = double(vertices[corners[t + e + 1]][i]) - double(vertices[corners[t]][i]);
        for (int i = 0; i < 3; i++) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            sixfold += edge[0][i] * (edge[1][j] * edge[2][k] - edge[1][k] * edge[2][j]);
        }
    }
    return sixfold / 6;
}

int main()
{
    const float vertices[][3] = {{60, 32, 32}, {4, 32, 32},  {32, 60, 32},
                                 {32, 4, 32},  {32, 32, 60}, {32, 32, 4}};
    const int triangles[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
    voutClosedSurface octahedron(vertices[0], 6, triangles, 24);
    octahedron.setEdgeLength(8);

    const float lower[3] = {0, 0, 0}, upper[3] = {64, 64, 64};
    voIndexedTetraSet *inside, *rest;
    if (octahedron.tessellateInBox(lower, upper, inside, rest)) {
        fprintf(stderr, "%s\n", voError::getErrorString());
        return 1;
    }
    printf("%.1f inside, %.1f in the rest, %.1f in the box\n", volumeOf(inside), volumeOf(rest),
           volumeOf(inside) + volumeOf(rest));
    delete inside;
    delete rest;
    return 0;
}
