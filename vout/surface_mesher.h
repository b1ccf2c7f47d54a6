#pragma once

#include "vout/triangle_surface.h"

#include <string>

// What is taken from CGAL; without it all of these throw CallerError with UNSUPPORTED.

namespace vo {

struct MeshSizes
{
    /// Lengths of edges are about this, and seldom more.
    double edge;
    /// How far triangles of the mesh may be away from the surface.
    double distance;
    /// Edges where the normals of triangles differ by more, in degrees, are edges of the mesh.
    double sharpAngle;
    /// Near a box vertices on sharp edges are as near to each other as this part of the distance between box
    /// and surface.
    double clearanceShare = 0.9;
};

/// Tetrahedra of one region or two, of positive volume.
struct RegionMesh
{
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<int, 4>> tetras;
    /// Of each tetrahedron: 0 inside of the surface, 1 between it and the box.
    std::vector<char> regions;
};

/// How many pairs of triangles cross or touch one another where they share nothing. The surface is closed.
std::size_t countCrossings(const TriangleSurface& surface);

/// Turns the triangles so that they bound a solid, counter-clockwise as seen from outside of it: of a surface
/// within another one, what is between them. Nothing crosses.
void orientOutwards(TriangleSurface& surface);

/// Tetrahedra inside of an oriented surface, and with a box, which lies round it, those in the rest of that.
/// The same for the same arguments. Throws std::exception where meshing fails.
RegionMesh meshInside(const TriangleSurface& surface, const TriangleSurface* box, const MeshSizes& sizes);

/// A file in OFF, PLY, STL or OBJ, by the ending of its name; polygons become triangles. Throws CallerError.
TriangleSurface readSurface(const std::string& fileName);

} // namespace vo
