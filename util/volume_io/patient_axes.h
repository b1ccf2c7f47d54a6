#pragma once

#include <optional>

#include "volume_io.h"

namespace vo {

using Vector3 = std::array<double, 3>;

/// Which way the axes of a file become those of the volume that is served.
struct Placement
{
    /// Axis of the file that serves as x, y and z.
    std::array<int, 3> fileAxis{0, 1, 2};
    /// Whether that axis runs the other way.
    std::array<bool, 3> reversed{};
    /// Of the served axes.
    Vector3 spacing{1, 1, 1};
    bool spacingKnown = false;
    PatientFrame orientation;
};

/// The placement of a file in which one voxel along x, y, z is a step of steps[0], steps[1], steps[2] mm in
/// the frame right, front, up: each axis serves for that axis of the patient which it is nearest to, no two
/// for the same. None where the steps do not span space or are no numbers.
std::optional<Placement> placementOfSteps(const std::array<Vector3, 3>& steps);

/// The file's own order, for files that do not say how they lie in the patient. Spacings that are no positive
/// numbers are unknown.
Placement fileOrder(const Vector3& spacing);

/// The same vector in the frame right, front, up when it was given in the frame left, back, up (DICOM's).
Vector3 fromLeftBackUp(const Vector3& vector);

} // namespace vo
