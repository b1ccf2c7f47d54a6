// U: timers (page 98).

#include <vo/utPerfMeter.h>

#include <sstream>

#include "rows.h"

namespace DIALECT {

void utilities()
{
    ROW(U1);
    voutTimer timer;
    timer.start();
    timer.stop();
    std::ostringstream out;
    out << timer;
    is<std::ostream& (*)(std::ostream&, const voutTimer&)>(&operator<<);
    ROW(U2);
    voutPerfMeter meter;
    meter.enable();
    meter.getTimer(voutPerfMeter::DRAW).start();
    meter.getTimer(voutPerfMeter::DRAW).stop();
    meter.countFrame();
    meter.disable();
    out << meter;
    is<std::ostream& (*)(std::ostream&, const voutPerfMeter&)>(&operator<<);
}

} // namespace DIALECT
