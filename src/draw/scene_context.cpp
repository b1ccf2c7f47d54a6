// The loader's functions stay inside this file: a program may hold other copies (libvo does).
#define GLAD_API_CALL static
#define GLAD_GL_IMPLEMENTATION
#include "draw/scene_context.h"

#include "draw/platform_context.h"

#include <cstring>
#include <stdexcept>
#include <string>

namespace vo {

namespace {

GLADapiproc loadFunction(void* getFunction, const char* name)
{
    return reinterpret_cast<GLADapiproc>(reinterpret_cast<GetGlFunction>(getFunction)(name));
}

} // namespace

SceneContext::SceneContext()
{
    const PlatformContext platform = currentPlatformContext();
    if (!platform.handle) throw std::runtime_error("no OpenGL context is current");
    handle = platform.handle;
    const int version =
        gladLoadGLContextUserPtr(&gl, loadFunction, reinterpret_cast<void*>(platform.getFunction));
    if (version < GLAD_MAKE_VERSION(3, 3))
        throw std::runtime_error("the current context has OpenGL " +
                                 std::to_string(GLAD_VERSION_MAJOR(version)) + "." +
                                 std::to_string(GLAD_VERSION_MINOR(version)) + ", 3.3 or later is needed");
    GLint profile = 0;
    gl.GetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    core = (profile & GL_CONTEXT_COMPATIBILITY_PROFILE_BIT) == 0;
    // Mesa's software rasteriser takes an 8-bit path for such textures: 11 values over a ramp where 256 are
    // right.
    const char* renderer = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    filters8BitTexturesCoarsely = renderer && std::strstr(renderer, "llvmpipe");
    gl.GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &most3dTexels);
    gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &mostUnits);
}

bool SceneContext::isCurrent() const
{
    return currentPlatformContext().handle == handle;
}

} // namespace vo
