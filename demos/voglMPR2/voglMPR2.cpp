// voglMPR2: cross-sections along a couple of polygons: the two pages of a book that stands in the volume.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglSection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

VoglVolume volume;
VoglSection* sections[2];
double fold = 100, pressedFold, pressedX; // degrees between the pages

bool foldPages(vo::Button button, bool isPress, double x, double)
{
    if (button != vo::Button::Right) return false;
    if (isPress) {
        pressedFold = fold;
        pressedX = x;
    }
    fold = std::clamp(pressedFold + 180 * (x - pressedX), 0.0, 360.0);
    return true;
}

// A page as a polygon of C4F_V3F records in voxels: from the hinge, which is the line through the volume's
// centre along z, far enough to leave the volume.
voVertexData* makePage(double degrees)
{
    double centre[2], length = 0;
    for (int i = 0; i < 2; i++) {
        centre[i] = volume.size[i] / 2.0;
        length = std::hypot(length, volume.size[i] * double(modelScale[i]));
    }
    const double angle = degrees * std::numbers::pi / 180;
    const float outX = float(centre[0] + length * std::sin(angle) / double(modelScale[0]));
    const float outY = float(centre[1] - length * std::cos(angle) / double(modelScale[1]));
    const float hingeX = float(centre[0]), hingeY = float(centre[1]), top = float(volume.size[2]);
    const float corners[4][7] = {{1, 1, 1, 1, hingeX, hingeY, 0},
                                 {1, 1, 1, 1, outX, outY, 0},
                                 {1, 1, 1, 1, outX, outY, top},
                                 {1, 1, 1, 1, hingeX, hingeY, top}};
    voVertexData* page = new voVertexData(4, 7);
    for (int i = 0; i < 4; i++)
        std::copy_n(corners[i], 7, (*page)[i]);
    page->setCount(4);
    return page;
}

} // namespace

const VoglProgram voglProgram = {
    .purpose = "Draws cross-sections of a volume along two polygons, the pages of a half-open book, in a\n"
               "window or, with -output, into a picture.",
    .example = "head.tif -lut 80 160 -fold 120 -view -20 20 -output book.png",
    .options = {{"fold",
                 {"DEGREES"},
                 "angle between the pages, which open towards -y (default 100)",
                 [](vo::Arguments& a) { fold = a.number(0, 360, "an angle in degrees"); }}},
    .ownLoop = true,
    .keys = "Right drag    open and close the book\n",
    .pointer = foldPages,
};

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenFile(argv[0], argv[1]));
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    for (VoglSection*& section : sections)
        section = new VoglSection(volume);
    return voglBox(volume);
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    for (int i = 0; i < 2; i++) {
        voVertexData* page = makePage(i == 0 ? -fold / 2 : fold / 2);
        sections[i]->cut(page);
        delete page;
    }
    // Sums of weighted slices cannot hide one another: the depth of all comes first.
    gl->DepthFunc(GL_LEQUAL);
    for (VoglSection* section : sections)
        section->drawDepth();
    for (VoglSection* section : sections)
        section->draw();
    gl->DepthFunc(GL_LESS);
    voglDrawOutlines(aTetraSet, aVolume, voInterleavedArrayTypeScope::V3F);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    for (VoglSection* section : sections)
        delete section;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
