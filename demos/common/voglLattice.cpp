#include "voglLattice.h"

#include <algorithm>
#include <array>
#include <utility>

namespace {

// A quadrilateral of four neighbouring vertices; `across` is the axis that all four share a place on.
void appendFace(const voutLattice& lattice, std::array<int, 3> at, std::size_t across,
                voIndexedFaceSet& faces)
{
    const std::size_t u = (across + 1) % 3, v = (across + 2) % 3;
    float corners[4][3];
    for (int corner = 0; corner < 4; corner++) {
        std::array<int, 3> place = at;
        place[u] += corner == 1 || corner == 2;
        place[v] += corner >= 2;
        lattice.getVertex(lattice.getVertexIndex(place[0], place[1], place[2]), corners[corner]);
    }
    faces.appendPoly(corners[0], 4);
}

// The faces of all boxes, those between two of them once.
void drawBoxes(const voutLattice& lattice)
{
    std::array<int, 3> boxes;
    lattice.getSizes(boxes[0], boxes[1], boxes[2]);
    voIndexedFaceSet faces(4 * 3 * lattice.getVertexCount(), 3, 5 * 3 * lattice.getVertexCount());
    for (std::size_t across = 0; across < 3; across++) {
        std::array<int, 3> end = boxes;
        end[across]++;
        for (int k = 0; k < end[2]; k++)
            for (int j = 0; j < end[1]; j++)
                for (int i = 0; i < end[0]; i++)
                    appendFace(lattice, {i, j, k}, across, faces);
    }
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(&faces, GL_LINE, voInterleavedArrayTypeScope::V3F);
}

} // namespace

vo::OwnOption voglLatticeOption(int boxes[3])
{
    return {
        "lattice", {"NX", "NY", "NZ"}, "boxes of the lattice along x, y and z", [boxes](vo::Arguments& a) {
            for (int axis = 0; axis < 3; axis++)
                boxes[axis] = a.integer(1, 128, "a number of boxes");
        }};
}

std::unique_ptr<voutLattice> voglMakeLattice(const int boxes[3], const VoglVolume& volume,
                                             const VoglSource& source)
{
    float lower[3], upper[3], spacing[3];
    for (int axis = 0; axis < 3; axis++) {
        lower[axis] = 0;
        upper[axis] = float(volume.size[axis]);
        spacing[axis] = float(options.scale ? (*options.scale)[std::size_t(axis)] : source.spacing[axis]);
    }
    auto lattice = std::make_unique<voutLattice>(boxes[0], boxes[1], boxes[2], lower, upper);
    lattice->setSpacing(spacing);
    return lattice;
}

void voglMoveTetras(voutLattice& lattice, voIndexedTetraSet* tetraSet)
{
    const std::unique_ptr<voIndexedTetraSet> moved(lattice.tessellate());
    if (!moved) return; // reported
    voVertexData& vertices = *moved->getVertexData();
    std::copy_n(vertices.getDataPtr(), vertices.getCount() * vertices.getValuesPerVertex(),
                tetraSet->getVertexData()->getDataPtr());
}

void voglReportFolds(const char* program, const voutLattice& lattice)
{
    static int reported = 0;
    const int inverted = lattice.countInverted();
    if (inverted == reported) return;
    reported = inverted;
    fprintf(stderr, "%s: %d tetrahedra are inside out; what lies in them is drawn twice\n", program,
            inverted);
}

void voglDrawLatticeFrame(const voutLattice& lattice, voIndexedTetraSet* tetraSet,
                          voBrickSetCollection* bricks, VoglPolygons& polygons)
{
    const bool wireframe = std::exchange(options.wireframe, false);
    if (wireframe) {
        voAppearanceActions::textureDisable(bricks->getInterpolationType());
        drawBoxes(lattice);
    }
    voglDrawFrame(tetraSet, bricks, polygons);
    options.wireframe = wireframe;
}
