#include "frame_names.h"

#include "volume_io/numbered_name.h"

#include <filesystem>
#include <unordered_map>

namespace vo {
namespace {

namespace fs = std::filesystem;

/// Finds the file that a name leads to. Folders are looked up once: a turn may have many pictures.
class Destinations
{
public:
    std::string of(const std::string& name)
    {
        std::error_code error;
        const fs::path path(name);
        if (fs::is_symlink(fs::symlink_status(path, error)))
            if (const fs::path target = fs::canonical(path, error); !error) return target.string();
        return (folder(path.parent_path().string()) / path.filename()).string();
    }

private:
    const fs::path& folder(const std::string& name)
    {
        const auto [entry, isNew] = folders_.try_emplace(name);
        std::error_code error;
        if (isNew) entry->second = fs::weakly_canonical(name.empty() ? "." : name, error);
        if (error) entry->second = name;
        return entry->second;
    }

    std::unordered_map<std::string, fs::path> folders_;
};

} // namespace

bool isNumbered(const std::string& name)
{
    return numberedName(name, 0).has_value();
}

Result<void> checkNumbered(const char* option, const std::string& name)
{
    if (isNumbered(name)) return {};
    return Failure{std::string("option ") + option +
                   ": expected a name with a %d or %03d for the number of each of the -frames, found '" +
                   name + "'"};
}

Result<void> checkFrameName(const char* option, const std::string& name)
{
    return name.find('%') == std::string::npos ? Result<void>() : checkNumbered(option, name);
}

std::string frameName(const std::string& name, int frames, int frame)
{
    return frames == 0 ? name : numberedName(name, frame).value_or(name);
}

Result<void> checkNamesDiffer(const std::vector<NamedPictures>& pictures)
{
    Destinations destinations;
    std::unordered_map<std::string, const char*> options; // of each destination
    for (const auto& [option, names] : pictures)
        for (const std::string& name : names) {
            const auto [entry, isNew] = options.emplace(destinations.of(name), option);
            if (isNew) continue;
            const bool same = std::string(entry->second) == option;
            return Failure{std::string("option ") + option + ": expected another file than that of " +
                           (same ? "another frame" : entry->second) + ", found '" + name + "'"};
        }
    return {};
}

} // namespace vo
