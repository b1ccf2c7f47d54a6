#pragma once

#include "draw/draw_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

/// A volume that is mostly empty, drawn in slices by drawUtility.
namespace vo::test {

/// Rows from red to blue whose opacity begins at entry `first` of 256.
inline std::vector<float> tableFrom(int first)
{
    std::vector<float> table;
    for (int i = 0; i < 256; ++i) {
        const float v = static_cast<float>(i) / 255.0f;
        table.insert(table.end(), {v, 0.5f * v, 1.0f - v, i < first ? 0.0f : 0.02f + 0.1f * v});
    }
    return table;
}

/// The first voxel of a part of a volume.
struct Place
{
    int x, y, z;
};

/// A thin letter in a corner and a small ball, nothing elsewhere.
inline Field sparseField(const Place& ball)
{
    Field sparse = constantField({64, 57, 61}, 0.0);
    const auto put = [&](const Field& part, const Place& place) {
        for (int z = 0; z < part.size.z; ++z)
            for (int y = 0; y < part.size.y; ++y)
                for (int x = 0; x < part.size.x; ++x)
                    sparse.at(place.x + x, place.y + y, place.z + z) = part.at(x, y, z);
    };
    put(letterFField({20, 20, 20}), {3, 4, 5});
    put(ballField({26, 26, 26}), ball);
    return quantised(withEmptyBorder(sparse, 2));
}

class SparseSlices : public testing::Test
{
protected:
    SparseSlices(const Place& ball, int pixels) : field(sparseField(ball))
    {
        setenv("VO_ENGINE", "slices", 1);
        scene.volume = &field;
        scene.width = scene.height = pixels;
        scene.overlap = 1;
        scene.view = orthographicView({20, 30}, field.size, pixels, pixels);
        scene.classification = Classification::postInterpolation;
        scene.table = tableFrom(1);
        options.utility = true;
    }
    ~SparseSlices() override { unsetenv("VO_ENGINE"); }

    void open(OffscreenProfile profile = OffscreenProfile::Compatibility)
    {
        drawing.reset();
        context = openFor(scene, profile);
        drawing = std::make_unique<SceneDrawing>(*context, scene, options);
    }

    const GladGLContext& gl() const { return context->gl(); }

    /// What is said while `draw` runs.
    template <typename Draw>
    static std::string messagesOf(const Draw& draw)
    {
        std::ostringstream messages;
        voError::setDebugLevel(2);
        voError::setDebugStream(messages);
        draw();
        voError::setDebugLevel(0);
        voError::setDebugStream(stderr);
        return messages.str();
    }

    static double largestDifference(const std::vector<float>& a, const std::vector<float>& b)
    {
        double largest = 0.0;
        for (std::size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(static_cast<double>(a[i]) - b[i]));
        return largest;
    }

    Field field;
    Scene scene;
    DrawOptions options;
    std::unique_ptr<OffscreenContext> context;
    std::unique_ptr<SceneDrawing> drawing;
};

} // namespace vo::test
