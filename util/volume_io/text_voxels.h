#pragma once

#include <span>

#include "input_file.h"
#include "stored_voxels.h"

namespace vo {

/// Reads numbers written as text from byte `offset` on, between them blanks, line ends or commas, until `out`
/// is full of numbers of this type in this machine's byte order. A failure where there are fewer or where a
/// word is no number of the type.
Result<void> readNumberText(const InputFile& file, std::int64_t offset, StoredType type,
                            std::span<std::byte> out);

/// The same for bytes of two hexadecimal digits each, with blanks anywhere.
Result<void> readHexBytes(const InputFile& file, std::int64_t offset, std::span<std::byte> out);

} // namespace vo
