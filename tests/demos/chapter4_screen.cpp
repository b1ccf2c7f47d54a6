#include "offscreen/offscreen.h"

#include "chapter4_screen.h"
#include "volume_view/picture.h"

#include <cstdio>
#include <memory>

static std::unique_ptr<vo::OffscreenContext> screen;

bool openScreen(int width, int height)
{
    std::string whyNot;
    // Plain OpenGL names lead to libGL, which knows the contexts of EGL and GLX only.
    screen = vo::openOffscreen(
        {.backEnd = vo::OffscreenBackEnd::Egl, .width = width, .height = height, .floatColor = true},
        &whyNot);
    if (!screen) std::fprintf(stderr, "%s\n", whyNot.c_str());
    return screen != nullptr;
}

bool writeScreen(const char* path)
{
    const auto written = vo::writePicture(path, screen->width(), screen->height(), screen->readFloats());
    if (!written) std::fprintf(stderr, "%s\n", written.failure().text.c_str());
    screen.reset();
    return bool(written);
}
