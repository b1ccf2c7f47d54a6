#include "volume_io.h"

#include <array>
#include <bit>
#include <cerrno>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <png.h>
#include <zlib.h>

#include "file_beside.h"

namespace vo {
namespace {

// Deflate shrinks by at most 1032, and one bit of grey becomes 32 of RGBA: a header that promises more is a
// lie.
constexpr std::uint64_t kMostBytesPerFileByte = 1032 * 32;

/// libpng's control block, freed with the scope.
struct PngImage
{
    PngImage()
    {
        std::memset(&image, 0, sizeof image);
        image.version = PNG_IMAGE_VERSION;
    }
    ~PngImage() { png_image_free(&image); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image image;
};

/// What a picture to be written is made of.
struct PictureShape
{
    int width = 0;
    int height = 0;
    int channels = 3; // 3 (RGB) or 4 (RGBA); of 2 bytes each: 1 (grey)
    int bytesPerChannel = 1;

    std::ptrdiff_t rowBytes() const { return std::ptrdiff_t(width) * channels * bytesPerChannel; }
};

Result<void> checkPicture(const std::string& path, const PictureShape& shape, std::size_t bytes)
{
    const auto text = std::to_string(shape.width) + " x " + std::to_string(shape.height) + " with " +
                      std::to_string(shape.channels) + " channels";
    const bool known =
        shape.bytesPerChannel == 2 ? shape.channels == 1 : shape.channels == 3 || shape.channels == 4;
    if (shape.width < 1 || shape.height < 1 || !known || shape.width > 0x7fffffff / 8)
        return Failure{path + ": expected a picture of at least 1 x 1 pixel with 3 or 4 channels, found " +
                       text};
    const std::uint64_t expected = std::uint64_t(shape.rowBytes()) * std::uint64_t(shape.height);
    if (bytes != expected)
        return Failure{path + ": expected " + std::to_string(expected) + " bytes for a picture of " + text +
                       ", found " + std::to_string(bytes)};
    return {};
}

/// Where libpng goes when it cannot go on, and why.
struct Escape
{
    std::jmp_buf place;
    std::array<char, 120> reason;
};

[[noreturn]] void escape(png_structp png, png_const_charp reason)
{
    auto& way = *static_cast<Escape*>(png_get_error_ptr(png));
    std::snprintf(way.reason.data(), way.reason.size(), "%s", reason);
    std::longjmp(way.place, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

/// Differences to the row above, runs of equal ones joined: a fifth of the time of libpng's own choice, and
/// for rendered pictures nearly its size.
void compressFast(png_structp png)
{
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, Z_RLE);
}

/// Nothing in here has a destructor, since libpng leaves it by a jump.
bool writeRows(std::FILE* file, const PictureShape& shape, const std::uint8_t* topRow, std::ptrdiff_t step,
               bool (*givesUp)(), Escape& way)
{
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &way, escape, ignoreWarning);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    way.reason = {"out of memory"};
    if (!info || setjmp(way.place) != 0) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, file);
    png_set_user_limits(png, 0x7fffffff, 0x7fffffff);
    const int color = shape.channels == 1   ? PNG_COLOR_TYPE_GRAY
                      : shape.channels == 3 ? PNG_COLOR_TYPE_RGB
                                            : PNG_COLOR_TYPE_RGB_ALPHA;
    png_set_IHDR(png, info, static_cast<png_uint_32>(shape.width), static_cast<png_uint_32>(shape.height),
                 8 * shape.bytesPerChannel, color, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    if (shape.bytesPerChannel == 1) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    compressFast(png);
    png_write_info(png, info);
    if (shape.bytesPerChannel == 2 && std::endian::native == std::endian::little) png_set_swap(png);
    for (int row = 0; row < shape.height; ++row) {
        if (givesUp && givesUp()) png_error(png, "interrupted");
        png_write_row(png, topRow + row * step);
    }
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

Result<void> writePicture(const std::string& path, const PictureShape& shape, const std::uint8_t* bytes,
                          RowOrder order, bool (*givesUp)() = nullptr)
{
    auto beside = FileBeside::create(path);
    if (!beside) return beside.failure();
    std::FILE* file = std::fopen(beside->temporaryPath().c_str(), "wb");
    if (!file) return Failure{path + ": cannot write: " + std::strerror(errno)};
    const bool topFirst = order == RowOrder::topFirst;
    const std::uint8_t* top = topFirst ? bytes : bytes + (shape.height - 1) * shape.rowBytes();
    Escape way{};
    const bool written =
        writeRows(file, shape, top, topFirst ? shape.rowBytes() : -shape.rowBytes(), givesUp, way);
    const bool closed = std::fclose(file) == 0;
    if (!written) return Failure{path + ": cannot write the picture: " + way.reason.data()};
    if (!closed) return Failure{path + ": cannot write the picture: " + std::strerror(errno)};
    return beside->commit();
}

} // namespace

Result<void> writePng(const std::string& path, int width, int height, int channels,
                      std::span<const std::uint8_t> bytes, RowOrder order, bool (*givesUp)())
{
    const PictureShape shape{width, height, channels, 1};
    if (auto checked = checkPicture(path, shape, bytes.size()); !checked) return checked;
    return writePicture(path, shape, bytes.data(), order, givesUp);
}

Result<void> writeGreyPng(const std::string& path, int width, int height,
                          std::span<const std::uint16_t> values, RowOrder order)
{
    const PictureShape shape{width, height, 1, 2};
    const auto bytes = std::as_bytes(values);
    if (auto checked = checkPicture(path, shape, bytes.size()); !checked) return checked;
    return writePicture(path, shape, reinterpret_cast<const std::uint8_t*>(bytes.data()), order);
}

Result<Picture> readPng(const std::string& path)
{
    PngImage png;
    if (!png_image_begin_read_from_file(&png.image, path.c_str()))
        return Failure{path + ": expected a PNG picture: " + png.image.message};

    Picture picture;
    picture.channels = (png.image.format & PNG_FORMAT_FLAG_ALPHA) ? 4 : 3;
    png.image.format = picture.channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    picture.width = static_cast<int>(png.image.width);
    picture.height = static_cast<int>(png.image.height);
    const std::uint64_t rowBytes = std::uint64_t(png.image.width) * std::uint64_t(picture.channels);
    std::error_code error;
    const std::uint64_t fileBytes = std::filesystem::file_size(path, error);
    if (error || rowBytes > 0x7fffffff || rowBytes * png.image.height > fileBytes * kMostBytesPerFileByte)
        return Failure{path + ": expected a PNG picture, found a header of " +
                       std::to_string(png.image.width) + " x " + std::to_string(png.image.height) +
                       " pixels in " + std::to_string(fileBytes) + " bytes"};
    picture.bytes.resize(rowBytes * png.image.height);
    if (!png_image_finish_read(&png.image, nullptr, picture.bytes.data(), 0, nullptr))
        return Failure{path + ": cannot read the picture: " + png.image.message};
    return picture;
}

} // namespace vo
