#pragma once

#include "volume_io/result.h"

#include <array>
#include <string>
#include <vector>

/** Tetrahedra with a colour at each vertex. */
struct Mesh
{
    struct Vertex
    {
        /** Red, green, blue and alpha, the opacity of one slice, from 0 to 1. */
        std::array<float, 4> color;
        std::array<float, 3> position;
    };
    std::vector<Vertex> vertices;
    /** Four vertex numbers each. */
    std::vector<int> tetras;
};

/** A flow round a cylinder that stands across it, on a grid round the cylinder whose cells grow outwards. The
    colour is the pressure: red where the fluid is stopped, blue where it is sucked off. */
Mesh flowMesh();

/** Reads a text file of lines `v X Y Z RED GREEN BLUE ALPHA` for the vertices and `t A B C D` for tetrahedra
    between them, counted from 0 in the order of the file. # begins a comment, empty lines are passed over. A
    failure names the file and the line. */
vo::Result<Mesh> readMesh(const std::string& path);
