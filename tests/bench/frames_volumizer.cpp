// This library: frames of a scene by drawUtility. VO_ENGINE, VO_THREADS and VO_OFFSCREEN of the environment
// count.
#include "bench_worker.h"
#include "volumizer_frames.h"

#include <stdexcept>

namespace {

bench::FrameOptions optionsFrom(const std::vector<std::string>& arguments)
{
    if (arguments.size() < 2)
        throw std::invalid_argument(
            "arguments: SCENE FOLDER-OF-VOLUMES [bricks=PER-AXIS] [new-tables] [per-slice]");
    bench::FrameOptions options{bench::sceneNamed(arguments[0]), arguments[1]};
    for (std::size_t i = 2; i < arguments.size(); ++i)
        if (arguments[i].starts_with("bricks="))
            options.bricksPerAxis = std::stoi(arguments[i].substr(7));
        else if (arguments[i] == "new-tables")
            options.newTables = true;
        else if (arguments[i] == "per-slice")
            options.perLength = false;
        else
            throw std::invalid_argument("'" + arguments[i] +
                                        "' is no option; bricks=PER-AXIS, new-tables and per-slice are");
    return options;
}

int run(const std::vector<std::string>& arguments)
{
    const bench::FrameOptions options = optionsFrom(arguments);
    bench::VolumizerFrames frames(options);
    bench::Worker worker;
    worker.work = [&](int number) {
        if (options.newTables) frames.changeTable(number);
        frames.draw(bench::turnOf(number));
    };
    worker.picture = [&] { return frames.picture(); };
    worker.facts = [&] {
        const std::string engine = frames.engine();
        std::string facts =
            bench::jsonPair("engine", engine) + ", " + bench::jsonPair("drawnBy", frames.renderer());
        if (engine == "slices")
            facts += ", " + bench::jsonPair("fragments", frames.countFragments([&] { frames.draw(0.0); }));
        return facts;
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
