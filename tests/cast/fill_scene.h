#pragma once

#include "support/reference.h"

#include "appearance/brick_grid.h"
#include "cast/fill_polygons.h"
#include "frame/polygon_cache.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace vo::test {

/// Tetrahedra that show voxels elsewhere: those of an n x n x n grid of cells over the volume, their vertices
/// moved by `place`.
struct Deformation
{
    int cells = 3;
    std::function<glm::dvec3(const glm::dvec3& voxel)> place = {};
};

/// How a Scene is handed to the CPU engine.
struct FillOptions
{
    int bricks = 1; ///< a side
    VoxelFormat format{Channels::luminance, VoxelType::uint8};
    TexelFormat texel = TexelFormat::intensity;
    std::optional<Deformation> deformation = std::nullopt; ///< records get voxel coordinates
    int colorChannels = 0; ///< 3 or 4: records get colours, linear in the position
    CastBlending blending = CastBlending::over;
    int threads = 2;
};

/// The colour that vertices have there; their alpha where records hold none is 1.
std::array<double, 4> vertexColorAt(const glm::dvec3& position);

/// A Scene as bricks, tables, tetrahedra and a request for them. The scene is to stay as long as this.
class FillScene
{
public:
    FillScene(const Scene& scene, const FillOptions& options);

    CastRequest& request() { return request_; }
    std::vector<CastBrick>& bricks() { return bricks_; }
    PolygonFiller& filler() { return filler_; }
    /// Makes the polygons and fills them.
    CastPicture fill();
    /// The same over the scene's background: four floats a pixel, rows from the bottom, fourth 0.
    std::vector<float> drawn();
    /// What becomes of a fragment at a point of space.
    using Change = std::function<std::optional<std::array<double, 4>>(const glm::dvec3& point,
                                                                      const std::array<double, 4>& fragment)>;
    /// What the volume looks like, deformed as it is; `change` is asked for each fragment if given.
    Picture reference(const Change& change = nullptr) const;
    /// The fragment at a point of space, nothing where there is none.
    std::optional<std::array<double, 4>> fragmentAt(const glm::dvec3& point) const;

private:
    void makeBricks();
    void makeTetras();
    void makeRequest();

    const Scene& scene_;
    FillOptions options_;
    std::vector<std::vector<std::byte>> voxels_;
    std::vector<CastBrick> bricks_;
    std::vector<Box> boxes_;
    RecordLayout layout_;
    std::vector<float> records_;
    std::vector<int> indices_;
    std::vector<Tetrahedron> space_, voxelSpace_;
    std::vector<glm::dmat4> weights_; ///< of a point in each tetrahedron
    std::unique_ptr<Table> table_;
    CastRequest request_;
    PolygonCache cache_;
    PolygonFiller filler_;
};

} // namespace vo::test
