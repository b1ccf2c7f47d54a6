#include "input_file.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vo {

Result<InputFile> InputFile::open(const std::string& path)
{
    // Without O_NONBLOCK the opening of a named pipe would wait for a writer.
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (descriptor < 0) return Failure{path + ": cannot open: " + std::strerror(errno)};
    struct stat status = {};
    const bool known = ::fstat(descriptor, &status) == 0;
    InputFile file(path, descriptor, static_cast<std::int64_t>(status.st_size));
    if (!known) return Failure{path + ": cannot open: " + std::strerror(errno)};
    if (!S_ISREG(status.st_mode))
        return Failure{path + ": expected a regular file, found " +
                       (S_ISDIR(status.st_mode) ? "a folder" : "a device or the like")};
    return file;
}

InputFile::InputFile(std::string path, int descriptor, std::int64_t size)
    : path_(std::move(path)), descriptor_(descriptor), size_(size)
{
}

InputFile::InputFile(InputFile&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)), size_(other.size_)
{
}

InputFile& InputFile::operator=(InputFile&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(descriptor_, other.descriptor_);
    std::swap(size_, other.size_);
    return *this;
}

InputFile::~InputFile()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> InputFile::readAt(std::int64_t offset, std::span<std::byte> out) const
{
    while (!out.empty()) {
        const ssize_t count = ::pread(descriptor_, out.data(), out.size(), offset);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return Failure{path_ + ": cannot read: " + std::strerror(errno)};
        if (count == 0)
            return Failure{path_ + ": cut off: expected " + std::to_string(out.size()) +
                           " more bytes at byte " + std::to_string(offset) + ", found the end of the file"};
        out = out.subspan(static_cast<std::size_t>(count));
        offset += count;
    }
    return {};
}

} // namespace vo
