#include "vector_file.h"

#include "volume_io/volume_io.h"

#include <cstring>

namespace {

// 16 GiB of vectors.
constexpr double kMostVectors = 1.4e9;

float partAt(const std::byte* bytes, vo::ChannelType type)
{
    const auto as = [bytes](auto number) {
        std::memcpy(&number, bytes, sizeof number);
        return float(number);
    };
    switch (type) {
    case vo::ChannelType::uint8: return as(std::uint8_t{});
    case vo::ChannelType::int8: return as(std::int8_t{});
    case vo::ChannelType::uint16: return as(std::uint16_t{});
    case vo::ChannelType::int16: return as(std::int16_t{});
    case vo::ChannelType::float32: return as(float{});
    }
    return 0;
}

} // namespace

vo::Result<VectorGrid> readVectors(const std::string& fileName)
{
    auto file = vo::openVolume(fileName);
    if (!file) return file.failure();
    const vo::VolumeInfo info = file->info();
    // Three channels arrive with a fourth.
    if (info.channels != 4)
        return vo::Failure{fileName + ": expected vectors of 3 parts, found " +
                           std::to_string(info.channels)};
    const double count = double(info.size[0]) * double(info.size[1]) * double(info.size[2]);
    if (count > kMostVectors) return vo::Failure{fileName + ": expected fewer vectors"};

    std::vector<std::byte> bytes(std::size_t(count) * std::size_t(info.bytesPerVoxel()));
    if (const auto read = file->readBrick({{0, 0, 0}, info.size}, bytes); !read) return read.failure();
    VectorGrid grid;
    for (std::size_t axis = 0; axis < 3; axis++)
        grid.size[axis] = int(info.size[axis]);
    const std::size_t step = std::size_t(vo::bytesPerChannel(info.type));
    for (std::size_t at = 0; at < bytes.size(); at += 4 * step)
        for (std::size_t part = 0; part < 3; part++)
            grid.parts.push_back(partAt(bytes.data() + at + part * step, info.type));
    return grid;
}
