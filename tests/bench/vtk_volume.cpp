#include "vtk_volume.h"

#include <vtkAutoInit.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <cstring>
#include <stdexcept>

VTK_MODULE_INIT(vtkRenderingOpenGL2)
VTK_MODULE_INIT(vtkRenderingVolumeOpenGL2)

namespace bench {

namespace {

/// Points are voxel centres.
vtkSmartPointer<vtkImageData> imageOf(const Volume& volume)
{
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(volume.side, volume.side, volume.side);
    image->SetOrigin(0.5, 0.5, 0.5);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
    std::memcpy(image->GetScalarPointer(), volume.voxels.data(), volume.voxels.size());
    return image;
}

void setTable(vtkVolumeProperty& property, const Table& table)
{
    const vtkNew<vtkColorTransferFunction> colors;
    const vtkNew<vtkPiecewiseFunction> opacity;
    for (int i = 0; i < 256; ++i) {
        const auto& entry = table[static_cast<std::size_t>(i)];
        colors->AddRGBPoint(i, static_cast<double>(entry[0]), static_cast<double>(entry[1]),
                            static_cast<double>(entry[2]));
        opacity->AddPoint(i, static_cast<double>(entry[3]));
    }
    property.SetColor(colors);
    property.SetScalarOpacity(opacity);
    property.SetScalarOpacityUnitDistance(1.0);
    property.SetInterpolationTypeToLinear();
    property.ShadeOff();
}

vtkSmartPointer<vtkVolumeMapper> gpuMapper()
{
    auto mapper = vtkSmartPointer<vtkOpenGLGPUVolumeRayCastMapper>::New();
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetSampleDistance(1.0);
    mapper->SetImageSampleDistance(1.0);
    mapper->SetUseJittering(0);
    return mapper;
}

vtkSmartPointer<vtkVolumeMapper> fixedPointMapper(int threads)
{
    auto mapper = vtkSmartPointer<vtkFixedPointVolumeRayCastMapper>::New();
    mapper->SetAutoAdjustSampleDistances(0);
    mapper->SetSampleDistance(1.0f);
    mapper->SetInteractiveSampleDistance(1.0f);
    mapper->SetImageSampleDistance(1.0f);
    if (threads > 0) mapper->SetNumberOfThreads(threads);
    return mapper;
}

} // namespace

VtkVolume::VtkVolume(const Scene& scene, const Volume& volume, bool onGpu, int threads) : scene_(scene)
{
    mapper_ = onGpu ? gpuMapper() : fixedPointMapper(threads);
    mapper_->SetInputData(imageOf(volume));
    if (scene.maximum)
        mapper_->SetBlendModeToMaximumIntensity();
    else
        mapper_->SetBlendModeToComposite();
    volume_->SetMapper(mapper_);
    setTable(*volume_->GetProperty(), makeTable(scene.table, volume, scene.visible));
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(kPictureSide, kPictureSide);
    window->AddRenderer(renderer_);
    renderer_->SetBackground(0, 0, 0);
    renderer_->AddVolume(volume_);
    look(0.0);
}

void VtkVolume::look(double turn)
{
    const Viewer viewer = viewerOf(scene_, turn);
    vtkCamera& camera = *renderer_->GetActiveCamera();
    std::array<double, 3> place = viewer.direction;
    for (double& coordinate : place)
        coordinate = viewer.centre + viewer.distance * coordinate;
    camera.SetFocalPoint(viewer.centre, viewer.centre, viewer.centre);
    camera.SetPosition(place.data());
    camera.SetViewUp(0, 1, 0);
    camera.SetParallelProjection(!scene_.perspective);
    camera.SetParallelScale(viewer.radius);
    camera.SetViewAngle(kViewAngle);
    camera.SetClippingRange(viewer.distance - 1.01 * viewer.radius, viewer.distance + 1.01 * viewer.radius);
}

void VtkVolume::render()
{
    window->Render();
    window->WaitForCompletion();
}

std::string VtkVolume::drawnBy() const
{
    const char* text = const_cast<vtkRenderWindow&>(*window.Get()).ReportCapabilities();
    const std::string capabilities = text ? text : "";
    const std::string key = "OpenGL renderer string:";
    const auto start = capabilities.find(key);
    if (start == std::string::npos) return "unknown";
    const auto first = capabilities.find_first_not_of(' ', start + key.size());
    return std::string(mapper_->GetClassName()) + ", " +
           capabilities.substr(first, capabilities.find('\n', first) - first);
}

} // namespace bench
