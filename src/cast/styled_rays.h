#pragma once

#include "cast/padded_voxels.h"
#include "cast/scene_rays.h"
#include "style/styled_scene.h"

#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace vo {

/// What a ray meets in one volume: colours multiplied by their opacity, by rising eye depth.
struct FragmentRun
{
    int count = 0, next = 0;
    std::array<double, kBatchSize> depth;
    std::array<glm::vec4, kBatchSize> color;

    bool atEnd() const { return next >= count; }
};

/// A chain of styles, and how far it goes without normals.
struct ChainPlan
{
    StyleChain chain; ///< effectiveChain()
    /// Styles at the front that read no normal: the opacity they leave decides which samples go on.
    std::size_t withoutNormals = 0;
    bool keepsClear = true;
    /// What firstColor() makes of a voxel is what the chain begins with.
    bool beginsWithVoxel = true;
};

/// All that rays need of a volume; not changed while they walk.
struct CastVolume
{
    const StyledVolume* styled = nullptr;
    std::shared_ptr<const PaddedVoxels> voxels;
    glm::dmat4 localFromEye{1.0};
    std::vector<glm::dvec4> eyePlanes; ///< kept where dot(plane, p) >= 0
    std::vector<ChainPlan> plans;      ///< of the volume's chains
    glm::vec3 changeScale{1.0f};       ///< from changes over a voxel to those over a shortest edge, local
};

/// Walks one ray after the other through a volume; each thread has its own.
class StyledRay
{
public:
    explicit StyledRay(const CastVolume& volume);

    /// Starts a ray of eye space; false if it meets nothing within `depths`.
    bool begin(const DepthRay& ray, DepthRange depths);
    /// The next fragments of the ray; false if there are no more.
    bool next(FragmentRun& run);

private:
    void gather();
    void takeChunk(int count);
    void shade();
    void dropClear();
    void placeSamples();
    void findNormals();
    void applyStyles(const StyleChain& chain, std::size_t from, std::size_t to);
    void emit(FragmentRun& run) const;

    const CastVolume& volume_;
    DepthRay local_, place_;
    double stepLength_ = 0.0; ///< in unit lengths
    std::int64_t plane_ = 0, lastPlane_ = -1;
    int wanted_ = 0; ///< samples in the next batch
    SampleBatch batch_{}, chunk_{};
    std::array<double, kBatchSize> depth_{};
};

} // namespace vo
