#include "x3d/sky_colors.h"

#include "x3d/node_transform.h"
#include "x3d/node_values.h"

#include <algorithm>

namespace vo {
namespace {

/// As many angles as colours need, rising; what is left over is left out.
void takeColors(const Node& node, const std::string& name, std::vector<float>& angles,
                std::vector<glm::vec3>& colors, ViewMessages& messages)
{
    const auto& given = floatsOf(node, name + "Angle");
    const auto list = vec3sOf(node, name + "Color");
    if (list.empty()) return;
    colors = list;
    angles.clear();
    for (const float angle : given) {
        if (angles.size() + 1 >= colors.size() || (!angles.empty() && angle < angles.back())) break;
        angles.push_back(angle);
    }
    if (angles.size() != given.size() || angles.size() + 1 != colors.size())
        messages.warn(node, "expected rising angles in Background." + name +
                                "Angle, one fewer than colours, found " + std::to_string(given.size()) +
                                " for " + std::to_string(colors.size()) + ": what fits is drawn");
    colors.resize(angles.size() + 1);
}

} // namespace

SkyColors skyColors(const PlacedNode& background, ViewMessages& messages)
{
    const Node& node = *background.node;
    SkyColors colors;
    takeColors(node, "sky", colors.skyAngles, colors.sky, messages);
    takeColors(node, "ground", colors.groundAngles, colors.ground, messages);
    colors.worldFromBackground = rigidAxes(background.worldFromLocal);
    colors.opacity = 1.0f - floatOf(node, "transparency");
    for (const char* const field : {"backUrl", "bottomUrl", "frontUrl", "leftUrl", "rightUrl", "topUrl"})
        if (!stringsOf(node, field).empty())
            messages.warn(node, std::string("Background.") + field + ": pictures of the sky are not drawn");
    return colors;
}

} // namespace vo
