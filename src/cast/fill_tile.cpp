#include "cast/fill_tile.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cast/fill_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>
#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace vo::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
using D = hn::CappedTag<float, 16>;
using DI = hn::RebindToSigned<D>;
using DU = hn::RebindToUnsigned<D>;
using V = hn::Vec<D>;
using VI = hn::Vec<DI>;
using VU = hn::Vec<DU>;
using M = hn::Mask<D>;

constexpr std::size_t kCapacity = 512;
/// One more row of a tile, and lanes that are written past the end.
constexpr std::size_t kStored = kCapacity + kTileSide + 16;

/// Samples waiting to be shaded, all of one brick, in the order in which they are blended.
struct Fragments
{
    std::size_t count = 0;
    alignas(64) std::array<float, kStored> place[3];
    alignas(64) std::array<std::int32_t, kStored> pixel; ///< of the tile
    alignas(64) std::array<float, kStored> color[4];     ///< of the vertices
    alignas(64) std::array<float, kStored> units;
    alignas(64) std::array<float, 4 * kStored> rgba;
};

struct Rgba
{
    V c[4];
};

// ---- Samples

/// Cells between texel centres: offsets in bytes of eight corners, and how far a place is from the first.
struct Cells
{
    VI base, right; ///< of the lower corners, x and x + 1
    VI up, back;    ///< to y + 1 and z + 1
    V x, y, z;
};

template <int bytes>
Cells cellsAt(const VoxelSize& size, V px, V py, V pz)
{
    const D d;
    const DI di;
    const VI one = hn::Set(di, 1);
    const VI ix = hn::ConvertTo(di, px), iy = hn::ConvertTo(di, py), iz = hn::ConvertTo(di, pz);
    const VI rowBytes = hn::Set(di, bytes * size.x);
    const VI layerBytes = hn::Set(di, bytes * size.x * size.y);
    const auto stepBelow = [&](VI index, int last, VI step) {
        return hn::IfThenElseZero(hn::Lt(index, hn::Set(di, last)), step);
    };
    Cells cells;
    cells.base =
        hn::Add(hn::Mul(ix, hn::Set(di, bytes)), hn::Add(hn::Mul(iy, rowBytes), hn::Mul(iz, layerBytes)));
    cells.right = hn::Add(cells.base, stepBelow(ix, size.x - 1, hn::Mul(one, hn::Set(di, bytes))));
    cells.up = stepBelow(iy, size.y - 1, rowBytes);
    cells.back = stepBelow(iz, size.z - 1, layerBytes);
    cells.x = hn::Sub(px, hn::ConvertTo(d, ix));
    cells.y = hn::Sub(py, hn::ConvertTo(d, iy));
    cells.z = hn::Sub(pz, hn::ConvertTo(d, iz));
    return cells;
}

V mix(V a, V b, V share)
{
    return hn::MulAdd(share, hn::Sub(b, a), a);
}

/// Trilinear; row(back, up) gives the value of an edge of the cell, mixed along x.
template <class Row>
V mixRows(const Cells& cells, Row row)
{
    const VI none = hn::Zero(DI());
    const V front = mix(row(none), row(cells.up), cells.y);
    const V behind = mix(row(cells.back), row(hn::Add(cells.back, cells.up)), cells.y);
    return mix(front, behind, cells.z);
}

V sampleFloats(const FillBrick& brick, V px, V py, V pz)
{
    const Cells cells = cellsAt<4>(brick.texels.size, px, py, pz);
    const auto* base = reinterpret_cast<const float*>(brick.texels.voxels.data());
    return mixRows(cells, [&](VI offset) {
        return mix(hn::GatherOffset(D(), base, hn::Add(cells.base, offset)),
                   hn::GatherOffset(D(), base, hn::Add(cells.right, offset)), cells.x);
    });
}

