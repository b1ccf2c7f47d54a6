#include "bench.h"

#include "../polygonize/scenes.h"
#include "polygonize/polygonize.h"

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

void run(const std::string& name, const scenes::TetraSet& set, const std::vector<vo::Box>& boxes, int planes)
{
    const vo::Camera camera = scenes::camera(256, gl_matrices::rotate(37, {1, 2, 0.5}), true);
    vo::SamplingRequest request;
    request.maxSamples = planes;
    vo::PolygonizeWorkspace workspace;
    StoringSink sink;
    vo::polygonize(set.view(), boxes, camera, request, workspace, sink);
    const long faces = sink.faces;
    const bench::Timing timing =
        bench::measure([&] { vo::polygonize(set.view(), boxes, camera, request, workspace, sink); });
    bench::printLine(name,
                     std::to_string(set.view().tetraCount()) + " tetra " + std::to_string(planes) +
                         " planes " + std::to_string(faces) + " faces",
                     timing);
}

} // namespace

int main()
{
    const scenes::TetraSet cube = scenes::cube(256);
    run("polygonize cube, 1 brick", cube, scenes::bricks(1, 256), 512);
    run("polygonize cube, 8 bricks", cube, scenes::bricks(2, 256), 512);
    run("polygonize cube, 64 bricks", cube, scenes::bricks(4, 256), 512);
    run("polygonize cube, 1 brick, T3F_C4F_V3F", cube.withValues(7), scenes::bricks(1, 256), 512);
    const scenes::TetraSet lattice = scenes::jitteredLattice(20, -4, 260, 0.1, 1);
    run("polygonize lattice, 1 brick", lattice, scenes::bricks(1, 256), 512);
    run("polygonize lattice, 8 bricks", lattice, scenes::bricks(2, 256), 512);
}
