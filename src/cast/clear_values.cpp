#include "cast/clear_values.h"

#include "cast/cast_volume.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace vo {

namespace {

bool isClear(const ChainPlan& plan, float low, float high)
{
    if (!plan.keepsClear) return false;
    return plan.beginsWithVoxel ? high <= 0.0f : plan.chain.front()->isClear(low, high);
}

} // namespace

std::array<std::uint16_t, ClearValues::kSteps + 3> ClearValues::nothingKnown()
{
    std::array<std::uint16_t, kSteps + 3> seen{};
    std::iota(seen.begin(), seen.end(), std::uint16_t{0});
    return seen;
}

ClearValues::ClearValues(std::span<const ChainPlan> plans)
{
    constexpr float kFar = std::numeric_limits<float>::max();
    for (int step = 0; step <= kSteps + 1; ++step) {
        const float low = step == 0 ? -kFar : static_cast<float>(step - 1) / kSteps;
        const float high = step == 0 ? 0.0f : step > kSteps ? kFar : static_cast<float>(step) / kSteps;
        const bool clear = std::all_of(plans.begin(), plans.end(),
                                       [&](const ChainPlan& plan) { return isClear(plan, low, high); });
        const auto s = static_cast<std::size_t>(step);
        seen_[s + 1] = static_cast<std::uint16_t>(seen_[s] + (clear ? 0 : 1));
    }
}

ClearValues ClearValues::ofOpacities(const ChainPlan& plan)
{
    ClearValues clear;
    if (plan.keepsClearVoxels)
        for (std::size_t next = 1; next < clear.seen_.size(); ++next)
            --clear.seen_[next];
    return clear;
}

void ClearValues::keepCommon(const ClearValues& other)
{
    const auto before = seen_;
    for (std::size_t s = 0; s + 1 < seen_.size(); ++s) {
        const bool isSeen = before[s + 1] != before[s] || other.seen_[s + 1] != other.seen_[s];
        seen_[s + 1] = static_cast<std::uint16_t>(seen_[s] + (isSeen ? 1 : 0));
    }
}

std::vector<ClearValues> clearValuesOf(std::span<const ChainPlan> plans, int components)
{
    std::vector<ClearValues> ofChains;
    for (const ChainPlan& plan : plans)
        ofChains.push_back(components == 1 ? ClearValues({&plan, 1}) : ClearValues::ofOpacities(plan));
    return ofChains;
}

} // namespace vo
