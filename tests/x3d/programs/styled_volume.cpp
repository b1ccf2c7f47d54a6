#include <cstdio>

#include <vo/Volumizer.h>
#include <vo/x3d/StyledVolume.h>

int main()
{
    // A volume of 16 x 16 x 16 voxels: a ball, brighter towards its middle.
    voBrickSetCollection bricks(16, 16, 16, 16, 16, 16, voPartialBrickTypeScope::AUGMENT, 0,
                                voInternalFormatTypeScope::INTENSITY8_EXT,
                                voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE,
                                voInterpolationTypeScope::_3D);
    static unsigned char voxels[16 * 16 * 16];
    for (int i = 0; i < 16 * 16 * 16; ++i) {
        const float x = i % 16 - 7.5f, y = i / 16 % 16 - 7.5f, z = i / 256 - 7.5f;
        const float value = 255 - 5 * (x * x + y * y + z * z);
        voxels[i] = static_cast<unsigned char>(value > 0 ? value : 0);
    }
    bricks.getCurrentBrickSet()->getBrick(0)->setDataPtr(voxels);
    // One tetrahedron of it, in voxels.
    float corners[] = {0, 0, 0, 16, 0, 16, 0, 16, 16, 16, 16, 0};
    int indices[] = {0, 1, 2, 3};
    voIndexedTetraSet tetras(corners, 4, 3, indices, 4);

    // The style, in three lines.
    voX3DScene scene;
    voX3DNode style = scene.createNode("CartoonVolumeStyle");
    voX3DStyledVolume volume(scene, style, &bricks, &tetras);

    // Seen from z = 40, orthographic; in a window volume.draw(model, projection, 64, 64) draws it.
    const GLdouble model[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -8, -8, -40, 1};
    const GLdouble projection[16] = {0.1, 0, 0, 0, 0, 0.1, 0, 0, 0, 0, -0.02, 0, 0, 0, -1, 1};
    static float picture[64 * 64 * 4];
    if (!volume.picture(model, projection, 64, 64, picture)) return 1;
    std::printf("opacity in the middle: %.2f\n", picture[4 * (64 * 32 + 32) + 3]);
    return 0;
}
