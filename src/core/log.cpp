#include "core/log.h"

#include <atomic>
#include <cstdlib>
#include <mutex>

namespace vo {

namespace {

int levelFromEnvironment()
{
    const char* text = std::getenv("VO_DEBUG");
    return text ? std::atoi(text) : 0;
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
