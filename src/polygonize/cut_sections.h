#pragma once

#include "core/kept_array.h"
#include "geometry/face_sink.h"
#include "polygonize/sampling_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace vo {

/// Parts of slices in boxes, in the order in which they were cut; the records follow each other.
class CutSections final : public FaceSink
{
public:
    struct Section
    {
        std::int32_t box;
        std::int32_t sample;
        std::uint32_t records;
    };

    void clear(int values)
    {
        values_ = static_cast<std::size_t>(values);
        records.clear();
        sections.clear();
    }
    bool append(int box, int sample, std::span<const float> values) override
    {
        std::ranges::copy(values, records.grow(values.size()));
        *sections.grow(1) = {box, sample, static_cast<std::uint32_t>(values.size() / values_)};
        return true;
    }

    /// Room behind the records that may be read.
    static constexpr std::size_t kBeyond = 24;
    void end() { std::fill_n(records.grow(kBeyond), kBeyond, 0.0f); }

    KeptArray<float> records;
    KeptArray<Section> sections;

private:
    std::size_t values_ = 3;
};

/// The faces and boxes near a tetrahedron, where each axis has at most two faces that are not close together
/// and a cell at most one box.
struct BoxesNearby
{
    static constexpr std::size_t kMostFaces = 2;
    static constexpr std::size_t kMostIntervals = 3;
    struct Interval
    {
        int lower, upper; ///< the face where it begins or ends; -1: that is not near
    };
    struct Axis
    {
        bool cuts; ///< otherwise there is one interval and nothing to cut
        std::size_t faceCount, intervalCount;
        std::array<double, kMostFaces> faces;
        std::array<Interval, kMostIntervals> intervals;
    };
    std::array<Axis, 3> axes;
    /// By interval of each axis, z fastest: the box, or -1.
    std::array<std::int32_t, kMostIntervals * kMostIntervals * kMostIntervals> box;
    std::int32_t& boxAt(std::size_t x, std::size_t y, std::size_t z)
    {
        return box[(x * kMostIntervals + y) * kMostIntervals + z];
    }
};

/// A tetrahedron of bare positions, as TetraInBoxes has it.
struct TetraSections
{
    const double* corners;
    const double* offsets;
    const int* firstInFront;
    bool mirrored;
};

/// Slices a tetrahedron with planes from `begin` to before `end` and lets boxes cut the slices: what
/// SliceCutter makes of them, though vertices may fall together. Returns the first plane that it does not do,
/// because the slice lies in a face, say, or `end`.
int cutSections(const TetraSections& tetra, const BoxesNearby& boxes, const PlaneFamily& planes, int begin,
                int end, CutSections& sections);

} // namespace vo
