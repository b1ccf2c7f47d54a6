#pragma once

#include "volume_io/volume_io.h"
#include "volume_view/frame_names.h"
#include "volume_view/options.h"

#include <optional>
#include <string>
#include <vector>

/// The command line of vorender.
namespace vo {

struct VorenderOptions
{
    /// Those that voglBasic has too; `files` and all that needs no OpenGL.
    Options view;
    /// The picture: .png, or .raw for floats. Empty: none.
    std::string output;
    /// The depths: .png or .raw. Empty: none.
    std::string depth;
    /// Frames of a turn; 0: the view alone.
    int frames = 0;
    /// How files without a format of their own are laid out.
    std::optional<RawLayout> raw;
};

/// Whether a file name asks for floats instead of a PNG.
bool isRawName(const std::string& name);

/// How many frames have to be drawn: those of the turn where a name has a number, else the view alone.
int pictureCount(const VorenderOptions& options);

/// All files that are to be written, by option.
std::vector<NamedPictures> pictureNames(const VorenderOptions& options);

Result<VorenderOptions> parseVorenderOptions(const std::vector<std::string>& words);

/// What -help prints of the options.
std::string vorenderOptionsHelp();

} // namespace vo
