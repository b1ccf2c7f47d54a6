#include "legacy/inside.h"
#include "legacy/report.h"

using vo::guarded;

int voGeometryActions::polygonizeMPR(float*, voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)
{
    return guarded("voGeometryActions::polygonizeMPR",
                   [] { vo::unsupported("reformatting is not there yet"); });
}

int voGeometryActions::polygonizeMPR(voVertexData*, voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)
{
    return guarded("voGeometryActions::polygonizeMPR",
                   [] { vo::unsupported("reformatting is not there yet"); });
}
