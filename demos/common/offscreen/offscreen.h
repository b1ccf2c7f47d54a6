#pragma once

#include <glad/gl.h>

#include <memory>
#include <string>
#include <vector>

/// OpenGL without a window: one interface, two back ends (EGL and OSMesa), each found at run time by dlopen,
/// so that a program starts where neither is installed. Shared by the demos and the tests.
namespace vo {

enum class OffscreenProfile { Core, Compatibility };

/// Any: what the environment variable VO_OFFSCREEN (egl or osmesa) names; without it EGL where that gives a
/// context, else OSMesa.
enum class OffscreenBackEnd { Any, Egl, Osmesa };

struct OffscreenRequest
{
    OffscreenProfile profile = OffscreenProfile::Compatibility;
    /// The least version that will do; the context may have a higher one.
    int majorVersion = 3;
    int minorVersion = 3;
    OffscreenBackEnd backEnd = OffscreenBackEnd::Any;
    /// Pixels of the framebuffer, each at least 1.
    int width = 256;
    int height = 256;
    /// RGBA32F instead of RGBA8.
    bool floatColor = false;
    bool withDepth = true;
    bool withStencil = true;
};

/// A context and a framebuffer of its own, of the size asked for; framebuffer 0 is not there or of no use.
/// A context belongs to the thread that made it current; a thread may have several and switch between them.
class OffscreenContext
{
public:
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// The framebuffer binding stays as it was when the context was last current.
    virtual bool makeCurrent() = 0;
    /// No context is current in this thread afterwards, if it was this one.
    virtual void release() = 0;
    virtual GLADapiproc getProcAddress(const char* name) const = 0;
    virtual OffscreenBackEnd backEnd() const = 0;

    /// OpenGL's functions in this context.
    const GladGLContext& gl() const { return gl_; }
    /// The framebuffer object; bound and covered by the viewport after openOffscreen.
    GLuint framebuffer() const { return framebuffer_; }
    void bindFramebuffer() const;
    /// Makes it transparent black, and as deep as can be.
    void clear() const;
    int width() const { return width_; }
    int height() const { return height_; }

    /// width * height * 4 values of the framebuffer, red green blue alpha, rows from the bottom.
    std::vector<unsigned char> readBytes() const;
    std::vector<float> readFloats() const;

    /// Back end, renderer and version, for messages.
    std::string description() const;

protected:
    OffscreenContext() = default;

    GladGLContext gl_{};

private:
    friend std::unique_ptr<OffscreenContext> openOffscreen(const OffscreenRequest&, std::string*);
    bool makeFramebuffer(const OffscreenRequest& request, std::string& whyNot);

    GLuint framebuffer_ = 0;
    int width_ = 0;
    int height_ = 0;
};

/// Opens a context and makes it current, with its framebuffer bound. Null when no back end gives one: whyNot,
/// if given, then says for each what was missing.
std::unique_ptr<OffscreenContext> openOffscreen(const OffscreenRequest& request,
                                                std::string* whyNot = nullptr);

} // namespace vo
