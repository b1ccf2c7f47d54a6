#include "volume_io.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <png.h>

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

Result<void> checkPicture(const std::string& path, int width, int height, int channels, std::size_t bytes)
{
    const auto shape = std::to_string(width) + " x " + std::to_string(height) + " with " +
                       std::to_string(channels) + " channels";
    // libpng's simplified interface takes the length of a row as a signed 32-bit number.
    if (width < 1 || height < 1 || (channels != 3 && channels != 4) || width > 0x7fffffff / channels)
        return Failure{path + ": expected a picture of at least 1 x 1 pixel with 3 or 4 channels, found " +
                       shape};
    const std::uint64_t expected = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(channels);
    if (bytes != expected)
        return Failure{path + ": expected " + std::to_string(expected) + " bytes for a picture of " + shape +
                       ", found " + std::to_string(bytes)};
    return {};
}

} // namespace

Result<void> writePng(const std::string& path, int width, int height, int channels,
                      std::span<const std::uint8_t> bytes, RowOrder order)
{
    if (auto checked = checkPicture(path, width, height, channels, bytes.size()); !checked) return checked;
    auto file = FileBeside::create(path);
    if (!file) return file.failure();

    PngImage png;
    png.image.width = static_cast<png_uint_32>(width);
    png.image.height = static_cast<png_uint_32>(height);
    png.image.format = channels == 4 ? PNG_FORMAT_RGBA : PNG_FORMAT_RGB;
    // A negative row length tells libpng that the first row in memory is the bottom one.
    const png_int_32 rowLength = order == RowOrder::topFirst ? width * channels : -width * channels;
    if (!png_image_write_to_file(&png.image, file->temporaryPath().c_str(), 0, bytes.data(), rowLength,
                                 nullptr))
        return Failure{path + ": cannot write the picture: " + png.image.message};
    return file->commit();
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
