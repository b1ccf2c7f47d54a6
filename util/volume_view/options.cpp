#include "options.h"

#include <algorithm>
#include <charconv>
#include <climits>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <strings.h>

namespace vo {

double Arguments::number(double low, double high, const char* what)
{
    const std::string word = text();
    double value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    const bool isNumber = code != std::errc::invalid_argument && end == word.data() + word.size();
    if (!isNumber || code != std::errc() || !(value >= low && value <= high)) {
        char bounds[80];
        std::snprintf(bounds, sizeof bounds, " from %g to %g", low, high);
        fail(what + std::string(bounds), word);
    }
    return value;
}

int Arguments::integer(int low, int high, const char* what)
{
    const std::string word = text();
    int value = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (code != std::errc() || end != word.data() + word.size() || value < low || value > high) {
        fail(std::string(what) + " from " + std::to_string(low) + " to " + std::to_string(high), word);
    }
    return value;
}

std::string Arguments::typed() const
{
    std::string line;
    for (const char* word : words_)
        line.append(line.empty() ? "" : " ").append(word);
    return line;
}

void Arguments::fail(const std::string& expected, const std::string& found)
{
    if (!failure_) {
        failure_ =
            Failure{std::string("option -") + option_ + ": expected " + expected + ", found '" + found + "'"};
    }
}

namespace {

using Words = std::span<const char* const>;

enum class Home { Guide, Ours };

constexpr double kLargest = 1e9;
constexpr const char* kNumber = "a number";
constexpr double kSmallest = 1e-6;
/// A picture is held as floats: a gigabyte at most.
constexpr int kMostPixels = 1 << 26;

struct Option
{
    const char* name;
    /// Names of the arguments, as -help prints them.
    std::vector<const char*> arguments;
    Home home;
    OptionSet least;
    const char* help;
    std::function<void(Options&, Arguments&)> read;
};

void readDataRange(Options& options, Arguments& arguments)
{
    const double low = arguments.number(-3.5e38, 3.5e38, kNumber);
    const double high = arguments.number(-3.5e38, 3.5e38, kNumber);
    if (!(low < high)) arguments.fail("LOW below HIGH", arguments.typed());
    options.dataRange = Options::DataRange{low, high};
}

void readLut(Options& options, Arguments& arguments)
{
    const double center = arguments.number(-3.5e38, 3.5e38, kNumber);
    options.lut = Options::Ramp{center, arguments.number(1e-30, 3.5e38, kNumber)};
}

void readSize(Options& options, Arguments& arguments)
{
    options.width = arguments.integer(1, 16384, "a width in pixels");
    options.height = arguments.integer(1, 16384, "a height in pixels");
    if (std::int64_t(options.width) * options.height > kMostPixels) {
        arguments.fail("at most " + std::to_string(kMostPixels) + " pixels in all", arguments.typed());
    }
}

bool isOptionName(const std::string& word);

void readOutput(Options& options, Arguments& arguments)
{
    const std::string name = arguments.text();
    const std::string ending = ".png";
    const bool isPng = name.size() > ending.size() &&
                       strcasecmp(name.c_str() + name.size() - ending.size(), ending.c_str()) == 0;
    if (!isPng && !isOptionName(name)) arguments.fail("a file name that ends in .png", name);
    options.output = name;
}

void readView(Options& options, Arguments& arguments)
{
    options.latitude = arguments.number(-kLargest, kLargest, "a latitude in degrees");
    options.longitude = arguments.number(-kLargest, kLargest, "a longitude in degrees");
}

void readScale(Options& options, Arguments& arguments)
{
    for (double& spacing : options.scale.emplace())
        spacing = arguments.number(kSmallest, kLargest, kNumber);
}

void readBricks(Options& options, Arguments& arguments)
{
    auto& bricks = options.bricks.emplace();
    for (int& count : bricks)
        count = arguments.integer(1, 1024, "a number of bricks");
}

void readSpace(Options& options, Arguments& arguments)
{
    const std::string word = arguments.text();
    if (word != "object" && word != "view") arguments.fail("object or view", word);
    options.viewSpace = word == "view";
}

void readEngine(Options& options, Arguments& arguments)
{
    const std::string word = arguments.text();
    if (word != "slices" && word != "cast") arguments.fail("slices or cast", word);
    options.engine = word == "cast" ? Options::Engine::Cast : Options::Engine::Slices;
}

/// Every option of the programs, in the order of -help.
const std::vector<Option>& optionTable()
{
    using enum Home;
    using enum OptionSet;
    static const std::vector<Option> table{
        {"2D",
         {},
         Guide,
         All,
         "draw with stacks of 2D textures, one for each axis",
         [](Options& o, Arguments&) { o.textureDimensions = 2; }},
        {"3D",
         {},
         Guide,
         All,
         "draw with 3D textures (the default)",
         [](Options& o, Arguments&) { o.textureDimensions = 3; }},
        {"color",
         {},
         Guide,
         All,
         "draw in RGBA (the default with a table of colours)",
         [](Options& o, Arguments&) { o.color = true; }},
        {"dataRange",
         {"LOW", "HIGH"},
         Guide,
         All,
         "values of the file that the table begins and ends at (default: all values of 8-bit types, else "
         "the\n"
         "smallest and the largest in the file)",
         readDataRange},
        {"lut",
         {"CENTER", "WIDTH"},
         Guide,
         All,
         "a grey ramp over these values of the file (default: over the whole data range)",
         readLut},
        {"lutFile",
         {"FILE"},
         Guide,
         All,
         "read the table from FILE; goes before -lut, and the middle mouse button does nothing",
         [](Options& o, Arguments& a) { o.lutFile = a.text(); }},
        {"monochrome",
         {},
         Guide,
         All,
         "draw in grey scale (the default without a table of colours)",
         [](Options& o, Arguments&) { o.color = false; }},
        {"tessellationSize",
         {"N"},
         Guide,
         All,
         "voxels along a sub-cube of voglSpaceLeap; without effect elsewhere",
         [](Options& o, Arguments& a) { o.tessellationSize = a.integer(1, INT_MAX, "a number of voxels"); }},
        {"output",
         {"FILE.png"},
         Ours,
         Simple,
         "draw into a picture, without a window (without a display and -output: into PROGRAM.png)",
         readOutput},
        {"size",
         {"W", "H"},
         Ours,
         Simple,
         "pixels of the window or picture, at most 16384 a side and 67108864 in all (default 512 512)",
         readSize},
        {"view",
         {"LATITUDE", "LONGITUDE"},
         Ours,
         Simple,
         "degrees the volume is turned by (default 0 0); positive latitudes look from below, as in\n"
         "the guide: -view -30 150 looks down",
         readView},
        {"scale",
         {"X", "Y", "Z"},
         Ours,
         All,
         "spacing of the voxels (default: the file's, the smallest 1; without one in the file 1 1 1)",
         readScale},
        {"bricks",
         {"X", "Y", "Z"},
         Ours,
         All,
         "cut the volume into bricks of one size, at most so many along each axis and 4096 in all (default: "
         "as\n"
         "few as fit)",
         readBricks},
        {"overlap",
         {"N"},
         Ours,
         All,
         "voxels that adjacent bricks share (default 1)",
         [](Options& o, Arguments& a) { o.overlap = a.integer(0, 1024, "a number of voxels"); }},
        {"space",
         {"object|view"},
         Ours,
         All,
         "spread the sampling planes over the volume (the default) or over the view volume",
         readSpace},
        {"sampling",
         {"PERIOD"},
         Ours,
         All,
         "distance of the sampling planes, in units of -scale (default 1); at most 65536 planes",
         [](Options& o, Arguments& a) { o.sampling = a.number(kSmallest, kLargest, kNumber); }},
        {"perspective",
         {"DEGREES"},
         Ours,
         All,
         "look from a point, with this angle over the smaller side (default: orthographic)",
         [](Options& o, Arguments& a) { o.perspective = a.number(0.1, 170, "an angle in degrees"); }},
        {"shells",
         {},
         Ours,
         All,
         "sample on shells round the eye instead of planes: the same distance on every ray; with "
         "-perspective",
         [](Options& o, Arguments&) { o.shells = true; }},
        {"frames",
         {"N"},
         Ours,
         All,
         "turn once round in N frames and print the median time of a frame; an -output with a %d or %03d "
         "gets\n"
         "a picture of each, numbered from 0, any other the view alone; without -output there is none",
         [](Options& o, Arguments& a) { o.frames = a.integer(1, 1000000, "a number of frames"); }},
        {"engine",
         {"slices|cast"},
         Ours,
         All,
         "draw each frame by one call of the library: as slices through OpenGL, or computed by the CPU\n"
         "engine (default: the program's own loop over slices)",
         readEngine},
        {"mip",
         {},
         Ours,
         All,
         "show the largest value along each ray",
         [](Options& o, Arguments&) { o.mip = true; }},
        {"wireframe",
         {},
         Ours,
         Simple,
         "outline the tetrahedra in yellow and the bricks in blue",
         [](Options& o, Arguments&) { o.wireframe = true; }},
        {"core",
         {},
         Ours,
         All,
         "ask for an OpenGL context of the core profile",
         [](Options& o, Arguments&) { o.core = true; }},
        {"help", {}, Ours, Simple, "print this text", [](Options& o, Arguments&) { o.help = true; }},
        {"version",
         {},
         Ours,
         Simple,
         "print the version of the library; not abbreviable",
         [](Options& o, Arguments&) { o.version = true; }},
    };
    return table;
}

bool isOptionName(const std::string& word)
{
    return word.starts_with('-') && std::ranges::any_of(optionTable(), [&](const Option& option) {
               return word.substr(1) == option.name;
           });
}

bool takes(OptionSet set, const Option& option)
{
    return set == OptionSet::All || option.least == OptionSet::Simple;
}

Option ownOption(const OwnOption& own, Home home)
{
    return {own.name, own.arguments,
            home,     OptionSet::Simple,
            own.help, [read = own.read](Options&, Arguments& arguments) { read(arguments); }};
}

/// The options of a program: its own in place of those of the same name, the others before the last two,
/// which every program ends its list with.
std::vector<Option> optionsOf(OptionSet set, std::span<const OwnOption> own)
{
    std::vector<Option> table;
    const auto named = [&](const std::string& name) {
        return std::ranges::find_if(own, [&](const OwnOption& o) { return o.name == name; });
    };
    const auto isShared = [](const OwnOption& o) {
        return std::ranges::any_of(optionTable(),
                                   [&](const Option& option) { return std::string(option.name) == o.name; });
    };
    for (const Option& option : optionTable()) {
        if (std::string(option.name) == "help") {
            for (const OwnOption& o : own)
                if (!isShared(o)) table.push_back(ownOption(o, Home::Ours));
        }
        const auto instead = named(option.name);
        if (instead != own.end()) {
            table.push_back(ownOption(*instead, option.home));
        } else if (takes(set, option)) {
            table.push_back(option);
        }
    }
    return table;
}

/// The option that `name` (no dash) spells or abbreviates; null if there is none.
const Option* findOption(const std::string& name, const std::vector<Option>& table)
{
    const Option* found = nullptr;
    for (const Option& option : table) {
        const std::string full = option.name;
        if (full == name) return &option;
        // -v is a view: nobody abbreviates a version.
        if (name.empty() || !full.starts_with(name) || full == "version") continue;
        // The guide's options come first in the table.
        const bool better = !found || (option.home == found->home && full < found->name);
        if (better) found = &option;
    }
    return found;
}

std::string argumentNames(const Option& option)
{
    std::string names;
    for (const char* name : option.arguments)
        names.append(names.empty() ? "" : " ").append(name);
    return names;
}

Failure missingArguments(const Option& option, Words found)
{
    std::string words;
    for (const char* word : found)
        words.append(words.empty() ? "'" : " ").append(word);
    return {std::string("option -") + option.name + ": expected " + argumentNames(option) + ", found " +
            (words.empty() ? "nothing" : words + "'")};
}

} // namespace

Result<Options> parseOptions(std::span<const char* const> words, OptionSet set,
                             std::span<const OwnOption> own)
{
    const std::vector<Option> table = optionsOf(set, own);
    Options options;
    bool optionsEnded = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string word = words[i];
        if (optionsEnded || !word.starts_with('-')) {
            options.files.push_back(word);
            continue;
        }
        if (word == "--") {
            optionsEnded = true;
            continue;
        }
        const Option* option = findOption(word.substr(word.starts_with("--") ? 2 : 1), table);
        if (!option) return Failure{"expected an option (-help lists them), found '" + word + "'"};
        const std::size_t count = option->arguments.size();
        const Words rest = words.subspan(i + 1);
        if (rest.size() < count) return missingArguments(*option, rest);
        Arguments arguments(option->name, rest.first(count));
        option->read(options, arguments);
        if (arguments.failure()) return *arguments.failure();
        i += count;
    }
    return options;
}

std::string optionsHelp(OptionSet set, std::span<const OwnOption> own)
{
    constexpr std::size_t kColumn = 28;
    std::string text;
    for (const Option& option : optionsOf(set, own)) {
        if (!option.help) continue;
        std::string line = std::string("  -") + option.name + " " + argumentNames(option);
        line.resize(std::max(line.size() + 1, kColumn), ' ');
        for (const char* at = option.help; *at; ++at)
            line.append(1, *at).append(*at == '\n' ? kColumn : 0, ' ');
        text += line + "\n";
    }
    return text;
}

int flushOutput(const char* program)
{
    // Both: an earlier write may have failed already.
    const bool flushed = std::fflush(stdout) == 0;
    if (flushed && !std::ferror(stdout)) return 0;
    std::fprintf(stderr, "%s: cannot write to standard output\n", program);
    return 1;
}

} // namespace vo
