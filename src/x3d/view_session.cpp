#include "x3d/view_session.h"

#include <limits>

namespace vo {

StyledScene ViewSession::styledScene(ViewRequest request)
{
    const auto make = [&] {
        ViewRequest bound = request;
        if (!bound.viewpoint) bound.viewpoint = events_.boundViewpoint();
        return view_.styledScene(bound);
    };
    StyledScene scene = make();
    return sendLevels() ? make() : scene;
}

/// Whether that set any field.
bool ViewSession::sendLevels()
{
    std::vector<SceneEvent> sent;
    for (const auto& [node, level] : view_.shownLevels()) {
        const auto [known, isNew] = levels_.try_emplace(node, level);
        if (!isNew && std::exchange(known->second, level) == level) continue;
        const bool isLod = node->field("level_changed") != nullptr;
        // The scene is not const here; views alone see it so.
        sent.push_back({const_cast<Node*>(node), node->field(isLod ? "level_changed" : "lowResActive")->slot,
                        FieldValue(std::vector<std::int32_t>{level})});
    }
    const auto before = events_.changes();
    events_.send(std::move(sent));
    return events_.changes() != before;
}

namespace {

struct Extent
{
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void add(const glm::dmat4& worldFromLocal, const glm::dvec3& local)
    {
        const glm::dvec3 point(worldFromLocal * glm::dvec4(local, 1.0));
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
};

} // namespace

SceneBounds boundsOf(const StyledScene& scene)
{
    Extent extent;
    for (const StyledVolume& volume : scene.volumes) {
        for (int corner = 0; corner < 8 && !volume.tetras; ++corner) {
            const glm::dvec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
            extent.add(volume.worldFromLocal, sign * glm::dvec3(volume.dimensions));
        }
        if (!volume.tetras) continue;
        for (const glm::vec3& position : volume.tetras->positions)
            extent.add(volume.worldFromLocal, glm::dvec3(position));
    }
    for (const StyledSurface& surface : scene.surfaces)
        for (const glm::vec3& position : surface.positions)
            extent.add(surface.worldFromLocal, glm::dvec3(position));
    if (!(extent.low.x <= extent.high.x)) return {};
    return {(extent.low + extent.high) * 0.5, glm::length(extent.high - extent.low) * 0.5};
}

} // namespace vo
