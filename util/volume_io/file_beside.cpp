#include "file_beside.h"

#include "volume_io.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace vo {
namespace {

namespace fs = std::filesystem;

std::string temporaryNameFor(const std::string& target)
{
    static std::atomic<unsigned> counter{0};
    return target + ".partial-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
}

} // namespace

Result<FileBeside> FileBeside::create(const std::string& path)
{
    if (path.empty()) return Failure{"cannot write: expected a file name, found an empty one"};
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        return Failure{path + ": cannot write: expected a regular file or a new name, found " +
                       (fs::is_directory(status) ? "a folder" : "a device or the like")};
    std::string target = path;
    if (fs::is_symlink(fs::symlink_status(path, error)) && fs::exists(status))
        target = fs::canonical(path, error).string();

    const std::string temporary = temporaryNameFor(target);
    const int descriptor = ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (descriptor < 0) return Failure{path + ": cannot write: " + std::strerror(errno)};
    ::close(descriptor);
    return FileBeside(path, target, temporary);
}

FileBeside::FileBeside(std::string path, std::string target, std::string temporary)
    : path_(std::move(path)), target_(std::move(target)), temporary_(std::move(temporary))
{
}

FileBeside::FileBeside(FileBeside&& other) noexcept
    : path_(std::move(other.path_)), target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, std::string()))
{
}

FileBeside& FileBeside::operator=(FileBeside&& other) noexcept
{
    std::swap(path_, other.path_);
    std::swap(target_, other.target_);
    std::swap(temporary_, other.temporary_);
    return *this;
}

FileBeside::~FileBeside()
{
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

Result<void> FileBeside::commit()
{
    std::error_code error;
    fs::rename(temporary_, target_, error);
    if (error) return Failure{path_ + ": cannot give the finished file its name: " + error.message()};
    temporary_.clear();
    return {};
}

Result<void> writeBytes(const std::string& path, std::span<const std::byte> bytes)
{
    auto beside = FileBeside::create(path);
    if (!beside) return beside.failure();
    std::FILE* file = std::fopen(beside->temporaryPath().c_str(), "wb");
    if (!file) return Failure{path + ": cannot write: " + std::strerror(errno)};
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    const int error = errno;
    if (std::fclose(file) != 0 || !written)
        return Failure{path + ": cannot write: " + std::strerror(written ? errno : error)};
    return beside->commit();
}

} // namespace vo
