// Any bytes as a scene: what could be read of it has a picture.

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "cast/cast_scene.h"
#include "x3d/read_scene.h"
#include "x3d/styled_view.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    vo::Scene scene;
    if (!vo::readSceneText(scene, {reinterpret_cast<const char*>(data), size}, "fuzz")) return 0;
    vo::SceneView view(scene);
    vo::ViewRequest request;
    request.width = request.height = 6;
    vo::ScenePicture picture;
    vo::castScene(view.styledScene(request), 1, picture);
    if (picture.rgba.size() != 4 * 6 * 6) {
        std::fprintf(stderr, "expected 6 x 6 pixels, found %zu numbers\n", picture.rgba.size());
        std::abort();
    }
    return 0;
}
