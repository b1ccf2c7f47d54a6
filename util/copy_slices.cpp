#include "copy_slices.h"

#include "volume_rows.h"

namespace vo {

Result<void> copySlices(const char* program, const std::string& path, VolumeFile& volume,
                        TiffStackWriter& writer, std::int64_t done, std::int64_t all)
{
    return readRows({program, "slice", path, "interrupted, nothing written", done, all}, volume,
                    [&writer](std::span<const std::byte> rows) { return writer.appendRows(rows); });
}

} // namespace vo
