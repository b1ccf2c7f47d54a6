#pragma once

#include "draw/brick_texture.h"
#include "draw/context_record.h"

namespace vo {

// Texturing of what is drawn next: OpenGL's own state in a compatibility context, where polygons of the
// application see it too, ContextState in a core one.

/// Two- or three-dimensional textures on or off.
void enableTexturing(ContextRecord& context, bool twoDimensional, bool enabled);

/// Coordinates from the position, by the planes set last.
void enableTexgen(ContextRecord& context, bool enabled);
void setTexgenPlanes(ContextRecord& context, const TexgenPlanes& planes);

} // namespace vo
