#pragma once

#include <cstring>
#include <gtest/gtest.h>

#include "volume_io/volume_io.h"

namespace vo {

/// A volume whose every value follows from its place, so that whatever is read can be checked without a copy.
class VolumeTruth
{
public:
    explicit VolumeTruth(VolumeInfo info) : info_(info) {}

    const VolumeInfo& info() const { return info_; }

    /// Writes one channel of a voxel in this machine's byte order.
    void put(std::int64_t x, std::int64_t y, std::int64_t z, int channel, std::byte* out) const
    {
        const auto seed = static_cast<std::uint32_t>(((z * 131 + y) * 137 + x) * 5 + channel + 1);
        const std::uint32_t bits = (seed * 2654435761u) ^ (seed >> 3);
        if (info_.type == ChannelType::float32) {
            const float value = static_cast<float>(bits % 20001) / 100.0f - 100.0f;
            std::memcpy(out, &value, sizeof value);
        } else {
            const auto value = static_cast<std::uint16_t>(bits >> 9);
            std::memcpy(out, &value, static_cast<std::size_t>(bytesPerChannel(info_.type)));
        }
    }

    bool contains(std::int64_t x, std::int64_t y, std::int64_t z) const
    {
        return x >= 0 && y >= 0 && z >= 0 && x < info_.size[0] && y < info_.size[1] && z < info_.size[2];
    }

    /// What reading the region must give.
    std::vector<std::byte> brick(const Region& region) const
    {
        const int step = bytesPerChannel(info_.type);
        std::vector<std::byte> bytes(static_cast<std::size_t>(region.size[0] * region.size[1] *
                                                              region.size[2] * info_.bytesPerVoxel()));
        std::byte* out = bytes.data();
        for (std::int64_t z = 0; z < region.size[2]; ++z)
            for (std::int64_t y = 0; y < region.size[1]; ++y)
                for (std::int64_t x = 0; x < region.size[0]; ++x)
                    for (int channel = 0; channel < info_.channels; ++channel, out += step)
                        if (contains(x + region.origin[0], y + region.origin[1], z + region.origin[2]))
                            put(x + region.origin[0], y + region.origin[1], z + region.origin[2], channel,
                                out);
        return bytes;
    }

    std::vector<std::byte> whole() const { return brick({{0, 0, 0}, info_.size}); }

private:
    VolumeInfo info_;
};

inline std::vector<std::byte> readBrick(VolumeFile& volume, const Region& region)
{
    std::vector<std::byte> bytes(static_cast<std::size_t>(region.size[0] * region.size[1] * region.size[2] *
                                                          volume.info().bytesPerVoxel()),
                                 std::byte{0xcd});
    const auto read = volume.readBrick(region, bytes);
    EXPECT_TRUE(read) << read.failure().text;
    return bytes;
}

/// Reads the whole volume and bricks inside, across each kind of edge and outside.
inline void expectReadsAs(VolumeFile& volume, const VolumeTruth& truth)
{
    ASSERT_EQ(volume.info(), truth.info());
    const auto [x, y, z] = truth.info().size;
    const Region regions[] = {
        {{0, 0, 0}, {x, y, z}},
        {{0, 0, z / 2}, {x, y, 1}},
        {{x / 2, 0, 0}, {1, y, z}},
        {{0, y / 3, 0}, {x, (y + 2) / 3, z}},
        {{x / 3, y / 3, z / 3}, {(x + 2) / 3, (y + 2) / 3, (z + 2) / 3}},
        {{-1, -2, -1}, {x + 3, y + 3, z + 2}},
        {{x - 1, y - 1, z - 1}, {3, 3, 3}},
        {{-3, y / 2, z / 2}, {5, 1, 1}},
        {{x, 0, 0}, {2, 2, 2}},
        {{0, -5, 0}, {2, 5, 2}},
        {{INT64_MIN, 0, INT64_MAX}, {1, 2, 1}},
    };
    for (const Region& region : regions)
        EXPECT_TRUE(readBrick(volume, region) == truth.brick(region))
            << "origin " << region.origin[0] << " " << region.origin[1] << " " << region.origin[2]
            << ", size " << region.size[0] << " " << region.size[1] << " " << region.size[2];
}

/// Opens and reads; the failure's text, or "" when all went well.
inline std::string failureOfReading(const std::string& path)
{
    auto volume = openVolume(path);
    if (!volume) return volume.failure().text;
    const auto bytes = volumeBytes(volume->info().size, volume->info().bytesPerVoxel());
    std::vector<std::byte> out(static_cast<std::size_t>(*bytes));
    const auto read = volume->readBrick({{0, 0, 0}, volume->info().size}, out);
    return read ? "" : read.failure().text;
}

/// A message is one line and holds all of `parts`.
inline void expectSays(const std::string& text, std::initializer_list<const char*> parts)
{
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    for (const char* part : parts)
        EXPECT_NE(text.find(part), std::string::npos) << "no \"" << part << "\" in: " << text;
}

} // namespace vo
