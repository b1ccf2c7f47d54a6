#include <vo/utLattice.h>

#include "legacy/report.h"

#include "vout/box_lattice.h"
#include "vout/warp_point.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

using vo::badValue;
using vo::guarded;
using vo::required;

struct voutLattice::Private
{
    vo::Lattice lattice;
    glm::dvec3 spacing{1};
    vo::HexaSplit split = vo::HexaSplit::five;

    glm::dvec3 middle() const { return 0.5 * (lattice.lower() + lattice.upper()); }
    /// In units of the spacing.
    glm::dvec3 size() const { return (lattice.upper() - lattice.lower()) * spacing; }

    const glm::dvec3& position(int vertex) const
    {
        requireVertex(vertex);
        return lattice.positions()[static_cast<std::size_t>(vertex)];
    }
    void requireVertex(int vertex) const
    {
        if (vertex < 0 || vertex >= lattice.vertexCount())
            badValue("vertex " + std::to_string(vertex) + " of " + std::to_string(lattice.vertexCount()));
    }
    void requireLattice() const
    {
        if (lattice.vertexCount() == 0) badValue("there is no lattice");
    }
    /// Moves all vertices as `moved` does points from the box's middle in units of the spacing.
    template <typename Moved>
    void moveEach(Moved moved)
    {
        requireLattice();
        std::vector<glm::dvec3> positions = lattice.positions();
        for (glm::dvec3& position : positions)
            position = moved((position - middle()) * spacing) / spacing + middle();
        lattice.moveTo(std::move(positions));
    }
    vo::FoldCount folds() const
    {
        requireLattice();
        return vo::countFolds(lattice.tetras(split));
    }
};

namespace {

glm::dvec3 pointOf(const float* numbers, const char* name)
{
    required(numbers, name);
    return {numbers[0], numbers[1], numbers[2]};
}

void write(const glm::dvec3& point, float* numbers, const char* name)
{
    required(numbers, name);
    for (int axis = 0; axis < 3; ++axis)
        numbers[axis] = static_cast<float>(point[axis]);
}

double radians(float degrees)
{
    if (!std::isfinite(degrees)) badValue("an angle is not finite");
    return static_cast<double>(degrees) * std::numbers::pi / 180;
}

void requireAxis(int axis)
{
    if (axis < 0 || axis > 2) badValue("axis " + std::to_string(axis) + ", there are 0, 1 and 2");
}

void requireAxes(int axis, int other)
{
    requireAxis(axis);
    requireAxis(other);
    if (axis == other) badValue("two axes are the same");
}

vo::Fan fanOf(int depthAxis, int beamAxis, float degrees, float r0, float r1, float elevation)
{
    requireAxes(depthAxis, beamAxis);
    if (!(r0 >= 0 && r1 > r0)) badValue("radii are not in order: 0 <= r0 < r1");
    return {depthAxis,         beamAxis, radians(degrees), static_cast<double>(r0), static_cast<double>(r1),
            radians(elevation)};
}

vo::VectorField fieldOf(const float* vectors, const int* sizes)
{
    required(vectors, "vectors");
    required(sizes, "sizes");
    std::size_t count = 3;
    for (int axis = 0; axis < 3; ++axis) {
        if (sizes[axis] < 1) badValue("a field of " + std::to_string(sizes[axis]) + " vectors along an axis");
        count *= static_cast<std::size_t>(sizes[axis]);
    }
    return {{vectors, count}, {sizes[0], sizes[1], sizes[2]}};
}

} // namespace

voutLattice::voutLattice(int nx, int ny, int nz, const float lower[3], const float upper[3]) : d(new Private)
{
    guarded("voutLattice", [&] {
        d->lattice = vo::Lattice({nx, ny, nz}, pointOf(lower, "lower"), pointOf(upper, "upper"));
    });
}

voutLattice::~voutLattice()
{
    delete d;
}

void voutLattice::getSizes(int& nx, int& ny, int& nz) const
{
    const glm::ivec3& boxes = d->lattice.boxes();
    nx = boxes.x;
    ny = boxes.y;
    nz = boxes.z;
}

void voutLattice::setTetrasPerHexa(int count)
{
    guarded("voutLattice::setTetrasPerHexa", [&] { d->split = vo::hexaSplit(count); });
}

int voutLattice::getTetrasPerHexa() const
{
    return static_cast<int>(d->split);
}

void voutLattice::setSpacing(const float spacing[3])
{
    guarded("voutLattice::setSpacing", [&] {
        const glm::dvec3 distances = pointOf(spacing, "spacing");
        for (int axis = 0; axis < 3; ++axis)
            if (!(distances[axis] > 0 && std::isfinite(distances[axis])))
                badValue("a spacing is not above 0");
        d->spacing = distances;
    });
}

int voutLattice::getVertexCount() const
{
    return d->lattice.vertexCount();
}