/// Integers of 8 or 16 bits: each fetch of 32 bits holds a texel and its neighbour to the right. A row's last
/// fetch begins earlier, so that none reads past it; rows have four bytes at least.
template <int bits>
V sampleIntegers(const FillBrick& brick, V px, V py, V pz)
{
    constexpr int bytes = bits / 8;
    const D d;
    const DI di;
    const DU du;
    const VoxelSize& size = brick.texels.size;
    const Cells cells = cellsAt<bytes>(size, px, py, pz);
    const VI lastFetch = hn::Set(di, size.x - 4 / bytes);
    const VI back = hn::Max(hn::Sub(hn::ConvertTo(di, px), lastFetch), hn::Zero(di));
    const VI base = hn::Sub(cells.base, hn::Mul(back, hn::Set(di, bytes)));
    const VU shift = hn::BitCast(du, hn::Mul(back, hn::Set(di, bits)));
    const VU mask = hn::Set(du, (1u << bits) - 1u);
    const auto* voxels = reinterpret_cast<const std::int32_t*>(brick.texels.voxels.data());
    const V sum = mixRows(cells, [&](VI offset) {
        const VU pair = hn::Shr(hn::BitCast(du, hn::GatherOffset(di, voxels, hn::Add(base, offset))), shift);
        const V left = hn::ConvertTo(d, hn::BitCast(di, hn::And(pair, mask)));
        const V right = hn::ConvertTo(d, hn::BitCast(di, hn::And(hn::ShiftRight<bits>(pair), mask)));
        return mix(left, right, cells.x);
    });
    return hn::Mul(sum, hn::Set(d, 1.0f / static_cast<float>((1 << bits) - 1)));
}

/// What the texture answers, lane by lane.
Rgba sampleAny(const FillBrick& brick, V px, V py, V pz)
{
    const D d;
    alignas(64) float place[3][16], answer[4][16];
    hn::Store(px, d, place[0]);
    hn::Store(py, d, place[1]);
    hn::Store(pz, d, place[2]);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const glm::dvec4 texel =
            filteredTexel(brick.texels, glm::dvec3(place[0][lane], place[1][lane], place[2][lane]) + 0.5);
        for (int c = 0; c < 4; ++c)
            answer[c][lane] = static_cast<float>(texel[c]);
    }
    return {{hn::Load(d, answer[0]), hn::Load(d, answer[1]), hn::Load(d, answer[2]), hn::Load(d, answer[3])}};
}

Rgba sampleTexture(const FillBrick& brick, V px, V py, V pz)
{
    const auto ofOne = [&](V value) {
        return Rgba{{value, value, value, brick.hasAlpha ? value : hn::Set(D(), 1.0f)}};
    };
    switch (brick.storage) {
    case TexelStorage::byte1: return ofOne(sampleIntegers<8>(brick, px, py, pz));
    case TexelStorage::short1: return ofOne(sampleIntegers<16>(brick, px, py, pz));
    case TexelStorage::float1: return ofOne(sampleFloats(brick, px, py, pz));
    case TexelStorage::any: break;
    }
    return sampleAny(brick, px, py, pz);
}

// ---- Shading

struct TablePlace
{
    VI below, above; ///< numbers of entries, times 4
    V share;
};

TablePlace placeIn(const Table& table, V value)
{
    const D d;
    const DI di;
    const int last = table.size() - 1;
    const VI most = hn::Set(di, last);
    // Zero comes second where either may be returned for a NaN; the number is clamped in any case.
    const V entry =
        hn::Mul(hn::Min(hn::Max(value, hn::Zero(d)), hn::Set(d, 1.0f)), hn::Set(d, static_cast<float>(last)));
    const VI below = hn::Max(hn::Min(hn::ConvertTo(di, entry), most), hn::Zero(di));
    const VI above = hn::Min(hn::Add(below, hn::Set(di, 1)), most);
    return {hn::ShiftLeft<2>(below), hn::ShiftLeft<2>(above), hn::Sub(entry, hn::ConvertTo(d, below))};
}

