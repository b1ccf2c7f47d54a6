#include "vout/surface_mesher.h"

#include "legacy/report.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace vo {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

void requireReadable(const std::string& fileName)
{
    if (std::filesystem::is_directory(fileName)) badValue(fileName + ": expected a file, found a folder");
    if (!std::ifstream(fileName)) badValue(fileName + ": cannot be opened");
}

/// Keeps what CGAL's readers print from standard error: what is wrong is told by voError.
class Silence
{
public:
    Silence() : before_(std::cerr.rdbuf(nullptr)) {}
    ~Silence()
    {
        std::cerr.rdbuf(before_);
        std::cerr.clear();
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    std::streambuf* before_;
};

bool readPolygons(const std::string& fileName, std::vector<Point>& points,
                  std::vector<std::vector<std::size_t>>& polygons)
{
    const Silence silence;
    return CGAL::IO::read_polygon_soup(fileName, points, polygons);
}

} // namespace

TriangleSurface readSurface(const std::string& fileName)
{
    requireReadable(fileName);
    std::vector<Point> points;
    std::vector<std::vector<std::size_t>> polygons;
    if (!readPolygons(fileName, points, polygons))
        badValue(fileName +
                 ": expected polygons in OFF, PLY, STL or OBJ, as the name ends; they are damaged or there "
                 "are none");
    TriangleSurface surface;
    for (const Point& p : points)
        surface.vertices.push_back({p.x(), p.y(), p.z()});
    for (const std::vector<std::size_t>& polygon : polygons) {
        for (const std::size_t corner : polygon)
            if (corner >= points.size())
                badValue(fileName + ": a polygon names vertex " + std::to_string(corner) + " of " +
                         std::to_string(points.size()));
        // Flat and convex ones fall into triangles round their first corner.
        for (std::size_t i = 2; i < polygon.size(); ++i)
            surface.triangles.push_back({static_cast<int>(polygon[0]), static_cast<int>(polygon[i - 1]),
                                         static_cast<int>(polygon[i])});
    }
    return surface;
}

} // namespace vo
