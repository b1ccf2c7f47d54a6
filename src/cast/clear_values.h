#pragma once

#include "style/style.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

struct ChainPlan;

/// The values of voxels of one component of which no chain makes anything that is seen.
class ClearValues
{
public:
    /// Those of which nothing is known: none.
    ClearValues() = default;
    explicit ClearValues(std::span<const ChainPlan> plans);
    /// Of voxels of several components, by their opacity as firstColor() says.
    static ClearValues ofOpacities(const ChainPlan& plan);

    /// Leaves those that are clear for the other, too.
    void keepCommon(const ClearValues& other);

    bool empty() const { return seen_[kSteps + 2] == kSteps + 2; }
    bool has(float value) const { return hasSteps(stepOf(value), stepOf(value)); }
    bool hasAll(float low, float high) const { return hasSteps(stepOf(low), stepOf(high)); }

private:
    static constexpr int kSteps = 1024;

    /// 0: up to 0; kSteps + 1: from 1 on.
    static int stepOf(float value)
    {
        return value > 0.0f ? 1 + static_cast<int>(value < 1.0f ? value * kSteps : kSteps) : 0;
    }
    bool hasSteps(int first, int last) const
    {
        return seen_[static_cast<std::size_t>(last) + 1] == seen_[static_cast<std::size_t>(first)];
    }
    static std::array<std::uint16_t, kSteps + 3> nothingKnown();

    /// How many steps before each may be seen.
    std::array<std::uint16_t, kSteps + 3> seen_ = nothingKnown();
};

/// Of each chain alone, for voxels of so many components.
std::vector<ClearValues> clearValuesOf(std::span<const ChainPlan> plans, int components);

} // namespace vo
