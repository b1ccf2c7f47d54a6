#pragma once

#include <vo/utPerfMeter.h>

namespace vo {

/// The meter that is enabled in this thread; nullptr without.
voutPerfMeter* currentMeter();

} // namespace vo
