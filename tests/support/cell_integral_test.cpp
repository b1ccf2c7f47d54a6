// The integral through cells against closed forms.
#include "support/cell_integral.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace vo::test;

/// Three tetrahedra that fill the prism below x + y = 4, z from 0 to 3.
std::vector<Tetrahedron> prism()
{
    const glm::dvec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0), d(0, 0, 3), e(4, 0, 3), f(0, 4, 3);
    return {{a, b, c, f}, {a, b, f, e}, {a, e, f, d}};
}

CellScene alongZ()
{
    CellScene scene;
    scene.tetras = prism();
    scene.width = scene.height = 15; // no pixel's centre lies on an edge
    scene.view.projection = ortho(-1, 7, -1, 7, -10, 10);
    return scene;
}

TEST(CellIntegral, constantMediumFollowsBeersLaw)
{
    CellScene scene = alongZ();
    scene.colorAt = [](std::size_t, const std::array<double, 4>&) { return std::array{0.2, 0.5, 1.0, 0.3}; };
    const Picture picture = integrateCells(scene);
    const double opacity = 1 - std::pow(0.7, 3);
    for (int y = 0; y < 15; ++y)
        for (int x = 0; x < 15; ++x) {
            const double px = -1 + (x + 0.5) * 8 / 15, py = -1 + (y + 0.5) * 8 / 15;
            const bool inside = px > 0 && py > 0 && px + py < 4;
            const double* pixel = picture.pixel(x, y);
            EXPECT_NEAR(pixel[3], inside ? opacity : 0, 1e-12) << x << " " << y;
            EXPECT_NEAR(pixel[1], inside ? 0.5 * opacity : 0, 1e-12);
        }
}

TEST(CellIntegral, nearerLightHidesFartherLight)
{
    // The colour is z / 3: seen from +z, the ray's light is the integral of (1 - s / 3) k exp(-k s).
    CellScene scene = alongZ();
    const std::vector<Tetrahedron> tetras = scene.tetras;
    scene.colorAt = [&](std::size_t tetra, const std::array<double, 4>& w) {
        double z = 0;
        for (std::size_t i = 0; i < 4; ++i)
            z += w[i] * tetras[tetra][i].z;
        return std::array{z / 3, 0.0, 0.0, 0.4};
    };
    const double k = -std::log(0.6), end = std::exp(-3 * k);
    const double light = (1 - end) - (1 / (3 * k)) * (1 - end * (1 + 3 * k));
    const Picture picture = integrateCells(scene);
    EXPECT_NEAR(picture.pixel(4, 4)[0], light, 2e-5);
    EXPECT_NEAR(picture.pixel(6, 3)[0], light, 2e-5);
}

} // namespace
