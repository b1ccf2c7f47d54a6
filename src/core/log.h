#pragma once

#include <cstdio>
#include <ostream>
#include <string_view>

namespace vo {

/// Sets what is printed: messages whose level is at most `level`; 0 prints nothing. The initial value comes
/// from the environment variable VO_DEBUG (a whole number), else 0.
void setDebugLevel(int level);
int debugLevel();

/// Where debug messages go; the initial destination is stderr. The stream stays the caller's and must
/// outlive its use; nullptr means stderr.
void setDebugStream(std::FILE* stream);
void setDebugStream(std::ostream* stream);

/// Prints `message` and a newline when `level` is at most debugLevel(). Thread safe.
void debug(int level, std::string_view message);

} // namespace vo
