// This library cuts a lattice of tetrahedra with many planes at once. VO_THREADS of the environment counts.
//
//     volumizer_slices CELLS PLANES BRICKS-PER-AXIS stack|faces
//
// stack: plane-major arrays of all polygons; faces: one polygon after the other, as into the face sets of the
// interface of 1998.
#include "bench_planes.h"
#include "bench_scene.h"
#include "bench_worker.h"

#include "polygonize/polygonize.h"
#include "polygonize/slice_stack.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>

namespace {

constexpr double kSide = 256.0;

/// Keeps the last polygons, copied into memory reserved before, and counts.
struct FaceStore : vo::FaceSink
{
    std::vector<float> store = std::vector<float>(std::size_t{1} << 24);
    std::size_t used = 0;
    double polygons = 0.0;
    double area = 0.0;
    bool measureArea = false;

    bool append(int, int, std::span<const float> records) override
    {
        if (used + records.size() > store.size()) used = 0;
        std::copy(records.begin(), records.end(), store.begin() + static_cast<std::ptrdiff_t>(used));
        used += records.size();
        if (measureArea) add(records);
        return true;
    }

    void add(std::span<const float> records)
    {
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(records[3 * i], records[3 * i + 1], records[3 * i + 2]);
        };
        glm::dvec3 sum(0.0);
        for (std::size_t i = 1; 3 * (i + 1) < records.size(); ++i)
            sum += 0.5 * glm::cross(corner(i) - corner(0), corner(i + 1) - corner(0));
        area += glm::length(sum);
        ++polygons;
    }
};

/// What a stack holds: a polygon is a fan whose triangles end with its first vertex.
void countStack(const vo::PolygonStack& stack, double& polygons, double& area)
{
    const auto corner = [&](std::size_t record) {
        const float* p = stack.records.data() + 3 * record;
        return glm::dvec3(p[0], p[1], p[2]);
    };
    for (const vo::PolygonStack::Run& run : stack.runs) {
        std::uint32_t fan = 0;
        for (std::size_t i = run.first; i < run.first + run.count; i += 3) {
            const std::uint32_t* triangle = stack.indices.data() + i;
            if (i == run.first || triangle[2] != fan) ++polygons;
            fan = triangle[2];
            const glm::dvec3 a = corner(triangle[0]);
            area += 0.5 * glm::length(glm::cross(corner(triangle[1]) - a, corner(triangle[2]) - a));
        }
    }
}

/// Bricks that meet; the outermost reach beyond the tetrahedra.
std::vector<vo::Box> brickBoxes(int perAxis)
{
    std::vector<vo::Box> boxes;
    const auto seam = [&](int i) {
        return i == 0 ? -1.0 : i == perAxis ? kSide + 1.0 : kSide * i / perAxis + 0.5;
    };
    for (int z = 0; z < perAxis; ++z)
        for (int y = 0; y < perAxis; ++y)
            for (int x = 0; x < perAxis; ++x)
                boxes.push_back({{seam(x), seam(y), seam(z)}, {seam(x + 1), seam(y + 1), seam(z + 1)}});
    return boxes;
}

vo::PlaneFamily familyOf(const bench::Planes& planes)
{
    vo::PlaneFamily family;
    family.normal = {planes.normal[0], planes.normal[1], planes.normal[2]};
    family.count = static_cast<int>(planes.depths.size());
    family.first = planes.depths.back();
    family.spacing = (planes.depths.back() - planes.depths.front()) / (family.count - 1);
    return family;
}

std::string factsOf(double polygons, double area)
{
    return bench::jsonPair("polygons", polygons) + ", " + bench::jsonPair("area", area);
}

int serveStack(const vo::TetraView& view, std::span<const vo::Box> boxes, const vo::PlaneFamily& family)
{
    vo::StackSlicer slicer;
    vo::PolygonStack stack;
    bench::Worker worker;
    worker.work = [&](int) { slicer.slice(view, boxes, family, vo::StackOrder::byBrick, 0, stack); };
    worker.facts = [&] {
        double polygons = 0.0, area = 0.0;
        countStack(stack, polygons, area);
        return factsOf(polygons, area);
    };
    return bench::serve(worker);
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 4)
        throw std::invalid_argument("arguments: CELLS PLANES BRICKS-PER-AXIS stack|faces");
    const bench::Tetras tetras = bench::makeTetras(std::stoi(arguments[0]), kSide);
    const bench::Planes planes = bench::makePlanes(std::stoi(arguments[1]), kSide);
    const std::vector<vo::Box> boxes = brickBoxes(std::stoi(arguments[2]));
    const vo::TetraView view{tetras.positions, 3, tetras.indices, -1};
    const vo::PlaneFamily family = familyOf(planes);
    if (arguments[3] == "stack") return serveStack(view, boxes, family);
    if (arguments[3] != "faces")
        throw std::invalid_argument("'" + arguments[3] + "' is no form; stack and faces are");
    vo::PolygonizeWorkspace workspace;
    FaceStore faces;
    bench::Worker worker;
    worker.work = [&](int) { vo::polygonize(view, boxes, family, workspace, faces); };
    worker.facts = [&] {
        faces.measureArea = true;
        vo::polygonize(view, boxes, family, workspace, faces);
        return factsOf(faces.polygons, faces.area);
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
