#include "volume_reader.h"

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <png.h>

#include "decoded_picture.h"
#include "input_file.h"

namespace vo {
namespace {

// Deflate shrinks by at most 1032, and one bit of grey becomes a byte, or three by a palette.
constexpr std::int64_t kMostBytesPerFileByte = 1032 * 8 * 4;

/// libpng's reader with what it says kept instead of printed. An error jumps back to the place that called
/// setjmp(jump): no object with a destructor may be made in between.
struct PngReader
{
    explicit PngReader(const std::string& path) : file(std::fopen(path.c_str(), "rb"))
    {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
        if (png) info = png_create_info_struct(png);
    }
    ~PngReader()
    {
        png_destroy_read_struct(&png, &info, nullptr);
        if (file) std::fclose(file);
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;

    [[noreturn]] static void fail(png_structp png, png_const_charp text)
    {
        auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
        std::snprintf(reader.message, sizeof reader.message, "%s", text);
        std::longjmp(reader.jump, 1);
    }
    static void ignore(png_structp, png_const_charp) {}

    bool readHeader();
    bool readRows(std::byte* voxels, std::int64_t rowBytes);

    std::FILE* file = nullptr;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::jmp_buf jump;
    char message[256] = "not a regular PNG file";
    std::vector<png_bytep> rows;
};

/// Asks for channels of whole bytes, values as they are stored.
bool PngReader::readHeader()
{
    if (!file || !info) return false;
    if (setjmp(jump)) return false;
    png_init_io(png, file);
    png_read_info(png, info);
    png_set_expand(png);
    if (nativeByteOrder() == ByteOrder::littleEndian) png_set_swap(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool PngReader::readRows(std::byte* voxels, std::int64_t rowBytes)
{
    rows.resize(png_get_image_height(png, info));
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i] = reinterpret_cast<png_bytep>(voxels) + static_cast<std::int64_t>(i) * rowBytes;
    if (setjmp(jump)) return false;
    png_read_image(png, rows.data());
    png_read_end(png, nullptr);
    return true;
}

} // namespace

Result<VolumeFile> openPngVolume(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    PngReader reader(path);
    if (!reader.readHeader()) return Failure{path + ": expected a PNG picture: " + reader.message};
    StoredLayout layout;
    layout.size = {png_get_image_width(reader.png, reader.info),
                   png_get_image_height(reader.png, reader.info), 1};
    layout.channels = png_get_channels(reader.png, reader.info);
    layout.type = png_get_bit_depth(reader.png, reader.info) == 16 ? StoredType::uint16 : StoredType::uint8;
    return openPicture(path, "PNG", layout, kMostBytesPerFileByte, [&](std::byte* pixels) {
        return reader.readRows(pixels, layout.size[0] * layout.pixelBytes()) ? nullptr : reader.message;
    });
}

} // namespace vo
