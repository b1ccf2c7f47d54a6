#include "draw/platform_context.h"

#include <atomic>
#include <cstddef>
#include <dlfcn.h>
#include <link.h>

namespace vo {

namespace {

using GetCurrent = void* (*)();

/// How often this process has loaded a library.
unsigned long long librariesLoaded()
{
    unsigned long long count = 0;
    dl_iterate_phdr(
        [](dl_phdr_info* info, std::size_t, void* target) {
            *static_cast<unsigned long long*>(target) = info->dlpi_adds;
            return 1; // the first one says it
        },
        &count);
    return count;
}

std::atomic<GetGlFunction> applicationFunctions{nullptr};

/// One window system's library, used only if the process has loaded it already.
class Platform
{
public:
    constexpr Platform(const char* library, const char* getCurrent, const char* getFunction)
        : library_(library), getCurrentName_(getCurrent), getFunctionName_(getFunction)
    {
    }

    PlatformContext current(unsigned long long librariesLoaded)
    {
        if (!ready_.load(std::memory_order_acquire) && !resolve(librariesLoaded)) return {};
        void* handle = getCurrent_.load(std::memory_order_relaxed)();
        return handle ? PlatformContext{handle, getFunction_.load(std::memory_order_relaxed)}
                      : PlatformContext{};
    }

private:
    /// Frames ask more than once, and dlopen looks for the file each time: only where it may be there now.
    bool resolve(unsigned long long librariesLoaded)
    {
        if (absentAt_.load(std::memory_order_relaxed) == librariesLoaded) return false;
        // Keeping the handle keeps the library, and so the two pointers.
        void* handle = dlopen(library_, RTLD_NOLOAD | RTLD_LAZY);
        if (!handle) {
            absentAt_.store(librariesLoaded, std::memory_order_relaxed);
            return false;
        }
        auto getCurrent = reinterpret_cast<GetCurrent>(dlsym(handle, getCurrentName_));
        auto getFunction = reinterpret_cast<GetGlFunction>(dlsym(handle, getFunctionName_));
        if (!getCurrent || !getFunction) return false;
        getCurrent_ = getCurrent;
        getFunction_ = getFunction;
        ready_.store(true, std::memory_order_release);
        return true;
    }

    const char* library_;
    const char* getCurrentName_;
    const char* getFunctionName_;
    std::atomic<bool> ready_{false};
    std::atomic<unsigned long long> absentAt_{0}; ///< how many libraries were loaded when it was not there
    std::atomic<GetCurrent> getCurrent_{nullptr};
    std::atomic<GetGlFunction> getFunction_{nullptr};
};

Platform glx("libGLX.so.0", "glXGetCurrentContext", "glXGetProcAddressARB");
Platform glxInLibGl("libGL.so.1", "glXGetCurrentContext", "glXGetProcAddressARB");
Platform egl("libEGL.so.1", "eglGetCurrentContext", "eglGetProcAddress");
Platform osmesa8("libOSMesa.so.8", "OSMesaGetCurrentContext", "OSMesaGetProcAddress");
Platform osmesa6("libOSMesa.so.6", "OSMesaGetCurrentContext", "OSMesaGetProcAddress");

} // namespace

PlatformContext currentPlatformContext()
{
    if (GetGlFunction own = applicationFunctions.load()) return {reinterpret_cast<void*>(own), own};
    const unsigned long long loaded = librariesLoaded();
    for (Platform* platform : {&glx, &glxInLibGl, &egl, &osmesa8, &osmesa6})
        if (const PlatformContext context = platform->current(loaded); context.handle) return context;
    return {};
}

void setGetGlFunction(GetGlFunction getFunction)
{
    applicationFunctions = getFunction;
}

} // namespace vo
