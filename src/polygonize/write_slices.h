#pragma once

#include "polygonize/cut_sections.h"
#include "polygonize/sampling_planes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace vo {

/// A vertex as it is cut.
struct alignas(32) PlacedVertex
{
    std::array<float, 3> position; ///< its last three values; none is -0
    std::int32_t firstInFront;     ///< the first plane that has it in front
    double offset;                 ///< along the planes' normal
    std::int32_t box;              ///< the only one that holds it, far from all faces; -1: there is none such
};

/// A tetrahedron to be sliced by planes that nothing else cuts. Its corners go by position from the least:
/// every edge is cut from its earlier corner.
struct TetraToSlice
{
    std::array<const float*, 4> corners; ///< their records
    int values;                          ///< of a record
    std::array<const PlacedVertex*, 4> places;
    std::array<int, 4> firstInFront; ///< the first plane that has the corner in front
    bool mirrored;                   ///< the corners are negatively oriented
};

/// A tetrahedron that planes meet.
struct SlicedTetra
{
    static constexpr std::int32_t kCut = -1;    ///< boxes cut it
    static constexpr std::int32_t kHalved = -2; ///< it is the next HalvedTetra
    std::uint32_t tetra;
    std::int32_t box;       ///< the only one that holds it, far from all faces; or one of these
    std::uint32_t endAside; ///< kCut: how many polygons boxes have made of it and those before it
    std::uint8_t order;     ///< of its corners, as TetraToSlice has them: two bits each
    bool mirrored;          ///< in this order they are negatively oriented
};
/// The corner that comes `i`-th.
constexpr std::size_t cornerAt(std::uint8_t order, std::size_t i)
{
    return order >> 2 * i & 3;
}

/// A tetrahedron of bare positions that one face between boxes parts; all others are far from it.
struct HalvedTetra
{
    std::uint32_t tetra;
    std::uint8_t order; ///< as SlicedTetra has it
    bool mirrored;
    std::uint8_t axis; ///< across which the face lies
    std::int32_t end;  ///< planes from this one on are left out
    double face;
    std::array<std::int32_t, 2> boxes; ///< below and above the face; -1: none
};

/// How many records and triangles, or the numbers of the next ones, in one word to be counted at once: the
/// lower half is the records. Differences are good even where a half of one is negative.
using StackCount = std::uint64_t;
constexpr StackCount stackCount(std::uint64_t records, std::uint64_t triangles)
{
    return (triangles << 32) + records;
}
constexpr StackCount countOfPolygon(std::uint64_t vertices)
{
    return stackCount(vertices, vertices - 2);
}
constexpr std::uint32_t recordsOf(StackCount count)
{
    return static_cast<std::uint32_t>(count);
}
constexpr std::uint32_t trianglesOf(StackCount count)
{
    return static_cast<std::uint32_t>(count >> 32);
}

/// Where slices go.
struct SliceTarget
{
    float* records;
    std::uint32_t* indices;
    StackCount* next; ///< of each plane of one box, from the first plane
};

/// Slices a tetrahedron with all planes that meet it, several at a time. A polygon is a fan as PolygonStack
/// has it, and keeps vertices that fall together. The bits are those of cutEdge.
/// `scratch` keeps its memory from call to call.
void writeSlices(const TetraToSlice& tetra, const PlaneFamily& planes, const SliceTarget& target,
                 std::vector<float>& scratch);

/// What is common to tetrahedra of bare positions.
struct TetraSource
{
    const PlacedVertex* places;
    const int* vertices;   ///< four of each tetrahedron
    std::size_t toNextBox; ///< counters
};

/// The same for many that boxes hold; target.next belongs to the first box.
void writePositions(std::span<const SlicedTetra> tetras, const TetraSource& from, const PlaneFamily& planes,
                    const SliceTarget& target);

/// The same for tetrahedra that are parted, as countHalves has counted.
void writeHalves(std::span<const HalvedTetra> tetras, const TetraSource& from, const PlaneFamily& planes,
                 const SliceTarget& target);

/// Copies sections of bare positions; CutSections::kBeyond numbers behind their records are read.
void writeSections(std::span<const CutSections::Section> sections, const float* records,
                   std::size_t toNextBox, const SliceTarget& target);

} // namespace vo
