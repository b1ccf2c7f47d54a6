#pragma once

#include "x3d/scene.h"

#include <string>

namespace vo {

/// Messages on what of a scene is not drawn, or in another way than it says: once each.
class ViewMessages
{
public:
    explicit ViewMessages(Scene& scene) : scene_(scene) {}

    void warn(const Node& node, const std::string& text, MessageTopic topic = MessageTopic::other)
    {
        scene_.tell(Severity::warning, node, text, topic);
    }
    void error(const Node& node, const std::string& text) { scene_.tell(Severity::error, node, text); }

private:
    Scene& scene_;
};

} // namespace vo
