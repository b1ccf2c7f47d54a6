#pragma once

#include "draw/volume_layers.h"

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace vo {

/// What is drawn at once: layers of one thing that follow each other, or what of a layer that reaches over
/// depths lies between two of them.
struct SceneStep
{
    std::size_t drawn; ///< number of the thing
    SliceLayer layer;
    double nearest = -std::numeric_limits<double>::infinity();
    double farthest = std::numeric_limits<double>::infinity();

    bool isWhole() const;
    /// What is drawn lies there, or behind.
    double depth() const;
    /// Whether one draw does for this and the next one, which this then is.
    bool join(const SceneStep& next);
};

/// The layers of each thing, in the order of the scene.
using LayerLists = std::vector<std::span<const SliceLayer>>;

/// Depths between which what several things have is drawn one thing after the other: all layers begin at one
/// of them. There are at least 512 where two things reach over depths: things that cross are out of order
/// between two borders alone.
std::vector<double> stepBorders(const LayerLists& lists);

/// All steps, the farthest first, divided at borders, which rise. At one depth what reaches behind it is
/// behind, then what comes later in the scene.
std::vector<SceneStep> sceneSteps(const LayerLists& lists, std::span<const double> borders);

} // namespace vo
