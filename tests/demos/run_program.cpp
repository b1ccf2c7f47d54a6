#include "run_program.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace vo {
namespace {

template <typename Value>
void writeVolume(const std::filesystem::path& path, const VolumeInfo& info,
                 const std::function<int(int, int, int)>& value)
{
    std::vector<Value> voxels;
    for (int z = 0; z < info.size[2]; ++z) {
        for (int y = 0; y < info.size[1]; ++y) {
            for (int x = 0; x < info.size[0]; ++x)
                voxels.push_back(Value(value(x, y, z)));
        }
    }
    ASSERT_TRUE(writeTiffStack(path, info, std::as_bytes(std::span(voxels))));
}

} // namespace

ScratchFolder::ScratchFolder()
{
    std::string name = testing::TempDir() + "/vogl_XXXXXX";
    if (!mkdtemp(name.data())) std::abort();
    path_ = name;
}

ScratchFolder::~ScratchFolder()
{
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

ProgramRun ScratchFolder::run(const std::string& program, const std::vector<std::string>& words,
                              const std::string& environment) const
{
    // The program's own output lies beside the folder, so that files() sees what the program left.
    const std::string out = path_.string() + ".out", err = path_.string() + ".err";
    std::string line = "cd '" + path_.string() + "' && env " + environment + " '" + program + "'";
    for (const std::string& word : words)
        line += " '" + word + "'";
    const int status = std::system((line + " >'" + out + "' 2>'" + err + "'").c_str());
    const ProgramRun result{WIFEXITED(status) ? WEXITSTATUS(status) : -1, readFile(out), readFile(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return result;
}

ProgramRun ScratchFolder::run(const std::string& program, const std::string& words) const
{
    std::istringstream stream(words);
    std::vector<std::string> list;
    for (std::string word; stream >> word;)
        list.push_back(word);
    return run(std::string(VOLUMIZER_PROGRAMS) + "/" + program, list, "-u DISPLAY -u WAYLAND_DISPLAY");
}

std::vector<std::string> ScratchFolder::files() const
{
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(path_))
        names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
}

void writeBytes(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                const std::function<int(int, int, int)>& value)
{
    writeVolume<std::uint8_t>(path, {{xSize, ySize, zSize}, 1, ChannelType::uint8}, value);
}

void writeShorts(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                 const std::function<int(int, int, int)>& value)
{
    writeVolume<std::uint16_t>(path, {{xSize, ySize, zSize}, 1, ChannelType::uint16}, value);
}

void writeChannels(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                   const std::string& voxels)
{
    std::ofstream(path, std::ios::binary)
        << "NRRD0004\ntype: uchar\ndimension: 4\nsizes: " << int(voxels.size()) / (xSize * ySize * zSize)
        << ' ' << xSize << ' ' << ySize << ' ' << zSize
        << "\nkinds: vector space space space\nencoding: raw\n\n"
        << voxels;
}

std::vector<float> writeSmoothTable(const std::filesystem::path& path,
                                    const std::function<double(double)>& opacity)
{
    std::ofstream file(path);
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const double v = i / 255.0;
        for (const double entry : {v, 1 - v, 0.5 + 0.4 * std::sin(6 * v), opacity(v)}) {
            char text[20];
            std::snprintf(text, sizeof text, "%.5f", entry);
            file << text << ' ';
            table.push_back(std::stof(text));
        }
        file << '\n';
    }
    return table;
}

DrawnPicture drawnPicture(const ScratchFolder& folder, const std::string& program, const std::string& words,
                          const std::string& said)
{
    const ProgramRun run = folder.run(program, words + " -output picture.png");
    EXPECT_EQ(run.status, 0) << program << ' ' << words << ": " << run.errors;
    EXPECT_EQ(run.errors, said) << program << ' ' << words;
    const auto picture = readPng(folder / "picture.png");
    EXPECT_TRUE(picture) << program << ' ' << words;
    return {picture ? *picture : Picture{}, run.output};
}

void expectOneLine(const ScratchFolder& folder, const std::string& program, const std::string& words,
                   const std::string& named)
{
    const ProgramRun run = folder.run(program, "-output bad.png " + words);
    EXPECT_EQ(run.status, 1) << words;
    EXPECT_NE(run.errors.find(named), std::string::npos) << words << ": " << run.errors;
    EXPECT_EQ(std::count(run.errors.begin(), run.errors.end(), '\n'), 1) << run.errors;
    EXPECT_EQ(run.output, "") << words;
    EXPECT_FALSE(std::filesystem::exists(folder / "bad.png")) << words;
}

std::string readFile(const std::filesystem::path& path)
{
    std::ifstream stream(path, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

int channel(const Picture& picture, int x, int y, int which)
{
    return picture.bytes[std::size_t((y * picture.width + x) * picture.channels + which)];
}

std::vector<float> pixelsOf(const Picture& picture)
{
    std::vector<float> pixels;
    for (int y = picture.height - 1; y >= 0; --y)
        for (int x = 0; x < picture.width; ++x) {
            for (int c = 0; c < 3; ++c)
                pixels.push_back(float(channel(picture, x, y, c)) / 255);
            pixels.push_back(1);
        }
    return pixels;
}

PictureDifference difference(const Picture& a, const Picture& b)
{
    PictureDifference result;
    if (a.bytes.size() != b.bytes.size()) return {255, a.width * a.height};
    for (std::size_t pixel = 0; pixel < a.bytes.size(); pixel += std::size_t(a.channels)) {
        int worst = 0;
        for (std::size_t i = pixel; i < pixel + 3; ++i)
            worst = std::max(worst, std::abs(a.bytes[i] - b.bytes[i]));
        result.largest = std::max(result.largest, worst);
        result.pixelsBeyondOne += worst > 1;
    }
    return result;
}

} // namespace vo
