#include "x3d/check_textures.h"

#include "x3d/node_values.h"
#include "x3d/slice_atlas.h"
#include "x3d/voxel_textures.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace vo {
namespace {

/// The first file that is there; "" where there is none.
std::string fileOf(const Scene& scene, const Node& node)
{
    for (const std::string& url : stringsOf(node, "url"))
        if (const auto place = scene.locate(node, url); place.reason.empty()) return place.path.string();
    return "";
}

/// PNG or JPEG, by its first bytes.
bool isPicture(const std::string& path)
{
    // Opening a pipe would wait for whoever writes.
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return false;
    char begin[4] = {};
    std::ifstream(path, std::ios::binary).read(begin, sizeof begin);
    const std::string_view text(begin, sizeof begin);
    return text == "\x89PNG" || text.starts_with("\xff\xd8\xff");
}

/// Files that are not there were told of with the urls.
void checkAtlas(const Scene& scene, const Node& node, ViewMessages& messages)
{
    if (lacksRefusedValue(scene, node)) return;
    const std::string wrong = atlasObjection(node);
    if (!wrong.empty()) return messages.error(node, node.typeName() + ": " + wrong);
    if (stringsOf(node, "url").empty() || !fileOf(scene, node).empty())
        VoxelTextures(scene, messages).of(&node);
}

void checkPicture(const Scene& scene, const Node& node, ViewMessages& messages)
{
    const std::string path = fileOf(scene, node);
    if (path.empty() || !isPicture(path)) return;
    messages.warn(node, node.typeName() + ": " + path +
                            ": a picture is one slice; ImageTextureAtlas takes one of many slices");
}

} // namespace

void checkTextures(Scene& scene)
{
    ViewMessages messages(scene);
    for (const auto& node : scene.nodes()) {
        if (isOf(node.get(), "ImageTextureAtlas")) checkAtlas(scene, *node, messages);
        if (isOf(node.get(), "ImageTexture3D")) checkPicture(scene, *node, messages);
    }
}

} // namespace vo
