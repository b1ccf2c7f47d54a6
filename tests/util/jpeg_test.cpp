// JPEG pictures, written by libjpeg and read back.

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "jpeg_file.h"
#include "scratch_folder.h"
#include "volume_truth.h"

namespace vo {
namespace {

/// Smooth, so that coding loses little: red grows along x, green along y, blue falls along x.
std::uint8_t smooth(int x, int y, int channel)
{
    return static_cast<std::uint8_t>(channel == 0 ? 3 * x : channel == 1 ? 3 * y : 240 - 3 * x);
}

void expectSmooth(const std::string& path, int channels)
{
    auto volume = openVolume(path);
    ASSERT_TRUE(volume) << volume.failure().text;
    const int arriving = channels == 3 ? 4 : channels;
    ASSERT_EQ(volume->info(), (VolumeInfo{{70, 50, 1}, arriving, ChannelType::uint8}));
    EXPECT_EQ(volume->description().alphaAdded, channels == 3);
    EXPECT_EQ(volume->description().format, "JPEG");
    const auto bytes = readBrick(*volume, {{0, 0, 0}, {70, 50, 1}});
    for (int y = 0; y < 50; ++y)
        for (int x = 0; x < 70; ++x)
            for (int channel = 0; channel < channels; ++channel)
                ASSERT_NEAR(int(bytes[static_cast<std::size_t>((y * 70 + x) * arriving + channel)]),
                            smooth(x, y, channel), 6)
                    << x << ' ' << y << ' ' << channel;
}

TEST(Jpeg, pixelsArriveInTheirPlaces)
{
    ScratchFolder folder;
    writeJpeg(folder / "grey.jpg", 70, 50, 1, smooth);
    writeJpeg(folder / "color.jpg", 70, 50, 3, smooth);
    writeJpeg(folder / "progressive.jpg", 70, 50, 3, smooth, true);
    expectSmooth(folder / "grey.jpg", 1);
    expectSmooth(folder / "color.jpg", 3);
    expectSmooth(folder / "progressive.jpg", 3);
}

TEST(Jpeg, whatCannotBeReadSaysSo)
{
    ScratchFolder folder;
    writeJpeg(folder / "inks.jpg", 70, 50, 4, smooth);
    EXPECT_FALSE(openVolume(folder / "inks.jpg"));
    writeJpeg(folder / "whole.jpg", 70, 50, 3, smooth);
    const auto bytes = std::filesystem::file_size(folder / "whole.jpg");
    for (const auto kept : {std::uintmax_t{3}, bytes / 10, bytes / 2, bytes - 10}) {
        std::filesystem::copy_file(folder / "whole.jpg", folder / "half.jpg",
                                   std::filesystem::copy_options::overwrite_existing);
        std::filesystem::resize_file(folder / "half.jpg", kept);
        const auto half = openVolume(folder / "half.jpg");
        ASSERT_FALSE(half) << kept;
        EXPECT_TRUE(half.failure().text.starts_with(folder / "half.jpg")) << half.failure().text;
    }
}

TEST(Jpeg, sizesThatTheFileCannotHoldAreRefused)
{
    ScratchFolder folder;
    writeJpeg(folder / "a.jpg", 16, 16, 1, smooth);
    std::fstream file(folder / "a.jpg", std::ios::in | std::ios::out | std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    const auto frame = bytes.find("\xff\xc0");
    ASSERT_NE(frame, std::string::npos);
    file.clear();
    file.seekp(static_cast<std::streamoff>(frame) + 5);
    file.write("\xff\xdc\xff\xdc", 4);
    file.close();
    const auto volume = openVolume(folder / "a.jpg");
    ASSERT_FALSE(volume);
    EXPECT_NE(volume.failure().text.find("cannot hold them"), std::string::npos) << volume.failure().text;
}

} // namespace
} // namespace vo
