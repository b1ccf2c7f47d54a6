#pragma once

#include "mesh_io/mesh_io.h"

#include <array>
#include <string>
#include <vector>

/** Which numbers of a mesh are shown. */
struct FieldChoice
{
    /** Empty: the first of one component at points, else on cells; else the first of any. */
    std::string name;
    /** From 0; -1: the length of a vector. */
    int component = -1;
};

/** Tetrahedra to be drawn, with a number or a colour at each vertex. */
struct MeshScene
{
    /** Moved and enlarged: the longest side becomes kLongestSide, the lowest corner the origin. */
    std::vector<std::array<float, 3>> positions;
    /** Four vertex numbers each. */
    std::vector<int> tetras;
    /** Faces of all cells: a count, then vertex numbers. */
    std::vector<int> faces;
    /** One for each vertex; else colours, from 0 to 1. */
    std::vector<double> values;
    std::vector<std::array<float, 4>> colors;
    /** The smallest and largest value. */
    double low = 0, high = 0;
    /** The field, with its component. */
    std::string fieldName;
    /** Cells left out since they have no number there. */
    std::int64_t cellsWithoutValue = 0;
    /** The box that all lies in. */
    std::array<float, 3> size{};
};

/** Those of `faces` that one cell alone has: where the mesh ends. */
std::vector<int> outerFaces(const std::vector<int>& faces);

constexpr double kLongestSide = 128;

/** A failure, without the file's name, where there is no such field or component, or the tetrahedra are too
    many. Vertices are shared, but for fields on cells, where each tetrahedron has its own. */
vo::Result<MeshScene> makeScene(const vo::Mesh& mesh, const FieldChoice& choice);
