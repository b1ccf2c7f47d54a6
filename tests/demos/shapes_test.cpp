// voglMorph, voglSphere and voglUnstructured against float64 samples of the same tetrahedra.
#include "run_program.h"

#include "support/compare.h"
#include "support/reference.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>

namespace {

using namespace vo::test;

constexpr int kWidth = 72, kHeight = 64;
const vo::VoxelSize kSize{24, 20, 16};
const Angles kAngles{-20, 35};
using Rgba = std::array<double, 4>;

/// A point's place in tetrahedra, found without any order.
class TetraMap
{
public:
    explicit TetraMap(const std::vector<Tetrahedron>& tetras)
    {
        for (const Tetrahedron& t : tetras)
            parts_.push_back({t[0], glm::inverse(glm::dmat3(t[1] - t[0], t[2] - t[0], t[3] - t[0]))});
    }

    struct Place
    {
        std::size_t tetra;
        std::array<double, 4> weights;
    };
    std::optional<Place> find(const glm::dvec3& point) const
    {
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const glm::dvec3 w = parts_[i].fromSpace * (point - parts_[i].origin);
            const double first = 1 - w.x - w.y - w.z;
            if (std::min({first, w.x, w.y, w.z}) >= -1e-9) return Place{i, {first, w.x, w.y, w.z}};
        }
        return {};
    }

private:
    struct Part
    {
        glm::dvec3 origin;
        glm::dmat3 fromSpace;
    };
    std::vector<Part> parts_;
};

/// Corner numbers 4 z + 2 y + x of the five tetrahedra of a cell; odd cells are mirrored in x.
std::vector<std::array<int, 4>> cellTetras(bool odd)
{
    std::vector<std::array<int, 4>> tetras{
        {0, 3, 5, 6}, {1, 0, 3, 5}, {2, 0, 3, 6}, {4, 0, 5, 6}, {7, 3, 5, 6}};
    for (auto& tetra : tetras)
        for (int& corner : tetra)
            corner ^= int(odd);
    return tetras;
}

/// Tetrahedra of an n x n x n grid of cells; place(i, j, k) is a vertex.
template <typename PlaceOf>
std::vector<Tetrahedron> gridTetras(int n, PlaceOf place)
{
    std::vector<Tetrahedron> tetras;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                for (const auto& corners : cellTetras((i + j + k) % 2)) {
                    Tetrahedron tetra;
                    for (std::size_t c = 0; c < 4; ++c)
                        tetra[c] =
                            place(i + (corners[c] & 1), j + (corners[c] >> 1 & 1), k + (corners[c] >> 2));
                    tetras.push_back(tetra);
                }
    return tetras;
}

class Shapes : public testing::Test
{
protected:
    Shapes()
    {
        vo::writeBytes(folder / "soft.tif", 24, 20, 16, [this](int x, int y, int z) {
            return int(std::lround(255 * double(field.at(x, y, z))));
        });
        table = vo::writeSmoothTable(folder / "smooth.lut", [](double v) { return 0.02 + 0.1 * v * v; });
    }

    std::vector<float> draw(const std::string& program, const std::string& words)
    {
        return vo::drawnPicture(folder, program, words + " -size 72 64 -view -20 35").pixels();
    }

    void expectOneLine(const std::string& program, const std::string& words, const std::string& named)
    {
        vo::expectOneLine(folder, program, words, named);
    }

    /// The volume through the table, in a view.
    Scene scene(const glm::dvec3& scale = glm::dvec3(1), double degrees = 0) const
    {
        Scene s;
        s.volume = &field;
        s.width = kWidth;
        s.height = kHeight;
        s.overlap = 1;
        s.table = table;
        s.classification = Classification::postInterpolation;
        s.period = 1.0 / scale;
        s.view = degrees > 0 ? perspectiveView(kAngles, kSize, kWidth, kHeight, degrees, scale)
                             : orthographicView(kAngles, kSize, kWidth, kHeight, scale);
        return s;
    }

    static void expectEqual(const std::vector<float>& drawn, const Picture& truth, const std::string& what)
    {
        const Comparison apart = compare(drawn, truth);
        EXPECT_GE(apart.psnrMasked, 50) << what << ": " << apart.summary();
        EXPECT_GT(apart.opaquePixels, std::size_t(kWidth * kHeight / 10)) << what;
        EXPECT_LT(apart.maskedPixels, std::size_t(kWidth * kHeight / 2)) << what;
        if (std::getenv("VO_TEST_PRINT")) std::printf("%s: %s\n", what.c_str(), apart.summary().c_str());
    }

