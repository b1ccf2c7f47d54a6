// vorender as a user calls it: pictures whose pixels follow from the volume by a formula, and what is
// refused.

#include <algorithm>
#include <cmath>
#include <cstring>

#include "foreign_volumes.h"
#include "run_program.h"
#include "scratch_folder.h"

namespace vo {
namespace {

/// A head-on picture of a cube of n voxels has kPixels pixels a side, kPixels / (n sqrt 3) a voxel.
constexpr int kPixels = 64;

class Vorender : public testing::Test
{
protected:
    ProgramRun run(const std::string& words)
    {
        return runProgram("cd '" + (folder_ / "") + "' && " VORENDER " " + words);
    }
    void draws(const std::string& words)
    {
        const auto drawn = run(words);
        EXPECT_EQ(drawn.status, 0) << words;
        EXPECT_EQ(drawn.output, "") << words;
    }
    /// A run that must fail with one line that holds `parts` and leave no more files than there were.
    void expectFails(const std::string& words, std::initializer_list<const char*> parts)
    {
        const int before = folder_.fileCount();
        auto failed = run(words);
        EXPECT_EQ(failed.status, 1) << words;
        ASSERT_EQ(std::ranges::count(failed.output, '\n'), 1) << words << "\n" << failed.output;
        EXPECT_TRUE(failed.output.starts_with("vorender: ")) << failed.output;
        failed.output.pop_back();
        expectSays(failed.output, parts);
        EXPECT_EQ(folder_.fileCount(), before) << words;
    }
    std::string bytesOf(const std::string& name)
    {
        std::ifstream file(folder_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    /// The floats of a .raw picture.
    std::vector<float> floats(const std::string& name)
    {
        const std::string bytes = bytesOf(name);
        std::vector<float> values(bytes.size() / sizeof(float));
        std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
        return values;
    }
    /// A cube of n^3 bytes, value(x, y, z).
    template <class Value>
    void writeCube(const std::string& name, int n, Value value)
    {
        std::string voxels;
        for (int z = 0; z < n; ++z)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x)
                    voxels += static_cast<char>(value(x, y, z));
        writeFile(folder_ / name, voxels);
    }

    ScratchFolder folder_;
};

/// The pixel in the middle of a square picture, `channels` floats each.
const float* middle(const std::vector<float>& picture, int channels)
{
    return &picture[std::size_t(channels * (kPixels / 2 * kPixels + kPixels / 2))];
}

TEST_F(Vorender, opacityOfAConstantCubeFollowsTheSum)
{
    constexpr int n = 16;
    writeCube("c.raw", n, [](int, int, int) { return 255; });
    writeFile(folder_ / "t.lut", "0.0 0.0 0.0 0.0\n1.0 0.5 0.25 0.1\n");
    for (const std::string view : {"0 0", "0 90", "90 0", "0 180"}) {
        draws("-raw 16 16 16 uchar c.raw -lutFile t.lut -size 64 64 -output p.raw -view " + view);
        const auto picture = floats("p.raw");
        ASSERT_EQ(picture.size(), std::size_t(4 * kPixels * kPixels));
        const double opacity = 1 - std::pow(0.9, n);
        const float* pixel = middle(picture, 4);
        EXPECT_NEAR(double(pixel[0]), opacity, 2e-3) << view;
        EXPECT_NEAR(double(pixel[1]), 0.5 * opacity, 2e-3) << view;
        EXPECT_NEAR(double(pixel[2]), 0.25 * opacity, 2e-3) << view;
        EXPECT_NEAR(double(pixel[3]), opacity, 2e-3) << view;
        for (int c = 0; c < 4; ++c)
            EXPECT_EQ(picture[std::size_t(c)], 0.0f) << "beside the cube";
    }
}

TEST_F(Vorender, coloursWithoutAlphaAreAsOpaqueAsBright)
{
    constexpr int n = 16;
    // Black before and behind (y points away), in between six slices of one colour.
    const auto writeSlab = [&](const std::string& name, int channels, unsigned char alpha) {
        std::string voxels;
        for (int i = 0; i < n * n * n; ++i) {
            const bool inside = i / n % n >= 5 && i / n % n < 11;
            for (const int value : {51, 102, 25, int(alpha)})
                voxels += static_cast<char>(inside ? value : 0);
            if (channels == 3) voxels.pop_back();
            if (channels == 4 && alpha == 255) voxels.back() = '\xff';
        }
        writeFile(folder_ / name, voxels);
        return " -raw 16 16 16 uchar " + name + " -channels " + std::to_string(channels) + " -size 64 64 ";
    };
    const std::string rgb = writeSlab("rgb.raw", 3, 0), opaque = writeSlab("opaque.raw", 4, 255),
                      bright = writeSlab("bright.raw", 4, 102);
    draws(rgb + "-color -output p.raw");
    const double opacity = 1 - std::pow(1 - 102 / 255.0, 6);
    const std::vector<float> picture = floats("p.raw");
    const float* pixel = middle(picture, 4);
    for (const auto& [channel, value] : {std::pair(0, 51), {1, 102}, {2, 25}, {3, 255}})
        EXPECT_NEAR(double(pixel[channel]), value / 255.0 * opacity, 1e-5) << channel;

    writeFile(folder_ / "t.lut", "0.0 0.0 0.0 0.0\n1.0 0.5 0.25 0.1\n");
    const auto expectSame = [&](const std::string& words, const std::string& other) {
        draws(rgb + words + " -output p.raw");
        draws(other + words + " -output other.raw");
        EXPECT_EQ(bytesOf("p.raw"), bytesOf("other.raw")) << words;
    };
    for (const char* words : {"", "-color -view 20 30", "-color -shells -perspective 40", "-2D -view 0 90"})
        expectSame(words, bright);
    for (const char* words : {"-mip -color", "-mip", "-lutFile t.lut", "-lut 100 80", "-color -lut 100 80"})
        expectSame(words, opaque);
    draws(opaque + "-color -output p.raw");
    EXPECT_EQ(middle(floats("p.raw"), 4)[1], 0.0f) << "an alpha of the file's own stays";
}

TEST_F(Vorender, rowsComeFromTheTop)
{
    // Bright above: at 0 0 z points up.
    writeCube("c.raw", 16, [](int, int, int z) { return z >= 8 ? 255 : 0; });
    draws("-raw 16 16 16 uchar c.raw -size 64 64 -mip -output p.raw -depth d.raw");
    draws("-raw 16 16 16 uchar c.raw -size 64 64 -mip -output p.png");
    const auto picture = floats("p.raw"), depths = floats("d.raw");
    const std::size_t above = std::size_t(kPixels * 22 + 32), below = std::size_t(kPixels * 42 + 32);
    EXPECT_GT(picture[4 * above], 0.9f);
    EXPECT_LT(picture[4 * below], 0.1f);
    EXPECT_LT(depths[above], 1.0f);
    EXPECT_EQ(depths[below], 1.0f);
    const auto png = readPng(folder_ / "p.png");
    ASSERT_TRUE(png);
    EXPECT_GT(png->bytes[3 * above], 230);
    EXPECT_LT(png->bytes[3 * below], 26);
}

TEST_F(Vorender, depthIsThatOfTheSampleThatReachesOneHalf)
{
    // 16 samples at 0.5 ... 15.5 along the line of sight, the near plane 1.01 r before the centre.
    constexpr int n = 16;
    const double radius = n * std::sqrt(3.0) / 2;
    const auto windowDepth = [&](int sample) {
        return (1.01 * radius + sample + 0.5 - n / 2.0) / (2.02 * radius);
    };
    writeCube("c.raw", n, [](int, int, int) { return 255; });
    for (const auto& [alpha, sample] :
         {std::pair("1.0", 0), {"0.5", 0}, {"0.49", 1}, {"0.1", 6}, {"0.05", 13}}) {
        writeFile(folder_ / "t.lut", std::string("0.0 0.0\n1.0 ") + alpha + "\n");
        draws("-raw 16 16 16 uchar c.raw -lutFile t.lut -size 64 64 -depth d.raw");
        const auto depths = floats("d.raw");
        ASSERT_EQ(depths.size(), std::size_t(kPixels * kPixels));
        EXPECT_NEAR(double(*middle(depths, 1)), windowDepth(sample), 1e-5) << alpha;
        EXPECT_EQ(depths[0], 1.0f);
    }
    writeFile(folder_ / "t.lut", "0.0 0.0\n1.0 0.04\n"); // 1 - .96^16 = .48
    draws("-raw 16 16 16 uchar c.raw -lutFile t.lut -size 64 64 -depth d.raw -output p.png");
    EXPECT_EQ(*middle(floats("d.raw"), 1), 1.0f);
    EXPECT_TRUE(readPng(folder_ / "p.png"));
}

TEST_F(Vorender, depthOfAMaximumIsWhereItLies)
{
    constexpr int n = 16;
    const double radius = n * std::sqrt(3.0) / 2;
    writeCube("c.raw", n, [](int, int y, int) { return y == 11 ? 200 : 50; }); // y points away
    draws("-raw 16 16 16 uchar c.raw -mip -size 64 64 -depth d.raw");
    EXPECT_NEAR(double(*middle(floats("d.raw"), 1)), (1.01 * radius + 11.5 - n / 2.0) / (2.02 * radius),
                1e-5);
    draws("-raw 16 16 16 uchar c.raw -mip -size 64 64 -depth d.png");
    auto png = openVolume(folder_ / "d.png");
    ASSERT_TRUE(png);
    EXPECT_EQ(png->info(), (VolumeInfo{{kPixels, kPixels, 1}, 1, ChannelType::uint16}));
    std::vector<std::uint16_t> values(kPixels * kPixels);
    ASSERT_TRUE(
        png->readBrick({{0, 0, 0}, {kPixels, kPixels, 1}}, std::as_writable_bytes(std::span(values))));
    const std::vector<float> depths = floats("d.raw");
    EXPECT_NEAR(values[std::size_t(kPixels / 2 * kPixels + kPixels / 2)], 65535 * double(*middle(depths, 1)),
                1.0);
}

TEST_F(Vorender, framesAreThePicturesOfTheirViews)
{
    writeCube("c.raw", 12, [](int x, int y, int z) { return x * 20 * (y > 5) + 3 * z; });
    const std::string volume = "-raw 12 12 12 uchar c.raw -size 40 40 ";
    draws(volume + "-view 10 20 -frames 4 -output f%02d.png -depth d%d.raw");
    EXPECT_EQ(folder_.fileCount(), 9);
    for (const auto& [frame, view] : {std::pair(0, "10 20"), {1, "10 110"}, {3, "10 290"}}) {
        draws(volume + "-view " + view + " -output one.png -depth one.raw");
        EXPECT_EQ(bytesOf("f0" + std::to_string(frame) + ".png"), bytesOf("one.png")) << frame;
        EXPECT_EQ(bytesOf("d" + std::to_string(frame) + ".raw"), bytesOf("one.raw")) << frame;
    }
    EXPECT_NE(bytesOf("f00.png"), bytesOf("f01.png"));
}

TEST_F(Vorender, namesWithoutANumberShowTheView)
{
    writeCube("c.raw", 12, [](int x, int y, int z) { return x * 20 * (y > 5) + 3 * z; });
    const std::string volume = "-raw 12 12 12 uchar c.raw -size 40 40 -view 10 20 ";
    draws(volume + "-output one.png -depth one.raw");
    draws(volume + "-output 100%d.png");
    EXPECT_EQ(bytesOf("100%d.png"), bytesOf("one.png")) << "no turn: the name as it is";
    for (const char* names : {"-output p.png -depth d%d.raw", "-output p.png"}) {
        const auto turned = run(volume + "-frames 3 " + names);
        EXPECT_EQ(turned.status, 0);
        EXPECT_EQ(turned.output.find("vorender: p.png: has no %d"), 0u) << turned.output;
        EXPECT_EQ(std::ranges::count(turned.output, '\n'), 1);
        EXPECT_EQ(bytesOf("p.png"), bytesOf("one.png")) << names;
    }
    EXPECT_EQ(bytesOf("d0.raw"), bytesOf("one.raw"));
    EXPECT_EQ(folder_.fileCount(), 8) << "c.raw, one.png, one.raw, 100%d.png, p.png, d0.raw to d2.raw";
}

TEST_F(Vorender, namesOfOneFileAreRefusedHoweverSpelled)
{
    writeCube("c.raw", 8, [](int x, int, int) { return x; });
    std::filesystem::create_directory(folder_ / "in");
    std::filesystem::create_directory_symlink("in", folder_ / "link");
    std::filesystem::create_symlink("p0.png", folder_ / "p1.png");
    writeFile(folder_ / "p0.png", "");
    const std::string raw = "-raw 8 8 8 uchar c.raw ", here = "$PWD/";
    const auto refuses = [&](const std::string& words, const char* option, const char* found) {
        expectFails(raw + words, {option, "expected another file", found});
    };
    refuses("-output ./n.raw -depth n.raw", "-depth", "'n.raw'");
    refuses("-output n.png -depth in/../n.png", "-depth", "'in/../n.png'");
    refuses("-output n.png -depth " + here + "n.png", "-depth", "/n.png'");
    refuses("-output in/n.png -depth link/n.png", "-depth", "'link/n.png'");
    refuses("-output w%d.png -depth ./w%d.png -frames 2", "-depth", "'./w0.png'");
    refuses("-output w%d.png -depth w%01d.png -frames 2", "-depth", "'w0.png'");
    refuses("-output w1.png -depth w%d.png -frames 2", "-depth", "'w1.png'");
    refuses("-output p%d.png -frames 2", "-output", "'p1.png'");
    refuses("-output p0.png -depth p1.png", "-depth", "'p1.png'");
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "in"));
    draws(raw + "-size 8 8 -output w%d.png -depth w%02d.png -frames 2");
    draws(raw + "-size 8 8 -output n.raw -depth in/n.raw");
}

TEST_F(Vorender, rawFilesOfEveryKindGiveOnePicture)
{
    const VolumeTruth truth({{7, 6, 5}, 1, ChannelType::uint16});
    const auto voxels = voxelsInFile(truth, {}, false);
    ASSERT_TRUE(writeTiffStack(folder_ / "t.tif", truth.info(), truth.whole()));
    writeFile(folder_ / "little.raw", voxels);
    writeFile(folder_ / "big.raw", "header" + voxelsInFile(truth, {}, true));
    writeFile(folder_ / "v.nhdr", "NRRD0004\ntype: ushort\ndimension: 3\nsizes: 7 6 5\nencoding: raw\n"
                                  "endian: little\ndata file: little.raw\n");
    std::string slices;
    for (std::size_t z = 0; z < 5; ++z) {
        slices += " s" + std::to_string(z);
        writeFile(folder_ / ("s" + std::to_string(z)), voxels.substr(z * 84, 84));
    }
    draws("t.tif -view 20 30 -size 50 50 -output tif.png");
    for (const std::string& volume :
         {std::string("-raw 7 6 5 ushort little.raw"), std::string("v.nhdr"),
          std::string("-bigEndian -header 6 -raw 7 6 5 ushort big.raw"), "-raw 7 6 5 ushort" + slices}) {
        draws(volume + " -view 20 30 -size 50 50 -output p.png");
        EXPECT_EQ(bytesOf("p.png"), bytesOf("tif.png")) << volume;
    }
    const VolumeTruth colors({{4, 3, 5}, 4, ChannelType::uint8});
    ASSERT_TRUE(writeTiffStack(folder_ / "c.tif", colors.info(), colors.whole()));
    writeFile(folder_ / "c.raw", voxelsInFile(colors, {}, false));
    draws("c.tif -color -size 50 50 -output tif.png");
    draws("-raw 4 3 5 uchar -channels 4 c.raw -color -size 50 50 -output p.png");
    EXPECT_EQ(bytesOf("p.png"), bytesOf("tif.png"));
}

TEST_F(Vorender, loadsNeitherOpenGlNorWhatAFileMayNotNeed)
{
    const auto loaded = runProgram("ldd " VORENDER);
    ASSERT_EQ(loaded.status, 0);
    EXPECT_NE(loaded.output.find("libpng"), std::string::npos);
    for (const char* library : {"libGL", "libEGL", "libOSMesa", "libX11", "libglfw", "libvo.so", "libgdcm"})
        EXPECT_EQ(loaded.output.find(library), std::string::npos) << library;
}

TEST_F(Vorender, badCommandLinesGiveOneLineAndNoFile)
{
    writeCube("c.raw", 8, [](int x, int, int) { return x; });
    const std::string raw = "-raw 8 8 8 uchar c.raw ";
    expectFails("", {"expected the file of one volume", "found none"});
    expectFails("a.tif b.tif -output p.png", {"expected the file of one volume", "found: a.tif b.tif"});
    expectFails(raw, {"expected -output FILE.png", "found none of them"});
    expectFails(raw + "-output p.jpg",
                {"option -output: expected a file name that ends in .png or .raw", "'p.jpg'"});
    expectFails(raw + "-wireframe -output p.png",
                {"option -wireframe: expected a program that draws with OpenGL"});
    expectFails(raw + "-core -output p.png", {"option -core: expected a program that draws with OpenGL"});
    expectFails(raw + "-engine cast -output p.png",
                {"option -engine: expected a program that draws with OpenGL"});
    expectFails(raw + "-frames 3 -output p%d%d.png",
                {"option -output: expected a name with a %d", "'p%d%d.png'"});
    expectFails(raw + "-frames 3 -depth p%s.png", {"option -depth: expected a name with a %d"});
    expectFails(raw + "-output p.png -depth p.png", {"option -depth: expected another file"});
    expectFails(raw + "-shells -2D -output p.png", {"option -shells: expected 3D textures, found -2D"});
    expectFails(raw + "-sampling 0.00001 -output p.png",
                {"option -sampling: expected at most 65536 sampling planes"});
    expectFails(raw + "-bricks 2 2 2 -overlap 0 -output p.png",
                {"option -bricks: expected an -overlap of 1 or more"});
    expectFails(raw + "-bricks 7 7 7 -overlap 0 -output p.png",
                {"option -bricks: expected an -overlap of 1 or more"});
    expectFails(raw + "-overlap 500 -output p.png",
                {"option -overlap: expected fewer voxels than a brick has on each side (8)", "'500'"});
    expectFails(raw + "-overlap 8 -bricks 1 1 1 -output p.png",
                {"option -overlap: expected fewer voxels", "'8'"});
    expectFails("-raw 8 8 8 double c.raw -output p.png", {"option -raw: expected char, uchar", "'double'"});
    expectFails("-raw 8 0 8 uchar c.raw -output p.png", {"option -raw: expected a number of voxels from 1"});
    expectFails("-raw 8 8 9 uchar c.raw -output p.png",
                {"c.raw: expected", "576 bytes of voxels", "512 bytes"});
    expectFails("-raw 1000000 1000000 9 float c.raw -output p.png", {"c.raw: expected", "found 512 bytes"});
    expectFails("-header 5 c.raw -output p.png", {"option -header: expected -raw"});
    expectFails("none.tif -output p.png", {"none.tif: cannot open"});
    expectFails(raw + "-lutFile none.lut -output p.png", {"none.lut: cannot open"});
    expectFails(raw + "-output no/p.png", {"no/p.png: cannot write"});
    EXPECT_EQ(folder_.fileCount(), 1);
}

TEST_F(Vorender, volumesAreNotReplaced)
{
    writeCube("c.raw", 8, [](int x, int, int) { return x; });
    writeFile(folder_ / "other.raw", "voxels of somebody");
    const std::string raw = "-raw 8 8 8 uchar c.raw -size 20 10 ";
    expectFails(raw + "-output ./c.raw", {"c.raw: expected an output that is no input"});
    expectFails(raw + "-output other.raw",
                {"other.raw: expected a new file, or one of 3200 bytes", "found one of 18"});
    expectFails(raw + "-depth other.raw", {"other.raw: expected a new file, or one of 800 bytes"});
    EXPECT_EQ(bytesOf("other.raw"), "voxels of somebody");
    draws(raw + "-output p.raw");
    draws(raw + "-output p.raw");
    EXPECT_EQ(bytesOf("p.raw").size(), 3200u);
}

TEST_F(Vorender, memoryThatIsNotThereIsNamed)
{
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the address sanitizer reserves more than any limit";
#endif
    writeCube("c.raw", 8, [](int x, int, int) { return x; });
    const auto limited = runProgram("cd '" + (folder_ / "") +
                                    "' && ulimit -v 1500000 && VO_THREADS=1 " VORENDER
                                    " -raw 8 8 8 uchar c.raw -size 8192 8192 -output p.png");
    EXPECT_EQ(limited.status, 1);
    ASSERT_EQ(std::ranges::count(limited.output, '\n'), 1) << limited.output;
    expectSays(limited.output.substr(0, limited.output.size() - 1),
               {"-size: expected memory", "8192 x 8192", "1073741824 bytes"});
    EXPECT_EQ(folder_.fileCount(), 1);
}

TEST_F(Vorender, limitOnTheSizeOfFilesGivesOneLineAndNoFile)
{
    writeCube("c.raw", 8, [](int x, int y, int z) { return x * 31 + y * 17 + z; });
    for (const std::string output : {"-output p.png", "-output p.raw", "-depth d.raw"}) {
        const auto limited = runProgram("cd '" + (folder_ / "") +
                                        "' && ulimit -f 8 && " VORENDER
                                        " -raw 8 8 8 uchar c.raw -sampling 0.1 -view 20 30 -size 300 300 " +
                                        output);
        EXPECT_EQ(limited.status, 1) << output;
        ASSERT_EQ(std::ranges::count(limited.output, '\n'), 1) << output << limited.output;
        expectSays(limited.output.substr(0, limited.output.size() - 1), {"cannot write"});
        EXPECT_EQ(folder_.fileCount(), 1) << output;
    }
}

TEST_F(Vorender, helpShowsExamplesAndNoOptionThatIsRefused)
{
    for (const char* word : {"-h", "-help", "--help"}) {
        const auto help = run(word);
        EXPECT_EQ(help.status, 0);
        EXPECT_NE(help.output.find("Example: vorender"), std::string::npos);
        EXPECT_NE(help.output.find("  -depth FILE"), std::string::npos);
        EXPECT_EQ(help.output.find("-wireframe"), std::string::npos);
    }
    EXPECT_EQ(run("-version").output.find("Volumizer "), 0u);
    EXPECT_EQ(run("-help >/dev/full").status, 1);
}

} // namespace
} // namespace vo
