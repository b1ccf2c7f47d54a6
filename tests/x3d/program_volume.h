#pragma once

#include "support/float_screen.h" // before headers that name OpenGL's own

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>
#include <vector>

#include <vo/Error.h>
#include <vo/x3d/StyledVolume.h>

/// A small volume as a program has it, and a screen to draw it on.
namespace program_volume {

constexpr int kPixels = 48;
constexpr int kVoxels = 8;

inline const voEngine kEngines[] = {voEngineScope::SLICES, voEngineScope::CAST};

/// kVoxels along each axis: of one value, or a soft ball.
class Voxels
{
public:
    explicit Voxels(int value = -1)
        : bricks(kVoxels, kVoxels, kVoxels, kVoxels, kVoxels, kVoxels, voPartialBrickTypeScope::AUGMENT, 0,
                 voInternalFormatTypeScope::INTENSITY8_EXT, voExternalFormatTypeScope::LUMINANCE,
                 voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D)
    {
        for (int i = 0; i < kVoxels * kVoxels * kVoxels; ++i) {
            const glm::dvec3 place(i % kVoxels, i / kVoxels % kVoxels, i / kVoxels / kVoxels);
            const double distance = glm::length(place - glm::dvec3(3.2, 3.5, 3.9));
            values.push_back(static_cast<unsigned char>(
                value >= 0 ? value : std::clamp(200.0 - 45.0 * distance, 0.0, 200.0) + 8.0 * place.x));
        }
        bricks.getCurrentBrickSet()->getBrick(0)->setDataPtr(values.data());
    }

    std::vector<unsigned char> values;
    voBrickSetCollection bricks;
};

/// The volume, turned about its middle, ten in front of the eye.
inline glm::dmat4 turned()
{
    glm::dmat4 model = glm::translate(glm::dmat4(1.0), glm::dvec3(0.0, 0.0, -14.0));
    model = glm::rotate(model, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, 0.5)));
    return glm::translate(model, glm::dvec3(-0.5 * kVoxels));
}

class ProgramScreen : public vo::test::FloatScreen<kPixels>
{
protected:
    std::vector<float> drawn(voX3DStyledVolume& volume, const glm::dmat4& model, const glm::dmat4& projection,
                             voEngine engine)
    {
        EXPECT_TRUE(volume.draw(glm::value_ptr(model), glm::value_ptr(projection), kPixels, kPixels, engine))
            << voError::getErrorString();
        EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
        return context_->readFloats();
    }
};

} // namespace program_volume
