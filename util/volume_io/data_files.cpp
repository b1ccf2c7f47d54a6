#include "data_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <sstream>

#include "deflate_stream.h"
#include "input_file.h"
#include "numbered_name.h"
#include "printable_text.h"
#include "text_voxels.h"

namespace vo {
namespace {

constexpr std::int64_t kMostFiles = 1 << 20;

/// Where the voxels begin in a data file whose header ends at `offset`.
Result<std::int64_t> afterSkippedLines(const InputFile& file, std::int64_t offset, unsigned lines)
{
    std::array<char, 4096> chunk;
    while (lines > 0) {
        const auto count =
            std::min<std::int64_t>(static_cast<std::int64_t>(chunk.size()), file.size() - offset);
        if (count <= 0)
            return Failure{file.path() + ": cut off: expected " + std::to_string(lines) +
                           " more lines before the voxels, found the end of the file"};
        const auto part = std::span(chunk).first(static_cast<std::size_t>(count));
        if (auto read = file.readAt(offset, std::as_writable_bytes(part)); !read) return read.failure();
        std::size_t used = 0;
        for (; used < part.size() && lines > 0; ++used)
            lines -= part[used] == '\n';
        offset += static_cast<std::int64_t>(used);
    }
    return offset;
}

Result<std::unique_ptr<StoredBytes>> rawBytes(const DataFiles& data, std::int64_t bytesPerFile)
{
    std::vector<FilePiece> pieces;
    for (const std::string& path : data.paths) {
        const auto file = InputFile::open(path);
        if (!file) return file.failure();
        const auto start = afterSkippedLines(*file, data.firstByte, data.lineSkip);
        if (!start) return start.failure();
        const std::int64_t fromEnd = std::max<std::int64_t>(file->size() - bytesPerFile, *start);
        if (data.byteSkip > file->size())
            return Failure{path + ": cut off: expected " + std::to_string(data.byteSkip) +
                           " bytes before the voxels, found a file of " + std::to_string(file->size())};
        pieces.push_back({path, data.byteSkip < 0 ? fromEnd : *start + data.byteSkip});
    }
    return bytesInFiles(std::move(pieces), bytesPerFile);
}

/// Fills `out` from a file that has to be decoded.
Result<void> decode(const DataFiles& data, const std::string& path, StoredType type, std::span<std::byte> out)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    const auto start = afterSkippedLines(*file, data.firstByte, data.lineSkip);
    if (!start) return start.failure();
    if (data.encoding == Encoding::deflate) {
        DeflateStream stream(*file, *start);
        if (auto skipped = stream.skip(data.byteSkip); !skipped) return skipped;
        if (auto read = stream.read(out); !read) return read;
        return stream.finish();
    }
    const std::int64_t from = *start + std::min(data.byteSkip, file->size());
    return data.encoding == Encoding::hex ? readHexBytes(*file, from, out)
                                          : readNumberText(*file, from, type, out);
}

Result<std::unique_ptr<StoredBytes>> decodedBytes(const DataFiles& data, StoredType type,
                                                  std::int64_t bytesPerFile)
{
    // No encoding holds more than this: deflate 1032 bytes in one, text and hex less than their length
    // (a number of 8 bytes may take a digit and a blank).
    const std::int64_t mostPerByte = data.encoding == Encoding::deflate ? 1032 : 4;
    std::int64_t total = 0;
    for (const std::string& path : data.paths) {
        const auto file = InputFile::open(path);
        if (!file) return file.failure();
        if (bytesPerFile / mostPerByte > file->size())
            return Failure{path + ": expected " + std::to_string(bytesPerFile) +
                           " bytes of voxels, found a file of " + std::to_string(file->size()) +
                           " bytes, which cannot hold them"};
        total += bytesPerFile;
    }
    auto block = MemoryBlock::allocate(data.paths.front(), total);
    if (!block) return block.failure();
    std::span<std::byte> left = block->bytes();
    for (const std::string& path : data.paths) {
        const auto part = left.first(static_cast<std::size_t>(bytesPerFile));
        if (auto decoded = decode(data, path, type, part); !decoded) return decoded.failure();
        left = left.subspan(part.size());
    }
    return bytesInMemory(std::move(*block));
}

} // namespace

Result<std::vector<std::string>> namedFiles(const std::string& path, const std::string& value)
{
    std::istringstream words(value);
    std::string pattern;
    std::int64_t first = 0, last = 0, step = 0;
    if (!(words >> pattern >> first >> last >> step) || !numberedName(pattern, 0))
        return std::vector<std::string>{value};
    constexpr std::int64_t kLargest = 1'000'000'000;
    const bool ends = step != 0 && first >= 0 && last >= 0 && first <= kLargest && last <= kLargest &&
                      (step > 0 ? last >= first : last <= first);
    if (!ends || (last - first) / step >= kMostFiles)
        return Failure{path + ": expected a range of 1 to " + std::to_string(kMostFiles) +
                       " data files, found \"" + printable(value) + "\""};
    std::vector<std::string> files;
    for (std::int64_t number = first; step > 0 ? number <= last : number >= last; number += step)
        files.push_back(*numberedName(pattern, number));
    return files;
}

std::vector<std::string> besideHeader(const std::string& path, const std::vector<std::string>& names)
{
    const auto folder = std::filesystem::path(path).parent_path();
    std::vector<std::string> paths;
    for (const std::string& name : names)
        paths.push_back((folder / name).string()); // an absolute name replaces the folder
    return paths;
}

Result<std::unique_ptr<StoredBytes>> openDataFiles(const std::string& path, const DataFiles& data,
                                                   StoredType type, std::int64_t bytes, std::int64_t volumes)
{
    const auto files = static_cast<std::int64_t>(data.paths.size());
    std::int64_t all = bytes;
    if (files > 1 && (__builtin_mul_overflow(bytes, volumes, &all) || all % files != 0))
        return Failure{path + ": expected voxels that " + std::to_string(files) +
                       " data files share evenly, found " + std::to_string(bytes) + " bytes in each of " +
                       std::to_string(volumes) + " volumes"};
    return data.encoding == Encoding::raw ? rawBytes(data, all / files)
                                          : decodedBytes(data, type, all / files);
}

} // namespace vo
