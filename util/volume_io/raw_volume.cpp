#include "volume_io.h"

#include "input_file.h"
#include "stored_voxels.h"

namespace vo {
namespace {

StoredType storedType(ChannelType type)
{
    switch (type) {
    case ChannelType::uint8: return StoredType::uint8;
    case ChannelType::int8: return StoredType::int8;
    case ChannelType::uint16: return StoredType::uint16;
    case ChannelType::int16: return StoredType::int16;
    case ChannelType::float32: return StoredType::float32;
    }
    return StoredType::uint8;
}

StoredLayout storedLayout(const RawLayout& layout)
{
    return {layout.info.size, layout.info.channels, false, storedType(layout.info.type), layout.byteOrder};
}

/// Bytes of the whole volume, once the layout has been found possible.
Result<std::int64_t> checkedBytes(const std::string& path, const RawLayout& layout)
{
    if (layout.headerLength < 0)
        return Failure{path + ": expected a header of 0 or more bytes, found " +
                       std::to_string(layout.headerLength)};
    return storedBytes(path, storedLayout(layout));
}

/// For a user who may have the sizes wrong: voxels, or slices, that nobody sees.
std::string leftOverNote(std::int64_t bytes, std::size_t longer, std::size_t files)
{
    const std::string where =
        files > 1 ? " in " + std::to_string(longer) + " of " + std::to_string(files) + " files" : "";
    return std::to_string(bytes) + " bytes after the voxels" + where + " are left over";
}

/// The volume whose bytes the files share evenly.
Result<VolumeFile> openPieces(const std::vector<std::string>& paths, const RawLayout& layout,
                              std::int64_t bytesPerFile)
{
    std::vector<FilePiece> pieces;
    std::int64_t leftOver = 0;
    std::size_t longer = 0;
    for (const std::string& path : paths) {
        const auto file = InputFile::open(path);
        if (!file) return file.failure();
        // Compared so that neither side can overflow.
        if (file->size() < layout.headerLength || file->size() - layout.headerLength < bytesPerFile)
            return Failure{path + ": expected a header of " + std::to_string(layout.headerLength) +
                           " bytes and " + std::to_string(bytesPerFile) + " bytes of voxels, found " +
                           std::to_string(file->size()) + " bytes"};
        pieces.push_back({path, layout.headerLength});
        const std::int64_t rest = file->size() - layout.headerLength - bytesPerFile;
        leftOver += rest;
        longer += rest > 0;
    }
    auto bytes = bytesInFiles(std::move(pieces), bytesPerFile);
    if (!bytes) return bytes.failure();
    VolumeDescription about;
    about.format = "raw";
    if (leftOver > 0) about.notes.push_back(leftOverNote(leftOver, longer, paths.size()));
    return openStoredVoxels(storedLayout(layout), Placement(), std::move(*bytes), std::move(about));
}

} // namespace

Result<ChannelType> rawChannelType(const std::string& what, const std::string& name)
{
    constexpr std::pair<const char*, ChannelType> types[] = {
        {"char", ChannelType::int8},   {"uchar", ChannelType::uint8},   {"ubyte", ChannelType::uint8},
        {"short", ChannelType::int16}, {"ushort", ChannelType::uint16}, {"float", ChannelType::float32}};
    for (const auto& [word, type] : types)
        if (name == word) return type;
    return Failure{what + ": expected char, uchar, ubyte, short, ushort or float, found \"" + name + "\""};
}

Result<VolumeFile> openRawVolume(const std::string& path, const RawLayout& layout)
{
    const auto bytes = checkedBytes(path, layout);
    if (!bytes) return bytes.failure();
    return openPieces({path}, layout, *bytes);
}

Result<VolumeFile> openRawSlices(const std::vector<std::string>& paths, const RawLayout& layout)
{
    const std::string first = paths.empty() ? "raw slices" : paths.front();
    const auto bytes = checkedBytes(first, layout);
    if (!bytes) return bytes.failure();
    if (paths.size() != static_cast<std::uint64_t>(layout.info.size[2]))
        return Failure{first + ": expected " + std::to_string(layout.info.size[2]) +
                       " files, one a slice, found " + std::to_string(paths.size())};
    return openPieces(paths, layout, *bytes / layout.info.size[2]);
}

} // namespace vo