int voutLattice::getVertexIndex(int i, int j, int k) const
{
    int number = -1;
    guarded("voutLattice::getVertexIndex", [&] {
        d->requireLattice();
        const glm::ivec3 at(i, j, k);
        for (int axis = 0; axis < 3; ++axis)
            if (at[axis] < 0 || at[axis] > d->lattice.boxes()[axis])
                badValue("vertex " + std::to_string(at[axis]) + " along an axis of " +
                         std::to_string(d->lattice.boxes()[axis]) + " boxes");
        number = d->lattice.vertexNumber(i, j, k);
    });
    return number;
}

void voutLattice::getVoxelCoordinates(int vertex, float voxel[3]) const
{
    guarded("voutLattice::getVoxelCoordinates", [&] {
        d->requireVertex(vertex);
        write(d->lattice.voxel(vertex), voxel, "voxel");
    });
}

void voutLattice::getVertex(int vertex, float position[3]) const
{
    guarded("voutLattice::getVertex", [&] { write(d->position(vertex), position, "position"); });
}

void voutLattice::setVertex(int vertex, const float position[3])
{
    guarded("voutLattice::setVertex", [&] {
        d->requireVertex(vertex);
        d->lattice.moveVertex(vertex, pointOf(position, "position"));
    });
}

void voutLattice::reset()
{
    d->lattice.reset();
}

void voutLattice::warp(void (*function)(float position[3], void* user), void* user)
{
    guarded("voutLattice::warp", [&] {
        required(function, "function");
        d->requireLattice();
        std::vector<glm::dvec3> positions = d->lattice.positions();
        for (glm::dvec3& position : positions) {
            float moved[3];
            write(position, moved, "position");
            function(moved, user);
            position = pointOf(moved, "position");
        }
        d->lattice.moveTo(std::move(positions));
    });
}

void voutLattice::twist(int axis, float degrees)
{
    guarded("voutLattice::twist", [&] {
        requireAxis(axis);
        const double angle = radians(degrees);
        d->moveEach([&](const glm::dvec3& point) { return vo::twisted(point, d->size(), axis, angle); });
    });
}

void voutLattice::bend(int axis, int towards, float degrees)
{
    guarded("voutLattice::bend", [&] {
        requireAxes(axis, towards);
        const double angle = radians(degrees);
        d->moveEach(
            [&](const glm::dvec3& point) { return vo::bent(point, d->size(), axis, towards, angle); });
    });
}

void voutLattice::taper(int axis, float factor)
{
    guarded("voutLattice::taper", [&] {
        requireAxis(axis);
        d->moveEach([&](const glm::dvec3& point) {
            return vo::tapered(point, d->size(), axis, static_cast<double>(factor));
        });
    });
}

void voutLattice::fan(int depthAxis, int beamAxis, float degrees, float r0, float r1, float elevation)
{
    guarded("voutLattice::fan", [&] {
        const vo::Fan fan = fanOf(depthAxis, beamAxis, degrees, r0, r1, elevation);
        glm::dvec3 tip(0);
        tip[depthAxis] = -0.5 * d->size()[depthAxis] - fan.innerRadius;
        d->moveEach([&](const glm::dvec3& point) { return tip + vo::fanned(point, d->size(), fan); });
    });
}

void voutLattice::cylinder(int depthAxis, int beamAxis, float r0, float r1, float degrees)
{
    guarded("voutLattice::cylinder", [&] {
        const vo::Fan fan = fanOf(depthAxis, beamAxis, degrees, r0, r1, 0);
        d->moveEach([&](const glm::dvec3& point) { return vo::fanned(point, d->size(), fan); });
    });
}

void voutLattice::displace(const float* vectors, const int sizes[3], float scale)
{
    guarded("voutLattice::displace", [&] {
        const vo::VectorField field = fieldOf(vectors, sizes);
        d->moveEach([&](const glm::dvec3& point) {
            return point + static_cast<double>(scale) * vo::vectorAt(point, d->size(), field);
        });
    });
}

void voutLattice::fit()
{
    guarded("voutLattice::fit", [&] {
        d->requireLattice();
        glm::dvec3 least = d->lattice.positions()[0], most = least;
        for (const glm::dvec3& position : d->lattice.positions()) {
            least = glm::min(least, position);
            most = glm::max(most, position);
        }
        const glm::dvec3 from = (0.5 * (least + most) - d->middle()) * d->spacing;
        double farthest = 0;
        for (const glm::dvec3& position : d->lattice.positions())
            farthest = std::max(farthest, glm::distance((position - d->middle()) * d->spacing, from));
        if (!(farthest > 0)) badValue("all vertices lie at one point");
        const double scale = 0.5 * glm::length(d->size()) / farthest;
        d->moveEach([&](const glm::dvec3& point) { return scale * (point - from); });
    });
}

int voutLattice::countInverted() const
{
    int count = -1;
    guarded("voutLattice::countInverted", [&] { count = d->folds().inverted; });
    return count;
}

int voutLattice::countFlat() const
{
    int count = -1;
    guarded("voutLattice::countFlat", [&] { count = d->folds().flat; });
    return count;
}

voIndexedTetraSet* voutLattice::tessellate()
{
    std::unique_ptr<voIndexedTetraSet> tetras;
    guarded("voutLattice::tessellate", [&] {
        d->requireLattice();
        tetras = vo::tetraSet(d->lattice.tetras(d->split));
    });
    return tetras.release();
}
