#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace {

constexpr int kAround = 48, kOutwards = 12, kUp = 16;

/// The pressure's deviation at a place outside a cylinder of radius `a`, in the speed's square far away: 1
/// where the flow along x comes to rest, -3 at the sides.
double pressure(double r, double angle, double a)
{
    const double ratio = a * a / (r * r);
    const double outwards = (1 - ratio) * std::cos(angle), around = -(1 + ratio) * std::sin(angle);
    return 1 - outwards * outwards - around * around;
}

/// Blue for suction, red for pressure; what flows on undisturbed is clear.
std::array<float, 4> colorOf(double pressure)
{
    const double strength = pressure > 0 ? pressure : -pressure / 3;
    const std::array<double, 3> color = pressure > 0 ? std::array{1.0, 0.3 + 0.5 * (1 - strength), 0.1}
                                                     : std::array{0.15, 0.45 + 0.4 * strength, 1.0};
    const double opacity = 0.12 * std::pow(strength, 1.2);
    return {float(color[0]), float(color[1]), float(color[2]), float(opacity)};
}

Mesh::Vertex vertexAt(int around, int outwards, int up)
{
    const double height = double(up) / kUp;
    const double a = 1 - 0.45 * height; // the cylinder tapers
    const double share = double(outwards) / kOutwards;
    const double r = a + (4 - a) * std::pow(share, 1.7);
    const double angle = 2 * std::numbers::pi * around / kAround;
    return {colorOf(pressure(r, angle, a)),
            {float(r * std::cos(angle)), float(r * std::sin(angle)), float(5 * height)}};
}

int vertexNumber(int around, int outwards, int up)
{
    return (up * (kOutwards + 1) + outwards) * kAround + around % kAround;
}

} // namespace

Mesh flowMesh()
{
    // Corner number 4 up + 2 outwards + around; neighbours are cut as mirror images, so that faces meet.
    constexpr int kFive[] = {0, 3, 5, 6, 1, 0, 3, 5, 2, 0, 3, 6, 4, 0, 5, 6, 7, 3, 5, 6};
    Mesh mesh;
    for (int up = 0; up <= kUp; ++up)
        for (int outwards = 0; outwards <= kOutwards; ++outwards)
            for (int around = 0; around < kAround; ++around)
                mesh.vertices.push_back(vertexAt(around, outwards, up));
    for (int up = 0; up < kUp; ++up)
        for (int outwards = 0; outwards < kOutwards; ++outwards)
            for (int around = 0; around < kAround; ++around)
                for (const int index : kFive) {
                    const int corner = index ^ ((up + outwards + around) % 2);
                    mesh.tetras.push_back(vertexNumber(around + (corner & 1), outwards + (corner >> 1 & 1),
                                                       up + (corner >> 2)));
                }
    return mesh;
}
