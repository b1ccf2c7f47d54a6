#pragma once

#include "volume_io/volume_io.h"

namespace vo {

/// Appends all slices of a volume, called `path` in messages, some rows at a time. `done` slices of `all`
/// were written before; progress is shown for the program of this name. Gives up when interrupted.
Result<void> copySlices(const char* program, const std::string& path, VolumeFile& volume,
                        TiffStackWriter& writer, std::int64_t done, std::int64_t all);

} // namespace vo
