#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include <algorithm>
#include <climits>
#include <cstring>
#include <functional>

using vo::badValue;
using vo::guarded;

namespace {

std::string outside(const char* what, int number, int count)
{
    return std::string(what) + " " + std::to_string(number) + " is outside 0 to " + std::to_string(count - 1);
}

/// Makes room for `count` records or entries in storage of our own; geometric growth.
template <typename Private, typename T>
void grow(Private& d, std::vector<T>& own, int count, int valuesEach)
{
    if (count <= d.countMax) return;
    const int larger =
        static_cast<int>(std::min<long long>(std::max<long long>(count, 2LL * d.countMax), INT_MAX));
    own.resize(static_cast<std::size_t>(larger) * static_cast<std::size_t>(valuesEach));
    d.data = own.data();
    d.countMax = larger;
}

bool ownsStorage(const voInside::VertexData& d)
{
    return d.data == d.own.data();
}

} // namespace

voVertexData::voVertexData(int countMax, int valuesPerVertex, float* data) : d(new Private)
{
    d->data = d->own.data();
    guarded("voVertexData", [&] {
        if (countMax < 0) badValue("countMax is " + std::to_string(countMax) + ", 0 or more is needed");
        if (valuesPerVertex < 1)
            badValue("valuesPerVertex is " + std::to_string(valuesPerVertex) + ", 1 or more is needed");
        d->values = valuesPerVertex;
        if (data) {
            d->data = data;
            d->count = countMax;
        } else {
            d->own.resize(static_cast<std::size_t>(countMax) * static_cast<std::size_t>(valuesPerVertex));
            d->data = d->own.data();
        }
        d->countMax = countMax;
    });
}

voVertexData::~voVertexData()
{
    delete d;
}

void voVertexData::empty()
{
    d->count = 0;
}

float* voVertexData::operator[](int i)
{
    return const_cast<float*>(static_cast<const voVertexData&>(*this)[i]);
}

const float* voVertexData::operator[](int i) const
{
    const float* record = nullptr;
    guarded("voVertexData", [&] {
        if (i < 0 || i >= d->countMax) badValue(outside("record", i, d->countMax));
        record = d->data + static_cast<std::size_t>(i) * static_cast<std::size_t>(d->values);
    });
    return record;
}

int voVertexData::getCount() const
{
    return d->count;
}

void voVertexData::setCount(int count)
{
    guarded("voVertexData::setCount", [&] {
        if (count < 0 || count > d->countMax) badValue(outside("count", count, d->countMax + 1));
        d->count = count;
    });
}

int voVertexData::getCountMax() const
{
    return d->countMax;
}

int voVertexData::getValuesPerVertex() const
{
    return d->values;
}

float* voVertexData::getDataPtr()
{
    return d->data;
}

const float* voVertexData::getDataPtr() const
{
    return d->data;
}

voIndices::voIndices(int countMax, int* indices) : d(new Private)
{
    guarded("voIndices", [&] {
        if (countMax < 0) badValue("countMax is " + std::to_string(countMax) + ", 0 or more is needed");
        if (indices) {
            d->data = indices;
            d->count = countMax;
        } else {
            d->own.resize(static_cast<std::size_t>(countMax));
            d->data = d->own.data();
        }
        d->countMax = countMax;
    });
}

voIndices::~voIndices()
{
    delete d;
}

void voIndices::empty()
{
    d->count = 0;
}

int& voIndices::operator[](int i)
{
    int* entry = &d->scratch;
    guarded("voIndices", [&] {
        if (i < 0 || i >= d->countMax) badValue(outside("entry", i, d->countMax));
        entry = d->data + i;
    });
    return *entry;
}

int voIndices::operator[](int i) const
{
    return const_cast<voIndices&>(*this)[i];
}

int voIndices::getCount() const
{
    return d->count;
}

void voIndices::setCount(int count)
{
    guarded("voIndices::setCount", [&] {
        if (count < 0 || count > d->countMax) badValue(outside("count", count, d->countMax + 1));
        d->count = count;
    });
}

int voIndices::getCountMax() const
{
    return d->countMax;
}

int* voIndices::getDataPtr()
{
    return d->data;
}

const int* voIndices::getDataPtr() const
{
    return d->data;
}

voIndexedSet::voIndexedSet() : d(new Private) {}

voIndexedSet::~voIndexedSet()
{
    delete d;
}

voVertexData* voIndexedSet::getVertexData() const
{
    return d->vertices;
}

voIndices* voIndexedSet::getIndices() const
{
    return d->indices;
}

void voIndexedSet::empty()
{
    if (d->ownVertices) d->vertices->empty();
    d->indices->empty();
}

