#pragma once

#include "core/record_layout.h"
#include "draw/context_record.h"
#include "draw/draw_state.h"

#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// Polygons ready to send: whole vertex records, and polygons as a count and that many record numbers, one
/// after the other.
struct FaceBatch
{
    std::vector<float> records;
    std::vector<int> polygons;

    void clear()
    {
        records.clear();
        polygons.clear();
    }
};

/// Draws polygons with the caller's program state replaced and everything but the bound textures given back.
/// GL_FILL fills them, GL_LINE draws their edges, GL_POINT their corners.
void drawFaces(ContextRecord& context, const DrawState& state, const RecordLayout& layout,
               std::span<const float> records, std::span<const int> polygons, GLenum mode);

/// Draws separate line segments, 6 floats (two positions) each, in the current colour without texture.
void drawSegments(ContextRecord& context, const DrawState& state, std::span<const float> positions);

/// A frame of many parts: all vertices are sent at once, then parts of the indices are drawn in any order.
class FaceStream
{
public:
    /// `records` and `indices` (of triangles) are sent now, unless they are the last that were: those of the
    /// same `serial`, which is not 0.
    FaceStream(ContextRecord& context, const DrawState& state, const RecordLayout& layout,
               std::span<const float> records, std::span<const std::uint32_t> indices, std::uint64_t serial);
    ~FaceStream();
    FaceStream(const FaceStream&) = delete;
    FaceStream& operator=(const FaceStream&) = delete;

    /// Draws `count` indices from `first` with the texture, coordinates and table of `state`.
    void draw(const DrawState& state, std::size_t first, std::size_t count);

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace vo
