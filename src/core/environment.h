#pragma once

#include <string_view>

namespace vo {

/// What an environment variable says; empty where it is not set.
std::string_view environmentText(const char* name);

/// Says in one line on standard error that what an environment variable says is not `expected` and has no
/// effect; of each variable once a process. Thread safe.
void tellUnusable(const char* name, std::string_view expected);

} // namespace vo
