#pragma once

#include <array>

#include <vo/x3d/View.h>

#include "volume_view/matrix.h"

namespace vo {

/// An eye that is moved: eye space is that of a viewer who looks along -z.
struct MovedEye
{
    Matrix eyeFromWorld{}, projection{};
    /// What it turns round, in the world, and how large that is.
    std::array<double, 3> center{};
    double radius = 1;

    /// Where the view is now, and the sphere round all that it shows.
    static MovedEye of(voX3DView& view);
    /// With the near and the far plane round the sphere, as far as it lies before the eye.
    void apply(voX3DView& view) const;

    /// Turns the scene round its center, about an axis of the eye, in radians.
    void examine(const std::array<double, 3>& axis, double angle);
    /// Moves the scene in eye space.
    void move(const std::array<double, 3>& by);
    /// Moves the scene nearer or, above 1, farther: its center is then that many times as far away.
    /// Orthographic views become larger or smaller.
    void approach(double factor);
    /// Turns the head, about an axis of the eye.
    void look(const std::array<double, 3>& axis, double angle);
    /// For a picture of other proportions: the smaller side keeps its angle.
    void resize(int oldWidth, int oldHeight, int width, int height);

    std::array<double, 3> centerInEye() const;
    bool isOrthographic() const { return projection[11] == 0; }
};

} // namespace vo
