#include "vorender_depth.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vo {
namespace {

/// Halvings of the range of depths: as fine as floats near 1.
constexpr int kRounds = 24;

/// Whether a pixel shows what is looked for. `whole` has everything in it, `part` what lies before a depth.
bool isReached(CastBlending blending, const float* whole, const float* part)
{
    if (blending == CastBlending::over) return part[3] <= 0.5f;
    return std::equal(part, part + 4, whole, [](float a, float b) { return a >= b; });
}

/// Whether there is anything to find in a pixel.
bool hasAny(CastBlending blending, const float* whole)
{
    if (blending == CastBlending::over) return whole[3] <= 0.5f;
    return std::any_of(whole, whole + 4, [](float value) { return std::isfinite(value) && value > 0.0f; });
}

/// A pixel of a picture's rectangle; null outside.
const float* pixelOf(const CastPicture& picture, int x, int y)
{
    x -= picture.x;
    y -= picture.y;
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return nullptr;
    return &picture.rgbt[4 * (std::size_t(y) * std::size_t(picture.width) + std::size_t(x))];
}

} // namespace

std::vector<float> pictureDepths(RayCaster& caster, const CastRequest& request, const CastPicture& picture,
                                 bool (*interrupted)())
{
    const auto pixels = std::size_t(request.width) * std::size_t(request.height);
    std::vector<float> before(pixels, 0.0f), reached(pixels, 1.0f), middle(pixels, 0.0f);
    CastRequest part = request;
    part.depth.depths = middle;
    CastPicture shown;
    for (int round = 0; round < kRounds; ++round) {
        if (interrupted()) return {};
        for (std::size_t i = 0; i < pixels; ++i)
            middle[i] = 0.5f * (before[i] + reached[i]);
        caster.cast(part, shown);
        for (int y = picture.y; y < picture.y + picture.height; ++y)
            for (int x = picture.x; x < picture.x + picture.width; ++x) {
                const float* whole = pixelOf(picture, x, y);
                if (!hasAny(request.blending, whole)) continue;
                const float* found = pixelOf(shown, x, y);
                const std::size_t i = std::size_t(y) * std::size_t(request.width) + std::size_t(x);
                const bool there = found && isReached(request.blending, whole, found);
                (there ? reached : before)[i] = middle[i];
            }
    }
    return reached;
}

} // namespace vo
