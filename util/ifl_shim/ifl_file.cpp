#include <ifl/iflFile.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <mutex>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "volume_io/volume_io.h"

/// What a file tells of itself, also when it is closed, and the open volume.
struct iflFile::Private
{
    std::string name;
    vo::VolumeInfo info;
    std::optional<vo::VolumeFile> volume;
};

namespace {

struct LastFailure
{
    iflStatus status = iflOKAY;
    std::string text;
};

LastFailure& lastFailure()
{
    thread_local LastFailure failure;
    return failure;
}

iflStatus failed(iflStatus status, const std::string& text)
{
    lastFailure() = {status, text};
    return status;
}

/// Programs of the time closed a file and left the object: those are kept within reach, so that a search for
/// lost memory does not count them.
struct ClosedFiles
{
    std::mutex lock;
    std::set<const iflFile*> files;
};

ClosedFiles& closedFiles()
{
    static ClosedFiles* const closed = new ClosedFiles; // outlives the files that static objects delete
    return *closed;
}

iflDataType typeOf(vo::ChannelType type)
{
    switch (type) {
    case vo::ChannelType::uint8: return iflUChar;
    case vo::ChannelType::int8: return iflChar;
    case vo::ChannelType::uint16: return iflUShort;
    case vo::ChannelType::int16: return iflShort;
    case vo::ChannelType::float32: return iflFloat;
    }
    return iflUChar;
}

/// Bytes of a channel; 0 for what is no type, or none of whole bytes.
int bytesOf(iflDataType type)
{
    switch (type) {
    case iflUChar:
    case iflChar: return 1;
    case iflUShort:
    case iflShort: return 2;
    case iflUInt:
    case iflInt:
    case iflFloat: return 4;
    case iflDouble: return 8;
    case iflBit: break;
    }
    return 0;
}

template <class To, class From>
To converted(From value)
{
    if constexpr (std::is_floating_point_v<To>) return static_cast<To>(value);
    const double number = static_cast<double>(value);
    if (std::isnan(number)) return 0;
    return static_cast<To>(std::clamp(std::round(number), static_cast<double>(std::numeric_limits<To>::min()),
                                      static_cast<double>(std::numeric_limits<To>::max())));
}

template <class To, class From>
void convert(std::span<const std::byte> from, std::byte* to)
{
    const std::size_t count = from.size() / sizeof(From);
    for (std::size_t i = 0; i < count; ++i) {
        From value;
        std::memcpy(&value, from.data() + i * sizeof(From), sizeof value);
        const To result = converted<To>(value);
        std::memcpy(to + i * sizeof(To), &result, sizeof result);
    }
}

template <class From>
void convert(std::span<const std::byte> from, iflDataType type, std::byte* to)
{
    switch (type) {
    case iflUChar: return convert<std::uint8_t, From>(from, to);
    case iflChar: return convert<std::int8_t, From>(from, to);
    case iflUShort: return convert<std::uint16_t, From>(from, to);
    case iflShort: return convert<std::int16_t, From>(from, to);
    case iflUInt: return convert<std::uint32_t, From>(from, to);
    case iflInt: return convert<std::int32_t, From>(from, to);
    case iflFloat: return convert<float, From>(from, to);
    case iflDouble: return convert<double, From>(from, to);
    case iflBit: return;
    }
}

void convert(std::span<const std::byte> from, vo::ChannelType fileType, iflDataType type, std::byte* to)
{
    switch (fileType) {
    case vo::ChannelType::uint8: return convert<std::uint8_t>(from, type, to);
    case vo::ChannelType::int8: return convert<std::int8_t>(from, type, to);
    case vo::ChannelType::uint16: return convert<std::uint16_t>(from, type, to);
    case vo::ChannelType::int16: return convert<std::int16_t>(from, type, to);
    case vo::ChannelType::float32: return convert<float>(from, type, to);
    }
}

/// Takes channels that lie side by side apart: within each run of `pixels` pixels, one channel after the
/// other.
void separate(std::span<const std::byte> from, int channels, std::size_t bytes, std::size_t pixels,
              std::byte* to)
{
    const std::size_t all = from.size() / (bytes * channels);
    for (std::size_t run = 0; run < all; run += pixels)
        for (int c = 0; c < channels; ++c)
            for (std::size_t i = run; i < run + pixels; ++i, to += bytes)
                std::memcpy(to, from.data() + (i * channels + c) * bytes, bytes);
}

/// Reads a box whose bytes are known to fit. Straight into `out` where nothing has to be converted.
vo::Result<void> readTile(vo::VolumeFile& volume, const vo::Region& region, iflDataType type, iflOrder order,
                          std::byte* out)
{
    const vo::VolumeInfo& info = volume.info();
    const std::size_t pixels = static_cast<std::size_t>(region.size[0] * region.size[1] * region.size[2]);
    const bool sameType = type == typeOf(info.type);
    const bool apart = order != iflInterleaved && info.channels > 1;

    std::vector<std::byte> read, typed;
    if (!sameType || apart) read.resize(pixels * info.bytesPerVoxel());
    std::span<std::byte> voxels =
        read.empty() ? std::span(out, pixels * info.bytesPerVoxel()) : std::span(read);
    if (const auto done = volume.readBrick(region, voxels); !done) return done;
    if (!sameType) {
        if (apart) typed.resize(pixels * info.channels * bytesOf(type));
        convert(voxels, info.type, type, apart ? typed.data() : out);
        voxels = typed;
    }
    if (apart) {
        const std::int64_t run = region.size[0] * (order == iflSequential ? 1 : region.size[1]);
        separate(voxels, info.channels, bytesOf(type), static_cast<std::size_t>(run), out);
    }
    return {};
}

const char* generalText(iflStatus status)
{
    switch (status) {
    case iflOKAY: return "no error";
    case iflBADPARAM: return "a parameter has no meaning";
    case iflUNSUPPORTED: return "not supported";
    case iflOPENFAILED: return "the file could not be opened";
    case iflREADFAILED: return "the file could not be read";
    case iflMALLOCFAILED: return "no memory";
    default: return "unknown status";
    }
}

} // namespace

