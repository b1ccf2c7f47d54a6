#pragma once

#include "volume_io/result.h"

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// The command line of the vogl programs (guide, page 159).
namespace vo {

/// Which options a program takes: voglSimple a few, all others all of them.
enum class OptionSet { Simple, All };

struct Options
{
    enum class Engine { Slices, Cast };
    struct DataRange
    {
        double low;
        double high;
    };
    struct Ramp
    {
        double center;
        double width;
    };

    /// What is no option and no argument of one, in order.
    std::vector<std::string> files;

    // The guide's options.
    int textureDimensions = 3;
    /// RGBA (true) or grey scale (false); unset: as the table file suggests.
    std::optional<bool> color;
    /// In values of the file, low < high; unset: see -help.
    std::optional<DataRange> dataRange;
    /// In values of the file, width > 0.
    std::optional<Ramp> lut;
    std::string lutFile;
    int tessellationSize = 8;

    // Ours.
    std::string output;
    int width = 512;
    int height = 512;
    /// Degrees.
    double latitude = 0;
    double longitude = 0;
    /// Spacing of the voxels along x, y, z; unset: the file's.
    std::optional<std::array<double, 3>> scale;
    /// Bricks along x, y, z; unset: as few as textures allow.
    std::optional<std::array<int, 3>> bricks;
    /// Voxels that adjacent bricks share.
    int overlap = 1;
    bool viewSpace = false;
    /// Distance of the sampling planes, in scaled units.
    double sampling = 1;
    /// Degrees of the whole angle; 0: orthographic.
    double perspective = 0;
    /// Sampling surfaces are shells round the eye instead of planes.
    bool shells = false;
    /// Who draws frames by one call of drawUtility; unset: the program polygonizes and draws slices itself.
    std::optional<Engine> engine;
    /// 0: none to time.
    int frames = 0;
    bool mip = false;
    bool core = false;
    bool wireframe = false;
    bool help = false;
    bool version = false;
};

/// Arguments of one option, taken one after the other; the first one that does not fit is kept as a failure.
class Arguments
{
public:
    Arguments(const char* option, std::span<const char* const> words) : option_(option), words_(words) {}

    /// A number from low to high; what says which one, for the message.
    double number(double low, double high, const char* what = "a number");
    int integer(int low, int high, const char* what);
    std::string text() { return words_[next_++]; }
    /// What was typed, all arguments.
    std::string typed() const;
    void fail(const std::string& expected, const std::string& found);
    const std::optional<Failure>& failure() const { return failure_; }

private:
    const char* option_;
    std::span<const char* const> words_;
    std::size_t next_ = 0;
    std::optional<Failure> failure_;
};

/// An option that one program alone takes, or takes in its own way: then it has the name of a shared one.
struct OwnOption
{
    /// Without the dash.
    const char* name;
    /// Names of its arguments, as -help prints them.
    std::vector<const char*> arguments;
    /// Null: -help does not show it.
    const char* help;
    std::function<void(Arguments&)> read;
};

/// Reads the words after the program's name. An option may be abbreviated; the guide's options come before
/// ours, and of several that fit the first in lexicographic order is taken. An option takes its arguments by
/// count, whatever they look like; of an option given twice the last one counts. `--` ends the options. A
/// failure names the option, what it expects and what was found.
Result<Options> parseOptions(std::span<const char* const> words, OptionSet set,
                             std::span<const OwnOption> own = {});

/// The options one by one, as -help prints them.
std::string optionsHelp(OptionSet set, std::span<const OwnOption> own = {});

/// Writes out what is left of standard output: 0, or 1 after one line on stderr when it did not all arrive.
int flushOutput(const char* program);

} // namespace vo
