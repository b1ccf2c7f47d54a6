#include "x3d/styled_view.h"

#include "x3d/doubtful_values.h"
#include "x3d/node_cameras.h"
#include "x3d/node_lights.h"
#include "x3d/node_transform.h"
#include "x3d/node_values.h"
#include "x3d/scene_walk.h"
#include "x3d/shape_nodes.h"
#include "x3d/sky_colors.h"
#include "x3d/view_messages.h"
#include "x3d/volume_nodes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace vo {
namespace {

/// Of all surfaces: 800 MB.
constexpr std::size_t kMostPoints = 20'000'000;

/// Of what is drawn, in the world.
constexpr double kMostReach = 1e15, kLeastSize = 1e-15;

std::string lengthText(double length)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, length, std::chars_format::general, 3).ptr};
}

/// The one that is bound at first: of the scene's own file, not of an Inline.
PlacedNode firstOf(const std::vector<PlacedNode>& nodes, const char* typeName)
{
    const auto found = std::ranges::find_if(
        nodes, [&](const PlacedNode& each) { return each.node->scope == 0 && isOf(each.node, typeName); });
    return found == nodes.end() ? PlacedNode{} : *found;
}

} // namespace

struct SceneView::Private
{
    Private(Scene& whole, VoxelReading reading)
        : scene(whole), messages(whole), doubtful(whole, messages), volumes(whole, messages, reading),
          shapes(messages)
    {
    }

    PlacedNode viewpointOf(const ViewRequest& request, const std::vector<PlacedNode>& bindables) const;
    ViewBox boxOf(const Node& node);
    bool hasDrawableSize(const ShownNode& each);
    ShownNodes drawableNodes(const std::optional<glm::dvec3>& eye);
    std::vector<ViewBox> boxesOf(const ShownNodes& nodes, const glm::dmat4& matrix);
    glm::dmat4 eyeOf(const ViewRequest& request, const PlacedNode& viewpoint);
    void addHeadlight(const ViewRequest& request, const Node* viewpoint,
                      const std::vector<PlacedNode>& bindables, const glm::dmat4& eyeFromWorld);
    void addShown(const std::optional<double>& sampling, StyledScene& styled);
    float originalDistance(const ShownNode& place, const glm::dmat4& eyeFromWorld);

    Scene& scene;
    ViewMessages messages;
    DoubtfulValues doubtful;
    VolumeNodes volumes;
    ShapeNodes shapes;
    ShownNodes shown;
    std::map<std::vector<const Node*>, float> originalDistances; // by the way to a place
};

PlacedNode SceneView::Private::viewpointOf(const ViewRequest& request,
                                           const std::vector<PlacedNode>& bindables) const
{
    if (!request.viewpoint) return firstOf(bindables, "X3DViewpointNode");
    const auto found = std::ranges::find(bindables, request.viewpoint, &PlacedNode::node);
    return found == bindables.end() ? PlacedNode{request.viewpoint} : *found;
}

ViewBox SceneView::Private::boxOf(const Node& node)
{
    return isOf(&node, "X3DVolumeDataNode") ? volumeBox(node) : shapes.boxOf(node);
}

/// Whether its box is one that numbers of single precision, and their squares, can hold.
bool SceneView::Private::hasDrawableSize(const ShownNode& each)
{
    const ViewBox box = boxOf(*each.node);
    if (box.isEmpty()) return true;
    ViewBox world;
    world.add(box, each.worldFromLocal);
    const glm::dvec3 reach = glm::max(glm::abs(world.low), glm::abs(world.high));
    const double farthest = std::max({reach.x, reach.y, reach.z});
    const double size = glm::length(world.high - world.low);
    if (farthest <= kMostReach && size >= kLeastSize) return true;
    const bool isFar = !(farthest <= kMostReach);
    messages.warn(*each.node, each.node->typeName() + " in its Transforms: expected " +
                                  (isFar ? "coordinates in the world up to " + lengthText(kMostReach)
                                         : "a size in the world from " + lengthText(kLeastSize) + " on") +
                                  ", found " + lengthText(isFar ? farthest : size) + ": not drawn");
    return false;
}

ShownNodes SceneView::Private::drawableNodes(const std::optional<glm::dvec3>& eye)
{
    ShownNodes found = shownNodes(scene, eye, messages);
    std::erase_if(found.nodes, [&](const ShownNode& each) { return !hasDrawableSize(each); });
    return found;
}

/// In the space that the matrix leads to from the world.
std::vector<ViewBox> SceneView::Private::boxesOf(const ShownNodes& nodes, const glm::dmat4& matrix)
{
    std::vector<ViewBox> boxes;
    for (const ShownNode& each : nodes.nodes)
        boxes.emplace_back().add(boxOf(*each.node), matrix * each.worldFromLocal);
    return boxes;
}

glm::dmat4 SceneView::Private::eyeOf(const ViewRequest& request, const PlacedNode& viewpoint)
{
    if (request.camera) return request.camera->eyeFromWorld;
    const glm::dmat4 eyeFromWorld = eyeFromWorldOf(viewpoint);
    if (viewpoint.node && !boolOf(*viewpoint.node, "viewAll")) return eyeFromWorld;
    ViewBox world;
    for (const ViewBox& box : boxesOf(drawableNodes({}), glm::dmat4(1.0)))
        world.add(box, glm::dmat4(1.0));
    return eyeThatSeesAll(viewpoint, eyeFromWorld, world, request.width, request.height);
}

