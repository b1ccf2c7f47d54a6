#include "draw/scene_steps.h"

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

struct CommonDepths
{
    double nearest, farthest;
};

/// Where two or more things that reach over depths may meet; empty if they do not.
CommonDepths commonReach(const LayerLists& lists)
{
    std::vector<double> nearest, farthest;
    for (const std::span<const SliceLayer> layers : lists) {
        if (layers.empty() || layers.front().reach <= 0.0) continue;
        nearest.push_back(layers.back().depth);
        farthest.push_back(layers.front().depth + layers.front().reach);
    }
    if (nearest.size() < 2) return {0.0, 0.0};
    std::ranges::sort(nearest);
    std::ranges::sort(farthest, std::greater<>());
    return {nearest[1], farthest[1]};
}

void divide(std::size_t drawn, const SliceLayer& layer, std::span<const double> borders,
            std::vector<SceneStep>& steps)
{
    SceneStep step{drawn, layer};
    if (layer.reach > 0.0) {
        auto border = std::ranges::upper_bound(borders, layer.depth);
        for (; border != borders.end() && *border < layer.depth + layer.reach; ++border) {
            step.farthest = *border;
            steps.push_back(step);
            step.nearest = *border;
        }
        step.farthest = std::numeric_limits<double>::infinity();
    }
    steps.push_back(step);
}

} // namespace

bool SceneStep::isWhole() const
{
    return std::isinf(nearest) && std::isinf(farthest);
}

double SceneStep::depth() const
{
    return std::max(layer.depth, nearest);
}

bool SceneStep::join(const SceneStep& next)
{
    const bool follows = next.drawn == drawn && next.layer.first == layer.first + layer.count;
    if (!follows || !isWhole() || !next.isWhole()) return false;
    layer.count += next.layer.count;
    return true;
}

std::vector<double> stepBorders(const LayerLists& lists)
{
    constexpr int kParts = 512;
    std::vector<double> borders;
    for (const std::span<const SliceLayer> layers : lists)
        for (const SliceLayer& layer : layers)
            borders.push_back(layer.depth);
    const CommonDepths common = commonReach(lists);
    const double width = (common.farthest - common.nearest) / kParts;
    for (int part = 0; part <= kParts && width > 0.0; ++part)
        borders.push_back(common.nearest + part * width);
    std::ranges::sort(borders);
    borders.erase(std::unique(borders.begin(), borders.end()), borders.end());
    return borders;
}

std::vector<SceneStep> sceneSteps(const LayerLists& lists, std::span<const double> borders)
{
    std::vector<SceneStep> steps;
    for (std::size_t i = lists.size(); i-- > 0;)
        for (const SliceLayer& layer : lists[i])
            divide(i, layer, borders, steps);
    std::ranges::stable_sort(steps, [](const SceneStep& a, const SceneStep& b) {
        if (a.depth() != b.depth()) return a.depth() > b.depth();
        return a.layer.reach > 0.0 && b.layer.reach <= 0.0;
    });
    return steps;
}

} // namespace vo
