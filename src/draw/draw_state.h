#pragma once

#include "draw/context_record.h"
#include "draw/programs.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

#include <array>

namespace vo {

/// The state in which the caller wants something drawn: OpenGL's own in a compatibility context, ContextState
/// in a core one.
struct DrawState
{
    glm::dmat4 model{1.0};
    glm::dmat4 projection{1.0};
    glm::mat4 textureMatrix{1.0f};
    glm::vec4 color{1.0f};
    std::array<glm::vec4, 8> clipPlanes{};
    int clipPlaneCount = 0; ///< highest enabled one, and 1
    int voxelUnit = 0;      ///< texture unit in use
    int tableUnit = 1;      ///< another one, for the table
    Texturing texturing = Texturing::none;
    bool oneChannel = false; ///< the bound texture answers with one channel
    bool textureHasAlpha = true;
    bool texgen = false;
    std::array<glm::vec4, 3> texgenPlanes{};
    bool replace = false;         ///< texture environment
    bool flat = false;            ///< shade model
    GLenum polygonMode = GL_FILL; ///< GL_FILL when front and back differ

    /// Alpha is the opacity of a unit of length: a fragment gets that of length(d) / length(sampleGauge * d)
    /// units, d being its line of sight in object space.
    bool opacityPerLength = false;
    glm::mat3 sampleGauge{1.0f};
    glm::vec4 viewer{0.0f}; ///< the eye and 1, or the line of sight and 0
};

/// Switches opacity per length on for samples that lie length(d) / length(gauge * d) apart; nothing happens
/// when the context has no unit length, or the matrices are singular.
void setOpacityPerLength(const ContextRecord& context, const glm::dmat3& gauge, DrawState& state);

DrawState readDrawState(const ContextRecord& context);

/// The part that changes from brick to brick.
void readBoundTexture(const ContextRecord& context, DrawState& state);

} // namespace vo
