#include <vo/utGeometry.h>

#include "legacy/report.h"

#include "vout/split_cells.h"

#include <algorithm>
#include <cmath>

using vo::badValue;
using vo::guarded;

struct voutIndexedSet::Private
{
    std::unique_ptr<voVertexData> ownVertices;
    std::unique_ptr<voIndices> ownIndices;
    voVertexData* vertices = nullptr;
    voIndices* indices = nullptr;
    vo::HexaSplit split = vo::HexaSplit::five;

    void own(std::unique_ptr<voVertexData> v, std::unique_ptr<voIndices> i)
    {
        ownVertices = std::move(v);
        ownIndices = std::move(i);
        vertices = ownVertices.get();
        indices = ownIndices.get();
    }
    void ownNothing() { own(std::make_unique<voVertexData>(0, 3), std::make_unique<voIndices>(0)); }
};

namespace {

void requireArrays(const float* data, int countV, const int* indices, int countI)
{
    if (!data && countV > 0) badValue("data is NULL");
    if (!indices && countI > 0) badValue("indices are NULL");
}

/// The records of a set as the vertices of a mesh.
vo::TetraMesh meshOf(const voVertexData& vertices)
{
    const int values = vertices.getValuesPerVertex();
    if (values < 3) badValue("records of " + std::to_string(values) + " values have no position");
    vo::TetraMesh mesh;
    mesh.values = values;
    const float* const data = vertices.getDataPtr();
    mesh.records.assign(data, data + static_cast<std::size_t>(vertices.getCount()) * static_cast<std::size_t>(values));
    return mesh;
}

void requireFinite(const vo::Cells& cells, const vo::TetraMesh& mesh)
{
    for (const int corner : cells.corners) {
        const glm::dvec3 p = mesh.position(corner);
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
            badValue("vertex " + std::to_string(corner) + " is not at a finite position");
    }
}

voIndexedTetraSet* tessellated(const char* action, const voutIndexedSet& set, const vo::Arrangement& arrangement,
                               vo::HexaSplit split)
{
    std::unique_ptr<voIndexedTetraSet> tetras;
    guarded(action, [&] {
        vo::TetraMesh mesh = meshOf(*set.getVertexData());
        const voIndices& indices = *set.getIndices();
        const vo::Cells cells =
            vo::cellsOf(arrangement, {indices.getDataPtr(), static_cast<std::size_t>(indices.getCount())},
                        set.getVertexData()->getCount());
        requireFinite(cells, mesh);
        vo::splitCells(cells, split, mesh);
        tetras = vo::tetraSet(mesh);
    });
    return tetras.release();
}

} // namespace

voutIndexedSet::voutIndexedSet(float* data, int countV, int valuesPerVertex, int* indices, int countI)
    : d(new Private)
{
    d->ownNothing();
    guarded("voutIndexedSet", [&] {
        requireArrays(data, countV, indices, countI);
        d->own(std::make_unique<voVertexData>(countV, valuesPerVertex, data),
               std::make_unique<voIndices>(countI, indices));
    });
}

voutIndexedSet::voutIndexedSet(const float* data, int countV, int valuesPerVertex, const int* indices, int countI)
    : voutIndexedSet(countV, valuesPerVertex, countI)
{
    guarded("voutIndexedSet", [&] {
        requireArrays(data, countV, indices, countI);
        if (d->vertices->getCountMax() != countV || d->indices->getCountMax() != countI) return; // reported
        std::copy_n(data, static_cast<std::size_t>(countV) * static_cast<std::size_t>(valuesPerVertex),
                    d->vertices->getDataPtr());
        std::copy_n(indices, countI, d->indices->getDataPtr());
        d->vertices->setCount(countV);
        d->indices->setCount(countI);
    });
}

voutIndexedSet::voutIndexedSet(int countMaxV, int valuesPerVertex, int countMaxI) : d(new Private)
{
    d->own(std::make_unique<voVertexData>(countMaxV, valuesPerVertex), std::make_unique<voIndices>(countMaxI));
}

voutIndexedSet::voutIndexedSet(voVertexData* data, voIndices* indices) : d(new Private)
{
    d->ownNothing();
    guarded("voutIndexedSet", [&] {
        d->vertices = &vo::required(data, "data");
        d->indices = &vo::required(indices, "indices");
    });
    if (data && indices) return;
    d->ownNothing();
}

voutIndexedSet::~voutIndexedSet()
{
    delete d;
}

voVertexData* voutIndexedSet::getVertexData() const
{
    return d->vertices;
}

voIndices* voutIndexedSet::getIndices() const
{
    return d->indices;
}

void voutIndexedSet::empty()
{
    if (d->vertices == d->ownVertices.get()) d->vertices->empty();
    d->indices->empty();
}

void voutIndexedHexaSet::setTetrasPerHexa(int count)
{
    guarded("voutIndexedHexaSet::setTetrasPerHexa", [&] { d->split = vo::hexaSplit(count); });
}

int voutIndexedHexaSet::getTetrasPerHexa() const
{
    return static_cast<int>(d->split);
}

void voutIndexedHexaStrip::setTetrasPerHexa(int count)
{
    guarded("voutIndexedHexaStrip::setTetrasPerHexa", [&] { d->split = vo::hexaSplit(count); });
}

int voutIndexedHexaStrip::getTetrasPerHexa() const
{
    return static_cast<int>(d->split);
}

#define VOUT_INDEXED_SET(Set, arrangement)                                                                     \
    Set::Set(float* data, int countV, int valuesPerVertex, int* indices, int countI)                           \
        : voutIndexedSet(data, countV, valuesPerVertex, indices, countI)                                       \
    {                                                                                                          \
    }                                                                                                          \
    Set::Set(const float* data, int countV, int valuesPerVertex, const int* indices, int countI)               \
        : voutIndexedSet(data, countV, valuesPerVertex, indices, countI)                                       \
    {                                                                                                          \
    }                                                                                                          \
    Set::Set(int countMaxV, int valuesPerVertex, int countMaxI)                                                \
        : voutIndexedSet(countMaxV, valuesPerVertex, countMaxI)                                                \
    {                                                                                                          \
    }                                                                                                          \
    Set::Set(voVertexData* data, voIndices* indices) : voutIndexedSet(data, indices) {}                        \
    voIndexedTetraSet* Set::tessellate()                                                                       \
    {                                                                                                          \
        return tessellated(#Set "::tessellate", *this, arrangement, d->split); \
    }

VOUT_INDEXED_SET(voutIndexedTetraFaceStrip, vo::kTetraFaceStrip)
VOUT_INDEXED_SET(voutIndexedTetraEdgeStrip, vo::kTetraEdgeStrip)
VOUT_INDEXED_SET(voutIndexedHexaSet, vo::kHexaSet)
VOUT_INDEXED_SET(voutIndexedHexaStrip, vo::kHexaStrip)
VOUT_INDEXED_SET(voutIndexedPrismSet, vo::kPrismSet)
VOUT_INDEXED_SET(voutIndexedPrismFaceStrip, vo::kPrismFaceStrip)
VOUT_INDEXED_SET(voutIndexedPrismBaseStrip, vo::kPrismBaseStrip)
VOUT_INDEXED_SET(voutIndexedPrismEdgeStrip, vo::kPrismEdgeStrip)
VOUT_INDEXED_SET(voutIndexedPyramidSet, vo::kPyramidSet)
VOUT_INDEXED_SET(voutIndexedPyramidStrip, vo::kPyramidStrip)

#undef VOUT_INDEXED_SET
