#pragma once

#include "style/style.h"
#include "style/styled_scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace vo {

bool asksForShadows(const StyleChain& chain);
/// The chain with shadows for all styles that ask for them.
StyleChain chainWithShadows(const StyleChain& chain, const ShadowTextures& textures);

/// Shadows of volumes, each computed once as long as voxels, chains and lights stay the same.
class ShadowStore
{
public:
    ShadowStore();
    ~ShadowStore();

    /// Gives textures to the styles of the volume that ask for shadows: those that the volume throws on
    /// itself, of its first eight lights. In up to `threads` threads (0: the usual number). Throws
    /// std::bad_alloc.
    void add(StyledVolume& volume, int threads);

private:
    struct Kept;
    Kept& keptFor(const StyledVolume& volume, int threads);

    std::vector<std::unique_ptr<Kept>> kept_; ///< the latest last
};

} // namespace vo
