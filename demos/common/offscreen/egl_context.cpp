// Without this the headers pull in Xlib. They come before the OpenGL loader's, which defines less of what
// they share.
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "back_ends.h"

#include <array>
#include <cstring>
#include <type_traits>

namespace vo {
namespace {

struct EglLibrary
{
    decltype(&eglGetProcAddress) getProcAddress = nullptr;
    decltype(&eglQueryString) queryString = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglBindAPI) bindApi = nullptr;
    decltype(&eglChooseConfig) chooseConfig = nullptr;
    decltype(&eglCreateContext) createContext = nullptr;
    decltype(&eglDestroyContext) destroyContext = nullptr;
    decltype(&eglMakeCurrent) makeCurrent = nullptr;
    PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay = nullptr;
    PFNEGLQUERYDEVICESEXTPROC queryDevices = nullptr;
    PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString = nullptr;
    std::string whyNot;
};

/// Whether `word` is one of the words of `list`.
bool hasWord(const char* list, const char* word)
{
    const std::size_t length = std::strlen(word);
    for (const char* at = list ? std::strstr(list, word) : nullptr; at; at = std::strstr(at + 1, word)) {
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == 0)) return true;
    }
    return false;
}

EglLibrary loadLibrary()
{
    EglLibrary library;
    void* handle = dlopen("libEGL.so.1", RTLD_LAZY | RTLD_LOCAL);
    if (!handle) {
        library.whyNot = "libEGL.so.1 is not installed";
        return library;
    }
    const bool complete = findFunction(handle, "eglGetProcAddress", library.getProcAddress) &&
                          findFunction(handle, "eglQueryString", library.queryString) &&
                          findFunction(handle, "eglInitialize", library.initialize) &&
                          findFunction(handle, "eglBindAPI", library.bindApi) &&
                          findFunction(handle, "eglChooseConfig", library.chooseConfig) &&
                          findFunction(handle, "eglCreateContext", library.createContext) &&
                          findFunction(handle, "eglDestroyContext", library.destroyContext) &&
                          findFunction(handle, "eglMakeCurrent", library.makeCurrent);
    if (!complete || !hasWord(library.queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_platform_base")) {
        library.whyNot = "libEGL is too old: EGL_EXT_platform_base expected";
        return library;
    }
    const auto extension = [&](const char* name, auto& function) {
        function =
            reinterpret_cast<std::remove_reference_t<decltype(function)>>(library.getProcAddress(name));
    };
    extension("eglGetPlatformDisplayEXT", library.getPlatformDisplay);
    extension("eglQueryDevicesEXT", library.queryDevices);
    extension("eglQueryDeviceStringEXT", library.queryDeviceString);
    return library;
}

/// Never unloaded, and its displays never closed: contexts and OpenGL functions may outlive any scope.
const EglLibrary& egl()
{
    static const EglLibrary library = loadLibrary();
    return library;
}

/// A display that can have contexts of OpenGL without a surface.
bool initialize(EGLDisplay display)
{
    return display != EGL_NO_DISPLAY && egl().initialize(display, nullptr, nullptr) &&
           hasWord(egl().queryString(display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
}

EGLDisplay openDevice(bool software)
{
    if (!hasWord(egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_EXT_platform_device") ||
        !egl().queryDevices || !egl().queryDeviceString) {
        return EGL_NO_DISPLAY;
    }
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (!egl().queryDevices(EGLint(devices.size()), devices.data(), &count)) return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count; ++i) {
        const EGLDeviceEXT device = devices[std::size_t(i)];
        const bool isSoftware =
            hasWord(egl().queryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
        if (isSoftware != software) continue;
        const EGLDisplay display = egl().getPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
        if (initialize(display)) return display;
    }
    return EGL_NO_DISPLAY;
}

EGLDisplay openSurfaceless()
{
    if (!hasWord(egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless")) {
        return EGL_NO_DISPLAY;
    }
    const EGLDisplay display =
        egl().getPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    return initialize(display) ? display : EGL_NO_DISPLAY;
}

/// A GPU where there is one, else Mesa without a device, else Mesa's software device.
EGLDisplay openDisplay()
{
    EGLDisplay display = openDevice(false);
    if (display == EGL_NO_DISPLAY) display = openSurfaceless();
    if (display == EGL_NO_DISPLAY) display = openDevice(true);
    return display;
}

EGLDisplay eglDisplay()
{
    static const EGLDisplay display = openDisplay();
    return display;
}

class EglContext final : public OffscreenContext
{
public:
    explicit EglContext(EGLContext handle) : handle_(handle) {}
    ~EglContext() override
    {
        release();
        egl().destroyContext(eglDisplay(), handle_);
    }

    bool makeCurrent() override
    {
        if (currentOffscreen() == this) return true;
        if (currentOffscreen() && currentOffscreen()->backEnd() != backEnd()) currentOffscreen()->release();
        if (!egl().makeCurrent(eglDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, handle_)) return false;
        currentOffscreen() = this;
        return true;
    }
    void release() override
    {
        if (currentOffscreen() != this) return;
        egl().makeCurrent(eglDisplay(), EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        currentOffscreen() = nullptr;
    }
    GLADapiproc getProcAddress(const char* name) const override { return egl().getProcAddress(name); }
    OffscreenBackEnd backEnd() const override { return OffscreenBackEnd::Egl; }

private:
    EGLContext handle_;
};

/// EGL_NO_CONFIG_KHR where that is known, else the first configuration for OpenGL.
EGLConfig chooseConfig()
{
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (hasWord(egl().queryString(eglDisplay(), EGL_EXTENSIONS), "EGL_KHR_no_config_context")) return config;
    const std::array<EGLint, 5> attributes{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                           EGL_OPENGL_BIT, EGL_NONE};
    EGLint count = 0;
    egl().chooseConfig(eglDisplay(), attributes.data(), &config, 1, &count);
    return config;
}

} // namespace

std::unique_ptr<OffscreenContext> openEgl(const OffscreenRequest& request, std::string& whyNot)
{
    if (!egl().whyNot.empty()) {
        whyNot = egl().whyNot;
        return nullptr;
    }
    if (eglDisplay() == EGL_NO_DISPLAY) {
        whyNot = "no device or surfaceless display";
        return nullptr;
    }
    const bool core = request.profile == OffscreenProfile::Core;
    const std::array<EGLint, 7> attributes{EGL_CONTEXT_MAJOR_VERSION,
                                           request.majorVersion,
                                           EGL_CONTEXT_MINOR_VERSION,
                                           request.minorVersion,
                                           EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                           core ? EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT
                                                : EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
                                           EGL_NONE};
    const EGLContext handle =
        egl().bindApi(EGL_OPENGL_API)
            ? egl().createContext(eglDisplay(), chooseConfig(), EGL_NO_CONTEXT, attributes.data())
            : EGL_NO_CONTEXT;
    if (handle == EGL_NO_CONTEXT) {
        whyNot = "no context of the version and profile asked for";
        return nullptr;
    }
    auto context = std::make_unique<EglContext>(handle);
    if (context->makeCurrent()) return context;
    whyNot = "its context cannot be made current";
    return nullptr;
}

} // namespace vo
