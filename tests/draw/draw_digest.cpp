// Draws fixed scenes and prints a number for each picture that changes with any bit of it:
// draw_digest egl|osmesa core|compatibility

#include "draw/draw_scene.h"

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace {

using namespace vo::test;

std::uint64_t digest(const std::vector<float>& picture)
{
    std::uint64_t hash = 14695981039346656037u;
    for (const float value : picture) {
        std::uint32_t bits;
        std::memcpy(&bits, &value, sizeof bits);
        for (int byte = 0; byte < 4; ++byte)
            hash = (hash ^ (bits >> (8 * byte) & 255u)) * 1099511628211u;
    }
    return hash;
}

Scene sceneOf(const Field& field, int number)
{
    Scene scene;
    scene.volume = &field;
    scene.width = 150;
    scene.height = 130;
    scene.overlap = 1;
    const Angles angles{17.0 * number, 41.0 * number};
    scene.view = number % 2 ? perspectiveView(angles, field.size, scene.width, scene.height, 40)
                            : orthographicView(angles, field.size, scene.width, scene.height);
    // A compatibility context keeps matrices as floats.
    for (Matrix* matrix : {&scene.view.model, &scene.view.projection})
        for (double& value : *matrix)
            value = static_cast<float>(value);
    if (number % 3 == 2) scene.compositing = Compositing::max;
    if (number >= 3) {
        scene.classification =
            number % 2 ? Classification::postInterpolation : Classification::preInterpolation;
        scene.table = {0, 0, 0, 0, 1, 0.5f, 0, 0.1f, 0, 1, 0.5f, 0.3f};
    }
    if (number == 6) scene.stackAxis = 2;
    return scene;
}

void draw(const char* backEnd, const char* profile)
{
    const Field field = quantised(noiseField({30, 26, 34}, 9));
    vo::OffscreenRequest request;
    request.backEnd = std::strcmp(backEnd, "egl") ? vo::OffscreenBackEnd::Osmesa : vo::OffscreenBackEnd::Egl;
    request.profile =
        std::strcmp(profile, "core") ? vo::OffscreenProfile::Compatibility : vo::OffscreenProfile::Core;
    request.width = 150;
    request.height = 130;
    request.floatColor = true;
    std::string why;
    const auto context = vo::openOffscreen(request, &why);
    if (!context) throw std::runtime_error(why);
    for (int number = 0; number < 7; ++number) {
        DrawOptions options;
        options.utility = number % 2 == 0;
        options.bricks = 1 + number % 3;
        const std::vector<float> picture = drawnPicture(*context, sceneOf(field, number), options);
        std::printf("%d %016llx\n", number, static_cast<unsigned long long>(digest(picture)));
    }
}

} // namespace

int main(int argc, char** argv)
{
    try {
        if (argc != 3) throw std::runtime_error("usage: draw_digest egl|osmesa core|compatibility");
        draw(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "draw_digest: %s\n", error.what());
        return 1;
    }
}
