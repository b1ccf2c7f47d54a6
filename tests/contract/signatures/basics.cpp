// B: what every program takes for granted.

#include <vo/GeometryActions.h>

#include "rows.h"

namespace DIALECT {

void basics()
{
    ROW(B1);
    voBool flag = 1 < 2;
    int number = flag;
    flag = number;
    ROW(B2);
    flag = VO_TRUE;
    flag = VO_FALSE;
    is(flag);
    ROW(B3);
    const char* version = voVersion();
    char text[80];
    snprintf(text, sizeof text, "%s", version);
    ROW(B4);
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    enum { tetraCount = sizeof(cubeIndices) / (VO_TETRA_VERTICES * sizeof(cubeIndices[0])) };
    static int oneATetra[tetraCount == 5 ? 1 : -1];
    is(oneATetra);
    ROW(B5);
    is<voErrorType (*)()>(&voError::getErrorNumber);
    ROW(B6);
    GLdouble d = 0;
    GLenum e = 0;
    GLboolean b = GL_TRUE;
    is(d);
    is(e);
    is(b);
}

} // namespace DIALECT
