#include "x3d/scene_walk.h"

#include "x3d/node_lights.h"
#include "x3d/node_transform.h"
#include "x3d/node_values.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <span>

namespace vo {
namespace {

constexpr std::size_t kMostDepth = 500;
constexpr std::size_t kMostVisits = 1'000'000;
constexpr std::size_t kMostShown = 100'000;
constexpr int kMostVolumes = 512;
constexpr std::size_t kMostOctants = 8;

/// How far a walk may go: nodes stand in many places, and a program may have put them below themselves.
class WalkBudget
{
public:
    bool enter(std::size_t depth)
    {
        if (exceeded_.empty() && depth > kMostDepth)
            exceeded_ = "nodes at most " + std::to_string(kMostDepth) + " deep";
        if (exceeded_.empty() && visits_ >= kMostVisits)
            exceeded_ = "nodes in at most " + std::to_string(kMostVisits) + " places";
        ++visits_;
        return exceeded_.empty();
    }
    /// The limit that ended the walk: what was expected; "" where none has.
    const std::string& exceeded() const { return exceeded_; }

private:
    std::size_t visits_ = 0;
    std::string exceeded_;
};

glm::dmat4 matrixOf(const Node& node)
{
    return isOf(&node, "Transform") ? transformMatrix(node) : glm::dmat4(1.0);
}

/// Of a matrix that has no inverse: whether it makes a box flat; else its numbers are too large or too small.
bool isWithoutExtent(const glm::dmat4& matrix)
{
    const glm::dmat3 axes(matrix);
    glm::dmat3 units;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = glm::length(axes[axis]);
        if (!std::isfinite(length)) return false;
        if (length == 0.0) return true;
        units[axis] = axes[axis] / length;
    }
    return std::abs(glm::determinant(units)) < 1e-12;
}

bool hasScaleOfZero(const Node* node)
{
    const auto isZero = [](float number) { return number == 0.0f; };
    return isOf(node, "Transform") && std::ranges::any_of(floatsOf(*node, "scale"), isZero);
}

/// All that stands below a group, shown or not.
std::vector<const Node*> childrenOf(const Node& node)
{
    std::vector<const Node*> children(node.inlined.begin(), node.inlined.end());
    for (const char* const field : {"children", "highRes", "lowRes"})
        children.insert(children.end(), nodesOf(node, field).begin(), nodesOf(node, field).end());
    return children;
}

class BindableSearch
{
public:
    void visit(const Node& node, const glm::dmat4& worldFromParent, std::size_t depth)
    {
        if (!budget_.enter(depth)) return;
        if (isOf(&node, "X3DBindableNode") && seen_.insert(&node).second)
            found.push_back({&node, worldFromParent});
        const glm::dmat4 worldFromNode = worldFromParent * matrixOf(node);
        for (const Node* const child : childrenOf(node))
            if (child) visit(*child, worldFromNode, depth + 1);
    }

    std::vector<PlacedNode> found;

private:
    WalkBudget budget_;
    std::set<const Node*> seen_;
};

class ShownSearch
{
public:
    ShownSearch(const std::optional<glm::dvec3>& eye, ViewMessages& messages) : eye_(eye), messages_(messages)
    {
    }

    /// What falls on one child of a group falls on all.
    void visitAll(std::span<const Node* const> children, const glm::dmat4& worldFromGroup)
    {
        const std::size_t lightsBefore = lights_.size(), planesBefore = planes_.size();
        for (const Node* const child : children)
            if (child) openScope(*child, worldFromGroup);
        for (const Node* const child : children)
            if (child) visit(*child, worldFromGroup);
        lights_.resize(lightsBefore);
        planes_.resize(planesBefore);
    }

    ShownNodes result()
    {
        for (ShownNode& shown : found_.nodes)
            shown.lights.insert(shown.lights.end(), globalLights_.begin(), globalLights_.end());
        return std::move(found_);
    }

private:
    void openScope(const Node& node, const glm::dmat4& worldFromGroup)
    {
        if (isOf(&node, "X3DLightNode") && boolOf(node, "on", true)) {
            if (boolOf(node, "shadows")) messages_.warn(node, node.typeName() + ".shadows is not drawn");
            auto& scope = boolOf(node, "global") ? globalLights_ : lights_;
            scope.push_back(worldLight(node, worldFromGroup));
        }
        if (isOf(&node, "ClipPlane") && boolOf(node, "enabled", true) && isInvertible(worldFromGroup))
            planes_.push_back(glm::transpose(glm::inverse(worldFromGroup)) *
                              glm::dvec4(vec4Of(node, "plane")));
    }

    void visit(const Node& node, const glm::dmat4& worldFromParent)
    {
        if (!boolOf(node, "visible", true)) return;
        if (!budget_.enter(path_.size())) return tellOfLimit(node, budget_.exceeded());
        if (found_.nodes.size() >= kMostShown)
            return tellOfLimit(node,
                               "at most " + std::to_string(kMostShown) + " shapes and volumes in all places");
        path_.push_back(&node);
        if (isOf(&node, "X3DVolumeDataNode") || isOf(&node, "X3DShapeNode"))
            show(node, worldFromParent);
        else {
            const glm::dmat4 worldFromNode = worldFromParent * matrixOf(node);
            visitAll(shownChildren(node, worldFromNode), worldFromNode);
        }
        path_.pop_back();
    }

