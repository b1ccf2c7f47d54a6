#pragma once

#include "bench_scene.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>

#include <string>

namespace bench {

/// A scene as VTK draws it: one of its two mappers, step 1 voxel, unshaded, in an off-screen window.
class VtkVolume
{
public:
    /// `onGpu`: vtkOpenGLGPUVolumeRayCastMapper, else vtkFixedPointVolumeRayCastMapper in so many threads (0:
    /// as many as it takes by itself).
    VtkVolume(const Scene& scene, const Volume& volume, bool onGpu, int threads);

    void look(double turn);
    /// Returns when the picture is done.
    void render();
    std::string drawnBy() const;

    vtkNew<vtkRenderWindow> window;

private:
    Scene scene_;
    vtkNew<vtkRenderer> renderer_;
    vtkSmartPointer<vtkVolumeMapper> mapper_;
    vtkNew<vtkVolume> volume_;
};

} // namespace bench
