#pragma once

#include "volume_io.h"

namespace vo {

/// Memory of a brick, addressed by voxels of the volume.
class BrickView
{
public:
    BrickView(const Region& region, int bytesPerVoxel, std::span<std::byte> bytes)
        : region_(region), bytesPerVoxel_(bytesPerVoxel), bytes_(bytes.data())
    {
    }

    /// Where the voxel (x, y, z) of the volume lies.
    std::byte* voxel(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        const std::int64_t row = (z - region_.origin[2]) * region_.size[1] + (y - region_.origin[1]);
        return bytes_ + (row * region_.size[0] + (x - region_.origin[0])) * bytesPerVoxel_;
    }
    std::int64_t width() const { return region_.size[0]; }

private:
    Region region_;
    std::int64_t bytesPerVoxel_;
    std::byte* bytes_;
};

/// What each file format implements.
class VolumeReader
{
public:
    virtual ~VolumeReader() = default;

    /// Fills those voxels of `brick` that belong to `inside`, which lies inside volume and brick and is not
    /// empty.
    virtual Result<void> read(const Region& inside, const BrickView& brick) = 0;

    /// A reader of the same voxels for another thread, with counters of its own; null where making one costs
    /// as much as reading.
    virtual std::unique_ptr<VolumeReader> another() const { return nullptr; }

    const VolumeInfo& info() const { return info_; }
    const VolumeDescription& description() const { return description_; }
    const ReadCounters& counters() const { return counters_; }

protected:
    VolumeInfo info_;
    VolumeDescription description_;
    ReadCounters counters_;
};

/// Opens page stacks and SGI's 3D TIFF. The file is known to begin like a TIFF.
Result<VolumeFile> openTiffVolume(const std::string& path);

/// Opens a header, with the voxels behind it or in files that it names.
Result<VolumeFile> openNrrdVolume(const std::string& path);

/// Opens NIfTI-1 and -2, also compressed with gzip; of a pair of files, `path` is either.
Result<VolumeFile> openNiftiVolume(const std::string& path);

/// Opens .mha and .mhd.
Result<VolumeFile> openMetaImageVolume(const std::string& path);

/// Opens one file of one or more frames.
Result<VolumeFile> openDicomFile(const std::string& path);

/// Opens the series of a folder that has the most slices.
Result<VolumeFile> openDicomFolder(const std::string& path);

/// Opens a picture as a volume of one slice.
Result<VolumeFile> openPngVolume(const std::string& path);

/// The same of JPEG.
Result<VolumeFile> openJpegVolume(const std::string& path);

} // namespace vo
