#include "x3d/scene_painter.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <string>

#include "core/invertible.h"
#include "legacy/report.h"

namespace vo {

namespace {

constexpr int kMostPixels = 32768;

} // namespace

void ScenePainter::draw(voEngine engine, const MakeScene& scene)
{
    if (engine < voEngineScope::AUTOMATIC || engine > voEngineScope::CAST)
        badEnum("expected AUTOMATIC, SLICES or CAST, found " + std::to_string(engine));
    const StyledScene made = scene();
    if (!screen_) screen_ = std::make_unique<SceneScreen>();
    const bool isCast =
        engine == voEngineScope::CAST || (engine == voEngineScope::AUTOMATIC && screen_->prefersCasting());
    if (!isCast) {
        screen_->draw(made);
        return;
    }
    ScenePicture picture;
    caster_.cast(made, 0, picture, screen_->readDepths(made.width, made.height));
    screen_->show(picture);
}

void ScenePainter::picture(float* rgba, int threads, const MakeScene& scene)
{
    required(rgba, "rgba");
    if (threads < 0) badValue("expected 0 or more threads, found " + std::to_string(threads));
    ScenePicture picture;
    caster_.cast(scene(), threads, picture);
    std::ranges::copy(picture.rgba, rgba);
}

void ScenePainter::checkSize(int width, int height)
{
    if (std::min(width, height) < 1 || std::max(width, height) > kMostPixels)
        badValue("expected 1 to " + std::to_string(kMostPixels) + " pixels, found " + std::to_string(width) +
                 " x " + std::to_string(height));
}

glm::dmat4 givenMatrix(const GLdouble* numbers, const char* name)
{
    const glm::dmat4 matrix = glm::make_mat4(&required(numbers, name));
    if (!isInvertible(matrix)) badValue(std::string(name) + " is singular or not finite");
    return matrix;
}

} // namespace vo
