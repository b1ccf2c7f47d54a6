#include "x3d/voxel_textures.h"

#include "x3d/node_values.h"
#include "x3d/pixel_images.h"
#include "x3d/slice_atlas.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <new>

namespace vo {
namespace {

/// The first row last: pictures begin at the top.
void turnRows(VoxelTexture& texture)
{
    const std::size_t row = static_cast<std::size_t>(texture.size.x) *
                            static_cast<std::size_t>(texture.components) * bytesOf(texture.kind);
    const auto rows = static_cast<std::size_t>(texture.size.y);
    for (std::size_t slice = 0; slice < static_cast<std::size_t>(texture.size.z); ++slice) {
        const auto first = texture.texels.begin() + static_cast<std::ptrdiff_t>(slice * rows * row);
        for (std::size_t y = 0; y < rows / 2; ++y)
            std::swap_ranges(first + static_cast<std::ptrdiff_t>(y * row),
                             first + static_cast<std::ptrdiff_t>((y + 1) * row),
                             first + static_cast<std::ptrdiff_t>((rows - 1 - y) * row));
    }
}

bool isFlat(const Node& node)
{
    return isOf(&node, "X3DTexture2DNode");
}

/// What a node makes of its file: slices, or a picture turned as the node has it.
TextureResult arranged(const Node& node, const std::string& path, std::shared_ptr<VoxelTexture> read)
{
    const bool isAtlas = isOf(&node, "ImageTextureAtlas");
    if (!isAtlas && !isFlat(node)) return {std::move(read), ""};
    if (read->size.z != 1)
        return {nullptr, path + ": expected a picture, found " + std::to_string(read->size.z) + " slices"};
    if ((isFlat(node) || boolOf(node, "flipY")) && !read->texels.empty()) turnRows(*read);
    if (!isAtlas) return {std::move(read), ""};
    TextureResult slices = atlasSlices(node, std::move(read));
    if (!slices.texture) slices.reason.insert(0, path + ": ");
    return slices;
}

} // namespace

bool lacksRefusedValue(const Scene& scene, const Node& node)
{
    const std::array fields{"image", "url", "numberOfSlices", "slicesOverX", "slicesOverY"};
    return std::ranges::any_of(fields, [&](const char* field) { return scene.lacksRefused(node, field); });
}

std::shared_ptr<const VoxelTexture> VoxelTextures::of(const Node* node, TexelUse use)
{
    return of(node, use, reading_);
}

std::shared_ptr<const VoxelTexture> VoxelTextures::tableOf(const Node* node)
{
    return of(node, TexelUse::values, VoxelReading::whole);
}

std::shared_ptr<const VoxelTexture> VoxelTextures::of(const Node* node, TexelUse use, VoxelReading reading)
{
    if (!node) return nullptr;
    State state{{node, node->revision()}};
    for (const char* const field : {"textureProperties", "texture"})
        for (const Node* const below : nodesOf(*node, field)) {
            state.emplace_back(below, below->revision());
            if (const Node* const properties = nodeOf(*below, "textureProperties"))
                state.emplace_back(properties, properties->revision());
        }
    Kept& kept = kept_[{node, use, reading}];
    if (kept.state == state) return kept.texture;
    kept.state = std::move(state);
    TextureResult made = make(*node, use, reading);
    if (!made.note.empty()) messages_.warn(*node, node->typeName() + ": " + made.note);
    if (made.texture)
        applyProperties(*node, *made.texture);
    else if (!lacksRefusedValue(scene_, *node))
        messages_.error(*node, node->typeName() + ": " + made.reason);
    kept.texture = std::move(made.texture);
    return kept.texture;
}

TextureResult VoxelTextures::make(const Node& node, TexelUse use, VoxelReading reading)
{
    try {
        if (isOf(&node, "ComposedTexture3D")) return composed(node, use, reading);
        if (isOf(&node, "ImageTextureAtlas"))
            if (std::string wrong = atlasObjection(node); !wrong.empty()) return {nullptr, std::move(wrong)};
        if (node.field("url")) return readUrls(node, use, reading);
        return pixelImage(node);
    } catch (const std::bad_alloc&) {
        return {nullptr, "not enough memory for its texels"};
    }
}

TextureResult VoxelTextures::readUrls(const Node& node, TexelUse use, VoxelReading reading)
{
    // An atlas is cut from its pixels.
    if (isOf(&node, "ImageTextureAtlas")) reading = VoxelReading::whole;
    std::string reasons;
    for (const std::string& url : stringsOf(node, "url")) {
        const auto place = scene_.locate(node, url);
        TextureResult read{nullptr, place.reason};
        if (place.reason.empty()) read = readFile(node, place.path.string(), use, reading);
        if (read.texture) {
            const std::string note = std::move(read.note);
            read = arranged(node, place.path.string(), std::move(read.texture));
            read.note = note;
        }
        if (read.texture) return read;
        reasons += (reasons.empty() ? "" : "; ") + read.reason;
        if (reasons.size() > 400) break;
    }
    return {nullptr, reasons.empty() ? "expected a url, found none" : reasons};
}

/// Not again where the program has read it.
TextureResult VoxelTextures::readFile(const Node& node, const std::string& path, TexelUse use,
                                      VoxelReading reading)
{
    const auto found = scene_.readVoxels.find(&node);
    const bool isThere = found != scene_.readVoxels.end() && !found->second->bytes.empty();
    if (!isThere || reading == VoxelReading::sizesAlone) return readVoxelFile(path, use, reading);
    ReadVoxels voxels = std::move(*found->second);
    found->second->bytes = {};
    if (voxels.revision != node.revision()) return readVoxelFile(path, use, reading);
    return textureOf(std::move(voxels), path, use);
}

TextureResult VoxelTextures::composed(const Node& node, TexelUse use, VoxelReading reading)
{
    auto whole = std::make_shared<VoxelTexture>();
    const auto& slices = nodesOf(node, "texture");
    if (slices.empty()) return {nullptr, "expected textures, found none"};
    for (const Node* const sliceNode : slices) {
        const auto slice = of(sliceNode, use, reading);
        if (!slice) return {nullptr, "a slice is missing"};
        if (sliceNode == slices.front() && whole->texels.empty()) {
            whole->size = {slice->size.x, slice->size.y, static_cast<int>(slices.size())};
            whole->components = slice->components;
            whole->kind = slice->kind;
            if (slice->texels.size() > mostTextureBytes() / slices.size())
                return {nullptr, "expected slices of at most half the memory, found more"};
            whole->texels.reserve(slice->texels.size() * slices.size());
        }
        if (slice->size.x != whole->size.x || slice->size.y != whole->size.y ||
            slice->components != whole->components || slice->kind != whole->kind)
            return {nullptr, "expected slices of one size, type and number of components, found several"};
        whole->texels.insert(whole->texels.end(), slice->texels.begin(), slice->texels.end());
    }
    return {std::move(whole), ""};
}

void VoxelTextures::applyProperties(const Node& node, VoxelTexture& texture)
{
    const Node* const properties = nodeOf(node, "textureProperties");
    const char* const repeats[] = {"repeatS", "repeatT", "repeatR"};
    const char* const modes[] = {"boundaryModeS", "boundaryModeT", "boundaryModeR"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        texture.repeats[axis] = boolOf(node, repeats[axis]);
        if (!properties) continue;
        const std::string_view mode = stringOf(*properties, modes[axis]);
        texture.repeats[axis] = mode == "REPEAT" && !(axis == 2 && isFlat(node));
        if (mode == "MIRRORED_REPEAT" || mode == "CLAMP_TO_BOUNDARY")
            messages_.warn(*properties, std::string(modes[axis]) + " " + std::string(mode) +
                                            " is not drawn: the value at the edge stays");
    }
    texture.nearest = properties && stringOf(*properties, "magnificationFilter") == "NEAREST_PIXEL";
}

std::shared_ptr<const VoxelTexture>
VoxelTextures::firstComponents(const std::shared_ptr<const VoxelTexture>& texture, int count)
{
    if (!texture || texture->components <= count) return texture;
    // Of textures that were replaced since, nobody else has the key.
    std::erase_if(parts_, [](const auto& part) { return part.first.first.use_count() == 1; });
    auto& kept = parts_[{texture, count}];
    if (kept) return kept;
    auto part = std::make_shared<VoxelTexture>();
    part->size = texture->size;
    part->components = count;
    part->kind = texture->kind;
    part->nearest = texture->nearest;
    part->repeats = texture->repeats;
    const std::size_t from = static_cast<std::size_t>(texture->components) * bytesOf(texture->kind);
    const std::size_t to = static_cast<std::size_t>(count) * bytesOf(texture->kind);
    part->texels.resize(texture->texels.size() / from * to);
    for (std::size_t i = 0; i < part->texels.size() / to; ++i)
        std::memcpy(part->texels.data() + i * to, texture->texels.data() + i * from, to);
    return kept = std::move(part);
}

} // namespace vo
