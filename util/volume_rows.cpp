#include "volume_rows.h"

#include <algorithm>

#include "utility.h"
#include "volume_io/memory_block.h"

namespace vo {

Result<void> readRows(const RowReader& reader, VolumeFile& volume,
                      const std::function<Result<void>(std::span<const std::byte>)>& take)
{
    constexpr std::int64_t kBytesAtOnce = 4 << 20;
    const auto& size = volume.info().size;
    const std::int64_t rowBytes = size[0] * volume.info().bytesPerVoxel();
    const std::int64_t rowsAtOnce = std::clamp<std::int64_t>(kBytesAtOnce / rowBytes, 1, size[1]);
    const auto block = MemoryBlock::allocate(reader.path, rowsAtOnce * rowBytes);
    if (!block) return block.failure();
    for (std::int64_t z = 0; z < size[2]; ++z) {
        for (std::int64_t y = 0; y < size[1]; y += rowsAtOnce) {
            if (interrupted()) return Failure{reader.path + ": " + reader.whenInterrupted};
            const std::int64_t count = std::min(rowsAtOnce, size[1] - y);
            const auto rows = block->bytes().first(static_cast<std::size_t>(count * rowBytes));
            if (auto read = volume.readBrick({{0, y, z}, {size[0], count, 1}}, rows); !read) return read;
            if (auto taken = take(rows); !taken) return taken;
        }
        showProgress(reader.program, reader.what, reader.done + z + 1, reader.all ? reader.all : size[2]);
    }
    return {};
}

} // namespace vo
