#pragma once

namespace vo {

using GlFunction = void (*)();
using GetGlFunction = GlFunction (*)(const char* name);

/// The context that is current in this thread, as its window system knows it.
struct PlatformContext
{
    void* handle = nullptr; ///< nullptr: no context is current
    GetGlFunction getFunction = nullptr;
};

/// Asks GLX, EGL, then OSMesa, as far as the process has loaded them; none is loaded here. OSMesa comes last,
/// since it names a current context inside Mesa's GLX and EGL contexts too.
PlatformContext currentPlatformContext();

/// Functions of contexts that the three above know nothing of come from here; nullptr goes back to asking
/// them.
void setGetGlFunction(GetGlFunction getFunction);

} // namespace vo
