#include "core/log.h"

#include "core/environment.h"

#include <atomic>
#include <charconv>
#include <mutex>

namespace vo {

namespace {

int levelFromEnvironment()
{
    const std::string_view text = environmentText("VO_DEBUG");
    if (text.empty()) return 0;
    int level = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, level);
    if (error == std::errc() && stop == end) return level;
    tellUnusable("VO_DEBUG", "a whole number");
    return 0;
}

struct Destination
{
    std::mutex mutex;
    std::FILE* file = nullptr;
    std::ostream* stream = nullptr;
};

Destination& destination()
{
    static Destination instance;
    return instance;
}

std::atomic<int>& level()
{
    static std::atomic<int> instance(levelFromEnvironment());
    return instance;
}

} // namespace

void setDebugLevel(int newLevel)
{
    level() = newLevel;
}

int debugLevel()
{
    return level();
}

void setDebugStream(std::FILE* stream)
{
    const std::lock_guard lock(destination().mutex);
    destination().file = stream;
    destination().stream = nullptr;
}

void setDebugStream(std::ostream* stream)
{
    const std::lock_guard lock(destination().mutex);
    destination().file = nullptr;
    destination().stream = stream;
}

void debug(int messageLevel, std::string_view message)
{
    if (messageLevel > debugLevel()) return;
    const std::lock_guard lock(destination().mutex);
    if (destination().stream) {
        *destination().stream << message << std::endl;
        return;
    }
    std::FILE* file = destination().file ? destination().file : stderr;
    std::fprintf(file, "%.*s\n", static_cast<int>(message.size()), message.data());
}

} // namespace vo
