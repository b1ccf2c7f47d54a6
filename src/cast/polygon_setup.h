#pragma once

#include "cast/cast_request.h"
#include "cast/fill_polygons.h"
#include "cast/fill_tile.h"
#include "cast/row_spans.h"
#include "cast/window_polygon.h"

#include <span>
#include <vector>

namespace vo {

/// Polygons ready to be filled, and their spans.
struct FillList
{
    std::vector<FillPolygon> polygons;
    std::vector<RowSpan> rows;

    void clear()
    {
        polygons.clear();
        rows.clear();
    }
};

/// Makes polygons ready to be filled; for one thread.
class PolygonSetup
{
public:
    /// `bricks` as the request has them.
    PolygonSetup(const CastRequest& request, std::span<const FillBrick> bricks,
                 std::span<const float> records);

    /// Appends what is seen of the polygon that triangles (three indices each) make as a fan: (b, c, a),
    /// (c, d, a) and so on.
    void append(int brick, std::span<const std::uint32_t> fan, FillList& list);

private:
    void readPolygon(std::span<const std::uint32_t> fan);
    PolygonVertex vertexOf(std::uint32_t number) const;
    /// Three vertices that span the polygon.
    struct Basis
    {
        std::size_t origin, first, second;
    };
    Basis findBasis() const;
    void setGradients(const FillBrick& brick, FillPolygon& polygon) const;

    const CastRequest& request_;
    std::span<const FillBrick> bricks_;
    std::span<const float> records_;
    WindowProjection projection_;
    std::vector<PolygonVertex> polygon_;
    std::vector<WindowVertex> seen_;
    std::vector<SnappedVertex> snapped_;
};

} // namespace vo
