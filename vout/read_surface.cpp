#include "vout/surface_mesher.h"

#include "legacy/report.h"

#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Simple_cartesian.h>

#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace vo {

namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

std::string wholeNumber(double number)
{
    std::ostringstream text;
    text << std::setprecision(17) << number;
    return text.str();
}

void requireReadable(const std::string& fileName)
{
    if (std::filesystem::is_directory(fileName)) badValue(fileName + ": expected a file, found a folder");
    if (!std::ifstream(fileName)) badValue(fileName + ": cannot be opened: " + std::strerror(errno));
}

std::string endingOf(const std::string& fileName)
{
    std::string ending = std::filesystem::path(fileName).extension().string();
    for (char& letter : ending)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    return ending;
}

/// CGAL's reader of PLY takes for granted that properties follow their element.
void requirePropertiesOfElements(const std::string& fileName)
{
    std::ifstream file(fileName, std::ios::binary);
    bool hasElement = false;
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string word, name;
        std::int64_t count = 0;
        words >> word;
        if (word == "end_header") return;
        if (word == "element") {
            if (!(words >> name >> count) || count < 0)
                badValue(fileName + ": damaged: expected a name and a count in \"" + line.substr(0, 80) + "\"");
            hasElement = true;
        } else if (word == "property" && !hasElement) {
            badValue(fileName + ": damaged: its header has a property before any element");
        }
    }
    badValue(fileName + ": cut off: its header has no end");
}

/// CGAL's reader of OFF makes room for as much as the header says.
void requireRoomForCounts(const std::string& fileName)
{
    std::ifstream file(fileName, std::ios::binary);
    const double bytes = static_cast<double>(std::filesystem::file_size(fileName));
    double counts[2]{};
    int found = 0;
    for (std::string word; found < 2 && file >> word;) {
        if (word[0] == '#') {
            std::getline(file, word);
            continue;
        }
        std::istringstream number(word);
        if (number >> counts[found]) ++found;
        else if (found > 0) return;
    }
    // "0 0 0" and "3 0 1 2" on lines of their own.
    if (found == 2 && 6 * counts[0] + 8 * counts[1] > bytes + 2)
        badValue(fileName + ": cut off: its header has " + wholeNumber(counts[0]) + " vertices and " +
                 wholeNumber(counts[1]) + " polygons, the file " + wholeNumber(bytes) + " bytes");
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
    if (endingOf(fileName) == ".ply") requirePropertiesOfElements(fileName);
    if (endingOf(fileName) == ".off") requireRoomForCounts(fileName);
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
