#include "style/table_stack.h"

#include "style/glsl_chain.h"
#include "style/texel_list.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace vo {

namespace {

// A table is its size, and the row in which it begins. Values at the edge have the last texel.
constexpr const char* kGlsl = R"(
vec4 stackedTexel(vec4 table, vec3 at)
{
    int texel = int(at.x) + int(table.x) * (int(at.y) + int(table.y) * int(at.z));
    return texelFetch(stackedTables, listPlace(256 * int(table.w) + texel), 0);
}
vec4 inTableRow(vec4 table, float at, vec2 row)
{
    float low = floor(at), high = min(low + 1.0, table.x - 1.0);
    return mix(stackedTexel(table, vec3(low, row)), stackedTexel(table, vec3(high, row)), at - low);
}
vec4 inTableSlice(vec4 table, vec2 at, float slice)
{
    float low = floor(at.y), high = min(low + 1.0, table.y - 1.0);
    return mix(inTableRow(table, at.x, vec2(low, slice)), inTableRow(table, at.x, vec2(high, slice)), at.y - low);
}
vec3 placeInTable(vec4 table, vec3 value) { return clamp(value * table.xyz - 0.5, vec3(0.0), table.xyz - 1.0); }
vec4 inTable1(vec4 table, vec3 value) { return inTableRow(table, placeInTable(table, value).x, vec2(0.0)); }
vec4 inTable2(vec4 table, vec3 value) { return inTableSlice(table, placeInTable(table, value).xy, 0.0); }
vec4 inTable3(vec4 table, vec3 value)
{
    vec3 at = placeInTable(table, value);
    float low = floor(at.z), high = min(low + 1.0, table.z - 1.0);
    return mix(inTableSlice(table, at.xy, low), inTableSlice(table, at.xy, high), at.z - low);
}
vec4 nearestInTable(vec4 table, vec3 value)
{
    return stackedTexel(table, floor(clamp(value * table.xyz, vec3(0.0), table.xyz - 1.0)));
}
)";

/// The GLSL function for values that change along so many axes.
std::string functionFor(const VoxelTexture& table, int axes)
{
    if (table.nearest) return "nearestInTable";
    axes = std::min(axes, 3);
    while (axes > 1 && table.size[axes - 1] == 1)
        --axes;
    return "inTable" + std::to_string(axes);
}

/// Four components a texel, of numbers at least as fine as those of the table.
template <class Number>
void copyTexels(const VoxelTexture& table, std::byte* to)
{
    constexpr bool kIsWhole = std::is_integral_v<Number>;
    constexpr float kMost = kIsWhole ? static_cast<float>(std::numeric_limits<Number>::max()) : 1.0f;
    const auto components = static_cast<std::size_t>(table.components);
    for (std::size_t texel = 0; texel < table.size.count(); ++texel, to += 4 * sizeof(Number))
        for (std::size_t c = 0; c < components; ++c) {
            const float number = numberAt(table, texel * components + c) * kMost;
            const auto stored = static_cast<Number>(kIsWhole ? number + 0.5f : number);
            std::memcpy(to + c * sizeof stored, &stored, sizeof stored);
        }
}

} // namespace

const TableStack::Entry& TableStack::add(const std::shared_ptr<const VoxelTexture>& table)
{
    const auto [found, isNew] = numbers_.emplace(table->serial, tables_.size());
    if (isNew) {
        tables_.push_back({table, rows_});
        rows_ += (table->size.count() + kListRow - 1) / kListRow;
    }
    return tables_[found->second];
}

std::string TableStack::write(GlslChain& chain, const std::shared_ptr<const VoxelTexture>& table, int axes,
                              const std::string& place)
{
    const VoxelSize& size = table->size;
    const glm::vec4 uniform(size.x, size.y, size.z, static_cast<float>(add(table).firstRow));
    chain.function("stackedTables", kGlsl);
    return functionFor(*table, axes) + "(" + chain.uniform(uniform) + ", " + place + ")";
}

std::vector<std::uint64_t> TableStack::serials() const
{
    std::vector<std::uint64_t> all(tables_.size());
    std::ranges::transform(tables_, all.begin(), [](const Entry& entry) { return entry.table->serial; });
    return all;
}

VoxelSize TableStack::size() const
{
    return listSize(rows_ * kListRow);
}

VoxelTexture TableStack::texture() const
{
    VoxelTexture whole;
    whole.size = size();
    whole.components = 4;
    whole.nearest = true;
    for (const Entry& entry : tables_)
        whole.kind = std::max(whole.kind, entry.table->kind);
    const std::size_t texelBytes = 4 * bytesOf(whole.kind);
    whole.texels.resize(whole.size.count() * texelBytes);
    for (const auto& [table, firstRow] : tables_) {
        std::byte* const to = whole.texels.data() + firstRow * kListRow * texelBytes;
        switch (whole.kind) {
        case TexelKind::uint8: copyTexels<std::uint8_t>(*table, to); break;
        case TexelKind::uint16: copyTexels<std::uint16_t>(*table, to); break;
        case TexelKind::float32: copyTexels<float>(*table, to); break;
        }
    }
    return whole;
}

} // namespace vo
