#include "style/shadow_textures.h"

#include "style/glsl_chain.h"
#include "style/shadow_grid.h"
#include "style/styled_voxels.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

namespace vo {

namespace {

constexpr std::size_t kMostKept = 8;

/// All that the opacity of a volume's places hangs on. The text of a chain, with its numbers and textures,
/// says what it does.
struct ShadowKey
{
    std::uint64_t voxels = 0;
    std::shared_ptr<const StyledTetras> tetras; ///< held, so that no others lie where they did
    glm::vec3 dimensions{0.0f};
    double unitLength = 0.0;
    std::string text;
    std::vector<GlslChain::Value> numbers;
    std::vector<std::uint64_t> textures;
    std::vector<glm::dvec4> clipPlanes; ///< local
    std::vector<int> segments;
    std::vector<float> surfaces;

    bool operator==(const ShadowKey&) const = default;
};

const std::vector<StyleChain>& chainsOf(const StyledVolume& volume)
{
    return volume.surfaces ? volume.surfaces->chains : volume.chains;
}

ShadowKey keyOf(const StyledVolume& volume)
{
    ShadowKey key;
    key.voxels = volume.voxels->serial;
    key.tetras = volume.tetras;
    key.dimensions = volume.dimensions;
    key.unitLength = volume.unitLength;
    GlslChain glsl;
    for (const StyleChain& chain : chainsOf(volume)) {
        for (const auto& style : chain)
            style->write(glsl);
        glsl.endFunction("chain");
    }
    key.text = glsl.functions();
    for (const GlslChain::Uniform& uniform : glsl.uniforms())
        key.numbers.push_back(uniform.value);
    for (const GlslChain::Texture& texture : glsl.textures())
        key.textures.push_back(texture.texture->serial);
    for (const glm::dvec4& plane : volume.clipPlanes)
        key.clipPlanes.push_back(plane * volume.worldFromLocal);
    if (volume.segments) {
        key.textures.push_back(volume.segments->identifiers->serial);
        key.segments = volume.segments->chainOf;
        key.segments.push_back(volume.segments->beyond);
        key.segments.push_back(volume.segments->component);
        key.numbers.emplace_back(volume.segments->scale);
    }
    if (volume.surfaces) key.surfaces = volume.surfaces->values;
    return key;
}

bool castSameShadows(const StyleLight& a, const StyleLight& b)
{
    const bool isFar = a.kind == StyleLight::Kind::directional;
    if (isFar != (b.kind == StyleLight::Kind::directional)) return false;
    return isFar ? a.direction == b.direction : a.position == b.position;
}

struct LightShadow
{
    StyleLight light;
    std::vector<std::uint16_t> through;
};

/// Up to four lights side by side, from the first on.
std::shared_ptr<const VoxelTexture> textureOf(const VoxelSize& size, const std::vector<LightShadow>& lights,
                                              std::size_t first)
{
    const std::size_t components = std::min<std::size_t>(4, lights.size() - first);
    auto texture = std::make_shared<VoxelTexture>();
    texture->size = size;
    texture->components = static_cast<int>(components);
    texture->kind = TexelKind::uint16;
    texture->texels.resize(size.count() * components * sizeof(std::uint16_t));
    for (std::size_t c = 0; c < components; ++c) {
        const std::vector<std::uint16_t>& through = lights[first + c].through;
        std::byte* to = texture->texels.data() + c * sizeof(std::uint16_t);
        for (std::size_t i = 0; i < through.size(); ++i, to += components * sizeof(std::uint16_t))
            std::memcpy(to, &through[i], sizeof(std::uint16_t));
    }
    return texture;
}

} // namespace

struct ShadowStore::Kept
{
    ShadowKey key;
    ShadowGrid grid;
    std::vector<LightShadow> lights;
    ShadowTextures textures;

    /// The shadows of lights, new where none of before is the same.
    const ShadowTextures& texturesFor(const std::vector<StyleLight>& wanted, int threads)
    {
        const std::size_t count = std::min(wanted.size(), kMostLights);
        const auto isSame = [](const LightShadow& a, const StyleLight& b) {
            return castSameShadows(a.light, b);
        };
        const auto end = wanted.begin() + static_cast<std::ptrdiff_t>(count);
        if (std::equal(lights.begin(), lights.end(), wanted.begin(), end, isSame)) return textures;
        std::vector<LightShadow> fresh;
        for (auto light = wanted.begin(); light != end; ++light) {
            const auto before = std::ranges::find_if(
                lights, [&](const LightShadow& shadow) { return isSame(shadow, *light); });
            if (before == lights.end())
                fresh.push_back({*light, lightThrough(grid, *light, threads)});
            else
                fresh.push_back(*before);
        }
        lights = std::move(fresh);
        textures = {{}, grid.box};
        for (std::size_t first = 0; first < count; first += 4)
            textures.textures.push_back(textureOf(grid.size, lights, first));
        return textures;
    }
};

ShadowStore::ShadowStore() = default;
ShadowStore::~ShadowStore() = default;

ShadowStore::Kept& ShadowStore::keptFor(const StyledVolume& volume, int threads)
{
    const ShadowKey key = keyOf(volume);
    const auto found = std::ranges::find_if(kept_, [&](const auto& kept) { return kept->key == key; });
    if (found != kept_.end()) {
        std::rotate(found, found + 1, kept_.end());
        return *kept_.back();
    }
    if (kept_.size() >= kMostKept) kept_.erase(kept_.begin());
    kept_.push_back(std::make_unique<Kept>(Kept{key, shadowGridOf(volume, threads), {}, {}}));
    return *kept_.back();
}

void ShadowStore::add(StyledVolume& volume, int threads)
{
    if (!isSound(volume)) return;
    if (volume.surroundings.lights.empty() || std::ranges::none_of(chainsOf(volume), asksForShadows)) return;
    Kept& kept = keptFor(volume, threads);
    if (kept.grid.texels.empty()) return;
    const ShadowTextures& textures = kept.texturesFor(volume.surroundings.lights, threads);
    for (StyleChain& chain : volume.surfaces ? volume.surfaces->chains : volume.chains)
        chain = chainWithShadows(chain, textures);
}

bool asksForShadows(const StyleChain& chain)
{
    return std::ranges::any_of(chain, [](const auto& style) { return style->asksForShadows(); });
}

StyleChain chainWithShadows(const StyleChain& chain, const ShadowTextures& textures)
{
    StyleChain made;
    for (const auto& style : chain) {
        auto shadowed = style->withShadows(textures);
        made.push_back(shadowed ? std::move(shadowed) : style);
    }
    return made;
}

} // namespace vo
