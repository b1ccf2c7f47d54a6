// voglMesh against integrals through the cells in double precision.
#include "run_program.h"

#include "support/cell_integral.h"
#include "support/compare.h"
#include "util/mesh_files.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace {

using namespace vo::test;
using vo::CellKind;
using vo::Mesh;
using Rgba = std::array<double, 4>;

constexpr int kWidth = 72, kHeight = 64;
constexpr double kLatitude = -20, kLongitude = 35;
const std::string kSize = " -size 72 64 -view -20 35";

/// A mesh as it is drawn: its lowest corner at the origin, its longest side 128.
class Drawn
{
public:
    explicit Drawn(const Mesh& mesh)
    {
        lower_ = upper_ = vector(mesh.points[0]);
        for (const Point& point : mesh.points) {
            lower_ = glm::min(lower_, vector(point));
            upper_ = glm::max(upper_, vector(point));
        }
        const glm::dvec3 size = upper_ - lower_;
        scale_ = 128 / std::max({size.x, size.y, size.z});
    }
    glm::dvec3 place(const Point& point) const { return scale_ * (vector(point) - lower_); }
    glm::dvec3 size() const { return scale_ * (upper_ - lower_); }

    View view(double degrees) const
    {
        const double half = 0.5 * glm::length(size()), wide = double(kWidth) / kHeight;
        View view;
        view.model = multiply(rotation(-kLatitude - 90, 1, 0, 0),
                              multiply(rotation(-kLongitude, 0, 0, 1),
                                       translation(-size().x / 2, -size().y / 2, -size().z / 2)));
        view.projection = ortho(-half * wide, half * wide, -half, half, -2 * half, 2 * half);
        if (degrees == 0) return view;
        const double sine = std::sin(degrees / 360 * 3.14159265358979), distance = half / sine;
        const double near = 0.5 * (distance - half), side = near * sine / std::sqrt(1 - sine * sine);
        view.model = multiply(translation(0, 0, -distance), view.model);
        view.projection = frustum(-side * wide, side * wide, -side, side, near, distance + 2 * half);
        return view;
    }

private:
    static glm::dvec3 vector(const Point& point) { return {point[0], point[1], point[2]}; }
    glm::dvec3 lower_, upper_;
    double scale_ = 1;
};

class MeshProgram : public testing::Test
{
protected:
    MeshProgram()
    {
        table = vo::writeSmoothTable(folder / "smooth.lut", [](double v) { return 0.004 + 0.02 * v * v; });
    }

    /// The table at `part` of its way, linear between entries.
    Rgba lookUp(double part) const
    {
        const double place = std::clamp(part, 0.0, 1.0) * 255;
        const auto entry = std::min<std::size_t>(static_cast<std::size_t>(place), 254);
        Rgba rgba{};
        for (std::size_t i = 0; i < 4; ++i) {
            const double below = double(table[4 * entry + i]), above = double(table[4 * entry + 4 + i]);
            rgba[i] = below + (place - static_cast<double>(entry)) * (above - below);
        }
        return rgba;
    }

    std::vector<float> draw(const std::string& words, const std::string& said = "")
    {
        return vo::drawnPicture(folder, "voglMesh", words + kSize, said).pixels();
    }

    static void expectEqual(const std::vector<float>& drawn, const Picture& truth, const std::string& what,
                            double decibels = 45)
    {
        const Comparison apart = compare(drawn, truth);
        EXPECT_GE(apart.psnrAll, decibels) << what << ": " << apart.summary();
        EXPECT_GT(apart.opaquePixels, std::size_t(kWidth * kHeight / 10)) << what;
        if (std::getenv("VO_TEST_PRINT")) std::printf("%s: %s\n", what.c_str(), apart.summary().c_str());
    }

    void expectOneLine(const std::string& words, const std::string& named)
    {
        vo::expectOneLine(folder, "voglMesh", words, named);
    }

    std::vector<float> table;
    vo::ScratchFolder folder;
};

/// The scene of a mesh of tetrahedra; colorAt(tetra, weights) is set by the caller.
CellScene sceneOf(const Mesh& mesh, double degrees = 0)
{
    const Drawn drawn(mesh);
    CellScene scene;
    scene.width = kWidth;
    scene.height = kHeight;
    scene.view = drawn.view(degrees);
    for (std::size_t i = 0; i < mesh.corners.size(); i += 4) {
        Tetrahedron tetra;
        for (std::size_t c = 0; c < 4; ++c)
            tetra[c] = drawn.place(mesh.points[static_cast<std::size_t>(mesh.corners[i + c])]);
        scene.tetras.push_back(tetra);
    }
    return scene;
}

