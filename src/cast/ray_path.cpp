#include "cast/ray_path.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace vo {

namespace {

/// A ray with more samples than this is left out: such spacings are mistakes.
constexpr double kMostPlanes = 1 << 24;

/// The part of a ray with all three numbers from 0 to 1.
void cutToUnitCube(const DepthRay& place, RayPart& depths)
{
    for (int axis = 0; axis < 3; ++axis) {
        depths.cut(place.origin[axis], place.direction[axis]);
        depths.cut(1.0 - place.origin[axis], -place.direction[axis]);
    }
}

} // namespace

bool RayPath::begin(const DepthRay& ray, RayPart depths, std::span<const TetraSpan> spans)
{
    pieces_.clear();
    lastPlane_.reset();
    idle_.reset();
    leaptPlanes_ = 0;
    for (const glm::dvec4& plane : volume_.eyePlanes)
        depths.cut(glm::dot(glm::dvec3(plane), ray.origin) + plane.w,
                   glm::dot(glm::dvec3(plane), ray.direction));
    local_ = transformed(volume_.localFromEye, ray);
    if (!volume_.tetras) {
        const glm::dvec3 size(volume_.styled->dimensions);
        const auto placeOf = [&size](const DepthRay& local) {
            return DepthRay{local.origin / size + 0.5, local.direction / size};
        };
        cutToUnitCube(placeOf(transformed(volume_.edgesFromEye, ray)), depths);
        addPiece(depths, placeOf(local_), -1);
    }
    for (const TetraSpan& span : spans) {
        const RayPart part{std::max(depths.begin, span.depths.begin), std::min(depths.end, span.depths.end)};
        addPiece(part, transformed(volume_.tetras->placeFromLocal(span.tetra), local_),
                 static_cast<int>(span.tetra));
    }
    piece_ = 0;
    toPlanes();
    return piece_ < pieces_.size();
}

/// Goes on to the next piece that has planes.
void RayPath::toPlanes()
{
    leapt_ = false;
    while (piece_ < pieces_.size() && pieces_[piece_].first > pieces_[piece_].last)
        ++piece_;
    if (piece_ < pieces_.size()) plane_ = pieces_[piece_].first;
}

/// A plane at which one piece ends and the next begins belongs to the first. Pieces between two planes may
/// have surfaces.
void RayPath::addPiece(RayPart depths, const DepthRay& place, int tetra)
{
    if (depths.empty()) return;
    const double first = std::ceil(depths.begin / volume_.styled->spacing - 0.5);
    const double last = std::floor(depths.end / volume_.styled->spacing - 0.5);
    if (!(last - first <= kMostPlanes) || !(std::abs(first) <= 1e15)) return;
    Piece piece{depths, static_cast<std::int64_t>(first), static_cast<std::int64_t>(last), place, tetra};
    if (lastPlane_) piece.first = std::max(piece.first, *lastPlane_ + 1);
    if (piece.first <= piece.last) lastPlane_ = piece.last;
    pieces_.push_back(piece);
}

bool RayPath::next(SampleChunk& chunk)
{
    std::int64_t most = kChunkSize, over = 0;
    if (volume_.leapsByValue) {
        if (idle_) leap();
    } else if (!volume_.blocks.empty()) {
        // Surfaces lie between two samples: the first and the last that are clear are looked at.
        if (volume_.styled->surfaces) {
            over = leapt_ ? 0 : clearPlanes() - 2;
            if (over > 0) most = 1;
        } else {
            leap();
        }
        leapt_ = over > 0;
    }
    if (piece_ == pieces_.size()) return false;
    const Piece& piece = pieces_[piece_];
    chunk.count = static_cast<int>(std::min(most, piece.last - plane_ + 1));
    chunk.plane = plane_;
    chunk.piece = piece_;
    const glm::dvec3 start = piece.place.at(depthOf(plane_));
    for (int axis = 0; axis < 3; ++axis) {
        const auto from = static_cast<float>(start[axis]);
        const auto step = static_cast<float>(piece.place.direction[axis] * volume_.styled->spacing);
        for (std::size_t i = 0; i < kChunkSize; ++i)
            chunk.place[static_cast<std::size_t>(axis)][i] = from + static_cast<float>(i) * step;
    }
    volume_.read(chunk.count, chunk.place, chunk.voxel);
    plane_ += chunk.count + std::max<std::int64_t>(over, 0);
    finishPiece();
    return true;
}

void RayPath::finishPiece()
{
    if (plane_ <= pieces_[piece_].last) return;
    ++piece_;
    toPlanes();
}

/// Goes to the next plane that does not lie in a clear block.
void RayPath::leap()
{
    while (piece_ < pieces_.size()) {
        const std::int64_t clear = clearPlanes();
        if (clear == 0) return;
        plane_ += clear;
        leaptPlanes_ += clear;
        finishPiece();
    }
}

int RayPath::samplesToLeap(const glm::vec3& cell, const glm::vec3& step) const
{
    const int clear = volume_.blocks.empty() ? 0 : volume_.blocks.leap(cell, step);
    if (clear > 0 || !idle_) return clear;
    const auto& [low, high] = volume_.voxels->blocks().ranges[blockAt(volume_.voxels->blocks().count, cell)];
    return low >= idle_->low && high <= idle_->high ? samplesInBlocks(cell, step, 1) : 0;
}

/// How many planes from the next one on lie in clear blocks at least.
std::int64_t RayPath::clearPlanes() const
{
    if (piece_ == pieces_.size()) return 0;
    const DepthRay& place = pieces_[piece_].place;
    const VoxelSize& size = volume_.voxels->size();
    const glm::vec3 cell = volume_.voxels->cellOf(glm::vec3(place.at(depthOf(plane_))));
    const glm::vec3 step(place.direction * volume_.styled->spacing * glm::dvec3(size.x, size.y, size.z));
    return std::min<std::int64_t>(samplesToLeap(cell, step), pieces_[piece_].last - plane_ + 1);
}

const RayPath::Piece* RayPath::pieceAt(double depth) const
{
    const auto found = std::find_if(pieces_.begin(), pieces_.end(), [&](const Piece& piece) {
        return depth >= piece.depths.begin && depth <= piece.depths.end;
    });
    return found == pieces_.end() ? nullptr : &*found;
}

double RayPath::unitsOfSample() const
{
    return glm::length(local_.direction) * volume_.styled->spacing / volume_.styled->unitLength;
}

} // namespace vo
