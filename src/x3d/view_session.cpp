#include "x3d/view_session.h"

#include "x3d/node_cameras.h"

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

SceneBounds boundsOf(const StyledScene& scene)
{
    ViewBox world;
    const auto add = [&world](const glm::dmat4& worldFromLocal, const std::vector<glm::vec3>& positions) {
        for (const glm::vec3& position : positions)
            world.add(glm::dvec3(worldFromLocal * glm::dvec4(position, 1.0)));
    };
    for (const StyledVolume& volume : scene.volumes) {
        const glm::dvec3 half = glm::dvec3(volume.dimensions) * 0.5;
        if (volume.tetras)
            add(volume.worldFromLocal, volume.tetras->positions);
        else
            world.add(ViewBox{-half, half}, volume.worldFromLocal);
    }
    for (const StyledSurface& surface : scene.surfaces)
        add(surface.worldFromLocal, surface.positions);
    if (world.isEmpty()) return {};
    return {(world.low + world.high) * 0.5, glm::length(world.high - world.low) * 0.5};
}

} // namespace vo
