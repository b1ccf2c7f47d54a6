#pragma once

#include "stored_voxels.h"

namespace vo {

/// How the voxels of a file are written down: as bytes, as bytes compressed with gzip or zlib, as decimal
/// numbers, as two hexadecimal digits for each byte.
enum class Encoding { raw, deflate, text, hex };

/// The files that a header names, or itself.
struct DataFiles
{
    std::vector<std::string> paths; // at least one
    std::int64_t firstByte = 0;     // where reading begins in each
    unsigned lineSkip = 0;          // lines passed over from there
    /// Then bytes, of what is decoded where it is compressed; -1, for raw ones: the voxels end the file.
    std::int64_t byteSkip = 0;
    Encoding encoding = Encoding::raw;
};

/// The file names that NRRD and MetaImage write as `NAME` or as `PATTERN FIRST LAST STEP`, where the pattern
/// has a number as %d, %3d or %03d. `path` is the header's name, for messages.
Result<std::vector<std::string>> namedFiles(const std::string& path, const std::string& value);

/// The names as seen from the folder of the header.
std::vector<std::string> besideHeader(const std::string& path, const std::vector<std::string>& names);

/// The voxels: `bytes` bytes of the first of `volumes` volumes. Several files share all volumes evenly. What
/// files of their sizes cannot hold is refused before memory is asked for.
Result<std::unique_ptr<StoredBytes>> openDataFiles(const std::string& path, const DataFiles& data,
                                                   StoredType type, std::int64_t bytes, std::int64_t volumes);

} // namespace vo