float* voIndexedSet::operator[](int i)
{
    float* record = nullptr;
    guarded("voIndexedSet", [&] {
        if (i < 0 || i >= d->indices->getCount()) badValue(outside("index entry", i, d->indices->getCount()));
        const int vertex = d->indices->getDataPtr()[i];
        if (vertex < 0 || vertex >= d->vertices->getCount())
            badValue(outside("vertex", vertex, d->vertices->getCount()));
        record = d->vertices->getDataPtr() + static_cast<std::size_t>(vertex) *
                                                 static_cast<std::size_t>(d->vertices->getValuesPerVertex());
    });
    return record;
}

voIndexedSetIterator::voIndexedSetIterator(voIndexedSet* indexedSet) : set(indexedSet), next(0), vertex(0) {}

voIndexedSetIterator::~voIndexedSetIterator() = default;

voBool voIndexedSetIterator::done() const
{
    return doneP();
}

voIndexedFaceSet::voIndexedFaceSet(int countMaxV, int valuesPerVertex, int countMaxI)
{
    d->ownVertices = std::make_unique<voVertexData>(countMaxV, valuesPerVertex);
    d->ownIndices = std::make_unique<voIndices>(countMaxI);
    d->vertices = d->ownVertices.get();
    d->indices = d->ownIndices.get();
}

voIndexedFaceSet::voIndexedFaceSet(voVertexData* vertexData, int countMaxI)
{
    d->ownIndices = std::make_unique<voIndices>(countMaxI);
    d->indices = d->ownIndices.get();
    d->vertices = vertexData;
    if (vertexData) return;
    vo::report("voIndexedFaceSet", voErrorTypeScope::BAD_VALUE, "vertexData is NULL");
    d->ownVertices = std::make_unique<voVertexData>(0, 3);
    d->vertices = d->ownVertices.get();
}

voIndexedFaceSet::~voIndexedFaceSet() = default;

void voIndexedFaceSet::empty()
{
    voIndexedSet::empty();
}

void voIndexedFaceSet::appendPoly(float* vdata, int count)
{
    guarded("voIndexedFaceSet::appendPoly", [&] {
        if (count < 3) badValue("a polygon of " + std::to_string(count) + " vertices, 3 or more are needed");
        voInside::VertexData& vertices = voInside::of(*d->vertices);
        voInside::Indices& indices = voInside::of(*d->indices);
        const auto values = static_cast<std::size_t>(vertices.values);
        if (count > INT_MAX - vertices.count) throw std::bad_alloc();
        // Own records may move when the storage grows.
        const bool inOwn = vdata && !vertices.own.empty() && !std::less<>{}(vdata, vertices.own.data()) &&
                           std::less<>{}(vdata, vertices.own.data() + vertices.own.size());
        const std::ptrdiff_t ownOffset = inOwn ? vdata - vertices.own.data() : 0;
        if (vertices.count + count > vertices.countMax) {
            if (!d->ownVertices || !ownsStorage(vertices))
                throw vo::CallerError{voErrorTypeScope::OUT_OF_MEMORY,
                                      "no room for " + std::to_string(count) + " vertices, " +
                                          std::to_string(vertices.count) + " of " +
                                          std::to_string(vertices.countMax) + " are in use"};
            grow(vertices, vertices.own, vertices.count + count, vertices.values);
            if (inOwn) vdata = vertices.own.data() + ownOffset;
        }
        if (indices.count > INT_MAX - count - 1) throw std::bad_alloc();
        grow(indices, indices.own, indices.count + count + 1, 1);
        float* firstFree = vertices.data + static_cast<std::size_t>(vertices.count) * values;
        if (vdata && vdata != firstFree)
            std::memmove(firstFree, vdata, static_cast<std::size_t>(count) * values * sizeof(float));
        int* entry = indices.data + indices.count;
        *entry++ = count;
        for (int i = 0; i < count; ++i)
            *entry++ = vertices.count + i;
        vertices.count += count;
        indices.count += count + 1;
    });
}

voIndexedFaceSetIterator::voIndexedFaceSetIterator(voIndexedFaceSet* faceSet) : voIndexedSetIterator(faceSet)
{
}

// Indices that are no group of a count and that many vertices end the traversal.
voBool voIndexedFaceSetIterator::doneP() const
{
    if (!set || next >= set->getIndices()->getCount()) return VO_TRUE;
    const int count = set->getIndices()->getDataPtr()[next];
    return count < 0 || count >= set->getIndices()->getCount() - next;
}

float* voIndexedFaceSetIterator::nextVertex()
{
    if (doneP() || vertex >= set->getIndices()->getDataPtr()[next]) return nullptr;
    return (*set)[next + 1 + vertex++];
}

void voIndexedFaceSetIterator::nextPrimitive()
{
    if (!doneP()) next += set->getIndices()->getDataPtr()[next] + 1;
    vertex = 0;
}

