#include "drag_vertex.h"

#include <algorithm>
#include <cmath>

namespace {

struct EyePoint
{
    double x, y, z; // looked along -z
};

EyePoint seen(const VoglView& view, const float position[3])
{
    const vo::Matrix m = vo::modelViewMatrix(view.model, view.orientation, view.volume);
    double at[3];
    for (std::size_t row = 0; row < 3; row++)
        at[row] = m[row] * double(position[0]) + m[4 + row] * double(position[1]) +
                  m[8 + row] * double(position[2]) + m[12 + row];
    return {at[0], at[1], at[2]};
}

// Units of eye space in a pixel, at a depth. What lies behind the eye is nowhere near a pixel.
double pixelSize(const VoglView& view, double z)
{
    const double pixel = 2 * view.volume.halfWidth / view.width;
    return view.volume.distance == 0 ? pixel : pixel * std::max(-z, 1e-6) / view.volume.distance;
}

// Adds a vector of eye space.
void moveAcross(const VoglView& view, double x, double y, float position[3])
{
    const vo::Matrix m = vo::modelViewMatrix(view.model, view.orientation, view.volume);
    for (std::size_t axis = 0; axis < 3; axis++) {
        const double* column = m.data() + 4 * axis; // at right angles to the others
        const double square = column[0] * column[0] + column[1] * column[1] + column[2] * column[2];
        position[axis] += float((column[0] * x + column[1] * y) / square);
    }
}

} // namespace

VertexDrag::VertexDrag(const voutLattice& lattice, const VoglView& view, double x, double y)
    : startX_(x), startY_(y)
{
    const double same = 0.5; // pixels
    double nearest = HUGE_VAL, depth = 0;
    for (int vertex = 0; vertex < lattice.getVertexCount(); vertex++) {
        float position[3];
        lattice.getVertex(vertex, position);
        const EyePoint point = seen(view, position);
        const double pixel = pixelSize(view, point.z);
        const double away =
            std::hypot(point.x / pixel + 0.5 * view.width - x, point.y / pixel + 0.5 * view.height - y);
        if (away > nearest + same || (away > nearest - same && point.z <= depth)) continue;
        nearest = std::min(away, nearest);
        depth = point.z;
        vertex_ = vertex;
    }
    lattice.getVertex(vertex_, position_);
}

void VertexDrag::dragTo(voutLattice& lattice, const VoglView& view, double x, double y) const
{
    float moved[3];
    std::copy_n(position_, 3, moved);
    const double pixel = pixelSize(view, seen(view, position_).z);
    moveAcross(view, (x - startX_) * pixel, (y - startY_) * pixel, moved);
    lattice.setVertex(vertex_, moved);
}
