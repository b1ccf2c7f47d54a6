#ifndef VO_COMPAT_GL_H
#define VO_COMPAT_GL_H

/* Programs of 1998 call extensions, glBlendEquationEXT and the like, with no declaration but <GL/gl.h>. With the folder of
   this file's parent first on the include path the system's header declares them, whichever header comes first. */

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES 1
#endif

#if defined(__GNUC__)
#pragma GCC system_header
#endif
#include_next <GL/gl.h>

#endif
