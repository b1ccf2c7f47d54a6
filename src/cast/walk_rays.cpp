#include "cast/walk_rays.h"

#include "core/highway_targets.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cast/walk_rays.cpp"
#include <hwy/foreach_target.h>

#include "cast/sample-inl.h"
#include "cast/shade-inl.h"

#include <hwy/cache_control.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace vo {
namespace HWY_NAMESPACE {
namespace {

using DoubleTag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<DoubleTag>;
constexpr DoubleTag kDoubles;
constexpr int kDoubleLanes = static_cast<int>(HWY_LANES(double) < 8 ? HWY_LANES(double) : 8);

/// Pixels that go together: 4 x 4, 4 x 2, 2 x 2.
constexpr int kPacketWidth = kLanes >= 8 ? 4 : kLanes >= 4 ? 2 : 1;
constexpr int kPacketHeight = kLanes / kPacketWidth;
constexpr int kTilePackets = kTile * kTile / kLanes;
/// Planes that a tile goes at a time.
constexpr float kSlab = 16.0f;
/// Samples between two looks for empty blocks.
constexpr int kRun = 4;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The rays of a packet. Places are in grid coordinates times kPlaceUnit.
struct Packet
{
    alignas(64) float start[3][kLanes]; ///< of the first sample
    alignas(64) float step[3][kLanes];
    alignas(64) float count[kLanes];      ///< samples
    alignas(64) float units[kLanes];      ///< of opacity a sample
    alignas(64) float first[kLanes];      ///< number of the sampling plane of the first sample
    alignas(64) float perStep[3][kLanes]; ///< 1 / step; large along axes that the ray hardly moves along
    std::intptr_t cellsAhead;             ///< from a sample of the middle ray to the one a slab further on

    // How far the walk has come.
    alignas(64) float sample[kLanes]; ///< the next one's number, from `first`
    alignas(64) float blend[5][kLanes];
    float next; ///< number of the nearest plane that is left; infinite: none
};

// ---- Where rays begin and end

struct PixelCentres
{
    Doubles x, y;

    HWY_INLINE Doubles operator()(const PixelRamp& ramp) const
    {
        return hn::MulAdd(hn::Set(kDoubles, ramp.dx), x,
                          hn::MulAdd(hn::Set(kDoubles, ramp.dy), y, hn::Set(kDoubles, ramp.at)));
    }
};

struct RayRange
{
    Doubles low, high;

    HWY_INLINE RayRange() : low(hn::Set(kDoubles, -kInfinity)), high(hn::Set(kDoubles, kInfinity)) {}

