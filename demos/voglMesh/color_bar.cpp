#include "color_bar.h"

#include "voglMain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace {

constexpr int kGlyphWidth = 5, kGlyphHeight = 7;

/// Rows of dots from the top, the leftmost in the highest of five bits.
struct Glyph
{
    char letter;
    std::array<unsigned char, kGlyphHeight> rows;
};

constexpr Glyph kGlyphs[] = {
    {'0', {14, 17, 19, 21, 25, 17, 14}}, {'1', {4, 12, 4, 4, 4, 4, 14}},
    {'2', {14, 17, 1, 2, 4, 8, 31}},     {'3', {31, 2, 4, 2, 1, 17, 14}},
    {'4', {2, 6, 10, 18, 31, 2, 2}},     {'5', {31, 16, 30, 1, 1, 17, 14}},
    {'6', {6, 8, 16, 30, 17, 17, 14}},   {'7', {31, 1, 2, 4, 8, 8, 8}},
    {'8', {14, 17, 17, 14, 17, 17, 14}}, {'9', {14, 17, 17, 15, 1, 2, 12}},
    {'.', {0, 0, 0, 0, 0, 12, 12}},      {'-', {0, 0, 0, 31, 0, 0, 0}},
    {'+', {0, 4, 4, 31, 4, 4, 0}},       {'e', {0, 0, 14, 17, 31, 16, 14}},
};

/// Boxes in pixels, counted from the lower left corner.
class PixelBoxes
{
public:
    void add(double x0, double y0, double x1, double y1, const float color[3])
    {
        const double x[4] = {x0, x1, x1, x0}, y[4] = {y0, y0, y1, y1};
        float box[4][7];
        for (int i = 0; i < 4; i++) {
            std::copy_n(color, 3, box[i]);
            box[i][3] = 1;
            box[i][4] = float(x[i]);
            box[i][5] = float(y[i]);
            box[i][6] = 0;
        }
        faces_.appendPoly(box[0], 4);
    }

    /// Text over black that ends at `right`, dots of `dot` pixels.
    void addText(const std::string& text, double right, double bottom, double dot)
    {
        static const float white[3] = {1, 1, 1}, black[3] = {0, 0, 0};
        double left = right - double(text.size()) * (kGlyphWidth + 1) * dot;
        add(left - dot, bottom - dot, right, bottom + (kGlyphHeight + 1) * dot, black);
        for (const char letter : text) {
            const auto glyph = std::find_if(std::begin(kGlyphs), std::end(kGlyphs),
                                            [letter](const Glyph& g) { return g.letter == letter; });
            for (int row = 0; glyph != std::end(kGlyphs) && row < kGlyphHeight; row++)
                for (int column = 0; column < kGlyphWidth; column++) {
                    if (!(glyph->rows[std::size_t(row)] >> (kGlyphWidth - 1 - column) & 1)) continue;
                    const double x = left + column * dot, y = bottom + (kGlyphHeight - 1 - row) * dot;
                    add(x, y, x + dot, y + dot, white);
                }
            left += (kGlyphWidth + 1) * dot;
        }
    }

    /// Over the picture.
    void draw(int width, int height)
    {
        GLdouble modelMatrix[16], projMatrix[16];
        vo::getMatrices(modelMatrix, projMatrix);
        const GLdouble one[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
        const GLdouble pixels[16] = {2.0 / width, 0, 0, 0, 0, 2.0 / height, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1};
        vo::loadMatrices(one, pixels);
        gl->Disable(GL_DEPTH_TEST);
        voGeometryActions::draw(&faces_, GL_FILL, voInterleavedArrayTypeScope::C4F_V3F);
        gl->Enable(GL_DEPTH_TEST);
        vo::loadMatrices(modelMatrix, projMatrix);
    }

private:
    voIndexedFaceSet faces_{4096, 7, 5120};
};

} // namespace

std::string barNumber(double value, double range)
{
    if (std::abs(value) < 1e-6 * std::abs(range)) value = 0;
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", value);
    return text;
}

void drawColorBar(const std::vector<float>& rgba, double low, double high)
{
    const VoglView& view = voglView();
    const double dot = std::max(std::floor(view.height / 256.0), 1.0);
    const double right = view.width - 6 * dot, left = right - 10 * dot;
    const double bottom = 8 * dot, top = view.height - 8 * dot;
    PixelBoxes boxes;
    static const float frame[3] = {0.6f, 0.6f, 0.6f};
    boxes.add(left - dot, bottom - dot, right + dot, top + dot, frame);
    const int entries = int(rgba.size() / 4);
    for (int i = 0; i < entries; i++)
        boxes.add(left, bottom + (top - bottom) * i / entries, right,
                  bottom + (top - bottom) * (i + 1) / entries, rgba.data() + 4 * i);
    constexpr int kNumbers = 4;
    for (int i = 0; i <= kNumbers; i++) {
        const double y = bottom + (top - bottom) * i / kNumbers;
        boxes.add(left - 3 * dot, y - dot / 2, left - dot, y + dot / 2, frame);
        boxes.addText(barNumber(low + (high - low) * i / kNumbers, high - low), left - 4 * dot,
                      std::clamp(y - 3.5 * dot, 0.0, view.height - 7 * dot), dot);
    }
    boxes.draw(view.width, view.height);
}
