#include "decoded_picture.h"

#include "input_file.h"

namespace vo {

Result<VolumeFile> openPicture(const std::string& path, const char* format, const StoredLayout& layout,
                               std::int64_t mostBytesPerFileByte,
                               const std::function<const char*(std::byte*)>& decode)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    const auto bytes = storedBytes(path, layout);
    if (!bytes) return bytes.failure();
    if (*bytes / mostBytesPerFileByte > file->size())
        return Failure{path + ": expected " + std::to_string(*bytes) + " bytes of pixels, found a file of " +
                       std::to_string(file->size()) + " bytes, which cannot hold them"};
    auto block = MemoryBlock::allocate(path, *bytes);
    if (!block) return block.failure();
    if (const char* const wrong = decode(block->bytes().data()))
        return Failure{path + ": cannot read the picture: " + wrong};
    VolumeDescription about;
    about.format = format;
    return openStoredVoxels(layout, Placement(), bytesInMemory(std::move(*block)), std::move(about));
}

} // namespace vo