    Field field = quantised(fieldOf(kSize, [](const glm::dvec3& p) {
        return 0.5 + 0.25 * std::sin(0.5 * p.x + 0.3 * p.y) + 0.2 * std::sin(0.6 * p.z - 0.4 * p.y);
    }));
    std::vector<float> table;
    vo::ScratchFolder folder;
    const std::string kTable = " soft.tif -lutFile smooth.lut ";
};

bool isShown(const glm::dvec3& voxel)
{
    return glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.5 - 1e-7))) &&
           glm::all(glm::lessThanEqual(voxel, glm::dvec3(23.5, 19.5, 15.5) + 1e-7));
}

struct Warp
{
    double twist, bend; ///< degrees
    int cells;
    glm::dvec3 scale{1};
};

/// The tetrahedra of voglMorph: in the volume, and where they are drawn.
struct Morph
{
    std::vector<Tetrahedron> voxels, space;

    explicit Morph(const Warp& warp)
    {
        const glm::dvec3 size(24, 20, 16), scaled = size * warp.scale;
        double farthest = 0.5 * glm::length(scaled);
        const auto warped = [&](int i, int j, int k) {
            const glm::dvec3 p = (glm::dvec3(i, j, k) / double(warp.cells) - 0.5) * scaled;
            const double turn = warp.twist / 180 * std::numbers::pi * p.z / scaled.z;
            const glm::dvec3 t(std::cos(turn) * p.x - std::sin(turn) * p.y,
                               std::sin(turn) * p.x + std::cos(turn) * p.y, p.z);
            const double whole = warp.bend / 180 * std::numbers::pi;
            if (whole == 0) return t;
            const double radius = scaled.z / whole, angle = p.z / radius;
            return glm::dvec3((radius + t.x) * std::cos(angle) - radius, t.y,
                              (radius + t.x) * std::sin(angle));
        };
        for (int i = 0; i <= warp.cells; ++i)
            for (int j = 0; j <= warp.cells; ++j)
                for (int k = 0; k <= warp.cells; ++k)
                    farthest = std::max(farthest, glm::length(warped(i, j, k)));
        const double shrunk = 0.5 * glm::length(scaled) / farthest;
        space = gridTetras(warp.cells, [&](int i, int j, int k) {
            return warped(i, j, k) * shrunk / warp.scale + 0.5 * size;
        });
        voxels = gridTetras(
            warp.cells, [&](int i, int j, int k) { return glm::dvec3(i, j, k) / double(warp.cells) * size; });
    }
};

/// The scene with each point moved back to the voxel it came from.
Picture morphed(Scene scene, const Morph& morph)
{
    const Scene volume = scene;
    const TetraMap map(morph.space);
    scene.geometry = morph.space;
    scene.sampleAt = [&](const glm::dvec3& point) -> std::optional<Rgba> {
        const auto place = map.find(point);
        if (!place) return {};
        glm::dvec3 voxel(0);
        for (std::size_t c = 0; c < 4; ++c)
            voxel += place->weights[c] * morph.voxels[place->tetra][c];
        if (!isShown(voxel)) return {};
        return referenceSample(volume, voxel);
    };
    return referencePicture(scene);
}

TEST_F(Shapes, morphEqualsTheInverseWarpResampled)
{
    struct Case
    {
        const char* words;
        Warp warp;
        double degrees;
    };
    for (const auto& [words, warp, degrees] :
         {Case{"-twist 100 -grid 3", {100, 0, 3}, 0}, Case{"-twist 0 -bend 60 -grid 3 -core", {0, 60, 3}, 0},
          Case{"-twist -70 -bend -50 -grid 2 -perspective 50", {-70, -50, 2}, 50},
          Case{"-twist 100 -grid 3 -bricks 2 2 2", {100, 0, 3}, 0},
          Case{"-twist 60 -bend 40 -grid 2 -scale 1 1 2 -core -bricks 1 3 1", {60, 40, 2, {1, 1, 2}}, 0},
          Case{"-twist 40 -grid 1", {40, 0, 1}, 0}})
        expectEqual(draw("voglMorph", kTable + words), morphed(scene(warp.scale, degrees), Morph(warp)),
                    words);
}

TEST_F(Shapes, morphWithoutAWarpIsBasic)
{
    for (const char* words : {"", "-2D", "-bricks 2 1 2", "-mip", "-space view -sampling 0.6"}) {
        const auto drawn = draw("voglMorph", kTable + "-twist 0 -grid 3 " + words);
        const Comparison apart = compareDrawn(drawn, draw("voglBasic", kTable + words));
        EXPECT_GE(apart.psnrAll, 45) << words << ": " << apart.summary();
    }
}

