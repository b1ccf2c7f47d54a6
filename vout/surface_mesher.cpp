#include "vout/surface_mesher.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedral_complex_mesh_domain_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/make_mesh_3.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <map>
#include <stdexcept>

// The one file that instantiates CGAL's mesh generator: a minute and 3 GB of compiling.

namespace vo {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain = CGAL::Polyhedral_complex_mesh_domain_3<Kernel, SurfaceMesh>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex =
    CGAL::Mesh_complex_3_in_triangulation_3<Triangulation, Domain::Corner_index, Domain::Curve_index>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// Tetrahedra with a smaller dihedral angle, in degrees, are mended.
constexpr double kSliverAngle = 10;

// Subdomains; CGAL takes 0 for what is outside.
constexpr int kOutside = 0, kInner = 1, kRest = 2;

SurfaceMesh surfaceMesh(const TriangleSurface& surface)
{
    SurfaceMesh mesh;
    std::vector<SurfaceMesh::Vertex_index> vertices;
    for (const glm::dvec3& v : surface.vertices)
        vertices.push_back(mesh.add_vertex({v.x, v.y, v.z}));
    const auto at = [&](int vertex) { return vertices[static_cast<std::size_t>(vertex)]; };
    for (const auto& [a, b, c] : surface.triangles)
        if (mesh.add_face(at(a), at(b), at(c)) == SurfaceMesh::null_face())
            throw std::logic_error("a triangle does not fit to its neighbours");
    return mesh;
}

/// The corners of each part of the surface that reach farthest along each axis, with a triangle of theirs.
std::map<int, std::size_t> farthestCorners(const TriangleSurface& surface)
{
    const std::vector<int> components = componentsOf(surface);
    std::map<int, std::array<std::pair<int, std::size_t>, 6>> ends; // of each part
    for (std::size_t t = 0; t < components.size(); ++t)
        for (const int corner : surface.triangles[t]) {
            const auto [own, isNew] = ends.try_emplace(components[t]);
            for (std::size_t end = 0; end < 6; ++end) {
                const auto along = [&](int vertex) {
                    const double x =
                        surface.vertices[static_cast<std::size_t>(vertex)][static_cast<int>(end / 2)];
                    return end % 2 == 0 ? x : -x;
                };
                std::pair<int, std::size_t>& farthest = own->second[end];
                if (isNew || along(corner) > along(farthest.first)) farthest = {corner, t};
            }
        }
    std::map<int, std::size_t> corners;
    for (const auto& [component, farthest] : ends)
        corners.insert(farthest.begin(), farthest.end());
    return corners;
}

/// Of several parts some may lie where none of CGAL's first points, on rays from the middle and on sharp
/// edges, is near: each part gets some of its own.
void addFirstPoints(Complex& complex, const Domain& domain, const TriangleSurface& surface)
{
    const SurfaceMesh& mesh = domain.polyhedra().front();
    const auto patches = get(CGAL::face_patch_id_t<Domain::Surface_patch_index>(), mesh);
    Triangulation& triangulation = complex.triangulation();
    for (const auto& [corner, triangle] : farthestCorners(surface)) {
        const glm::dvec3& v = surface.vertices[static_cast<std::size_t>(corner)];
        const Kernel::Point_3 point(v.x, v.y, v.z);
        const Complex::Vertex_handle near = triangulation.nearest_power_vertex(point);
        if (near != Complex::Vertex_handle()) {
            const auto& ball = triangulation.point(near);
            if (CGAL::squared_distance(ball.point(), point) <= ball.weight()) continue; // on a sharp edge
        }
        const Complex::Vertex_handle vertex = triangulation.insert(Triangulation::Weighted_point(point));
        complex.set_dimension(vertex, 2);
        complex.set_index(vertex, domain.index_from_surface_patch_index(get(
                                      patches, SurfaceMesh::Face_index(static_cast<unsigned>(triangle)))));
    }
}

/// How far apart vertices are on sharp edges. They are kept by balls, which must not reach another surface:
/// near the box the surface has small ones, and near the surface the box.
struct EdgeLength
{
    using FT = Kernel::FT;

    double longest, clearanceShare;
    bool hasBox;
    glm::dvec3 lower, upper;       // of the surface
    glm::dvec3 boxLower, boxUpper; // of the box

