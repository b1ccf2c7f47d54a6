// The loader's functions stay inside this file: a program may hold other copies (libvo does).
#define GLAD_API_CALL static
#define GLAD_GL_IMPLEMENTATION
#include "window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cctype>

namespace vo {
namespace {

/// The text of GLFW's last error.
std::string lastError()
{
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

Window& owner(GLFWwindow* handle)
{
    return *static_cast<Window*>(glfwGetWindowUserPointer(handle));
}

bool toButton(int button, Button& result)
{
    switch (button) {
    case GLFW_MOUSE_BUTTON_LEFT: result = Button::Left; return true;
    case GLFW_MOUSE_BUTTON_MIDDLE: result = Button::Middle; return true;
    case GLFW_MOUSE_BUTTON_RIGHT: result = Button::Right; return true;
    default: return false;
    }
}

} // namespace

std::unique_ptr<Window> Window::open(const ScreenRequest& request, std::string& whyNot)
{
    if (!glfwInit()) {
        whyNot = lastError();
        return nullptr;
    }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, request.core ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_COMPAT_PROFILE);
    std::unique_ptr<Window> window(new Window);
    window->handle_ =
        glfwCreateWindow(request.width, request.height, request.program.c_str(), nullptr, nullptr);
    if (!window->handle_) {
        whyNot = lastError();
        return nullptr;
    }
    glfwMakeContextCurrent(window->handle_);
    // Timed frames do not wait for the display.
    glfwSwapInterval(request.frames > 0 ? 0 : 1);
    if (gladLoadGLContext(&window->gl_, glfwGetProcAddress) < GLAD_MAKE_VERSION(3, 3)) {
        whyNot = "OpenGL 3.3 expected, found less";
        return nullptr;
    }
    window->connectInput();
    return window;
}

Window::~Window()
{
    if (handle_) glfwDestroyWindow(handle_);
    glfwTerminate();
}

void Window::connectInput()
{
    glfwSetWindowUserPointer(handle_, this);
    glfwSetFramebufferSizeCallback(handle_,
                                   [](GLFWwindow* handle, int, int) { owner(handle).needsDrawing_ = true; });
    glfwSetWindowRefreshCallback(handle_, [](GLFWwindow* handle) { owner(handle).needsDrawing_ = true; });
    glfwSetKeyCallback(handle_, [](GLFWwindow* handle, int key, int, int action, int) {
        Window& window = owner(handle);
        if (action != GLFW_PRESS || !window.callbacks_.key) return;
        if (key == GLFW_KEY_ESCAPE) key = kEscapeKey;
        if (key < 128 && !window.callbacks_.key(std::tolower(key))) window.leaving_ = true;
        window.needsDrawing_ = true;
    });
    glfwSetMouseButtonCallback(handle_, [](GLFWwindow* handle, int button, int action, int) {
        Window& window = owner(handle);
        Button pressed{};
        const auto call = action == GLFW_PRESS ? window.callbacks_.press : window.callbacks_.release;
        if (!toButton(button, pressed) || !call) return;
        double x = 0, y = 0;
        glfwGetCursorPos(handle, &x, &y);
        int width = 0, height = 0;
        glfwGetWindowSize(handle, &width, &height);
        call(pressed, x, y, width, height);
        window.needsDrawing_ = true;
    });
    glfwSetCursorPosCallback(handle_, [](GLFWwindow* handle, double x, double y) {
        Window& window = owner(handle);
        int width = 0, height = 0;
        glfwGetWindowSize(handle, &width, &height);
        bool isHeld = false;
        for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_3; ++button) {
            Button held{};
            if (glfwGetMouseButton(handle, button) != GLFW_PRESS || !toButton(button, held)) continue;
            isHeld = true;
            if (window.callbacks_.drag) window.callbacks_.drag(held, x, y, width, height);
            window.needsDrawing_ = true;
        }
        if (isHeld || !window.callbacks_.hover) return;
        window.callbacks_.hover(x, y, width, height);
        window.needsDrawing_ = true;
    });
    glfwSetScrollCallback(handle_, [](GLFWwindow* handle, double, double steps) {
        Window& window = owner(handle);
        if (!window.callbacks_.scroll) return;
        window.callbacks_.scroll(steps);
        window.needsDrawing_ = true;
    });
}

void Window::framebufferSize(int& width, int& height) const
{
    glfwGetFramebufferSize(handle_, &width, &height);
}

void Window::swap()
{
    needsDrawing_ = false;
    glfwSwapBuffers(handle_);
}

bool Window::handleEvents(bool wait)
{
    wait ? glfwWaitEvents() : glfwPollEvents();
    return !leaving_ && !glfwWindowShouldClose(handle_);
}

} // namespace vo
