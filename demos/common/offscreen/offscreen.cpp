// The loader's functions stay inside this file: a program may hold other copies (libvo does).
#define GLAD_API_CALL static
#define GLAD_GL_IMPLEMENTATION
#include "back_ends.h"

#include <cstdlib>

namespace vo {
namespace {

thread_local const OffscreenContext* loadingFor = nullptr;

GLADapiproc loadFunction(const char* name)
{
    return loadingFor->getProcAddress(name);
}

/// What VO_OFFSCREEN asks for; Any without it. Another word gives a text.
OffscreenBackEnd wantedByEnvironment(std::string& whyNot)
{
    const char* value = std::getenv("VO_OFFSCREEN");
    const std::string word = value ? value : "";
    if (word == "egl") return OffscreenBackEnd::Egl;
    if (word == "osmesa") return OffscreenBackEnd::Osmesa;
    if (!word.empty()) whyNot = "VO_OFFSCREEN is '" + word + "', expected egl or osmesa";
    return OffscreenBackEnd::Any;
}

std::string versionText(int major, int minor)
{
    return std::to_string(major) + "." + std::to_string(minor);
}

bool loadFunctions(const OffscreenContext& context, GladGLContext& gl, const OffscreenRequest& request,
                   std::string& whyNot)
{
    loadingFor = &context;
    const int version = gladLoadGLContext(&gl, loadFunction);
    loadingFor = nullptr;
    const int wanted = GLAD_MAKE_VERSION(request.majorVersion, request.minorVersion);
    if (version >= wanted) return true;
    whyNot = "OpenGL " + versionText(request.majorVersion, request.minorVersion) + " expected, found " +
             versionText(GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version));
    return false;
}

} // namespace

OffscreenContext*& currentOffscreen()
{
    static thread_local OffscreenContext* current = nullptr;
    return current;
}

bool OffscreenContext::makeFramebuffer(const OffscreenRequest& request, std::string& whyNot)
{
    width_ = request.width;
    height_ = request.height;
    const auto attach = [&](GLenum point, GLenum format) {
        GLuint buffer = 0;
        gl_.GenRenderbuffers(1, &buffer);
        gl_.BindRenderbuffer(GL_RENDERBUFFER, buffer);
        gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
        gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, point, GL_RENDERBUFFER, buffer);
    };
    GLint limit = 0;
    gl_.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &limit);
    if (width_ < 1 || height_ < 1 || width_ > limit || height_ > limit) {
        whyNot = "a framebuffer of 1 to " + std::to_string(limit) + " pixels a side expected, found " +
                 std::to_string(width_) + " x " + std::to_string(height_);
        return false;
    }
    gl_.GenFramebuffers(1, &framebuffer_);
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    attach(GL_COLOR_ATTACHMENT0, request.floatColor ? GL_RGBA32F : GL_RGBA8);
    if (request.withStencil) {
        attach(GL_DEPTH_STENCIL_ATTACHMENT, GL_DEPTH24_STENCIL8);
    } else if (request.withDepth) {
        attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
    }
    gl_.BindRenderbuffer(GL_RENDERBUFFER, 0);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        whyNot = "its framebuffer is incomplete";
        return false;
    }
    bindFramebuffer();
    return true;
}

void OffscreenContext::bindFramebuffer() const
{
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.DrawBuffer(GL_COLOR_ATTACHMENT0);
    gl_.ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl_.Viewport(0, 0, width_, height_);
}

void OffscreenContext::clear() const
{
    bindFramebuffer();
    gl_.ClearColor(0, 0, 0, 0);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

std::vector<unsigned char> OffscreenContext::readBytes() const
{
    std::vector<unsigned char> pixels(std::size_t(width_) * std::size_t(height_) * 4);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
}

std::vector<float> OffscreenContext::readFloats() const
{
    std::vector<float> pixels(std::size_t(width_) * std::size_t(height_) * 4);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
    return pixels;
}

std::string OffscreenContext::description() const
{
    const auto text = [this](GLenum name) { return reinterpret_cast<const char*>(gl_.GetString(name)); };
    return std::string(backEnd() == OffscreenBackEnd::Egl ? "EGL" : "OSMesa") + ", " + text(GL_RENDERER) +
           ", " + text(GL_VERSION);
}

std::unique_ptr<OffscreenContext> openOffscreen(const OffscreenRequest& request, std::string* whyNot)
{
    std::string reasons;
    OffscreenBackEnd wanted = request.backEnd;
    if (wanted == OffscreenBackEnd::Any) wanted = wantedByEnvironment(reasons);
    if (reasons.empty()) {
        struct Way
        {
            OffscreenBackEnd backEnd;
            const char* name;
            std::unique_ptr<OffscreenContext> (*open)(const OffscreenRequest&, std::string&);
        };
        for (const Way& way : {Way{OffscreenBackEnd::Egl, "EGL", openEgl},
                               Way{OffscreenBackEnd::Osmesa, "OSMesa", openOsmesa}}) {
            if (wanted != OffscreenBackEnd::Any && wanted != way.backEnd) continue;
            std::string reason;
            auto context = way.open(request, reason);
            if (context && loadFunctions(*context, context->gl_, request, reason) &&
                context->makeFramebuffer(request, reason)) {
                return context;
            }
            reasons += (reasons.empty() ? "" : "; ") + std::string(way.name) + ": " + reason;
        }
    }
    if (whyNot) *whyNot = reasons;
    return nullptr;
}

} // namespace vo
