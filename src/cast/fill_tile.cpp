#include "cast/fill_tile.h"

#include "core/highway_targets.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cast/fill_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "cast/sample-inl.h"
#include "cast/shade-inl.h"

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace {

static_assert(kPlaceUnit == kPlaceParts);

using FourTag = hn::CappedTag<float, 4>;
using Four = hn::Vec<FourTag>; // of four channels, where vectors are as long
constexpr FourTag kFour;

constexpr std::size_t kCapacity = 512;
/// One more row of a tile, and lanes that are written past the end.
constexpr std::size_t kStored = kCapacity + kTileSide + 16;

template <class T>
using Lanes = std::array<T, kStored>;

/// Samples waiting to be shaded, all of one sampler, in the order in which they are blended.
struct Fragments
{
    std::size_t count = 0;
    alignas(64) Lanes<std::int32_t> place[3]; ///< 1 / kPlaceUnit voxel
    alignas(64) Lanes<std::int32_t> pixel;    ///< of the tile
    alignas(64) Lanes<float> color[4];        ///< of the vertices
    alignas(64) Lanes<std::int32_t> entry;    ///< of the table: where it begins
    alignas(64) Lanes<float> weight;          ///< of the next entry, or the sample itself
    alignas(64) std::array<float, 4 * kStored> rgba;
};

struct Rgba
{
    Floats c[4];
};

// ---- Samples

/// Of one channel or of four, in the units of a plan: 1 stands for 1.
template <class Sampler>
class GridSource
{
public:
    static constexpr int kChannels = Sampler::kChannels;

    explicit GridSource(const FillSampler& sampler)
        : lanes_(sampler.grid->view()), sampler_(sampler.grid->view()),
          unit_(1.0f / sampler.grid->view().rawUnit)
    {
    }

    HWY_INLINE void sample(Ints x, Ints y, Ints z, Floats (&values)[kChannels]) const
    {
        const Place place = lanes_.place(x, y, z);
        for (int c = 0; c < kChannels; ++c)
            values[c] = sampler_.value(place, c) * hn::Set(kFloats, unit_);
    }

private:
    GridLanes lanes_;
    Sampler sampler_;
    float unit_;
};

/// Bricks that make no grid, lane by lane.
class TexelSource
{
public:
    static constexpr int kChannels = 4;

    explicit TexelSource(const FillSampler& sampler) : texels_(sampler.texels) {}

    void sample(Ints x, Ints y, Ints z, Floats (&values)[kChannels]) const
    {
        alignas(64) std::int32_t place[3][16];
        alignas(64) float answer[4][16];
        hn::Store(x, kInts, place[0]);
        hn::Store(y, kInts, place[1]);
        hn::Store(z, kInts, place[2]);
        for (std::size_t lane = 0; lane < hn::Lanes(kFloats); ++lane) {
            const glm::dvec4 texel = filteredTexel(
                texels_, glm::dvec3(place[0][lane], place[1][lane], place[2][lane]) / double(kPlaceUnit));
            for (int c = 0; c < 4; ++c)
                answer[c][lane] = static_cast<float>(texel[c]);
        }
        for (int c = 0; c < 4; ++c)
            values[c] = hn::Load(kFloats, answer[c]);
    }

private:
    const BrickTexels& texels_;
};

template <class Function>
void withSource(const FillSampler& sampler, Function function)
{
    if (!sampler.grid) return function(TexelSource(sampler));
    switch (sampler.grid->view().kind) {
    case GridKind::bytes: return function(GridSource<ByteSampler>(sampler));
    case GridKind::shorts: return function(GridSource<ShortSampler>(sampler));
    case GridKind::floats: break;
    }
    if (sampler.grid->view().channels == 1) return function(GridSource<FloatSampler<1>>(sampler));
    function(GridSource<FloatSampler<4>>(sampler));
}

/// The last lanes of a vector that is not full: any place that is in the brick will do.
void padFragments(Fragments& fragments)
{
    for (std::size_t i = fragments.count; i % hn::Lanes(kFloats) != 0; ++i)
        for (auto& coordinates : fragments.place)
            coordinates[i] = coordinates[fragments.count - 1];
}

template <class Source, class Function>
HWY_INLINE void forSamples(const Source& source, Fragments& fragments, Function function)
{
    padFragments(fragments);
    for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(kFloats)) {
        Floats values[Source::kChannels];
        source.sample(hn::Load(kInts, &fragments.place[0][i]), hn::Load(kInts, &fragments.place[1][i]),
                      hn::Load(kInts, &fragments.place[2][i]), values);
        function(i, values);
    }
}

