#include "vox3d_options.h"

#include "volume_view/frame_names.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

namespace vo {
namespace {

/// Takes the words of an option one after the other; the first that does not fit is kept as a failure.
class Words
{
public:
    Words(const std::vector<std::string>& words, std::size_t next) : words_(words), next_(next) {}

    std::string text(const char* what)
    {
        const std::string word = next_ < words_.size() ? words_[next_] : "";
        if (next_ >= words_.size())
            fail(what, "the end");
        else if (word.empty())
            fail(what, "\"\"");
        else if (isOption(word))
            fail(what, "the option " + word);
        ++next_;
        return word;
    }

    double number(double low, double high, const char* what)
    {
        const std::string word = text(what);
        double value = 0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error == std::errc() && end == word.data() + word.size() && value >= low && value <= high)
            return value;
        fail(what, "\"" + word + "\"");
        return low;
    }

    int whole(int low, int high, const char* what)
    {
        const double value = number(low, high, what);
        if (value != std::floor(value)) fail(what, "\"" + words_[next_ - 1] + "\"");
        return static_cast<int>(value);
    }

    void fail(const std::string& expected, const std::string& found)
    {
        if (failure_.empty()) failure_ = "expected " + expected + ", found " + found;
    }

    static bool isOption(const std::string& word);
    std::size_t next() const { return next_; }
    const std::string& failure() const { return failure_; }

private:
    const std::vector<std::string>& words_;
    std::size_t next_;
    std::string failure_;
};

struct Option
{
    const char* name;
    const char* arguments;
    /// Only volumes have it.
    bool isOfVolumes;
    const char* help;
    std::function<void(Vox3dOptions&, Words&)> read;
};

constexpr double kMost = 1e30;
/// A scene's clock tells milliseconds apart up to here.
constexpr double kMostSeconds = 1e12;

void readEngine(Vox3dOptions& to, Words& words)
{
    const std::string name = words.text("slices or cast");
    if (name == "slices")
        to.engine = Vox3dOptions::Engine::slices;
    else if (name == "cast")
        to.engine = Vox3dOptions::Engine::cast;
    else
        words.fail("slices or cast", "\"" + name + "\"");
}

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

void readStyle(Vox3dOptions& to, Words& words)
{
    to.style = words.text("a style");
    if (std::ranges::find(styleNames(), to.style) == styleNames().end())
        words.fail("a style (" + listed(styleNames()) + ")", "\"" + to.style + "\"");
}

void readOutput(Vox3dOptions& to, Words& words)
{
    to.output = words.text("a file name");
    if (!to.output.ends_with(".png")) words.fail("a file name that ends in .png", "\"" + to.output + "\"");
}

const std::vector<Option>& options()
{
    static const std::vector<Option> all = {
        {"-output", "FILE.png", false,
         "write a picture; neither a window nor OpenGL is needed, unless\n-engine slices asks for it",
         readOutput},
        {"-size", "W H", false, "pixels of the picture or the window (default 512 512)",
         [](auto& to, auto& words) {
             to.width = words.whole(1, 32768, "a width from 1 to 32768");
             to.height = words.whole(1, 32768, "a height from 1 to 32768");
         }},
        {"-viewpoint", "NAME", false,
         "see the scene from this viewpoint: its DEF name, its description, or\nits number from 1",
         [](auto& to, auto& words) { to.viewpoint = words.text("the name of a viewpoint"); }},
        {"-frames", "N", false,
         "N pictures over the longest cycle of the scene's TimeSensors, or a turn\n"
         "round a scene that has none; FILE.png has a %d or %03d for their number",
         [](auto& to, auto& words) { to.frames = words.whole(1, 1000000, "a number of frames"); }},
        {"-time", "SECONDS", false, "the time of the (first) picture on the scene's clock (default 0)",
         [](auto& to, auto& words) {
             to.time = words.number(-kMostSeconds, kMostSeconds, "a time from -1e12 to 1e12 seconds");
         }},
        {"-engine", "slices|cast", false,
         "draw by slices in OpenGL, or by rays on the processor (default: in a\n"
         "picture cast, in a window slices where OpenGL has hardware)",
         readEngine},
        {"-sampling", "PERIOD", false,
         "distance of the sampling planes, in shortest edges of a voxel, 0.01 to 100\n"
         "(default 1, and 0.5 where styles go by normals); half takes twice as long",
         [](auto& to, auto& words) { to.sampling = words.number(0.01, 100, "a distance from 0.01 to 100"); }},
        {"-check", "", false, "list what is unsupported or wrong, with its file and line",
         [](auto& to, auto&) { to.check = true; }},
        {"-save", "OUT", false, "write the scene: ClassicVRML where OUT ends with .x3dv, XML otherwise",
         [](auto& to, auto& words) { to.save = words.text("a file name"); }},
        {"-allow", "FOLDER", false, "let the scene name files in and below this folder, too",
         [](auto& to, auto& words) { to.allowed.push_back(words.text("a folder")); }},
        {"-style", "NAME", true, nullptr, readStyle},
        {"-lut", "CENTER WIDTH", true,
         "where values of the file become opaque: 0 up to CENTER - WIDTH / 2,\n"
         "full from CENTER + WIDTH / 2 (default: found from the values)",
         [](auto& to, auto& words) {
             const double center = words.number(-kMost, kMost, "a center from -1e30 to 1e30");
             to.lut = {center, words.number(1e-30, kMost, "a width from 1e-30 to 1e30")};
         }},
        {"-lutFile", "FILE", true, "colours and opacities from a table, as voglBasic takes it",
         [](auto& to, auto& words) { to.lutFile = words.text("a file name"); }},
        {"-labels", "FILE", true,
         "a volume of numbers: each voxel has the colour of its number, also in the\n"
         "tones of cartoon and tone; 0: not drawn; not for iso, projection, stipple",
         [](auto& to, auto& words) { to.labels = words.text("a file name"); }},
        {"-view", "LATITUDE LONGITUDE", true,
         "degrees (default 0 180, the face, where the file says how the patient\nlies; else 0 0)",
         [](auto& to, auto& words) {
             const double latitude = words.number(-90, 90, "a latitude from -90 to 90");
             to.view = {latitude, words.number(-kMost, kMost, "a longitude from -1e30 to 1e30")};
         }},
    };
    return all;
}

bool Words::isOption(const std::string& word)
{
    return std::ranges::find(options(), word, &Option::name) != options().end();
}

Result<void> checkTogether(const Vox3dOptions& options)
{
    if (options.input.empty())
        return Failure{"expected a scene or a volume, found none; vox3d -help shows examples"};
    if (options.frames > 0 && options.output.empty())
        return Failure{"option -frames: expected -output FILE.png beside it, found none"};
    if (options.frames > 1) return checkNumbered("-output", options.output);
    return options.frames > 0 ? checkFrameName("-output", options.output) : Result<void>();
}

} // namespace