/// The box of a mixed mesh as six tetrahedra of corners apart from those of the mesh.
Mesh boxOf(int n)
{
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.points.push_back(
            {double(n) * (corner & 1), double(n) * (corner >> 1 & 1), double(n) * (corner >> 2)});
    mesh.corners = {0, 1, 3, 7, 0, 3, 2, 7, 0, 2, 6, 7, 0, 6, 4, 7, 0, 4, 5, 7, 0, 5, 1, 7};
    mesh.kinds.assign(6, CellKind::tetra);
    return mesh;
}

/// The value at these weights of a tetrahedron.
double mixed(const Mesh& mesh, const std::vector<double>& values, std::size_t tetra,
             const std::array<double, 4>& w)
{
    double sum = 0;
    for (std::size_t c = 0; c < 4; ++c)
        sum += w[c] * values[static_cast<std::size_t>(mesh.corners[4 * tetra + c])];
    return sum;
}

std::vector<double> linear(const Mesh& mesh)
{
    std::vector<double> values;
    for (const Point& p : mesh.points)
        values.push_back(5 + 2 * p[0] - 3 * p[1] + 1.5 * p[2]);
    return values;
}

TEST_F(MeshProgram, linearFieldOnAnyCellsIsExact)
{
    struct Case
    {
        const char* words;
        double degrees;
    };
    unsigned seed = 0;
    for (const auto& [words, degrees] : {Case{"", 0},
                                         {"-core", 0},
                                         {"-engine cast", 0},
                                         {"-engine slices", 0},
                                         {"-perspective 40", 40},
                                         {"-engine cast -perspective 50 -core", 50},
                                         {"-shells -perspective 50", 50},
                                         {"-space view -sampling 0.2", 0}}) {
        MixedMesh any(3, 0.25, ++seed);
        any.mesh.pointFields = {{"linear", 1, false, linear(any.mesh)}, any.mesh.pointFields[1]};
        vo::test::writeFile(folder / "any.vtu", VtuWriter({VtuStyle::Where::inlined}).file({&any.mesh}));
        const Mesh box = boxOf(3);
        CellScene scene = sceneOf(box, degrees);
        const std::vector<double> values = linear(box);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        scene.colorAt = [&, lowest = *low, across = *high - *low](std::size_t tetra,
                                                                  const std::array<double, 4>& w) {
            return lookUp((mixed(box, values, tetra, w) - lowest) / across);
        };
        expectEqual(draw(std::string("any.vtu -field linear -lutFile smooth.lut -sampling 0.5 ") + words),
                    integrateCells(scene), words);
    }
}

TEST_F(MeshProgram, fieldsAreInterpolatedInsideACellAndThenLookedUp)
{
    const Mesh mesh = [] {
        MixedMesh any(2, 0.25, 11);
        const vo::SplitMesh split = vo::splitMesh(any.mesh);
        Mesh tetras;
        tetras.points = split.points;
        for (const auto& tetra : split.tetras)
            tetras.corners.insert(tetras.corners.end(), tetra.begin(), tetra.end());
        tetras.kinds.assign(split.tetras.size(), CellKind::tetra);
        std::mt19937 random(4);
        std::uniform_real_distribution<double> value(-2, 3);
        const auto field = [&](const char* name, int components, std::size_t count) {
            vo::MeshField made{name, components, false, {}};
            for (std::size_t i = 0; i < count * static_cast<std::size_t>(components); ++i)
                made.values.push_back(double(float(value(random))));
            return made;
        };
        tetras.pointFields = {field("heat", 1, tetras.points.size()), field("flow", 3, tetras.points.size())};
        tetras.cellFields = {field("region", 1, tetras.kinds.size())};
        return tetras;
    }();
    vo::test::writeFile(folder / "t.vtk", legacyVtk(mesh, true, false));
    CellScene scene = sceneOf(mesh);
    const auto expectValues = [&](const std::string& words, const std::vector<double>& values, double low,
                                  double high) {
        scene.colorAt = [&](std::size_t tetra, const std::array<double, 4>& w) {
            return lookUp((mixed(mesh, values, tetra, w) - low) / (high - low));
        };
        expectEqual(draw("t.vtk -lutFile smooth.lut -sampling 0.25 " + words), integrateCells(scene), words);
    };
    const auto range = [](const std::vector<double>& values) {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        return std::pair(*low, *high);
    };
    const auto& heat = mesh.pointFields[0].values;
    std::vector<double> part, length;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        const double* v = mesh.pointFields[1].values.data() + 3 * i;
        part.push_back(v[1]);
        length.push_back(std::hypot(v[0], v[1], v[2]));
    }
    expectValues("", heat, range(heat).first, range(heat).second);
    expectValues("-engine cast", heat, range(heat).first, range(heat).second);
    expectValues("-dataRange -0.5 1.25", heat, -0.5, 1.25);
    expectValues("-dataRange -0.5 1.25 -engine cast", heat, -0.5, 1.25);
    expectValues("-dataRange -9 8", heat, -9, 8);
    expectValues("-field flow", length, range(length).first, range(length).second);
    expectValues("-field flow -component 1", part, range(part).first, range(part).second);

    const auto& regions = mesh.cellFields[0].values;
    const auto [low, high] = range(regions);
    scene.colorAt = [&, lowest = low, across = high - low](std::size_t tetra, const std::array<double, 4>&) {
        return lookUp((regions[tetra] - lowest) / across);
    };
    for (const char* words : {"", "-engine cast", "-colors"})
        expectEqual(draw(std::string("t.vtk -field region -lutFile smooth.lut -sampling 0.25 ") + words),
                    integrateCells(scene), std::string("region ") + words);

    const auto [coldest, hottest] = range(heat);
    scene.colorAt = [&, lowest = coldest, across = hottest - coldest](std::size_t tetra,
                                                                      const std::array<double, 4>& w) {
        Rgba rgba{};
        for (std::size_t c = 0; c < 4; ++c) {
            const Rgba corner =
                lookUp((heat[static_cast<std::size_t>(mesh.corners[4 * tetra + c])] - lowest) / across);
            for (std::size_t i = 0; i < 4; ++i)
                rgba[i] += w[c] * corner[i];
        }
        return rgba;
    };
    for (const char* words : {"-colors", "-colors -core"})
        expectEqual(draw(std::string("t.vtk -lutFile smooth.lut -sampling 0.25 ") + words),
                    integrateCells(scene), words);
}