    /// The first node beyond the first limit stands for all.
    void tellOfLimit(const Node& node, const std::string& expected)
    {
        if (isCutOff_) return;
        isCutOff_ = true;
        messages_.error(node, "expected " + expected + ", found more: from here on they are left out");
    }

    void show(const Node& node, const glm::dmat4& worldFromLocal)
    {
        if (isOf(&node, "X3DVolumeDataNode") && ++volumes_ > kMostVolumes)
            return tellOfLimit(node, "at most " + std::to_string(kMostVolumes) + " volumes in all places");
        if (isInvertible(worldFromLocal))
            found_.nodes.push_back({&node, worldFromLocal, path_, lights_, planes_});
        else if (std::ranges::none_of(path_, hasScaleOfZero)) // which DoubtfulValues tells of
            messages_.warn(node, node.typeName() + " stands in " +
                                     (isWithoutExtent(worldFromLocal)
                                          ? "a Transform without extent"
                                          : "Transforms whose scales no number can hold") +
                                     ": not drawn");
    }

    std::vector<const Node*> shownChildren(const Node& node, const glm::dmat4& worldFromNode)
    {
        if (isOf(&node, "Switch")) return childAt(node, integerOf(node, "whichChoice", -1));
        if (isOf(&node, "LOD")) return childAt(node, levelOf(node, worldFromNode));
        if (isOf(&node, "OctTree")) return octants(node, worldFromNode);
        if (isOf(&node, "Inline") && !boolOf(node, "load", true)) return {};
        return childrenOf(node);
    }

    static std::vector<const Node*> childAt(const Node& node, int index)
    {
        const auto& children = nodesOf(node, "children");
        if (index < 0 || static_cast<std::size_t>(index) >= children.size()) return {};
        return {children[static_cast<std::size_t>(index)]};
    }

    /// In the space of the node.
    double distanceToEye(const Node& node, const glm::dmat4& worldFromNode) const
    {
        if (!eye_ || !isInvertible(worldFromNode)) return 0.0;
        const glm::dvec3 eye(glm::inverse(worldFromNode) * glm::dvec4(*eye_, 1.0));
        return glm::distance(eye, glm::dvec3(vec3Of(node, "center")));
    }

    int levelOf(const Node& node, const glm::dmat4& worldFromNode)
    {
        const double distance = distanceToEye(node, worldFromNode);
        const auto& range = floatsOf(node, "range");
        const auto last = static_cast<std::ptrdiff_t>(nodesOf(node, "children").size()) - 1;
        const auto beyond = std::ranges::find_if(range, [&](float limit) { return distance < limit; });
        const auto level = eye_ ? std::min<std::ptrdiff_t>(beyond - range.begin(), last) : 0;
        found_.levels.push_back({&node, static_cast<int>(std::max<std::ptrdiff_t>(level, 0))});
        return found_.levels.back().level;
    }

    std::vector<const Node*> octants(const Node& node, const glm::dmat4& worldFromNode)
    {
        const bool isFar = distanceToEye(node, worldFromNode) > static_cast<double>(floatOf(node, "range"));
        found_.levels.push_back({&node, isFar ? 1 : 0});
        if (isFar) return {nodeOf(node, "lowRes")};
        const auto& highRes = nodesOf(node, "highRes");
        if (highRes.size() > kMostOctants)
            messages_.warn(node, "expected at most " + std::to_string(kMostOctants) +
                                     " nodes in OctTree.highRes, found " + std::to_string(highRes.size()) +
                                     ": the first are drawn");
        return {highRes.begin(),
                highRes.begin() + static_cast<std::ptrdiff_t>(std::min(highRes.size(), kMostOctants))};
    }

    std::optional<glm::dvec3> eye_;
    ViewMessages& messages_;
    WalkBudget budget_;
    int volumes_ = 0;
    bool isCutOff_ = false;
    ShownNodes found_;
    std::vector<const Node*> path_;
    std::vector<StyleLight> lights_, globalLights_;
    std::vector<glm::dvec4> planes_;
};

} // namespace

std::vector<PlacedNode> bindableNodes(const Scene& scene)
{
    BindableSearch search;
    for (const Node* const root : scene.roots)
        search.visit(*root, glm::dmat4(1.0), 0);
    return std::move(search.found);
}

ShownNodes shownNodes(const Scene& scene, const std::optional<glm::dvec3>& eye, ViewMessages& messages)
{
    ShownSearch search(eye, messages);
    const std::vector<const Node*> roots(scene.roots.begin(), scene.roots.end());
    search.visitAll(roots, glm::dmat4(1.0));
    return search.result();
}

} // namespace vo