// ---- Shading

/// Where samples of one channel lie in the table.
void findEntries(const FillFrame& frame, const FillSampler& sampler, Fragments& fragments)
{
    const auto last = static_cast<float>(frame.entries.size() / 8 - 1);
    withSource(sampler, [&](const auto& source) {
        forSamples(source, fragments, [&](std::size_t i, const auto& values) {
            // Written so that a NaN counts as 0.
            const Floats scaled = hn::Min(values[0] * hn::Set(kFloats, last), hn::Set(kFloats, last));
            const Floats place = hn::IfThenElseZero(values[0] > hn::Zero(kFloats), scaled);
            const Ints entry = toLower(place);
            hn::Store(place - hn::ConvertTo(kFloats, entry), kFloats, &fragments.weight[i]);
            hn::Store(hn::ShiftLeft<3>(entry), kInts, &fragments.entry[i]);
        });
    });
}

/// A shading plan's components of one value or of four.
template <class Shade>
HWY_INLINE Rgba shaded(const ShadingPlan& plan, const Shade& shade, const Floats (&values)[1])
{
    static_cast<void>(plan);
    const auto key = shade.key(values[0]);
    return {
        {shade.component(key, 0), shade.component(key, 1), shade.component(key, 2), shade.component(key, 3)}};
}

template <class Shade>
HWY_INLINE Rgba shaded(const ShadingPlan& plan, const Shade& shade, const Floats (&values)[4])
{
    const auto component = [&](std::size_t c) {
        return shade.component(shade.key(values[plan.oneChannel ? 0 : c]), c);
    };
    return {{component(0), component(1), component(2), component(3)}};
}

template <class Shade>
void shadeWith(const FillFrame& frame, const FillSampler& sampler, const FillTile& tile, Fragments& fragments)
{
    const Shade shade(*sampler.plan, 1.0f);
    const bool modulates = frame.vertexColor && !frame.shading.replace;
    const bool ownAlpha = frame.vertexColor && frame.shading.replace && sampler.keepsAlpha;
    withSource(sampler, [&](const auto& source) {
        forSamples(source, fragments, [&](std::size_t i, const auto& values) {
            Rgba rgba = shaded(*sampler.plan, shade, values);
            for (std::size_t c = 0; modulates && c < 4; ++c)
                rgba.c[c] = rgba.c[c] * hn::Load(kFloats, &fragments.color[c][i]);
            if (ownAlpha) rgba.c[3] = hn::Load(kFloats, &fragments.color[3][i]);
            if (frame.opacityPerLength) {
                const Ints pixel = hn::And(hn::Load(kInts, &fragments.pixel[i]),
                                           hn::Set(kInts, kTileSide * kTileSide - 1)); // past the end: any
                const Floats alpha = rgba.c[3], one = hn::Set(kFloats, 1.0f);
                rgba.c[3] =
                    hn::IfThenElse(alpha < one, opacityOver(alpha, gather(tile.units.data(), pixel)), one);
            }
            hn::StoreInterleaved4(rgba.c[0], rgba.c[1], rgba.c[2], rgba.c[3], kFloats,
                                  &fragments.rgba[4 * i]);
        });
    });
}

// ---- Blending

/// Fragments with all that can be: stored one after the other.
class StoredColors
{
public:
    explicit StoredColors(const Fragments& fragments) : rgba_(fragments.rgba.data()) {}

    HWY_INLINE Four channels(std::size_t i, std::size_t first) const
    {
        return hn::LoadU(kFour, rgba_ + 4 * i + first);
    }
    HWY_INLINE float alpha(std::size_t i) const { return rgba_[4 * i + 3]; }

private:
    const float* rgba_;
};

/// Fragments of a table's entries.
class TableColors
{
public:
    TableColors(const Fragments& fragments, std::span<const float> entries)
        : entry_(fragments.entry.data()), weight_(fragments.weight.data()), entries_(entries.data())
    {
    }

    HWY_INLINE Four channels(std::size_t i, std::size_t first) const
    {
        const float* entry = entries_ + entry_[i] + first;
        return hn::MulAdd(hn::Set(kFour, weight_[i]), hn::LoadU(kFour, entry + 4), hn::LoadU(kFour, entry));
    }
    HWY_INLINE float alpha(std::size_t i) const
    {
        const float* entry = entries_ + entry_[i] + 3;
        return entry[0] + weight_[i] * entry[4];
    }

private:
    const std::int32_t* entry_;
    const float* weight_;
    const float* entries_;
};

