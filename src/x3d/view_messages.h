#pragma once

#include "x3d/scene.h"

#include <set>
#include <string>
#include <utility>

namespace vo {

/// Messages on what of a scene is not drawn, or in another way than it says: once each.
class ViewMessages
{
public:
    explicit ViewMessages(Scene& scene) : scene_(scene) {}

    void warn(const Node& node, const std::string& text) { add(Severity::warning, node, text); }
    void error(const Node& node, const std::string& text) { add(Severity::error, node, text); }

private:
    void add(Severity severity, const Node& node, const std::string& text);

    Scene& scene_;
    std::set<std::pair<const Node*, std::string>> told_;
};

} // namespace vo
