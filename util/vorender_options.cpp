#include "vorender_options.h"

#include "volume_view/frame_names.h"

#include <algorithm>
#include <climits>

namespace vo {
namespace {

bool endsWith(std::string name, const std::string& ending)
{
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return name.size() > ending.size() && name.ends_with(ending);
}

std::string pictureName(Arguments& arguments)
{
    const std::string name = arguments.text();
    if (!endsWith(name, ".png") && !isRawName(name))
        arguments.fail("a file name that ends in .png or .raw", name);
    return name;
}

void readRaw(RawLayout& layout, Arguments& arguments)
{
    for (const std::size_t axis : {0u, 1u, 2u})
        layout.info.size[axis] = arguments.integer(1, INT_MAX, "a number of voxels");
    const std::string name = arguments.text();
    if (const auto type = rawChannelType("", name)) {
        layout.info.type = *type;
    } else {
        arguments.fail("char, uchar, ubyte, short, ushort or float", name);
    }
}

/// An option of voglBasic that does nothing without OpenGL.
OwnOption needsOpenGl(const char* name, std::vector<const char*> words = {})
{
    return {name, std::move(words), nullptr, [](Arguments& arguments) {
                arguments.fail("a program that draws with OpenGL, such as voglBasic", "vorender");
            }};
}

/// What the options of files without a format are read into: they may come in any order.
struct RawWords
{
    RawLayout layout;
    bool sized = false;
    const char* other = nullptr; // an option that says more of the layout
};

std::vector<OwnOption> ownOptions(VorenderOptions& to, RawWords& raw)
{
    return {
        {"output",
         {"FILE"},
         "the picture: FILE.png, or FILE.raw for floats (4 a pixel, see the manual)",
         [&](Arguments& a) { to.output = pictureName(a); }},
        {"depth",
         {"FILE"},
         "depths where opacity reaches one half: FILE.png (16 bits, white is far) or FILE.raw (a float a\n"
         "pixel, 1 is far)",
         [&](Arguments& a) { to.depth = pictureName(a); }},
        {"frames",
         {"N"},
         "turn once round in N frames; a file name with a %d or %03d gets a picture of each, numbered from "
         "0, any\n"
         "other the view alone",
         [&](Arguments& a) { to.frames = a.integer(1, 1000000, "a number of frames"); }},
        {"raw",
         {"X", "Y", "Z", "TYPE"},
         "the file holds nothing but so many voxels, x fastest, of TYPE char, uchar (or ubyte), short,\n"
         "ushort or float; several files: one a slice",
         [&](Arguments& a) {
             readRaw(raw.layout, a);
             raw.sized = true;
         }},
        {"header",
         {"BYTES"},
         "with -raw: bytes passed over at the start of each file (default 0)",
         [&](Arguments& a) {
             raw.layout.headerLength = a.integer(0, INT_MAX, "a number of bytes");
             raw.other = "-header";
         }},
        {"channels",
         {"N"},
         "with -raw: 1 (default), 2 (luminance, alpha), 3 (RGB) or 4 (RGBA), side by side",
         [&](Arguments& a) {
             raw.layout.info.channels = a.integer(1, 4, "a number of channels");
             raw.other = "-channels";
         }},
        {"bigEndian",
         {},
         "with -raw: the highest byte comes first",
         [&](Arguments&) {
             raw.layout.byteOrder = ByteOrder::bigEndian;
             raw.other = "-bigEndian";
         }},
        needsOpenGl("wireframe"),
        needsOpenGl("core"),
        needsOpenGl("engine", {"slices|cast"}),
    };
}

std::string listed(const std::vector<std::string>& files)
{
    std::string text;
    for (const std::string& file : files)
        text += " " + file;
    return text.empty() ? " none" : ":" + text;
}

Result<void> checkTogether(const VorenderOptions& options, const RawWords& raw)
{
    if (!raw.sized && raw.other)
        return Failure{std::string("option ") + raw.other +
                       ": expected -raw X Y Z TYPE beside it, found none"};
    const auto& files = options.view.files;
    if (files.empty() || (files.size() > 1 && !raw.sized))
        return Failure{"expected the file of one volume (-help says more), found" + listed(files)};
    if (options.output.empty() && options.depth.empty())
        return Failure{"expected -output FILE.png, -output FILE.raw or -depth FILE, found none of them"};
    if (options.frames > 0) {
        if (auto named = checkFrameName("-output", options.output); !named) return named;
        if (auto named = checkFrameName("-depth", options.depth); !named) return named;
    }
    if (options.view.shells && options.view.textureDimensions == 2)
        return Failure{"option -shells: expected 3D textures, found -2D"};
    return {};
}

} // namespace

bool isRawName(const std::string& name)
{
    return endsWith(name, ".raw");
}

int pictureCount(const VorenderOptions& options)
{
    const bool everyFrame = isNumbered(options.output) || isNumbered(options.depth);
    return options.frames > 0 && everyFrame ? options.frames : 1;
}

std::vector<NamedPictures> pictureNames(const VorenderOptions& options)
{
    std::vector<NamedPictures> pictures;
    for (const auto& [option, name] : {std::pair("-output", options.output), {"-depth", options.depth}}) {
        if (name.empty()) continue;
        const int count = options.frames > 0 && isNumbered(name) ? options.frames : 1;
        NamedPictures& named = pictures.emplace_back(NamedPictures{option, {}});
        for (int frame = 0; frame < count; ++frame)
            named.names.push_back(frameName(name, options.frames, frame));
    }
    return pictures;
}

Result<VorenderOptions> parseVorenderOptions(const std::vector<std::string>& words)
{
    VorenderOptions options;
    RawWords raw;
    std::vector<const char*> arguments;
    for (const std::string& word : words)
        arguments.push_back(word.c_str());
    auto view = parseOptions(arguments, OptionSet::All, ownOptions(options, raw));
    if (!view) return view.failure();
    options.view = std::move(*view);
    if (auto fit = checkTogether(options, raw); !fit) return fit.failure();
    if (raw.sized) options.raw = raw.layout;
    return options;
}

std::string vorenderOptionsHelp()
{
    VorenderOptions options;
    RawWords raw;
    return optionsHelp(OptionSet::All, ownOptions(options, raw));
}

} // namespace vo
