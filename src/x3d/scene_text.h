#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace vo {

/// The text of a file, decompressed where gzip made it, up to `most` bytes. Links are not followed, devices
/// and pipes not read. False where there is none: then `reason` says why.
bool readSceneFile(const std::filesystem::path& path, std::int64_t most, std::string& text,
                   std::string& reason);

} // namespace vo
