#pragma once

#include "screen.h"

#include <memory>

struct GLFWwindow;

/// The only home of GLFW.
namespace vo {

/// A window with a context of OpenGL 3.3 or later, current after open().
class Window
{
public:
    /// Null when there is no display or no such context; whyNot says what was missing.
    static std::unique_ptr<Window> open(const ScreenRequest& request, std::string& whyNot);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Input goes to these, from handleEvents.
    void setCallbacks(const ScreenCallbacks& callbacks) { callbacks_ = callbacks; }
    const GladGLContext& gl() const { return gl_; }
    /// Pixels of the framebuffer.
    void framebufferSize(int& width, int& height) const;
    /// Shows what was drawn.
    void swap();
    /// Waits for input, if asked to, and handles it. False once the window is to be closed.
    bool handleEvents(bool wait);
    bool needsDrawing() const { return needsDrawing_; }

private:
    Window() = default;
    void connectInput();

    GLFWwindow* handle_ = nullptr;
    GladGLContext gl_{};
    ScreenCallbacks callbacks_{};
    bool needsDrawing_ = true;
    bool leaving_ = false;
};

} // namespace vo
