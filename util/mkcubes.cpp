// mkcubes x y z cubeSize [file.tif]: writes a test volume of cubes (guide, pages 148 and 159).

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "utility.h"
#include "volume_io/memory_block.h"
#include "volume_io/volume_io.h"

namespace {

constexpr const char* kHelp =
    R"(mkcubes x y z cubeSize [file.tif]

Writes a test volume of x by y by z voxels, one byte each, filled with cubes of
cubeSize voxels a side that touch each other. Intensity falls linearly from 255
at a cube's centre to 0 on its surface. The file is a TIFF with one page for
each slice; without a name it is out.tif.

  -help      print this text
  -version   print the version

Example: 8 cubes of 128 voxels a side
    mkcubes 256 256 256 128 cubes.tif
)";

struct Request
{
    std::array<std::int64_t, 3> size{};
    std::int64_t cubeSize = 0;
    std::string path = "out.tif";
};

vo::Result<Request> parsedRequest(const std::vector<std::string>& arguments)
{
    if (arguments.size() < 4 || arguments.size() > 5)
        return vo::Failure{"expected x y z cubeSize [file.tif], found " + std::to_string(arguments.size()) +
                           " arguments; mkcubes -help shows an example"};
    Request request;
    const std::array names{"x", "y", "z", "cubeSize"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto value = vo::parsedWhole(names[i], arguments[i], 1);
        if (!value) return value.failure();
        (i < 3 ? request.size[i] : request.cubeSize) = *value;
    }
    if (arguments.size() == 5) request.path = arguments[4];
    return request;
}

/// Intensity that the position along one axis allows: 255 (1 - |2 t - 1|) rounded half up, where t in (0,1)
/// is the voxel's centre within its cube. A voxel's intensity is the least of its three, so that it depends
/// on the distance to the cube's centre along the axis where that is largest.
std::uint8_t intensityAlongAxis(std::int64_t position, std::int64_t cubeSize)
{
    const std::int64_t fromCentre = std::abs(2 * (position % cubeSize) + 1 - cubeSize); // in half voxels
    return static_cast<std::uint8_t>((2 * 255 * (cubeSize - fromCentre) + cubeSize) / (2 * cubeSize));
}

vo::Result<void> writeCubes(const Request& request)
{
    auto writer = vo::TiffStackWriter::create(request.path, {request.size, 1, vo::ChannelType::uint8});
    if (!writer) return writer.failure();
    const auto block = vo::MemoryBlock::allocate(request.path, 2 * request.size[0]);
    if (!block) return block.failure();
    const auto length = static_cast<std::size_t>(request.size[0]);
    const auto alongX = block->bytes().first(length), row = block->bytes().last(length);
    for (std::size_t x = 0; x < length; ++x)
        alongX[x] = std::byte(intensityAlongAxis(static_cast<std::int64_t>(x), request.cubeSize));

    for (std::int64_t z = 0; z < request.size[2]; ++z) {
        for (std::int64_t y = 0; y < request.size[1]; ++y) {
            if (vo::interrupted()) return vo::Failure{request.path + ": interrupted, nothing written"};
            const std::byte most{
                std::min(intensityAlongAxis(y, request.cubeSize), intensityAlongAxis(z, request.cubeSize))};
            std::ranges::transform(alongX, row.begin(),
                                   [most](std::byte along) { return std::min(along, most); });
            if (auto written = writer->appendRows(row); !written) return written;
        }
        vo::showProgress("mkcubes", "slice", z + 1, request.size[2]);
    }
    return writer->finish();
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    const auto request = parsedRequest(arguments);
    return request ? writeCubes(*request) : request.failure();
}

} // namespace

int main(int argc, char** argv)
{
    return vo::runUtility({"mkcubes", kHelp, run}, argc, argv);
}
