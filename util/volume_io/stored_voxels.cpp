#include "stored_voxels.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <optional>

#include "byte_order.h"
#include "full_alpha.h"
#include "input_file.h"
#include "volume_reader.h"

namespace vo {
namespace {

class MemoryBytes final : public StoredBytes
{
public:
    explicit MemoryBytes(std::shared_ptr<const MemoryBlock> block) : block_(std::move(block)) {}

    Result<void> read(std::int64_t offset, std::span<std::byte> out) override
    {
        std::memcpy(out.data(), block_->bytes().data() + offset, out.size());
        return {};
    }
    std::unique_ptr<StoredBytes> another() const override { return std::make_unique<MemoryBytes>(block_); }

private:
    std::shared_ptr<const MemoryBlock> block_;
};

class FileBytes final : public StoredBytes
{
public:
    FileBytes(std::vector<FilePiece> pieces, std::int64_t bytesPerPiece)
        : pieces_(std::move(pieces)), bytesPerPiece_(bytesPerPiece)
    {
    }

    Result<void> read(std::int64_t offset, std::span<std::byte> out) override
    {
        while (!out.empty()) {
            const FilePiece& piece = pieces_[static_cast<std::size_t>(offset / bytesPerPiece_)];
            const std::int64_t start = offset % bytesPerPiece_;
            const auto count =
                std::min<std::int64_t>(bytesPerPiece_ - start, static_cast<std::int64_t>(out.size()));
            if (!file_ || file_->path() != piece.path) {
                auto file = InputFile::open(piece.path);
                if (!file) return file.failure();
                file_.emplace(std::move(*file));
            }
            if (auto read = file_->readAt(piece.offset + start, out.first(std::size_t(count))); !read)
                return read;
            out = out.subspan(std::size_t(count));
            offset += count;
        }
        return {};
    }
    std::unique_ptr<StoredBytes> another() const override
    {
        return std::make_unique<FileBytes>(pieces_, bytesPerPiece_);
    }

private:
    std::vector<FilePiece> pieces_;
    std::int64_t bytesPerPiece_;
    std::optional<InputFile> file_; // the one read last
};

template <class Number>
double numberAt(const std::byte* from)
{
    Number number;
    std::memcpy(&number, from, sizeof number);
    return static_cast<double>(number);
}

template <class Number>
void numbersToFloats(const std::byte* from, std::size_t count, float* to)
{
    for (std::size_t i = 0; i < count; ++i, from += sizeof(Number)) {
        Number number;
        std::memcpy(&number, from, sizeof number);
        to[i] = static_cast<float>(number);
    }
}

/// Doubles beyond the largest float become infinite.
void convertToFloats(StoredType type, const std::byte* from, std::size_t count, float* to)
{
    switch (type) {
    case StoredType::uint32: return numbersToFloats<std::uint32_t>(from, count, to);
    case StoredType::int32: return numbersToFloats<std::int32_t>(from, count, to);
    case StoredType::uint64: return numbersToFloats<std::uint64_t>(from, count, to);
    case StoredType::int64: return numbersToFloats<std::int64_t>(from, count, to);
    case StoredType::float64: return numbersToFloats<double>(from, count, to);
    case StoredType::uint8:
    case StoredType::int8:
    case StoredType::uint16:
    case StoredType::int16:
    case StoredType::float32: break; // arrive as they are
    }
}

bool isConverted(StoredType type)
{
    return channelTypeFor(type) == ChannelType::float32 && type != StoredType::float32;
}

/// Copies items of `Bytes` bytes that lie side by side to places `step` bytes apart.
template <std::size_t Bytes>
void scatter(const std::byte* from, std::int64_t count, std::byte* to, std::int64_t step)
{
    for (std::int64_t i = 0; i < count; ++i)
        std::memcpy(to + i * step, from + i * std::int64_t(Bytes), Bytes);
}

void scatter(const std::byte* from, std::int64_t itemBytes, std::int64_t count, std::byte* to,
             std::int64_t step)
{
    switch (itemBytes) {
    case 1: return scatter<1>(from, count, to, step);
    case 2: return scatter<2>(from, count, to, step);
    case 4: return scatter<4>(from, count, to, step);
    case 8: return scatter<8>(from, count, to, step);
    default:
        for (std::int64_t i = 0; i < count; ++i)
            std::memcpy(to + i * step, from + i * itemBytes, static_cast<std::size_t>(itemBytes));
    }
}

class StoredReader final : public VolumeReader
{
public:
    StoredReader(const StoredLayout& layout, const Placement& placement, std::unique_ptr<StoredBytes> bytes,
                 VolumeDescription description);
    Result<void> read(const Region& inside, const BrickView& brick) override;
    std::unique_ptr<VolumeReader> another() const override
    {
        return std::make_unique<StoredReader>(layout_, placement_, bytes_->another(), description_);
    }

private:
    Result<void> readVoxels(std::array<std::int64_t, 3> first, std::int64_t count, std::byte* voxels,
                            std::int64_t step);
    Result<void> readNumbers(std::int64_t offset, std::span<std::byte> out);

