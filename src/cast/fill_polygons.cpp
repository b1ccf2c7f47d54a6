#include "cast/fill_polygons.h"

#include "cast/fill_tile.h"
#include "cast/fill_voxels.h"
#include "cast/polygon_setup.h"
#include "core/parallel.h"
#include "polygonize/camera.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace vo {

namespace {

constexpr int kMostPixels = 16384; ///< a side
constexpr int kMostVoxels = 65000; ///< a side of a brick
constexpr std::size_t kChunkIndices = 3 * 256;
constexpr std::size_t kChunksAtOnce = 256;
constexpr std::size_t kTilePixels = static_cast<std::size_t>(kTileSide) * kTileSide;

/// Consecutive whole polygons of one brick.
struct Chunk
{
    int brick;
    std::size_t first; ///< of the indices
    std::size_t end;
};

/// Whether the triangle at index i goes on with the fan of the one before it.
bool goesOn(std::span<const std::uint32_t> indices, std::size_t i)
{
    return indices[i + 2] == indices[i - 1] && indices[i] == indices[i - 2];
}

/// End of the polygon that holds the triangle before index i, within a run that ends at `end`.
std::size_t endOfPolygon(std::span<const std::uint32_t> indices, std::size_t i, std::size_t end)
{
    while (i < end && goesOn(indices, i))
        i += 3;
    return i;
}

std::vector<Chunk> chunksOf(const FramePolygons& polygons)
{
    std::vector<Chunk> chunks;
    for (const PolygonRun& run : polygons.runs) {
        const std::size_t end = run.first + run.count;
        for (std::size_t first = run.first; first < end;) {
            const std::size_t near = std::min(first + kChunkIndices, end);
            const std::size_t stop = endOfPolygon(polygons.indices, near, end);
            chunks.push_back({run.brick, first, stop});
            first = stop;
        }
    }
    return chunks;
}

// ---- What fragments become

bool isUnit(float value)
{
    return value >= 0.0f && value <= 1.0f;
}

bool clampsTexels(const CastBrick& brick)
{
    const VoxelType type = brick.texels.format.type;
    return brick.texels.classified || (type != VoxelType::float32 && type != VoxelType::int32);
}

/// Whether no sample has an opacity outside 0 to 1.
bool boundsOpacity(const CastRequest& request)
{
    if (request.opacityGauge) return true;
    if (request.layout.color >= 0 || !isUnit(request.shading.color.a)) return false;
    return request.shading.table || std::ranges::all_of(request.bricks, clampsTexels);
}

FillFrame frameOf(const CastRequest& request)
{
    FillFrame frame;
    frame.shading = request.shading;
    frame.blending = request.blending;
    frame.perspective = WindowProjection(request).perspective();
    frame.vertexColor = request.layout.color >= 0;
    frame.opacityPerLength = request.opacityGauge.has_value();
    frame.terminates = hidesBehind(request.blending) && boundsOpacity(request);
    frame.depth = request.depth;
    frame.width = request.width;
    return frame;
}

/// The lines of sight of pixels in object space: linear in the pixel's place.
struct Sights
{
    glm::dvec3 start{0.0}; ///< of the window's left lower corner
    glm::dvec3 right{0.0}; ///< change a pixel
    glm::dvec3 up{0.0};

    glm::dvec3 through(double x, double y) const { return start + x * right + y * up; }
};

Sights sightsOf(const CastRequest& request, const Camera& camera)
{
    Sights sights;
    if (!camera.perspective) {
        sights.start = camera.direction;
        return sights;
    }
    // Points of the middle of the depth range, times their homogeneous part: all on the same side of the eye.
    const glm::dmat4 inverse = glm::inverse(request.projection * request.model);
    const auto fromEye = [&](const glm::dvec4& p) { return glm::dvec3(p) - p.w * camera.eye; };
    sights.right = fromEye(inverse[0]) * (2.0 / request.width);
    sights.up = fromEye(inverse[1]) * (2.0 / request.height);
    sights.start = fromEye(inverse[3] - inverse[0] - inverse[1]);
    return sights;
}

void setUnits(const Sights& sights, const glm::dmat3& gauge, FillTile& tile)
{
    tile.units.resize(kTilePixels);
    for (int y = 0; y < kTileSide; ++y)
        for (int x = 0; x < kTileSide; ++x) {
            const glm::dvec3 sight = sights.through(tile.x + x + 0.5, tile.y + y + 0.5);
            tile.units[static_cast<std::size_t>(y * kTileSide + x)] =
                static_cast<float>(glm::length(sight) / glm::length(gauge * sight));
        }
}

// ---- Tiles

/// The polygons of chunks, by the tiles that their boxes meet.
class TileBins
{
public:
    TileBins(int across, int up)
        : across_(across), tiles_(static_cast<std::size_t>(across) * static_cast<std::size_t>(up))
    {
    }

