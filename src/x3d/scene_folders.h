#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace vo {

/// The folders whose files a scene may name.
class SceneFolders
{
public:
    /// Lets a scene name files in and below a folder. Whether it exists.
    bool allow(const std::string& folder);

    struct Place
    {
        /// Without links; empty where there is none.
        std::filesystem::path path;
        /// Why there is none.
        std::string reason;
        /// Whether it lies in a network.
        bool isRemote = false;
    };
    /// Where the file of a url lies that stands in a file of the folder `base`. Links are followed before the
    /// folder is looked at.
    Place locate(std::string_view url, const std::filesystem::path& base) const;

private:
    bool isAllowed(const std::filesystem::path& path) const;

    std::vector<std::filesystem::path> folders_; // without links
};

} // namespace vo
