#include "vout/round_solids.h"

#include "legacy/report.h"

#include "vout/axis_frame.h"

#include <numbers>

namespace vo {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

std::size_t product(int a, int b)
{
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(b);
}

/// Adds `count` vertices round a middle; returns the first one's number.
int addRing(Solid& solid, const glm::dvec3& middle, const AxisFrame& frame, double radius, int count)
{
    const auto first = static_cast<int>(solid.vertices.size());
    for (int i = 0; i < count; ++i)
        solid.add(middle + radius * frame.at(kTurn * i / count));
    return first;
}

/// The tetrahedra from the ends of a line through a ring to the ring's sides.
void addTetras(Cells& tetras, int lower, int ring, int upper, int count)
{
    for (int i = 0; i < count; ++i)
        tetras.add({lower, ring + i, ring + (i + 1) % count, upper});
}

/// The pyramids from what lies between the sides of two rings to a tip.
void addPyramids(Cells& pyramids, int ring, int ringAbove, int tip, int count)
{
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        pyramids.add({ring + i, ring + next, ringAbove + next, ringAbove + i, tip});
    }
}

/// The prisms from a middle to the sides of a ring, up to another such ring.
void addPrisms(Cells& prisms, int middle, int ring, int middleAbove, int ringAbove, int count)
{
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        prisms.add({middle, ring + i, ring + next, middleAbove, ringAbove + i, ringAbove + next});
    }
}

} // namespace

void check(const Ball& ball)
{
    requireFinite("the centre", ball.center);
    requirePositive("the radius", ball.radius);
    requireAtLeast("slices", ball.slices, 3);
    requireAtLeast("stacks", ball.stacks, 2);
    requireCountable(product(ball.slices, ball.stacks), 2);
}

Solid solidOf(const Ball& ball)
{
    const AxisFrame frame({0, 0, 1});
    Solid solid;
    Cells caps{CellKind::tetra, {}}, wedges{CellKind::pyramid, {}};
    const int center = solid.add(ball.center);
    const int bottom = solid.add(ball.center - glm::dvec3(0, 0, ball.radius));
    const int top = solid.add(ball.center + glm::dvec3(0, 0, ball.radius));
    int below = -1;
    for (int stack = 1; stack < ball.stacks; ++stack) {
        const double angle = std::numbers::pi * stack / ball.stacks;
        const glm::dvec3 middle = ball.center - glm::dvec3(0, 0, ball.radius * std::cos(angle));
        const int ring = addRing(solid, middle, frame, ball.radius * std::sin(angle), ball.slices);
        if (stack == 1) addTetras(caps, bottom, ring, center, ball.slices);
        if (stack > 1) addPyramids(wedges, below, ring, center, ball.slices);
        if (stack == ball.stacks - 1) addTetras(caps, center, ring, top, ball.slices);
        below = ring;
    }
    solid.parts = {caps, wedges};
    return solid;
}

void check(const Column& column)
{
    requireFinite("the base", column.base);
    requireFinite("the top", column.top);
    requirePositive("the radius", column.radius);
    requirePositive("the height", glm::length(column.top - column.base));
    requireAtLeast("slices", column.slices, 3);
    requireAtLeast("stacks", column.stacks, 1);
    requireCountable(product(column.slices, column.stacks), 3);
}

Solid solidOf(const Column& column)
{
    const AxisFrame frame(column.top - column.base);
    Solid solid;
    Cells prisms{CellKind::prism, {}}, tips{CellKind::tetra, {}};
    int below = -1, belowRing = -1;
    for (int stack = 0; stack <= column.stacks; ++stack) {
        const double part = static_cast<double>(stack) / column.stacks;
        const glm::dvec3 middle = column.base + part * (column.top - column.base);
        const int axis = solid.add(middle);
        if (column.isCone && stack == column.stacks) {
            addTetras(tips, below, belowRing, axis, column.slices);
            break;
        }
        const double radius = column.isCone ? (1 - part) * column.radius : column.radius;
        const int ring = addRing(solid, middle, frame, radius, column.slices);
        if (stack > 0) addPrisms(prisms, below, belowRing, axis, ring, column.slices);
        below = axis;
        belowRing = ring;
    }
    solid.parts = {prisms, tips};
    return solid;
}

void check(const Torus& torus)
{
    requireFinite("the centre", torus.center);
    requirePositive("the radius", torus.radius);
    requirePositive("the tube's radius", torus.tubeRadius);
    if (torus.tubeRadius >= torus.radius) badValue("the tube's radius is not less than the ring's");
    requireAtLeast("slices", torus.slices, 3);
    requireAtLeast("sides", torus.sides, 3);
    requireCountable(product(torus.slices, torus.sides), 3);
}

Solid solidOf(const Torus& torus)
{
    const AxisFrame frame({0, 0, 1});
    Solid solid;
    for (int slice = 0; slice < torus.slices; ++slice) {
        const glm::dvec3 outward = frame.at(kTurn * slice / torus.slices);
        const glm::dvec3 middle = torus.center + torus.radius * outward;
        solid.add(middle);
        for (int side = 0; side < torus.sides; ++side) {
            const double angle = kTurn * side / torus.sides;
            solid.add(middle + torus.tubeRadius * (std::cos(angle) * outward + glm::dvec3(0, 0, std::sin(angle))));
        }
    }
    Cells prisms{CellKind::prism, {}};
    for (int slice = 0; slice < torus.slices; ++slice) {
        const int here = slice * (torus.sides + 1), there = (slice + 1) % torus.slices * (torus.sides + 1);
        addPrisms(prisms, here, here + 1, there, there + 1, torus.sides);
    }
    solid.parts = {prisms};
    return solid;
}

} // namespace vo
