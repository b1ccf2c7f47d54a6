#include "cast/shading_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

void setTable(const Table& table, const std::array<float, 4>& factor, ShadingPlan& plan)
{
    plan.table = true;
    plan.last = table.size() - 1;
    const auto entry = [&](int i, std::size_t c) {
        return table.rgba[4 * static_cast<std::size_t>(i) + c] * factor[c];
    };
    for (std::size_t c = 0; c < 4; ++c) {
        for (int i = 0; i <= plan.last; ++i) {
            const float next = entry(std::min(i + 1, plan.last), c);
            plan.entries[c].push_back(entry(i, c));
            plan.entries[c].push_back(next - entry(i, c));
        }
        plan.notZero[c].push_back(0);
        for (int i = 0; i <= plan.last; ++i)
            plan.notZero[c].push_back(plan.notZero[c].back() + (entry(i, c) != 0.0f));
    }
}

/// Packs nothing where that would lose too much: of the opacities each a part of itself, since small ones add
/// up.
void packEntries(ShadingPlan& plan)
{
    plan.redAlpha.clear();
    plan.greenBlue.clear();
    constexpr float kMostEntry = 65535.0f, kMostDifference = 32767.0f, kLoss = 1.0f / 256.0f;
    std::array<std::vector<std::uint32_t>, 4> packed;
    for (std::size_t c = 0; c < 4; ++c) {
        const std::vector<float>& entries = plan.entries[c];
        float most = 0.0f, mostDifference = 0.0f;
        for (std::size_t i = 0; i < entries.size(); i += 2) {
            if (!(entries[i] >= 0.0f) || !std::isfinite(entries[i])) return;
            most = std::max(most, entries[i]);
            mostDifference = std::max(mostDifference, std::abs(entries[i + 1]));
        }
        plan.entryScale[c] = most > 0.0f ? most / kMostEntry : 1.0f;
        plan.differenceScale[c] = mostDifference > 0.0f ? mostDifference / kMostDifference : 1.0f;
        for (std::size_t i = 0; i < entries.size(); i += 2) {
            const float entry = std::round(entries[i] / plan.entryScale[c]);
            const float difference = std::round(entries[i + 1] / plan.differenceScale[c]);
            if (c == 3 && std::abs(entry * plan.entryScale[c] - entries[i]) > kLoss * entries[i]) return;
            const auto low = static_cast<std::uint16_t>(
                static_cast<std::int16_t>(std::clamp(difference, -kMostDifference, kMostDifference)));
            packed[c].push_back(static_cast<std::uint32_t>(std::clamp(entry, 0.0f, kMostEntry)) << 16 | low);
        }
    }
    for (std::size_t i = 0; i < packed[0].size(); ++i) {
        plan.redAlpha.push_back({packed[0][i], packed[3][i]});
        plan.greenBlue.push_back({packed[1][i], packed[2][i]});
    }
}

/// How many steps an entry takes so that colours halfway to the next step are within 1/2040; 0: the table is
/// not smooth.
int smoothStepsOf(const ShadingPlan& plan)
{
    constexpr float kMostSteps = 16.0f, kMostEntries = 4096.0f, kLoss = 1.0f / 2040.0f;
    float most = 0.0f;
    for (std::size_t i = 0; i < plan.entries[3].size(); i += 2) {
        if (plan.entries[3][i] > kMostSmoothAlpha) return 0;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max(most, std::abs(plan.entries[c][i + 1]));
    }
    const float steps = std::max(std::ceil(most / (2.0f * kLoss)), 1.0f);
    return steps <= kMostSteps && steps * static_cast<float>(plan.last) < kMostEntries
               ? static_cast<int>(steps)
               : 0;
}

/// Of a plan that has packed entries.
void addSmoothEntries(ShadingPlan& plan)
{
    plan.smooth.clear();
    plan.smoothSteps = plan.packed() ? smoothStepsOf(plan) : 0;
    if (plan.smoothSteps == 0) return;
    constexpr std::array<float, 3> kMost{2047.0f, 2047.0f, 1023.0f};
    for (std::size_t c = 0; c < 3; ++c)
        plan.smoothScale[c] = plan.entryScale[c] * 65535.0f / kMost[c];
    plan.smoothDifferenceScale = plan.differenceScale[3] / static_cast<float>(plan.smoothSteps);
    const auto steps = static_cast<float>(plan.smoothSteps);
    for (int i = 0; i <= plan.last * plan.smoothSteps; ++i) {
        const auto at = 2 * static_cast<std::size_t>(i / plan.smoothSteps);
        const auto part = static_cast<float>(i % plan.smoothSteps);
        const auto between = [&](std::size_t c, float weight) {
            return plan.entries[c][at] + weight / steps * plan.entries[c][at + 1];
        };
        const auto color = [&](std::size_t c) {
            const float number = std::round(between(c, part + 0.5f) / plan.smoothScale[c]);
            return static_cast<std::uint32_t>(std::clamp(number, 0.0f, kMost[c]));
        };
        const float alpha = std::clamp(std::round(between(3, part) / plan.entryScale[3]), 0.0f, 65535.0f);
        plan.smooth.push_back(
            {static_cast<std::uint32_t>(alpha) << 16 | (plan.redAlpha[at / 2].second & 0xffffu),
             color(0) << 21 | color(1) << 10 | color(2)});
    }
}

} // namespace

