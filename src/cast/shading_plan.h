#pragma once

#include "cast/cast_request.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace vo {

/// The largest opacity in smooth tables: with larger ones a few samples make a pixel, and the errors of their
/// colours do not even out.
constexpr float kMostSmoothAlpha = 0.25f;

/// What becomes of a sample, component by component: value * slope + base, or a table's entries, the texture
/// environment and the colour worked into them.
struct ShadingPlan
{
    bool oneChannel = true; ///< all components come from the one value
    bool table = false;
    bool grey = false; ///< red, green and blue are always equal
    int last = 0;      ///< number of the last entry
    /// (entry, next entry - entry) for each entry; the last one's difference is 0.
    std::array<std::vector<float>, 4> entries;
    /// The same in 32 bits a component, if that keeps every alpha to 1/256 of itself: the entry in the upper
    /// 16, the difference (signed) in the lower, each times its scale. Two components are read at a time:
    /// red and (next in memory) alpha, green and blue.
    struct PackedPair
    {
        std::uint32_t first = 0, second = 0;
    };
    std::vector<PackedPair> redAlpha, greenBlue;
    bool packed() const { return !redAlpha.empty(); }
    std::array<float, 4> entryScale{}, differenceScale{};
    /// Of tables whose colours change little between entries, and whose opacities are small: `smoothSteps`
    /// for each entry of the table, the last one alone, each with alpha as above and with the colour halfway
    /// to the next one (red in the upper 11 bits, green in 11, blue in 10, each times its `smoothScale`).
    struct SmoothEntry
    {
        std::uint32_t alpha = 0, color = 0;
    };
    std::vector<SmoothEntry> smooth;
    int smoothSteps = 0;
    float smoothDifferenceScale = 0.0f; ///< of alpha; its entries have entryScale
    std::array<float, 3> smoothScale{};
    std::array<float, 4> slope{};
    std::array<float, 4> base{};

    /// True when component c is 0 for all values from low to high, as stored (`unit` stands for 1).
    bool isZero(int component, float low, float high, float unit) const;

    /// How many entries of alpha from the first on are 0.
    int clearEntries() const;

    /// True when there is one channel, and no component falls as values rise.
    bool rises() const;

    std::array<std::vector<int>, 4> notZero; ///< number of entries before each that are not 0
};

/// The plan of samples that are `units` units of opacity long each, with 1 - (1 - alpha)^units as the table's
/// alpha; nothing without a table, or where that would be off between two entries by more than 1/4096 of
/// itself.
std::optional<ShadingPlan> withUnits(const ShadingPlan& plan, double units);

/// For samples of one channel, or of four; `texel` as the bricks have it, `classified` by a table before
/// interpolation.
ShadingPlan shadingPlan(const CastShading& shading, TexelFormat texel, bool classified);

} // namespace vo
