#pragma once

#include "volume_view/camera.h"

namespace vo {

/// The guide's trackball (page 89): a drag turns the volume by a tenth of a degree a pixel.
class Trackball
{
public:
    void press(double x, double y, const Orientation& orientation)
    {
        lastX_ = x;
        lastY_ = y;
        last_ = orientation;
    }
    /// The orientation for the pointer at (x, y), y downwards.
    Orientation drag(double x, double y) const
    {
        return {last_.latitude + (lastY_ - y) / 10, last_.longitude + (lastX_ - x) / 10};
    }

private:
    double lastX_ = 0;
    double lastY_ = 0;
    Orientation last_;
};

} // namespace vo
