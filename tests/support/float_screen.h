#pragma once

#include "offscreen/offscreen.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace vo::test {

/// Tests that draw into a square of `pixels` with channels of floats, in both profiles of OpenGL.
template <int pixels>
class FloatScreen : public testing::TestWithParam<OffscreenProfile>
{
protected:
    void SetUp() override
    {
        context_ = opened({});
        ASSERT_TRUE(context_);
        // What a driver leaves of 8 bits is no matter here.
        context_->clear();
    }

    const GladGLContext& gl() const { return context_->gl(); }

    /// The context that a request gives, made as large and with floats.
    static std::unique_ptr<OffscreenContext> opened(OffscreenRequest request)
    {
        request.profile = GetParam();
        request.width = request.height = pixels;
        request.floatColor = true;
        std::string whyNot;
        auto context = openOffscreen(request, &whyNot);
        EXPECT_TRUE(context) << whyNot;
        return context;
    }

    static const float* pixelAt(const std::vector<float>& picture, int x, int y)
    {
        return picture.data() + 4 * (y * pixels + x);
    }

    std::unique_ptr<OffscreenContext> context_;
};

inline const auto kBothProfiles = testing::Values(OffscreenProfile::Core, OffscreenProfile::Compatibility);

inline std::string profileName(const testing::TestParamInfo<OffscreenProfile>& test)
{
    return test.param == OffscreenProfile::Core ? "core" : "compatibility";
}

} // namespace vo::test