    FT operator()(const Kernel::Point_3& point, int, const Domain::Index&) const
    {
        if (!hasBox) return longest;
        const glm::dvec3 p(point.x(), point.y(), point.z());
        const glm::dvec3 toBox = glm::min(p - boxLower, boxUpper - p);
        const glm::dvec3 toSurface = glm::max(glm::max(lower - p, p - upper), glm::dvec3(0));
        const double clearance = std::max(std::min({toBox.x, toBox.y, toBox.z}), glm::length(toSurface));
        return std::min(longest, clearanceShare * clearance);
    }
};

RegionMesh regionsOf(const Complex& complex)
{
    RegionMesh mesh;
    std::map<Complex::Vertex_handle, int> numbers;
    const Triangulation& triangulation = complex.triangulation();
    for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
        std::array<int, 4> tetra;
        for (int i = 0; i < 4; ++i) {
            const Complex::Vertex_handle vertex = cell->vertex(i);
            const auto [found, isNew] = numbers.try_emplace(vertex, static_cast<int>(numbers.size()));
            if (isNew) {
                const auto& point = triangulation.point(vertex);
                mesh.vertices.push_back({point.x(), point.y(), point.z()});
            }
            tetra[static_cast<std::size_t>(i)] = found->second;
        }
        mesh.tetras.push_back(tetra);
        mesh.regions.push_back(complex.subdomain_index(cell) == kInner ? 0 : 1);
    }
    return mesh;
}

} // namespace

std::size_t countCrossings(const TriangleSurface& surface)
{
    const SurfaceMesh mesh = surfaceMesh(surface);
    std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    return pairs.size();
}

void orientOutwards(TriangleSurface& surface)
{
    SurfaceMesh mesh = surfaceMesh(surface);
    CGAL::Polygon_mesh_processing::orient_to_bound_a_volume(mesh);
    for (const SurfaceMesh::Face_index face : mesh.faces()) {
        std::array<int, 3>& triangle = surface.triangles[static_cast<std::size_t>(face)];
        std::size_t i = 0;
        for (const SurfaceMesh::Vertex_index vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            triangle[i++] = static_cast<int>(vertex);
    }
}

RegionMesh meshInside(const TriangleSurface& surface, const TriangleSurface* box, const MeshSizes& sizes)
{
    namespace parameters = CGAL::parameters;
    std::vector<SurfaceMesh> surfaces{surfaceMesh(surface)};
    std::vector<std::pair<int, int>> sides{{kInner, box ? kRest : kOutside}}; // within, without
    if (box) {
        surfaces.push_back(surfaceMesh(*box));
        sides.push_back({kRest, kOutside});
    }
    CGAL::Random random(1);
    CGAL::get_default_random() = random; // equal arguments give equal meshes
    Domain domain(surfaces.begin(), surfaces.end(), sides.begin(), sides.end(), &random);
    domain.detect_features(sizes.sharpAngle);

    EdgeLength edgeLength{
        sizes.edge, sizes.clearanceShare, box != nullptr, surface.lower(), surface.upper(), {}, {}};
    if (box) {
        edgeLength.boxLower = box->lower();
        edgeLength.boxUpper = box->upper();
    }
    // Circumradii of the equilateral triangle and of the regular tetrahedron, and a little more. What is
    // mended moves away from the surface.
    const Criteria criteria(parameters::edge_size = edgeLength, parameters::facet_angle = 25,
                            parameters::facet_size = 0.65 * sizes.edge,
                            parameters::facet_distance = 0.7 * sizes.distance,
                            parameters::facet_topology = CGAL::FACET_VERTICES_ON_SAME_SURFACE_PATCH,
                            parameters::cell_radius_edge_ratio = 2, parameters::cell_size = 0.7 * sizes.edge);
    Complex complex;
    CGAL::Mesh_3::internal::C3t3_initializer<Complex, Domain, Criteria, true>()(complex, domain, criteria,
                                                                                true);
    addFirstPoints(complex, domain, surface);
    CGAL::refine_mesh_3(complex, domain, criteria, parameters::no_perturb(), parameters::no_exude(),
                        parameters::no_reset_c3t3());
    CGAL::perturb_mesh_3(complex, domain, parameters::sliver_bound = kSliverAngle);
    CGAL::exude_mesh_3(complex, parameters::sliver_bound = kSliverAngle);
    return regionsOf(complex);
}

} // namespace vo
