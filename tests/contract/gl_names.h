#pragma once

namespace vo::test {

/// How a function of the current context is found by its name.
using FindFunction = void (*(*)(const char* name))();

/// From now on the plain names of OpenGL lead to what this finds.
void leadOpenGlNames(FindFunction findFunction);

} // namespace vo::test
