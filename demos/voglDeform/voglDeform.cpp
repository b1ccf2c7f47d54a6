// voglDeform: a volume warped by a lattice of boxes, whose vertices may be dragged (guide, pages 14 and 166).
#include "voglMain.h"

#include "drag_vertex.h"
#include "vector_file.h"
#include "voglLattice.h"

#include <array>
#include <optional>
#include <vector>

namespace {

struct Warp
{
    std::string kind;
    double amount = 0;
    std::string file; // of a field
};

struct Drag
{
    double fromX, fromY, toX, toY;
};

int boxes[3] = {8, 8, 8};
int tetrasPerBox = 5;
std::vector<Warp> warps;
std::array<double, 3> fieldScale{1, 1, 1};
std::vector<Drag> drags; // that the first frame makes

void readWarp(vo::Arguments& arguments)
{
    Warp warp;
    warp.kind = arguments.text();
    if (warp.kind == "field")
        warp.file = arguments.text();
    else if (warp.kind == "taper")
        warp.amount = arguments.number(0, 1000, "a factor");
    else if (warp.kind == "twist" || warp.kind == "bend")
        warp.amount = arguments.number(-3600, 3600, "an angle in degrees");
    else
        arguments.fail("twist, bend, taper or field", warp.kind);
    warps.push_back(warp);
}

bool pointer(vo::Button button, bool pressed, double x, double y);
bool undo(int key);

} // namespace

const VoglProgram voglProgram = {
    .purpose = "Draws a volume out of shape: a lattice of boxes lies over it, each vertex says which voxel\n"
               "belongs there, and vertices are moved, by warps or by the mouse.",
    .example = "head.tif -lut 80 120 -warp twist 60 -warp bend 40 -lattice 12 12 12 -view 0 150",
    .options = {voglLatticeOption(boxes),
                {"warp",
                 {"KIND", "AMOUNT"},
                 "twist DEGREES about the z axis, bend DEGREES towards x, taper FACTOR of the top, or field\n"
                 "FILE, a volume of vectors in mm; may be given several times, one is done after the other",
                 readWarp},
                {"fieldScale",
                 {"X", "Y", "Z"},
                 "factors of the vectors' parts (default 1 1 1)",
                 [](vo::Arguments& a) {
                     for (double& factor : fieldScale)
                         factor = a.number(-1e6, 1e6, "a factor");
                 }},
                {"split",
                 {"N"},
                 "tetrahedra in a box: 5, 6 or 24 (default 5)",
                 [](vo::Arguments& a) {
                     tetrasPerBox = a.integer(5, 24, "5, 6 or 24");
                     if (tetrasPerBox > 6 && tetrasPerBox < 24) a.fail("5, 6 or 24", a.typed());
                 }},
                {"drag",
                 {"X0", "Y0", "X1", "Y1"},
                 "drag the vertex nearest to a pixel to another one, counted from the lower left corner, as\n"
                 "the right button does; may be given several times",
                 [](vo::Arguments& a) {
                     double place[4];
                     for (double& coordinate : place)
                         coordinate = a.number(-1e5, 1e5, "a place in pixels");
                     drags.push_back({place[0], place[1], place[2], place[3]});
                 }}},
    .keys = "Right drag    move the vertex under the pointer\n"
            "u             take back all that was dragged\n",
    .pointer = pointer,
    .key = undo,
};

static VoglWarpedVolume volume;
static std::optional<VertexDrag> drag;
static bool latticeChanged = false;

namespace {

bool pointer(vo::Button button, bool pressed, double x, double y)
{
    if (button != vo::Button::Right) return false;
    const VoglView& view = voglView();
    if (pressed) drag.emplace(volume.getLattice(), view, x * view.width, y * view.height);
    if (!drag) return true;
    drag->dragTo(volume.getLattice(), view, x * view.width, y * view.height);
    latticeChanged = true;
    return true;
}

void displace(voutLattice& lattice, const Warp& warp)
{
    auto grid = readVectors(warp.file);
    if (!grid) voglFail("voglDeform", grid.failure().text);
    for (std::size_t i = 0; i < grid->parts.size(); i++)
        grid->parts[i] *= float(fieldScale[i % 3]);
    lattice.displace(grid->parts.data(), grid->size);
}

void warpLattice(voutLattice& lattice)
{
    for (const Warp& warp : warps) {
        if (warp.kind == "twist") lattice.twist(2, float(warp.amount));
        if (warp.kind == "bend") lattice.bend(2, 0, float(warp.amount));
        if (warp.kind == "taper") lattice.taper(2, float(warp.amount));
        if (warp.kind == "field") displace(lattice, warp);
    }
    if (!warps.empty()) lattice.fit();
}

bool undo(int key)
{
    if (key != 'u') return false;
    drag.reset();
    volume.getLattice().reset();
    warpLattice(volume.getLattice());
    latticeChanged = true;
    return true;
}

void makeDrags()
{
    for (const Drag& each : drags)
        VertexDrag(volume.getLattice(), voglView(), each.fromX, each.fromY)
            .dragTo(volume.getLattice(), voglView(), each.toX, each.toY);
    latticeChanged = latticeChanged || !drags.empty();
    drags.clear();
}

} // namespace

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    return volume.read(argv[0], argv[1]);
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    voutLattice& lattice = volume.makeLattice(boxes);
    lattice.setTetrasPerHexa(tetrasPerBox);
    warpLattice(lattice);
    return volume.tessellate();
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    volume.initTextures();
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    makeDrags();
    if (latticeChanged) volume.moveTetras(aTetraSet);
    latticeChanged = false;
    volume.draw(aTetraSet);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    volume.free();
    delete aTetraSet;
}
