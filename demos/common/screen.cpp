#include "screen.h"

#include "offscreen/offscreen.h"
#include "volume_view/frame_names.h"
#include "volume_view/picture.h"
#include "window.h"

#include <vo/FloatTarget.h>

#include <csignal>
#include <cstdio>
#include <memory>
#include <vector>

namespace vo {
namespace {

int fail(const ScreenRequest& request, const std::string& reason)
{
    std::fprintf(stderr, "%s: %s\n", request.program.c_str(), reason.c_str());
    return 1;
}

/// One frame into the target, and from there onto whatever framebuffer is bound.
bool drawFrame(const ScreenCallbacks& callbacks, voFloatTarget& target)
{
    target.begin();
    const bool drawn = callbacks.draw(target.getWidth(), target.getHeight());
    target.end();
    if (drawn) target.show(0, 0);
    return drawn;
}

/// Draws the frames and writes those that `output` asks for; the reason is printed when it cannot.
bool drawAndWrite(const ScreenRequest& request, const ScreenCallbacks& callbacks, const std::string& output)
{
    std::vector<float> pixels(std::size_t(request.width) * std::size_t(request.height) * 4);
    voFloatTarget target(request.width, request.height);
    const int count = std::max(request.frames, 1);
    for (int frame = 1; frame <= count; ++frame) {
        if (!drawFrame(callbacks, target)) return false;
        if (output.empty() || (frame < count && !isNumbered(output))) continue;
        target.readPixels(pixels.data());
        const std::string name = frameName(output, request.frames, frame % count);
        if (const auto written = writePicture(name, request.width, request.height, pixels); !written)
            return fail(request, written.failure().text) == 0;
    }
    return true;
}

int showWithoutWindow(const ScreenRequest& request, const ScreenCallbacks& callbacks,
                      const std::string& output)
{
    std::string whyNot;
    const auto context =
        openOffscreen({.profile = request.core ? OffscreenProfile::Core : OffscreenProfile::Compatibility,
                       .width = request.width,
                       .height = request.height},
                      &whyNot);
    if (!context) return fail(request, "no OpenGL without a window: " + whyNot);
    // Past the largest size of a file that is allowed writing then fails, and cleans up, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    gl = &context->gl();
    callbacks.initialize();
    const bool done = drawAndWrite(request, callbacks, output);
    callbacks.cleanup();
    return done ? 0 : 1;
}

/// Draws into the window until it is closed, or `frames` frames were drawn.
bool runWindow(Window& window, const ScreenRequest& request, const ScreenCallbacks& callbacks)
{
    std::unique_ptr<voFloatTarget> target;
    int frames = 0;
    while (window.handleEvents(!window.needsDrawing() && request.frames == 0)) {
        int width = 0, height = 0;
        window.framebufferSize(width, height);
        // An iconified window has no pixels.
        if (width < 1 || height < 1 || (!window.needsDrawing() && request.frames == 0)) continue;
        if (!target || target->getWidth() != width || target->getHeight() != height)
            target = std::make_unique<voFloatTarget>(width, height);
        if (!drawFrame(callbacks, *target)) return false;
        window.swap();
        if (++frames == request.frames) break;
    }
    return true;
}

int showInWindow(Window& window, const ScreenRequest& request, const ScreenCallbacks& callbacks)
{
    gl = &window.gl();
    callbacks.initialize();
    window.setCallbacks(callbacks);
    const bool drawn = runWindow(window, request, callbacks);
    callbacks.cleanup();
    return drawn ? 0 : 1;
}

} // namespace

int showOnScreen(const ScreenRequest& request, const ScreenCallbacks& callbacks)
{
    if (!request.output.empty()) return showWithoutWindow(request, callbacks, request.output);
    std::string whyNot;
    if (const auto window = Window::open(request, whyNot)) return showInWindow(*window, request, callbacks);
    const std::string output = request.frames > 0 ? "" : request.program + ".png";
    std::fprintf(stderr, "%s: no window (%s); drawing without one%s\n", request.program.c_str(),
                 whyNot.c_str(), output.empty() ? "" : (" into " + output).c_str());
    return showWithoutWindow(request, callbacks, output);
}

} // namespace vo
