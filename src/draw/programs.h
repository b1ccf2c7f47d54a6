#pragma once

#include "draw/context_record.h"
#include "draw/link_program.h"

#include <string>

namespace vo {

enum class Texturing { none, twoDimensional, threeDimensional };
/// What becomes of texture colour and fragment colour: OpenGL's GL_MODULATE, or GL_REPLACE, which keeps the
/// fragment's alpha where the texture has none.
enum class TextureEnvironment { modulate, replace, replaceColorOnly };
/// Post-interpolation lookup: each component in its own column, or all four with red.
enum class Lookup { none, perComponent, byRed };

/// Which of the programs a draw needs.
struct ProgramVariant
{
    Texturing texturing = Texturing::none;
    bool texgen = false;            ///< coordinates from the position
    bool projectiveTexture = false; ///< the texture matrix is not affine
    bool vertexColor = false;       ///< else the current colour
    bool flat = false;
    TextureEnvironment environment = TextureEnvironment::modulate;
    Lookup lookup = Lookup::none;
    bool filteredLookup = false; ///< by the driver's linear filter
    int clipDistances = 0;       ///< planes 0 to n - 1 are computed
    bool opacityPerLength = false;

    unsigned key() const;
};

/// Vertex attributes of every program.
enum AttributeLocation : GLuint { kPosition = 0, kColor = 1, kTexCoord = 2 };

/// What the shaders of a variant begin with: #version, and its choices (TEXTURED, COORDINATES, ...).
std::string programDefinitions(const ProgramVariant& variant);
/// GLSL for fragment shaders that draw a texture: its uniforms `voxels` and `table`, and vec4 shade(vec4
/// sampled, vec4 color), what becomes of a sample.
extern const char* const kShading;

/// The linked program, compiled on first use in this context.
const Program& programFor(ContextRecord& context, const ProgramVariant& variant);

} // namespace vo