    /// Keeps t where origin + t * direction <= slack.
    HWY_INLINE void bound(Doubles origin, Doubles direction, double slack)
    {
        const Doubles zero = hn::Zero(kDoubles);
        const Doubles room = hn::Set(kDoubles, slack) - origin;
        const Doubles t = room / direction;
        high = hn::IfThenElse(direction > zero, hn::Min(high, t), high);
        low = hn::IfThenElse(direction < zero, hn::Max(low, t), low);
        const auto outside = hn::And(direction == zero, room < zero);
        low = hn::IfThenElse(outside, hn::Set(kDoubles, kInfinity), low);
    }
};

Doubles lengthOf(const Doubles (&v)[3])
{
    return hn::Sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Lengths of opacity between two samples, for each ray.
Doubles unitsOf(const glm::dmat3& gauge, const Doubles (&direction)[3])
{
    Doubles measured[3];
    for (int row = 0; row < 3; ++row) {
        measured[row] = hn::Zero(kDoubles);
        for (int column = 0; column < 3; ++column)
            measured[row] =
                hn::MulAdd(hn::Set(kDoubles, gauge[column][row]), direction[column], measured[row]);
    }
    return lengthOf(direction) / lengthOf(measured);
}

/// Keeps what lies before the caller's depths.
void boundByDepth(const RayJob& job, const PixelCentres& at, const double* pixelX, const double* pixelY,
                  RayRange& range)
{
    const CastDepth& depth = *job.depth;
    const double span = depth.farDepth - depth.nearDepth;
    alignas(64) double limit[kDoubleLanes];
    for (int lane = 0; lane < kDoubleLanes; ++lane) {
        const auto pixel =
            static_cast<std::size_t>(pixelY[lane]) * static_cast<std::size_t>(job.viewportWidth) +
            static_cast<std::size_t>(pixelX[lane]);
        const double there = depth.depths[pixel];
        if (span != 0.0)
            limit[lane] = 2.0 * (there - depth.nearDepth) / span - 1.0;
        else if (depth.orEqual ? depth.nearDepth <= there : depth.nearDepth < there)
            limit[lane] = 2.0;
        else
            limit[lane] = -2.0;
    }
    const Doubles most = hn::Load(kDoubles, limit);
    const Doubles side = hn::Set(kDoubles, span < 0.0 ? -1.0 : 1.0);
    const RayBound &z = job.frame->clipZ, &w = job.frame->clipW;
    range.bound(side * (at(z.origin) - most * at(w.origin)),
                side * (at(z.direction) - most * at(w.direction)), depth.orEqual ? 1e-9 : 0.0);
}

/// The rays of kDoubleLanes pixels, from `lane` of the packet on.
void setRays(const RayJob& job, const double* pixelX, const double* pixelY, int lane, Packet& packet)
{
    const RayFrame& frame = *job.frame;
    const PixelCentres at{hn::Load(kDoubles, pixelX), hn::Load(kDoubles, pixelY)};
    const Doubles zero = hn::Zero(kDoubles);
    Doubles origin[3], direction[3];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        origin[axis] = at(frame.origin[axis]);
        direction[axis] = at(frame.direction[axis]);
    }
    Doubles along = at(frame.along);
    if (frame.shells) {
        Doubles scaled[3];
        for (int axis = 0; axis < 3; ++axis)
            scaled[axis] = direction[axis] * hn::Set(kDoubles, 1.0 / frame.scale[axis]);
        along = lengthOf(scaled);
    }
    RayRange range;
    for (const RayBound& bound : frame.bounds)
        range.bound(at(bound.origin), at(bound.direction), bound.slack);
    if (job.depth) boundByDepth(job, at, pixelX, pixelY, range);

    const Doubles nearest = at(frame.nearest);
    const Doubles perSpacing = hn::Set(kDoubles, 1.0 / frame.spacing);
    const Doubles a = (range.low * along - nearest) * perSpacing;
    const Doubles b = (range.high * along - nearest) * perSpacing;
    const auto backwards = along < zero;
    const Doubles first = hn::Max(hn::Ceil(hn::IfThenElse(backwards, b, a)), zero);
    const Doubles last =
        hn::Min(hn::Floor(hn::IfThenElse(backwards, a, b)), hn::Set(kDoubles, frame.count - 1.0));
    // Neither for a NaN, nor for rays along the planes.
    const auto meets = hn::And(first <= last, hn::And(range.low <= range.high, along != zero));
    const Doubles count = hn::IfThenElseZero(meets, last - first + hn::Set(kDoubles, 1.0));

    constexpr hn::Rebind<float, DoubleTag> kHalf;
    const auto put = [&](Doubles from, float* to) {
        hn::StoreU(hn::DemoteTo(kHalf, from), kHalf, to + lane);
    };
    const Doubles perAlong = hn::Set(kDoubles, 1.0) / along;
    const Doubles t = hn::MulAdd(first, hn::Set(kDoubles, frame.spacing), nearest) * perAlong;
    const Doubles unit = hn::Set(kDoubles, double{kPlaceUnit});
    for (int axis = 0; axis < 3; ++axis) {
        const Doubles start =
            hn::MulAdd(direction[axis], t, origin[axis] + hn::Set(kDoubles, job.shift[axis]));
        put(hn::IfThenElseZero(meets, start * unit), packet.start[axis]);
        const Doubles step = direction[axis] * hn::Set(kDoubles, frame.spacing) * perAlong;
        put(hn::IfThenElseZero(meets, step * unit), packet.step[axis]);
    }
    put(count, packet.count);
    put(first, packet.first);
    put(job.gauge ? unitsOf(*job.gauge, direction) : hn::Set(kDoubles, 1.0), packet.units);
}

/// What the walk asks of the steps of a packet, again and again.
void setSteps(const GridView& grid, Packet& packet)
{
    const std::intptr_t pitch[3] = {1, static_cast<std::intptr_t>(grid.rowPitch),
                                    static_cast<std::intptr_t>(grid.slicePitch)};
    packet.cellsAhead = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Floats step = hn::Load(kFloats, packet.step[axis]);
        const auto moves = hn::Abs(step) > hn::Set(kFloats, 1e-2f);
        hn::Store(hn::IfThenElse(moves, hn::Set(kFloats, 1.0f) / step, hn::Set(kFloats, 1e6f)), kFloats,
                  packet.perStep[axis]);
        const float voxels = kSlab / kPlaceUnit * packet.step[axis][kLanes / 2];
        packet.cellsAhead += std::lround(std::fmax(-1e5f, std::fmin(voxels, 1e5f))) * pitch[axis];
    }
}

/// The packet whose left lower pixel is (x, y). Pixels beyond the tile have no samples.
void setPacket(const RayJob& job, const PixelRectangle& tile, int x, int y, Packet& packet)
{
    alignas(64) double pixelX[kDoubleLanes], pixelY[kDoubleLanes];
    for (int lane = 0; lane < kLanes; lane += kDoubleLanes) {
        for (int i = 0; i < kDoubleLanes; ++i) {
            pixelX[i] = std::min(x + (lane + i) % kPacketWidth, tile.right - 1);
            pixelY[i] = std::min(y + (lane + i) / kPacketWidth, tile.top - 1);
        }
        setRays(job, pixelX, pixelY, lane, packet);
    }
    for (int lane = 0; lane < kLanes; ++lane)
        if (x + lane % kPacketWidth >= tile.right || y + lane / kPacketWidth >= tile.top)
            packet.count[lane] = 0.0f;
    setSteps(job.grid, packet);
    packet.next = std::numeric_limits<float>::infinity();
    for (int lane = 0; lane < kLanes; ++lane) {
        packet.sample[lane] = 0.0f;
        if (packet.count[lane] > 0.0f) packet.next = std::min(packet.next, packet.first[lane]);
    }
}

// ---- How samples join

/// A lane each: red, green, blue, and transmittance or alpha.
struct PixelLanes
{
    Floats rgbt[4];
    Floats alpha;
};

/// Of samples with one channel, which are not asked for another.
struct NoPlace
{
};

template <class Sampler, class Shade>
struct Fragments
{
    static constexpr bool kIsSmooth = false;
    using At = std::conditional_t<Sampler::kChannels == 1, NoPlace, Place>;

