#include "bench.h"

#include "../polygonize/scenes.h"
#include "frame/polygon_cache.h"
#include "polygonize/polygonize.h"
#include "polygonize/slice_stack.h"

namespace {

/// Holds on to what it is given, as a face set does: copies into memory reserved before.
struct StoringSink : vo::FaceSink
{
    std::vector<float> store = std::vector<float>(std::size_t{1} << 24);
    std::size_t used = 0;
    long faces = 0;

    bool append(int, int, std::span<const float> records) override
    {
        if (used + records.size() > store.size()) used = 0;
        std::copy(records.begin(), records.end(), store.begin() + static_cast<std::ptrdiff_t>(used));
        used += records.size();
        ++faces;
        return true;
    }
};

/// A view and planes that every case uses.
struct Case
{
    const scenes::TetraSet& set;
    std::vector<vo::Box> boxes;
    int planes;
    vo::Camera camera = scenes::camera(256, gl_matrices::rotate(37, {1, 2, 0.5}), true);
    vo::SamplingRequest request{};

    Case(const scenes::TetraSet& tetras, int bricksPerAxis, int count)
        : set(tetras), boxes(scenes::bricks(bricksPerAxis, 256)), planes(count)
    {
        request.maxSamples = count;
    }

    void print(const char* form, long polygons, const bench::Timing& timing) const
    {
        const std::string size = std::to_string(set.view().tetraCount()) + " tetra, " +
                                 std::to_string(boxes.size()) + " bricks, " + std::to_string(planes) +
                                 " planes, " + std::to_string(polygons) + " polygons";
        std::printf("%-22s %-62s %9.3f ms +- %.3f %8.1f M/s\n", form, size.c_str(), 1e3 * timing.median,
                    1e3 * timing.spread, 1e-6 * static_cast<double>(polygons) / timing.median);
        std::fflush(stdout);
    }
};

/// One polygon after the other, as into the face sets of a caller.
void runFaces(const Case& c)
{
    vo::PolygonizeWorkspace workspace;
    StoringSink sink;
    const auto work = [&] {
        sink.faces = 0;
        vo::polygonize(c.set.view(), c.boxes, c.camera, c.request, workspace, sink);
    };
    const bench::Timing timing = bench::measure(work, 0.4);
    c.print("faces", sink.faces, timing);
}

/// A polygon has two vertices more than triangles.
long polygonCount(std::size_t records, std::size_t indices)
{
    return (static_cast<long>(records) - static_cast<long>(indices / 3)) / 2;
}

void runStack(const Case& c, int threads)
{
    vo::StackSlicer slicer;
    vo::PolygonStack stack;
    const auto work = [&] {
        slicer.slice(c.set.view(), c.boxes, c.camera, c.request, vo::StackOrder::byBrick, threads, stack);
    };
    const bench::Timing timing = bench::measure(work, 0.4);
    c.print(threads == 1 ? "stack, 1 thread" : "stack",
            polygonCount(stack.records.size() / static_cast<std::size_t>(c.set.values), stack.indices.size()),
            timing);
}

/// What a frame does; bare positions of a convex set are one body.
void runFrame(const Case& c)
{
    vo::PolygonCache cache;
    const auto work = [&] {
        cache.invalidate();
        cache.update({c.set.view(), c.boxes, c.camera, c.request}, 0.0);
    };
    const bench::Timing timing = bench::measure(work, 0.4);
    c.print(
        "frame",
        polygonCount(cache.records().size() / static_cast<std::size_t>(c.set.values), cache.indices().size()),
        timing);
}

void runAll(const scenes::TetraSet& set, int bricksPerAxis, int planes)
{
    const Case c(set, bricksPerAxis, planes);
    runFaces(c);
    runStack(c, 1);
    runStack(c, 0);
    runFrame(c);
}

} // namespace

/// polygonize_bench [CELLS...]: lattices of so many cells along an axis, 0 is the cube of five tetrahedra;
/// all when none is given.
int main(int argc, char** argv)
{
    std::vector<int> wanted;
    for (int i = 1; i < argc; ++i)
        wanted.push_back(std::atoi(argv[i]));
    if (wanted.empty()) wanted = {0, 20, 56};
    for (const int cells : wanted) {
        const scenes::TetraSet set =
            cells <= 0 ? scenes::cube(256) : scenes::jitteredLattice(cells, 2, 254, 0.1, 1);
        for (const int perAxis : {1, 4})
            runAll(set, perAxis, cells <= 0 ? 512 : 256);
        if (cells <= 0) runAll(set.withValues(7), 1, 512);
    }
}
