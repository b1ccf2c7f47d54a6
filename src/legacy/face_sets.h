#pragma once

// The face sets of a caller, and polygons of his, as the inner stages take them.

#include "legacy/inside.h"

#include "geometry/face_sink.h"
#include "polygonize/slice_tetra.h"

namespace vo {

/// Hands polygons to the face sets of the caller, sets[brick][sample].
class FaceSetSink final : public FaceSink
{
public:
    FaceSetSink(voIndexedFaceSet*** sets, int values) : sets_(sets), values_(values) {}

    bool append(int brick, int sample, std::span<const float> records) override;

private:
    voIndexedFaceSet*** sets_;
    int values_;
};

/// Empties all face sets and the vertex data that they share. Throws CallerError when one is NULL or has
/// other than `values` values a record.
void resetFaceSets(voIndexedFaceSet*** sets, int bricks, int samples, int values);

/// A caller's polygon as the clipping stage takes it. Boxes speak of its positions unless a column is given.
/// Throws CallerError when its records have no position.
CutPolygon cutPolygon(const voVertexData& polygon, int voxelColumn = -1);

/// Appends what was cut, if anything. Throws CallerError when the face set has other records.
void appendCut(const CutPolygon& cut, voIndexedFaceSet& faceSet);

/// Where in a record its voxel coordinates begin; -1 when it has none beside its position. A format that is
/// not that of the records is passed over: programs of 1998 give any.
int voxelColumn(int format, int values);

} // namespace vo
