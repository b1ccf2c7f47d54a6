// OpenGL's plain names, as programs of 1998 call them, led to the context that a test has made current: libGL
// would know the contexts of GLX and EGL only, and the tests run under OSMesa too.

#include "gl_names.h"

#include <GL/gl.h>

namespace {

vo::test::FindFunction find = nullptr;

template <class Function>
Function* named(const char* name)
{
    return reinterpret_cast<Function*>(find(name));
}

} // namespace

void vo::test::leadOpenGlNames(FindFunction findFunction)
{
    find = findFunction;
}

extern "C" {

void glEnable(GLenum capability)
{
    named<void(GLenum)>("glEnable")(capability);
}
void glBlendFunc(GLenum source, GLenum destination)
{
    named<void(GLenum, GLenum)>("glBlendFunc")(source, destination);
}
void glPolygonMode(GLenum face, GLenum mode)
{
    named<void(GLenum, GLenum)>("glPolygonMode")(face, mode);
}
void glGetDoublev(GLenum name, GLdouble* values)
{
    named<void(GLenum, GLdouble*)>("glGetDoublev")(name, values);
}
void glMatrixMode(GLenum mode)
{
    named<void(GLenum)>("glMatrixMode")(mode);
}
void glPushMatrix()
{
    named<void()>("glPushMatrix")();
}
void glPopMatrix()
{
    named<void()>("glPopMatrix")();
}
void glMultMatrixf(const GLfloat* matrix)
{
    named<void(const GLfloat*)>("glMultMatrixf")(matrix);
}
}