/// target = function(target, fragment, prepared, c) for the channels of each fragment's pixel, from channel c
/// on; before(i, pixel) prepares what function needs.
template <class Colors, class Before, class Function>
HWY_INLINE void updatePixels(const Fragments& fragments, const Colors& colors, FillTile& tile, Before before,
                             Function function)
{
    float* targets = tile.rgba.data();
    for (std::size_t i = 0; i < fragments.count; ++i) {
        const auto pixel = static_cast<std::size_t>(fragments.pixel[i]);
        const auto prepared = before(i, pixel);
        for (std::size_t c = 0; c < 4; c += hn::Lanes(kFour)) {
            float* target = targets + 4 * pixel + c;
            hn::StoreU(function(hn::LoadU(kFour, target), colors.channels(i, c), prepared, c), kFour, target);
        }
    }
}

/// Colours count whole, alphas as much as they say: over an alpha of 0 that is GL_SRC_ALPHA,
/// GL_ONE_MINUS_SRC_ALPHA.
template <class Colors>
void blendWhole(const Fragments& fragments, const Colors& colors, FillTile& tile)
{
    struct Weights
    {
        float color, alpha;
    };
    float* transmittance = tile.transmittance.data();
    updatePixels(
        fragments, colors, tile,
        [&](std::size_t i, std::size_t pixel) {
            const float color = transmittance[pixel], alpha = colors.alpha(i) * color;
            transmittance[pixel] -= alpha;
            return Weights{color, alpha};
        },
        [](Four target, Four source, const Weights& weights, std::size_t first) {
            const auto isAlpha = hn::Iota(kFour, static_cast<float>(first)) == hn::Set(kFour, 3.0f);
            const Four weight =
                hn::IfThenElse(isAlpha, hn::Set(kFour, weights.alpha), hn::Set(kFour, weights.color));
            return hn::MulAdd(weight, source, target);
        });
}

template <class Colors>
void blend(CastBlending blending, const Fragments& fragments, const Colors& colors, FillTile& tile)
{
    const auto nothing = [](std::size_t, std::size_t) { return 0; };
    const auto weighted = [](Four target, Four source, Four weight, std::size_t) {
        return hn::MulAdd(weight, source, target);
    };
    float* transmittance = tile.transmittance.data();
    switch (blending) {
    case CastBlending::over:
        return updatePixels(
            fragments, colors, tile,
            [&](std::size_t i, std::size_t pixel) {
                const float part = colors.alpha(i) * transmittance[pixel];
                transmittance[pixel] -= part;
                return hn::Set(kFour, part);
            },
            weighted);
    case CastBlending::alphaSum:
        return updatePixels(
            fragments, colors, tile,
            [&](std::size_t i, std::size_t) { return hn::Set(kFour, colors.alpha(i)); }, weighted);
    case CastBlending::premultiplied: return blendWhole(fragments, colors, tile);
    case CastBlending::sum:
        return updatePixels(fragments, colors, tile, nothing,
                            [](Four a, Four b, int, std::size_t) { return a + b; });
    case CastBlending::max:
        return updatePixels(fragments, colors, tile, nothing,
                            [](Four a, Four b, int, std::size_t) { return hn::Max(a, b); });
    case CastBlending::min:
        return updatePixels(fragments, colors, tile, nothing,
                            [](Four a, Four b, int, std::size_t) { return hn::Min(a, b); });
    }
}

void drawFragments(const FillFrame& frame, const FillSampler& sampler, FillTile& tile, Fragments& fragments)
{
    if (!frame.entries.empty()) {
        findEntries(frame, sampler, fragments);
        return blend(frame.blending, fragments, TableColors(fragments, frame.entries), tile);
    }
    if (sampler.plan->table)
        shadeWith<TableShade>(frame, sampler, tile, fragments);
    else
        shadeWith<LinearShade>(frame, sampler, tile, fragments);
    blend(frame.blending, fragments, StoredColors(fragments), tile);
}

// ---- Fragments of a polygon

/// A number along a row.
struct RowValue
{
    float start, step; ///< at the left end of the polygon's box, and a pixel

    HWY_INLINE Floats at(Floats x) const
    {
        return hn::MulAdd(hn::Set(kFloats, step), x, hn::Set(kFloats, start));
    }
};

/// The blocks of a sampler that can be left out.
class BlockTest
{
public:
    explicit BlockTest(const FillSampler& sampler) : distances_(sampler.blockDistance)
    {
        if (!distances_) return;
        row_ = sampler.grid->blockCount().x;
        slice_ = row_ * sampler.grid->blockCount().y;
    }

