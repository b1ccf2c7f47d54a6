#pragma once

#include "style/styled_scene.h"
#include "support/reference_styles.h"

#include <span>
#include <vector>

namespace vo::test {

/// The picture of a scene in double precision, as styled_scene.h says: for each pixel red, green, blue
/// (multiplied by alpha) and alpha, rows from the bottom. Samples are taken where the ray through the pixel's
/// centre meets the planes. Styles must come from styleWithReference(). Stipples are left out, and shadows
/// but those of samples. Slow: for pictures of some 64 x 64 pixels.
std::vector<double> styledReference(const StyledScene& scene);

/// How far a picture is from it: decibels of all four channels, peak 1. Not a number where their sizes
/// differ.
double psnr(std::span<const float> picture, const std::vector<double>& reference);

} // namespace vo::test
