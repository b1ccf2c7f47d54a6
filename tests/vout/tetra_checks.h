#pragma once

// What holds of every solid's tetrahedra, judged from their vertices alone.

#include <vo/Geometry.h>

#include <glm/vec3.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace vo::test {

/// A copy of a set.
struct Tetras
{
    int values = 3;
    std::vector<std::vector<float>> records;
    std::vector<std::array<int, 4>> corners;

    glm::dvec3 position(int vertex) const;
    /// Tetrahedra of both, as if on one array of records that they share.
    void append(const Tetras& other);
};

/// Deletes the set. NULL is a failure, and gives nothing.
Tetras taken(voIndexedTetraSet* set);

/// The sum of signed volumes.
double volumeOf(const Tetras& tetras);

/// The area of the faces that belong to one tetrahedron only.
double areaOf(const Tetras& tetras);

/// The angle between two of its faces in degrees, the smallest one.
double smallestDihedral(const Tetras& tetras);

/// The faces that belong to one tetrahedron only, counter-clockwise as seen from outside.
std::vector<std::array<int, 3>> boundaryFaces(const Tetras& tetras);

/// Vertices of these faces, each once.
std::vector<int> boundaryVertices(const Tetras& tetras);

// Each answers what is wrong, or an empty text.

/// All are positively oriented.
std::string wrongHandedness(const Tetras& tetras);
/// A face belongs to one tetrahedron, or to two that lie on its two sides.
std::string unmatchedFaces(const Tetras& tetras);
/// No point lies inside two; by separating planes, for all pairs.
std::string overlaps(const Tetras& tetras);

/// Flat polygons round a solid, counter-clockwise as seen from outside.
struct Surface
{
    std::vector<std::vector<glm::dvec3>> polygons;

    /// By the divergence theorem.
    double volume() const;
    double area() const;
};

/// The surface of a parallelepiped from a corner along three edges.
Surface boxSurface(const glm::dvec3& corner, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c);

/// All of the above, and volume and surface within 1e-6 of what is expected. A face inside that its
/// neighbours do not share vertex for vertex would count as surface.
void expectSolid(const Tetras& tetras, double volume, double area);
void expectSolid(const Tetras& tetras, const Surface& surface);

} // namespace vo::test