voIndexedTetraSet::voIndexedTetraSet(float* data, int countV, int valuesPerVertex, int* indices, int countI)
{
    d->ownVertices = std::make_unique<voVertexData>(countV, valuesPerVertex, data);
    d->ownIndices = std::make_unique<voIndices>(countI, indices);
    d->vertices = d->ownVertices.get();
    d->indices = d->ownIndices.get();
    if (countI % VO_TETRA_VERTICES == 0) return;
    vo::report("voIndexedTetraSet", voErrorTypeScope::BAD_VALUE,
               std::to_string(countI) + " indices, a multiple of 4 is needed");
    d->indices->setCount(countI > 0 ? countI - countI % VO_TETRA_VERTICES : 0);
}

voIndexedTetraSet::voIndexedTetraSet(const float* data, int countV, int valuesPerVertex, const int* indices,
                                     int countI)
    : voIndexedTetraSet(countV, valuesPerVertex, countI)
{
    guarded("voIndexedTetraSet", [&] {
        if (countI % VO_TETRA_VERTICES != 0)
            badValue(std::to_string(countI) + " indices, a multiple of 4 is needed");
        if (!data || !indices) badValue("data or indices are NULL");
        if (d->vertices->getCountMax() != countV || d->indices->getCountMax() != countI) return;
        std::copy_n(data, static_cast<std::size_t>(countV) * static_cast<std::size_t>(valuesPerVertex),
                    d->vertices->getDataPtr());
        std::copy_n(indices, countI, d->indices->getDataPtr());
        d->vertices->setCount(countV);
        d->indices->setCount(countI);
    });
}

voIndexedTetraSet::voIndexedTetraSet(int countMaxV, int valuesPerVertex, int countMaxI)
{
    d->ownVertices = std::make_unique<voVertexData>(countMaxV, valuesPerVertex);
    d->ownIndices = std::make_unique<voIndices>(countMaxI);
    d->vertices = d->ownVertices.get();
    d->indices = d->ownIndices.get();
}

voIndexedTetraSet::voIndexedTetraSet(voVertexData* data, voIndices* indices)
{
    d->vertices = data;
    d->indices = indices;
    if (data && indices) return;
    vo::report("voIndexedTetraSet", voErrorTypeScope::BAD_VALUE, "data or indices are NULL");
    d->ownVertices = std::make_unique<voVertexData>(0, 3);
    d->ownIndices = std::make_unique<voIndices>(0);
    d->vertices = d->ownVertices.get();
    d->indices = d->ownIndices.get();
}

voIndexedTetraSet::~voIndexedTetraSet() = default;

voIndexedTetraSetIterator::voIndexedTetraSetIterator(voIndexedTetraSet* tetraSet)
    : voIndexedSetIterator(tetraSet)
{
}

voBool voIndexedTetraSetIterator::doneP() const
{
    return !set || next + VO_TETRA_VERTICES > set->getIndices()->getCount();
}

float* voIndexedTetraSetIterator::nextVertex()
{
    if (doneP() || vertex >= VO_TETRA_VERTICES) return nullptr;
    return (*set)[next + vertex++];
}

void voIndexedTetraSetIterator::nextPrimitive()
{
    if (!doneP()) next += VO_TETRA_VERTICES;
    vertex = 0;
}

int boundFaceCount(int tetraCount)
{
    constexpr int kPerTetra = 11;
    int bound = 0;
    guarded("boundFaceCount", [&] {
        if (tetraCount < 0 || tetraCount > INT_MAX / kPerTetra)
            badValue("tetraCount is " + std::to_string(tetraCount));
        bound = kPerTetra * tetraCount;
    });
    return bound;
}

voBool hasTextureComponent(voInterleavedArrayType format)
{
    voBool answer = VO_FALSE;
    guarded("hasTextureComponent", [&] { answer = vo::recordLayout(format, 3).texCoord >= 0; });
    return answer;
}

int getValuesPerVertex(voInterleavedArrayType format)
{
    int values = 0;
    guarded("getValuesPerVertex", [&] {
        if (format == voInterleavedArrayTypeScope::USER_V3F)
            badValue("USER_V3F records have as many values as the application says");
        values = vo::recordLayout(format, 0).values;
    });
    return values;
}

namespace vo {

TetraView tetraView(voIndexedTetraSet& set)
{
    const voVertexData& vertices = *set.getVertexData();
    const voIndices& indices = *set.getIndices();
    const int values = vertices.getValuesPerVertex();
    if (values < 3) badValue("records of " + std::to_string(values) + " values have no position");
    if (indices.getCount() % VO_TETRA_VERTICES != 0)
        badValue(std::to_string(indices.getCount()) + " indices, a multiple of 4 is needed");
    TetraView view;
    view.valuesPerVertex = values;
    view.records = {vertices.getDataPtr(),
                    static_cast<std::size_t>(vertices.getCount()) * static_cast<std::size_t>(values)};
    view.indices = {indices.getDataPtr(), static_cast<std::size_t>(indices.getCount())};
    for (const int index : view.indices)
        if (index < 0 || index >= vertices.getCount())
            badValue(outside("vertex", index, vertices.getCount()));
    return view;
}

} // namespace vo
