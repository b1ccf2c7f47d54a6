#pragma once

// A small context and a square that fills it, textured by one brick, for the GL tests of the face.

#include "offscreen/offscreen.h"

#include "expect_error.h"
#include "face_scene.h"

#include <algorithm>
#include <cstring>

namespace vo::test {

/// A compatibility context of 4 x 4 float pixels over [0, 4]^2, seen along -z.
class SquareScreen
{
public:
    SquareScreen()
    {
        OffscreenRequest request;
        request.width = request.height = kSize;
        request.floatColor = true;
        std::string whyNot;
        context = openOffscreen(request, &whyNot);
        if (!context) {
            ADD_FAILURE() << whyNot;
            return;
        }
        const GladGLContext& gl = context->gl();
        gl.MatrixMode(GL_PROJECTION);
        gl.LoadMatrixd((ortho(2, -10, 10) * translation(-2, -2, 0)).m);
        gl.MatrixMode(GL_MODELVIEW);
        gl.Disable(GL_DEPTH_TEST);
    }

    /// One brick of 4^3 voxels of luminance, all `value`, downloaded when it is bound.
    static std::unique_ptr<voBrickSetCollection> constantVolume(unsigned char value)
    {
        auto volume = byteVolume(4, 4, voInterpolationTypeScope::_3D, 0);
        std::memset(voAppearanceActions::dataAlloc(brickOf(*volume)), value, 64);
        return volume;
    }
    static voBrick* brickOf(voBrickSetCollection& volume) { return volume.getCurrentBrickSet()->getBrick(0); }

    /// Clears, draws the square z = 2 textured by the bound brick, and returns red and alpha in the middle.
    std::pair<float, float> drawSquare(voBrickSetCollection& volume)
    {
        const GladGLContext& gl = context->gl();
        gl.ClearColor(0, 0, 0, 0);
        gl.Clear(GL_COLOR_BUFFER_BIT);
        gl.Color4f(1, 1, 1, 1);
        voIndexedFaceSet square(0, 3, 0);
        float corners[] = {0, 0, 2, 4, 0, 2, 4, 4, 2, 0, 4, 2};
        square.appendPoly(corners, 4);
        voAppearanceActions::textureEnable(voInterpolationTypeScope::_3D);
        voAppearanceActions::texgenEnable();
        voAppearanceActions::texgenSetEquation(brickOf(volume));
        EXPECT_EQ(voAppearanceActions::textureBind(brickOf(volume)), 0);
        voGeometryActions::draw(&square, voInterleavedArrayTypeScope::V3F);
        voAppearanceActions::texgenDisable();
        voAppearanceActions::textureDisable(voInterpolationTypeScope::_3D);
        return middle();
    }

    std::pair<float, float> middle() const
    {
        const std::vector<float> pixels = context->readFloats();
        const std::size_t pixel = 4 * (kSize * kSize / 2 + kSize / 2);
        return {pixels[pixel], pixels[pixel + 3]};
    }

    const GladGLContext& gl() const { return context->gl(); }

    static constexpr int kSize = 4;
    std::unique_ptr<OffscreenContext> context;
};

} // namespace vo::test
