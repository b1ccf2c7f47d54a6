// vox3d: scenes of X3D, and volumes in scenes: shown, drawn into pictures, checked and written.

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <vo/Error.h>
#include <vo/x3d/View.h>

#include "utility.h"
#include "volume_io/file_beside.h"
#include "vox3d_options.h"
#include "vox3d_pictures.h"
#include "vox3d_volume.h"
#include "vox3d_window.h"

namespace {

constexpr const char* kProgram = "vox3d";

std::string counted(int number, const char* what)
{
    return std::to_string(number) + " " + what + (number == 1 ? "" : "s");
}

/// "2 errors, 1 warning".
std::string problemsOf(const voX3DScene& scene)
{
    const int errors = scene.getErrorCount();
    const int others = scene.getMessageCount() - errors;
    const int left = scene.getLeftOutMessageCount();
    return counted(errors, "error") + ", " + counted(others, "warning") +
           (left > 0 ? " and " + std::to_string(left) + " more" : "");
}

/// A scene, and what it was made of.
struct OpenedScene
{
    voX3DScene scene;
    std::string input;
    /// Whether it is a volume's that vox3d said of why nothing is seen.
    bool isToldEmpty = false;
};

/// Of a volume's scene, whose nodes are in no file, with its name.
void printMessages(const OpenedScene& opened, FILE* stream)
{
    for (int i = 0; i < opened.scene.getMessageCount(); ++i) {
        if (opened.isToldEmpty && opened.scene.getMessageTopic(i) == voX3DScope::NOTHING_SEEN) continue;
        const bool hasPlace = *opened.scene.getMessageFile(i) != '\0';
        const std::string whole = (hasPlace ? "" : opened.input + ": ") + opened.scene.getMessage(i);
        std::fprintf(stream, "%s\n", vo::withoutControls(whole).c_str());
    }
}

vo::Result<void> check(OpenedScene& opened)
{
    opened.scene.check();
    printMessages(opened, stdout);
    if (opened.scene.getMessageCount() > 0)
        return vo::Failure{opened.input + ": " + problemsOf(opened.scene)};
    std::printf("%s: nothing is unsupported or wrong\n", opened.input.c_str());
    return {};
}

/// The scene itself is not replaced: what it has and is not known would be lost. Nor is a file of another
/// kind.
vo::Result<void> checkOutput(const std::string& scene, const std::string& output)
{
    std::error_code none;
    if (std::filesystem::equivalent(scene, output, none))
        return vo::Failure{output + ": expected an output that is no input, found the scene"};
    // Opening a pipe would wait for whoever writes; FileBeside refuses it.
    if (!std::filesystem::is_regular_file(output, none)) return {};
    std::ifstream file(output, std::ios::binary);
    char first = 0;
    if (file >> first && first != '<' && first != '#')
        return vo::Failure{output + ": expected a new file or a scene to replace, found another file"};
    return {};
}

vo::Result<void> save(OpenedScene& opened, const vo::Vox3dOptions& options)
{
    voX3DScene& scene = opened.scene;
    if (!options.check && options.output.empty()) printMessages(opened, stderr);
    if (scene.getErrorCount() > 0)
        return vo::Failure{options.save + ": not written: " + problemsOf(scene) + " in " + options.input};
    if (auto may = checkOutput(options.input, options.save); !may) return may;
    std::set<std::string> outside;
    if (!vo::isScene(options.input)) outside = vo::makeUrlsRelative(scene, options.save);
    const vo::NoticesInterrupts whileItIsOpen;
    auto file = vo::FileBeside::create(options.save);
    if (!file) return file.failure();
    const bool isClassic = options.save.ends_with(".x3dv");
    if (!scene.write(file->temporaryPath().c_str(), isClassic ? voX3DScope::CLASSIC_VRML : voX3DScope::XML))
        return vo::Failure{options.save + ": " + voError::getErrorString()};
    if (vo::interrupted()) return vo::Failure{options.save + ": not written: interrupted"};
    auto done = file->commit();
    for (const std::string& folder : outside)
        if (done) vo::warn(kProgram, options.save + ": is read with -allow " + folder);
    return done;
}

/// The scene that is named, or one of the volume that is.
vo::Result<void> openScene(OpenedScene& opened, const vo::Vox3dOptions& options)
{
    voX3DScene& scene = opened.scene;
    opened.input = options.input;
    for (const std::string& folder : options.allowed) {
        std::error_code none;
        if (!std::filesystem::is_directory(folder, none))
            return vo::Failure{folder + ": expected a folder behind -allow, found none"};
        scene.allowFolder(folder.c_str());
    }
    if (!vo::isScene(options.input)) {
        const auto made = vo::makeVolumeScene(scene, options);
        if (!made) return made.failure();
        opened.isToldEmpty = *made == vo::VolumeScene::toldEmpty;
        return {};
    }
    if (!options.ofVolumes.empty())
        return vo::Failure{"option " + options.ofVolumes + ": expected a volume, found the scene " +
                           options.input};
    if (scene.read(options.input.c_str())) return {};
    printMessages(opened, options.check ? stdout : stderr);
    return vo::Failure{options.input + ": expected a scene, found none that can be read"};
}

/// "1 (Front, The front), 2 (Near)", as far as there is room.
std::string viewpointsOf(voX3DView& view)
{
    constexpr int kMost = 20;
    const int count = view.getViewpointCount();
    std::string text;
    for (int i = 0; i < std::min(count, kMost); ++i) {
        const voX3DNode viewpoint = view.getViewpoint(i);
        const std::string name = viewpoint.getName(), description = viewpoint.getString("description");
        text += (i == 0 ? "" : ", ") + std::to_string(i + 1);
        if (name.empty() && description.empty()) continue;
        text += " (" + name + (name.empty() || description.empty() ? "" : ", ") + description + ")";
    }
    return count > kMost ? text + " ... " + std::to_string(count) : text;
}

vo::Result<void> chooseViewpoint(voX3DView& view, const vo::Vox3dOptions& options)
{
    if (options.viewpoint.empty() || view.setViewpoint(options.viewpoint.c_str())) return {};
    const std::string names = viewpointsOf(view);
    return vo::Failure{"option -viewpoint: expected " +
                       (names.empty() ? "none, since " + options.input + " has no viewpoints"
                                      : "a viewpoint of " + options.input + ": " + names) +
                       "; found \"" + options.viewpoint + "\""};
}

/// Pictures, or a window; where there is no display, a picture all the same.
vo::Result<void> show(voX3DScene& scene, vo::Vox3dOptions options)
{
    voX3DView view(scene);
    view.setSize(options.width, options.height);
    if (auto chosen = chooseViewpoint(view, options); !chosen) return chosen;
    view.setTime(options.time);
    view.setSampling(options.sampling);
    if (options.output.empty()) {
        std::string whyNot;
#ifdef VOX3D_HAS_WINDOW
        const auto shown = vo::showInWindow(scene, view, options, whyNot);
        if (!shown) return shown.failure();
        if (*shown) return {};
#else
        whyNot = "built without GLFW";
#endif
        options.output = "vox3d.png";
        vo::warn(kProgram, "no window (" + whyNot + "); drawing without one into " + options.output);
    }
    auto written = vo::writePictures(view, options);
    double center[3], radius = 0;
    if (written && scene.getMessageCount() == 0 && !view.getBounds(center, radius))
        vo::warn(kProgram, options.input + ": expected volumes or shapes to draw, found none");
    return written;
}

/// What is wrong is left out of the picture; the program ends with 1 all the same.
vo::Result<void> showWithMessages(OpenedScene& opened, const vo::Vox3dOptions& options)
{
    auto shown = show(opened.scene, options);
    printMessages(opened, stderr);
    if (!shown || opened.scene.getErrorCount() == 0) return shown;
    return vo::Failure{options.input + ": drawn without what is wrong: " + problemsOf(opened.scene)};
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    const vo::EndsWhenInterrupted atOnce;
    const auto options = vo::parseVox3dOptions(arguments);
    if (!options) return options.failure();
    if (!options->output.empty())
        if (auto named = vo::checkPictureNames(*options); !named) return named;
    OpenedScene opened;
    if (auto done = openScene(opened, *options); !done) return done;
    vo::Result<void> checked;
    if (options->check) checked = check(opened);
    const bool isShown = !options->output.empty() || (!options->check && options->save.empty());
    if (isShown && checked) checked = showWithMessages(opened, *options);
    if (!options->save.empty())
        if (auto saved = save(opened, *options); !saved) return saved;
    return checked;
}

} // namespace

int main(int argc, char** argv)
{
#ifdef VOX3D_HAS_WINDOW
    const std::string help = vo::vox3dHelp() + "\n" + vo::kWindowKeys;
#else
    const std::string help = vo::vox3dHelp();
#endif
    return vo::runUtility({kProgram, help.c_str(), run}, argc, argv);
}
