// A volume of 64 x 64 x 64 voxels, twisted: boxes whose records are voxel coordinates and a place.

#include <vo/utGeometry.h>

int main()
{
    const int n = 8; // boxes along each side
    voutIndexedHexaSet boxes((n + 1) * (n + 1) * (n + 1), 6, 8 * n * n * n);
    voVertexData& vertices = *boxes.getVertexData();
    voIndices& corners = *boxes.getIndices();
    int vertex = 0, corner = 0;
    for (int k = 0; k <= n; k++)
        for (int j = 0; j <= n; j++)
            for (int i = 0; i <= n; i++) {
                float* record = vertices[vertex++];
                const float x = 64.f * i / n, y = 64.f * j / n, z = 64.f * k / n, turn = z / 64;
                record[0] = x;
                record[1] = y;
                record[2] = z;
                record[3] = 32 + cosf(turn) * (x - 32) - sinf(turn) * (y - 32);
                record[4] = 32 + sinf(turn) * (x - 32) + cosf(turn) * (y - 32);
                record[5] = z;
                if (i == n || j == n || k == n) continue;
                const int right = 1, up = n + 1, back = (n + 1) * (n + 1), first = vertex - 1;
                const int round[4] = {first, first + right, first + right + up, first + up};
                for (int c = 0; c < 8; c++)
                    corners[corner++] = round[c % 4] + c / 4 * back;
            }
    vertices.setCount(vertex);
    corners.setCount(corner);
    boxes.setTetrasPerHexa(24);

    voIndexedTetraSet* tetras = boxes.tessellate();
    printf("%d tetrahedra on %d vertices\n", tetras->getIndices()->getCount() / 4,
           tetras->getVertexData()->getCount());
    delete tetras;
    return 0;
}
