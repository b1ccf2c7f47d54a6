#pragma once

#include "offscreen.h"

#include <dlfcn.h>

namespace vo {

/// Each opens a context and makes it current; gl() is not loaded yet. Null and a text when it cannot.
std::unique_ptr<OffscreenContext> openEgl(const OffscreenRequest& request, std::string& whyNot);
std::unique_ptr<OffscreenContext> openOsmesa(const OffscreenRequest& request, std::string& whyNot);

/// The context that is current in this thread, whichever its back end. EGL and OSMesa share Mesa's dispatch
/// table: each lets go of the other's context before it takes over.
OffscreenContext*& currentOffscreen();

/// The function `name` of a library opened with dlopen; false when it is not there.
template <typename Function>
bool findFunction(void* library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(dlsym(library, name));
    return function != nullptr;
}

} // namespace vo
