#include "vout/transform_mesh.h"

#include "legacy/report.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <string>

namespace vo {

namespace {

using Format = voInterleavedArrayTypeScope;

int colorChannels(voInterleavedArrayType format)
{
    switch (format) {
    case Format::C3F_V3F:
    case Format::T3F_C3F_V3F: return 3;
    case Format::C4F_V3F:
    case Format::T3F_C4F_V3F: return 4;
    default: return 0;
    }
}

void requireFormat(const TetraMesh& mesh, voInterleavedArrayType format)
{
    if (format < Format::DEFAULT || format > Format::USER_V3F)
        badEnum("voInterleavedArrayType has no value " + std::to_string(format));
    if (format == Format::USER_V3F) badValue("USER_V3F does not say what its records hold");
    const int values = format == Format::DEFAULT ? 3 : getValuesPerVertex(format);
    if (values != mesh.values)
        badValue("the vertex format has " + std::to_string(values) + " values a record, the set " +
                 std::to_string(mesh.values));
}

} // namespace

glm::dmat4 affineMatrix(const double* columns)
{
    for (int i = 0; i < 16; ++i)
        if (!std::isfinite(columns[i])) badValue("the matrix is not finite");
    const glm::dmat4 matrix = glm::make_mat4(columns);
    for (int column = 0; column < 4; ++column)
        if (matrix[column][3] != (column == 3 ? 1.0 : 0.0)) badValue("the last row of the matrix is not 0 0 0 1");
    const double volume = glm::determinant(glm::dmat3(matrix));
    if (volume == 0 || !std::isfinite(volume)) badValue("the matrix is singular");
    return matrix;
}

voInterleavedArrayType placedFormat(voInterleavedArrayType format, bool hasColor)
{
    if (hasColor) return Format::T3F_C4F_V3F;
    const int channels = colorChannels(format);
    return channels == 0 ? Format::T3F_V3F : channels == 3 ? Format::T3F_C3F_V3F : Format::T3F_C4F_V3F;
}

TetraMesh placed(const TetraMesh& mesh, voInterleavedArrayType format, const glm::dmat4& matrix,
                 const std::optional<glm::vec4>& color)
{
    requireFormat(mesh, format);
    const int channels = colorChannels(format);
    const int voxelColumn = format != Format::DEFAULT && hasTextureComponent(format) ? 0 : mesh.values - 3;
    TetraMesh result;
    result.values = getValuesPerVertex(placedFormat(format, color.has_value()));
    result.tetras = mesh.tetras;
    result.records.reserve(mesh.vertexCount() * static_cast<std::size_t>(result.values));
    for (int vertex = 0; vertex < static_cast<int>(mesh.vertexCount()); ++vertex) {
        const float* record = mesh.record(vertex);
        result.records.insert(result.records.end(), record + voxelColumn, record + voxelColumn + 3);
        const float* own = record + mesh.values - 3 - channels;
        for (int channel = 0; channel < (color ? 4 : channels); ++channel) {
            const float value = channel < channels ? own[channel] : 1.0f;
            result.records.push_back(color ? value * (*color)[channel] : value);
        }
        const glm::dvec3 position(matrix * glm::dvec4(mesh.position(vertex), 1));
        for (int axis = 0; axis < 3; ++axis)
            result.records.push_back(static_cast<float>(position[axis]));
    }
    return result;
}

} // namespace vo
