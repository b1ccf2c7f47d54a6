#pragma once

#include <memory>
#include <vector>

#include "memory_block.h"
#include "patient_axes.h"
#include "volume_io.h"

namespace vo {

/// Numeric type of a number in a file.
enum class StoredType { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

int bytesPerNumber(StoredType type);
/// For messages: "float64".
const char* storedTypeName(StoredType type);
/// The type that such numbers arrive as: their own, or float32.
ChannelType channelTypeFor(StoredType type);

/// The number that lies at `from` in this machine's byte order.
double numberAt(StoredType type, const std::byte* from);

/// How the voxels of a file lie one after the other, without gaps: x fastest, then y, then z.
struct StoredLayout
{
    std::array<std::int64_t, 3> size{};
    int channels = 1;    // 1 to 4
    bool planar = false; // a whole volume for each channel instead of channels side by side
    StoredType type = StoredType::uint8;
    ByteOrder byteOrder = nativeByteOrder();

    std::int64_t pixelBytes() const { return (planar ? 1 : channels) * bytesPerNumber(type); }
};

/// Bytes of all voxels; a failure, beginning with `path`, for impossible sizes.
Result<std::int64_t> storedBytes(const std::string& path, const StoredLayout& layout);

/// Where the bytes of the voxels come from.
class StoredBytes
{
public:
    virtual ~StoredBytes() = default;
    /// Fills `out` from byte `offset` of the voxels on.
    virtual Result<void> read(std::int64_t offset, std::span<std::byte> out) = 0;
    /// The same bytes for another thread.
    virtual std::unique_ptr<StoredBytes> another() const = 0;
};

std::unique_ptr<StoredBytes> bytesInMemory(MemoryBlock block);

/// A part of the voxels' bytes that lies in one file.
struct FilePiece
{
    std::string path;
    std::int64_t offset = 0;
};

/// Voxels in one or more files, `bytesPerPiece` in each. A failure where a file is missing or too short.
Result<std::unique_ptr<StoredBytes>> bytesInFiles(std::vector<FilePiece> pieces, std::int64_t bytesPerPiece);

/// The volume of these voxels, turned to the patient's axes. Of `description`, spacing and orientation come
/// from `placement`; a note says when numbers are converted.
Result<VolumeFile> openStoredVoxels(const StoredLayout& layout, const Placement& placement,
                                    std::unique_ptr<StoredBytes> bytes, VolumeDescription description);

} // namespace vo
