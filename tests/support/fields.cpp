#include "support/fields.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <random>

namespace vo::test {

namespace {

Field blank(const VoxelSize& size, int channels)
{
    Field field;
    field.size = size;
    field.channels = channels;
    field.values.resize(static_cast<std::size_t>(size.count()) * static_cast<std::size_t>(channels));
    return field;
}

glm::dvec3 extentOf(const VoxelSize& size)
{
    return {size.x, size.y, size.z};
}

int smallestSide(const VoxelSize& size)
{
    return std::min({size.x, size.y, size.z});
}

double roundedTo(float value, int levels)
{
    return std::floor(std::clamp(static_cast<double>(value), 0.0, 1.0) * levels + 0.5);
}

/// An F that stands upright where u grows to the right and v upwards, both over 0 to 1.
bool inLetterF(double u, double v)
{
    const bool stem = u >= 0.2 && u < 0.35 && v >= 0.15 && v < 0.85;
    const bool upperBar = u >= 0.2 && u < 0.8 && v >= 0.7 && v < 0.85;
    const bool lowerBar = u >= 0.2 && u < 0.6 && v >= 0.42 && v < 0.55;
    return stem || upperBar || lowerBar;
}

} // namespace

std::size_t Field::index(int x, int y, int z) const
{
    assert(x >= 0 && x < size.x && y >= 0 && y < size.y && z >= 0 && z < size.z);
    const auto row =
        static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(y);
    return (row * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
}

float& Field::at(int x, int y, int z, int channel)
{
    return values[index(x, y, z) + static_cast<std::size_t>(channel)];
}

float Field::at(int x, int y, int z, int channel) const
{
    return values[index(x, y, z) + static_cast<std::size_t>(channel)];
}

Field fieldOf(const VoxelSize& size, const std::function<double(const glm::dvec3& centre)>& function)
{
    Field field = blank(size, 1);
    std::size_t i = 0;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                field.values[i++] = static_cast<float>(function({x + 0.5, y + 0.5, z + 0.5}));
    return field;
}

Field constantField(const VoxelSize& size, double value)
{
    Field field = blank(size, 1);
    std::fill(field.values.begin(), field.values.end(), static_cast<float>(value));
    return field;
}

Field rampField(const VoxelSize& size, const glm::dvec3& gradient, double value)
{
    return fieldOf(size, [&](const glm::dvec3& p) {
        return value + gradient.x * p.x + gradient.y * p.y + gradient.z * p.z;
    });
}

Field axisRampField(const VoxelSize& size, int axis)
{
    const double steps = std::max(1, size[axis] - 1);
    return fieldOf(size, [&](const glm::dvec3& p) { return (p[axis] - 0.5) / steps; });
}

Field ballField(const VoxelSize& size, double radius)
{
    const glm::dvec3 centre = 0.5 * extentOf(size);
    const double reach = 0.5 * smallestSide(size) * radius;
    return fieldOf(size, [&](const glm::dvec3& p) {
        const glm::dvec3 q = p - centre;
        const double inward = std::max(0.0, 1.0 - std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z) / reach);
        return inward * inward * (3.0 - 2.0 * inward);
    });
}

Field cubesField(const VoxelSize& size, int period)
{
    const glm::dvec3 centre = 0.5 * extentOf(size);
    return fieldOf(size, [&](const glm::dvec3& p) {
        double farthest = 0.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double inCell = std::fmod(p[axis], period) / period;
            if (inCell < 0.25 || inCell >= 0.75) return 0.0;
            const double cellCentre = (std::floor(p[axis] / period) + 0.5) * period;
            farthest = std::max(farthest, std::abs(cellCentre - centre[axis]) / centre[axis]);
        }
        return 1.0 - 0.8 * std::min(1.0, farthest);
    });
}

Field noiseField(const VoxelSize& size, unsigned seed)
{
    std::mt19937 random(seed);
    Field field = blank(size, 1);
    // Not a standard distribution: those differ between libraries.
    for (float& value : field.values)
        value = static_cast<float>(random() >> 8) / 16777215.0f;
    return field;
}

Field letterFField(const VoxelSize& size)
{
    const double depth = std::max(1.0, smallestSide(size) / 8.0);
    const glm::dvec3 extent = extentOf(size);
    return fieldOf(size, [&](const glm::dvec3& p) {
        const glm::dvec3 place = p / extent;
        if (p.x < depth && inLetterF(place.y, place.z)) return 1.0;
        if (p.y < depth && inLetterF(place.x, place.z)) return 2.0 / 3.0;
        if (p.z < depth && inLetterF(place.x, place.y)) return 1.0 / 3.0;
        return 0.0;
    });
}

Field combined(const std::vector<Field>& channels)
{
    assert(channels.size() == 2 || channels.size() == 4);
    Field field = blank(channels[0].size, static_cast<int>(channels.size()));
    for (std::size_t c = 0; c < channels.size(); ++c) {
        assert(channels[c].channels == 1 && channels[c].size == field.size);
        for (std::size_t i = 0; i < channels[c].values.size(); ++i)
            field.values[i * channels.size() + c] = channels[c].values[i];
    }
    return field;
}

Field withEmptyBorder(Field field, int layers)
{
    const auto nearEdge = [&](int i, int size) { return i < layers || i >= size - layers; };
    for (int z = 0; z < field.size.z; ++z)
        for (int y = 0; y < field.size.y; ++y)
            for (int x = 0; x < field.size.x; ++x)
                if (nearEdge(x, field.size.x) || nearEdge(y, field.size.y) || nearEdge(z, field.size.z))
                    std::fill_n(&field.at(x, y, z), field.channels, 0.0f);
    return field;
}

Field quantised(Field field, int levels)
{
    for (float& value : field.values)
        value = static_cast<float>(roundedTo(value, levels) / levels);
    return field;
}

std::vector<std::uint8_t> toBytes(const Field& field)
{
    std::vector<std::uint8_t> bytes;
    bytes.reserve(field.values.size());
    for (const float value : field.values)
        bytes.push_back(static_cast<std::uint8_t>(roundedTo(value, 255)));
    return bytes;
}

std::vector<std::uint16_t> toShorts(const Field& field)
{
    std::vector<std::uint16_t> shorts;
    shorts.reserve(field.values.size());
    for (const float value : field.values)
        shorts.push_back(static_cast<std::uint16_t>(roundedTo(value, 65535)));
    return shorts;
}

} // namespace vo::test