TEST_F(Shapes, morphOfStacksShowsTheSameShape)
{
    const auto stacks = draw("voglMorph", kTable + "-twist 50 -grid 3 -2D");
    const Comparison apart = compareDrawn(stacks, draw("voglMorph", kTable + "-twist 50 -grid 3"));
    EXPECT_GE(apart.psnrAll, 20) << "slices are not interpolated: " << apart.summary();
}

TEST_F(Shapes, morphThatFoldsOverIsRefused)
{
    expectOneLine("voglMorph", "soft.tif -twist 400 -grid 2", "fold over");
    expectOneLine("voglMorph", "soft.tif -bend 300", "fold over");
    expectOneLine("voglMorph", "soft.tif -grid 0", "-grid");
    expectOneLine("voglMorph", "soft.tif -twist 1e9", "-twist");
}

/// The triangles of the refined icosahedron on the unit sphere.
std::vector<std::array<glm::dvec3, 3>> geodesic(int level)
{
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<glm::dvec3> corners;
    for (int axis = 0; axis < 3; ++axis)
        for (const double one : {-1.0, 1.0})
            for (const double golden : {-g, g}) {
                glm::dvec3 p(0);
                p[axis] = one;
                p[(axis + 1) % 3] = golden;
                corners.push_back(p);
            }
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (std::size_t a = 0; a < 12; ++a) // neighbours are 2 apart
        for (std::size_t b = a + 1; b < 12; ++b)
            for (std::size_t c = b + 1; c < 12; ++c) {
                const auto near = [&](std::size_t i, std::size_t j) {
                    return glm::distance(corners[i], corners[j]) < 2.1;
                };
                if (!near(a, b) || !near(b, c) || !near(c, a)) continue;
                triangles.push_back(
                    {glm::normalize(corners[a]), glm::normalize(corners[b]), glm::normalize(corners[c])});
            }
    for (; level > 0; --level) {
        std::vector<std::array<glm::dvec3, 3>> finer;
        for (const auto& [a, b, c] : triangles) {
            const glm::dvec3 ab = glm::normalize(a + b), bc = glm::normalize(b + c),
                             ca = glm::normalize(c + a);
            finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        triangles = finer;
    }
    return triangles;
}

/// The facets of slices round z and stacks along it, in triangles.
std::vector<std::array<glm::dvec3, 3>> slicedSphere(int slices, int stacks)
{
    const auto at = [&](int slice, int stack) {
        const double around = 2 * std::numbers::pi * slice / slices, up = std::numbers::pi * stack / stacks;
        return glm::dvec3(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), -std::cos(up));
    };
    std::vector<std::array<glm::dvec3, 3>> triangles;
    for (int i = 0; i < slices; ++i)
        for (int j = 0; j < stacks; ++j) {
            if (j > 0) triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            if (j < stacks - 1) triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return triangles;
}

struct Ball
{
    glm::dvec3 center;
    double radius;
    std::vector<std::array<glm::dvec3, 3>> triangles; ///< of the unit sphere
    glm::dvec3 scale{1};
};

/// The volume, masked: what lies outside any face of the polyhedron is not there.
Picture ballOf(Scene scene, const Ball& ball)
{
    const Scene volume = scene;
    const auto& triangles = ball.triangles;
    for (const auto& [a, b, c] : triangles) {
        const auto place = [&](const glm::dvec3& p) { return ball.center + ball.radius * p / ball.scale; };
        scene.geometry.push_back({place(a), place(b), place(c), ball.center});
    }
    scene.sampleAt = [&](const glm::dvec3& point) -> std::optional<Rgba> {
        const glm::dvec3 p = (point - ball.center) * ball.scale / ball.radius;
        for (const auto& [a, b, c] : triangles) {
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double out = glm::dot(normal, a);
            if (glm::dot(normal, p) * (out < 0 ? -1 : 1) > std::abs(out) + 1e-9) return {};
        }
        if (!isShown(point)) return {};
        return referenceSample(volume, point);
    };
    return referencePicture(scene);
}

TEST_F(Shapes, sphereEqualsAMaskedVolume)
{
    struct Case
    {
        const char* words;
        Ball ball;
        double degrees;
    };
    for (const auto& [words, ball, degrees] :
         {Case{"-level 1", {{12, 10, 8}, 8, geodesic(1)}, 0},
          Case{"-level 2 -core", {{12, 10, 8}, 8, geodesic(2)}, 0},
          Case{"-slices 7 5", {{12, 10, 8}, 8, slicedSphere(7, 5)}, 0},
          Case{"-level 1 -radius 9 -center 20 6 4 -perspective 40", {{20, 6, 4}, 9, geodesic(1)}, 40},
          Case{"-level 0 -radius 13 -center 12 10 11 -bricks 2 2 2", {{12, 10, 11}, 13, geodesic(0)}, 0},
          Case{"-level 1 -radius 10 -scale 1 1 2", {{12, 10, 8}, 10, geodesic(1), {1, 1, 2}}, 0}})
        expectEqual(draw("voglSphere", kTable + words), ballOf(scene(ball.scale, degrees), ball), words);
}

TEST_F(Shapes, sphereTakesPlanesBeyondTheVolume)
{
    // Twice as large as the volume: all of it shows, by planes at other places.
    const auto ball = draw("voglSphere", kTable + "-radius 35 -level 0 -sampling 0.1 -mip");
    const Comparison apart = compareDrawn(ball, draw("voglBasic", kTable + "-sampling 0.1 -mip"));
    EXPECT_GE(apart.psnrMasked, 35) << apart.summary();
}

TEST_F(Shapes, sphereNamesBadOptions)
{
    expectOneLine("voglSphere", "soft.tif -center 12 10 17",
                  "-center: expected a place from 0 0 0 to 24 20 16");
    expectOneLine("voglSphere", "soft.tif -radius 36", "-radius: expected at most 35.");
    expectOneLine("voglSphere", "soft.tif -radius 0", "-radius");
    expectOneLine("voglSphere", "soft.tif -level 6", "-level");
    expectOneLine("voglSphere", "soft.tif -slices 2 5", "-slices");
    expectOneLine("voglSphere", "soft.tif -slices 8 1", "-slices");
}

/// A mesh of 2 x 2 x 2 cells out of shape, with a colour at each vertex.
struct ColoredMesh
{
    static glm::dvec3 place(int i, int j, int k)
    {
        return {i + 0.2 * j - 1, j * 0.8 + 0.1 * k * i, 0.7 * k + 0.15 * std::sin(2.0 * i + j)};
    }
    static Rgba color(int i, int j, int k)
    {
        const auto part = [&](int a, int b, int c) { return ((a * i + b * j + c * k) % 7) / 8.0; };
        return {part(1, 2, 4), part(3, 5, 1), part(2, 3, 6), 0.25 * part(4, 1, 5)};
    }

    std::vector<Tetrahedron> space;
    std::vector<std::array<Rgba, 4>> colors;

    explicit ColoredMesh(std::ostream& file)
    {
        file << "# a mesh\n\n";
        for (int k = 0; k <= 2; ++k)
            for (int j = 0; j <= 2; ++j)
                for (int i = 0; i <= 2; ++i) {
                    const glm::dvec3 p = place(i, j, k);
                    const Rgba c = color(i, j, k);
                    file << "v " << p.x << ' ' << p.y << ' ' << p.z << "  " << c[0] << ' ' << c[1] << ' '
                         << c[2] << ' ' << c[3] << "  # " << i << '\n';
                }
        for (int cell = 0; cell < 8; ++cell)
            for (const auto& corners : cellTetras(cell == 1 || cell == 2 || cell == 4 || cell == 7)) {
                file << 't';
                Tetrahedron tetra;
                std::array<Rgba, 4> rgba;
                for (std::size_t c = 0; c < 4; ++c) {
                    const int i = (cell & 1) + (corners[c] & 1), j = (cell >> 1 & 1) + (corners[c] >> 1 & 1),
                              k = (cell >> 2) + (corners[c] >> 2);
                    file << ' ' << 9 * k + 3 * j + i;
                    tetra[c] = place(i, j, k);
                    rgba[c] = color(i, j, k);
                }
                file << '\n';
                space.push_back(tetra);
                colors.push_back(rgba);
            }
        fit();
    }

    /// As the program does: the longest side becomes 128, the middle that of a box of whole units.
    void fit()
    {
        glm::dvec3 lower(1e9), upper(-1e9);
        for (const Tetrahedron& tetra : space)
            for (const glm::dvec3& p : tetra) {
                lower = glm::min(lower, p);
                upper = glm::max(upper, p);
            }
        const glm::dvec3 sides = upper - lower;
        const double enlarged = 128 / std::max({sides.x, sides.y, sides.z});
        size = {int(std::ceil(enlarged * sides.x - 1e-4)), int(std::ceil(enlarged * sides.y - 1e-4)),
                int(std::ceil(enlarged * sides.z - 1e-4))};
        for (Tetrahedron& tetra : space)
            for (glm::dvec3& p : tetra)
                p = enlarged * (p - 0.5 * (lower + upper)) + 0.5 * glm::dvec3(size.x, size.y, size.z);
    }
    vo::VoxelSize size{};
};

TEST_F(Shapes, unstructuredEqualsExactLinearInterpolation)
{
    std::ofstream file(folder / "mesh.txt");
    const ColoredMesh mesh(file);
    file.close();
    const Field box = constantField(mesh.size, 0);
    const TetraMap map(mesh.space);
    for (const char* words : {"", "-core", "-perspective 50", "-mip", "-monochrome -core"}) {
        Scene s;
        s.volume = &box;
        s.width = kWidth;
        s.height = kHeight;
        s.period = glm::dvec3(4);
        const bool perspective = std::string(words) == "-perspective 50";
        s.view = perspective ? perspectiveView(kAngles, mesh.size, kWidth, kHeight, 50)
                             : orthographicView(kAngles, mesh.size, kWidth, kHeight);
        if (std::string(words) == "-mip") s.compositing = Compositing::max;
        const bool grey = std::string(words).starts_with("-mono");
        s.geometry = mesh.space;
        s.sampleAt = [&](const glm::dvec3& point) -> std::optional<Rgba> {
            const auto place = map.find(point);
            if (!place) return {};
            Rgba sum{};
            for (std::size_t c = 0; c < 4; ++c)
                for (std::size_t i = 0; i < 4; ++i)
                    sum[i] += place->weights[c] * mesh.colors[place->tetra][c][i];
            if (grey) sum[0] = sum[1] = sum[2] = 0.30 * sum[0] + 0.59 * sum[1] + 0.11 * sum[2];
            return sum;
        };
        expectEqual(draw("voglUnstructured", std::string("mesh.txt -sampling 4 ") + words),
                    referencePicture(s), words);
    }
}

TEST_F(Shapes, unstructuredHasAMeshOfItsOwn)
{
    const auto flow = draw("voglUnstructured", "");
    double red = 0, blue = 0;
    for (std::size_t i = 0; i < flow.size(); i += 4) {
        red += std::max(0.0f, flow[i] - flow[i + 2]);
        blue += std::max(0.0f, flow[i + 2] - flow[i]);
    }
    EXPECT_GT(red, 10) << "pressure";
    EXPECT_GT(blue, 10) << "suction";
}

TEST_F(Shapes, unstructuredNamesBadOptionsAndLines)
{
    const auto expectBadMesh = [this](const std::string& text, const std::string& named) {
        std::ofstream(folder / "bad.txt") << text;
        expectOneLine("voglUnstructured", "bad.txt", "bad.txt: " + named);
    };
    expectBadMesh("", "expected a tetrahedron");
    expectBadMesh("v 0 0 0 1 1 1\n", "line 1: expected a colour from 0 to 1, found the end of the line");
    expectBadMesh("v 0 0 0 1 1 2 1\n", "line 1: expected a colour from 0 to 1, found '2'");
    expectBadMesh("v 0 0 0 1 1 1 1 # fine\n\nt 0 0 0 1\n", "line 3: expected the number of a vertex");
    expectBadMesh("v 0 0 0 1 1 1 1 5\n", "line 1: expected the end of the line, found '5'");
    expectBadMesh("w 1\n", "line 1: expected v or t, found 'w'");
    expectBadMesh("v nan 0 0 1 1 1 1\n", "line 1: expected a coordinate, found 'nan'");
    expectOneLine("voglUnstructured", "missing.txt", "missing.txt");
    for (const char* option : {"-2D", "-lut 1 2", "-lutFile a.lut", "-dataRange 1 2", "-bricks 2 2 2"})
        expectOneLine("voglUnstructured", option, "option -");
    std::ofstream(folder / "flat.txt") << "v 0 0 0 1 1 1 1\nt 0 0 0 0\n";
    const auto nothing = draw("voglUnstructured", "flat.txt");
    EXPECT_EQ(*std::max_element(nothing.begin(), nothing.end()), 1) << "alpha alone";
    EXPECT_EQ(nothing[0], 0);
}

TEST_F(Shapes, tenFramesEndAsTheyBegan)
{
    for (const auto& [program, file] :
         {std::pair("voglMorph", "soft.tif"), std::pair("voglSphere", "soft.tif"),
          std::pair("voglUnstructured", "-sampling 4")})
        EXPECT_EQ(draw(program, std::string(file) + " -frames 10"), draw(program, file)) << program;
}

} // namespace
