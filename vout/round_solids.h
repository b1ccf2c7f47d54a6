#pragma once

#include "vout/solid.h"

namespace vo {

// Solids of revolution. check() throws CallerError for numbers that give none, or one of too many cells; solidOf()
// takes checked ones.

struct Ball
{
    glm::dvec3 center;
    double radius;
    int slices;
    int stacks;
};
void check(const Ball& ball);
Solid solidOf(const Ball& ball);

/// A cylinder, or a cone that has its tip at the top.
struct Column
{
    glm::dvec3 base;
    glm::dvec3 top;
    double radius;
    int slices;
    int stacks;
    bool isCone;
};
void check(const Column& column);
Solid solidOf(const Column& column);

struct Torus
{
    glm::dvec3 center;
    double radius;
    double tubeRadius;
    int slices;
    int sides;
};
void check(const Torus& torus);
Solid solidOf(const Torus& torus);

} // namespace vo