    const Sampler& sampler;
    const Shade& shade;
    const At& at;
    Floats value;
    typename Shade::Key key;

    HWY_INLINE Fragments(const Sampler& s, const Shade& f, const At& place, Floats answer)
        : sampler(s), shade(f), at(place), value(answer), key(f.key(answer))
    {
    }

    HWY_INLINE Floats raw() const { return value; }
    HWY_INLINE Floats alpha() const { return shade.component(key, 3); }
    HWY_INLINE Floats color(std::size_t c) const
    {
        if constexpr (Sampler::kChannels == 1)
            return shade.component(key, c);
        else
            return shade.component(shade.key(sampler.value(at, static_cast<int>(c))), c);
    }
    HWY_INLINE Floats red() const { return color(0); }
    HWY_INLINE void greenBlue(Floats& green, Floats& blue) const
    {
        green = color(1);
        blue = color(2);
    }
};

/// Two components are read at a time, colours when they are asked for.
template <class Sampler>
struct Fragments<Sampler, PackedShade>
{
    static constexpr bool kIsSmooth = false;
    const PackedShade& shade;
    PackedShade::Key key;
    IntPairs redAlpha;

    HWY_INLINE Fragments(const Sampler&, const PackedShade& f, const NoPlace&, Floats answer)
        : shade(f), key(f.key(answer)), redAlpha(f.redAlpha(key))
    {
    }

    HWY_INLINE Floats alpha() const { return shade.component(key, redAlpha.second, 3); }
    HWY_INLINE Floats red() const { return shade.component(key, redAlpha.first, 0); }
    HWY_INLINE void greenBlue(Floats& green, Floats& blue) const
    {
        const IntPairs both = shade.greenBlue(key);
        green = shade.component(key, both.first, 1);
        blue = shade.component(key, both.second, 2);
    }
};

/// One read for all.
template <class Sampler>
struct Fragments<Sampler, SmoothShade>
{
    static constexpr bool kIsSmooth = true;
    const SmoothShade& shade;
    SmoothShade::Key key;
    IntPairs alphaColor;

    HWY_INLINE Fragments(const Sampler&, const SmoothShade& f, const NoPlace&, Floats answer)
        : shade(f), key(f.key(answer)), alphaColor(f.read(key))
    {
    }

