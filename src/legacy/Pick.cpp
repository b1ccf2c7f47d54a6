#include "legacy/inside.h"
#include "legacy/report.h"

using vo::guarded;

voBool voGeometryActions::pick(int*, int*, voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, GLdouble*,
                               GLdouble*, float*, voBool, voVertexData*, void*)
{
    guarded("voGeometryActions::pick", [] { vo::unsupported("picking is not there yet"); });
    return VO_FALSE;
}

voBool voGeometryActions::pick(int*, int*, voIndexedTetraSet*, voBrick*, voInterleavedArrayType, GLdouble*,
                               GLdouble*, float*, voBool, voVertexData*, void*)
{
    guarded("voGeometryActions::pick", [] { vo::unsupported("picking is not there yet"); });
    return VO_FALSE;
}
