// VTK's volume mappers: frames of a scene into an off-screen window. Needs a display, such as Xvfb's.
#include "vtk_volume.h"
#include "bench_worker.h"

#include <vtkUnsignedCharArray.h>
#include <vtkVersion.h>

#include <stdexcept>

namespace {

std::vector<float> pictureOf(bench::VtkVolume& volume)
{
    volume.look(0.0);
    volume.render();
    const vtkNew<vtkUnsignedCharArray> bytes;
    const int last = bench::kPictureSide - 1;
    volume.window->GetRGBACharPixelData(0, 0, last, last, 0, bytes);
    std::vector<float> pixels;
    for (vtkIdType i = 0; i < 4 * bytes->GetNumberOfTuples(); ++i)
        pixels.push_back(static_cast<float>(bytes->GetValue(i)) / 255.0f);
    return pixels;
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 4)
        throw std::invalid_argument("arguments: SCENE fixed|gpu THREADS FOLDER-OF-VOLUMES");
    const bench::Scene scene = bench::sceneNamed(arguments[0]);
    bench::VtkVolume volume(scene, bench::cachedVolume(scene.volume, scene.side, arguments[3]),
                            arguments[1] == "gpu", std::stoi(arguments[2]));
    bench::Worker worker;
    worker.work = [&](int number) {
        volume.look(bench::turnOf(number));
        volume.render();
    };
    worker.picture = [&] { return pictureOf(volume); };
    worker.facts = [&] {
        return bench::jsonPair("version", std::string("VTK ") + vtkVersion::GetVTKVersion()) + ", " +
               bench::jsonPair("drawnBy", volume.drawnBy());
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
