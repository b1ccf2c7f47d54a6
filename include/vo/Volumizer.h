#ifndef VO_VOLUMIZER_H
#define VO_VOLUMIZER_H

#include <vo/Api.h>
#include <vo/Enums.h>
#include <vo/Error.h>

#include <vo/Geometry.h>
#include <vo/GeometryActions.h>

#include <vo/Appearance.h>
#include <vo/AppearanceActions.h>

#include <vo/LookupTable.h>

#include <vo/FloatTarget.h>
#include <vo/State.h>
#include <vo/utGeometry.h>
#include <vo/utLattice.h>
#include <vo/utPerfMeter.h>
#include <vo/utSolids.h>

#endif
