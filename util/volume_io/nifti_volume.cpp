#include "volume_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <nifti/nifti2_io.h>
#include <optional>

#include "byte_order.h"
#include "deflate_stream.h"
#include "stored_voxels.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// The header in numbers of this machine, checked as far as libnifti needs it.
struct NiftiHeader
{
    std::string path;
    int version = 1;
    bool voxelsApart = false; // in a file of their own (.img)
    bool swapped = false;
    std::int64_t firstByte = 0; // of the voxels
    nifti_1_header one{};
    nifti_2_header two{};
};

struct FreeImage
{
    void operator()(nifti_image* image) const { nifti_image_free(image); }
};
using NiftiImage = std::unique_ptr<nifti_image, FreeImage>;

/// The first bytes of a file, decompressed if need be; as many as there are.
Result<std::vector<std::byte>> firstBytes(const std::string& path, std::size_t count)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    std::vector<std::byte> bytes(
        static_cast<std::size_t>(std::min<std::int64_t>(file->size(), std::int64_t(count))));
    if (auto read = file->readAt(0, bytes); !read) return read.failure();
    if (!beginsLikeGzip(bytes)) return bytes;
    bytes.resize(count);
    DeflateStream stream(*file, 0);
    const auto found = stream.readSome(bytes);
    if (!found) return found.failure();
    bytes.resize(static_cast<std::size_t>(*found));
    return bytes;
}

/// The other file of a pair, compressed or not: `from` and `to` are endings such as ".img".
std::string pairedFile(const std::string& path, const std::string& from, const std::string& to)
{
    std::string base = path;
    if (base.ends_with(".gz")) base.erase(base.size() - 3);
    std::string lower = base;
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    if (!lower.ends_with(from)) return "";
    base.erase(base.size() - from.size());
    std::string upper = to;
    std::ranges::transform(upper, upper.begin(), [](unsigned char c) { return char(std::toupper(c)); });
    for (const std::string& ending : {to, to + ".gz", upper}) {
        std::error_code error;
        if (fs::exists(base + ending, error)) return base + ending;
    }
    return base + to;
}

template <class Header>
void copyHeader(const std::vector<std::byte>& bytes, Header& header)
{
    std::memcpy(&header, bytes.data(), sizeof header);
}

Result<NiftiHeader> readHeader(const std::string& path)
{
    const auto bytes = firstBytes(path, sizeof(nifti_2_header));
    if (!bytes) return bytes.failure();
    NiftiHeader header;
    header.path = path;
    const std::size_t length = bytes->size();
    std::int32_t size = 0;
    if (length >= sizeof size) std::memcpy(&size, bytes->data(), sizeof size);
    header.swapped = size != 348 && size != 540;
    if (header.swapped) swapBytes(std::as_writable_bytes(std::span(&size, 1)), sizeof size);
    header.version = size == 540 ? 2 : 1;
    if ((size != 348 && size != 540) || length < static_cast<std::size_t>(size))
        return Failure{path + ": expected a NIfTI header of 348 or 540 bytes, found " +
                       (length < sizeof size ? std::to_string(length) + " bytes"
                                             : "the length " + std::to_string(size) + " and " +
                                                   std::to_string(length) + " bytes")};
    const char* magic = nullptr;
    double first = 0;
    if (header.version == 1) {
        copyHeader(*bytes, header.one);
        if (header.swapped) nifti_swap_as_nifti1(&header.one);
        magic = header.one.magic;
        first = double(header.one.vox_offset);
    } else {
        copyHeader(*bytes, header.two);
        if (header.swapped) nifti_swap_as_nifti2(&header.two);
        magic = header.two.magic;
        first = double(header.two.vox_offset);
    }
    const std::string kind(magic, strnlen(magic, 4));
    const std::string number = std::to_string(header.version);
    if (kind != "n+" + number && kind != "ni" + number)
        return Failure{path + ": expected \"n+" + number + "\" or \"ni" + number +
                       "\" in a NIfTI header, found " +
                       (kind.empty() ? "none (Analyze 7.5?)" : "another word")};
    header.voxelsApart = kind[1] == 'i';
    if (!(first >= 0 && first < 9e15))
        return Failure{path + ": expected voxels at byte 0 or later, found byte " + std::to_string(first)};
    header.firstByte = static_cast<std::int64_t>(first);
    // Zero where a program left it out.
    if (!header.voxelsApart) header.firstByte = std::max<std::int64_t>(header.firstByte, size);
    return header;
}