    void start(std::size_t chunks)
    {
        chunks_ = chunks;
        starts_.assign(chunks * tiles_ + 1, 0);
    }

    /// Chunks may be counted at the same time.
    void count(std::size_t chunk, const FillList& list)
    {
        for (const FillPolygon& polygon : list.polygons)
            forTiles(polygon.box, [&](std::size_t tile) { ++place(chunk, tile); });
    }

    /// Once all are counted: room for each chunk in each tile.
    void allot()
    {
        std::size_t sum = 0;
        for (std::size_t& start : starts_)
            sum += std::exchange(start, sum);
        entries_.resize(sum);
    }

    /// Chunks may be entered at the same time; their polygons in the order given, or the reverse.
    void enter(std::size_t chunk, const FillList& list, bool reverse)
    {
        const std::size_t count = list.polygons.size();
        for (std::size_t i = 0; i < count; ++i) {
            const FillPolygon& polygon = list.polygons[reverse ? count - 1 - i : i];
            const PolygonRows entry{&polygon, list.rows.data() + polygon.firstRow};
            forTiles(polygon.box, [&](std::size_t tile) { entries_[place(chunk, tile)++] = entry; });
        }
    }

    /// Once all are entered.
    std::span<const PolygonRows> of(std::size_t tile) const
    {
        const std::size_t first = tile == 0 ? 0 : starts_[tile * chunks_ - 1];
        return std::span(entries_).subspan(first, starts_[(tile + 1) * chunks_ - 1] - first);
    }

private:
    /// Where the next polygon of a chunk goes in a tile; chunks of a tile follow each other.
    std::size_t& place(std::size_t chunk, std::size_t tile) { return starts_[tile * chunks_ + chunk]; }

    template <class Function>
    void forTiles(const PixelBox& box, Function function) const
    {
        for (int y = box.y0 / kTileSide; y <= (box.y1 - 1) / kTileSide; ++y)
            for (int x = box.x0 / kTileSide; x <= (box.x1 - 1) / kTileSide; ++x)
                function(static_cast<std::size_t>(y) * static_cast<std::size_t>(across_) +
                         static_cast<std::size_t>(x));
    }