V lookedUp(const Table& table, const TablePlace& place, int column)
{
    const float* entries = table.rgba.data() + column;
    return mix(hn::GatherIndex(D(), entries, place.below), hn::GatherIndex(D(), entries, place.above),
               place.share);
}

Rgba applied(const Table& table, bool oneChannel, const Rgba& sampled)
{
    if (!oneChannel)
        return {{lookedUp(table, placeIn(table, sampled.c[0]), 0),
                 lookedUp(table, placeIn(table, sampled.c[1]), 1),
                 lookedUp(table, placeIn(table, sampled.c[2]), 2),
                 lookedUp(table, placeIn(table, sampled.c[3]), 3)}};
    const TablePlace place = placeIn(table, sampled.c[0]);
    return {{lookedUp(table, place, 0), lookedUp(table, place, 1), lookedUp(table, place, 2),
             lookedUp(table, place, 3)}};
}

Rgba environment(const CastShading& shading, bool hasAlpha, const Rgba& sampled, const Rgba& color)
{
    if (!shading.replace)
        return {{hn::Mul(color.c[0], sampled.c[0]), hn::Mul(color.c[1], sampled.c[1]),
                 hn::Mul(color.c[2], sampled.c[2]), hn::Mul(color.c[3], sampled.c[3])}};
    if (shading.table || hasAlpha) return sampled;
    return {{sampled.c[0], sampled.c[1], sampled.c[2], color.c[3]}};
}

/// 1 - (1 - alpha)^units.
V opacityOver(V alpha, V units)
{
    const D d;
    const V clamped = hn::Min(hn::Max(alpha, hn::Zero(d)), hn::Set(d, 1.0f - 0x1p-24f));
    const V result = hn::Neg(hn::Expm1(d, hn::Mul(units, hn::Log1p(d, hn::Neg(clamped)))));
    return hn::IfThenElse(hn::Ge(alpha, hn::Set(d, 1.0f)), hn::Set(d, 1.0f), result);
}

Rgba colorsAt(const FillFrame& frame, const Fragments& fragments, std::size_t i)
{
    const D d;
    if (frame.vertexColor)
        return {{hn::Load(d, &fragments.color[0][i]), hn::Load(d, &fragments.color[1][i]),
                 hn::Load(d, &fragments.color[2][i]), hn::Load(d, &fragments.color[3][i])}};
    const glm::vec4& color = frame.shading.color;
    return {{hn::Set(d, color.r), hn::Set(d, color.g), hn::Set(d, color.b), hn::Set(d, color.a)}};
}

/// The last lanes of a vector that is not full: any place that is in the brick will do.
void padFragments(Fragments& fragments)
{
    const std::size_t lanes = hn::Lanes(D());
    for (std::size_t i = fragments.count; i % lanes != 0; ++i)
        for (auto& coordinates : fragments.place)
            coordinates[i] = coordinates[fragments.count - 1];
}

void shadeFragments(const FillFrame& frame, const FillBrick& brick, const FillTile& tile,
                    Fragments& fragments)
{
    const D d;
    padFragments(fragments);
    if (frame.opacityPerLength)
        for (std::size_t i = 0; i < fragments.count; ++i)
            fragments.units[i] = tile.units[static_cast<std::size_t>(fragments.pixel[i])];
    for (std::size_t i = 0; i < fragments.count; i += hn::Lanes(d)) {
        Rgba sampled =
            sampleTexture(brick, hn::Load(d, &fragments.place[0][i]), hn::Load(d, &fragments.place[1][i]),
                          hn::Load(d, &fragments.place[2][i]));
        if (frame.shading.table) sampled = applied(*frame.shading.table, brick.oneChannel, sampled);
        Rgba rgba = environment(frame.shading, brick.hasAlpha, sampled, colorsAt(frame, fragments, i));
        if (frame.opacityPerLength) rgba.c[3] = opacityOver(rgba.c[3], hn::Load(d, &fragments.units[i]));
        hn::StoreInterleaved4(rgba.c[0], rgba.c[1], rgba.c[2], rgba.c[3], d, &fragments.rgba[4 * i]);
    }
}

