#pragma once

#include <glad/gl.h>

namespace vo {

/// The context that a SceneDrawer lives in: its functions, and what its driver can.
struct SceneContext
{
    /// Of the context that is current now. Throws std::runtime_error: without one, or if it is older than
    /// OpenGL 3.3.
    SceneContext();

    bool isCurrent() const;

    GladGLContext gl{};
    void* handle = nullptr;
    bool core = false; ///< core profile: no fixed-function state
    /// 8-bit textures are filtered with 8-bit arithmetic: they are stored with 16 bits.
    bool filters8BitTexturesCoarsely = false;
    GLint most3dTexels = 0; ///< along an axis
    GLint mostUnits = 0;    ///< textures that a fragment program may read
};

} // namespace vo
