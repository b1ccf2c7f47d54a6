#pragma once

/// Volumes and pictures in files. The only part of the project that knows file formats; it needs neither the
/// library nor OpenGL. Nothing here prints: what goes wrong comes back as a Failure.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "result.h"

namespace vo {

/// Numeric type of one channel of a voxel. In memory always in the byte order of this machine.
enum class ChannelType { uint8, int8, uint16, int16, float32 };

/// Bytes of one channel: 1, 2 or 4.
int bytesPerChannel(ChannelType type);

/// Name for messages: "uint8" ... "float32".
const char* channelTypeName(ChannelType type);

/// Shape of a volume. Voxels lie x fastest, then y, then z; the channels of a voxel lie side by side.
struct VolumeInfo
{
    /// Voxels along x, y, z, each from 1 to 2^31-1.
    std::array<std::int64_t, 3> size{};
    /// 1 (luminance or intensity), 2 (luminance alpha) or 4 (RGBA).
    int channels = 1;
    ChannelType type = ChannelType::uint8;

    int bytesPerVoxel() const { return channels * bytesPerChannel(type); }
    friend bool operator==(const VolumeInfo&, const VolumeInfo&) = default;
};

/// Where the axes of a volume point in the patient. Three directions make its frame: x to the patient's
/// right, y to the front (anterior), z up (superior).
struct PatientFrame
{
    /// False where the file does not say; then the voxels keep the order of the file.
    bool known = false;
    /// Where the x, y and z axes of the file point: R or L, A or P, S or I each, as in "LPS". A volume whose
    /// orientation is known arrives as "RAS" whatever the file has: axes are exchanged and turned round, no
    /// voxel changes its value.
    std::string fileAxes;
    /// Unit vectors along x, y and z of the volume as it arrives, in the patient's frame: near the identity,
    /// exactly that for a volume that is not oblique.
    std::array<std::array<double, 3>, 3> direction{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    /// Angle of the rotation that is left between the volume's axes and the patient's.
    double obliqueDegrees = 0;
};

/// What a file says about its voxels beside their shape.
struct VolumeDescription
{
    /// "TIFF", "NIfTI-1", "DICOM" ...
    std::string format;
    /// Distance of voxels along x, y and z, in mm, above 0; 1 where the file does not say.
    std::array<double, 3> spacing{1, 1, 1};
    bool spacingKnown = false;
    PatientFrame orientation;
    /// What a value v of the file stands for: slope * v + intercept. Voxels arrive without it.
    double slope = 1;
    double intercept = 0;
    /// The file has three channels: alpha is full everywhere, and none of the file's.
    bool alphaAdded = false;
    /// What a user should know, one line each without the file's name: numbers that were converted, parts of
    /// the file that are left out.
    std::vector<std::string> notes;
};

/// Bytes of `voxels` voxels per axis; a failure if a size lies outside 1..2^31-1 or the product reaches 2^63.
Result<std::int64_t> volumeBytes(const std::array<std::int64_t, 3>& voxels, int bytesPerVoxel);

/// Sizes for messages: "64 x 32 x 16".
std::string sizeText(const std::array<std::int64_t, 3>& size);

/// A box of voxels, in voxels of the volume. The origin may be negative and the box may leave the volume.
struct Region
{
    std::array<std::int64_t, 3> origin{};
    std::array<std::int64_t, 3> size{};
};

/// What reading has cost since the file was opened.
struct ReadCounters
{
    /// Slices of which anything was read, counted once for each brick.
    std::int64_t slices = 0;
    /// Rows decoded or read, whether or not the brick needed them: compressed files are decoded in whole
    /// strips or tiles, all others are read row by row.
    std::int64_t rows = 0;
    /// Bytes of voxels read from the file, before decoding.
    std::int64_t bytes = 0;
};

class VolumeReader;

/// An open volume. Stays open until destroyed. One thread at a time may use it.
class VolumeFile
{
public:
    explicit VolumeFile(std::unique_ptr<VolumeReader> reader);
    VolumeFile(VolumeFile&&) noexcept;
    VolumeFile& operator=(VolumeFile&&) noexcept;
    ~VolumeFile();

    const VolumeInfo& info() const;
    const VolumeDescription& description() const;

    /// Reads the voxels of `region` into `out`, x fastest, zero outside the volume. `out` has exactly
    /// size x * size y * size z * bytesPerVoxel() bytes. Slices and rows that the region does not need are
    /// not touched (whole strips or tiles where the file is compressed). After a failure `out` holds no
    /// useful values. Large regions are read in several threads.
    Result<void> readBrick(const Region& region, std::span<std::byte> out);

