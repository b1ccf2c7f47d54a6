// Prints which OpenGL the tests get: back end, renderer, version.

#include "offscreen/offscreen.h"

#include <cstdio>

int main()
{
    std::string whyNot;
    const auto context = vo::openOffscreen({}, &whyNot);
    if (!context) {
        std::fprintf(stderr, "print_renderer: %s\n", whyNot.c_str());
        return 1;
    }
    std::printf("%s\nGL_RENDERER %s\n", context->description().c_str(),
                reinterpret_cast<const char*>(context->gl().GetString(GL_RENDERER)));
}
