#pragma once

#include <array>
#include <string>

#include "volume_io/result.h"

namespace vo {

/// A lookup table from a text file, stretched or shrunk to 256 entries.
struct LookupFile
{
    static constexpr int kEntries = 256;

    /// Whether the file has red, green and blue; otherwise they are equal, being its luminance.
    bool isColor = false;
    /// Red, green, blue, alpha of each entry, from 0 to 1, not premultiplied; the first entry is the lowest
    /// value. Alpha is the opacity of one slice.
    std::array<float, 4 * kEntries> rgba{};
};

/// Reads a table: one entry a line, either luminance and alpha or red, green, blue and alpha, the same on all
/// lines. All numbers of a file are whole and from 0 to 255, or all have a decimal point and lie from 0 to 1.
/// # begins a comment, empty lines are passed over. From 2 to 4096 entries, between which values are
/// interpolated linearly. A failure names the file and the line.
Result<LookupFile> readLookupFile(const std::string& path);

} // namespace vo
