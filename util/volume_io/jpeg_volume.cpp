#include "volume_reader.h"

#include <csetjmp>
#include <cstdio>

#include <jpeglib.h>

#include "decoded_picture.h"
#include "input_file.h"

namespace vo {
namespace {

// A block of 8 x 8 pixels, of one or more channels, takes at least a few bits of the file.
constexpr std::int64_t kMostBytesPerFileByte = 4096;

/// libjpeg's reader with what it says kept instead of printed. An error jumps back to the place that called
/// setjmp(jump): no object with a destructor may be made in between. What libjpeg makes up for missing or
/// damaged data, and warns of, is an error too.
struct JpegReader
{
    explicit JpegReader(const std::string& path) : file(std::fopen(path.c_str(), "rb"))
    {
        jpeg.err = jpeg_std_error(&errors);
        jpeg.client_data = this;
        errors.error_exit = fail;
        errors.emit_message = [](j_common_ptr any, int level) {
            if (level < 0) fail(any);
        };
    }
    ~JpegReader()
    {
        if (created) jpeg_destroy_decompress(&jpeg);
        if (file) std::fclose(file);
    }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    [[noreturn]] static void fail(j_common_ptr any)
    {
        auto& reader = *static_cast<JpegReader*>(any->client_data);
        any->err->format_message(any, reader.message);
        std::longjmp(reader.jump, 1);
    }

    bool readHeader();
    bool readRows(std::byte* voxels);

    std::FILE* file = nullptr;
    bool created = false;
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    std::jmp_buf jump;
    char message[JMSG_LENGTH_MAX] = "cannot be opened";
};

bool JpegReader::readHeader()
{
    if (!file) return false;
    if (setjmp(jump)) return false;
    jpeg_create_decompress(&jpeg);
    created = true;
    jpeg_stdio_src(&jpeg, file);
    jpeg_read_header(&jpeg, TRUE);
    jpeg.out_color_space = jpeg.num_components == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_calc_output_dimensions(&jpeg);
    return true;
}

bool JpegReader::readRows(std::byte* voxels)
{
    if (setjmp(jump)) return false;
    jpeg_start_decompress(&jpeg);
    const std::size_t rowBytes =
        std::size_t{jpeg.output_width} * static_cast<std::size_t>(jpeg.output_components);
    while (jpeg.output_scanline < jpeg.output_height) {
        JSAMPROW row = reinterpret_cast<JSAMPROW>(voxels) + jpeg.output_scanline * rowBytes;
        jpeg_read_scanlines(&jpeg, &row, 1);
    }
    jpeg_finish_decompress(&jpeg);
    return true;
}

} // namespace

Result<VolumeFile> openJpegVolume(const std::string& path)
{
    const auto file = InputFile::open(path);
    if (!file) return file.failure();
    JpegReader reader(path);
    if (!reader.readHeader()) return Failure{path + ": expected a JPEG picture: " + reader.message};
    StoredLayout layout;
    layout.size = {reader.jpeg.output_width, reader.jpeg.output_height, 1};
    layout.channels = reader.jpeg.output_components;
    return openPicture(path, "JPEG", layout, kMostBytesPerFileByte,
                       [&](std::byte* pixels) { return reader.readRows(pixels) ? nullptr : reader.message; });
}

} // namespace vo