TEST_F(MeshProgram, coloursOfTheFileAreDrawnAsTheyAre)
{
    const Mesh box = boxOf(1);
    std::string file = "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n";
    for (const Point& p : box.points)
        file += std::to_string(p[0]) + " " + std::to_string(p[1]) + " " + std::to_string(p[2]) + "\n";
    file += "CELLS 6 30\n";
    for (std::size_t i = 0; i < box.corners.size(); ++i)
        file += (i % 4 == 0 ? "\n4 " : " ") + std::to_string(box.corners[i]);
    file += "\nCELL_TYPES 6\n10 10 10 10 10 10\nPOINT_DATA 8\nCOLOR_SCALARS rgba 4\n";
    std::vector<Rgba> colors;
    for (int i = 0; i < 8; ++i) {
        colors.push_back({(i * 3 % 8) / 8.0, (i * 5 % 7) / 7.0, (i & 2) / 2.0, 0.005 + 0.003 * i});
        for (const double part : colors.back())
            file += std::to_string(part) + " ";
    }
    vo::test::writeFile(folder / "colors.vtk", file);
    CellScene scene = sceneOf(box);
    scene.colorAt = [&](std::size_t tetra, const std::array<double, 4>& w) {
        Rgba rgba{};
        for (std::size_t c = 0; c < 4; ++c)
            for (std::size_t i = 0; i < 4; ++i)
                rgba[i] += w[c] * colors[static_cast<std::size_t>(box.corners[4 * tetra + c])][i];
        return rgba;
    };
    expectEqual(draw("colors.vtk -sampling 0.5"), integrateCells(scene), "colours");
    expectOneLine("colors.vtk -lutFile smooth.lut",
                  "option -lutFile: expected none, since the field has colours");
    expectOneLine("colors.vtk -bar", "option -bar");
}

TEST_F(MeshProgram, flowRoundAPostIsThatOfItsCells)
{
    const char* data = std::getenv("VOLUMIZER_TEST_DATA");
    const std::string path = std::string(data ? data : "") + "/snapshot/vtkdata/post.vtk";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "post.vtk is not there";
    const auto mesh = vo::readMesh(path);
    ASSERT_TRUE(mesh) << mesh.failure().text;
    const auto& values = mesh->pointFields[0].values;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    CellScene scene = sceneOf(*mesh);
    scene.colorAt = [&, lowest = *low, across = *high - *low](std::size_t tetra,
                                                              const std::array<double, 4>& w) {
        return lookUp((mixed(*mesh, values, tetra, w) - lowest) / across);
    };
    const Picture truth = integrateCells(scene);
    for (const char* words : {"", "-engine cast", "-engine slices"})
        expectEqual(draw(path + " -lutFile smooth.lut -sampling 0.5 " + words), truth,
                    std::string("post ") + words);
}

