#include "gl.h"

const GladGLContext* gl = nullptr;