    HWY_INLINE Floats alpha() const { return shade.alpha(key, alphaColor.first); }
    HWY_INLINE Floats red() const { return shade.red(alphaColor.second); }
    HWY_INLINE void greenBlue(Floats& green, Floats& blue) const
    {
        green = shade.green(alphaColor.second);
        blue = shade.blue(alphaColor.second);
    }
};

/// Front to back, until nothing more is seen. Colours count as much as their alpha says, or as they are.
template <bool kPremultiplied>
class Composite
{
public:
    static constexpr bool kClearAddsNothing = !kPremultiplied;

    Composite(const RayJob& job, const Packet& packet)
        : grey_(job.shading->grey), perUnit_(job.gauge != nullptr), length_(hn::Load(kFloats, packet.units))
    {
    }

    template <class Source>
    HWY_INLINE void add(const Source& source, Mask active)
    {
        const Floats zero = hn::Zero(kFloats);
        const auto seen = hn::And(active, transmittance_ >= hn::Set(kFloats, kLeastTransmittance));
        Floats alpha = hn::IfThenElseZero(seen, source.alpha());
        if (kPremultiplied ? hn::AllFalse(kFloats, seen) : hn::AllTrue(kFloats, alpha == zero)) return;
        if (perUnit_) alpha = Source::kIsSmooth ? length_.opacityOfSmooth(alpha) : length_.opacity(alpha);
        const Floats weight = transmittance_ * alpha;
        const Floats colorWeight = kPremultiplied ? hn::IfThenElseZero(seen, transmittance_) : weight;
        red_ = hn::MulAdd(colorWeight, source.red(), red_);
        if (!grey_) {
            Floats green, blue;
            source.greenBlue(green, blue);
            green_ = hn::MulAdd(colorWeight, green, green_);
            blue_ = hn::MulAdd(colorWeight, blue, blue_);
        }
        alpha_ = hn::MulAdd(weight, alpha, alpha_);
        transmittance_ = transmittance_ - weight;
    }

    void keep(Packet& packet) const
    {
        hn::Store(red_, kFloats, packet.blend[0]);
        hn::Store(green_, kFloats, packet.blend[1]);
        hn::Store(blue_, kFloats, packet.blend[2]);
        hn::Store(alpha_, kFloats, packet.blend[3]);
        hn::Store(transmittance_, kFloats, packet.blend[4]);
    }
    void goOn(const Packet& packet)
    {
        red_ = hn::Load(kFloats, packet.blend[0]);
        green_ = hn::Load(kFloats, packet.blend[1]);
        blue_ = hn::Load(kFloats, packet.blend[2]);
        alpha_ = hn::Load(kFloats, packet.blend[3]);
        transmittance_ = hn::Load(kFloats, packet.blend[4]);
    }

    /// Rays that see nothing more have no more samples.
    HWY_INLINE Floats left(Floats count) const
    {
        return hn::IfThenElseZero(transmittance_ >= hn::Set(kFloats, kLeastTransmittance), count);
    }

    PixelLanes result() const
    {
        return {{red_, grey_ ? red_ : green_, grey_ ? red_ : blue_, transmittance_}, alpha_};
    }

private:
    bool grey_;
    bool perUnit_;
    LengthOfSamples length_;
    Floats red_ = hn::Zero(kFloats), green_ = hn::Zero(kFloats), blue_ = hn::Zero(kFloats);
    Floats alpha_ = hn::Zero(kFloats);
    Floats transmittance_ = hn::Set(kFloats, 1.0f);
};

using Over = Composite<false>;
using Premultiplied = Composite<true>;

float startOf(CastBlending blending)
{
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    switch (blending) {
    case CastBlending::max: return -kInfinite;
    case CastBlending::min: return kInfinite;
    case CastBlending::over:
    case CastBlending::premultiplied:
    case CastBlending::sum:
    case CastBlending::alphaSum: break;
    }
    return 0.0f;
}

/// Blendings that need no order.
class Others
{
public:
    static constexpr bool kClearAddsNothing = false;

    Others(const RayJob& job, const Packet& packet)
        : blending_(job.blending), perUnit_(job.gauge != nullptr), length_(hn::Load(kFloats, packet.units))
    {
        for (Floats& value : value_)
            value = hn::Set(kFloats, startOf(blending_));
    }

    template <class Source>
    HWY_INLINE void add(const Source& source, Mask active)
    {
        Floats alpha = source.alpha();
        if (perUnit_) alpha = length_.opacity(alpha);
        for (std::size_t c = 0; c < 4; ++c) {
            const Floats fragment = c < 3 ? source.color(c) : alpha;
            value_[c] = hn::IfThenElse(active, joined(value_[c], fragment, alpha), value_[c]);
        }
    }

