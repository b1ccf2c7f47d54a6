#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/face_sets.h"
#include "legacy/report.h"

#include "polygonize/reformat.h"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

/// The layout of the records, which a stack's weights need to have colours.
vo::RecordLayout reformatLayout(int format, int values, const voBrickSet& set)
{
    const vo::RecordLayout layout = vo::recordLayout(format, values);
    if (vo::thinAxis(set.getOrientation()) >= 0 && layout.color < 0)
        badValue(
            "a stack of two-dimensional bricks needs a format with colours, which carry the weights of its "
            "slices");
    return layout;
}

/// polygonSet[brick][0], emptied.
vo::FaceSetSink faceSets(voIndexedFaceSet*** sets, const voBrickSet& set, int values)
{
    vo::resetFaceSets(sets, set.getBrickCount(), 1, values);
    return vo::FaceSetSink(sets, values);
}

void cutToBricks(const vo::CutPolygon& polygon, const voBrickSet& set, const std::vector<vo::Box>& boxes,
                 const vo::RecordLayout& layout, vo::FaceSink& sink)
{
    thread_local vo::BoxCutter cutter;
    if (!vo::reformat(polygon, {boxes, vo::thinAxis(set.getOrientation()), layout}, cutter, sink))
        throw vo::CallerError{voErrorTypeScope::OUT_OF_MEMORY,
                              "the vertex data that the face sets share is full; the rest is missing"};
}

} // namespace

int voGeometryActions::polygonizeMPR(float planeEquation[4], voBrickSet* brickSet,
                                     voIndexedFaceSet*** polygonSet, voInterleavedArrayType format)
{
    return guarded("voGeometryActions::polygonizeMPR", [&] {
        const voBrickSet& set = required(brickSet, "brickSet");
        if (!planeEquation) badValue("planeEquation is NULL");
        const glm::dvec4 plane(glm::make_vec4(planeEquation));
        const glm::dvec3 normal(plane);
        if (!std::isfinite(plane.x + plane.y + plane.z + plane.w) || normal == glm::dvec3(0.0))
            badValue("planeEquation has no direction, or is not finite");
        if (format == voInterleavedArrayTypeScope::USER_V3F)
            badValue("a plane has no values of the application's own; USER_V3F needs a polygon");
        const vo::RecordLayout layout = reformatLayout(format, 0, set);
        vo::FaceSetSink sink = faceSets(polygonSet, set, layout.values);
        std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        cutToBricks(vo::planeThroughBoxes(plane, boxes, layout), set, boxes, layout, sink);
    });
}

int voGeometryActions::polygonizeMPR(voVertexData* polygon, voBrickSet* brickSet,
                                     voIndexedFaceSet*** polygonSet, voInterleavedArrayType format)
{
    return guarded("voGeometryActions::polygonizeMPR", [&] {
        const voBrickSet& set = required(brickSet, "brickSet");
        const voVertexData& vertices = required(polygon, "polygon");
        const int values = vertices.getValuesPerVertex();
        const vo::RecordLayout layout = reformatLayout(format, values, set);
        if (layout.values != values || values < 3)
            badValue("the vertex format has " + std::to_string(layout.values) +
                     " values a record, the polygon " + std::to_string(values));
        const auto parts = vo::convexParts(vo::cutPolygon(vertices, layout.texCoord));
        if (!parts) badValue("the edges of the polygon cross");
        vo::FaceSetSink sink = faceSets(polygonSet, set, values);
        std::vector<vo::Box> boxes;
        vo::clipBoxes(set, boxes);
        for (const vo::CutPolygon& part : *parts)
            cutToBricks(part, set, boxes, layout, sink);
    });
}
