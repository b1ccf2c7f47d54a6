#pragma once

#include "gl.h"

#include <string>

/// Where the frames of a program go: a window, or a picture drawn without one. Both are drawn into a target
/// of 32-bit floats first (voFloatTarget), so that many faint slices add up to the same.
namespace vo {

enum class Button { Left, Middle, Right };

/// The key codes are ASCII, letters in lower case.
constexpr int kEscapeKey = 27;

/// What the program does when its screen asks. The first three are needed. The context is current, and
/// `gl` leads to it.
struct ScreenCallbacks
{
    /// Once, before the first frame.
    void (*initialize)();
    /// One frame of width x height pixels into the framebuffer that is bound, which holds anything. False: it
    /// cannot be drawn, the reason was printed.
    bool (*draw)(int width, int height);
    /// Once, at the end.
    void (*cleanup)();
    /// Positions in a window of width x height (not pixels where the display is dense), from its upper left
    /// corner.
    void (*press)(Button button, double x, double y, int width, int height) = nullptr;
    void (*drag)(Button button, double x, double y, int width, int height) = nullptr;
    /// False: leave.
    bool (*key)(int key) = nullptr;
    /// The button is let go; only windows tell this and what follows.
    void (*release)(Button button, double x, double y, int width, int height) = nullptr;
    /// The pointer is moved without a button.
    void (*hover)(double x, double y, int width, int height) = nullptr;
    /// The wheel is turned, upwards above 0.
    void (*scroll)(double steps) = nullptr;
};

struct ScreenRequest
{
    /// The program's name, for messages and the window's title.
    std::string program;
    int width = 512;
    int height = 512;
    /// A context of the core profile instead of the compatibility profile.
    bool core = false;
    /// The picture to write, without a window; with `frames`, a name with a %d gets a picture of each frame,
    /// any other the last one. Empty: a window; where there is no display, PROGRAM.png, or with `frames`
    /// none.
    std::string output;
    /// How many frames are drawn before it ends; 0: a window stays until it is closed, a picture takes one.
    /// The last one is number 0: a turn ends where it began.
    int frames = 0;
};

/// Runs the program to its end. The exit status: 0, or 1 after one line on stderr that says why.
int showOnScreen(const ScreenRequest& request, const ScreenCallbacks& callbacks);

} // namespace vo
