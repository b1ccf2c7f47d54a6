#include "polygonize/clip_polygon.h"

#include <algorithm>
#include <cassert>

namespace vo {

namespace {

/// Walks from a vertex along its edge: the vertex itself when inside, then the points where the edge meets
/// `planes`, in the order in which it does.
class SlabCut
{
public:
    SlabCut(int axis, double lower, double upper, CutPolygon& out)
        : column_(out.voxelColumn + axis), lower_(lower), upper_(upper), out_(out)
    {
    }

    void edge(const double* from, const double* to)
    {
        const double a = coordinate(from);
        const double b = coordinate(to);
        if (a >= lower_ && a <= upper_) {
            out_.push(from);
            out_.dropRepeat();
        }
        if (a < b) {
            meet(from, to, lower_);
            meet(from, to, upper_);
        } else if (b < a) {
            meet(from, to, upper_);
            meet(from, to, lower_);
        }
    }

private:
    double coordinate(const double* record) const { return record[column_]; }

    void meet(const double* from, const double* to, double plane)
    {
        const double a = coordinate(from) - plane;
        const double b = coordinate(to) - plane;
        if (!((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0))) return;
        double* point = out_.grow();
        cutEdge(from, to, a, b, out_.values, point);
        point[column_] = plane;
        out_.dropRepeat();
    }

    int column_;
    double lower_, upper_;
    CutPolygon& out_;
};

double distance(const glm::dvec4& plane, const double* position)
{
    return plane.x * position[0] + plane.y * position[1] + plane.z * position[2] + plane.w;
}

} // namespace

void clipToSlab(const CutPolygon& polygon, int axis, double lower, double upper, CutPolygon& out)
{
    assert(&polygon != &out);
    out.clear(polygon.values, polygon.voxelColumn);
    SlabCut cut(axis, lower, upper, out);
    for (int i = 0; i < polygon.count; ++i)
        cut.edge(polygon.record(i), polygon.record(i + 1 < polygon.count ? i + 1 : 0));
    out.close();
}

void clipToBox(const CutPolygon& polygon, const Box& box, CutPolygon& scratch, CutPolygon& out)
{
    clipToSlab(polygon, 0, box.lower.x, box.upper.x, out);
    clipToSlab(out, 1, box.lower.y, box.upper.y, scratch);
    clipToSlab(scratch, 2, box.lower.z, box.upper.z, out);
}

void clipToHalfSpace(const CutPolygon& polygon, const glm::dvec4& plane, CutPolygon& out)
{
    assert(&polygon != &out);
    out.clear(polygon.values, polygon.voxelColumn);
    for (int i = 0; i < polygon.count; ++i) {
        const int next = i + 1 < polygon.count ? i + 1 : 0;
        const double a = distance(plane, polygon.position(i));
        const double b = distance(plane, polygon.position(next));
        if (a >= 0.0) {
            out.push(polygon.record(i));
            out.dropRepeat();
        }
        if ((a < 0.0 && b > 0.0) || (a > 0.0 && b < 0.0)) {
            cutEdge(polygon.record(i), polygon.record(next), a, b, polygon.values, out.grow());
            out.dropRepeat();
        }
    }
    out.close();
}

} // namespace vo
