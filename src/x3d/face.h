#pragma once

#include <vo/x3d/Scene.h>

#include <deque>
#include <optional>
#include <string>

#include "legacy/report.h"
#include "x3d/number_text.h"
#include "x3d/plane_spacing.h"
#include "x3d/read_scene.h"

struct voX3DScene::Private
{
    /// Views hold it, too, until they notice that another was read.
    std::shared_ptr<vo::Scene> scene = std::make_shared<vo::Scene>();
    /// By the caller, for all files that are read.
    vo::SceneFolders allowed;
    /// What a call last made for the caller to read.
    std::string text;
    /// Its messages, as far as they were asked for.
    std::deque<std::string> messages;
};

namespace vo {

/// The answer of `body`, or `none` after a voError.
template <typename Answer, typename Body>
Answer guardedAnswer(const char* action, Answer none, Body body)
{
    Answer answer = none;
    guarded(action, [&] { answer = body(); });
    return answer;
}

voX3DScope::voX3DEdition faceEdition(Edition edition);

/// The element of a list, whose index must be inside.
template <typename List>
auto& elementOf(List& list, int index)
{
    if (index < 0 || static_cast<std::size_t>(index) >= list.size())
        badValue("index " + std::to_string(index) + " is outside of 0 to " + std::to_string(list.size()) +
                 " - 1");
    return list[static_cast<std::size_t>(index)];
}

/// What setSampling takes; nothing for 0.
inline std::optional<double> samplingOf(double edges)
{
    if (edges == 0) return {};
    if (!(edges >= kLeastSampling && edges <= kMostSampling))
        badValue("expected a distance of sampling planes from " + numberText(kLeastSampling) + " to " +
                 numberText(kMostSampling) + " shortest edges of a voxel, or 0, found " + numberText(edges));
    return edges;
}

} // namespace vo
