#pragma once

#include "volume_io/volume_io.h"

#include <functional>
#include <span>

namespace vo {

/// Who reads a volume row by row, for messages and the progress on a terminal.
struct RowReader
{
    const char* program;
    /// What a step is called.
    const char* what;
    /// The file that a failure names.
    std::string path;
    /// What a failure says when a signal came.
    const char* whenInterrupted;
    /// Slices that came before this volume's, and in all; 0 in all: this volume's.
    std::int64_t done = 0;
    std::int64_t all = 0;
};

/// Calls take(voxels) for all voxels in the order of a file, some rows of a slice at a time; ends with its
/// failure.
Result<void> readRows(const RowReader& reader, VolumeFile& volume,
                      const std::function<Result<void>(std::span<const std::byte>)>& take);

} // namespace vo
