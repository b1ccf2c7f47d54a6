#include "copy_slices.h"

#include <algorithm>

#include "utility.h"

namespace vo {

Result<void> copySlices(const char* program, const std::string& path, VolumeFile& volume,
                        TiffStackWriter& writer, std::int64_t done, std::int64_t all)
{
    constexpr std::int64_t kBytesAtOnce = 4 << 20;
    const auto& size = volume.info().size;
    const std::int64_t rowBytes = size[0] * volume.info().bytesPerVoxel();
    const std::int64_t rowsAtOnce = std::clamp<std::int64_t>(kBytesAtOnce / rowBytes, 1, size[1]);
    std::vector<std::byte> rows;
    for (std::int64_t z = 0; z < size[2]; ++z) {
        for (std::int64_t y = 0; y < size[1]; y += rowsAtOnce) {
            if (interrupted()) return Failure{path + ": interrupted, nothing written"};
            const std::int64_t count = std::min(rowsAtOnce, size[1] - y);
            rows.resize(static_cast<std::size_t>(count * rowBytes));
            if (auto read = volume.readBrick({{0, y, z}, {size[0], count, 1}}, rows); !read) return read;
            if (auto written = writer.appendRows(rows); !written) return written;
        }
        showProgress(program, "slice", done + z + 1, all);
    }
    return {};
}

} // namespace vo
