// voglMPR1: a cross-section of a volume, along a plane at any angle.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglSection.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace {

// Where the plane's normal points, in degrees, and how far the plane is from the volume's centre, as a part
// of half the volume's diagonal. Both in the scaled volume.
struct Plane
{
    double latitude = 30, longitude = 40, offset = 0;
};

VoglVolume volume;
VoglSection* section;
Plane plane, pressed;
double pressedX, pressedY;
std::optional<std::array<float, 4>> given; // by -plane, in voxels

void readPlane(vo::Arguments& arguments)
{
    auto& values = given.emplace();
    for (float& value : values)
        value = float(arguments.number(-1e9, 1e9));
    if (values[0] == 0 && values[1] == 0 && values[2] == 0)
        arguments.fail("A B C that are not all 0", arguments.typed());
}

// The plane as A x + B y + C z + D = 0 in voxels.
std::array<float, 4> planeEquation()
{
    if (given) return *given;
    const double latitude = plane.latitude * std::numbers::pi / 180;
    const double longitude = plane.longitude * std::numbers::pi / 180;
    const double normal[3] = {std::cos(latitude) * std::sin(longitude),
                              -std::cos(latitude) * std::cos(longitude), std::sin(latitude)};
    std::array<float, 4> equation;
    double diagonal = 0, d = 0;
    for (std::size_t i = 0; i < 3; i++) {
        const double scale = double(modelScale[i]);
        diagonal = std::hypot(diagonal, volume.size[i] * scale);
        equation[i] = float(normal[i] * scale);
        d -= normal[i] * scale * volume.size[i] / 2;
    }
    equation[3] = float(d - plane.offset * diagonal / 2);
    return equation;
}

// The right button turns the plane.
bool turnPlane(vo::Button button, bool isPress, double x, double y)
{
    if (button != vo::Button::Right) return false;
    if (isPress) {
        pressed = plane;
        pressedX = x;
        pressedY = y;
    }
    given.reset();
    plane.longitude = pressed.longitude + 180 * (x - pressedX);
    plane.latitude = pressed.latitude + 180 * (y - pressedY);
    return true;
}

bool movePlane(int key)
{
    if (key != '+' && key != '=' && key != '-') return false;
    given.reset();
    plane.offset = std::clamp(plane.offset + (key == '-' ? -0.02 : 0.02), -1.0, 1.0);
    return true;
}

} // namespace

const VoglProgram voglProgram = {
    .purpose = "Draws a cross-section of a volume along a plane, in a window or, with -output, into a "
               "picture.",
    .example = "head.tif -lut 80 160 -plane 1 1 0.5 -200 -output section.png",
    .options = {{"plane",
                 {"A", "B", "C", "D"},
                 "the plane Ax + By + Cz + D = 0 in voxels (default: oblique, through the volume's centre)",
                 readPlane}},
    .ownLoop = true,
    .keys = "Right drag    turn the plane\n"
            "+ -           move the plane along its normal\n",
    .pointer = turnPlane,
    .key = movePlane,
};

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenFile(argv[0], argv[1]));
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    section = new VoglSection(volume);
    return voglBox(volume);
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    gl->Disable(GL_DEPTH_TEST);
    section->cut(planeEquation().data());
    section->draw();
    gl->Enable(GL_DEPTH_TEST);
    voglDrawOutlines(aTetraSet, aVolume, voInterleavedArrayTypeScope::V3F);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete section;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
