// Closed surfaces in a build without CGAL.
#include "vout/surface_mesher.h"

#include "legacy/report.h"

namespace vo {

namespace {

[[noreturn]] void withoutCgal()
{
    unsupported("this library was built without CGAL, which makes tetrahedra of closed surfaces");
}

} // namespace

std::size_t countCrossings(const TriangleSurface&)
{
    withoutCgal();
}

void orientOutwards(TriangleSurface&)
{
    withoutCgal();
}

RegionMesh meshInside(const TriangleSurface&, const TriangleSurface*, const MeshSizes&)
{
    withoutCgal();
}

TriangleSurface readSurface(const std::string&)
{
    withoutCgal();
}

} // namespace vo
