// Any bytes as a scene: reading ends, with a scene or an error that has a line, and what was read without an
// error is the same after it was written and read again.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "x3d/check_scene.h"
#include "x3d/read_scene.h"
#include "x3d/write_scene.h"
#include "../x3d/same_graph.h"

namespace {

[[noreturn]] void stop(const char* what, const std::string& detail)
{
    std::fprintf(stderr, "%s: %s\n", what, detail.c_str());
    std::abort();
}

void mustComeBack(const vo::Scene& scene, vo::Encoding encoding)
{
    const std::string text = vo::sceneText(scene, encoding);
    vo::Scene again;
    if (!vo::readSceneText(again, text, "again"))
        stop("not read again", vo::messageLine(again.messages.back()) + "\n" + text);
    if (again.errorCount() > 0)
        stop("errors when read again", vo::messageLine(again.messages.front()) + "\n" + text);
    const std::string difference = vo::graphDifference(scene, again);
    if (!difference.empty()) stop("another scene when read again", difference + "\n" + text);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    vo::Scene scene;
    const bool isRead = vo::readSceneText(scene, {reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!isRead && scene.errorCount() == 0) stop("no error", "a scene that was not read");
    for (const vo::SceneMessage& message : scene.messages)
        if (message.place.line < 1) stop("no line", vo::messageLine(message));
    if (!isRead) return 0;
    vo::checkScene(scene);
    if (scene.errorCount() > 0) return 0;
    mustComeBack(scene, vo::Encoding::xml);
    mustComeBack(scene, vo::Encoding::classic);
    return 0;
}
