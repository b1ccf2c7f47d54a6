// voglPick: the voxels along the line of sight through a pixel, drawn as a signal at the bottom.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voxel_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

namespace {

constexpr voInterleavedArrayType kFormat = voInterleavedArrayTypeScope::V3F;

VoglVolume volume;
VoglPolygons* polygons;

// The pixel that was picked: by -pick from the lower left corner, or as parts of the window by the mouse.
std::optional<std::array<int, 2>> pickedPixel;
std::optional<std::array<double, 2>> pickedPart;
std::string valuesFile;

// The signal: samples from the nearest to the farthest.
voVertexData* positions;      // records of V3F
std::vector<char> voxels;     // as the bricks have them
std::vector<double> channels; // the values of the file, channel by channel of each sample
int channelCount = 1;

bool pickWithRightButton(vo::Button button, bool, double x, double y)
{
    if (button != vo::Button::Right) return false;
    pickedPixel.reset();
    pickedPart = {x, y};
    return true;
}

int channelsOf(voExternalFormatType format)
{
    switch (format) {
    case voExternalFormatTypeScope::LUMINANCE_ALPHA: return 2;
    case voExternalFormatTypeScope::RGBA:
    case voExternalFormatTypeScope::ABGR_EXT: return 4;
    default: return 1;
    }
}

// The voxels along the line of sight; false: it misses the volume.
bool pickSignal(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    const VoglView& view = voglView();
    // The same place of the window, however large it becomes.
    if (!pickedPart)
        pickedPart = {((*pickedPixel)[0] + 0.5) / view.width, ((*pickedPixel)[1] + 0.5) / view.height};
    pickedPixel = {std::clamp(int((*pickedPart)[0] * view.width), 0, view.width - 1),
                   std::clamp(int((*pickedPart)[1] * view.height), 0, view.height - 1)};
    int pixel[2] = {(*pickedPixel)[0], (*pickedPixel)[1]};
    int viewport[4] = {0, 0, view.width, view.height};
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    const float period = float(options.sampling);
    float samplingPeriod[3] = {period / modelScale[0], period / modelScale[1], period / modelScale[2]};
    const bool hit =
        voGeometryActions::pick(pixel, viewport, aTetraSet, aVolume->getCurrentBrickSet(), kFormat,
                                modelMatrix, projMatrix, samplingPeriod, VO_FALSE, positions, voxels.data());
    // Bricks hold the file's values spread over their type's whole range.
    const voDataType type = aVolume->getCurrentBrickSet()->getBrick(0)->getDataType();
    const vo::ValueRange full = vo::fullRange(type);
    channels = vo::channelValues(type, voxels.data(), std::size_t(positions->getCount() * channelCount));
    for (double& value : channels)
        value = double(volume.loValue) + (value - full.low) / (full.high - full.low) *
                                             (double(volume.hiValue) - double(volume.loValue));
    return hit;
}

// A line a sample: its position in voxels, and the voxel's channels.
void writeValues()
{
    FILE* file = valuesFile == "-" ? stdout : fopen(valuesFile.c_str(), "w");
    bool good = file;
    if (good) good = fprintf(file, "# x y z value, from the nearest\n") > 0;
    for (int i = 0; good && i < positions->getCount(); i++) {
        const float* position = (*positions)[i];
        fprintf(file, "%.6g %.6g %.6g", double(position[0]), double(position[1]), double(position[2]));
        for (int channel = 0; channel < channelCount; channel++)
            fprintf(file, " %.9g", channels[std::size_t(i * channelCount + channel)]);
        good = fprintf(file, "\n") > 0;
    }
    if (file && file != stdout) good = fclose(file) == 0 && good;
    if (!good) voglFail("voglPick", valuesFile + ": cannot be written");
}

void appendQuad(voIndexedFaceSet& faces, const double x[4], const double y[4], const float color[4])
{
    float quad[4][7];
    for (int i = 0; i < 4; i++) {
        std::copy_n(color, 4, quad[i]);
        quad[i][4] = float(x[i]);
        quad[i][5] = float(y[i]);
        quad[i][6] = 0;
    }
    faces.appendPoly(quad[0], 4);
}

void appendBox(voIndexedFaceSet& faces, double x0, double y0, double x1, double y1, const float color[4])
{
    const double x[4] = {x0, x1, x1, x0}, y[4] = {y0, y0, y1, y1};
    appendQuad(faces, x, y, color);
}

// A line two pixels wide.
void appendSegment(voIndexedFaceSet& faces, double x0, double y0, double x1, double y1, const float color[4])
{
    const double length = std::max(std::hypot(x1 - x0, y1 - y0), 1e-6);
    const double u = (y1 - y0) / length, v = -(x1 - x0) / length;
    const double x[4] = {x0 - u, x0 + u, x1 + u, x1 - u}, y[4] = {y0 - v, y0 + v, y1 + v, y1 - v};
    appendQuad(faces, x, y, color);
}

// The signal over a dark ground in the lowest quarter, nearest sample to the left, and a cross at the pixel.
void appendSignal(voIndexedFaceSet& faces, int width, int height)
{
    static const float ground[4] = {0, 0, 0.15f, 0.8f}, cross[4] = {1, 1, 0, 1};
    static const float colors[4][4] = {
        {1, 0.3f, 0.3f, 1}, {0.3f, 1, 0.3f, 1}, {0.4f, 0.5f, 1, 1}, {1, 1, 1, 1}};
    const double top = height / 4.0, margin = std::min(8.0, top / 4);
    appendBox(faces, 0, 0, width, top, ground);
    const double pixelX = (*pickedPixel)[0] + 0.5, pixelY = (*pickedPixel)[1] + 0.5;
    appendBox(faces, pixelX - 6, pixelY - 0.5, pixelX + 6, pixelY + 0.5, cross);
    appendBox(faces, pixelX - 0.5, pixelY - 6, pixelX + 0.5, pixelY + 6, cross);

    const int count = positions->getCount();
    const double across = double(volume.hiValue) - double(volume.loValue);
    const auto atX = [&](int i) { return margin + (width - 2 * margin) * (i + 0.5) / count; };
    const auto atY = [&](int i, int channel) {
        const double value = channels[std::size_t(i * channelCount + channel)];
        return margin + (top - 2 * margin) * (value - double(volume.loValue)) / across;
    };
    for (int channel = 0; channel < channelCount; channel++)
        for (int i = 0; i + 1 < count; i++)
            appendSegment(faces, atX(i), atY(i, channel), atX(i + 1), atY(i + 1, channel),
                          colors[channelCount == 1 ? 3 : channel]);
}

// Over the picture, in pixels.
void drawSignal()
{
    const VoglView& view = voglView();
    voIndexedFaceSet faces(4096, 7, 5120);
    appendSignal(faces, view.width, view.height);
    GLdouble modelMatrix[16], projMatrix[16];
    vo::getMatrices(modelMatrix, projMatrix);
    const GLdouble one[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    const GLdouble pixels[16] = {
        2.0 / view.width, 0, 0, 0, 0, 2.0 / view.height, 0, 0, 0, 0, -1, 0, -1, -1, 0, 1};
    vo::loadMatrices(one, pixels);
    gl->Disable(GL_DEPTH_TEST);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    voGeometryActions::draw(&faces, GL_FILL, voInterleavedArrayTypeScope::C4F_V3F);
    gl->Enable(GL_DEPTH_TEST);
    vo::loadMatrices(modelMatrix, projMatrix);
}

} // namespace

const VoglProgram voglProgram = {
    .purpose = "Draws a volume, and at the bottom the voxels along the line of sight through a pixel, in a\n"
               "window or, with -output, into a picture.",
    .example = "head.tif -lut 80 120 -pick 256 300 -values signal.txt -output pick.png",
    .options = {{"pick",
                 {"X", "Y"},
                 "the pixel, counted from the lower left corner (default: none until the button is pressed)",
                 [](vo::Arguments& a) {
                     const int x = a.integer(0, 16383, "a column of pixels");
                     pickedPixel = {x, a.integer(0, 16383, "a row of pixels")};
                 }},
                {"values",
                 {"FILE"},
                 "write the samples of -pick to FILE (- is standard output): x y z in voxels and the values",
                 [](vo::Arguments& a) { valuesFile = a.text(); }}},
    .keys = "Right button  pick the line of sight under the pointer\n",
    .pointer = pickWithRightButton,
};

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    if (!valuesFile.empty() && !pickedPixel)
        voglFail(argv[0], "option -values: expected -pick too, found none");
    if (pickedPixel && ((*pickedPixel)[0] >= options.width || (*pickedPixel)[1] >= options.height))
        voglFail(argv[0], "option -pick: expected a pixel of " + std::to_string(options.width) + " x " +
                              std::to_string(options.height) + ", found '" +
                              std::to_string((*pickedPixel)[0]) + " " + std::to_string((*pickedPixel)[1]) +
                              "'");
    volume = voglReadVolume(argv[0], voglOpenFile(argv[0], argv[1]));
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection* aVolume)
{
    voIndexedTetraSet* aTetraSet = voglBox(volume);
    polygons = new VoglPolygons(aTetraSet, volume, kFormat);
    positions = new voVertexData(volume.maxSamplesNumber, 3);
    channelCount = channelsOf(aVolume->getCurrentBrickSet()->getBrick(0)->getExternalFormat());
    voxels.resize(std::size_t(volume.maxSamplesNumber) * std::size_t(channelCount) * sizeof(float));
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voglDrawFrame(aTetraSet, aVolume, *polygons);
    if (!pickedPixel && !pickedPart) return;
    const bool hit = pickSignal(aTetraSet, aVolume);
    if (!valuesFile.empty()) writeValues();
    valuesFile.clear();
    if (hit) drawSignal();
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete polygons;
    delete positions;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
