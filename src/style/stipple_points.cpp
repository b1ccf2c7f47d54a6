#include "style/stipple_points.h"

#include "core/invertible.h"
#include "core/parallel.h"
#include "style/power.h"
#include "style/shine.h"
#include "style/styled_voxels.h"
#include "style/surface_normals.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace vo {

namespace {

/// A number that looks like chance; every bit depends on every bit of the key.
std::uint64_t scrambled(std::uint64_t key)
{
    key += 0x9e3779b97f4a7c15u;
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
    key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
    return key ^ (key >> 31);
}

/// 21 of its bits as a number from 0 to below 1.
float fraction(std::uint64_t bits)
{
    return static_cast<float>(bits & 0x1fffff) / static_cast<float>(0x200000);
}

/// How many points voxels have.
class Stippling
{
public:
    Stippling(const StyledScene& scene, const StyledVolume& volume);

    /// Sets N of samples that have voxel and place; drops those that have none. Leaves the colour in Cv, N in
    /// Ov. `index` goes along.
    void numberOf(SampleBatch& batch, std::array<std::uint64_t, kBatchSize>& index) const;
    /// A local position within the clip planes.
    bool isKept(const glm::vec3& position) const;

private:
    void findDepths();
    void placeSamples(SampleBatch& batch) const;
    void dropClear(SampleBatch& batch, std::array<std::uint64_t, kBatchSize>& index) const;
    void findLighting(const SampleBatch& batch, const BatchVectors& n, BatchFloats& lighting) const;
    float factorsOf(const SampleBatch& batch, std::size_t i, const glm::vec3& n) const;

    const StyledVolume& volume_;
    const StippleFactors& factors_;
    StyleChain chain_;
    SurfaceNormals normals_;
    bool keepsClear_ = true, perspective_ = false;
    glm::dmat4 eyeFromLocal_{1.0};
    glm::vec3 eye_{0.0f}, backwards_{0.0f};
    float nearest_ = 0.0f, farthest_ = 0.0f, resolution_ = 1.0f;
};

Stippling::Stippling(const StyledScene& scene, const StyledVolume& volume)
    : volume_(volume), factors_(*volume.stipple), chain_(effectiveChain(volume.chains[0])),
      normals_(volume.stipple->surfaceNormals), perspective_(scene.clipFromEye[2][3] != 0.0),
      eyeFromLocal_(scene.eyeFromWorld * volume.worldFromLocal)
{
    const glm::dmat4 localFromEye = glm::inverse(eyeFromLocal_);
    eye_ = glm::vec3(localFromEye[3]);
    backwards_ = glm::vec3(glm::normalize(glm::dvec3(localFromEye[2])));
    keepsClear_ =
        std::all_of(chain_.begin(), chain_.end(), [](const auto& style) { return style->keepsClear(); }) &&
        (chain_.empty() || !chain_.front()->replacesColor());
    findDepths();
}

void Stippling::findDepths()
{
    const auto depthOf = [&](const glm::dvec3& position) {
        return static_cast<float>(-(eyeFromLocal_ * glm::dvec4(position, 1.0)).z);
    };
    nearest_ = std::numeric_limits<float>::infinity();
    farthest_ = -nearest_;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
        const float depth = depthOf(sign * glm::dvec3(volume_.dimensions));
        nearest_ = std::min(nearest_, depth);
        farthest_ = std::max(farthest_, depth);
    }
    if (factors_.originalDistance > 0.0f)
        resolution_ = raised(depthOf({0.0, 0.0, 0.0}) / factors_.originalDistance, factors_.resolutionFactor);
}

bool Stippling::isKept(const glm::vec3& position) const
{
    const glm::dvec4 world = volume_.worldFromLocal * glm::dvec4(position, 1.0);
    return std::all_of(volume_.clipPlanes.begin(), volume_.clipPlanes.end(),
                       [&](const glm::dvec4& plane) { return glm::dot(plane, world) >= 0.0; });
}