// ---- Blending

using D4 = hn::CappedTag<float, 4>;

/// target = function(target, source) for the four channels of a pixel.
template <class Function>
void updatePixel(float* target, const float* source, Function function)
{
    const D4 d;
    for (std::size_t c = 0; c < 4; c += hn::Lanes(d))
        hn::StoreU(function(hn::LoadU(d, target + c), hn::LoadU(d, source + c)), d, target + c);
}

template <class Function>
void updatePixels(const Fragments& fragments, FillTile& tile, Function function)
{
    for (std::size_t i = 0; i < fragments.count; ++i)
        updatePixel(&tile.rgba[4 * static_cast<std::size_t>(fragments.pixel[i])], &fragments.rgba[4 * i],
                    function);
}

void addBehind(const Fragments& fragments, FillTile& tile)
{
    const D4 d;
    for (std::size_t i = 0; i < fragments.count; ++i) {
        const auto pixel = static_cast<std::size_t>(fragments.pixel[i]);
        const float alpha = fragments.rgba[4 * i + 3];
        const float through = tile.transmittance[pixel];
        const auto weight = hn::Set(d, alpha * through);
        updatePixel(&tile.rgba[4 * pixel], &fragments.rgba[4 * i],
                    [&](auto target, auto source) { return hn::MulAdd(weight, source, target); });
        tile.transmittance[pixel] = through - alpha * through;
    }
}

void addTimesAlpha(const Fragments& fragments, FillTile& tile)
{
    const D4 d;
    for (std::size_t i = 0; i < fragments.count; ++i) {
        const auto weight = hn::Set(d, fragments.rgba[4 * i + 3]);
        updatePixel(&tile.rgba[4 * static_cast<std::size_t>(fragments.pixel[i])], &fragments.rgba[4 * i],
                    [&](auto target, auto source) { return hn::MulAdd(weight, source, target); });
    }
}

void blendFragments(CastBlending blending, const Fragments& fragments, FillTile& tile)
{
    switch (blending) {
    case CastBlending::over: return addBehind(fragments, tile);
    case CastBlending::alphaSum: return addTimesAlpha(fragments, tile);
    case CastBlending::sum:
        return updatePixels(fragments, tile, [](auto a, auto b) { return hn::Add(a, b); });
    case CastBlending::max:
        return updatePixels(fragments, tile, [](auto a, auto b) { return hn::Max(a, b); });
    case CastBlending::min:
        return updatePixels(fragments, tile, [](auto a, auto b) { return hn::Min(a, b); });
    }
}

// ---- Fragments of a polygon

struct RowValue
{
    float start, step; ///< at x = 0 of the tile, and a pixel
};

V valuesAt(const RowValue& row, V x)
{
    return hn::MulAdd(hn::Set(D(), row.step), x, hn::Set(D(), row.start));
}

class RowFiller
{
public:
    RowFiller(const FillFrame& frame, const FillPolygon& polygon, const FillTile& tile, Fragments& fragments)
        : frame_(frame), polygon_(polygon), tile_(tile), fragments_(fragments)
    {
    }