    bool any() const { return distances_ != nullptr; }

    /// Blocks to the next that may hold something.
    HWY_INLINE Ints distance(Ints x, Ints y, Ints z) const
    {
        constexpr int kBlockBits = kPlaceBits + kBlockShift;
        const Ints number = hn::ShiftRight<kBlockBits>(x) +
                            hn::ShiftRight<kBlockBits>(y) * hn::Set(kInts, row_) +
                            hn::ShiftRight<kBlockBits>(z) * hn::Set(kInts, slice_);
        return hn::And(gatherAtByte(reinterpret_cast<const std::int32_t*>(distances_), number),
                       hn::Set(kInts, 0xff));
    }

private:
    const std::uint8_t* distances_;
    int row_ = 0, slice_ = 0;
};

class RowFiller
{
public:
    RowFiller(const FillFrame& frame, const FillPolygon& polygon, const FillTile& tile, Fragments& fragments)
        : frame_(frame), polygon_(polygon), tile_(tile), fragments_(fragments),
          blocks_(frame.samplers[static_cast<std::size_t>(polygon.sampler)]), left_(polygon.box.x0 - tile.x),
          opaque_(frame.blending == CastBlending::over ? kOpaque : kOpaqueToWhole)
    {
        if (!blocks_.any() || frame.perspective) return;
        float step = 1e-3f;
        for (const WindowGradient& place : polygon.place)
            step = std::max(step, std::abs(place.dx));
        // Rounding may take a place into the next cell.
        pixelsABlock_ = std::min((kBlockCells - 0.01f) * kPlaceUnit / step, 1024.0f);
    }

    /// Pixels left <= x < right of row y, all counted in the tile.
    void fill(int y, int left, int right)
    {
        setRow(y);
        constexpr int kStep = kLanes;
        for (int x = left; x < right; x += kStep) {
            Mask drawn = drawnPixels(x, y, right);
            if (hn::AllFalse(kFloats, drawn)) continue;
            const Floats px = hn::Iota(kFloats, static_cast<float>(x - left_));
            const Floats w = frame_.perspective ? clipW(px) : hn::Set(kFloats, 1.0f);
            const Ints place[3] = {placeAt(0, px, w), placeAt(1, px, w), placeAt(2, px, w)};
            if (blocks_.any()) {
                const Ints distance = blocks_.distance(place[0], place[1], place[2]);
                drawn = hn::And(drawn, hn::RebindMask(kFloats, distance == hn::Zero(kInts)));
                if (hn::AllFalse(kFloats, drawn)) {
                    x += pixelsPast(distance);
                    continue;
                }
            }
            store(place, px, w, hn::Iota(kInts, y * kTileSide + x), drawn);
        }
    }

private:
    RowValue rowOf(const WindowGradient& gradient, int y) const
    {
        return {gradient.value + gradient.dy * static_cast<float>(y - polygon_.box.y0), gradient.dx};
    }

    void setRow(int tileRow)
    {
        const int y = tileRow + tile_.y;
        for (std::size_t axis = 0; axis < 3; ++axis)
            place_[axis] = rowOf(polygon_.place[axis], y);
        if (frame_.perspective) inverseW_ = rowOf(polygon_.inverseW, y);
        if (!frame_.depth.depths.empty()) depth_ = rowOf(polygon_.depth, y);
        for (std::size_t c = 0; frame_.vertexColor && c < 4; ++c)
            color_[c] = rowOf(polygon_.color[c], y);
    }

    HWY_INLINE Floats clipW(Floats px) const
    {
        return hn::Set(kFloats, 1.0f) /
               hn::Max(inverseW_.at(px), hn::Set(kFloats, polygon_.smallestInverseW));
    }

    HWY_INLINE Ints placeAt(std::size_t axis, Floats px, Floats w) const
    {
        const Floats place = hn::Max(place_[axis].at(px) * w, hn::Set(kFloats, polygon_.lower[axis]));
        return toNearest(hn::Min(place, hn::Set(kFloats, polygon_.upper[axis])));
    }

    HWY_INLINE Mask drawnPixels(int x, int y, int right) const
    {
        Mask drawn = hn::FirstN(kFloats, static_cast<std::size_t>(right - x));
        if (frame_.terminates) {
            const Floats through =
                hn::LoadU(kFloats, tile_.transmittance.data() + static_cast<std::size_t>(y * kTileSide + x));
            drawn = hn::And(drawn, through > hn::Set(kFloats, opaque_));
        }
        if (!frame_.depth.depths.empty()) drawn = hn::And(drawn, inFront(x, y, right));
        return drawn;
    }

