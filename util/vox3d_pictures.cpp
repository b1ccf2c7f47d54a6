#include "offscreen/offscreen.h" // before headers that name OpenGL's own

#include "vox3d_pictures.h"

#include "machine_memory.h"
#include "utility.h"
#include "volume_io/volume_io.h"
#include "volume_view/frame_names.h"
#include "volume_view/picture.h"
#include "vox3d_navigation.h"

#include <vo/Error.h>

#include <filesystem>
#include <iomanip>
#include <numbers>
#include <span>
#include <sstream>

namespace vo {
namespace {

constexpr const char* kProgram = "vox3d";

/// Pictures of a view: by rays, or by OpenGL without a window.
class Painter
{
public:
    Painter(voX3DView& view, int width, int height) : view_(view), width_(width), height_(height)
    {
        pixels_.resize(std::size_t(width) * std::size_t(height) * 4);
    }
    ~Painter()
    {
        if (context_) view_.releaseDrawing();
    }
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    Result<void> openGl()
    {
        std::string whyNot;
        context_ = openOffscreen({.width = width_, .height = height_, .floatColor = true}, &whyNot);
        if (context_) return {};
        return Failure{"option -engine: expected OpenGL without a window, found none: " + whyNot};
    }

    Result<std::span<const float>> paint()
    {
        if (!context_) {
            if (!view_.picture(pixels_.data())) return failure();
            return std::span<const float>(pixels_);
        }
        context_->clear();
        if (!view_.draw(voEngineScope::SLICES)) return failure();
        pixels_ = context_->readFloats();
        return std::span<const float>(pixels_);
    }

private:
    static Failure failure() { return {std::string("cannot draw: ") + voError::getErrorString()}; }

    voX3DView& view_;
    int width_, height_;
    std::vector<float> pixels_;
    std::unique_ptr<OffscreenContext> context_;
};

/// Pixels are 4 floats here, 5 while they are computed, and 3 bytes in the end.
Result<void> checkMemory(const Vox3dOptions& options)
{
    constexpr std::int64_t kBytesPerPixel = 9 * sizeof(float) + 3;
    constexpr double kGib = 1 << 30;
    const std::int64_t needed = std::int64_t(options.width) * options.height * kBytesPerPixel;
    const std::int64_t there = machineMemory();
    if (there <= 0 || needed <= there) return {};
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << "option -size: expected a picture that "
         << double(there) / kGib << " GiB of memory hold, found " << options.width << " x " << options.height
         << " pixels, which take " << double(needed) / kGib << " GiB";
    return Failure{text.str()};
}

/// Once the file is there, a signal lets it go again.
Result<void> write(const std::string& name, const Vox3dOptions& options, std::span<const float> pixels)
{
    const auto colors = roundedColors(pixels);
    const NoticesInterrupts whileItIsOpen;
    auto written =
        writePng(name, options.width, options.height, 3, colors, RowOrder::bottomFirst, interrupted);
    if (written && interrupted()) return Failure{"interrupted"};
    return written;
}

} // namespace

Result<void> checkPictureNames(const Vox3dOptions& options)
{
    NamedPictures pictures{"-output", {}};
    for (int frame = 0; frame < std::max(options.frames, 1); ++frame)
        pictures.names.push_back(frameName(options.output, options.frames, frame));
    if (auto differ = checkNamesDiffer({pictures}); !differ) return differ;
    std::error_code none;
    for (const std::string& name : pictures.names)
        for (const std::string& input : {options.input, options.labels, options.lutFile})
            if (std::filesystem::equivalent(input, name, none))
                return Failure{name + ": expected an output that is no input, found the file " + input};
    return {};
}

Result<void> writePictures(voX3DView& view, const Vox3dOptions& options)
{
    if (auto fits = checkMemory(options); !fits) return fits;
    Painter painter(view, options.width, options.height);
    if (options.engine == Vox3dOptions::Engine::slices)
        if (auto opened = painter.openGl(); !opened) return opened;
    const double cycle = options.frames > 0 ? view.getCycle() : 0;
    const MovedEye begin = MovedEye::of(view);
    const int count = std::max(options.frames, 1);
    for (int frame = 0; frame < count; ++frame) {
        const double part = double(frame) / count;
        view.setTime(options.time + cycle * part);
        if (options.frames > 0 && cycle == 0) {
            MovedEye eye = begin;
            eye.examine({0, 1, 0}, 2 * std::numbers::pi * part);
            eye.apply(view);
        }
        const auto pixels = painter.paint();
        if (!pixels) return pixels.failure();
        const std::string name = frameName(options.output, options.frames, frame);
        if (auto written = write(name, options, *pixels); !written) return written;
        if (options.frames > 0) showProgress(kProgram, "frame", frame + 1, count);
    }
    return {};
}

} // namespace vo