    /// Pixels left <= x < right of row y, all counted in the tile.
    void fill(int y, int left, int right)
    {
        const D d;
        const DI di;
        setRow(y);
        for (int x = left; x < right; x += static_cast<int>(hn::Lanes(d))) {
            const M drawn = drawnPixels(x, y, right);
            const std::size_t count = hn::CountTrue(d, drawn);
            if (count == 0) continue;
            const V px = hn::Iota(d, static_cast<float>(x - left_));
            const V w = frame_.perspective ? clipW(px) : hn::Set(d, 1.0f);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const V place = hn::Mul(valuesAt(place_[axis], px), w);
                store(hn::Min(hn::Max(place, hn::Set(d, polygon_.lower[axis])),
                              hn::Set(d, polygon_.upper[axis])),
                      drawn, fragments_.place[axis]);
            }
            for (std::size_t c = 0; frame_.vertexColor && c < 4; ++c)
                store(hn::Mul(valuesAt(color_[c], px), w), drawn, fragments_.color[c]);
            hn::CompressStore(hn::Iota(di, y * kTileSide + x), hn::RebindMask(di, drawn), di,
                              fragments_.pixel.data() + fragments_.count);
            fragments_.count += count;
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
        left_ = polygon_.box.x0 - tile_.x;
        for (std::size_t axis = 0; axis < 3; ++axis)
            place_[axis] = rowOf(polygon_.place[axis], y);
        if (frame_.perspective) inverseW_ = rowOf(polygon_.inverseW, y);
        if (!frame_.depth.depths.empty()) depth_ = rowOf(polygon_.depth, y);
        for (std::size_t c = 0; frame_.vertexColor && c < 4; ++c)
            color_[c] = rowOf(polygon_.color[c], y);
    }

    V clipW(V px) const
    {
        const D d;
        return hn::Div(hn::Set(d, 1.0f),
                       hn::Max(valuesAt(inverseW_, px), hn::Set(d, polygon_.smallestInverseW)));
    }

    M drawnPixels(int x, int y, int right) const
    {
        const D d;
        M drawn = hn::FirstN(d, static_cast<std::size_t>(right - x));
        if (frame_.terminates)
            drawn = hn::And(drawn, hn::Gt(hn::LoadU(d, &tile_.transmittance[at(x, y)]), hn::Set(d, kOpaque)));
        if (!frame_.depth.depths.empty()) drawn = hn::And(drawn, inFront(x, y, right));
        return drawn;
    }

    M inFront(int x, int y, int right) const
    {
        const D d;
        alignas(64) std::array<float, 16> there{};
        const float* row = frame_.depth.depths.data() +
                           static_cast<std::size_t>(tile_.y + y) * static_cast<std::size_t>(frame_.width) +
                           static_cast<std::size_t>(tile_.x + x);
        const auto count = std::min(static_cast<std::size_t>(right - x), hn::Lanes(d));
        std::copy_n(row, count, there.begin());
        const V opaque = hn::Load(d, there.data());
        const V here = valuesAt(depth_, hn::Iota(d, static_cast<float>(x - left_)));
        return frame_.depth.orEqual ? hn::Le(here, opaque) : hn::Lt(here, opaque);
    }

    static std::size_t at(int x, int y) { return static_cast<std::size_t>(y * kTileSide + x); }

    void store(V values, M drawn, std::array<float, kStored>& target) const
    {
        hn::CompressStore(values, drawn, D(), target.data() + fragments_.count);
    }

    const FillFrame& frame_;
    const FillPolygon& polygon_;
    const FillTile& tile_;
    Fragments& fragments_;
    int left_ = 0;
    RowValue place_[3] = {}, inverseW_ = {}, depth_ = {}, color_[4] = {};
};

void fillTileOfTarget(const FillFrame& frame, std::span<const PolygonRows> polygons, FillTile& tile)
{
    Fragments fragments;
    int brick = -1;
    const auto flush = [&] {
        if (fragments.count == 0) return;
        shadeFragments(frame, frame.bricks[static_cast<std::size_t>(brick)], tile, fragments);
        blendFragments(frame.blending, fragments, tile);
        fragments.count = 0;
    };
    for (const PolygonRows& p : polygons) {
        if (p.polygon->brick != brick) flush();
        brick = p.polygon->brick;
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
} // namespace vo::HWY_NAMESPACE
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
        if (frame.blending == CastBlending::over) tile.transmittance.assign(kTilePixels + 16, 1.0f);
    }
    HWY_DYNAMIC_DISPATCH(fillTileOfTarget)(frame, polygons, tile);
}

} // namespace vo

#endif
