#include "brick_io.h"

#include "data_type.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <list>
#include <mutex>
#include <string>
#include <sys/stat.h>
#include <vector>

namespace {

constexpr std::size_t kOpenFiles = 4;

using Sizes = std::array<std::int64_t, 3>;

int fail(const std::string& text)
{
    std::fprintf(stderr, "%s: %s\n", program_invocation_short_name, text.c_str());
    return 1;
}

/// What tells whether a file is still the one that was opened.
struct FileIdentity
{
    dev_t device{};
    ino_t number{};
    off_t size{};
    timespec changed{};

    static FileIdentity of(const std::string& path)
    {
        struct stat status = {};
        if (::stat(path.c_str(), &status) != 0) return {};
        return {status.st_dev, status.st_ino, status.st_size, status.st_mtim};
    }
    bool operator==(const FileIdentity& other) const
    {
        return device == other.device && number == other.number && size == other.size &&
               changed.tv_sec == other.changed.tv_sec && changed.tv_nsec == other.changed.tv_nsec;
    }
};

/// The volumes read last, kept open from brick to brick. Callers hold `lock`.
class OpenVolumes
{
public:
    std::mutex lock;

    /// The volume of that name, opened by `open` unless it is open and unchanged on the disk.
    template <class Open>
    vo::Result<vo::VolumeFile*> find(const std::string& name, const std::string& path, Open open)
    {
        const FileIdentity identity = FileIdentity::of(path);
        const auto known = std::ranges::find(entries_, name, &Entry::name);
        if (known != entries_.end() && known->identity == identity) {
            entries_.splice(entries_.begin(), entries_, known);
            return &entries_.front().volume;
        }
        if (known != entries_.end()) entries_.erase(known);
        auto volume = open();
        if (!volume) return volume.failure();
        entries_.push_front({name, identity, std::move(*volume)});
        if (entries_.size() > kOpenFiles) entries_.pop_back();
        return &entries_.front().volume;
    }

private:
    struct Entry
    {
        std::string name;
        FileIdentity identity;
        vo::VolumeFile volume;
    };
    std::list<Entry> entries_; // the one used last comes first
};

OpenVolumes& openVolumes()
{
    static OpenVolumes volumes;
    return volumes;
}

void printNotes(const std::string& path, const vo::VolumeFile& volume)
{
    for (const std::string& note : volume.description().notes)
        std::fprintf(stderr, "%s: %s: %s\n", program_invocation_short_name, path.c_str(), note.c_str());
}

/// The open volume of any format; what it has to say about itself is printed when it is opened.
vo::Result<vo::VolumeFile*> openedVolume(const std::string& path)
{
    return openVolumes().find("volume " + path, path, [&path] {
        auto volume = vo::openVolume(path);
        if (volume) printNotes(path, *volume);
        return volume;
    });
}

/// The same for the name that an application gave.
vo::Result<vo::VolumeFile*> namedVolume(const char* fileName)
{
    if (!fileName) return vo::Failure{"expected the name of a volume file, found NULL"};
    if (!*fileName) return vo::Failure{"expected the name of a volume file, found ''"};
    return openedVolume(fileName);
}

voExternalFormatType formatOf(int channels)
{
    return channels == 1   ? voExternalFormatTypeScope::LUMINANCE
           : channels == 2 ? voExternalFormatTypeScope::LUMINANCE_ALPHA
                           : voExternalFormatTypeScope::RGBA;
}

std::string text(const Sizes& sizes)
{
    return std::to_string(sizes[0]) + " x " + std::to_string(sizes[1]) + " x " + std::to_string(sizes[2]);
}

int readBrick(const std::string& name, vo::VolumeFile& volume, void* data, const vo::Region& region)
{
    if (!data) return fail(name + ": expected memory for a brick, found NULL");
    const auto bytes = vo::volumeBytes(region.size, volume.info().bytesPerVoxel());
    if (!bytes) return fail(name + ": brick: " + bytes.failure().text);
    const auto read =
        volume.readBrick(region, {static_cast<std::byte*>(data), static_cast<std::size_t>(*bytes)});
    if (read) return 0;
    const std::string& why = read.failure().text;
    return fail(why.find(name) == 0 ? why : name + ": " + why);
}

int readVolumeBrick(const char* fileName, void* data, const vo::Region& region, const Sizes* volumeSize)
{
    const std::lock_guard guard(openVolumes().lock);
    const auto volume = namedVolume(fileName);
    if (!volume) return fail(volume.failure().text);
    const Sizes& found = (*volume)->info().size;
    if (volumeSize && *volumeSize != found)
        return fail(std::string(fileName) + ": expected a volume of " + text(*volumeSize) +
                    " voxels, found " + text(found));
    return readBrick(fileName, **volume, data, region);
}

/// The layout that holds voxels and channels of so many bytes; how the bytes are read as numbers does not
/// matter.
vo::Result<vo::RawLayout> rawLayout(const Sizes& size, int headerLength, int bytesPerVoxel,
                                    int bytesPerChannel, bool bigEndian)
{
    const int channels = bytesPerChannel > 0 ? bytesPerVoxel / bytesPerChannel : 0;
    const bool knownChannel = bytesPerChannel == 1 || bytesPerChannel == 2 || bytesPerChannel == 4;
    if (!knownChannel || channels * bytesPerChannel != bytesPerVoxel ||
        (channels != 1 && channels != 2 && channels != 4))
        return vo::Failure{"raw slices: expected 1, 2 or 4 channels of 1, 2 or 4 bytes, found voxels of " +
                           std::to_string(bytesPerVoxel) + " bytes with channels of " +
                           std::to_string(bytesPerChannel)};
    const auto type = bytesPerChannel == 1   ? vo::ChannelType::uint8
                      : bytesPerChannel == 2 ? vo::ChannelType::uint16
                                             : vo::ChannelType::float32;
    return vo::RawLayout{{size, channels, type},
                         headerLength,
                         bigEndian ? vo::ByteOrder::bigEndian : vo::ByteOrder::littleEndian};
}

int readRawBrick(char** fileNames, void* data, const vo::Region& region, const vo::RawLayout& layout)
{
    if (!fileNames) return fail("expected the names of raw slices, found NULL");
    std::vector<std::string> paths;
    std::string name = "raw";
    for (std::int64_t z = 0; z < layout.info.size[2]; ++z) {
        if (!fileNames[z])
            return fail("expected the name of raw slice " + std::to_string(z) + ", found NULL");
        paths.emplace_back(fileNames[z]);
        name += '\n' + paths.back();
    }
    name += '\n' + text(layout.info.size) + ' ' + std::to_string(layout.headerLength) + ' ' +
            std::to_string(layout.info.channels) + ' ' + vo::channelTypeName(layout.info.type) +
            (layout.byteOrder == vo::ByteOrder::bigEndian ? " big" : " little");

    const std::string first = paths.empty() ? "raw slices" : paths.front();
    const std::lock_guard guard(openVolumes().lock);
    const auto volume = openVolumes().find(name, first, [&] {
        auto opened = vo::openRawSlices(paths, layout);
        if (opened) printNotes(first, *opened);
        return opened;
    });
    if (!volume) return fail(volume.failure().text);
    return readBrick(first, **volume, data, region);
}

} // namespace

