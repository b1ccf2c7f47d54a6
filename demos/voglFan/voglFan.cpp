// voglFan: a volume of ultrasound, beams side by side in the file, in the shape that was scanned (guide, page
// 14).
#include "voglMain.h"

#include "voglLattice.h"

#include <algorithm>
#include <optional>

namespace {

struct Radii
{
    double inner, outer;
};

int boxes[3] = {0, 0, 0}; // 0: as many as the shape asks for
double angle = 75, elevation = 0;
std::optional<Radii> radii;
int depthAxis = 1, beamAxis = 0;

void readRadii(vo::Arguments& arguments)
{
    radii.emplace();
    radii->inner = arguments.number(0, 1e9, "a radius");
    radii->outer = arguments.number(0, 1e9, "a radius");
    if (!(radii->inner < radii->outer)) arguments.fail("R0 below R1", arguments.typed());
}

int readAxis(vo::Arguments& arguments)
{
    const std::string name = arguments.text();
    if (name == "x" || name == "y" || name == "z") return name[0] - 'x';
    arguments.fail("x, y or z", name);
    return 0;
}

} // namespace

const VoglProgram voglProgram = {
    .purpose = "Draws a volume of beams as the fan that they were scanned in: depth runs along one axis of\n"
               "the file and the beams' directions along another; no voxel is resampled.",
    .example = "beams.nrrd -angle 70 -radius 15 75 -elevation 40 -view 70 30",
    .options = {{"angle",
                 {"DEGREES"},
                 "between the first beam and the last one (default 75)",
                 [](vo::Arguments& a) { angle = a.number(0.1, 360, "an angle in degrees"); }},
                {"radius",
                 {"R0", "R1"},
                 "of the first sample of a beam and the last one, in units of the file's spacing\n"
                 "(default: as deep as the file is, from a third of that on)",
                 readRadii},
                {"elevation",
                 {"DEGREES"},
                 "swing from the first frame to the last one (default 0: frames lie side by side)",
                 [](vo::Arguments& a) { elevation = a.number(0, 180, "an angle in degrees"); }},
                {"axes",
                 {"DEPTH", "BEAM"},
                 "axes of the file, x, y or z, along which the depth and the beams run (default y x)",
                 [](vo::Arguments& a) {
                     depthAxis = readAxis(a);
                     beamAxis = readAxis(a);
                     if (depthAxis == beamAxis) a.fail("two axes", a.typed());
                 }},
                voglLatticeOption(boxes)},
};

static VoglWarpedVolume volume;

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    return volume.read(argv[0], argv[1]);
}

// A box for every three degrees, and half as many along the beams, which stay straight.
static void chooseBoxes()
{
    if (boxes[0] > 0) return;
    boxes[beamAxis] = std::clamp(int(angle / 3), 1, 64);
    boxes[depthAxis] = 12;
    boxes[3 - depthAxis - beamAxis] = std::clamp(int(elevation / 3), 1, 64);
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    chooseBoxes();
    voutLattice& lattice = volume.makeLattice(boxes);
    const double depth = volume.getSize(depthAxis) * volume.getSpacing(depthAxis);
    const Radii fan = radii.value_or(Radii{depth / 3, depth / 3 + depth});
    lattice.fan(depthAxis, beamAxis, float(angle), float(fan.inner), float(fan.outer), float(elevation));
    lattice.fit();
    return volume.tessellate();
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    volume.initTextures();
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    volume.draw(aTetraSet);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    volume.free();
    delete aTetraSet;
}
