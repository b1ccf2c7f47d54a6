#pragma once

#include "support/reference_styles.h"

#include <glm/vec4.hpp>

#include <string>
#include <vector>

namespace vo::test {

/// Styles to be compared with the reference.
struct StyleCase
{
    std::string name;
    std::vector<ReferenceStyle> styles; ///< one after the other
    StyleSurroundings surroundings;

    StyleChain chain() const;
};

/// All styles, with what turns in their equations.
std::vector<StyleCase> styleCases();

/// The samples of the comparison: edges of the ranges among them, samples without normal and without opacity.
/// They agree to the bit with what floats hold.
std::vector<ReferenceSample> caseSamples();

/// Colour and opacity of each sample after the styles, in double precision.
std::vector<glm::dvec4> referenceColors(const StyleCase& styleCase,
                                        const std::vector<ReferenceSample>& samples);

/// Peak signal to noise, in decibels, for a peak of 1.
double psnr(const std::vector<glm::dvec4>& expected, const std::vector<glm::vec4>& found);

} // namespace vo::test