void Stippling::placeSamples(SampleBatch& batch) const
{
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        const glm::vec3 place(batch.place[0][i], batch.place[1][i], batch.place[2][i]);
        const glm::vec3 position = (place - 0.5f) * volume_.dimensions;
        const glm::vec3 view = perspective_ ? glm::normalize(eye_ - position) : backwards_;
        for (int axis = 0; axis < 3; ++axis) {
            batch.position[static_cast<std::size_t>(axis)][i] = position[axis];
            batch.V[static_cast<std::size_t>(axis)][i] = view[axis];
        }
    }
}

void Stippling::dropClear(SampleBatch& batch, std::array<std::uint64_t, kBatchSize>& index) const
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        if (!(batch.Ov[i] > 0.0f)) continue;
        for (BatchFloats& component : batch.voxel)
            component[kept] = component[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            batch.place[axis][kept] = batch.place[axis][i];
            batch.Cv[axis][kept] = batch.Cv[axis][i];
        }
        batch.Ov[kept] = batch.Ov[i];
        index[kept++] = index[i];
    }
    batch.count = static_cast<int>(kept);
}

void Stippling::findLighting(const SampleBatch& batch, const BatchVectors& n, BatchFloats& lighting) const
{
    lighting.fill(1.0f);
    for (const StyleLight& light : volume_.surroundings.lights) {
        BatchVectors L;
        BatchFloats nL;
        directionsTo(light, batch, L);
        facing(n, L, nL);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            if (nL[i] > 0.0f) lighting[i] *= 1.0f - raised(std::min(nL[i], 1.0f), factors_.lightingFactor);
    }
}

/// N / kStippleMost, but Tl.
float Stippling::factorsOf(const SampleBatch& batch, std::size_t i, const glm::vec3& n) const
{
    const StippleFactors& k = factors_;
    const glm::vec3 position(batch.position[0][i], batch.position[1][i], batch.position[2][i]);
    const glm::vec3 V(batch.V[0][i], batch.V[1][i], batch.V[2][i]);
    const float facing = std::min(std::abs(glm::dot(n, V)), 1.0f);
    const bool turned = n != glm::vec3(0.0f) && std::acos(facing) >= k.gradientThreshold;
    const float Cv = std::min(batch.Ov[i], 1.0f);
    const float boundary =
        turned ? k.gradientBoundaryOpacity * raised(batch.gradient[i], k.gradientOpacityFactor) : 0.0f;
    const float silhouette =
        n != glm::vec3(0.0f) ? k.silhouetteBoundaryOpacity * raised(1.0f - facing, k.silhouetteOpacityFactor)
                             : 0.0f;
    const double depth = -(eyeFromLocal_ * glm::dvec4(position, 1.0)).z;
    const float range = farthest_ - nearest_;
    const float z =
        range > 0.0f ? std::clamp((farthest_ - static_cast<float>(depth)) / range, 0.0f, 1.0f) : 0.0f;
    const float Tb = Cv * (k.gradientRetainedOpacity + boundary);
    const float Ts = Cv * (k.silhouetteRetainedOpacity + silhouette);
    const float Td = 1.0f + raised(z, k.distanceFactor);
    const float Ti = raised(batch.gradient[i], k.interiorFactor);
    return Tb * Ts * Td * resolution_ * Ti;
}

void Stippling::numberOf(SampleBatch& batch, std::array<std::uint64_t, kBatchSize>& index) const
{
    firstColor(volume_.voxels->components, batch);
    if (keepsClear_) dropClear(batch, index);
    if (batch.count == 0) return;
    placeSamples(batch);
    findNormals(*volume_.voxels, volume_.dimensions, batch);
    for (const auto& style : chain_)
        style->apply(volume_.surroundings, batch);
    BatchVectors room;
    const BatchVectors& n = normals_.of(batch, room);
    BatchFloats lighting;
    findLighting(batch, n, lighting);
    for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i) {
        const float N = kStippleMost * lighting[i] * factorsOf(batch, i, {n[0][i], n[1][i], n[2][i]});
        batch.Ov[i] = N > 0.0f ? std::min(N, 4.0f * kStippleMost) : 0.0f;
    }
}

