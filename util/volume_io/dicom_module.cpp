#include "dicom_slice.h"

#include <dlfcn.h>
#include <filesystem>

namespace vo {
namespace {

constexpr const char* kLibrary = "libvolumizer-dicom.so";

/// Folders of this code and of the program, and where their libraries lie as seen from there.
std::vector<std::filesystem::path> likelyFolders()
{
    static const char here = 0;
    std::vector<std::filesystem::path> homes;
    std::error_code none;
    if (Dl_info found; ::dladdr(&here, &found) && found.dli_fname)
        homes.push_back(std::filesystem::path(found.dli_fname).parent_path());
    homes.push_back(std::filesystem::read_symlink("/proc/self/exe", none).parent_path());
    std::vector<std::filesystem::path> folders;
    for (const auto& home : homes)
        if (!home.empty()) folders.insert(folders.end(), {home, home / VOLUMIZER_LIBRARIES, home / "../lib"});
    return folders;
}

const DicomFunctions* load()
{
    void* library = nullptr;
    for (const auto& folder : likelyFolders())
        if (!library) library = ::dlopen((folder / kLibrary).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
    return library ? static_cast<const DicomFunctions*>(::dlsym(library, "volumizerDicom")) : nullptr;
}

const DicomFunctions* functions()
{
    static const DicomFunctions* const loaded = load();
    return loaded;
}

Failure missing(const std::string& path)
{
    return {path + ": DICOM files need the library " + kLibrary +
            ", expected beside the programs' libraries, found none that loads"};
}

} // namespace

std::vector<DicomHeader> readDicomHeaders(const std::vector<std::string>& paths)
{
    if (functions()) return functions()->readHeaders(paths);
    std::vector<DicomHeader> headers;
    for (const std::string& path : paths)
        headers.emplace_back(missing(path));
    return headers;
}

Result<void> readDicomPixels(const std::vector<DicomSlice>& slices, std::span<std::byte> out)
{
    if (functions()) return functions()->readPixels(slices, out);
    return missing(slices.empty() ? "DICOM" : slices.front().path);
}

} // namespace vo
