#pragma once

#include <functional>
#include <memory>

#include <vo/x3d/View.h>

#include "cast/cast_scene.h"
#include "draw/scene_screen.h"

namespace vo {

/// What the face's classes draw scenes with. Wrong arguments are the caller's mistakes (badValue, badEnum),
/// found before `scene` is made.
class ScenePainter
{
public:
    using MakeScene = std::function<StyledScene()>;

    /// Into the context that is current, by the engine that the caller chooses.
    void draw(voEngine engine, const MakeScene& scene);
    /// Lets go of what draw() keeps in the context.
    void releaseDrawing() { screen_.reset(); }
    /// Without OpenGL: width * height * 4 floats.
    void picture(float* rgba, int threads, const MakeScene& scene);

    /// BAD_VALUE for sizes of pictures that are not 1 to 32768 pixels.
    static void checkSize(int width, int height);

private:
    SceneCaster caster_;
    std::unique_ptr<SceneScreen> screen_;
};

/// A caller's matrix, column by column; BAD_VALUE, with the argument's name, unless it has an inverse.
glm::dmat4 givenMatrix(const GLdouble* numbers, const char* name);

} // namespace vo
