#include "draw/chain_functions.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace vo {

namespace {

/// Chains with one text.
struct Kind
{
    std::vector<std::size_t> chains;
    std::vector<bool> differ; ///< which of their uniforms do

    std::size_t rowLength() const { return static_cast<std::size_t>(std::ranges::count(differ, true)); }
};

using Numbers = std::vector<GlslChain::Uniform>;

/// The styles at the front that read no normal, and the others.
void writeChain(GlslChain& glsl, const StyleChain& chain, const std::string& number)
{
    const auto middle = std::ranges::find_if(chain, [](const auto& style) { return style->needsNormal(); });
    const auto writePart = [&glsl](auto from, auto to, const std::string& name) {
        std::for_each(from, to, [&glsl](const auto& style) { style->write(glsl); });
        glsl.endFunction(name);
    };
    writePart(chain.begin(), middle, "front" + number);
    writePart(middle, chain.end(), "rest" + number);
}

/// What chains of one kind have in common, beside the types of their uniforms; one without styles is none
/// whose styles do nothing, since projections ask for that.
std::string textOf(const GlslChain& glsl, const StyleChain& chain)
{
    std::string text = chain.empty() ? "empty" : "";
    text += glsl.declarations() + glsl.functions();
    for (const GlslChain::Texture& texture : glsl.textures())
        text += std::to_string(texture.texture->serial) + " ";
    return text;
}

/// All kinds in the order of their first chains, and the uniforms of each chain.
std::vector<Kind> findKinds(const GlslChain& glsl, std::span<const StyleChain> chains,
                            std::vector<Numbers>& numbers)
{
    std::vector<Kind> kinds;
    std::unordered_map<std::string, std::size_t> kindOf;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        GlslChain alone(glsl.tableStack());
        writeChain(alone, chains[i], "");
        numbers.push_back(alone.uniforms());
        const auto [found, isNew] = kindOf.emplace(textOf(alone, chains[i]), kinds.size());
        if (isNew) kinds.emplace_back().differ.resize(numbers[i].size());
        Kind& kind = kinds[found->second];
        kind.chains.push_back(i);
        const Numbers& first = numbers[kind.chains.front()];
        for (std::size_t n = 0; n < first.size(); ++n)
            if (numbers[i][n].value != first[n].value) kind.differ[n] = true;
    }
    return kinds;
}

glm::vec4 inVector(const GlslChain::Value& value)
{
    struct
    {
        glm::vec4 operator()(int number) const { return glm::vec4(static_cast<float>(number), 0, 0, 0); }
        glm::vec4 operator()(float number) const { return {number, 0, 0, 0}; }
        glm::vec4 operator()(const glm::vec2& vector) const { return {vector, 0, 0}; }
        glm::vec4 operator()(const glm::vec3& vector) const { return {vector, 0}; }
        glm::vec4 operator()(const glm::vec4& vector) const { return vector; }
    } const widened;
    return std::visit(widened, value);
}

/// The row of a chain with these uniforms.
void addRow(const Kind& kind, const Numbers& numbers, std::vector<glm::vec4>& rows)
{
    for (std::size_t n = 0; n < numbers.size(); ++n)
        if (kind.differ[n]) rows.push_back(inVector(numbers[n].value));
}

} // namespace

ChainFunctions writeChains(GlslChain& glsl, std::span<const StyleChain> chains)
{
    std::vector<Numbers> numbers;
    const std::vector<Kind> kinds = findKinds(glsl, chains, numbers);
    ChainFunctions written;
    written.numberOf.resize(chains.size());
    constexpr const char* kParameters = "(int chain, vec4 color, StyleSample s)\n{\n";
    std::string without = std::string("vec4 withoutNormals") + kParameters;
    std::string with = std::string("vec4 withNormals") + kParameters;
    int first = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        const Kind& kind = kinds[k];
        const std::string number = std::to_string(k);
        glsl.beginRow(kind.differ);
        writeChain(glsl, chains[kind.chains.front()], number);
        const std::string row = std::to_string(written.rows.size()) + " + " +
                                std::to_string(kind.rowLength()) + " * (chain - " + std::to_string(first) +
                                ")";
        for (const std::size_t chain : kind.chains) {
            written.numberOf[chain] = first++;
            addRow(kind, numbers[chain], written.rows);
        }
        const bool isLast = k + 1 == kinds.size();
        const std::string choice =
            isLast ? "    return " : "    if (chain < " + std::to_string(first) + ") return ";
        without += choice + "front" + number + "(" + row + ", color, s);\n";
        with += choice + "rest" + number + "(" + row + ", color, s);\n";
    }
    written.text = without + "}\n" + with + "}\nvec4 chainOf" + kParameters +
                   "    return withNormals(chain, withoutNormals(chain, color, s), s);\n}\n";
    return written;
}

} // namespace vo
