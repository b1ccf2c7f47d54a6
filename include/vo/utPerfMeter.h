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
    /** Adds time that was measured otherwise. */
    void add(double seconds);
    /** Seconds so far, a running stretch included. */
    double getSeconds() const;

private:
    double total;
    double started;
};

/** Prints the seconds. */
VO_API std::ostream &operator<<(std::ostream &stream, const voutTimer &timer);

/** The phases of volume rendering, a timer for each (guide, page 98). While a meter is enabled, drawUtility of the same
    thread adds its times to it and counts a frame; it then waits for OpenGL at the end of LOAD and DRAW, so that these
    hold the work itself, not only its being asked for. A program that draws by loops of its own starts and stops the
    timers itself. */
class VO_API voutPerfMeter
{
public:
    /** Slicing tetrahedra; ordering bricks; sending textures; drawing polygons. */
    enum Phase { POLYGONIZE, SORT, LOAD, DRAW, PHASE_COUNT };

    voutPerfMeter();
    /** Disables itself; in the thread that enabled it. */
    ~voutPerfMeter();

    /** At most one meter is enabled in a thread; another one is replaced. disable() of one that is not does nothing. */
    void enable();
    void disable();

    /** The timer of a phase, which lives as long as the meter. Outside the phases: BAD_VALUE and POLYGONIZE's. */
    voutTimer &getTimer(Phase phase);
    const voutTimer &getTimer(Phase phase) const;
    /** "polygonize", "sort", "load" or "draw"; outside the phases: BAD_VALUE and an empty text. */
    static const char *getName(Phase phase);

    void countFrame();
    int getFrameCount() const;
    /** All timers and the count to 0. */
    void reset();

private:
    struct Private;
    Private *d;
    voutPerfMeter(const voutPerfMeter &);
    voutPerfMeter &operator=(const voutPerfMeter &);
};

/** Prints one line without its end: each phase and its seconds, then the number of frames. */
VO_API std::ostream &operator<<(std::ostream &stream, const voutPerfMeter &meter);

#endif