ShadingPlan shadingPlan(const CastShading& shading, TexelFormat texel, bool classified)
{
    ShadingPlan plan;
    plan.oneChannel = !classified && (texel == TexelFormat::intensity || texel == TexelFormat::luminance);
    const bool hasAlpha = classified || (texel != TexelFormat::luminance && texel != TexelFormat::rgb);
    std::array<float, 4> factor{1.0f, 1.0f, 1.0f, 1.0f};
    if (!shading.replace) factor = {shading.color.r, shading.color.g, shading.color.b, shading.color.a};
    if (shading.table) {
        setTable(*shading.table, factor, plan);
        packEntries(plan);
        addSmoothEntries(plan);
    } else {
        plan.slope = factor;
        // Alpha is 1 where the texture has none; replacing keeps the colour's.
        if (!hasAlpha) {
            plan.slope[3] = 0.0f;
            plan.base[3] = shading.color.a;
        }
    }
    plan.grey = plan.oneChannel && plan.entries[0] == plan.entries[1] && plan.entries[0] == plan.entries[2] &&
                plan.slope[0] == plan.slope[1] && plan.slope[0] == plan.slope[2];
    return plan;
}

std::optional<ShadingPlan> withUnits(const ShadingPlan& plan, double units)
{
    constexpr int kMostEntries = 4096; // made anew for each frame
    constexpr double kLoss = 1.0 / 4096.0;
    if (!plan.table || plan.last >= kMostEntries) return std::nullopt;
    const auto opacity = [&](double alpha) { return 1.0 - std::pow(1.0 - alpha, units); };
    ShadingPlan folded = plan;
    std::vector<float>& pairs = folded.entries[3];
    for (std::size_t i = 0; i < pairs.size(); i += 2) {
        const double here = pairs[i], next = here + pairs[i + 1];
        if (!(here >= 0.0 && here <= 1.0 && next >= 0.0 && next <= 1.0)) return std::nullopt;
        const double middle = opacity(0.5 * (here + next)), mean = 0.5 * (opacity(here) + opacity(next));
        if (std::abs(middle - mean) > kLoss * middle) return std::nullopt;
        pairs[i] = static_cast<float>(opacity(here));
        pairs[i + 1] = static_cast<float>(opacity(next) - opacity(here));
    }
    packEntries(folded);
    addSmoothEntries(folded);
    return folded;
}

int ShadingPlan::clearEntries() const
{
    const auto seen = std::ranges::upper_bound(notZero[3], 0);
    return std::max(static_cast<int>(seen - notZero[3].begin()) - 1, 0);
}

bool ShadingPlan::rises() const
{
    if (!oneChannel) return false;
    if (!table) return std::ranges::all_of(slope, [](float s) { return s >= 0.0f; });
    for (const std::vector<float>& pairs : entries)
        for (std::size_t difference = 1; difference < pairs.size(); difference += 2)
            if (!(pairs[difference] >= 0.0f)) return false;
    return true;
}

bool ShadingPlan::isZero(int component, float low, float high, float unit) const
{
    const auto c = static_cast<std::size_t>(component);
    if (!(low <= high)) return false;
    if (!table) return base[c] == 0.0f && (slope[c] == 0.0f || (low == 0.0f && high == 0.0f));
    // The same arithmetic as a sample's.
    const float scale = static_cast<float>(last) / unit;
    const auto place = [&](float raw) {
        return raw > 0.0f ? std::min(raw * scale, static_cast<float>(last)) : 0.0f;
    };
    const auto first = static_cast<std::size_t>(place(low));
    const float highest = place(high);
    auto end = static_cast<std::size_t>(highest);
    end += static_cast<float>(end) < highest ? 2 : 1;
    return notZero[c][end] == notZero[c][first];
}

} // namespace vo
