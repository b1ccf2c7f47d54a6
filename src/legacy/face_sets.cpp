#include "legacy/face_sets.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include <algorithm>

namespace vo {

bool FaceSetSink::append(int brick, int sample, std::span<const float> records)
{
    voIndexedFaceSet& faces = *sets_[brick][sample];
    const int count = static_cast<int>(records.size()) / values_;
    const voVertexData& vertices = *faces.getVertexData();
    const bool shared = !voInside::of(faces).ownVertices;
    if (shared && vertices.getCount() + count > vertices.getCountMax()) return false;
    // appendPoly copies; it does not write to what it is given.
    faces.appendPoly(const_cast<float*>(records.data()), count);
    return true;
}

void resetFaceSets(voIndexedFaceSet*** sets, int bricks, int samples, int values)
{
    if (!sets) badValue("polygonSet is NULL");
    for (int b = 0; b < bricks; ++b) {
        if (!sets[b]) badValue("polygonSet[" + std::to_string(b) + "] is NULL");
        for (int s = 0; s < samples; ++s) {
            if (!sets[b][s])
                badValue("polygonSet[" + std::to_string(b) + "][" + std::to_string(s) + "] is NULL");
            voIndexedFaceSet& faces = *sets[b][s];
            if (faces.getVertexData()->getValuesPerVertex() != values)
                badValue("face sets of " + std::to_string(faces.getVertexData()->getValuesPerVertex()) +
                         " values a record, the tetrahedra have " + std::to_string(values));
            faces.empty();
            faces.getVertexData()->empty();
        }
    }
}

CutPolygon cutPolygon(const voVertexData& polygon, int voxelColumn)
{
    const int values = polygon.getValuesPerVertex();
    if (values < 3) badValue("records of " + std::to_string(values) + " values have no position");
    CutPolygon cut;
    cut.clear(values, voxelColumn);
    std::vector<double> record(static_cast<std::size_t>(values));
    for (int i = 0; i < polygon.getCount(); ++i) {
        std::copy_n(polygon[i], values, record.begin());
        cut.push(record.data());
    }
    return cut;
}

int voxelColumn(int format, int values)
{
    const RecordLayout layout = recordLayout(format, values);
    return layout.texCoord >= 0 && layout.values <= values ? values - layout.values + layout.texCoord : -1;
}

void appendCut(const CutPolygon& cut, voIndexedFaceSet& faceSet)
{
    if (faceSet.getVertexData()->getValuesPerVertex() != cut.values)
        badValue("the face set has " + std::to_string(faceSet.getVertexData()->getValuesPerVertex()) +
                 " values a record, the polygon " + std::to_string(cut.values));
    if (cut.count < 3) return;
    std::vector<float> records;
    for (int i = 0; i < cut.count; ++i)
        for (int v = 0; v < cut.values; ++v)
            records.push_back(static_cast<float>(cut.record(i)[v]));
    faceSet.appendPoly(records.data(), cut.count);
}

} // namespace vo
