#pragma once

#include "draw/ray_hits.h"
#include "draw/scene_resources.h"
#include "draw/surface_program.h"
#include "draw/translucent_target.h"
#include "style/shared_planes.h"
#include "style/styled_scene.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Draws the opaque ones, with the depth test that is set.
void drawOpaqueSurfaces(const StyledScene& scene, const SharedPlanes& planes, SceneResources& resources,
                        SceneArrays& arrays);

/// The translucent surfaces of a picture, drawn slab by slab between depths. In a slab the triangle whose
/// middle is farthest comes first.
class TranslucentSurfaces
{
public:
    explicit TranslucentSurfaces(SceneResources& resources)
        : resources_(resources), arrays_(resources.context)
    {
    }

    /// `depths`: of all that is to be drawn in between, rising; those of further slabs are put among them.
    /// Borrows the scene and its planes until it is drawn.
    void prepare(const StyledScene& scene, const SharedPlanes& planes, std::vector<double>& depths);
    /// As prepare(), for findHits(). False: there are none.
    bool prepareHits(const StyledScene& scene, const SharedPlanes& planes);
    /// Draws the next hit of each pixel, into what RayHits have bound.
    void findHits(const RayHits& hits, const TranslucentTarget& target, std::size_t source);
    /// Whether anything that is not drawn yet is behind a depth.
    bool anyBehind(double depth) const;
    /// Draws all slabs behind a depth that are not drawn yet. True: something was drawn, so that another
    /// program is in use.
    bool drawBehind(double depth);

private:
    struct Triangle
    {
        std::size_t surface;
        float nearest, farthest;
        double middle;
        std::uint32_t uncut; ///< uncutPlanes()

        bool isDrawnWith(const Triangle& other) const
        {
            return surface == other.surface && uncut == other.uncut;
        }
    };
    /// A triangle in a slab.
    struct Part
    {
        std::size_t slab, triangle;
    };

    void gatherTriangles(std::vector<float>& records);
    void gather(const StyledSurface& surface, std::size_t number, std::vector<float>& records);
    void divide(std::vector<double>& depths);
    void gatherParts();
    void sendTriangles(const std::vector<float>& records);
    void sendParts();
    void drawSlab();
    SceneProgram& useProgram(const Triangle& triangle, SurfacePart part) const;

    SceneResources& resources_;
    SceneArrays arrays_;
    const StyledScene* scene_ = nullptr;
    const SharedPlanes* planes_ = nullptr;
    std::vector<Triangle> triangles_;
    std::vector<float> borders_; ///< slab i lies before border i and behind border i + 1
    std::vector<Part> parts_;
    std::size_t next_ = 0; ///< of parts_
    SceneProgram* program_ = nullptr;
    const Triangle* used_ = nullptr; ///< whose program is in use
};

} // namespace vo
