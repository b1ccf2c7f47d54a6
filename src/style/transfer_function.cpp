#include "style/transfer_function.h"

#include "style/glsl_chain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vo {

namespace {

const char* const kGlsl = R"(
vec3 functionPlace(vec3 value, vec3 halfTexel) { return clamp(value, halfTexel, 1.0 - halfTexel); }
)";

/// The first row of a texture; components that it lacks are 0.
std::vector<glm::vec4> firstRow(const VoxelTexture& texture)
{
    const auto size = static_cast<std::size_t>(texture.size.x);
    std::vector<glm::vec4> row(size);
    BatchVectors place{};
    std::array<BatchFloats, 4> texels{};
    for (std::size_t axis = 1; axis < 3; ++axis)
        place[axis].fill(0.5f / static_cast<float>(texture.size[static_cast<int>(axis)]));
    for (std::size_t first = 0; first < size; first += kBatchSize) {
        const std::size_t count = std::min<std::size_t>(kBatchSize, size - first);
        for (std::size_t i = 0; i < count; ++i)
            place[0][i] = (static_cast<float>(first + i) + 0.5f) / static_cast<float>(size);
        sampleTexture(texture, static_cast<int>(count), place, texels);
        for (std::size_t i = 0; i < count; ++i)
            row[first + i] = {texels[0][i], texels[1][i], texels[2][i], texels[3][i]};
    }
    return row;
}

} // namespace

TransferFunction::TransferFunction(std::shared_ptr<const VoxelTexture> texture, int axes)
    : texture_(std::move(texture)), axes_(axes)
{
    if (texture_ && (axes == 1 || (texture_->size.y == 1 && texture_->size.z == 1)))
        row_ = firstRow(*texture_);
}

bool TransferFunction::isClear(float low, float high) const
{
    if (row_.empty() || components() % 2 != 0) return false; // odd: opaque
    const auto size = static_cast<float>(row_.size());
    // One texel more on each side than values between them read.
    const auto first = static_cast<std::size_t>(std::clamp(std::floor(low * size - 1.5f), 0.0f, size - 1.0f));
    const auto last = static_cast<std::size_t>(std::clamp(std::ceil(high * size + 0.5f), 0.0f, size - 1.0f));
    const int alpha = components() - 1;
    for (std::size_t i = first; i <= last; ++i)
        if (!(row_[i][alpha] <= 0.0f)) return false;
    return true;
}

void TransferFunction::sample(int count, BatchVectors& place, std::array<BatchFloats, 4>& texels) const
{
    if (!row_.empty()) {
        sampleRow(count, place[0], texels);
        return;
    }
    for (int axis = 0; axis < 3; ++axis) {
        const float half = halfTexel(axis);
        for (float& coordinate : place[static_cast<std::size_t>(axis)])
            coordinate = std::clamp(coordinate, half, 1.0f - half);
    }
    sampleTexture(*texture_, count, place, texels);
}

void TransferFunction::sampleRow(int count, const BatchFloats& values,
                                 std::array<BatchFloats, 4>& texels) const
{
    const auto size = static_cast<float>(row_.size());
    const float before = texture_->nearest ? 0.0f : 0.5f;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const float at = values[i] * size - before;
        const float inside = at > 0.0f ? std::min(at, size - 1.0f) : 0.0f;
        const auto low = static_cast<std::size_t>(inside);
        const std::size_t high = std::min(low + 1, row_.size() - 1);
        const float weight = texture_->nearest ? 0.0f : inside - static_cast<float>(low);
        const glm::vec4 texel = row_[low] + (row_[high] - row_[low]) * weight;
        for (std::size_t c = 0; c < 4; ++c)
            texels[c][i] = texel[static_cast<int>(c)];
    }
}

std::string TransferFunction::write(GlslChain& chain, const std::string& place) const
{
    if (TableStack* const tables = chain.tableStack().get())
        return tables->write(chain, texture_, row_.empty() ? axes_ : 1, place);
    chain.function("functionPlace", kGlsl);
    const std::string half = chain.uniform(glm::vec3(halfTexel(0), halfTexel(1), halfTexel(2)));
    return "styleTexture(" + chain.texture(texture_) + ", functionPlace(" + place + ", " + half + "))";
}

} // namespace vo
