#include "patient_axes.h"

#include <algorithm>
#include <cmath>

namespace vo {
namespace {

// Steps closer than this to a plane, as a part of the volume of a cube of their lengths, span no space.
constexpr double kFlat = 1e-3;

double length(const Vector3& v)
{
    return std::hypot(v[0], v[1], v[2]);
}

double determinant(const std::array<Vector3, 3>& m)
{
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/// The order of the file's axes in which they are nearest to the patient's.
std::array<int, 3> nearestOrder(const std::array<Vector3, 3>& units)
{
    std::array<int, 3> order{0, 1, 2}, best = order;
    double most = -1;
    do {
        double sum = 0;
        for (std::size_t axis = 0; axis < 3; ++axis)
            sum += std::abs(units[std::size_t(order[axis])][axis]);
        if (sum > most + 1e-9) {
            most = sum;
            best = order;
        }
    } while (std::next_permutation(order.begin(), order.end()));
    return best;
}

bool isSpacing(double value)
{
    return std::isfinite(value) && value > 0;
}

} // namespace

std::optional<Placement> placementOfSteps(const std::array<Vector3, 3>& steps)
{
    std::array<Vector3, 3> units = steps;
    for (Vector3& unit : units) {
        const double all = length(unit);
        if (!isSpacing(all)) return std::nullopt;
        for (double& part : unit)
            part /= all;
    }
    if (!(std::abs(determinant(units)) > kFlat)) return std::nullopt;

    Placement placement;
    placement.fileAxis = nearestOrder(units);
    placement.spacingKnown = true;
    PatientFrame& orientation = placement.orientation;
    orientation.known = true;
    orientation.fileAxes = "   ";
    double trace = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<std::size_t>(placement.fileAxis[axis]);
        const bool reversed = units[from][axis] < 0;
        placement.reversed[axis] = reversed;
        placement.spacing[axis] = length(steps[from]);
        orientation.fileAxes[from] = (reversed ? "LPI" : "RAS")[axis];
        for (std::size_t i = 0; i < 3; ++i)
            orientation.direction[axis][i] = (reversed ? -units[from][i] : units[from][i]) + 0.0;
        trace += orientation.direction[axis][axis];
    }
    orientation.obliqueDegrees = std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::acos(-1.0);
    return placement;
}

Placement fileOrder(const Vector3& spacing)
{
    Placement placement;
    placement.spacingKnown = std::ranges::all_of(spacing, isSpacing);
    if (placement.spacingKnown) placement.spacing = spacing;
    return placement;
}

Vector3 fromLeftBackUp(const Vector3& vector)
{
    return {-vector[0], -vector[1], vector[2]};
}

} // namespace vo
