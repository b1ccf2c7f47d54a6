// VTK cuts a lattice of tetrahedra with many planes at once.
//
//     vtk_slices CELLS PLANES plane-cutter|contour|cutter
//
// plane-cutter: vtkPlaneCutter, a call for each plane; contour: vtkContour3DLinearGrid of the depth, all
// planes in one call; cutter: vtkCutter with all planes' values.
#include "bench_planes.h"
#include "bench_scene.h"
#include "bench_worker.h"

#include <vtkCell.h>
#include <vtkCellArray.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkCutter.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPlane.h>
#include <vtkPlaneCutter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersion.h>

#include <array>
#include <functional>
#include <stdexcept>

namespace {

constexpr double kSide = 256.0;

/// Tetrahedra, with their depth along the planes' normal at each point.
void fillGrid(vtkUnstructuredGrid& grid, const bench::Tetras& tetras, const bench::Planes& planes)
{
    const vtkNew<vtkPoints> points;
    const vtkNew<vtkFloatArray> depths;
    points->SetDataTypeToFloat();
    for (std::size_t i = 0; i < tetras.positions.size(); i += 3) {
        const float* p = tetras.positions.data() + i;
        points->InsertNextPoint(p);
        depths->InsertNextValue(static_cast<float>(planes.depthOf({p[0], p[1], p[2]})));
    }
    grid.SetPoints(points);
    grid.GetPointData()->SetScalars(depths);
    const vtkNew<vtkCellArray> cells;
    for (std::size_t i = 0; i < tetras.indices.size(); i += 4) {
        std::array<vtkIdType, 4> corners{};
        for (std::size_t j = 0; j < 4; ++j)
            corners[j] = tetras.indices[i + j];
        cells->InsertNextCell(4, corners.data());
    }
    grid.SetCells(VTK_TETRA, cells);
}

/// What was made, over all planes.
struct Made
{
    double polygons = 0.0;
    double area = 0.0;
};

void count(vtkPolyData& data, Made& made)
{
    made.polygons += static_cast<double>(data.GetNumberOfPolys());
    for (vtkIdType i = 0; i < data.GetNumberOfCells(); ++i) {
        vtkCell& cell = *data.GetCell(i);
        double a[3], b[3], c[3], sum[3] = {0, 0, 0};
        cell.GetPoints()->GetPoint(0, a);
        for (vtkIdType j = 1; j + 1 < cell.GetNumberOfPoints(); ++j) {
            cell.GetPoints()->GetPoint(j, b);
            cell.GetPoints()->GetPoint(j + 1, c);
            for (int k = 0; k < 3; ++k) {
                const int l = (k + 1) % 3, m = (k + 2) % 3;
                sum[k] += 0.5 * ((b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]));
            }
        }
        made.area += std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    }
}

void count(vtkDataObject* object, Made& made)
{
    if (auto* data = vtkPolyData::SafeDownCast(object)) return count(*data, made);
    auto* tree = vtkDataObjectTree::SafeDownCast(object);
    if (!tree) return;
    vtkSmartPointer<vtkDataObjectTreeIterator> leaves;
    leaves.TakeReference(tree->NewTreeIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
        count(leaves->GetCurrentDataObject(), made);
}

/// Calls `made`, if given, with each plane's or all planes' output.
using Slicing = std::function<void(const std::function<void(vtkDataObject*)>& made)>;

Slicing planeCutter(vtkUnstructuredGrid& grid, const bench::Planes& planes)
{
    auto plane = vtkSmartPointer<vtkPlane>::New();
    auto cutter = vtkSmartPointer<vtkPlaneCutter>::New();
    cutter->SetInputData(&grid);
    cutter->SetPlane(plane);
    cutter->ComputeNormalsOff();
    cutter->InterpolateAttributesOff();
    plane->SetNormal(planes.normal[0], planes.normal[1], planes.normal[2]);
    return [=, &planes](const std::function<void(vtkDataObject*)>& made) {
        for (const double depth : planes.depths) {
            plane->SetOrigin(depth * planes.normal[0], depth * planes.normal[1], depth * planes.normal[2]);
            cutter->Update();
            if (made) made(cutter->GetOutputDataObject(0));
        }
    };
}

Slicing contour(vtkUnstructuredGrid& grid, const bench::Planes& planes)
{
    auto filter = vtkSmartPointer<vtkContour3DLinearGrid>::New();
    filter->SetInputData(&grid);
    filter->MergePointsOff();
    filter->ComputeNormalsOff();
    filter->ComputeScalarsOff();
    filter->InterpolateAttributesOff();
    for (std::size_t i = 0; i < planes.depths.size(); ++i)
        filter->SetValue(static_cast<int>(i), planes.depths[i]);
    return [=](const std::function<void(vtkDataObject*)>& made) {
        filter->Modified();
        filter->Update();
        if (made) made(filter->GetOutputDataObject(0));
    };
}

Slicing cutter(vtkUnstructuredGrid& grid, const bench::Planes& planes)
{
    auto plane = vtkSmartPointer<vtkPlane>::New();
    auto filter = vtkSmartPointer<vtkCutter>::New();
    plane->SetNormal(planes.normal[0], planes.normal[1], planes.normal[2]);
    filter->SetInputData(&grid);
    filter->SetCutFunction(plane);
    for (std::size_t i = 0; i < planes.depths.size(); ++i)
        filter->SetValue(static_cast<int>(i), planes.depths[i]);
    return [=](const std::function<void(vtkDataObject*)>& made) {
        filter->Modified();
        filter->Update();
        if (made) made(filter->GetOutputDataObject(0));
    };
}

int run(const std::vector<std::string>& arguments)
{
    if (arguments.size() != 3)
        throw std::invalid_argument("arguments: CELLS PLANES plane-cutter|contour|cutter");
    const bench::Tetras tetras = bench::makeTetras(std::stoi(arguments[0]), kSide);
    const bench::Planes planes = bench::makePlanes(std::stoi(arguments[1]), kSide);
    vtkNew<vtkUnstructuredGrid> grid;
    fillGrid(*grid, tetras, planes);
    Slicing slice;
    if (arguments[2] == "plane-cutter")
        slice = planeCutter(*grid, planes);
    else if (arguments[2] == "contour")
        slice = contour(*grid, planes);
    else if (arguments[2] == "cutter")
        slice = cutter(*grid, planes);
    else
        throw std::invalid_argument("'" + arguments[2] + "' is no way of cutting");
    bench::Worker worker;
    worker.work = [&](int) { slice(nullptr); };
    worker.facts = [&] {
        Made made;
        slice([&](vtkDataObject* object) { count(object, made); });
        return bench::jsonPair("version", std::string("VTK ") + vtkVersion::GetVTKVersion()) + ", " +
               bench::jsonPair("polygons", made.polygons) + ", " + bench::jsonPair("area", made.area);
    };
    return bench::serve(worker);
}

} // namespace

int main(int argc, char** argv)
{
    return bench::guarded(argc, argv, run);
}
