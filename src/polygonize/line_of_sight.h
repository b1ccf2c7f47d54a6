#pragma once

#include "core/box.h"
#include "geometry/tetra_view.h"
#include "polygonize/camera.h"
#include "polygonize/sampling_planes.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <optional>
#include <span>
#include <vector>

namespace vo {

/// What the viewer sees through one point of the window, in object space.
struct LineOfSight
{
    glm::dvec3 start{0.0};             ///< on the near plane of the view volume
    glm::dvec3 direction{0.0, 0.0, 1}; ///< unit vector, away from the viewer
    double length = 0.0;               ///< to the far plane; infinite for a view volume without end
};

/// The line through `device`, normalised device coordinates (-1 to 1 over the viewport). Nothing for singular
/// or non-finite matrices.
std::optional<LineOfSight> lineOfSight(const glm::dmat4& model, const glm::dmat4& projection,
                                       const glm::dvec2& device);

/// Where a line of sight meets sampling surfaces.
struct LineSamples
{
    struct Place
    {
        int box;     ///< number of the clip box
        int surface; ///< number of the sampling surface, 0 is the farthest
    };
    std::vector<Place> places;  ///< from the viewer on
    std::vector<float> records; ///< TetraView::valuesPerVertex each, as interpolated over the tetrahedron
    double step = 0.0;          ///< from surface to surface along the line
};

/// The points in which the line meets the planes of `request` (not SamplingSpace::primitive) inside the
/// tetrahedra and the clip boxes: where polygonize would put a fragment. Of tetrahedra and boxes that meet,
/// one yields the point: faces belong as polygonize has it, and a line that runs exactly in a face or an edge
/// counts as moved aside by less than any number.
LineSamples sampleLine(const TetraView& tetras, std::span<const Box> clipBoxes, const Camera& camera,
                       const SamplingRequest& request, const LineOfSight& line);

/// How far apart surfaces lie along any line: length(d) / length(gauge * d) along a line of direction d, from
/// the eye on if they are shells. Nothing for SamplingSpace::primitive, where that differs by tetrahedron,
/// and where there are no surfaces.
std::optional<glm::dmat3> sampleGauge(const TetraView& tetras, const Camera& camera,
                                      const SamplingRequest& request);

} // namespace vo