    void keep(Packet& packet) const
    {
        for (std::size_t c = 0; c < 4; ++c)
            hn::Store(value_[c], kFloats, packet.blend[c]);
    }
    void goOn(const Packet& packet)
    {
        for (std::size_t c = 0; c < 4; ++c)
            value_[c] = hn::Load(kFloats, packet.blend[c]);
    }

    HWY_INLINE Floats left(Floats count) const { return count; }
    PixelLanes result() const { return {{value_[0], value_[1], value_[2], value_[3]}, value_[3]}; }

private:
    HWY_INLINE Floats joined(Floats there, Floats fragment, Floats alpha) const
    {
        switch (blending_) {
        case CastBlending::max: return hn::Max(there, fragment);
        case CastBlending::min: return hn::Min(there, fragment);
        case CastBlending::alphaSum: return hn::MulAdd(fragment, alpha, there);
        case CastBlending::sum:
        case CastBlending::premultiplied:
        case CastBlending::over: break;
        }
        return there + fragment;
    }

    CastBlending blending_;
    bool perUnit_;
    LengthOfSamples length_;
    Floats value_[4];
};

/// The largest or the smallest sample, where no component falls as samples rise; shaded at the end.
template <class Shade>
class Extreme
{
public:
    static constexpr bool kClearAddsNothing = false;

    Extreme(const RayJob& job, const Packet& packet)
        : job_(job), most_(job.blending == CastBlending::max), raw_(hn::Set(kFloats, startOf(job.blending))),
          count_(hn::Load(kFloats, packet.count))
    {
    }

    template <class Source>
    HWY_INLINE void add(const Source& source, Mask active)
    {
        const Floats raw = source.raw();
        raw_ = hn::IfThenElse(active, most_ ? hn::Max(raw_, raw) : hn::Min(raw_, raw), raw_);
    }

    void keep(Packet& packet) const { hn::Store(raw_, kFloats, packet.blend[0]); }
    void goOn(const Packet& packet) { raw_ = hn::Load(kFloats, packet.blend[0]); }

    HWY_INLINE Floats left(Floats count) const { return count; }

    PixelLanes result() const
    {
        const Shade shade(*job_.shading, job_.grid.rawUnit);
        const Mask any = count_ > hn::Zero(kFloats);
        PixelLanes pixels;
        for (std::size_t c = 0; c < 4; ++c)
            pixels.rgbt[c] = hn::IfThenElse(any, shade.component(shade.key(raw_), c), raw_);
        pixels.alpha = pixels.rgbt[3];
        return pixels;
    }

    /// Where a block's highest (for max; else lowest) sample changes anything.
    HWY_INLINE Mask mayChange(Floats end) const { return most_ ? end > raw_ : end < raw_; }

private:
    const RayJob& job_;
    bool most_;
    Floats raw_;
    Floats count_;
};

template <class Blend>
constexpr bool kIsExtreme = false;
template <class Shade>
constexpr bool kIsExtreme<Extreme<Shade>> = true;

// ---- The walk

/// Steps over blocks that hold nothing.
class Leaps
{
public:
    Leaps(const RayJob& job, const Packet& packet)
        : distance_(reinterpret_cast<const std::int32_t*>(job.blockDistance)),
          ranges_(job.blockRanges ? job.blockRanges + (job.blending == CastBlending::max) : nullptr),
          pitchY_(hn::Set(kInts, job.blockCount.x)),
          pitchZ_(hn::Set(kInts, job.blockCount.x * job.blockCount.y)),
          last_(hn::Set(
              kUints, static_cast<std::uint32_t>(job.blockCount.x * job.blockCount.y * job.blockCount.z - 1)))
    {
        for (int axis = 0; axis < 3; ++axis) {
            perStep_[axis] = hn::Load(kFloats, packet.perStep[axis]);
            forward_[axis] = perStep_[axis] > hn::Zero(kFloats);
        }
    }