/// Points before their places are known: all of a voxel's.
struct VoxelPoints
{
    std::uint64_t voxel;
    float N;
    glm::vec3 color;
};

std::vector<VoxelPoints> sliceOf(const StyledVolume& volume, const Stippling& stippling, int z)
{
    const VoxelSize& size = volume.voxels->size;
    std::vector<VoxelPoints> points;
    SampleBatch batch{};
    std::array<std::uint64_t, kBatchSize> index{};
    const auto inSlice = static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y);
    for (std::uint64_t first = 0; first < inSlice; first += kBatchSize) {
        batch.count = static_cast<int>(std::min<std::uint64_t>(kBatchSize, inSlice - first));
        for (std::size_t to = 0; to < static_cast<std::size_t>(batch.count); ++to) {
            const auto x = static_cast<int>((first + to) % static_cast<std::uint64_t>(size.x));
            const auto y = static_cast<int>((first + to) / static_cast<std::uint64_t>(size.x));
            batch.place[0][to] = (static_cast<float>(x) + 0.5f) / static_cast<float>(size.x);
            batch.place[1][to] = (static_cast<float>(y) + 0.5f) / static_cast<float>(size.y);
            batch.place[2][to] = (static_cast<float>(z) + 0.5f) / static_cast<float>(size.z);
            index[to] = static_cast<std::uint64_t>(z) * inSlice + first + to;
        }
        sampleTexture(*volume.voxels, batch.count, batch.place, batch.voxel);
        stippling.numberOf(batch, index);
        for (std::size_t i = 0; i < static_cast<std::size_t>(batch.count); ++i)
            if (batch.Ov[i] > 0.0f)
                points.push_back({index[i], batch.Ov[i], {batch.Cv[0][i], batch.Cv[1][i], batch.Cv[2][i]}});
    }
    return points;
}

/// The first points of a voxel that has N of them on average among its like.
void spread(const VoxelPoints& voxel, float N, const StyledVolume& volume, const Stippling& stippling,
            std::vector<StipplePoint>& points)
{
    const VoxelSize& size = volume.voxels->size;
    const auto across = static_cast<std::uint64_t>(size.x), up = static_cast<std::uint64_t>(size.y);
    const glm::vec3 lower(voxel.voxel % across, voxel.voxel / across % up, voxel.voxel / across / up);
    const std::uint64_t key = scrambled(voxel.voxel);
    for (std::uint64_t number = 0; static_cast<float>(number) + fraction(key) < N; ++number) {
        const std::uint64_t bits = scrambled(key + number + 1);
        const glm::vec3 within(fraction(bits), fraction(bits >> 21), fraction(bits >> 42));
        const glm::vec3 place = (lower + within) / glm::vec3(size.x, size.y, size.z);
        const StipplePoint point{(place - 0.5f) * volume.dimensions, voxel.color};
        if (stippling.isKept(point.position)) points.push_back(point);
    }
}

} // namespace

std::vector<StipplePoint> stipplePoints(const StyledScene& scene, const StyledVolume& volume, int threads)
{
    if (!volume.stipple || !isSound(volume) || !isInvertible(scene.eyeFromWorld)) return {};
    const Stippling stippling(scene, volume);
    std::vector<std::vector<VoxelPoints>> slices(static_cast<std::size_t>(volume.voxels->size.z));
    parallelFor(slices.size(), threads,
                [&](std::size_t z) { slices[z] = sliceOf(volume, stippling, static_cast<int>(z)); });
    double total = 0.0;
    for (const auto& slice : slices)
        for (const VoxelPoints& voxel : slice)
            total += static_cast<double>(voxel.N);
    const auto most = static_cast<double>(kStipplePoints);
    const auto part = static_cast<float>(total > most ? most / total : 1.0);
    std::vector<StipplePoint> points;
    for (const auto& slice : slices)
        for (const VoxelPoints& voxel : slice)
            spread(voxel, voxel.N * part, volume, stippling, points);
    return points;
}

} // namespace vo
