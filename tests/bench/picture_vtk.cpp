// VTK from a raw file to a PNG file and out, as a C++ program would do it. Needs a display, such as Xvfb's.
//
//     vtk_picture SCENE fixed|gpu VOLUME.raw OUTPUT.png
#include "vtk_volume.h"
#include "bench_worker.h"

#include <vtkPNGWriter.h>
#include <vtkWindowToImageFilter.h>

#include <fstream>
#include <stdexcept>

namespace {

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 4)
        throw std::invalid_argument("arguments: SCENE fixed|gpu VOLUME.raw OUTPUT.png");
    const bench::Scene scene = bench::sceneNamed(arguments[0]);
    bench::Volume voxels;
    voxels.side = scene.side;
    voxels.voxels.resize(static_cast<std::size_t>(scene.side) * static_cast<std::size_t>(scene.side) *
                         static_cast<std::size_t>(scene.side));
    std::ifstream file(arguments[2], std::ios::binary);
    if (!file.read(reinterpret_cast<char*>(voxels.voxels.data()),
                   static_cast<std::streamsize>(voxels.voxels.size())))
        throw std::runtime_error("cannot read " + arguments[2]);
    bench::VtkVolume volume(scene, voxels, arguments[1] == "gpu", 2);
    volume.render();
    const vtkNew<vtkWindowToImageFilter> picture;
    picture->SetInput(volume.window);
    picture->ShouldRerenderOff();
    const vtkNew<vtkPNGWriter> writer;
    writer->SetFileName(arguments[3].c_str());
    writer->SetInputConnection(picture->GetOutputPort());
    writer->Write();
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
