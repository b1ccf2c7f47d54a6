#include "tiff_handle.h"

#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <unistd.h>

namespace vo {

struct TiffHandle::State
{
    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State()
    {
        // TIFFCleanup, unlike TIFFClose, leaves the descriptor alone, so that closeWritten() can see it fail.
        if (tiff) TIFFCleanup(tiff);
        if (descriptor >= 0) ::close(descriptor);
    }

    std::string path;
    std::optional<InputFile> input; // while reading
    std::int64_t position = 0;      // libtiff's, while reading
    int descriptor = -1;            // while writing
    std::string error;              // the first since it was last taken
    std::string warning;            // the last
    TIFF* tiff = nullptr;
};

namespace {

// A header cannot make libtiff ask for more memory at once than this, or than 16 times the file.
constexpr std::int64_t kLeastMemoryLimit = 64 << 20;

std::string formatted(const char* format, va_list arguments)
{
    char text[512];
    std::vsnprintf(text, sizeof text, format, arguments);
    std::replace(text, text + std::strlen(text), '\n', ' ');
    return text;
}

int keepError(TIFF*, void* error, const char*, const char* format, va_list arguments)
{
    auto& text = *static_cast<std::string*>(error);
    if (text.empty()) text = formatted(format, arguments);
    return 1;
}

int keepWarning(TIFF*, void* warning, const char*, const char* format, va_list arguments)
{
    *static_cast<std::string*>(warning) = formatted(format, arguments);
    return 1;
}

struct FreeOptions
{
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};

std::unique_ptr<TIFFOpenOptions, FreeOptions> openOptions(std::string& error, std::string& warning)
{
    std::unique_ptr<TIFFOpenOptions, FreeOptions> options(TIFFOpenOptionsAlloc());
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepError, &error);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keepWarning, &warning);
    return options;
}

} // namespace

/// What libtiff calls to read; it is handed the State.
struct TiffInput
{
    static TiffHandle::State& state(thandle_t handle) { return *static_cast<TiffHandle::State*>(handle); }

    static tmsize_t read(thandle_t handle, void* out, tmsize_t size)
    {
        const std::int64_t left =
            std::max<std::int64_t>(state(handle).input->size() - state(handle).position, 0);
        const auto count = std::min<std::int64_t>(size, left);
        const std::span bytes(static_cast<std::byte*>(out), static_cast<std::size_t>(count));
        if (!state(handle).input->readAt(state(handle).position, bytes)) return -1;
        state(handle).position += count;
        return count;
    }
    static tmsize_t write(thandle_t, void*, tmsize_t) { return -1; }
    static toff_t seek(thandle_t handle, toff_t offset, int whence)
    {
        const std::int64_t base = whence == SEEK_SET   ? 0
                                  : whence == SEEK_CUR ? state(handle).position
                                                       : state(handle).input->size();
        std::int64_t position = 0;
        if (offset > static_cast<toff_t>(INT64_MAX) ||
            __builtin_add_overflow(base, static_cast<std::int64_t>(offset), &position))
            return static_cast<toff_t>(-1);
        state(handle).position = position;
        return static_cast<toff_t>(position);
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return static_cast<toff_t>(state(handle).input->size()); }
};

Result<TiffHandle> TiffHandle::read(InputFile file)
{
    auto state = std::make_unique<State>();
    state->path = file.path();
    state->input.emplace(std::move(file));
    const auto options = openOptions(state->error, state->warning);
    TIFFOpenOptionsSetMaxSingleMemAlloc(
        options.get(), std::max(kLeastMemoryLimit, 16 * std::min(state->input->size(), INT64_MAX / 16)));
    // m: no memory mapping, which would crash where a file shrinks; c: leave large uncompressed strips whole.
    state->tiff = TIFFClientOpenExt(state->path.c_str(), "rmc", state.get(), TiffInput::read,
                                    TiffInput::write, TiffInput::seek, TiffInput::close, TiffInput::size,
                                    nullptr, nullptr, options.get());
    TiffHandle handle(std::move(state));
    // libtiff's words for a directory without entries.
    if (!handle.get() && handle.state_->error.find("to read TIFF directory (0 elements") != std::string::npos)
        return Failure{handle.state_->path + ": expected at least one page, found none"};
    if (!handle.get())
        return Failure{handle.state_->path + ": cannot read the first page of this TIFF" +
                       handle.takeComplaint()};
    return handle;
}

Result<TiffHandle> TiffHandle::write(const std::string& temporaryPath, const std::string& path, bool bigTiff)
{
    auto state = std::make_unique<State>();
    state->path = path;
    state->descriptor = ::open(temporaryPath.c_str(), O_RDWR | O_CLOEXEC);
    if (state->descriptor < 0) return Failure{path + ": cannot write: " + std::strerror(errno)};
    const auto options = openOptions(state->error, state->warning);
    state->tiff = TIFFFdOpenExt(state->descriptor, path.c_str(), bigTiff ? "w8" : "w4", options.get());
    TiffHandle handle(std::move(state));
    if (!handle.get()) return Failure{path + ": cannot write" + handle.takeComplaint()};
    return handle;
}

TiffHandle::TiffHandle(std::unique_ptr<State> state) : state_(std::move(state)) {}
TiffHandle::TiffHandle(TiffHandle&&) noexcept = default;
TiffHandle& TiffHandle::operator=(TiffHandle&&) noexcept = default;
TiffHandle::~TiffHandle() = default;

TIFF* TiffHandle::get() const
{
    return state_->tiff;
}

const InputFile& TiffHandle::file() const
{
    return *state_->input;
}

std::string TiffHandle::takeComplaint()
{
    std::string text = state_->error.empty() ? state_->warning : state_->error;
    // Some of libtiff's messages begin with the file's name, which those of the callers do already.
    if (text.starts_with(state_->path + ": ")) text.erase(0, state_->path.size() + 2);
    state_->error.clear();
    state_->warning.clear();
    return text.empty() ? text : ": " + text;
}

bool TiffHandle::sawError() const
{
    return !state_->error.empty();
}

Result<void> TiffHandle::closeWritten()
{
    const bool flushed = TIFFFlush(state_->tiff) != 0;
    const std::string complaint = takeComplaint();
    TIFFCleanup(std::exchange(state_->tiff, nullptr));
    const bool closed = ::close(std::exchange(state_->descriptor, -1)) == 0;
    if (!flushed) return Failure{state_->path + ": cannot write" + complaint};
    if (!closed) return Failure{state_->path + ": cannot write: " + std::strerror(errno)};
    return {};
}

} // namespace vo