/// Before all other lights, so that it is not the one that is left out.
void SceneView::Private::addHeadlight(const ViewRequest& request, const Node* viewpoint,
                                      const std::vector<PlacedNode>& bindables,
                                      const glm::dmat4& eyeFromWorld)
{
    const Node* info = viewpoint ? vo::nodeOf(*viewpoint, "navigationInfo") : nullptr;
    if (!info) info = firstOf(bindables, "NavigationInfo").node;
    if (!request.headlight || (info && !boolOf(*info, "headlight", true))) return;
    for (ShownNode& each : shown.nodes)
        each.lights.insert(each.lights.begin(), headlight(eyeFromWorld));
}

/// From the eye to the middle of the volume, along the view, when it was drawn first.
float SceneView::Private::originalDistance(const ShownNode& place, const glm::dmat4& eyeFromWorld)
{
    const double distance = -(eyeFromWorld * place.worldFromLocal)[3].z;
    return originalDistances.emplace(place.path, static_cast<float>(std::max(distance, 0.0))).first->second;
}

/// The id of a node is its place among those that are shown, from 1.
void SceneView::Private::addShown(const std::optional<double>& sampling, StyledScene& styled)
{
    std::size_t points = 0;
    for (std::size_t i = 0; i < shown.nodes.size(); ++i) {
        const ShownNode& each = shown.nodes[i];
        const int id = static_cast<int>(i) + 1;
        if (isOf(each.node, "X3DVolumeDataNode")) {
            if (auto volume = volumes.of(each, styled, sampling)) {
                volume->id = id;
                if (volume->stipple)
                    volume->stipple->originalDistance = originalDistance(each, styled.eyeFromWorld);
                styled.volumes.push_back(std::move(*volume));
            }
        } else if (auto surface = shapes.of(each)) {
            points += surface->positions.size();
            surface->id = id;
            if (points <= kMostPoints)
                styled.surfaces.push_back(std::move(*surface));
            else
                messages.error(*each.node, "expected shapes with at most " + std::to_string(kMostPoints) +
                                               " points in all places, found more: left out");
        }
    }
}

SceneView::SceneView(Scene& scene) : SceneView(scene, VoxelReading::whole) {}

SceneView::SceneView(Scene& scene, VoxelReading reading) : d(std::make_unique<Private>(scene, reading)) {}

SceneView::~SceneView() = default;

StyledScene SceneView::styledScene(const ViewRequest& request)
{
    ViewRequest asked = request;
    asked.width = std::max(asked.width, 1);
    asked.height = std::max(asked.height, 1);
    d->doubtful.tell();
    const std::vector<PlacedNode> bindables = bindableNodes(d->scene);
    const PlacedNode viewpoint = d->viewpointOf(asked, bindables);
    StyledScene styled;
    styled.width = asked.width;
    styled.height = asked.height;
    styled.eyeFromWorld = d->eyeOf(asked, viewpoint);
    d->shown = d->drawableNodes(glm::dvec3(glm::inverse(styled.eyeFromWorld)[3]));
    const std::vector<ViewBox> eyeBoxes = d->boxesOf(d->shown, styled.eyeFromWorld);
    styled.clipFromEye = asked.camera ? asked.camera->clipFromEye
                                      : clipFromEyeOf(viewpoint, eyeBoxes, asked.width, asked.height);
    d->addHeadlight(asked, viewpoint.node, bindables, styled.eyeFromWorld);
    if (const PlacedNode background = firstOf(bindables, "Background"); background.node)
        styled.background = skyColors(background, d->messages);
    d->addShown(asked.sampling, styled);
    return styled;
}

const Node* SceneView::nodeOf(int id) const
{
    const auto& nodes = d->shown.nodes;
    return id < 1 || static_cast<std::size_t>(id) > nodes.size()
               ? nullptr
               : nodes[static_cast<std::size_t>(id) - 1].node;
}

std::vector<const Node*> SceneView::pathOf(int id) const
{
    return nodeOf(id) ? d->shown.nodes[static_cast<std::size_t>(id) - 1].path : std::vector<const Node*>();
}

const std::vector<ShownLevel>& SceneView::shownLevels() const
{
    return d->shown.levels;
}

std::vector<const Node*> SceneView::viewpoints() const
{
    std::vector<const Node*> found;
    for (const PlacedNode& each : bindableNodes(d->scene))
        if (isOf(each.node, "X3DViewpointNode")) found.push_back(each.node);
    return found;
}

void checkView(Scene& scene)
{
    SceneView view(scene, VoxelReading::sizesAlone);
    const StyledScene styled = view.styledScene({});
    std::set<const Node*> seen;
    for (const ShownNode& shown : view.d->shown.nodes)
        seen.insert(shown.node);
    // Those that other levels, choices and times may show.
    for (const auto& node : scene.nodes())
        if (isOf(node.get(), "X3DVolumeDataNode") && !seen.contains(node.get()))
            view.d->volumes.of({node.get(), glm::dmat4(1.0), {}, {}, {}}, styled, {});
}

} // namespace vo
