#pragma once

#include "style/glsl_chain.h"

#include <glm/vec4.hpp>

#include <span>
#include <string>
#include <vector>

namespace vo {

/// The GLSL of a volume's chains. Chains that differ in numbers and tables alone share their functions, so
/// that a program is as long as there are kinds of chains, not as there are chains.
struct ChainFunctions
{
    /// `vec4 withoutNormals(int chain, vec4 color, StyleSample s)` for the styles at the front of chains,
    /// withNormals for those from the first on that reads one, and chainOf for both.
    std::string text;
    /// The number that programs have for each chain: those of a kind follow each other.
    std::vector<int> numberOf;
    /// What `chainNumbers` has, as a list: the rows of all chains, in the programs' order.
    std::vector<glm::vec4> rows;
};

/// Adds the chains to `glsl`.
ChainFunctions writeChains(GlslChain& glsl, std::span<const StyleChain> chains);

} // namespace vo
