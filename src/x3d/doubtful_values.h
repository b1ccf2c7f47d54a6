#pragma once

#include "x3d/scene.h"
#include "x3d/view_messages.h"

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vo {

/// What is wrong with a value that its field allows: "scale", "expected numbers other than 0", "0 1 1:
/// nothing in it is drawn".
struct Doubt
{
    std::string field, expected, found;
    MessageTopic topic = MessageTopic::other;
};

/// Of the values of one node: axes and directions without a length, numbers that voxels do not have, lists
/// that should rise and fall, or that do not fit each other.
std::vector<Doubt> doubtsOf(const Node& node);

/// Tells of the doubtful values of a scene: of each node that has another value than when it was looked at.
/// What is expected of a node is told once, however often events bring it something else.
class DoubtfulValues
{
public:
    DoubtfulValues(const Scene& scene, ViewMessages& messages) : scene_(scene), messages_(messages) {}

    void tell();

private:
    struct Watched
    {
        const Node* node;
        std::uint64_t revision;
    };

    const Scene& scene_;
    ViewMessages& messages_;
    std::size_t known_ = 0; // nodes of the scene
    std::vector<Watched> watched_;
    std::set<std::pair<const Node*, std::string>> told_;
};

} // namespace vo
