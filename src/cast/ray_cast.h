#pragma once

#include "cast/cast_picture.h"
#include "cast/cast_request.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace vo {

/// Walks rays through volumes: samples where the slices would lie. For geometry in its own place (no voxel
/// coordinates, no colours of vertices) that rays enter and leave. Keeps voxels rearranged for sampling, and
/// what the tables make of them, until they change.
class RayCaster
{
public:
    RayCaster();
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// Why this request cannot be done by rays with the same result as slices; empty when it can. Cheap,
    /// but for voxels that it has not seen before: these are arranged for sampling.
    std::string refusal(const CastRequest& request);

    /// The frame, into memory that `picture` keeps from call to call. Only for requests without refusal. Rays
    /// end where less than 1/2048 shows through: no channel is off by more, for fragments of 0 to 1.
    void cast(const CastRequest& request, CastPicture& picture);

    /// Off: samples are taken where they add exactly nothing too. The picture is the same, to the bit.
    void setSkipping(bool on);

    /// Lets go of what was kept of a brick.
    void forget(std::uint64_t brickId);
    /// Bytes kept.
    std::size_t bytes() const;

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
