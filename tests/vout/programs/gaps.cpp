// Two small things in a volume of 64 x 64 x 64 voxels, and boxes round them.

#include <vo/utOccupied.h>

static int readVoxels(const int origin[3], const int size[3], double* values, void*)
{
    for (int z = origin[2]; z < origin[2] + size[2]; z++)
        for (int y = origin[1]; y < origin[1] + size[1]; y++)
            for (int x = origin[0]; x < origin[0] + size[0]; x++) {
                const int left = x > 2 && x < 20 && y > 2 && y < 12 && z > 2 && z < 12;
                const int right = x > 50 && y > 50 && z > 50;
                *values++ = left || right ? 0.7 : 0.1;
            }
    return 0;
}

int main()
{
    const int sizes[3] = {64, 64, 64};
    voutOccupied occupied(sizes, readVoxels, NULL, 0.5, 1.0, 8); // values of 0.5 to 1, blocks of 8 voxels
    voIndexedTetraSet* tetras = occupied.tessellate();
    printf("%d of %d blocks in %d boxes, %.1f %% of the volume\n", occupied.getOccupiedCount(),
           occupied.getBlockCount(), occupied.getBoxCount(), 100 * occupied.getCoveredFraction());
    delete tetras;
    return 0;
}
