// Draws a volume in a window: a turning ring of fog in a cube of 64 x 64 x 64 voxels.

#include <GLFW/glfw3.h>

#include <vo/AppearanceActions.h>
#include <vo/GeometryActions.h>

int main()
{
    const int n = 64;

    // What it looks like: voxels in one brick, bright in the middle of the ring.
    voBrickSetCollection fog(n, n, n, n, n, n, voPartialBrickTypeScope::AUGMENT, 1,
                             voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
                             voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    unsigned char* voxel = (unsigned char*)voAppearanceActions::dataAlloc(fog.getCurrentBrickSet());
    for (int z = 0; z < n; z++)
        for (int y = 0; y < n; y++)
            for (int x = 0; x < n; x++) {
                double distance = hypot(hypot(x - 31.5, y - 31.5) - 20, z - 31.5);
                *voxel++ = distance < 10 ? (unsigned char)(255 - 25 * distance) : 0;
            }

    // What shape it has: the cube's corners, and the five tetrahedra that it falls into.
    const float corners[] = {0, 0, 0, n, 0, 0, 0, n, 0, n, n, 0, 0, 0, n, n, 0, n, 0, n, n, n, n, n};
    const int tetras[] = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 3, 6, 4, 0, 5, 6, 7, 3, 5, 6};
    voIndexedTetraSet cube(corners, 8, 3, tetras, 20);

    glfwInit();
    GLFWwindow* window = glfwCreateWindow(512, 512, "A volume", NULL, NULL);
    glfwMakeContextCurrent(window);
    glMatrixMode(GL_PROJECTION);
    glOrtho(-40, 40, -40, 40, -n, n);
    glMatrixMode(GL_MODELVIEW);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glColor4f(0.1f, 0.1f, 0.1f, 0.1f); // scales the voxels: light and opacity of one slice

    while (!glfwWindowShouldClose(window)) {
        glClear(GL_COLOR_BUFFER_BIT);
        glPushMatrix();
        glRotated(20 * glfwGetTime(), 1, 2, 3);
        glTranslated(-n / 2, -n / 2, -n / 2);
        float period[3] = {1, 1, 1}; // one slice a voxel
        voGeometryActions::drawUtility(&cube, voInterleavedArrayTypeScope::V3F, &fog, NULL,
                                       voSamplingSpaceScope::OBJECT, period, voDecorationFlagsScope::NONE);
        glPopMatrix();
        glfwSwapBuffers(window);
        glfwPollEvents();
    }
    glfwTerminate();
}
