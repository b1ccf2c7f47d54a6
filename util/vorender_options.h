#pragma once

#include "volume_io/volume_io.h"
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
    /// Pictures of a turn; 0: one, of the view alone.
    int frames = 0;
    /// How files without a format of their own are laid out.
    std::optional<RawLayout> raw;
};

/// Whether a file name asks for floats instead of a PNG.
bool isRawName(const std::string& name);

/// The name of a picture of a turn: that with its number, from 0, in place of %d. Without a turn the name
/// itself.
std::string frameName(const VorenderOptions& options, const std::string& name, int frame);

Result<VorenderOptions> parseVorenderOptions(const std::vector<std::string>& words);

/// What -help prints of the options.
std::string vorenderOptionsHelp();

} // namespace vo
