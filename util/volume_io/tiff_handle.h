#pragma once

#include <memory>
#include <string>

#include <tiffio.h>

#include "input_file.h"

namespace vo {

/// A TIFF being read or written, with what libtiff says about it kept instead of printed.
class TiffHandle
{
public:
    /// Reads through `file`, which this object keeps. Strips stay as they lie in the file.
    static Result<TiffHandle> read(InputFile file);
    /// Writes to an existing empty file, `path` being its name in messages.
    static Result<TiffHandle> write(const std::string& temporaryPath, const std::string& path, bool bigTiff);

    TiffHandle(TiffHandle&&) noexcept;
    TiffHandle& operator=(TiffHandle&&) noexcept;
    ~TiffHandle();

    TIFF* get() const;
    /// The file being read.
    const InputFile& file() const;

    /// What libtiff complained about since the last call, as ": text", or nothing.
    std::string takeComplaint();
    /// Whether an error (not a mere warning) was reported since takeComplaint().
    bool sawError() const;

    /// Writes what is left and closes; the object is good for nothing afterwards.
    Result<void> closeWritten();

private:
    struct State;
    friend struct TiffInput;
    explicit TiffHandle(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace vo
