#include "support/compare.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

namespace vo::test {

namespace {

constexpr double kOneStep = 1.0 / 255.0;

class SquaredError
{
public:
    void add(double error)
    {
        sum_ += error * error;
        ++count_;
    }

    double psnr() const { return 10.0 * std::log10(static_cast<double>(count_) / sum_); }

private:
    double sum_ = 0.0;
    std::size_t count_ = 0;
};

/// Largest of three; infinite as soon as one is not a number.
double largestOf(const double (&errors)[3])
{
    double largest = 0.0;
    for (const double error : errors)
        largest =
            std::isnan(error) ? std::numeric_limits<double>::infinity() : std::max(largest, std::abs(error));
    return largest;
}

Picture drawnPicture(std::span<const float> rgba)
{
    Picture picture;
    picture.width = static_cast<int>(rgba.size() / 4);
    picture.height = 1;
    picture.rgba.assign(rgba.begin(), rgba.end());
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        picture.rgba[i + 3] = std::max({picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    picture.unmasked.assign(rgba.size() / 4, 1);
    return picture;
}

} // namespace

Comparison compare(std::span<const float> picture, const Picture& reference)
{
    assert(picture.size() == reference.rgba.size() && reference.unmasked.size() * 4 == reference.rgba.size());
    Comparison result;
    SquaredError masked;
    SquaredError all;
    std::size_t off = 0;
    const std::size_t pixels = reference.unmasked.size();
    for (std::size_t i = 0; i < pixels; ++i) {
        const double* expected = reference.rgba.data() + 4 * i;
        const bool counts = reference.unmasked[i] != 0;
        const bool opaque = expected[3] > kOneStep;
        double errors[3];
        for (std::size_t c = 0; c < 3; ++c) {
            errors[c] = static_cast<double>(picture[4 * i + c]) - expected[c];
            if (opaque) all.add(errors[c]);
            if (opaque && counts) masked.add(errors[c]);
        }
        const double largest = largestOf(errors);
        result.largestAll = std::max(result.largestAll, largest);
        if (counts) result.largestMasked = std::max(result.largestMasked, largest);
        off += largest > kOneStep;
        result.opaquePixels += opaque;
        result.maskedPixels += !counts;
    }
    result.psnrMasked = masked.psnr();
    result.psnrAll = all.psnr();
    result.fractionOff = pixels ? static_cast<double>(off) / static_cast<double>(pixels) : 0.0;
    return result;
}

Comparison compareDrawn(std::span<const float> picture, std::span<const float> other)
{
    return compare(picture, drawnPicture(other));
}

std::vector<float> fromBytes(std::span<const std::uint8_t> rgba)
{
    std::vector<float> floats;
    floats.reserve(rgba.size());
    for (const std::uint8_t value : rgba)
        floats.push_back(static_cast<float>(value) / 255.0f);
    return floats;
}

std::string Comparison::summary() const
{
    char line[200];
    std::snprintf(
        line, sizeof line,
        "PSNR %.2f dB masked, %.2f dB all; largest %.2g masked, %.2g all; %.3f%% off by more than 1/255; "
        "%zu pixels drawn, %zu masked",
        psnrMasked, psnrAll, largestMasked, largestAll, 100.0 * fractionOff, opaquePixels, maskedPixels);
    return line;
}

} // namespace vo::test