TEST_F(MeshProgram, barShowsTheTableAndItsNumbers)
{
    MixedMesh any(2, 0.1, 5);
    vo::test::writeFile(folder / "any.msh", gmsh(any.mesh, true, false, false));
    for (const char* words : {"", "-core", "-colors", "-engine cast"}) {
        const std::string said = "voglMesh: any.msh: 1 of " + std::to_string(any.mesh.cellCount() + 1) +
                                 " cells skipped: 1 points, lines or surfaces\n";
        draw(std::string("any.msh -lutFile smooth.lut -bar ") + words, said);
        const auto picture = vo::readPng(folder / "picture.png");
        ASSERT_TRUE(picture);
        // The bar is ten dots wide, six from the right edge and eight from the others.
        for (int y = 8; y < kHeight - 8; ++y) {
            const Rgba color = lookUp((kHeight - 8 - y - 0.5) / (kHeight - 16));
            for (int i = 0; i < 3; ++i)
                EXPECT_NEAR(vo::channel(*picture, kWidth - 10, y, i), 255 * color[std::size_t(i)], 2)
                    << y << words;
        }
        int white = 0;
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth - 18; ++x)
                white += std::min({vo::channel(*picture, x, y, 0), vo::channel(*picture, x, y, 1),
                                   vo::channel(*picture, x, y, 2)}) == 255;
        EXPECT_GT(white, 100) << "dots of digits" << words;
    }
}

/// A cube as one hexahedron, or as six pyramids round its middle.
Mesh cube(bool pyramids)
{
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},   {0, 0, 1},
                   {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {.5, .5, .5}};
    mesh.corners = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.kinds = {CellKind::hexa};
    if (pyramids) {
        mesh.kinds.assign(6, CellKind::pyramid);
        mesh.corners = {0, 1, 2, 3, 8, 4, 7, 6, 5, 8, 0, 4, 5, 1, 8,
                        1, 5, 6, 2, 8, 2, 6, 7, 3, 8, 3, 7, 4, 0, 8};
    }
    mesh.pointFields = {{"low", 1, false, {0, 1, 0, 0, 0, 0, 0, 0, 0}},
                        {"none", 3, false, std::vector<double>(27)}};
    mesh.cellFields = {{"region", 1, false, std::vector<double>(mesh.kinds.size())}};
    return mesh;
}

TEST_F(MeshProgram, outlinesShowWhereTheMeshEnds)
{
    vo::test::writeFile(folder / "one.vtk", legacyVtk(cube(false), false, true));
    vo::test::writeFile(folder / "six.vtk", legacyVtk(cube(true), false, true));
    const auto yellow = [&](const std::string& words) {
        draw("-lut 1000 1 " + words);
        const auto picture = vo::readPng(folder / "picture.png");
        std::vector<int> pixels;
        for (int i = 0; picture && i < kWidth * kHeight; ++i) {
            const auto part = [&](int which) { return vo::channel(*picture, i % kWidth, i / kWidth, which); };
            if (part(0) == 255 && part(1) == 255 && part(2) == 0) pixels.push_back(i);
        }
        return pixels;
    };
    EXPECT_TRUE(yellow("one.vtk").empty());
    const auto expected = yellow("one.vtk -wireframe");
    EXPECT_GT(expected.size(), 200u);
    for (const char* words : {"", "-core", "-colors", "-engine cast"})
        EXPECT_EQ(yellow(std::string("six.vtk -wireframe ") + words), expected) << words;
}

TEST_F(MeshProgram, whatCannotBeDrawnIsRefusedInOneLine)
{
    MixedMesh any(1, 0, 5);
    vo::test::writeFile(folder / "any.vtk", legacyVtk(any.mesh, false, false));
    expectOneLine("missing.vtk", "missing.vtk: cannot open");
    expectOneLine("any.vtk -field cold", "expected one of the fields heat, flow, region, found 'cold'");
    expectOneLine("any.vtk -field flow -component 3", "option -component: expected 0 to 2");
    expectOneLine("any.vtk -2D", "option -2D");
    expectOneLine("any.vtk -bricks 2 2 2", "option -bricks");
    expectOneLine("any.vtk -colors -engine cast", "option -engine");
    expectOneLine("any.vtk any.vtk", "expected the file of one mesh");
    const std::string whole = legacyVtk(any.mesh, true, false);
    vo::test::writeFile(folder / "cut.vtk", whole.substr(0, whole.size() / 2));
    expectOneLine("cut.vtk", "cut.vtk: ");
    any.mesh.pointFields.clear();
    any.mesh.cellFields.clear();
    vo::test::writeFile(folder / "bare.vtu", VtuWriter({}).file({&any.mesh}));
    expectOneLine("bare.vtu", "bare.vtu: expected a field, found none");
}

} // namespace
