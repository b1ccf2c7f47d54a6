#pragma once

#include <cstddef>
#include <functional>

namespace vo {

/// Threads that work is spread over when nobody says otherwise: those of the machine, or the environment's
/// VO_THREADS (1 and up) if that is fewer. What else VO_THREADS says is told (tellUnusable).
int usualThreads();

/// Calls body(0) to body(count - 1), each once, in up to `threads` threads of the machine's (0:
/// usualThreads()), in any order; returns when all are done. The first exception that a body throws comes out
/// here.
void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

/// The same, but whoever is done takes the next number: what is near in number is done at about the same
/// time, and what it reads is in the caches for all threads.
void parallelInOrder(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

} // namespace vo
