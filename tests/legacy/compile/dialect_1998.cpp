// What sources of 1998 take for granted: stream names without std, text literals as char *, assignments as
// conditions, an implicit double to int, and C's headers and <GL/gl.h> from <vo/...>. Compiled as C++98 with
// -fpermissive and include/vo/compat on the path, whose <GL/gl.h> declares the extensions.
// ROW(B7) ROW(B8) of tests/contract/checklist.txt.

#include <GL/gl.h>
#include <vo/Volumizer.h>

// Declared; asking for a size alone links nothing of OpenGL, whose libraries do not all export extensions.
enum { extensionsAreDeclared = sizeof(&glBlendEquationEXT) + sizeof(&glTexImage3DEXT) + GL_MAX_EXT };

static char* nameOf(voErrorType number)
{
    switch (number) {
    case voErrorTypeScope::NO_ERROR: return "no error";
    default: return "error";
    }
}

int dialect1998()
{
    voBrickSetCollection* aVolume = new voBrickSetCollection(
        8, 8, 8, 8, 8, 8, voPartialBrickTypeScope::AUGMENT, 0, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_2D);
    int bricks = 0.9;
    voBrickSetCollectionIterator collectionIter(aVolume);
    for (voBrickSet* brickSet; brickSet = collectionIter();) {
        voBrickSetIterator brickSetIter(brickSet);
        for (voBrick* brick; brick = brickSetIter();)
            bricks++;
    }
    delete aVolume;
    assert(bricks == 24);
    char text[80];
    strcpy(text, nameOf(voError::getErrorNumber()));
    if (strcmp(text, "no error") || fabs(-1.0) != 1) cerr << text << endl;
    if (!extensionsAreDeclared) return 0;
    cout << voDataTypeScope::FLOAT << endl;
    GLdouble x = atof("24");
    return bricks + x;
}