    int across_;
    std::size_t tiles_;
    std::size_t chunks_ = 0;
    std::vector<std::size_t> starts_;
    std::vector<PolygonRows> entries_;
};

int tilesAlong(int pixels)
{
    return (pixels + kTileSide - 1) / kTileSide;
}

std::vector<FillTile> tilesOf(int width, int height)
{
    std::vector<FillTile> tiles;
    for (int y = 0; y < height; y += kTileSide)
        for (int x = 0; x < width; x += kTileSide) {
            tiles.emplace_back();
            tiles.back().x = x;
            tiles.back().y = y;
        }
    return tiles;
}

/// The smallest box around both.
PixelBox united(const PixelBox& a, const PixelBox& b)
{
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

// ---- The picture

/// Copies the part of a tile that lies in the picture.
void copyTile(const FillFrame& frame, const FillTile& tile, CastPicture& picture)
{
    const bool hides = hidesBehind(frame.blending);
    const int left = std::max(tile.x, picture.x),
              right = std::min(tile.x + kTileSide, picture.x + picture.width);
    const int end = std::min(tile.y + kTileSide, picture.y + picture.height);
    for (int y = std::max(tile.y, picture.y); y < end; ++y)
        for (int x = left; x < right; ++x) {
            const auto from = static_cast<std::size_t>((y - tile.y) * kTileSide + x - tile.x);
            const std::size_t to =
                static_cast<std::size_t>(y - picture.y) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(x - picture.x);
            float* rgbt = &picture.rgbt[4 * to];
            if (tile.rgba.empty()) {
                std::fill_n(rgbt, 4, frame.nothing());
            } else {
                std::copy_n(&tile.rgba[4 * from], 4, rgbt);
            }
            if (!hides) continue;
            picture.alpha[to] = rgbt[3];
            rgbt[3] = tile.rgba.empty() ? 1.0f : tile.transmittance[from];
        }
}

void setPicture(const FillFrame& frame, std::span<const FillTile> tiles, const PixelBox& box, int threads,
                CastPicture& picture)
{
    picture.x = box.x0;
    picture.y = box.y0;
    picture.width = box.empty() ? 0 : box.x1 - box.x0;
    picture.height = box.empty() ? 0 : box.y1 - box.y0;
    const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
    picture.rgbt.resize(4 * pixels);
    picture.alpha.resize(hidesBehind(frame.blending) ? pixels : 0);
    parallelFor(tiles.size(), threads, [&](std::size_t i) { copyTile(frame, tiles[i], picture); });
}

/// One call of PolygonFiller::fill.
class Filling
{
public:
    Filling(const CastRequest& request, const FramePolygons& polygons, const FillVoxels& voxels)
        : request_(request), polygons_(polygons), voxels_(voxels), frame_(frameOf(request)),
          tiles_(tilesOf(request.width, request.height)),
          bins_(tilesAlong(request.width), tilesAlong(request.height))
    {
        frame_.samplers = voxels.samplers();
        frame_.entries = voxels.entries();
        if (!request.opacityGauge) return;
        if (const auto camera = findCamera(request.model, request.projection))
            sights_ = sightsOf(request, *camera);
    }

    void fill(CastPicture& picture)
    {
        std::vector<Chunk> chunks = chunksOf(polygons_);
        nearestFirst_ = hidesBehind(request_.blending);
        if (nearestFirst_) std::ranges::reverse(chunks);
        for (std::size_t first = 0; first < chunks.size(); first += kChunksAtOnce)
            fillChunks(std::span(chunks).subspan(first, std::min(kChunksAtOnce, chunks.size() - first)));
        setPicture(frame_, tiles_, box_, request_.threads, picture);
    }

private:
    void fillChunks(std::span<const Chunk> chunks)
    {
        lists_.resize(std::max(lists_.size(), chunks.size()));
        bins_.start(chunks.size());
        parallelFor(chunks.size(), request_.threads, [&](std::size_t i) {
            prepare(chunks[i], lists_[i]);
            bins_.count(i, lists_[i]);
        });
        bins_.allot();
        parallelFor(chunks.size(), request_.threads,
                    [&](std::size_t i) { bins_.enter(i, lists_[i], nearestFirst_); });
        for (std::size_t i = 0; i < chunks.size(); ++i)
            for (const FillPolygon& polygon : lists_[i].polygons)
                box_ = united(box_, polygon.box);
        parallelFor(tiles_.size(), request_.threads, [&](std::size_t i) {
            const std::span<const PolygonRows> polygons = bins_.of(i);
            if (polygons.empty()) return;
            if (request_.opacityGauge && tiles_[i].units.empty())
                setUnits(sights_, *request_.opacityGauge, tiles_[i]);
            fillTile(frame_, polygons, tiles_[i]);
        });
    }

    void prepare(const Chunk& chunk, FillList& list) const
    {
        list.clear();
        PolygonSetup setup(request_, voxels_.bricks(), polygons_.records);
        for (std::size_t first = chunk.first; first < chunk.end;) {
            const std::size_t end = endOfPolygon(polygons_.indices, first + 3, chunk.end);
            setup.append(chunk.brick, polygons_.indices.subspan(first, end - first), list);
            first = end;
        }
    }

    const CastRequest& request_;
    const FramePolygons& polygons_;
    const FillVoxels& voxels_;
    FillFrame frame_;
    Sights sights_;
    std::vector<FillTile> tiles_;
    TileBins bins_;
    std::vector<FillList> lists_;
    PixelBox box_;
    bool nearestFirst_ = false;
};

} // namespace

std::string fillRefusal(const CastRequest& request)
{
    if (request.width < 1 || request.height < 1 || std::max(request.width, request.height) > kMostPixels)
        return "the viewport is " + std::to_string(request.width) + " x " + std::to_string(request.height) +
               " pixels, not 1 to " + std::to_string(kMostPixels);
    if (request.bricks.empty()) return "there are no voxels";
    for (const CastBrick& brick : request.bricks)
        if (brick.texels.voxels.size() / voxelBytes(brick.texels.format) < brick.texels.size.count())
            return "a brick has no voxels in memory";
    for (const CastBrick& brick : request.bricks)
        for (int axis = 0; axis < 3; ++axis)
            if (brick.texels.size[axis] > kMostVoxels)
                return "a brick is " + std::to_string(brick.texels.size[axis]) + " voxels long, more than " +
                       std::to_string(kMostVoxels);
    if (!findCamera(request.model, request.projection)) return "the matrices are singular";
    return "";
}

struct PolygonFiller::Private
{
    FillVoxels voxels;
};

PolygonFiller::PolygonFiller() : d(std::make_unique<Private>()) {}
PolygonFiller::~PolygonFiller() = default;

void PolygonFiller::fill(const CastRequest& request, const FramePolygons& polygons, CastPicture& picture)
{
    assert(fillRefusal(request).empty());
    d->voxels.startFrame(request);
    Filling(request, polygons, d->voxels).fill(picture);
}

void PolygonFiller::forget(std::uint64_t brickId)
{
    d->voxels.forget(brickId);
}

std::size_t PolygonFiller::bytes() const
{
    return d->voxels.bytes();
}

} // namespace vo
