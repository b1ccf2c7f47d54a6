#ifndef VO_UT_PERF_METER_H
#define VO_UT_PERF_METER_H

#include <vo/Error.h>

/** A stopwatch of wall-clock time that adds up (guide, page 98). */
class VO_API voutTimer
{
public:
    voutTimer();
    /** start() while running, and stop() while stopped, do nothing. */
    void start();
    void stop();
    void reset();
    /** Seconds so far, a running stretch included. */
    double getSeconds() const;

private:
    double total;
    double started;
};

/** Prints the seconds. */
VO_API std::ostream &operator<<(std::ostream &stream, const voutTimer &timer);

#endif
