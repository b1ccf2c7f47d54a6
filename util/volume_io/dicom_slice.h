#pragma once

#include <optional>

#include "stored_voxels.h"

namespace vo {

/// What a DICOM file says of its picture or pictures.
struct DicomSlice
{
    std::string path;
    std::string series;            // the series' unique identifier
    std::string seriesDescription; // may be empty
    std::int64_t columns = 0, rows = 0, frames = 1;
    int channels = 1;
    int bitsAllocated = 0, bitsStored = 0, highBit = 0;
    bool isSigned = false;
    bool lowIsWhite = false;
    /// Unit vectors along rows and columns and the first voxel's place, in mm left, back, up.
    std::optional<std::array<Vector3, 2>> directions;
    std::optional<Vector3> position;
    /// Distance of columns and of rows, in mm; not above 0 where the file does not say.
    std::array<double, 2> spacing{};
    /// Distance of frames or slices as the file has it; 0 where it does not.
    double sliceSpacing = 0;
    double slope = 1, intercept = 0;
    std::int64_t instance = 0;
    bool isCompressed = false;

    StoredLayout layout() const
    {
        StoredLayout layout;
        layout.size = {columns, rows, frames};
        layout.channels = channels;
        layout.type = bitsAllocated == 8    ? (isSigned ? StoredType::int8 : StoredType::uint8)
                      : bitsAllocated == 16 ? (isSigned ? StoredType::int16 : StoredType::uint16)
                                            : (isSigned ? StoredType::int32 : StoredType::uint32);
        return layout;
    }
};

/// What a file turned out to be: a picture, no DICOM picture at all (nothing), or one that cannot be read.
using DicomHeader = Result<std::optional<DicomSlice>>;

/// Reads everything but the pixels: one answer for each path.
std::vector<DicomHeader> readDicomHeaders(const std::vector<std::string>& paths);

/// Reads the pixels of one file after another, all their frames, into memory of exactly their size: channels
/// side by side, in this machine's byte order, bits that belong to no value cleared or filled with the sign.
/// All files have as many bytes of pixels.
Result<void> readDicomPixels(const std::vector<DicomSlice>& slices, std::span<std::byte> out);

/// The two functions above as a library of its own offers them, under the name volumizerDicom: GDCM and what
/// it needs take longer to load than most files take to read. In programs the functions load that library;
/// where it is missing, they answer with failures that say so.
struct DicomFunctions
{
    std::vector<DicomHeader> (*readHeaders)(const std::vector<std::string>& paths);
    Result<void> (*readPixels)(const std::vector<DicomSlice>& slices, std::span<std::byte> out);
};

} // namespace vo