int myGetVolumeSizesIfl(char* fileName, int& xSize, int& ySize, int& zSize,
                        voExternalFormatType& diskDataFormat, voDataType& dataType)
{
    const std::lock_guard guard(openVolumes().lock);
    const auto volume = namedVolume(fileName);
    if (!volume) return fail(volume.failure().text);
    const vo::VolumeInfo& info = (*volume)->info();
    xSize = static_cast<int>(info.size[0]);
    ySize = static_cast<int>(info.size[1]);
    zSize = static_cast<int>(info.size[2]);
    diskDataFormat = formatOf(info.channels);
    dataType = dataTypeOf(info.type);
    return 0;
}

int myGetVolumeSpacing(char* fileName, double& xSpacing, double& ySpacing, double& zSpacing)
{
    const std::lock_guard guard(openVolumes().lock);
    const auto volume = namedVolume(fileName);
    if (!volume) return fail(volume.failure().text);
    const std::array<double, 3>& spacing = (*volume)->description().spacing;
    xSpacing = spacing[0];
    ySpacing = spacing[1];
    zSpacing = spacing[2];
    return 0;
}

int myGetVolumeAlphaAdded(char* fileName, bool& added)
{
    const std::lock_guard guard(openVolumes().lock);
    const auto volume = namedVolume(fileName);
    if (!volume) return fail(volume.failure().text);
    added = (*volume)->description().alphaAdded;
    return 0;
}

int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize)
{
    const Sizes volumeSize{xVolumeSize, yVolumeSize, zVolumeSize};
    return readVolumeBrick(fileName, data,
                           {{xBrickOrigin, yBrickOrigin, zBrickOrigin}, {xBrickSize, yBrickSize, zBrickSize}},
                           &volumeSize);
}

int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize)
{
    return readVolumeBrick(fileName, data,
                           {{xBrickOrigin, yBrickOrigin, zBrickOrigin}, {xBrickSize, yBrickSize, zBrickSize}},
                           nullptr);
}

int myReadBrickRaw(char** fileNames, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize, int headerLength, int bytesPerVoxel)
{
    // Channels of any size will do: in this machine's order the bytes stay as they are.
    const int bytesPerChannel = bytesPerVoxel == 8 ? 2 : bytesPerVoxel == 16 ? 4 : std::min(bytesPerVoxel, 4);
    return myReadBrickRaw(fileNames, data, xBrickOrigin, yBrickOrigin, zBrickOrigin, xBrickSize, yBrickSize,
                          zBrickSize, xVolumeSize, yVolumeSize, zVolumeSize, headerLength, bytesPerVoxel,
                          bytesPerChannel, vo::nativeByteOrder() == vo::ByteOrder::bigEndian);
}

int myReadBrickRaw(char** fileNames, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize, int headerLength, int bytesPerVoxel, int bytesPerChannel, int bigEndian)
{
    const auto layout = rawLayout({xVolumeSize, yVolumeSize, zVolumeSize}, headerLength, bytesPerVoxel,
                                  bytesPerChannel, bigEndian != 0);
    if (!layout) return fail(layout.failure().text);
    return readRawBrick(fileNames, data,
                        {{xBrickOrigin, yBrickOrigin, zBrickOrigin}, {xBrickSize, yBrickSize, zBrickSize}},
                        *layout);
}