    StoredLayout layout_;
    Placement placement_;
    std::unique_ptr<StoredBytes> bytes_;
    std::array<std::byte, 4> alpha_;
    std::vector<std::byte> row_;
    std::vector<float> floats_;
};

StoredReader::StoredReader(const StoredLayout& layout, const Placement& placement,
                           std::unique_ptr<StoredBytes> bytes, VolumeDescription description)
    : layout_(layout), placement_(placement), bytes_(std::move(bytes))
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        info_.size[axis] = layout.size[static_cast<std::size_t>(placement.fileAxis[axis])];
    info_.channels = layout.channels == 3 ? 4 : layout.channels;
    info_.type = channelTypeFor(layout.type);
    alpha_ = fullAlpha(info_.type);
    description_ = std::move(description);
    description_.alphaAdded = layout.channels == 3;
    description_.spacing = placement.spacing;
    description_.spacingKnown = placement.spacingKnown;
    description_.orientation = placement.orientation;
    if (isConverted(layout.type))
        description_.notes.push_back(std::string("numbers of type ") + storedTypeName(layout.type) +
                                     " are converted to float32");
}

Result<void> StoredReader::read(const Region& inside, const BrickView& brick)
{
    // The box in voxels of the file, and how far apart its voxels lie in the brick.
    std::array<std::int64_t, 3> first{}, last{}, step{};
    std::byte* const corner = brick.voxel(inside.origin[0], inside.origin[1], inside.origin[2]);
    std::byte* start = corner;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<std::size_t>(placement_.fileAxis[axis]);
        const std::int64_t low = inside.origin[axis], high = low + inside.size[axis] - 1;
        std::array<std::int64_t, 3> next = inside.origin;
        ++next[axis];
        step[from] = brick.voxel(next[0], next[1], next[2]) - corner;
        first[from] = placement_.reversed[axis] ? info_.size[axis] - 1 - high : low;
        last[from] = placement_.reversed[axis] ? info_.size[axis] - 1 - low : high;
        if (placement_.reversed[axis]) {
            start += (inside.size[axis] - 1) * step[from];
            step[from] = -step[from];
        }
    }
    const std::int64_t count = last[0] - first[0] + 1;
    // Rows that follow each other in the file and in the brick are read at once.
    const bool rowsTouch = count == layout_.size[0] && step[1] == count * step[0];
    const std::int64_t rowsAtOnce = rowsTouch ? last[1] - first[1] + 1 : 1;
    for (std::int64_t z = first[2]; z <= last[2]; ++z) {
        for (std::int64_t y = first[1]; y <= last[1]; y += rowsAtOnce) {
            std::byte* const voxels = start + (z - first[2]) * step[2] + (y - first[1]) * step[1];
            if (auto read = readVoxels({first[0], y, z}, rowsAtOnce * count, voxels, step[0]); !read)
                return read;
            counters_.rows += rowsAtOnce;
        }
        ++counters_.slices;
    }
    return {};
}

/// `count` voxels that follow each other in the file, the first one at `first`, to places `step` bytes apart.
Result<void> StoredReader::readVoxels(std::array<std::int64_t, 3> first, std::int64_t count,
                                      std::byte* voxels, std::int64_t step)
{
    const std::int64_t pixel = (first[2] * layout_.size[1] + first[1]) * layout_.size[0] + first[0];
    const std::int64_t planeBytes =
        layout_.size[0] * layout_.size[1] * layout_.size[2] * layout_.pixelBytes();
    const int channelBytes = bytesPerChannel(info_.type);
    const int perPlane = layout_.planar ? 1 : layout_.channels;
    const std::int64_t itemBytes = std::int64_t(perPlane) * channelBytes;
    const auto bytes = static_cast<std::size_t>(count * layout_.pixelBytes());
    const bool isPlain = !isConverted(layout_.type) && itemBytes == step;

    for (int plane = 0; plane < (layout_.planar ? layout_.channels : 1); ++plane) {
        const std::int64_t offset = plane * planeBytes + pixel * layout_.pixelBytes();
        std::byte* to = voxels + plane * channelBytes;
        if (isPlain) {
            if (auto read = readNumbers(offset, {to, bytes}); !read) return read;
        } else {
            row_.resize(bytes);
            if (auto read = readNumbers(offset, row_); !read) return read;
            const std::byte* from = row_.data();
            if (isConverted(layout_.type)) {
                floats_.resize(static_cast<std::size_t>(count * perPlane));
                convertToFloats(layout_.type, row_.data(), floats_.size(), floats_.data());
                from = reinterpret_cast<const std::byte*>(floats_.data());
            }
            scatter(from, itemBytes, count, to, step);
        }
    }
    if (layout_.channels == 3)
        for (std::int64_t i = 0; i < count; ++i)
            std::memcpy(voxels + i * step + 3 * channelBytes, alpha_.data(), std::size_t(channelBytes));
    return {};
}

