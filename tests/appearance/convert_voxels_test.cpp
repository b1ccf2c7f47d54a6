#include "appearance/convert_voxels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace {

using vo::Channels;
using vo::VoxelFormat;
using vo::VoxelType;

constexpr std::array kChannels{Channels::intensity, Channels::luminance, Channels::luminanceAlpha,
                               Channels::rgba, Channels::abgr};
constexpr std::array kTypes{VoxelType::uint8,       VoxelType::int8,           VoxelType::uint8_332,
                            VoxelType::uint16,      VoxelType::int16,          VoxelType::uint16_4444,
                            VoxelType::uint16_5551, VoxelType::uint32,         VoxelType::int32,
                            VoxelType::uint32_8888, VoxelType::uint32_1010102, VoxelType::float32};

using Rgba = std::array<float, 4>;

template <class T>
std::vector<std::byte> bytesOf(const std::vector<T>& values)
{
    std::vector<std::byte> bytes(values.size() * sizeof(T));
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

template <class T>
std::vector<T> valuesOf(const std::vector<std::byte>& bytes)
{
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
    return values;
}

template <class T>
Rgba decodeOne(VoxelFormat format, const std::vector<T>& values)
{
    Rgba rgba{};
    vo::decodeVoxels(bytesOf(values), format, 1, rgba.data());
    return rgba;
}

template <class T>
std::vector<T> encodeOne(const Rgba& rgba, VoxelFormat format)
{
    std::vector<std::byte> bytes(vo::voxelBytes(format));
    vo::encodeVoxels(rgba.data(), 1, format, bytes);
    return valuesOf<T>(bytes);
}

template <class T>
std::vector<T> convert(const std::vector<T>& values, Channels from, Channels to, VoxelType type,
                       std::size_t count)
{
    const auto source = bytesOf(values);
    std::vector<std::byte> target(count * vo::voxelBytes({to, type}));
    vo::convertVoxels(source.data(), {from, type}, target.data(), {to, type}, count);
    return valuesOf<T>(target);
}

template <class T>
std::vector<T> stretch(const std::vector<T>& values, VoxelType type, double low, double high)
{
    auto bytes = bytesOf(values);
    vo::stretchRange(bytes, {Channels::luminance, type}, low, high);
    return valuesOf<T>(bytes);
}

TEST(VoxelFormat, sizesCountChannelsAndPackedNumbers)
{
    EXPECT_EQ(vo::voxelBytes({Channels::luminance, VoxelType::uint8}), 1u);
    EXPECT_EQ(vo::voxelBytes({Channels::intensity, VoxelType::int16}), 2u);
    EXPECT_EQ(vo::voxelBytes({Channels::luminanceAlpha, VoxelType::uint16}), 4u);
    EXPECT_EQ(vo::voxelBytes({Channels::abgr, VoxelType::float32}), 16u);
    EXPECT_EQ(vo::voxelBytes({Channels::rgba, VoxelType::uint8_332}), 1u);
    EXPECT_EQ(vo::voxelBytes({Channels::rgba, VoxelType::uint16_5551}), 2u);
    EXPECT_EQ(vo::voxelBytes({Channels::abgr, VoxelType::uint32_1010102}), 4u);
}

TEST(VoxelFormat, packedTypesNeedTheirChannels)
{
    for (const VoxelType type : kTypes)
        for (const Channels channels : kChannels) {
            const bool fits =
                type == VoxelType::uint8_332 ? channels == Channels::rgba : vo::channelCount(channels) == 4;
            EXPECT_EQ(vo::isValid({channels, type}), !vo::isPacked(type) || fits);
        }
}

TEST(DecodeVoxels, unsignedNumbersReachFromZeroToOne)
{
    const auto ends = [](auto largest, VoxelType type) {
        using T = decltype(largest);
        EXPECT_EQ(decodeOne<T>({Channels::luminance, type}, {T{0}})[0], 0.0f);
        EXPECT_EQ(decodeOne<T>({Channels::luminance, type}, {largest})[0], 1.0f);
        EXPECT_FLOAT_EQ(decodeOne<T>({Channels::luminance, type}, {T(largest / 5)})[0], 0.2f);
    };
    ends(std::numeric_limits<std::uint8_t>::max(), VoxelType::uint8);
    ends(std::numeric_limits<std::uint16_t>::max(), VoxelType::uint16);
    ends(std::numeric_limits<std::uint32_t>::max(), VoxelType::uint32);
}

TEST(DecodeVoxels, signedNumbersReachFromMinusOneToOne)
{
    const auto ends = [](auto largest, VoxelType type) {
        using T = decltype(largest);
        const VoxelFormat format{Channels::luminance, type};
        EXPECT_EQ(decodeOne<T>(format, {largest})[0], 1.0f);
        EXPECT_EQ(decodeOne<T>(format, {T(-largest)})[0], -1.0f);
        EXPECT_EQ(decodeOne<T>(format, {T(-largest - 1)})[0], -1.0f);
        EXPECT_EQ(decodeOne<T>(format, {T{0}})[0], 0.0f);
    };
    ends(std::numeric_limits<std::int8_t>::max(), VoxelType::int8);
    ends(std::numeric_limits<std::int16_t>::max(), VoxelType::int16);
    ends(std::numeric_limits<std::int32_t>::max(), VoxelType::int32);
}

TEST(DecodeVoxels, floatsStayAsTheyAre)
{
    EXPECT_EQ(decodeOne<float>({Channels::rgba, VoxelType::float32}, {-3.0f, 0.1f, 7e20f, 1.0f}),
              (Rgba{-3.0f, 0.1f, 7e20f, 1.0f}));
}

TEST(DecodeVoxels, channelsSpreadOverRedGreenBlueAlpha)
{
    const VoxelType type = VoxelType::float32;
    EXPECT_EQ(decodeOne<float>({Channels::intensity, type}, {0.5f}), (Rgba{0.5f, 0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(decodeOne<float>({Channels::luminance, type}, {0.5f}), (Rgba{0.5f, 0.5f, 0.5f, 0.5f}));
    EXPECT_EQ(decodeOne<float>({Channels::luminanceAlpha, type}, {0.5f, 0.25f}),
              (Rgba{0.5f, 0.5f, 0.5f, 0.25f}));
    EXPECT_EQ(decodeOne<float>({Channels::rgba, type}, {0.1f, 0.2f, 0.3f, 0.4f}),
              (Rgba{0.1f, 0.2f, 0.3f, 0.4f}));
    EXPECT_EQ(decodeOne<float>({Channels::abgr, type}, {0.4f, 0.3f, 0.2f, 0.1f}),
              (Rgba{0.1f, 0.2f, 0.3f, 0.4f}));
}

TEST(DecodeVoxels, packedNumbersHoldTheFirstChannelInTheirHighestBits)
{
    EXPECT_EQ(decodeOne<std::uint8_t>({Channels::rgba, VoxelType::uint8_332}, {0b101'010'01}),
              (Rgba{5 / 7.0f, 2 / 7.0f, 1 / 3.0f, 1.0f}));
    EXPECT_EQ(decodeOne<std::uint16_t>({Channels::rgba, VoxelType::uint16_4444}, {0x1234}),
              (Rgba{1 / 15.0f, 2 / 15.0f, 3 / 15.0f, 4 / 15.0f}));
    EXPECT_EQ(decodeOne<std::uint16_t>({Channels::rgba, VoxelType::uint16_5551}, {0b00001'00010'00011'1}),
              (Rgba{1 / 31.0f, 2 / 31.0f, 3 / 31.0f, 1.0f}));
    EXPECT_EQ(decodeOne<std::uint32_t>({Channels::rgba, VoxelType::uint32_8888}, {0x01020304u}),
              (Rgba{1 / 255.0f, 2 / 255.0f, 3 / 255.0f, 4 / 255.0f}));
    EXPECT_EQ(decodeOne<std::uint32_t>({Channels::rgba, VoxelType::uint32_1010102},
                                       {1u << 22 | 2u << 12 | 3u << 2 | 2u}),
              (Rgba{1 / 1023.0f, 2 / 1023.0f, 3 / 1023.0f, 2 / 3.0f}));
    EXPECT_EQ(decodeOne<std::uint32_t>({Channels::abgr, VoxelType::uint32_8888}, {0x01020304u}),
              (Rgba{4 / 255.0f, 3 / 255.0f, 2 / 255.0f, 1 / 255.0f}));
}

/// Every bit pattern of a voxel of up to 16 bits, random ones of more; floats in -1 to 1.
std::vector<std::byte> samplesOf(VoxelFormat format)
{
    std::mt19937 random(11);
    if (format.type == VoxelType::float32) {
        std::vector<float> values(4000);
        for (float& value : values)
            value = std::uniform_real_distribution<float>(-1, 1)(random);
        return bytesOf(values);
    }
    std::vector<std::uint16_t> values(65536);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<std::uint16_t>(vo::voxelBytes(format) <= 2 ? i : random());
    return bytesOf(values);
}

TEST(EncodeVoxels, undoesDecoding)
{
    for (const VoxelType type : kTypes)
        for (const Channels channels : kChannels) {
            const VoxelFormat format{channels, type};
            if (!vo::isValid(format)) continue;
            const auto original = samplesOf(format);
            const std::size_t count = original.size() / vo::voxelBytes(format);
            std::vector<float> once(4 * count);
            std::vector<float> twice(4 * count);
            std::vector<std::byte> encoded(original.size());
            vo::decodeVoxels(original, format, count, once.data());
            vo::encodeVoxels(once.data(), count, format, encoded);
            vo::decodeVoxels(encoded, format, count, twice.data());
            EXPECT_EQ(once, twice) << static_cast<int>(type) << ' ' << static_cast<int>(channels);
        }
}

TEST(EncodeVoxels, clampsAndRoundsToNearest)
{
    const VoxelFormat bytes{Channels::rgba, VoxelType::uint8};
    EXPECT_EQ(encodeOne<std::uint8_t>({-1.0f, 2.0f, 100.4f / 255, 100.6f / 255}, bytes),
              (std::vector<std::uint8_t>{0, 255, 100, 101}));
    const VoxelFormat shorts{Channels::rgba, VoxelType::int16};
    EXPECT_EQ(encodeOne<std::int16_t>({-2.0f, 2.0f, -100.6f / 32767, -100.4f / 32767}, shorts),
              (std::vector<std::int16_t>{-32767, 32767, -101, -100}));
    const VoxelFormat words{Channels::rgba, VoxelType::uint32};
    EXPECT_EQ(encodeOne<std::uint32_t>({0.0f, 1.0f, 5.0f, 0.5f}, words),
              (std::vector<std::uint32_t>{0, 0xffffffffu, 0xffffffffu, 0x80000000u}));
    const VoxelFormat packed{Channels::rgba, VoxelType::uint16_5551};
    EXPECT_EQ(encodeOne<std::uint16_t>({-1.0f, 2.0f, 10.4f / 31, 0.6f}, packed),
              (std::vector<std::uint16_t>{0b00000'11111'01010'1}));
    const VoxelFormat floats{Channels::rgba, VoxelType::float32};
    EXPECT_EQ(encodeOne<float>({-1.0f, 2.0f, 0.1f, 1e9f}, floats),
              (std::vector<float>{-1.0f, 2.0f, 0.1f, 1e9f}));
}

TEST(EncodeVoxels, notANumberBecomesTheLowestValue)
{
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(encodeOne<std::uint8_t>({kNan, kNan, kNan, 1.0f}, {Channels::rgba, VoxelType::uint8})[0], 0);
    EXPECT_EQ(encodeOne<std::uint16_t>({kNan, 0, 0, 0}, {Channels::rgba, VoxelType::uint16_4444})[0], 0);
}

TEST(EncodeVoxels, oneChannelTakesTheLuminance)
{
    const VoxelFormat grey{Channels::luminance, VoxelType::float32};
    EXPECT_FLOAT_EQ(encodeOne<float>({1, 0, 0, 1}, grey)[0], 0.30f);
    EXPECT_FLOAT_EQ(encodeOne<float>({0, 1, 0, 1}, grey)[0], 0.59f);
    EXPECT_FLOAT_EQ(encodeOne<float>({0, 0, 1, 1}, grey)[0], 0.11f);
    EXPECT_EQ(encodeOne<float>({0.1f, 0.1f, 0.1f, 1}, grey)[0], 0.1f);
    const VoxelFormat greyAlpha{Channels::luminanceAlpha, VoxelType::float32};
    EXPECT_EQ(encodeOne<float>({0.7f, 0.7f, 0.7f, 0.2f}, greyAlpha), (std::vector<float>{0.7f, 0.2f}));
}

TEST(ConvertVoxels, copiesOf32BitChannelsAreExact)
{
    const VoxelType type = VoxelType::uint32;
    const std::vector<std::uint32_t> grey{0x12345679u, 0xfffffffeu};
    EXPECT_EQ(
        convert(grey, Channels::luminance, Channels::rgba, type, 2),
        (std::vector<std::uint32_t>{grey[0], grey[0], grey[0], grey[0], grey[1], grey[1], grey[1], grey[1]}));
    EXPECT_EQ(convert(grey, Channels::luminance, Channels::luminanceAlpha, type, 2),
              (std::vector<std::uint32_t>{grey[0], grey[0], grey[1], grey[1]}));
    const std::vector<std::uint32_t> color{0x12345679u, 0x87654321u, 3, 0xfffffffeu};
    EXPECT_EQ(convert(color, Channels::rgba, Channels::abgr, type, 1),
              (std::vector<std::uint32_t>{color[3], color[2], color[1], color[0]}));
    const std::vector<std::uint32_t> greyColor{0x12345679u, 0x12345679u, 0x12345679u, 5};
    EXPECT_EQ(convert(greyColor, Channels::rgba, Channels::luminanceAlpha, type, 1),
              (std::vector<std::uint32_t>{0x12345679u, 5}));
}

TEST(ConvertVoxels, colorBecomesTheLuminanceRounded)
{
    const std::vector<std::uint8_t> color{10, 200, 30, 7, 9, 9, 9, 1};
    EXPECT_EQ(convert(color, Channels::rgba, Channels::luminance, VoxelType::uint8, 2),
              (std::vector<std::uint8_t>{124, 9})); // 3 + 118 + 3.3
    EXPECT_EQ(convert(color, Channels::rgba, Channels::luminanceAlpha, VoxelType::uint8, 2),
              (std::vector<std::uint8_t>{124, 7, 9, 1}));
}

TEST(ConvertVoxels, greyColorGivesItsValueExactly)
{
    std::mt19937 random(5);
    for (int i = 0; i < 100000; ++i) {
        const auto grey = static_cast<std::uint32_t>(random());
        const auto grey8 = static_cast<std::int8_t>(grey);
        const auto greyFloat = static_cast<float>(grey) / 3.0e9f - 0.5f;
        ASSERT_EQ(convert(std::vector{grey, grey, grey, 1u}, Channels::rgba, Channels::luminance,
                          VoxelType::uint32, 1)[0],
                  grey);
        ASSERT_EQ(convert(std::vector<std::int8_t>{1, grey8, grey8, grey8}, Channels::abgr,
                          Channels::luminance, VoxelType::int8, 1)[0],
                  grey8);
        ASSERT_EQ(convert(std::vector{greyFloat, greyFloat, greyFloat, 1.0f}, Channels::rgba,
                          Channels::intensity, VoxelType::float32, 1)[0],
                  greyFloat);
    }
}

TEST(ConvertVoxels, changesTheTypeByWayOfItsRange)
{
    const auto source = bytesOf<std::uint8_t>({0, 1, 128, 255});
    std::vector<std::byte> target(8);
    vo::convertVoxels(source.data(), {Channels::luminance, VoxelType::uint8}, target.data(),
                      {Channels::luminance, VoxelType::uint16}, 4);
    EXPECT_EQ(valuesOf<std::uint16_t>(target), (std::vector<std::uint16_t>{0, 257, 128 * 257, 65535}));
}

TEST(ConvertVoxels, inPlaceEqualsApart)
{
    constexpr std::size_t kCount = 1537; // three blocks and one voxel
    std::mt19937 random(3);
    for (const VoxelType fromType : kTypes)
        for (const VoxelType toType :
             {fromType, VoxelType::uint8, VoxelType::uint16_4444, VoxelType::float32})
            for (const Channels from : kChannels)
                for (const Channels to : kChannels) {
                    const VoxelFormat source{from, fromType};
                    const VoxelFormat target{to, toType};
                    if (!vo::isValid(source) || !vo::isValid(target)) continue;
                    std::vector<float> rgba(4 * kCount);
                    for (float& value : rgba)
                        value = std::uniform_real_distribution<float>(0, 1)(random);
                    std::vector<std::byte> original(kCount * vo::voxelBytes(source));
                    vo::encodeVoxels(rgba.data(), kCount, source, original);
                    std::vector<std::byte> apart(kCount * vo::voxelBytes(target));
                    vo::convertVoxels(original.data(), source, apart.data(), target, kCount);
                    std::vector<std::byte> shared(original);
                    shared.resize(std::max(original.size(), apart.size()));
                    vo::convertVoxels(shared.data(), source, shared.data(), target, kCount);
                    shared.resize(apart.size());
                    ASSERT_EQ(shared, apart) << static_cast<int>(fromType) << static_cast<int>(from) << ' '
                                             << static_cast<int>(toType) << static_cast<int>(to);
                }
}

TEST(StretchRange, mapsItsEndsToTheEndsOfTheType)
{
    EXPECT_EQ((stretch<std::uint8_t>({0, 50, 100, 150, 255}, VoxelType::uint8, 50, 150)),
              (std::vector<std::uint8_t>{0, 0, 128, 255, 255}));
    EXPECT_EQ((stretch<std::int8_t>({-128, -50, 0, 50, 127}, VoxelType::int8, -50, 50)),
              (std::vector<std::int8_t>{0, 0, 64, 127, 127}));
    EXPECT_EQ((stretch<std::uint16_t>({0, 1000, 1500, 2000, 65535}, VoxelType::uint16, 1000, 2000)),
              (std::vector<std::uint16_t>{0, 0, 32768, 65535, 65535}));
    EXPECT_EQ((stretch<std::int16_t>({-32768, -1024, 1000, 3072, 32767}, VoxelType::int16, -1024, 3072)),
              (std::vector<std::int16_t>{0, 0, 16192, 32767, 32767}));
    EXPECT_EQ((stretch<std::uint32_t>({0, 10, 15, 20, 0xffffffffu}, VoxelType::uint32, 10, 20)),
              (std::vector<std::uint32_t>{0, 0, 0x80000000u, 0xffffffffu, 0xffffffffu}));
    EXPECT_EQ((stretch<std::int32_t>({-5, -1, 0, 1, 7}, VoxelType::int32, -1, 1)),
              (std::vector<std::int32_t>{0, 0, 0x40000000, 0x7fffffff, 0x7fffffff}));
    EXPECT_EQ((stretch<float>({-5.0f, -1.0f, 0.0f, 1.0f, 7.0f}, VoxelType::float32, -1, 1)),
              (std::vector<float>{0.0f, 0.0f, 0.5f, 1.0f, 1.0f}));
}

TEST(StretchRange, wholeRangeChangesNothing)
{
    std::vector<std::uint8_t> bytes(256);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i);
    EXPECT_EQ(stretch(bytes, VoxelType::uint8, 0, 255), bytes);
    std::vector<std::uint16_t> shorts(65536);
    for (std::size_t i = 0; i < shorts.size(); ++i)
        shorts[i] = static_cast<std::uint16_t>(i);
    EXPECT_EQ(stretch(shorts, VoxelType::uint16, 0, 65535), shorts);
}

TEST(StretchRange, emptyRangeLeavesTheVoxelsAlone)
{
    const std::vector<std::uint8_t> values{1, 2, 3};
    EXPECT_EQ(stretch(values, VoxelType::uint8, -1, -1), values);
    EXPECT_EQ(stretch(values, VoxelType::uint8, 200, 100), values);
    EXPECT_EQ(stretch(values, VoxelType::uint8, std::nan(""), 100), values);
}

TEST(StretchRange, notANumberBecomesZero)
{
    EXPECT_EQ(stretch<float>({std::nanf(""), 1.0f}, VoxelType::float32, 0, 2),
              (std::vector<float>{0.0f, 0.5f}));
}

} // namespace
