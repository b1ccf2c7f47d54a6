#include "style/transfer_function.h"

#include "style/glsl_chain.h"

#include <algorithm>

namespace vo {

namespace {

const char* const kGlsl = R"(
vec3 functionPlace(vec3 value, vec3 halfTexel) { return clamp(value, halfTexel, 1.0 - halfTexel); }
)";

float halfTexel(const VoxelTexture& function, int axis)
{
    return 0.5f / static_cast<float>(function.size[axis]);
}

} // namespace

void sampleFunction(const VoxelTexture& function, int count, BatchVectors& place,
                    std::array<BatchFloats, 4>& texels)
{
    for (int axis = 0; axis < 3; ++axis) {
        const float half = halfTexel(function, axis);
        for (float& coordinate : place[static_cast<std::size_t>(axis)])
            coordinate = std::clamp(coordinate, half, 1.0f - half);
    }
    sampleTexture(function, count, place, texels);
}

std::string writeFunction(GlslChain& chain, const std::shared_ptr<const VoxelTexture>& function,
                          const std::string& place)
{
    chain.function("functionPlace", kGlsl);
    const std::string half =
        chain.uniform(glm::vec3(halfTexel(*function, 0), halfTexel(*function, 1), halfTexel(*function, 2)));
    return "styleTexture(" + chain.texture(function) + ", functionPlace(" + place + ", " + half + "))";
}

} // namespace vo