    Mask inFront(int x, int y, int right) const
    {
        alignas(64) std::array<float, 16> there{};
        const float* row = frame_.depth.depths.data() +
                           static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(frame_.width) +
                           static_cast<std::size_t>(tile_.x + x);
        std::copy_n(row, std::min(static_cast<std::size_t>(right - x), hn::Lanes(kFloats)), there.begin());
        const Floats opaque = hn::Load(kFloats, there.data());
        const Floats here = depth_.at(hn::Iota(kFloats, static_cast<float>(x - left_)));
        return frame_.depth.orEqual ? here <= opaque : here < opaque;
    }

    /// How many pixels more than a vector's lie in blocks that are left out.
    HWY_INLINE int pixelsPast(Ints distance) const
    {
        alignas(64) std::array<std::int32_t, 16> lanes;
        hn::Store(distance, kInts, lanes.data());
        const int blocks = lanes[hn::Lanes(kInts) - 1] - 1;
        return blocks > 0 ? static_cast<int>(pixelsABlock_ * static_cast<float>(blocks)) : 0;
    }

    HWY_INLINE void store(const Ints (&place)[3], Floats px, Floats w, Ints pixel, Mask drawn)
    {
        const std::size_t at = fragments_.count;
        const bool all = hn::AllTrue(kFloats, drawn);
        const auto write = [&](auto values, auto tag, auto* target) {
            if (all)
                hn::StoreU(values, tag, target + at);
            else
                hn::CompressStore(values, hn::RebindMask(tag, drawn), tag, target + at);
        };
        for (std::size_t axis = 0; axis < 3; ++axis)
            write(place[axis], kInts, fragments_.place[axis].data());
        for (std::size_t c = 0; frame_.vertexColor && c < 4; ++c)
            write(color_[c].at(px) * w, kFloats, fragments_.color[c].data());
        write(pixel, kInts, fragments_.pixel.data());
        fragments_.count += all ? hn::Lanes(kFloats) : hn::CountTrue(kFloats, drawn);
    }

    const FillFrame& frame_;
    const FillPolygon& polygon_;
    const FillTile& tile_;
    Fragments& fragments_;
    BlockTest blocks_;
    int left_;
    float opaque_;
    float pixelsABlock_ = 0.0f;
    RowValue place_[3] = {}, inverseW_ = {}, depth_ = {}, color_[4] = {};
};

void fillTileOfTarget(const FillFrame& frame, std::span<const PolygonRows> polygons, FillTile& tile)
{
    Fragments fragments;
    int sampler = -1;
    const auto flush = [&] {
        if (fragments.count == 0) return;
        drawFragments(frame, frame.samplers[static_cast<std::size_t>(sampler)], tile, fragments);
        fragments.count = 0;
    };
    for (const PolygonRows& p : polygons) {
        if (p.polygon->sampler != sampler) flush();
        sampler = p.polygon->sampler;
        const PixelBox& box = p.polygon->box;
        RowFiller filler(frame, *p.polygon, tile, fragments);
        const int end = std::min(box.y1, tile.y + kTileSide);
        for (int y = std::max(box.y0, tile.y); y < end; ++y) {
            const RowSpan& span = p.rows[y - box.y0];
            const int left = std::max(span.left - tile.x, 0);
            const int right = std::min(span.right - tile.x, kTileSide);
            if (left >= right) continue;
            if (fragments.count + kTileSide > kCapacity) flush();
            filler.fill(y - tile.y, left, right);
        }
    }
    flush();
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace vo {

HWY_EXPORT(fillTileOfTarget);

namespace {

constexpr std::size_t kTilePixels = static_cast<std::size_t>(kTileSide) * kTileSide;

} // namespace

float FillFrame::nothing() const
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return blending == CastBlending::max ? -infinity : blending == CastBlending::min ? infinity : 0.0f;
}

void fillTile(const FillFrame& frame, std::span<const PolygonRows> polygons, FillTile& tile)
{
    if (tile.rgba.empty()) {
        tile.rgba.assign(4 * kTilePixels, frame.nothing());
        // Vectors read past the last row.
        if (hidesBehind(frame.blending)) tile.transmittance.assign(kTilePixels + 16, 1.0f);
    }
    HWY_DYNAMIC_DISPATCH(fillTileOfTarget)(frame, polygons, tile);
}

} // namespace vo

#endif
