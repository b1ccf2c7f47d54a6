// vorender VOLUME -output FILE: a picture of a volume, drawn without OpenGL.

#include "utility.h"
#include "vorender_depth.h"
#include "vorender_options.h"
#include "vorender_output.h"
#include "vorender_scene.h"

#include "volume_view/defaults.h"

#include <future>
#include <new>

namespace {

constexpr const char* kProgram = "vorender";

std::string helpText()
{
    return R"(Usage: vorender [OPTION...] VOLUME

Draws a volume into a picture, without OpenGL and without a display: the same
picture as voglBasic -output.

Example: vorender head.tif -color -lutFile brain.lut -view 0 180 -output head.png
         vorender -raw 256 256 256 uchar scan.raw -frames 36 -output turn%03d.png

Options may stand anywhere and may be abbreviated.
)" + vo::vorenderOptionsHelp();
}

vo::Result<vo::VolumeFile> openInput(const vo::VorenderOptions& options)
{
    const std::vector<std::string>& files = options.view.files;
    if (!options.raw) return vo::openVolume(files.front());
    return files.size() == 1 ? vo::openRawVolume(files.front(), *options.raw)
                             : vo::openRawSlices(files, *options.raw);
}

/// The volume and its table, ready to be drawn.
vo::Result<vo::VolumeScene> openScene(const vo::VorenderOptions& options)
{
    const std::string& path = options.view.files.front();
    std::optional<vo::LookupFile> table;
    if (!options.view.lutFile.empty()) {
        auto read = vo::readLookupFile(options.view.lutFile);
        if (!read) return read.failure();
        table = *read;
    }
    auto file = openInput(options);
    if (!file) return file.failure();
    for (const std::string& note : file->description().notes)
        vo::warn(kProgram, path + ": " + note);
    const bool color = vo::inColor(options.view, table && table->isColor);
    auto volume = vo::loadVolume(path, *file, options.view, color);
    if (!volume) return volume.failure();
    return vo::VolumeScene::make(std::move(*volume), options.view, table);
}

vo::Result<void> checkNames(const vo::VorenderOptions& options)
{
    const std::uintmax_t pixels = std::uintmax_t(options.view.width) * std::uintmax_t(options.view.height);
    const std::vector<vo::NamedPictures> pictures = vo::pictureNames(options);
    if (auto differ = vo::checkNamesDiffer(pictures); !differ) return differ;
    for (const auto& [option, names] : pictures) {
        const std::uintmax_t floats = option == std::string("-output") ? 4 : 1;
        for (const std::string& name : names)
            if (auto checked = vo::checkPictureName(name, pixels * floats * 4, options.view.files); !checked)
                return checked;
    }
    return {};
}

/// Says that a turn ends up in one picture: the number may have been forgotten.
void noteWhatIsNotNumbered(const vo::VorenderOptions& options)
{
    if (options.frames == 0) return;
    for (const std::string& name : {options.output, options.depth})
        if (!name.empty() && !vo::isNumbered(name))
            vo::warn(kProgram, name + ": has no %d for the number of each of the -frames; it shows the view");
}

/// Draws frame after frame; one is written while the next is drawn.
class FrameWriter
{
public:
    FrameWriter(const vo::VorenderOptions& options, const vo::VolumeScene& scene)
        : options_(options), scene_(scene)
    {
    }

    vo::Result<void> run()
    try {
        const int count = vo::pictureCount(options_);
        for (int frame = 0; frame < count; ++frame) {
            if (vo::interrupted()) return vo::Failure{"interrupted"};
            if (auto drawn = draw(frame, 360.0 * frame / count); !drawn) return drawn;
            if (options_.frames > 0) vo::showProgress(kProgram, "frame", frame + 1, count);
        }
        return written();
    } catch (const std::bad_alloc&) {
        const auto [width, height] = std::pair(options_.view.width, options_.view.height);
        return vo::Failure{"option -size: expected memory beside the volume's for a picture of " +
                           std::to_string(width) + " x " + std::to_string(height) + " pixels, " +
                           std::to_string(std::int64_t(width) * height * 16) +
                           " bytes each time that it is held, found less"};
    }

private:
    vo::Result<void> draw(int frame, double degrees)
    {
        const vo::SceneView view(scene_, degrees);
        if (const std::string why = caster_.refusal(view.request()); !why.empty())
            return vo::Failure{options_.view.files.front() + ": cannot be drawn without OpenGL: " + why};
        vo::CastPicture picture;
        caster_.cast(view.request(), picture);
        if (isWanted(options_.depth, frame)) {
            const auto depths = vo::pictureDepths(caster_, view.request(), picture, vo::interrupted);
            if (depths.empty()) return vo::Failure{"interrupted"};
            const std::string name = vo::frameName(options_.depth, options_.frames, frame);
            auto done = vo::writeDepths(name, options_.view.width, options_.view.height, depths);
            if (!done) return done;
        }
        if (!isWanted(options_.output, frame)) return {};
        if (auto done = written(); !done) return done;
        return write(vo::frameName(options_.output, options_.frames, frame), std::move(picture));
    }

    /// Frame 0 is the view itself.
    static bool isWanted(const std::string& name, int frame)
    {
        return !name.empty() && (frame == 0 || vo::isNumbered(name));
    }

    /// Waits for the picture that is being written.
    vo::Result<void> written() { return pending_.valid() ? pending_.get() : vo::Result<void>(); }

    vo::Result<void> write(const std::string& name, vo::CastPicture picture)
    {
        const auto now = options_.frames > 1 ? std::launch::async : std::launch::deferred;
        pending_ = std::async(now, [name, picture = std::move(picture), &options = options_.view] {
            return vo::writeFrame(name, options.width, options.height, picture, !options.mip);
        });
        return {};
    }

    const vo::VorenderOptions& options_;
    const vo::VolumeScene& scene_;
    vo::RayCaster caster_;
    std::future<vo::Result<void>> pending_;
};

vo::Result<void> run(const std::vector<std::string>& words)
{
    const auto options = vo::parseVorenderOptions(words);
    if (!options) return options.failure();
    if (auto named = checkNames(*options); !named) return named;
    const auto scene = openScene(*options);
    if (!scene) return scene.failure();
    noteWhatIsNotNumbered(*options);
    if (const std::string vain = vo::withoutEffect(options->view); !vain.empty()) vo::warn(kProgram, vain);
    return FrameWriter(*options, *scene).run();
}

} // namespace

int main(int argc, char** argv)
{
    const std::string help = helpText();
    return vo::runUtility({kProgram, help.c_str(), run}, argc, argv);
}
