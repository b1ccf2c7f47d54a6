// iflfrombin hdrlen xsize ysize csize bpp infile outimage: a raw image becomes a TIFF file (guide, page 147).

#include "copy_slices.h"
#include "utility.h"

namespace {

constexpr const char* kHelp =
    R"(iflfrombin [-bigEndian | -littleEndian] hdrlen xsize ysize csize bpp infile outimage

Converts a raw image, rows of pixels after a header, to a two-dimensional TIFF
file.

  hdrlen    bytes of the header, which are passed over
  xsize     width in pixels
  ysize     height in pixels
  csize     channels of a pixel, side by side: 1 (intensity), 2 (luminance and
            alpha), 3 (RGB; alpha is added) or 4 (RGBA)
  bpp       type of a channel: char, uchar, ubyte, short, ushort or float
  infile    the raw image
  outimage  the TIFF file, by convention named .tif

  -bigEndian      the raw image has the highest byte first, as IRIX wrote it
  -littleEndian   the lowest byte comes first; without either, the order of
                  this machine
  -help           print this text
  -version        print the version

Example: a slice of 64 x 64 shorts without a header
    iflfrombin -littleEndian 0 64 64 1 short quarter.40 slice40.tif
)";

struct Request
{
    vo::RawLayout layout;
    std::string input, output;
};

vo::Result<Request> parsedRequest(std::vector<std::string> words)
{
    Request request;
    while (!words.empty() && words[0].starts_with('-')) {
        if (words[0] == "-bigEndian") {
            request.layout.byteOrder = vo::ByteOrder::bigEndian;
        } else if (words[0] == "-littleEndian") {
            request.layout.byteOrder = vo::ByteOrder::littleEndian;
        } else {
            break; // hdrlen's own check tells what is wrong
        }
        words.erase(words.begin());
    }
    if (words.size() != 7)
        return vo::Failure{"expected hdrlen xsize ysize csize bpp infile outimage, found " +
                           std::to_string(words.size()) + " arguments; iflfrombin -help shows an example"};
    const auto header = vo::parsedWhole("hdrlen", words[0], 0, INT64_MAX);
    if (!header) return header.failure();
    const auto width = vo::parsedWhole("xsize", words[1], 1);
    if (!width) return width.failure();
    const auto height = vo::parsedWhole("ysize", words[2], 1);
    if (!height) return height.failure();
    const auto channels = vo::parsedWhole("csize", words[3], 1, 4);
    if (!channels) return channels.failure();
    const auto type = vo::rawChannelType("bpp", words[4]);
    if (!type) return type.failure();
    request.layout.headerLength = *header;
    request.layout.info = {{*width, *height, 1}, static_cast<int>(*channels), *type};
    request.input = words[5];
    request.output = words[6];
    return request;
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    const auto request = parsedRequest(arguments);
    if (!request) return request.failure();
    if (auto fit = vo::checkOutput(request->output, {request->input}); !fit) return fit;
    auto image = vo::openRawVolume(request->input, request->layout);
    if (!image) return image.failure();
    auto writer = vo::TiffStackWriter::create(request->output, image->info());
    if (!writer) return writer.failure();
    if (auto done = vo::copySlices("iflfrombin", request->output, *image, *writer, 0, 1); !done) return done;
    return writer->finish();
}

} // namespace

int main(int argc, char** argv)
{
    return vo::runUtility({"iflfrombin", kHelp, run}, argc, argv);
}
