#pragma once

#include "cast/cast_depth.h"
#include "style/styled_scene.h"

#include <memory>

namespace vo {

/// Makes pictures of scenes without OpenGL. Opaque and translucent surfaces, volumes that overlap, and the
/// sky stand in the right order in every pixel. What it finds out about voxels stays for the next picture, as
/// long as their texture (VoxelTexture::serial) is drawn. One picture at a time.
///
/// Volumes and surfaces whose numbers make no sense (not finite, without extent, texels missing) are left
/// out.
class SceneCaster
{
public:
    SceneCaster();
    ~SceneCaster();
    SceneCaster(const SceneCaster&) = delete;
    SceneCaster& operator=(const SceneCaster&) = delete;

    /// `threads`: at most so many; 0: as many as the machine has. The picture is the same, bit for bit, for
    /// any number. `there`: opaque things that are no part of the scene; what they hide is left out, and
    /// before them there is no sky. Throws std::bad_alloc.
    void cast(const StyledScene& scene, int threads, ScenePicture& picture, const CastDepth& there = {});

private:
    struct Private;
    std::unique_ptr<Private> d;
};

/// One picture by a SceneCaster of its own.
void castScene(const StyledScene& scene, int threads, ScenePicture& picture);

} // namespace vo
