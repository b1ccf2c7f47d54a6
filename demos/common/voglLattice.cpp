#include "voglLattice.h"

#include "voglLookup.h"

#include <algorithm>

namespace {

const voInterleavedArrayType format = voInterleavedArrayTypeScope::T3F_V3F;

// A quadrilateral of four neighbouring vertices; `across` is the axis that all four share a place on.
void appendFace(const voutLattice& lattice, const std::array<int, 3>& at, std::size_t across,
                voIndices& indices)
{
    const std::size_t u = (across + 1) % 3, v = (across + 2) % 3;
    int count = indices.getCount();
    indices.setCount(count + 5);
    indices[count++] = 4;
    for (int corner = 0; corner < 4; corner++) {
        std::array<int, 3> place = at;
        place[u] += corner == 1 || corner == 2;
        place[v] += corner >= 2;
        indices[count++] = lattice.getVertexIndex(place[0], place[1], place[2]);
    }
}

// The faces of all boxes, those between two of them once, on the vertices of the lattice's tetrahedra.
std::unique_ptr<voIndexedFaceSet> makeBoxes(const voutLattice& lattice, voIndexedTetraSet* tetraSet)
{
    std::array<int, 3> boxes;
    lattice.getSizes(boxes[0], boxes[1], boxes[2]);
    auto faces =
        std::make_unique<voIndexedFaceSet>(tetraSet->getVertexData(), 5 * 3 * lattice.getVertexCount());
    for (std::size_t across = 0; across < 3; across++) {
        std::array<int, 3> end = boxes;
        end[across]++;
        for (int k = 0; k < end[2]; k++)
            for (int j = 0; j < end[1]; j++)
                for (int i = 0; i < end[0]; i++)
                    appendFace(lattice, {i, j, k}, across, *faces->getIndices());
    }
    return faces;
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

voBrickSetCollection* VoglWarpedVolume::read(const char* program, const char* fileName)
{
    program_ = program;
    const VoglSource source = voglOpenFile(program, fileName);
    volume_ = voglReadVolume(program, source);
    for (std::size_t axis = 0; axis < 3; axis++)
        spacing_[axis] = options.scale ? (*options.scale)[axis] : source.spacing[axis];
    return volume_.bricks;
}

voutLattice& VoglWarpedVolume::makeLattice(const int boxes[3])
{
    const float lower[3] = {0, 0, 0};
    float upper[3], spacing[3];
    for (int axis = 0; axis < 3; axis++) {
        upper[axis] = float(getSize(axis));
        spacing[axis] = float(getSpacing(axis));
    }
    lattice_ = std::make_unique<voutLattice>(boxes[0], boxes[1], boxes[2], lower, upper);
    lattice_->setSpacing(spacing);
    return *lattice_;
}

// Where the number of tetrahedra that are inside out is another than the last time.
void VoglWarpedVolume::reportFolds()
{
    const int inverted = lattice_->countInverted();
    if (inverted == foldsReported_) return;
    foldsReported_ = inverted;
    fprintf(stderr, "%s: %d tetrahedra are inside out; what lies in them is drawn twice\n", program_.c_str(),
            inverted);
}

voIndexedTetraSet* VoglWarpedVolume::tessellate()
{
    reportFolds();
    voIndexedTetraSet* tetraSet = lattice_->tessellate();
    polygons_ = std::make_unique<VoglPolygons>(tetraSet, volume_, format);
    return tetraSet;
}

void VoglWarpedVolume::initTextures()
{
    voglInitTextures(volume_);
}

void VoglWarpedVolume::moveTetras(voIndexedTetraSet* tetraSet)
{
    reportFolds();
    const std::unique_ptr<voIndexedTetraSet> moved(lattice_->tessellate());
    if (!moved) return; // reported
    voVertexData& vertices = *moved->getVertexData();
    std::copy_n(vertices.getDataPtr(), vertices.getCount() * vertices.getValuesPerVertex(),
                tetraSet->getVertexData()->getDataPtr());
    polygons_ = std::make_unique<VoglPolygons>(tetraSet, volume_, format);
}

// Without the bricks, which are not where the lattice takes them.
void VoglWarpedVolume::drawBoxes(voIndexedTetraSet* tetraSet)
{
    if (!options.wireframe) return;
    if (!boxes_) boxes_ = makeBoxes(*lattice_, tetraSet);
    voAppearanceActions::textureDisable(volume_.bricks->getInterpolationType());
    vo::setColor(1, 1, 0, 1);
    voGeometryActions::draw(boxes_.get(), GL_LINE, format);
}

void VoglWarpedVolume::draw(voIndexedTetraSet* tetraSet)
{
    voglChooseStack(volume_.bricks);
    drawBoxes(tetraSet);
    voglDrawPolygons(volume_.bricks, *polygons_);
}

void VoglWarpedVolume::free()
{
    boxes_.reset();
    polygons_.reset();
    lattice_.reset();
    deleteLookupTable();
    voglFreeVolume(volume_);
}
