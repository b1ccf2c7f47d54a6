#include "style/glsl_chain.h"

#include <algorithm>

namespace vo {

namespace {

constexpr const char* kChainNumberGlsl =
    "vec4 chainNumber(int i) { return texelFetch(chainNumbers, listPlace(i), 0); }\n";

const char* typeOf(const GlslChain::Value& value)
{
    constexpr std::array kTypes{"int", "float", "vec2", "vec3", "vec4"};
    return kTypes.at(value.index());
}

} // namespace

void GlslChain::function(std::string_view name, std::string_view text)
{
    if (std::ranges::find(defined_, name) != defined_.end()) return;
    defined_.emplace_back(name);
    functions_.append(text).append("\n");
}

void GlslChain::beginRow(std::vector<bool> differ)
{
    hasRow_ = true;
    differ_ = std::move(differ);
    asked_ = inRow_ = 0;
}

std::string GlslChain::numberInRow(const Value& value)
{
    function("chainNumber", kChainNumberGlsl);
    std::string name("n");
    name += std::to_string(inRow_);
    const std::string type = typeOf(value);
    rowReads_ +=
        "    " + type + " " + name + " = " + type + "(chainNumber(row + " + std::to_string(inRow_) + "));\n";
    ++inRow_;
    return name;
}

std::string GlslChain::uniform(const Value& value)
{
    if (const std::size_t number = asked_++; number < differ_.size() && differ_[number])
        return numberInRow(value);
    std::string name("u");
    name += std::to_string(uniforms_.size());
    uniforms_.push_back({name, value});
    declarations_.append("uniform ").append(typeOf(value)).append(" ").append(name).append(";\n");
    return name;
}

std::string GlslChain::texture(std::shared_ptr<const VoxelTexture> texture)
{
    const auto same = std::ranges::find(textures_, texture, &Texture::texture);
    if (same != textures_.end()) return same->name;
    std::string name("styleTexture");
    name += std::to_string(textures_.size());
    textures_.push_back({name, std::move(texture)});
    declarations_.append("uniform sampler3D ").append(name).append(";\n");
    return name;
}

void GlslChain::step(std::string_view name, const std::vector<std::string>& arguments)
{
    steps_.append("    color = ").append(name).append("(color, s");
    for (const std::string& argument : arguments)
        steps_.append(", ").append(argument);
    steps_.append(");\n");
}

void GlslChain::statement(std::string_view text)
{
    steps_.append("    ").append(text).append("\n");
}

void GlslChain::endFunction(std::string_view name)
{
    functions_.append("vec4 ")
        .append(name)
        .append(hasRow_ ? "(int row, " : "(")
        .append("vec4 color, StyleSample s)\n{\n");
    functions_.append(rowReads_).append(steps_).append("    return color;\n}\n");
    rowReads_.clear();
    steps_.clear();
}

} // namespace vo