struct NiftiType
{
    int code;
    StoredType type;
    int channels;
};

constexpr NiftiType kTypes[] = {
    {DT_UINT8, StoredType::uint8, 1},     {DT_INT8, StoredType::int8, 1},
    {DT_UINT16, StoredType::uint16, 1},   {DT_INT16, StoredType::int16, 1},
    {DT_UINT32, StoredType::uint32, 1},   {DT_INT32, StoredType::int32, 1},
    {DT_UINT64, StoredType::uint64, 1},   {DT_INT64, StoredType::int64, 1},
    {DT_FLOAT32, StoredType::float32, 1}, {DT_FLOAT64, StoredType::float64, 1},
    {DT_RGB24, StoredType::uint8, 3},     {DT_RGBA32, StoredType::uint8, 4},
};

/// Checks what libnifti would complain about on standard error.
template <class Header>
Result<void> checkForLibrary(const std::string& path, const Header& header)
{
    const std::int64_t count = header.dim[0];
    if (count < 1 || count > 7)
        return Failure{path + ": expected 1 to 7 dimensions, found " + std::to_string(count)};
    for (std::int64_t i = 1; i <= count; ++i)
        if (header.dim[i] < 1 || header.dim[i] > 0x7fffffff)
            return Failure{path + ": expected sizes from 1 to 2147483647, found " +
                           std::to_string(header.dim[i]) + " in dimension " + std::to_string(i)};
    if (std::ranges::find(kTypes, int(header.datatype), &NiftiType::code) == std::end(kTypes))
        return Failure{path +
                       ": expected integers, 32- or 64-bit floats, RGB or RGBA, found NIfTI data type " +
                       std::to_string(header.datatype)};
    return {};
}

/// libnifti's view of the header: dimensions, type and transformations.
Result<NiftiImage> imageOf(NiftiHeader& header)
{
    const auto checked = header.version == 1 ? checkForLibrary(header.path, header.one)
                                             : checkForLibrary(header.path, header.two);
    if (!checked) return checked.failure();
    nifti_set_debug_level(0);
    NiftiImage image(header.version == 1 ? nifti_convert_n1hdr2nim(header.one, nullptr)
                                         : nifti_convert_n2hdr2nim(header.two, nullptr));
    if (!image) return Failure{header.path + ": expected a NIfTI header, found one that libnifti refuses"};
    return image;
}

/// Whether several values of a voxel, volume after volume, are one vector or colour.
bool isVector(int intent)
{
    return intent == NIFTI_INTENT_VECTOR || intent == NIFTI_INTENT_RGB_VECTOR ||
           intent == NIFTI_INTENT_RGBA_VECTOR;
}

StoredLayout layoutOf(const NiftiHeader& header, const nifti_image& image, VolumeDescription& about)
{
    const auto type = std::ranges::find(kTypes, image.datatype, &NiftiType::code);
    StoredLayout layout;
    layout.size = {image.nx, image.ny, image.nz};
    layout.type = type->type;
    layout.channels = type->channels;
    layout.byteOrder = header.swapped == (nativeByteOrder() == ByteOrder::bigEndian) ? ByteOrder::littleEndian
                                                                                     : ByteOrder::bigEndian;
    // A vector's parts lie in the fifth dimension, or, as many programs write them, in the fourth.
    std::int64_t volumes = 1;
    for (const std::int64_t size : {image.nt, image.nu, image.nv, image.nw})
        if (__builtin_mul_overflow(volumes, size, &volumes)) volumes = INT64_MAX;
    const bool inFifth = image.nt == 1 && image.nu > 1 && volumes == image.nu;
    const bool inFourth = image.nt > 1 && volumes == image.nt && isVector(image.intent_code);
    if (type->channels == 1 && (inFifth || inFourth) && volumes <= 4) {
        layout.channels = static_cast<int>(volumes);
        layout.planar = true;
    } else if (volumes > 1) {
        about.notes.push_back("the first of " + std::to_string(volumes) + " volumes is read");
    }
    return layout;
}