char* iflStatusToString(iflStatus status, char* buffer, int length)
{
    if (!buffer || length < 1) return buffer;
    const LastFailure& last = lastFailure();
    const std::string text =
        status != iflOKAY && status == last.status ? last.text : std::string(generalText(status));
    const std::size_t count = std::min(text.size(), static_cast<std::size_t>(length) - 1);
    text.copy(buffer, count);
    buffer[count] = '\0';
    return buffer;
}

iflFile* iflFile::open(const char* fileName, int flags, iflStatus* status)
{
    iflStatus ignored;
    iflStatus& answer = status ? *status : ignored;
    if (!fileName || !*fileName) {
        answer = failed(iflBADPARAM, "expected the name of a file, found none");
        return nullptr;
    }
    if ((flags & O_ACCMODE) != O_RDONLY) {
        answer = failed(iflUNSUPPORTED, std::string(fileName) + ": expected to be opened to read only");
        return nullptr;
    }
    try {
        auto volume = vo::openVolume(fileName);
        if (!volume) {
            answer = failed(iflOPENFAILED, volume.failure().text);
            return nullptr;
        }
        answer = iflOKAY;
        const vo::VolumeInfo info = volume->info();
        return new iflFile(new Private{fileName, info, std::move(*volume)});
    } catch (const std::bad_alloc&) {
        answer = failed(iflMALLOCFAILED, std::string(fileName) + ": no memory");
        return nullptr;
    }
}

iflFile::iflFile(Private* contents) : d(contents) {}

iflFile::~iflFile()
{
    {
        const std::lock_guard guard(closedFiles().lock);
        closedFiles().files.erase(this);
    }
    delete d;
}

iflStatus iflFile::close()
{
    d->volume.reset();
    const std::lock_guard guard(closedFiles().lock);
    closedFiles().files.insert(this);
    return iflOKAY;
}

iflStatus iflFile::getDimensions(iflSize& size) const
{
    const auto& found = d->info.size;
    size = iflSize(static_cast<int>(found[0]), static_cast<int>(found[1]), static_cast<int>(found[2]),
                   d->info.channels);
    return iflOKAY;
}

iflDataType iflFile::getDataType() const
{
    return typeOf(d->info.type);
}

iflColorModel iflFile::getColorModel() const
{
    return d->info.channels == 1 ? iflLuminance : d->info.channels == 2 ? iflLuminanceAlpha : iflRGBA;
}

int iflFile::getNumChannels() const
{
    return d->info.channels;
}

iflStatus iflFile::getTile(int x, int y, int z, int nx, int ny, int nz, void* data, const iflConfig* config)
{
    const iflDataType fileType = typeOf(d->info.type);
    const iflDataType type = config ? config->getDataType() : fileType;
    const iflOrder order = config ? config->getOrder() : iflInterleaved;
    if (!data) return failed(iflBADPARAM, d->name + ": expected memory for pixels, found NULL");
    if (!d->volume) return failed(iflBADPARAM, d->name + ": expected an open file, found it closed");
    if (!bytesOf(type) || (order != iflInterleaved && order != iflSequential && order != iflSeparate))
        return failed(iflUNSUPPORTED,
                      d->name + ": expected a type of whole bytes and an order of iflOrder, found " +
                          std::to_string(type) + " and " + std::to_string(order));
    const vo::Region region{{x, y, z}, {nx, ny, nz}};
    const int largest = std::max(bytesOf(type), bytesOf(fileType));
    const auto bytes = vo::volumeBytes(region.size, d->info.channels * largest);
    if (!bytes) return failed(iflBADPARAM, d->name + ": " + bytes.failure().text);
    try {
        const auto read = readTile(*d->volume, region, type, order, static_cast<std::byte*>(data));
        return read ? iflOKAY : failed(iflREADFAILED, read.failure().text);
    } catch (const std::bad_alloc&) {
        return failed(iflMALLOCFAILED, d->name + ": no memory for a tile");
    }
}
