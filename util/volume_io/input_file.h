#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "result.h"

namespace vo {

/// A regular file, open for reading at any place.
class InputFile
{
public:
    static Result<InputFile> open(const std::string& path);
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;
    ~InputFile();

    const std::string& path() const { return path_; }
    /// Bytes in the file when it was opened.
    std::int64_t size() const { return size_; }

    /// Fills `out` from `offset` on; a failure if the file ends before or cannot be read.
    Result<void> readAt(std::int64_t offset, std::span<std::byte> out) const;

private:
    InputFile(std::string path, int descriptor, std::int64_t size);

    std::string path_;
    int descriptor_ = -1;
    std::int64_t size_ = 0;
};

} // namespace vo
