#include "x3d/scene_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <memory>
#include <string_view>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <zlib.h>

namespace vo {
namespace {

struct Descriptor
{
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor()
    {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int release() { return std::exchange(number_, -1); }
    int number_;
};

} // namespace

bool readSceneFile(const std::filesystem::path& path, std::int64_t most, std::string& text,
                   std::string& reason)
{
    // Without O_NONBLOCK the opening of a named pipe would wait for a writer.
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW));
    struct stat status = {};
    if (file.number_ < 0 || ::fstat(file.number_, &status) != 0) {
        reason = std::string("cannot open: ") + std::strerror(errno);
        return false;
    }
    if (!S_ISREG(status.st_mode)) {
        reason = "expected a regular file, found a folder, a device or the like";
        return false;
    }
    // gzread passes on what gzip did not make.
    const std::unique_ptr<gzFile_s, int (*)(gzFile)> stream(::gzdopen(file.number_, "rb"), ::gzclose);
    if (!stream) {
        reason = "cannot open: there is not enough memory";
        return false;
    }
    file.release();
    text.clear();
    char part[1 << 16];
    int count = 0;
    while ((count = ::gzread(stream.get(), part, sizeof part)) > 0) {
        text.append(part, static_cast<std::size_t>(count));
        if (static_cast<std::int64_t>(text.size()) <= most) continue;
        reason = "expected at most " + std::to_string(most) + " bytes of text, found more";
        return false;
    }
    int error = Z_OK;
    const char* const why = ::gzerror(stream.get(), &error);
    if (count == 0 && error == Z_OK) return true;
    // zlib begins with a name of its own for the file.
    std::string_view what = error == Z_ERRNO ? std::strerror(errno) : why;
    if (what.starts_with("<fd:")) what.remove_prefix(std::min(what.find(": ") + 2, what.size()));
    reason = "cannot read: ";
    reason += what;
    return false;
}

} // namespace vo
