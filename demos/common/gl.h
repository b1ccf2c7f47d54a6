#pragma once

// The loader comes before any header of <vo/...>, which include <GL/gl.h>.
#include <glad/gl.h>

/// OpenGL's functions in the context that is current: set by showOnScreen before it calls the program.
extern const GladGLContext* gl;
