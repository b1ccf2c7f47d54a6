#include "matrices.h"

#include "offscreen/offscreen.h"

#include <gtest/gtest.h>

#include <vo/State.h>

namespace {

const vo::Model kModel{{181, 217, 181}, {1, 1, 2}};

void loadBoth(double degrees)
{
    const vo::ViewVolume view = vo::viewVolume(kModel, degrees, 320, 200);
    vo::loadProjection(view);
    vo::loadModelView(kModel, {12, 34}, view);
}

TEST(Matrices, fixedFunctionsAndOurOwnProductsAgree)
{
    std::string whyNot;
    const auto context = vo::openOffscreen({}, &whyNot);
    ASSERT_TRUE(context) << whyNot;
    gl = &context->gl();
    EXPECT_FALSE(vo::isCoreContext());
    for (const double degrees : {0.0, 35.0}) {
        loadBoth(degrees);
        GLdouble modelView[16], projection[16];
        vo::getMatrices(modelView, projection);
        const vo::ViewVolume view = vo::viewVolume(kModel, degrees, 320, 200);
        const vo::Matrix expectedModelView = vo::modelViewMatrix(kModel, {12, 34}, view);
        const vo::Matrix expectedProjection = vo::projectionMatrix(view);
        for (std::size_t i = 0; i < 16; ++i) {
            EXPECT_NEAR(modelView[i], expectedModelView[i], 1e-4) << i;
            EXPECT_NEAR(projection[i], expectedProjection[i], 1e-5 * (1 + std::abs(expectedProjection[i])))
                << i;
        }
    }
}

TEST(Matrices, coreContextHoldsThemInTheLibrary)
{
    std::string whyNot;
    const auto context = vo::openOffscreen({.profile = vo::OffscreenProfile::Core}, &whyNot);
    ASSERT_TRUE(context) << whyNot;
    gl = &context->gl();
    EXPECT_TRUE(vo::isCoreContext());
    loadBoth(35);
    GLdouble modelView[16], projection[16];
    vo::getMatrices(modelView, projection);
    const vo::ViewVolume view = vo::viewVolume(kModel, 35, 320, 200);
    EXPECT_EQ(modelView[14], double(float(vo::modelViewMatrix(kModel, {12, 34}, view)[14])));
    EXPECT_EQ(projection[5], double(float(vo::projectionMatrix(view)[5])));
}

} // namespace
