#include "x3d/scene_folders.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "x3d/printable_word.h"

namespace vo {
namespace {

namespace fs = std::filesystem;

/// The scheme before the colon; none in front of what is a path.
std::string_view schemeOf(std::string_view url)
{
    const auto colon = url.find(':');
    return colon == url.npos || url.find('/') < colon ? std::string_view() : url.substr(0, colon);
}

/// With %20 and the like decoded; nothing where that leads to a character that no path has.
std::optional<std::string> decoded(std::string_view url)
{
    std::string out;
    for (std::size_t i = 0; i < url.size(); ++i) {
        unsigned char letter = static_cast<unsigned char>(url[i]);
        if (letter == '%' && i + 2 < url.size()) {
            const char* const end = url.data() + i + 3;
            const auto parsed = std::from_chars(url.data() + i + 1, end, letter, 16);
            if (parsed.ec == std::errc() && parsed.ptr == end)
                i += 2;
            else
                letter = '%';
        }
        if (letter == 0) return {};
        out += static_cast<char>(letter);
    }
    return out;
}

} // namespace

bool SceneFolders::allow(const std::string& folder)
{
    std::error_code error;
    fs::path path = fs::canonical(folder.empty() ? fs::path(".") : fs::path(folder), error);
    if (error || !fs::is_directory(path, error)) return false;
    folders_.push_back(std::move(path));
    return true;
}

bool SceneFolders::isAllowed(const fs::path& path) const
{
    return std::ranges::any_of(folders_, [&](const fs::path& folder) {
        return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
    });
}

SceneFolders::Place SceneFolders::locate(std::string_view url, const fs::path& base) const
{
    const std::string shown = quotedWord(url);
    const std::string_view scheme = schemeOf(url);
    if (!scheme.empty() && scheme != "file")
        return {{}, shown + " is in a network or no file: not read", true};
    std::string_view rest = scheme.empty() ? url : url.substr(5);
    if (!scheme.empty() && rest.starts_with("//")) rest.remove_prefix(2);
    rest = rest.substr(0, rest.find('#'));
    const auto name = decoded(rest);
    if (!name || name->empty()) return {{}, shown + " names no file"};
    std::error_code error;
    const fs::path path = fs::canonical(base / *name, error);
    // What lies outside is not told apart from what is not there, or a scene could look for files.
    if (error) {
        const fs::path close = fs::weakly_canonical(base / *name, error);
        if (!error && isAllowed(close)) return {{}, shown + ": no such file"};
    } else if (isAllowed(path)) {
        return {path, ""};
    }
    return {{}, shown + " is not below the folder of the scene (-allow FOLDER lets it in)"};
}

} // namespace vo