const std::vector<std::string>& styleNames()
{
    static const std::vector<std::string> names = {"opacity",    "boundary", "cartoon", "edge",
                                                   "silhouette", "tone",     "shaded",  "iso",
                                                   "projection", "stipple",  "blended", "composed"};
    return names;
}

Result<Vox3dOptions> parseVox3dOptions(const std::vector<std::string>& words)
{
    Vox3dOptions parsed;
    bool areOptions = true;
    for (std::size_t i = 0; i < words.size();) {
        const std::string& word = words[i++];
        if (areOptions && word == "--") {
            areOptions = false;
        } else if (areOptions && word.size() > 1 && word.starts_with('-')) {
            const auto option = std::ranges::find(options(), word, &Option::name);
            if (option == options().end())
                return Failure{"expected an option that vox3d -help lists, found \"" + word + "\""};
            Words rest(words, i);
            option->read(parsed, rest);
            if (!rest.failure().empty()) return Failure{"option " + word + ": " + rest.failure()};
            i = rest.next();
            if (option->isOfVolumes && parsed.ofVolumes.empty()) parsed.ofVolumes = word;
        } else if (!parsed.input.empty()) {
            return Failure{"expected one scene or volume, found \"" + parsed.input + "\" and \"" + word +
                           "\""};
        } else {
            parsed.input = word;
        }
    }
    if (auto together = checkTogether(parsed); !together) return together.failure();
    return parsed;
}

std::string vox3dHelp()
{
    std::string text = R"(Usage: vox3d [OPTION...] SCENE
       vox3d [OPTION...] VOLUME

Shows a scene of X3D with volumes, in a window or in a picture: XML (.x3d) or
ClassicVRML (.x3dv), compressed by gzip or not. A volume, of any format that
volinfo knows, is shown in a scene that is made for it.

Examples:
    vox3d head.x3d
    vox3d head.x3d -viewpoint Front -size 800 600 -output front.png
    vox3d heart.x3d -frames 50 -output beat%03d.png
    vox3d head.nii -style cartoon -output head.png
    vox3d head.nii -style edge -save head.x3d
    vox3d head.x3d -check
    vox3d head.x3dv -save head.x3d

Files that a scene names are read in and below its own folder; nothing is
fetched from a network.

)";
    const auto print = [&text](const Option& option, const std::string& help) {
        std::string head = std::string("  ") + option.name + " " + option.arguments;
        head.resize(std::max<std::size_t>(head.size() + 1, 22), ' ');
        text += head;
        for (const char letter : help) {
            text += letter;
            if (letter == '\n') text.append(22, ' ');
        }
        text += "\n";
    };
    for (const Option& option : options())
        if (!option.isOfVolumes) print(option, option.help);
    text += "  -help               print this text\n  -version            print the version\n\nOf volumes:\n";
    for (const Option& option : options())
        if (option.isOfVolumes)
            print(option, option.help ? option.help
                                      : "opacity (default), boundary, cartoon, edge, silhouette, tone,\n"
                                        "shaded, iso, projection, stipple, blended or composed");
    return text;
}

} // namespace vo
