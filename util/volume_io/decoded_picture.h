#pragma once

#include <functional>

#include "stored_voxels.h"

namespace vo {

/// A file of one picture as a volume of one slice, decoded whole. A file too short for such a picture, which
/// takes at least a byte for each `mostBytesPerFileByte` of its pixels, is refused before memory is asked
/// for. `decode` fills the pixels, or returns what is wrong with them, else null.
Result<VolumeFile> openPicture(const std::string& path, const char* format, const StoredLayout& layout,
                               std::int64_t mostBytesPerFileByte,
                               const std::function<const char*(std::byte*)>& decode);

} // namespace vo
