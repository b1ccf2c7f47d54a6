#pragma once

#include "volume_io/volume_io.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// Programs of the project run as a user runs them, in a folder of their own.
namespace vo {

struct ProgramRun
{
    /// Exit status; -1 when a signal ended it.
    int status;
    std::string output;
    std::string errors;
};

/// A folder that is gone when this object is.
class ScratchFolder
{
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;

    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
    const std::filesystem::path& path() const { return path_; }

    /// Runs `program` (a path) with these words, none of which holds a quote, in this folder.
    /// `environment`: words NAME=VALUE.
    ProgramRun run(const std::string& program, const std::vector<std::string>& words,
                   const std::string& environment = "") const;
    /// Splits at spaces: run("voglBasic", "a.tif -2D"), a program of the build.
    ProgramRun run(const std::string& program, const std::string& words) const;

    /// Names of the files that lie here.
    std::vector<std::string> files() const;

private:
    std::filesystem::path path_;
};

/// Writes a TIFF of one channel whose voxel (x, y, z) is value(x, y, z).
void writeBytes(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                const std::function<int(int, int, int)>& value);
void writeShorts(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                 const std::function<int(int, int, int)>& value);

/// Writes bytes as NRRD, side by side as many channels as they are enough for.
void writeChannels(const std::filesystem::path& path, int xSize, int ySize, int zSize,
                   const std::string& voxels);

/// Writes 256 colours that change smoothly, opacity(v) at 0 <= v <= 1; returns the numbers that the file
/// holds.
std::vector<float> writeSmoothTable(const std::filesystem::path& path,
                                    const std::function<double(double)>& opacity);

/// Four floats a pixel, rows from the bottom, as OpenGL delivers them.
std::vector<float> pixelsOf(const Picture& picture);

/// What a run draws that must succeed; an empty picture where it leaves none.
struct DrawnPicture
{
    Picture picture;
    std::string printed; ///< on stdout

    std::vector<float> pixels() const { return pixelsOf(picture); }
};
/// -output is added to the words. `said`: what the run must say on stderr.
DrawnPicture drawnPicture(const ScratchFolder& folder, const std::string& program, const std::string& words,
                          const std::string& said = "");

/// A run that must fail with one line that holds `named`, and leave no picture.
void expectOneLine(const ScratchFolder& folder, const std::string& program, const std::string& words,
                   const std::string& named);

std::string readFile(const std::filesystem::path& path);

/// Red, green or blue of a pixel, y from the top.
int channel(const Picture& picture, int x, int y, int which);

/// The largest difference of a channel, and how many pixels differ by more than 1.
struct PictureDifference
{
    int largest = 0;
    int pixelsBeyondOne = 0;
};
PictureDifference difference(const Picture& a, const Picture& b);

} // namespace vo
