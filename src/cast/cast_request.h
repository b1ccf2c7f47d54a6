#pragma once

#include "cast/cast_depth.h"
#include "core/box.h"
#include "core/record_layout.h"
#include "geometry/tetra_view.h"
#include "lookup/brick_texels.h"
#include "lookup/table.h"
#include "polygonize/sampling_planes.h"

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cstdint>
#include <optional>
#include <span>

namespace vo {

/// One brick as the caller holds it. `id` stands for the brick as long as it lives, `version` for its present
/// voxels, `tableSerial` for the entries of `texels.classified` (0: none).
struct CastBrick
{
    std::uint64_t id = 0;
    std::uint64_t version = 0;
    std::uint64_t tableSerial = 0;
    BrickTexels texels;
    glm::vec3 origin{0.0f}; ///< lower corner, voxels
    glm::vec3 size{1.0f};   ///< voxels
    int thinAxis = -1;      ///< of a brick of a stack: sampled without interpolation across it
};

/// How fragments join: over is GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA; premultiplied is GL_ONE,
/// GL_ONE_MINUS_SRC_ALPHA for colours and GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA for alpha; sum is GL_ONE,
/// GL_ONE; alphaSum is GL_SRC_ALPHA, GL_ONE; max and min are GL_MAX and GL_MIN. Alpha is blended like the
/// colours.
enum class CastBlending { over, premultiplied, max, min, sum, alphaSum };

/// Fragments hide what lies behind them.
constexpr bool hidesBehind(CastBlending blending)
{
    return blending == CastBlending::over || blending == CastBlending::premultiplied;
}

/// What becomes of a sample, as programs.cpp has it: the table, then the texture environment.
struct CastShading
{
    const Table* table = nullptr; ///< after interpolation; nullptr: none
    std::uint64_t tableSerial = 0;
    glm::vec4 color{1.0f}; ///< the current colour, for records without one of their own
    bool replace = false;  ///< texture environment GL_REPLACE
    bool flat = false;     ///< a polygon has the colour of its first vertex
};

/// One frame of one volume for the CPU engine. Everything is borrowed for the call.
struct CastRequest
{
    glm::dmat4 model{1.0};
    glm::dmat4 projection{1.0};
    int width = 0; ///< of the viewport, pixels
    int height = 0;

    TetraView tetras;
    RecordLayout layout; ///< texCoord >= 0: voxel coordinates of its own; else the position is them
    std::span<const Box> clipBoxes; ///< of the bricks
    std::span<const CastBrick> bricks;
    SamplingRequest sampling;

    CastShading shading;
    CastBlending blending = CastBlending::over;
    /// Eye space, kept where dot(plane, p) >= 0.
    std::span<const glm::vec4> clipPlanes;
    /// Alpha is the opacity of length(d) / length(gauge * d) units along a line of sight d; nothing: of a
    /// sample.
    std::optional<glm::dmat3> opacityGauge;
    CastDepth depth;
    int threads = 0; ///< at most so many; 0: as many as the machine has
};

} // namespace vo