std::optional<Placement> placementOf(const nifti_dmat44& matrix, double millimetres)
{
    std::array<Vector3, 3> steps{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t i = 0; i < 3; ++i)
            steps[axis][i] = matrix.m[i][axis] * millimetres;
    return placementOfSteps(steps);
}

/// Notes distances that are none in the file's header: libnifti takes 1 for them.
template <class Header>
void noteDistances(const Header& header, VolumeDescription& about)
{
    for (int axis = 1; axis <= std::min<int>(int(header.dim[0]), 3); ++axis) {
        const double distance = double(header.pixdim[axis]);
        if (header.dim[axis] == 1 || (std::isfinite(distance) && distance != 0)) continue;
        char found[64];
        std::snprintf(found, sizeof found, "%g", distance);
        about.notes.push_back("expected a distance of voxels above 0 in pixdim[" + std::to_string(axis) +
                              "], found " + found + "; 1 is used");
    }
}

Placement placementOf(const NiftiHeader& header, const nifti_image& image, VolumeDescription& about)
{
    const double millimetres = image.xyz_units == NIFTI_UNITS_METER    ? 1e3
                               : image.xyz_units == NIFTI_UNITS_MICRON ? 1e-3
                                                                       : 1;
    if (image.sform_code > 0) {
        if (const auto found = placementOf(image.sto_xyz, millimetres)) return *found;
        about.notes.emplace_back("the sform is no transformation of space and is not used");
    }
    header.version == 1 ? noteDistances(header.one, about) : noteDistances(header.two, about);
    if (image.qform_code > 0) {
        if (const auto found = placementOf(image.qto_xyz, millimetres)) return *found;
        about.notes.emplace_back("the qform is no transformation of space and is not used");
    }
    return fileOrder({std::abs(image.dx) * millimetres, std::abs(image.dy) * millimetres,
                      std::abs(image.dz) * millimetres});
}

Result<std::unique_ptr<StoredBytes>> bytesOf(const std::string& path, std::int64_t offset, std::int64_t bytes)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    std::array<std::byte, 3> magic{};
    if (file->size() >= 3)
        if (auto read = file->readAt(0, magic); !read) return read.failure();
    if (!beginsLikeGzip(magic)) return bytesInFiles({{path, offset}}, bytes);
    DeflateStream stream(*file, 0);
    if (auto skipped = stream.skip(offset); !skipped) return skipped.failure();
    auto block = stream.readBlock(bytes);
    if (!block) return block.failure();
    return bytesInMemory(std::move(*block));
}

} // namespace

Result<VolumeFile> openNiftiVolume(const std::string& path)
{
    // Of a pair, the .img file has no header.
    const std::string paired = pairedFile(path, ".img", ".hdr");
    auto header = readHeader(paired.empty() ? path : paired);
    if (!header) return header.failure();
    const auto image = imageOf(*header);
    if (!image) return image.failure();

    VolumeDescription about;
    about.format = "NIfTI-" + std::to_string(header->version);
    const StoredLayout layout = layoutOf(*header, **image, about);
    const auto bytes = storedBytes(header->path, layout);
    if (!bytes) return bytes.failure();
    const double slope = (*image)->scl_slope, intercept = (*image)->scl_inter;
    if (slope != 0 && std::isfinite(slope) && std::isfinite(intercept)) {
        about.slope = slope;
        about.intercept = intercept;
    }
    const Placement placement = placementOf(*header, **image, about);
    std::string voxels = header->path;
    if (header->voxelsApart) voxels = paired.empty() ? pairedFile(path, ".hdr", ".img") : path;
    if (voxels.empty())
        return Failure{path +
                       ": expected the ending .hdr or .hdr.gz of a NIfTI header whose voxels lie in an "
                       ".img file, found another"};
    auto source = bytesOf(voxels, header->firstByte, *bytes);
    if (!source) return source.failure();
    return openStoredVoxels(layout, placement, std::move(*source), std::move(about));
}

} // namespace vo
