#include "core/environment.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <set>
#include <string>

namespace vo {

std::string_view environmentText(const char* name)
{
    const char* text = std::getenv(name);
    return text ? text : "";
}

void tellUnusable(const char* name, std::string_view expected)
{
    static std::mutex mutex;
    static std::set<std::string> told;
    {
        const std::lock_guard lock(mutex);
        if (!told.emplace(name).second) return;
    }
    std::string found(environmentText(name));
    std::ranges::replace_if(
        found, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '.');
    std::fprintf(stderr, "%s: expected %.*s, found \"%s\", which has no effect\n", name,
                 static_cast<int>(expected.size()), expected.data(), found.c_str());
}

} // namespace vo