    /// Samples that may be left out from these places on; 0 where a block may hold something.
    template <class Blend>
    HWY_INLINE Floats leap(const Ints (&place)[3], const Blend& blend, Mask& occupied) const
    {
        constexpr int kShift = kPlaceBits + kBlockShift;
        Ints block[3];
        for (int axis = 0; axis < 3; ++axis)
            block[axis] = hn::ShiftRight<kShift>(place[axis]);
        const Ints number = block[0] + block[1] * pitchY_ + block[2] * pitchZ_;
        const Ints inside = hn::BitCast(kInts, hn::Min(hn::BitCast(kUints, number), last_));
        Ints free;
        if constexpr (kIsExtreme<Blend>) {
            occupied = blend.mayChange(gather(ranges_, inside + inside));
            free = hn::BitCast(kInts, hn::IfThenZeroElse(occupied, hn::BitCast(kFloats, hn::Set(kInts, 1))));
        } else {
            free = hn::And(gatherAtByte(distance_, inside), hn::Set(kInts, 0xff));
            occupied = hn::RebindMask(kFloats, free == hn::Zero(kInts));
        }
        if (hn::AllTrue(kFloats, occupied)) return hn::Zero(kFloats);
        Floats steps = hn::Set(kFloats, 1e6f);
        for (int axis = 0; axis < 3; ++axis) {
            const Ints one = hn::Set(kInts, 1);
            const Ints face = hn::IfThenElse(hn::RebindMask(kInts, forward_[axis]), block[axis] + free,
                                             block[axis] + one - free);
            const Floats way = hn::ConvertTo(kFloats, hn::ShiftLeft<kShift>(face) - place[axis]);
            // Since places are rounded.
            const Floats margin = hn::CopySign(hn::Set(kFloats, 64.0f), way);
            steps = hn::Min(steps, (way - margin) * perStep_[axis]);
        }
        const Floats whole = hn::Floor(hn::Max(steps, hn::Zero(kFloats))) + hn::Set(kFloats, 1.0f);
        return hn::IfThenZeroElse(occupied, whole);
    }

private:
    const std::int32_t* distance_;
    const float* ranges_;
    Ints pitchY_, pitchZ_;
    hn::Vec<UintTag> last_;
    Floats perStep_[3];
    Mask forward_[3];
};

/// Asks for the voxels near some places of the slab after this one, without waiting: neighbours share lines
/// of the cache. The middle ray says how far that is, since the exact cells would take as long as those of
/// samples.
template <class Sampler>
class Ahead
{
public:
    Ahead(const GridView& grid, const Packet& packet)
        : start_(reinterpret_cast<std::uintptr_t>(grid.cells) +
                 static_cast<std::uintptr_t>(packet.cellsAhead) * Sampler::kCellBytes)
    {
    }

    HWY_INLINE void ask(const Place& at) const
    {
        constexpr int kLanesApart = 3;
        alignas(64) std::int32_t cell[kLanes];
        hn::Store(at.cell, kInts, cell);
        // No object need lie there: asking for what is not there does nothing.
        for (int lane = 0; lane < kLanes; lane += kLanesApart)
            hwy::Prefetch(reinterpret_cast<const std::byte*>(
                start_ + Sampler::kCellBytes * static_cast<std::uintptr_t>(cell[lane])));
    }

private:
    std::uintptr_t start_;
};

/// The places of a run's samples, where channels besides the first are sampled later; storing them takes
/// time.
template <class Sampler, bool kLater = (Sampler::kChannels > 1)>
class PlacesOfRun
{
public:
    HWY_INLINE void keep(int i, const Place& place) { places_[i] = place; }
    HWY_INLINE const Place& of(int i) const { return places_[i]; }

private:
    Place places_[kRun];
};

template <class Sampler>
class PlacesOfRun<Sampler, false>
{
public:
    HWY_INLINE void keep(int, const Place&) {}
    HWY_INLINE NoPlace of(int) const { return {}; }
};

/// The rays of a packet in the grid.
class Lines
{
public:
    explicit Lines(const Packet& packet)
    {
        for (int axis = 0; axis < 3; ++axis) {
            start_[axis] = hn::Load(kFloats, packet.start[axis]);
            step_[axis] = hn::Load(kFloats, packet.step[axis]);
        }
    }