    const ReadCounters& counters() const;

private:
    std::unique_ptr<VolumeReader> reader_;
    std::vector<std::unique_ptr<VolumeReader>> others_; // of other threads
    ReadCounters counters_;
};

/// Opens a volume: a file of one of these formats, known by its content, or a folder with a DICOM series.
/// docs/formats.md tells what of each is read.
///  - TIFF, classic or BigTIFF: a stack of pages (page k is slice z = k, the first row of a page is y = 0,
///    whatever its orientation tag says; reduced copies and masks are passed over) or SGI's 3D TIFF (one
///    directory with ImageDepth above 1).
///  - NRRD, NIfTI-1 and -2 (also compressed, also as .hdr and .img), MetaImage, DICOM, PNG and JPEG (one
///  slice).
/// Volumes that say how they lie in the patient arrive with x to the right, y to the front and z up; all
/// others, TIFF, PNG and JPEG among them, in the order of the file. Numbers of types that ChannelType lacks
/// become float32, with a note. Three channels arrive as RGBA with full alpha (the largest value of the type,
/// 1 for float), and the description says so. Files that can only be decoded whole are decoded here and kept
/// in memory. Everything is checked on opening, so that a file that has lost pages or bytes fails here and
/// says what is missing.
Result<VolumeFile> openVolume(const std::string& path);

enum class ByteOrder { littleEndian, bigEndian };

/// The order of the machine this runs on.
ByteOrder nativeByteOrder();

/// Layout of voxels without a format of their own. Here `info` may have three channels; they arrive as RGBA
/// with full alpha.
struct RawLayout
{
    VolumeInfo info;
    /// Bytes to pass over at the start of each file.
    std::int64_t headerLength = 0;
    ByteOrder byteOrder = nativeByteOrder();
};

/// The type that the command lines of programs for raw files call char, uchar or ubyte, short, ushort or
/// float; a failure for any other name, in which `what` names the argument.
Result<ChannelType> rawChannelType(const std::string& what, const std::string& name);

/// Opens a volume that lies in one file, slice after slice. The file may be longer than the volume, of which
/// a note tells, not shorter.
Result<VolumeFile> openRawVolume(const std::string& path, const RawLayout& layout);

/// Opens a volume whose slice z lies in paths[z], each after a header of its own. There are as many paths as
/// slices.
Result<VolumeFile> openRawSlices(const std::vector<std::string>& paths, const RawLayout& layout);

enum class Compression { none, deflate };
enum class TiffKind { automatic, classic, big };

struct TiffOptions
{
    Compression compression = Compression::none;
    /// automatic: BigTIFF when the voxels and the directories could reach 4 GiB without compression.
    TiffKind kind = TiffKind::automatic;
};

/// Writes a page-stack TIFF row by row: under a temporary name in the same folder, renamed by finish().
/// Destroyed before that, it leaves nothing behind, and a file that stood at `path` stays as it was.
class TiffStackWriter
{
public:
    /// Fails for sizes that no TIFF can hold, for more bytes than the disk has free, and where the file
    /// cannot be made.
    static Result<TiffStackWriter> create(const std::string& path, const VolumeInfo& info,
                                          const TiffOptions& options = {});
    TiffStackWriter(TiffStackWriter&&) noexcept;
    TiffStackWriter& operator=(TiffStackWriter&&) noexcept;
    ~TiffStackWriter();

    /// Appends whole rows: y fastest, then z. `rows` is a multiple of one row's bytes.
    Result<void> appendRows(std::span<const std::byte> rows);

    /// Completes the file; a failure if rows are missing.
    Result<void> finish();

private:
    struct State;
    explicit TiffStackWriter(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// Writes a whole volume, as TiffStackWriter does. `voxels` has exactly the bytes of `info`.
Result<void> writeTiffStack(const std::string& path, const VolumeInfo& info,
                            std::span<const std::byte> voxels, const TiffOptions& options = {});

/// Writes a file of these bytes, beside and then renamed.
Result<void> writeBytes(const std::string& path, std::span<const std::byte> bytes);

/// Whether the first row of a picture in memory is its top or, as OpenGL delivers it, its bottom.
enum class RowOrder { topFirst, bottomFirst };

/// A picture: rows top first, 3 (RGB) or 4 (RGBA, not premultiplied) bytes per pixel, no padding.
struct Picture
{
    int width = 0;
    int height = 0;
    int channels = 3;
    std::vector<std::uint8_t> bytes;
};

/// Writes a PNG, beside and then renamed. `bytes` holds width * height * channels bytes (channels 3 or 4, as
/// in Picture), the first row as `order` says. The bytes are stored as they are, marked as sRGB. Before each
/// row it is asked whether it `givesUp`: then that is its failure, and no file is there.
Result<void> writePng(const std::string& path, int width, int height, int channels,
                      std::span<const std::uint8_t> bytes, RowOrder order = RowOrder::topFirst,
                      bool (*givesUp)() = nullptr);

/// Writes one value of 16 bits a pixel as a grey PNG, in the same way; the values are stored as they are,
/// without a claim to be sRGB.
Result<void> writeGreyPng(const std::string& path, int width, int height,
                          std::span<const std::uint16_t> values, RowOrder order = RowOrder::topFirst);

/// Reads a PNG; grey, palette and 16-bit pictures arrive as 8-bit RGB or RGBA.
Result<Picture> readPng(const std::string& path);

} // namespace vo
