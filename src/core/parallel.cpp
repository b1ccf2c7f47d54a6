#include "core/parallel.h"

#include "core/environment.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <string_view>

namespace vo {

int usualThreads()
{
    const int machine = tbb::this_task_arena::max_concurrency();
    const std::string_view wanted = environmentText("VO_THREADS");
    if (wanted.empty()) return machine;
    int threads = 0;
    const char* end = wanted.data() + wanted.size();
    const auto [stop, error] = std::from_chars(wanted.data(), end, threads);
    if (error == std::errc() && stop == end && threads >= 1) return std::min(threads, machine);
    tellUnusable("VO_THREADS", "a whole number from 1 on");
    return machine;
}

void parallelFor(std::size_t count, int threads, const std::function<void(std::size_t)>& body)
{
    threads = threads == 0 ? usualThreads() : std::min(threads, tbb::this_task_arena::max_concurrency());
    if (threads == 1 || count < 2) {
        for (std::size_t i = 0; i < count; ++i)
            body(i);
        return;
    }
    tbb::task_arena arena(threads);
    arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, body, tbb::simple_partitioner()); });
}

void parallelInOrder(std::size_t count, int threads, const std::function<void(std::size_t)>& body)
{
    std::atomic<std::size_t> next{0};
    const auto workers = static_cast<std::size_t>(threads == 0 ? usualThreads() : threads);
    parallelFor(std::min(workers, count), threads, [&](std::size_t) {
        for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;)
            body(i);
    });
}

} // namespace vo
