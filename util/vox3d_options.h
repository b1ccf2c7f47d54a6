#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "volume_io/result.h"

namespace vo {

/// The command line of vox3d.
struct Vox3dOptions
{
    enum class Engine { automatic, slices, cast };

    /// A scene, or a volume.
    std::string input;
    std::vector<std::string> allowed;
    bool check = false;
    std::string save, output;
    int width = 512, height = 512;
    std::string viewpoint;
    int frames = 0;
    double time = 0;
    /// Distance of sampling planes, in shortest edges of a voxel; 0: the view's own.
    double sampling = 0;
    Engine engine = Engine::automatic;

    // Of volumes.
    std::string style, labels, lutFile;
    struct Ramp
    {
        double center, width;
    };
    std::optional<Ramp> lut;
    /// Latitude and longitude.
    std::optional<std::array<double, 2>> view;

    /// The first option that only volumes have; empty: none was given.
    std::string ofVolumes;
};

/// The names of -style.
const std::vector<std::string>& styleNames();

/// Reads the words behind the program's name.
Result<Vox3dOptions> parseVox3dOptions(const std::vector<std::string>& words);

/// What -help prints.
std::string vox3dHelp();

} // namespace vo