/// Numbers in this machine's byte order.
Result<void> StoredReader::readNumbers(std::int64_t offset, std::span<std::byte> out)
{
    if (auto read = bytes_->read(offset, out); !read) return read;
    if (layout_.byteOrder != nativeByteOrder()) swapBytes(out, bytesPerNumber(layout_.type));
    counters_.bytes += static_cast<std::int64_t>(out.size());
    return {};
}

} // namespace

int bytesPerNumber(StoredType type)
{
    switch (type) {
    case StoredType::uint8:
    case StoredType::int8: return 1;
    case StoredType::uint16:
    case StoredType::int16: return 2;
    case StoredType::uint32:
    case StoredType::int32:
    case StoredType::float32: return 4;
    case StoredType::uint64:
    case StoredType::int64:
    case StoredType::float64: return 8;
    }
    return 0;
}

const char* storedTypeName(StoredType type)
{
    switch (type) {
    case StoredType::uint8: return "uint8";
    case StoredType::int8: return "int8";
    case StoredType::uint16: return "uint16";
    case StoredType::int16: return "int16";
    case StoredType::uint32: return "uint32";
    case StoredType::int32: return "int32";
    case StoredType::uint64: return "uint64";
    case StoredType::int64: return "int64";
    case StoredType::float32: return "float32";
    case StoredType::float64: return "float64";
    }
    return "unknown";
}

ChannelType channelTypeFor(StoredType type)
{
    switch (type) {
    case StoredType::uint8: return ChannelType::uint8;
    case StoredType::int8: return ChannelType::int8;
    case StoredType::uint16: return ChannelType::uint16;
    case StoredType::int16: return ChannelType::int16;
    case StoredType::uint32:
    case StoredType::int32:
    case StoredType::uint64:
    case StoredType::int64:
    case StoredType::float32:
    case StoredType::float64: break;
    }
    return ChannelType::float32;
}

double numberAt(StoredType type, const std::byte* from)
{
    switch (type) {
    case StoredType::uint8: return numberAt<std::uint8_t>(from);
    case StoredType::int8: return numberAt<std::int8_t>(from);
    case StoredType::uint16: return numberAt<std::uint16_t>(from);
    case StoredType::int16: return numberAt<std::int16_t>(from);
    case StoredType::uint32: return numberAt<std::uint32_t>(from);
    case StoredType::int32: return numberAt<std::int32_t>(from);
    case StoredType::uint64: return numberAt<std::uint64_t>(from);
    case StoredType::int64: return numberAt<std::int64_t>(from);
    case StoredType::float32: return numberAt<float>(from);
    case StoredType::float64: return numberAt<double>(from);
    }
    return 0;
}

Result<std::int64_t> storedBytes(const std::string& path, const StoredLayout& layout)
{
    if (layout.channels < 1 || layout.channels > 4)
        return Failure{path + ": expected 1 to 4 channels, found " + std::to_string(layout.channels)};
    const int numberBytes = bytesPerNumber(layout.type);
    const auto bytes = volumeBytes(layout.size, layout.channels * numberBytes);
    if (!bytes) return Failure{path + ": " + bytes.failure().text};
    // With alpha added, or as floats, voxels may take more room than in the file.
    const int arriving =
        (layout.channels == 3 ? 4 : layout.channels) * bytesPerChannel(channelTypeFor(layout.type));
    if (const auto served = volumeBytes(layout.size, arriving); !served)
        return Failure{path + ": " + served.failure().text};
    return *bytes;
}

std::unique_ptr<StoredBytes> bytesInMemory(MemoryBlock block)
{
    return std::make_unique<MemoryBytes>(std::make_shared<const MemoryBlock>(std::move(block)));
}

Result<std::unique_ptr<StoredBytes>> bytesInFiles(std::vector<FilePiece> pieces, std::int64_t bytesPerPiece)
{
    for (const FilePiece& piece : pieces) {
        const auto file = InputFile::open(piece.path);
        if (!file) return file.failure();
        if (piece.offset > file->size() || file->size() - piece.offset < bytesPerPiece)
            return Failure{piece.path + ": cut off: expected " + std::to_string(bytesPerPiece) +
                           " bytes of voxels at byte " + std::to_string(piece.offset) + ", found a file of " +
                           std::to_string(file->size()) + " bytes"};
    }
    return std::unique_ptr<StoredBytes>(new FileBytes(std::move(pieces), bytesPerPiece));
}

Result<VolumeFile> openStoredVoxels(const StoredLayout& layout, const Placement& placement,
                                    std::unique_ptr<StoredBytes> bytes, VolumeDescription description)
{
    return VolumeFile(
        std::make_unique<StoredReader>(layout, placement, std::move(bytes), std::move(description)));
}

} // namespace vo
