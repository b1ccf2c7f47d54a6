#include "x3d/check_scene.h"

#include <algorithm>
#include <array>
#include <set>

#include "x3d/node_values.h"
#include "x3d/printable_word.h"

namespace vo {
namespace {

constexpr std::array kProfiles{"Core",      "Interchange",      "CADInterchange",     "Interactive", "MPEG-4",
                               "Immersive", "MPEG4Interactive", "MedicalInterchange", "Medical",     "Full"};
/// Those with volumes and 3D textures.
constexpr std::array kVolumeProfiles{"Full", "MedicalInterchange", "Medical"};

void warnAt(Scene& scene, const TextPlace& place, std::string text)
{
    scene.messages.push_back({Severity::warning, place, std::move(text)});
}

void checkComponents(Scene& scene)
{
    const SceneHeader& header = scene.header;
    if (std::ranges::find(kProfiles, header.profile) == kProfiles.end())
        return warnAt(scene, {scene.file, 1}, "unknown profile " + quotedWord(header.profile));
    if (std::ranges::find(kVolumeProfiles, header.profile) != kVolumeProfiles.end()) return;
    std::set<std::string_view> told;
    for (const auto& node : scene.nodes()) {
        const std::string& component = node->type().component();
        const int level = node->type().level(node->edition());
        const bool isExtra = component == "VolumeRendering" || component == "Texturing3D";
        if (!isExtra || node->scope != 0 || told.contains(component)) continue;
        const auto named = std::ranges::find(header.components, component, &SceneHeader::Component::name);
        if (named != header.components.end() && named->level >= level) continue;
        told.insert(component);
        warnAt(scene, node->place,
               node->typeName() + " is of the component " + component + ", level " + std::to_string(level) +
                   ", which the profile " + header.profile +
                   " does not bring and no component statement names");
    }
}

/// Whether a picture's message says it already.
bool isTold(const Scene& scene, const Node& node, const std::string& reasons)
{
    const std::string text = node.typeName() + ": " + reasons;
    return std::ranges::any_of(scene.messages,
                               [&](const SceneMessage& message) { return message.text == text; });
}

/// One of the files that a field names must be there; those of Inline were read, those of Anchor are for
/// later.
void checkUrls(Scene& scene, const Node& node, const FieldRow& row)
{
    const auto* const urls = std::get_if<std::vector<std::string>>(&node.value(row));
    const bool isUrl = row.name == "url" || row.name.ends_with("Url");
    const bool isPicture = !isOf(&node, "X3DChildNode") || isOf(&node, "X3DBindableNode");
    if (!isUrl || !urls || urls->empty() || !isPicture) return;
    std::string reasons;
    for (const std::string& url : *urls) {
        const auto place = scene.locate(node, url);
        if (place.reason.empty()) return;
        reasons += (reasons.empty() ? "" : "; ") + place.reason;
        if (reasons.size() > 400) break;
    }
    if (!isTold(scene, node, reasons))
        warnAt(scene, node.place, node.typeName() + "." + row.name + ": " + reasons);
}

} // namespace

void checkScene(Scene& scene)
{
    checkComponents(scene);
    for (const auto& node : scene.nodes())
        for (const Node::Setting& setting : node->settings())
            checkUrls(scene, *node, node->field(setting.slot));
}

} // namespace vo
