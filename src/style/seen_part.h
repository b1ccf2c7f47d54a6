#pragma once

#include "style/styled_scene.h"

#include <optional>

namespace vo {

/// What a picture shows of a volume: of its box, or the box round its tetrahedra, within its clip planes.
struct SeenPart
{
    /// Eye depths between which it lies.
    double nearest, farthest;
    /// No ray that enters one of its faces and leaves the opposite one has less eye depth in it: faces of the
    /// box, clip planes that face each other, and, as a whole, nearest and farthest.
    double crossing;
};

/// Nothing where the view does not meet it, and for matrices that are singular or not finite.
std::optional<SeenPart> seenPart(const StyledScene& scene, const StyledVolume& volume);

} // namespace vo
