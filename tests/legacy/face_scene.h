#pragma once

// What the guide's programs set up, for tests of the face: a cube of tetrahedra, matrices, face sets.

#include <vo/Volumizer.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace vo::test {

/// An OpenGL matrix, column by column.
struct Matrix
{
    GLdouble m[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    operator GLdouble*() { return m; }

    friend Matrix operator*(const Matrix& a, const Matrix& b)
    {
        Matrix product;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row) {
                double sum = 0;
                for (int i = 0; i < 4; ++i)
                    sum += a.m[4 * i + row] * b.m[4 * column + i];
                product.m[4 * column + row] = sum;
            }
        return product;
    }
};

inline Matrix translation(double x, double y, double z)
{
    Matrix t;
    t.m[12] = x;
    t.m[13] = y;
    t.m[14] = z;
    return t;
}

/// Turns about the axis (x, y, z), as glRotated.
inline Matrix rotation(double degrees, double x, double y, double z)
{
    const double length = std::sqrt(x * x + y * y + z * z);
    const double a[3] = {x / length, y / length, z / length};
    const double c = std::cos(degrees * M_PI / 180), s = std::sin(degrees * M_PI / 180);
    Matrix r;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            double value = a[row] * a[column] * (1 - c) + (row == column ? c : 0);
            if ((row + 1) % 3 == column) value -= a[(row + 2) % 3] * s;
            if ((column + 1) % 3 == row) value += a[(column + 2) % 3] * s;
            r.m[4 * column + row] = value;
        }
    return r;
}

/// Turns the direction (1, 1, 1) towards the viewer.
inline Matrix diagonalView()
{
    return rotation(std::acos(1 / std::sqrt(3.0)) * 180 / M_PI, 1, -1, 0);
}

inline Matrix ortho(double halfSize, double nearest, double farthest)
{
    Matrix o;
    o.m[0] = o.m[5] = 1 / halfSize;
    o.m[10] = -2 / (farthest - nearest);
    o.m[14] = -(farthest + nearest) / (farthest - nearest);
    return o;
}

inline Matrix frustum(double halfSize, double nearest, double farthest)
{
    Matrix f;
    f.m[0] = f.m[5] = nearest / halfSize;
    f.m[10] = -(farthest + nearest) / (farthest - nearest);
    f.m[11] = -1;
    f.m[14] = -2 * farthest * nearest / (farthest - nearest);
    f.m[15] = 0;
    return f;
}

/// Corners [0, size]^3 and the guide's five tetrahedra (page 76).
struct CubeArrays
{
    explicit CubeArrays(float size)
    {
        for (int i = 0; i < 8; ++i) {
            vertices[i][0] = i % 4 == 1 || i % 4 == 2 ? size : 0;
            vertices[i][1] = i % 4 >= 2 ? size : 0;
            vertices[i][2] = i >= 4 ? size : 0;
        }
    }
    float vertices[8][3];
    int indices[20] = {0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7};
};

/// Face sets [bricks][samples] that share one array of vertices and begin without room for indices, as legacy
/// programs make them; behind the last sample and the last brick stand pointers that nobody may follow.
class FaceSets
{
public:
    FaceSets(int bricks, int samples, int valuesPerVertex = 3, int vertices = 100000)
        : bricks_(bricks), samples_(samples), shared_(vertices, valuesPerVertex)
    {
        for (int b = 0; b < bricks; ++b) {
            rows_.emplace_back();
            for (int s = 0; s < samples; ++s) {
                owned_.push_back(std::make_unique<voIndexedFaceSet>(&shared_, 0));
                rows_.back().push_back(owned_.back().get());
            }
            rows_.back().push_back(reinterpret_cast<voIndexedFaceSet*>(1));
        }
        for (auto& row : rows_)
            pointers_.push_back(row.data());
        pointers_.push_back(reinterpret_cast<voIndexedFaceSet**>(1));
    }

    operator voIndexedFaceSet***() { return pointers_.data(); }
    voIndexedFaceSet& at(int brick, int sample) { return *rows_[std::size_t(brick)][std::size_t(sample)]; }
    voVertexData& vertices() { return shared_; }
    int bricks() const { return bricks_; }
    int samples() const { return samples_; }

    /// All indices, face set after face set, each after its count; then all records in use.
    std::vector<float> contents()
    {
        std::vector<float> all;
        for (int b = 0; b < bricks_; ++b)
            for (int s = 0; s < samples_; ++s) {
                const voIndices& indices = *at(b, s).getIndices();
                all.push_back(float(indices.getCount()));
                all.insert(all.end(), indices.getDataPtr(), indices.getDataPtr() + indices.getCount());
            }
        const float* data = shared_.getDataPtr();
        all.insert(all.end(), data, data + shared_.getCount() * shared_.getValuesPerVertex());
        return all;
    }

private:
    int bricks_, samples_;
    voVertexData shared_;
    std::vector<std::unique_ptr<voIndexedFaceSet>> owned_;
    std::vector<std::vector<voIndexedFaceSet*>> rows_;
    std::vector<voIndexedFaceSet**> pointers_;
};

/// The records of a face set's polygons, one list of positions a polygon.
inline std::vector<std::vector<std::array<float, 3>>> polygonsOf(voIndexedFaceSet& faces)
{
    std::vector<std::vector<std::array<float, 3>>> polygons;
    const int values = faces.getVertexData()->getValuesPerVertex();
    for (voIndexedFaceSetIterator next(&faces); !next.doneP(); next.nextPrimitive()) {
        polygons.emplace_back();
        while (const float* record = next.nextVertex())
            polygons.back().push_back({record[values - 3], record[values - 2], record[values - 1]});
    }
    return polygons;
}

/// A volume of size^3 bytes in bricks of brickSize^3.
inline std::unique_ptr<voBrickSetCollection>
byteVolume(int size, int brickSize, voInterpolationType type = voInterpolationTypeScope::_3D, int overlap = 1,
           voPartialBrickType partial = voPartialBrickTypeScope::AUGMENT)
{
    return std::make_unique<voBrickSetCollection>(size, size, size, brickSize, brickSize, brickSize, partial,
                                                  overlap, voInternalFormatTypeScope::INTENSITY8_EXT,
                                                  voExternalFormatTypeScope::LUMINANCE,
                                                  voDataTypeScope::UNSIGNED_BYTE, type);
}

} // namespace vo::test