    HWY_INLINE void placesOf(Floats sample, Ints (&place)[3]) const
    {
        for (int axis = 0; axis < 3; ++axis)
            place[axis] = toNearest(hn::MulAdd(sample, step_[axis], start_[axis]));
    }

private:
    Floats start_[3], step_[3];
};

template <class Sampler>
struct Run
{
    PlacesOfRun<Sampler> at;
    Floats raw[kRun];
};

/// Takes a run's samples from number `sample` on; those a slab further on are asked for meanwhile.
template <class Sampler>
HWY_INLINE void take(const Ahead<Sampler>& ahead, const GridLanes& grid, const Sampler& sampler,
                     const Lines& lines, Floats sample, Run<Sampler>& run)
{
#pragma GCC unroll 4
    for (int i = 0; i < kRun; ++i) {
        Ints place[3];
        lines.placesOf(sample + hn::Set(kFloats, static_cast<float>(i)), place);
        const Place here = grid.place(place[0], place[1], place[2]);
        ahead.ask(here);
        run.raw[i] = sampler.value(here, Sampler::kChannels - 1);
        run.at.keep(i, here);
    }
}

/// Whether no sample of a run adds anything, as far as that is known without a look at the table.
template <class Blend, class Sampler, class Shade>
HWY_INLINE bool addsNothing(const Run<Sampler>& run, const Shade& shade)
{
    if constexpr (!Blend::kClearAddsNothing) return false;
    if constexpr (Sampler::kIsNumber) {
        Floats highest = run.raw[0];
        for (int i = 1; i < kRun; ++i)
            highest = hn::Max(highest, run.raw[i]);
        return hn::AllFalse(kFloats, shade.mayBeSeen(highest));
    }
    Mask seen = shade.mayBeSeen(run.raw[0]);
    for (int i = 1; i < kRun; ++i)
        seen = hn::Or(seen, shade.mayBeSeen(run.raw[i]));
    return hn::AllFalse(kFloats, seen);
}

/// Takes the packet's samples that lie before plane number `end`.
template <class Sampler, class Shade, class Blend>
void walk(const RayJob& job, const Shade& shade, float end, Packet& packet)
{
    const GridLanes grid(job.grid);
    const Sampler sampler(job.grid);
    const Leaps leaps(job, packet);
    const Lines lines(packet);
    const Ahead<Sampler> ahead(job.grid, packet);
    const bool leaping = kIsExtreme<Blend> ? job.blockRanges != nullptr : job.blockDistance != nullptr;
    Blend blend(job, packet);
    blend.goOn(packet);
    const Floats one = hn::Set(kFloats, 1.0f);
    Floats count = hn::Load(kFloats, packet.count);
    const Floats first = hn::Load(kFloats, packet.first);
    const Floats bound = hn::Set(kFloats, end) - first;
    Floats sample = hn::Load(kFloats, packet.sample);
    while (!hn::AllFalse(kFloats, sample < hn::Min(count, bound))) {
        if (leaping) {
            Ints place[3];
            lines.placesOf(sample, place);
            Mask occupied;
            const auto active = sample < count;
            sample = sample + leaps.leap(place, blend, occupied);
            if (hn::AllFalse(kFloats, hn::And(active, occupied))) continue;
        }
        // All samples of a run before all of their fragments: the more reads are under way at a time.
        Run<Sampler> run;
        take(ahead, grid, sampler, lines, sample, run);
        if (addsNothing<Blend>(run, shade)) {
            sample = sample + hn::Set(kFloats, static_cast<float>(kRun));
            continue;
        }
#pragma GCC unroll 4
        for (int i = 0; i < kRun; ++i, sample = sample + one)
            blend.add(Fragments<Sampler, Shade>(sampler, shade, run.at.of(i), run.raw[i]), sample < count);
        count = blend.left(count);
    }
    blend.keep(packet);
    hn::Store(sample, kFloats, packet.sample);
    hn::Store(count, kFloats, packet.count);
    const Floats never = hn::Set(kFloats, std::numeric_limits<float>::infinity());
    packet.next = hn::GetLane(hn::MinOfLanes(kFloats, hn::IfThenElse(sample < count, first + sample, never)));
}

/// The pixels of a packet that lie in the tile.
void store(const RayJob& job, const PixelRectangle& tile, int x, int y, const PixelLanes& pixels)
{
    alignas(64) float rgbt[4 * kLanes];
    alignas(64) float alpha[kLanes];
    hn::StoreInterleaved4(pixels.rgbt[0], pixels.rgbt[1], pixels.rgbt[2], pixels.rgbt[3], kFloats, rgbt);
    hn::Store(pixels.alpha, kFloats, alpha);
    CastPicture& picture = *job.picture;
    const int width = std::min(kPacketWidth, tile.right - x);
    for (int row = 0; row < std::min(kPacketHeight, tile.top - y); ++row) {
        const auto pixel =
            static_cast<std::size_t>(y + row - picture.y) * static_cast<std::size_t>(picture.width) +
            static_cast<std::size_t>(x - picture.x);
        std::copy_n(rgbt + 4 * kPacketWidth * row, 4 * width, picture.rgbt.data() + 4 * pixel);
        if (!picture.alpha.empty())
            std::copy_n(alpha + kPacketWidth * row, width, picture.alpha.data() + pixel);
    }
}

/// All packets of a tile go a few planes before any goes on: neighbours read the same voxels, while these are
/// near.
template <class Sampler, class Shade, class Blend>
void walkTile(const RayJob& job, const PixelRectangle& tile)
{
    const Shade shade(*job.shading, job.grid.rawUnit);
    Packet packets[kTilePackets];
    const int columns = (tile.width() + kPacketWidth - 1) / kPacketWidth;
    const int count = columns * ((tile.height() + kPacketHeight - 1) / kPacketHeight);
    const auto xOf = [&](int i) { return tile.left + i % columns * kPacketWidth; };
    const auto yOf = [&](int i) { return tile.bottom + i / columns * kPacketHeight; };
    float next = std::numeric_limits<float>::infinity();
    for (int i = 0; i < count; ++i) {
        setPacket(job, tile, xOf(i), yOf(i), packets[i]);
        Blend(job, packets[i]).keep(packets[i]);
        next = std::min(next, packets[i].next);
    }
    while (next < static_cast<float>(job.frame->count)) {
        const float end = next + kSlab;
        next = std::numeric_limits<float>::infinity();
        for (int i = 0; i < count; ++i) {
            if (packets[i].next < end) walk<Sampler, Shade, Blend>(job, shade, end, packets[i]);
            next = std::min(next, packets[i].next);
        }
    }
    for (int i = 0; i < count; ++i) {
        Blend blend(job, packets[i]);
        blend.goOn(packets[i]);
        PixelLanes pixels = blend.result();
        if constexpr (std::is_same_v<Shade, SmoothShade>)
            for (std::size_t c = 0; c < 3; ++c)
                pixels.rgbt[c] =
                    pixels.rgbt[c] * hn::Set(kFloats, shade.colorScale(job.shading->grey ? 0 : c));
        store(job, tile, xOf(i), yOf(i), pixels);
    }
}

template <class Sampler>
void walkSamples(const RayJob& job, const PixelRectangle& tile)
{
    const ShadingPlan& shading = *job.shading;
    if (job.blending == CastBlending::premultiplied) {
        if (shading.table) return walkTile<Sampler, TableShade, Premultiplied>(job, tile);
        return walkTile<Sampler, LinearShade, Premultiplied>(job, tile);
    }
    if (job.blending != CastBlending::over) {
        if (job.extremeOfRaw && shading.table)
            return walkTile<Sampler, TableShade, Extreme<TableShade>>(job, tile);
        if (job.extremeOfRaw) return walkTile<Sampler, LinearShade, Extreme<LinearShade>>(job, tile);
        if (shading.table) return walkTile<Sampler, TableShade, Others>(job, tile);
        return walkTile<Sampler, LinearShade, Others>(job, tile);
    }
    // Four channels each have a place of their own in the table.
    if constexpr (Sampler::kChannels == 1) {
        if (shading.smoothSteps > 0) return walkTile<Sampler, SmoothShade, Over>(job, tile);
        if (shading.packed()) return walkTile<Sampler, PackedShade, Over>(job, tile);
    }
    if (shading.table) return walkTile<Sampler, TableShade, Over>(job, tile);
    return walkTile<Sampler, LinearShade, Over>(job, tile);
}

} // namespace

void walkRaysOfTarget(const RayJob& job, const PixelRectangle& tile)
{
    switch (job.grid.kind) {
    case GridKind::bytes: return walkSamples<ByteSampler>(job, tile);
    case GridKind::shorts: return walkSamples<ShortSampler>(job, tile);
    case GridKind::floats: break;
    }
    job.grid.channels == 1 ? walkSamples<FloatSampler<1>>(job, tile)
                           : walkSamples<FloatSampler<4>>(job, tile);
}

} // namespace HWY_NAMESPACE
} // namespace vo
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace vo {

HWY_EXPORT(walkRaysOfTarget);

void walkRays(const RayJob& job, const PixelRectangle& tile)
{
    HWY_DYNAMIC_DISPATCH(walkRaysOfTarget)(job, tile);
}

} // namespace vo
#endif
