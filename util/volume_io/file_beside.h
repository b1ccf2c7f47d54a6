#pragma once

#include <string>

#include "result.h"

namespace vo {

/// A new file under a temporary name in the folder of its final one, so that nobody ever sees it half
/// written. Unless committed, it is removed when this object goes.
class FileBeside
{
public:
    /// Makes the empty temporary file. Fails where the folder cannot be written to, or where `path` is
    /// something else than a regular file (a folder, a device).
    static Result<FileBeside> create(const std::string& path);
    FileBeside(FileBeside&& other) noexcept;
    FileBeside& operator=(FileBeside&& other) noexcept;
    ~FileBeside();

    /// The temporary name, to be written to.
    const std::string& temporaryPath() const { return temporary_; }

    /// Gives the file its final name, replacing what stood there.
    Result<void> commit();

private:
    FileBeside(std::string path, std::string target, std::string temporary);

    std::string path_;      // as the caller named it, for messages
    std::string target_;    // with links resolved
    std::string temporary_; // empty once committed or moved from
};

} // namespace vo
