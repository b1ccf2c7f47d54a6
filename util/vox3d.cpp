// vox3d: scenes of X3D, checked and written.

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <vo/Error.h>
#include <vo/x3d/Scene.h>

#include "utility.h"
#include "volume_io/file_beside.h"

namespace {

constexpr const char* kHelp =
    R"(vox3d [-allow FOLDER]... SCENE -check
vox3d [-allow FOLDER]... SCENE -save OUT

Reads a scene of X3D with volumes, in XML (.x3d) or ClassicVRML (.x3dv),
compressed by gzip or not. Drawing does not exist yet. Files that the scene
names are read in and below its own folder; nothing is fetched from a network.

  -check         list what is unsupported or wrong, with its file and line
  -save OUT      write what was read: ClassicVRML where OUT ends with .x3dv,
                 XML otherwise
  -allow FOLDER  let the scene name files in and below this folder, too
  -help          print this text
  -version       print the version

Example:
    vox3d head.x3d -check
    vox3d head.x3dv -save head.x3d
)";

struct Options
{
    std::string scene, save;
    std::vector<std::string> allowed;
    bool check = false;
};

vo::Result<Options> parse(const std::vector<std::string>& words)
{
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        if (word == "-check") {
            options.check = true;
        } else if (word == "-save" || word == "-allow") {
            if (++i == words.size()) return vo::Failure{"expected a name behind " + word + ", found the end"};
            word == "-save" ? void(options.save = words[i]) : options.allowed.push_back(words[i]);
        } else if (word.starts_with('-') && word.size() > 1) {
            return vo::Failure{"expected -check, -save or -allow, found the option \"" + word +
                               "\"; drawing does not exist yet"};
        } else if (!options.scene.empty()) {
            return vo::Failure{"expected one scene, found \"" + options.scene + "\" and \"" + word + "\""};
        } else {
            options.scene = word;
        }
    }
    if (options.scene.empty())
        return vo::Failure{"expected a scene, found none; vox3d -help shows an example"};
    if (!options.check && options.save.empty())
        return vo::Failure{options.scene + ": drawing does not exist yet: expected -check or -save OUT"};
    return options;
}

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

void printMessages(const voX3DScene& scene, FILE* stream)
{
    for (int i = 0; i < scene.getMessageCount(); ++i)
        std::fprintf(stream, "%s\n", scene.getMessage(i));
}

vo::Result<void> check(voX3DScene& scene, const std::string& path)
{
    scene.check();
    printMessages(scene, stdout);
    if (scene.getMessageCount() > 0) return vo::Failure{path + ": " + problemsOf(scene)};
    std::printf("%s: nothing is unsupported or wrong\n", path.c_str());
    return {};
}

/// The scene itself is not replaced: what it has and is not known would be lost. Nor is a file of another
/// kind.
vo::Result<void> checkOutput(const std::string& scene, const std::string& output)
{
    std::error_code none;
    if (std::filesystem::equivalent(scene, output, none))
        return vo::Failure{output + ": expected an output that is no input, found the scene"};
    std::ifstream file(output, std::ios::binary);
    char first = 0;
    if (file >> first && first != '<' && first != '#')
        return vo::Failure{output + ": expected a new file or a scene to replace, found another file"};
    return {};
}

vo::Result<void> save(const voX3DScene& scene, const Options& options)
{
    if (!options.check) printMessages(scene, stderr);
    if (scene.getErrorCount() > 0)
        return vo::Failure{options.save + ": not written: " + problemsOf(scene) + " in " + options.scene};
    if (auto may = checkOutput(options.scene, options.save); !may) return may;
    auto file = vo::FileBeside::create(options.save);
    if (!file) return file.failure();
    const bool isClassic = options.save.ends_with(".x3dv");
    if (!scene.write(file->temporaryPath().c_str(), isClassic ? voX3DScope::CLASSIC_VRML : voX3DScope::XML))
        return vo::Failure{options.save + ": " + voError::getErrorString()};
    return file->commit();
}

vo::Result<void> run(const std::vector<std::string>& arguments)
{
    const auto options = parse(arguments);
    if (!options) return options.failure();
    voX3DScene scene;
    for (const std::string& folder : options->allowed) {
        std::error_code none;
        if (!std::filesystem::is_directory(folder, none))
            return vo::Failure{folder + ": expected a folder behind -allow, found none"};
        scene.allowFolder(folder.c_str());
    }
    if (!scene.read(options->scene.c_str())) {
        printMessages(scene, options->check ? stdout : stderr);
        return vo::Failure{options->scene + ": expected a scene, found none that can be read"};
    }
    vo::Result<void> checked;
    if (options->check) checked = check(scene, options->scene);
    if (!options->save.empty())
        if (auto saved = save(scene, *options); !saved) return saved;
    return checked;
}

} // namespace

int main(int argc, char** argv)
{
    return vo::runUtility({"vox3d", kHelp, run}, argc, argv);
}
