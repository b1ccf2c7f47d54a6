#include "x3d/view_messages.h"

namespace vo {

void ViewMessages::add(Severity severity, const Node& node, const std::string& text)
{
    constexpr std::size_t kMost = 1000;
    if (told_.size() >= kMost) {
        if (!told_.contains({&node, text})) ++scene_.messagesLeftOut;
        return;
    }
    if (told_.emplace(&node, text).second) scene_.messages.push_back({severity, node.place, text});
}

} // namespace vo
