#include "back_ends.h"

#include <array>

namespace vo {
namespace {

// The few entries and constants of OSMesa's interface that are used here: its header needs a package of its
// own.
using OsmesaHandle = struct osmesa_context*;
constexpr int kOsmesaFormat = 0x22;
constexpr int kOsmesaRgba = 0x1908;
constexpr int kOsmesaProfile = 0x33;
constexpr int kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaCompatProfile = 0x35;
constexpr int kOsmesaMajorVersion = 0x36;
constexpr int kOsmesaMinorVersion = 0x37;

struct OsmesaLibrary
{
    OsmesaHandle (*createContextAttribs)(const int* attributes, OsmesaHandle share) = nullptr;
    void (*destroyContext)(OsmesaHandle context) = nullptr;
    GLboolean (*makeCurrent)(OsmesaHandle context, void* buffer, GLenum type, GLsizei width,
                             GLsizei height) = nullptr;
    GLADapiproc (*getProcAddress)(const char* name) = nullptr;
    std::string whyNot;
};

OsmesaLibrary loadLibrary()
{
    OsmesaLibrary library;
    void* handle = nullptr;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        if (!handle) handle = dlopen(name, RTLD_LAZY | RTLD_LOCAL);
    }
    if (!handle) {
        library.whyNot = "libOSMesa.so.8 is not installed";
    } else if (!findFunction(handle, "OSMesaCreateContextAttribs", library.createContextAttribs) ||
               !findFunction(handle, "OSMesaDestroyContext", library.destroyContext) ||
               !findFunction(handle, "OSMesaMakeCurrent", library.makeCurrent) ||
               !findFunction(handle, "OSMesaGetProcAddress", library.getProcAddress)) {
        library.whyNot = "libOSMesa is too old: OSMesaCreateContextAttribs expected";
    }
    return library;
}

/// Never unloaded: contexts and OpenGL functions may outlive any scope.
const OsmesaLibrary& osmesa()
{
    static const OsmesaLibrary library = loadLibrary();
    return library;
}

class OsmesaContext final : public OffscreenContext
{
public:
    explicit OsmesaContext(OsmesaHandle handle) : handle_(handle) {}
    ~OsmesaContext() override
    {
        release();
        osmesa().destroyContext(handle_);
    }

    bool makeCurrent() override
    {
        if (currentOffscreen() == this) return true;
        if (currentOffscreen()) currentOffscreen()->release();
        if (!osmesa().makeCurrent(handle_, buffer_.data(), GL_UNSIGNED_BYTE, kSide, kSide)) return false;
        currentOffscreen() = this;
        return true;
    }
    void release() override
    {
        if (currentOffscreen() != this) return;
        osmesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        currentOffscreen() = nullptr;
    }
    GLADapiproc getProcAddress(const char* name) const override { return osmesa().getProcAddress(name); }
    OffscreenBackEnd backEnd() const override { return OffscreenBackEnd::Osmesa; }

private:
    /// OSMesa wants a framebuffer 0 in memory; nobody draws into it.
    static constexpr int kSide = 4;

    OsmesaHandle handle_;
    std::array<unsigned char, 4 * kSide * kSide> buffer_{};
};

} // namespace

std::unique_ptr<OffscreenContext> openOsmesa(const OffscreenRequest& request, std::string& whyNot)
{
    if (!osmesa().whyNot.empty()) {
        whyNot = osmesa().whyNot;
        return nullptr;
    }
    const bool core = request.profile == OffscreenProfile::Core;
    const std::array<int, 9> attributes{kOsmesaFormat,
                                        kOsmesaRgba,
                                        kOsmesaProfile,
                                        core ? kOsmesaCoreProfile : kOsmesaCompatProfile,
                                        kOsmesaMajorVersion,
                                        request.majorVersion,
                                        kOsmesaMinorVersion,
                                        request.minorVersion,
                                        0};
    const OsmesaHandle handle = osmesa().createContextAttribs(attributes.data(), nullptr);
    if (!handle) {
        whyNot = "no context of the version and profile asked for";
        return nullptr;
    }
    auto context = std::make_unique<OsmesaContext>(handle);
    if (context->makeCurrent()) return context;
    whyNot = "its context cannot be made current";
    return nullptr;
}

} // namespace vo
