// Meshes of known contents in every format, and damaged ones.
#include "mesh_files.h"
#include "scratch_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace {

using namespace vo::test;
using vo::CellKind;
using vo::Mesh;
using vo::MeshField;

/// The files of a mesh in all formats that hold all of it, by name.
std::map<std::string, std::string> allFormats(const Mesh& mesh)
{
    std::map<std::string, std::string> files{
        {"ascii3.vtk", legacyVtk(mesh, false, false)},
        {"ascii5.vtk", legacyVtk(mesh, false, true)},
        {"binary3.vtk", legacyVtk(mesh, true, false)},
        {"binary5.vtk", legacyVtk(mesh, true, true)},
    };
    using Where = VtuStyle::Where;
    files["ascii.vtu"] = VtuWriter({}).file({&mesh});
    int number = 0;
    for (const Where where : {Where::inlined, Where::appendedRaw, Where::appendedBase64})
        for (const bool compressed : {false, true})
            for (const bool bigEndian : {false, true})
                for (const bool longHeader : {false, true})
                    files["binary" + std::to_string(++number) + ".vtu"] =
                        VtuWriter({where, compressed, bigEndian, longHeader}).file({&mesh});
    for (const bool version4 : {false, true}) {
        const std::string name = version4 ? "4.msh" : "2.msh";
        files["ascii" + name] = gmsh(mesh, version4, false, false);
        files["little" + name] = gmsh(mesh, version4, true, false);
        files["big" + name] = gmsh(mesh, version4, true, true);
    }
    return files;
}

void expectSame(const MeshField& found, const MeshField& expected, const std::string& name)
{
    EXPECT_EQ(found.name, expected.name) << name;
    EXPECT_EQ(found.components, expected.components) << name;
    EXPECT_EQ(found.values, expected.values) << name << " " << expected.name;
}

Mesh tetrasOf(const Mesh& mixed)
{
    const vo::SplitMesh split = vo::splitMesh(mixed);
    Mesh mesh;
    mesh.points = split.points;
    for (const auto& tetra : split.tetras) {
        mesh.kinds.push_back(CellKind::tetra);
        mesh.corners.insert(mesh.corners.end(), tetra.begin(), tetra.end());
    }
    mesh.pointFields = {{"value", 1, false, vo::valuesAtPoints(mixed, split, mixed.pointFields[0])}};
    MeshField regions{"region", 1, false, {}};
    for (const std::int64_t cell : split.cellOfTetra)
        regions.values.push_back(mixed.cellFields[0].values[static_cast<std::size_t>(cell)]);
    mesh.cellFields = {regions};
    return mesh;
}

class MeshFormats : public testing::Test
{
protected:
    vo::Result<Mesh> read(const std::string& name, const std::string& bytes)
    {
        writeFile(folder / name, bytes);
        return vo::readMesh(folder / name);
    }
    /// That the file is refused in one line that names it and says `why`.
    void expectRefused(const std::string& name, const std::string& bytes, const std::string& why)
    {
        const auto mesh = read(name, bytes);
        ASSERT_FALSE(mesh) << name;
        const std::string& text = mesh.failure().text;
        EXPECT_EQ(text.find(folder / ""), 0u) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_NE(text.find(why), std::string::npos) << text;
    }

    vo::ScratchFolder folder;
    const MixedMesh mixed{3, 0.2, 7};
};

TEST_F(MeshFormats, everyFormatHoldsTheSameMesh)
{
    for (const auto& [name, bytes] : allFormats(mixed.mesh)) {
        const auto mesh = read(name, bytes);
        ASSERT_TRUE(mesh) << name << ": " << mesh.failure().text;
        EXPECT_EQ(mesh->points, mixed.mesh.points) << name;
        EXPECT_EQ(mesh->kinds, mixed.mesh.kinds) << name;
        EXPECT_EQ(mesh->corners, mixed.mesh.corners) << name;
        ASSERT_EQ(mesh->pointFields.size(), 2u) << name;
        ASSERT_EQ(mesh->cellFields.size(), 1u) << name;
        expectSame(mesh->pointFields[0], mixed.mesh.pointFields[0], name);
        expectSame(mesh->pointFields[1], mixed.mesh.pointFields[1], name);
        EXPECT_EQ(mesh->cellFields[0].name, "region") << name;
        std::vector<double> regions = mixed.mesh.cellFields[0].values;
        const bool hasTriangle = name.ends_with(".msh");
        EXPECT_EQ(mesh->cellFields[0].values, regions) << name;
        EXPECT_EQ(mesh->counts.text(), hasTriangle ? "1 of " + std::to_string(regions.size() + 1) +
                                                         " cells skipped: 1 points, lines or surfaces"
                                                   : "")
            << name;
    }
}

TEST_F(MeshFormats, viewHoldsItsCellsWithPointsInCommon)
{
    for (const char* name : {"view.pos", "view.pos.gz"}) {
        const std::string bytes = gmshView(mixed.mesh);
        writeFile(folder / name, bytes);
        if (std::string(name).ends_with(".gz")) {
            const gzFile file = gzopen((folder / name).c_str(), "wb");
            gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
            gzclose(file);
        }
        const auto mesh = vo::readMesh(folder / name);
        ASSERT_TRUE(mesh) << mesh.failure().text;
        EXPECT_EQ(mesh->kinds, mixed.mesh.kinds);
        EXPECT_EQ(mesh->points.size(), mixed.mesh.points.size());
        ASSERT_EQ(mesh->corners.size(), mixed.mesh.corners.size());
        for (std::size_t i = 0; i < mesh->corners.size(); ++i) {
            const auto here = static_cast<std::size_t>(mesh->corners[i]),
                       there = static_cast<std::size_t>(mixed.mesh.corners[i]);
            ASSERT_EQ(mesh->points[here], mixed.mesh.points[there]);
            ASSERT_EQ(mesh->pointFields[0].values[here], mixed.mesh.pointFields[0].values[there]);
        }
        EXPECT_EQ(mesh->pointFields[0].name, "heat");
    }
}

TEST_F(MeshFormats, viewWithStepsBetweenCellsKeepsThem)
{
    const auto mesh = read("steps.pos", "View \"v\" {\nSS(0,0,0,1,0,0,0,1,0,0,0,1){1,2,3,4,9,9,9,9};\n"
                                        "SS(0,0,0,0,1,0,1,0,0,0,0,-1){1,3,5,6,9,9,9,9};\n"
                                        "VS(0,0,0,1,0,0,0,1,0,0,0,1){1,2,3,4,5,6,7,8,9,10,11,12};\n};");
    ASSERT_TRUE(mesh) << mesh.failure().text;
    // Two of the corners in common have one value, the third has two.
    EXPECT_EQ(mesh->points.size(), 6u);
    std::vector<double> values;
    for (const std::int64_t corner : mesh->corners)
        values.push_back(mesh->pointFields.at(0).values[static_cast<std::size_t>(corner)]);
    EXPECT_EQ(values, (std::vector<double>{1, 2, 3, 4, 1, 3, 5, 6}));
    EXPECT_EQ(mesh->notes, std::vector<std::string>{"the first of 2 steps is read"});
    EXPECT_EQ(mesh->counts.text(), "1 of 3 cells skipped: 1 of kinds that are not read");
}

TEST_F(MeshFormats, tetGenCountsFromZeroOrOne)
{
    const Mesh tetras = tetrasOf(mixed.mesh);
    for (const int first : {0, 1}) {
        writeFile(folder / "a.node", tetGenNodes(tetras, first));
        writeFile(folder / "a.ele", tetGenElements(tetras, first));
        for (const char* name : {"a.node", "a.ele"}) {
            const auto mesh = vo::readMesh(folder / name);
            ASSERT_TRUE(mesh) << mesh.failure().text;
            EXPECT_EQ(mesh->points, tetras.points);
            EXPECT_EQ(mesh->corners, tetras.corners);
            expectSame(mesh->pointFields.at(0), tetras.pointFields[0], name);
            expectSame(mesh->cellFields.at(0), tetras.cellFields[0], name);
        }
    }
}

TEST_F(MeshFormats, piecesOfAVtuAreOneMesh)
{
    const MixedMesh other(2, 0.1, 8);
    const auto mesh = read("two.vtu", VtuWriter({VtuStyle::Where::inlined}).file({&mixed.mesh, &other.mesh}));
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), mixed.mesh.points.size() + other.mesh.points.size());
    EXPECT_EQ(mesh->cellCount(), mixed.mesh.cellCount() + other.mesh.cellCount());
    EXPECT_EQ(mesh->corners[mixed.mesh.corners.size()],
              other.mesh.corners[0] + std::int64_t(mixed.mesh.points.size()));
    EXPECT_EQ(mesh->cellFields[0].values.back(), other.mesh.cellFields[0].values.back());
}

/// Text of a grid of these cells on the unit cube's corners and (0.5, 0.5, 2), with a number on each cell.
std::string cubeGrid(const std::vector<std::pair<int, std::vector<int>>>& cells)
{
    std::ostringstream cellText, types, values;
    std::size_t numbers = 0;
    for (const auto& [type, corners] : cells) {
        cellText << corners.size();
        for (const int corner : corners)
            cellText << ' ' << corner;
        cellText << '\n';
        types << type << '\n';
        values << types.str().size() << '\n';
        numbers += corners.size() + 1;
    }
    std::ostringstream file;
    file << "# vtk DataFile Version 2.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 10 float\n"
            "0 0 0 1 0 0 1 1 0 0 1 0 0 0 1 1 0 1 1 1 1 0 1 1 0.5 0.5 2 nan 0 0\n"
         << "CELLS " << cells.size() << ' ' << numbers << '\n'
         << cellText.str() << "CELL_TYPES " << cells.size() << '\n'
         << types.str() << "CELL_DATA " << cells.size() << "\nSCALARS c int\nLOOKUP_TABLE default\n"
         << values.str();
    return file.str();
}

TEST_F(MeshFormats, cellsThatCannotBeDrawnAreCountedAndTheRestIsKept)
{
    const auto mesh = read("bad.vtk", cubeGrid({{10, {0, 1, 2, 4}},  // fine
                                                {10, {0, 1, 4, 2}},  // inside out, and the same as the first
                                                {10, {0, 2, 1, 8}},  // inside out
                                                {10, {0, 1, 2, 3}},  // flat
                                                {10, {0, 1, 2, 77}}, // no such point
                                                {10, {0, 1, 2, -1}}, // no such point
                                                {10, {0, 1, 2}},     // too few
                                                {10, {1, 2, 3, 9}},  // not a number
                                                {5, {0, 1, 2}},      // a triangle
                                                {42, {1, 2, 3, 4}},  // a polyhedron
                                                {12, {0, 1, 2, 3, 6, 5, 4, 7}},
                                                {10, {1, 1, 2, 4}}, // flat
                                                {24, {4, 5, 6, 8, 0, 0, 0, 0, 0, 0}}}));
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->cellCount(), 3u);
    EXPECT_EQ(
        mesh->counts.text(),
        "10 of 13 cells skipped: 1 points, lines or surfaces, 1 of kinds that are not read, 3 with corners "
        "that "
        "are no points of the file, 1 at points without finite coordinates, 2 of no volume, 1 partly inside "
        "out, 1 repeated; 1 cells inside out turned round; 1 cells with curved edges taken as straight");
    EXPECT_EQ(mesh->cellFields.at(0).values.size(), 3u);
    EXPECT_EQ(mesh->cellFields[0].values[0], 3);
    EXPECT_EQ(mesh->cellFields[0].values[1], 9) << "that of the third cell";
}

TEST_F(MeshFormats, voxelsAndPrismsOfEitherHandAreRead)
{
    for (const auto& [type, corners] : {std::pair{11, std::vector<int>{0, 1, 3, 2, 4, 5, 7, 6}},
                                        {12, {0, 1, 2, 3, 4, 5, 6, 7}},
                                        {12, {4, 5, 6, 7, 0, 1, 2, 3}},
                                        {13, {0, 1, 2, 4, 5, 6}},
                                        {13, {0, 2, 1, 4, 6, 5}},
                                        {14, {0, 1, 2, 3, 8}},
                                        {14, {0, 3, 2, 1, 8}}}) {
        const auto mesh = read("one.vtk", cubeGrid({{type, corners}}));
        ASSERT_TRUE(mesh) << mesh.failure().text;
        double volume = 0;
        const vo::SplitMesh split = vo::splitMesh(*mesh);
        for (const auto& t : split.tetras) {
            const double piece = volumeOf(split, t);
            EXPECT_GT(piece, 0);
            volume += piece;
        }
        EXPECT_NEAR(volume, type == 13 ? 0.5 : type == 14 ? 2.0 / 3 : 1.0, 1e-12) << type;
        EXPECT_EQ(mesh->counts.inverted, (type == 12 && corners[0] == 4) || (type == 14 && corners[1] == 3));
    }
}

TEST_F(MeshFormats, bytesOfThreeOrFourComponentsAreColours)
{
    const std::string grid = cubeGrid({{10, {0, 1, 2, 4}}});
    const auto mesh =
        read("colors.vtk", grid + "COLOR_SCALARS rgba 4\n0.25 0.5 0.75 1\nSCALARS rgb unsigned_char 3\n"
                                  "LOOKUP_TABLE default\n51 102 255\n");
    ASSERT_TRUE(mesh) << mesh.failure().text;
    ASSERT_EQ(mesh->cellFields.size(), 3u);
    EXPECT_FALSE(mesh->cellFields[0].isColor);
    EXPECT_TRUE(mesh->cellFields[1].isColor);
    EXPECT_EQ(mesh->cellFields[1].values, (std::vector<double>{0.25, 0.5, 0.75, 1}));
    EXPECT_TRUE(mesh->cellFields[2].isColor);
    EXPECT_EQ(mesh->cellFields[2].values, (std::vector<double>{51 / 255.0, 102 / 255.0, 1}));
}

TEST_F(MeshFormats, wrongFilesAreRefusedWithTheReason)
{
    const std::string grid = cubeGrid({{10, {0, 1, 2, 4}}});
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return text.replace(text.find(from), from.size(), to);
    };
    expectRefused("empty.vtk", "", "expected a mesh");
    expectRefused("other.txt", "hello", "found \"hello\"");
    expectRefused("kind.vtk", changed(grid, "UNSTRUCTURED_GRID", "POLYDATA"),
                  "expected DATASET UNSTRUCTURED_GRID");
    expectRefused("huge.vtk", changed(grid, "POINTS 10", "POINTS 4000000000000000000"), "cut off");
    expectRefused("many.vtk", changed(grid, "POINTS 10", "POINTS 1000000000"), "cut off");
    expectRefused("letters.vtk", changed(grid, "0.5 0.5 2", "0.5 x 2"), "line 6: expected a number");
    expectRefused("count.vtk", changed(grid, "CELL_DATA 1", "CELL_DATA 2"),
                  "expected data for 1 cells, found 2");
    expectRefused("nothing.vtk", cubeGrid({{5, {0, 1, 2}}}), "expected a cell of some volume");
    const std::string vtu = VtuWriter({VtuStyle::Where::inlined, true}).file({&mixed.mesh});
    expectRefused("points.vtu", changed(vtu, "NumberOfPoints=\"", "NumberOfPoints=\"9"), "bytes, found");
    expectRefused("xml.vtu", changed(vtu, "</CellData>", "</CelData>"), "expected XML");
    expectRefused("lz4.vtu", changed(vtu, "vtkZLib", "vtkLZ4"), "vtkZLibDataCompressor");
    expectRefused("format.msh", changed(gmsh(mixed.mesh, true, false, false), "4.1", "3.0"),
                  "expected version 2.2");
    expectRefused("item.pos", changed(gmshView(mixed.mesh), "TIME", "ZEIT"), "expected an item of a view");
    expectRefused("alone.node", "1 3 0 0\n0 0 0 0\n", ".ele: cannot open");
    EXPECT_FALSE(vo::readMesh(folder / "missing.vtu"));
    EXPECT_FALSE(vo::readMesh(folder / ""));
}

TEST_F(MeshFormats, damagedFilesAreReadOrRefusedInOneLine)
{
    auto files = allFormats(MixedMesh(2, 0.2, 3).mesh);
    files["view.pos"] = gmshView(MixedMesh(2, 0.2, 3).mesh);
    const Mesh tetras = tetrasOf(MixedMesh(1, 0.2, 3).mesh);
    files["a.node"] = tetGenNodes(tetras, 0);
    writeFile(folder / "a.ele", tetGenElements(tetras, 0));
    std::mt19937 random(5);
    int refused = 0, kept = 0;
    const auto check = [&](const std::string& name, const std::string& bytes) {
        const auto mesh = read(name, bytes);
        if (mesh) {
            ++kept;
            vo::splitMesh(*mesh);
            return;
        }
        ++refused;
        const std::string& text = mesh.failure().text;
        EXPECT_EQ(text.find(folder / ""), 0u) << text;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
        EXPECT_LT(text.size(), 500u) << text;
    };
    for (const auto& [name, bytes] : files) {
        for (std::size_t i = 0; i < 40; ++i)
            check(name, bytes.substr(0, bytes.size() * i / 40 + random() % 20));
        for (int i = 0; i < 60; ++i) {
            std::string changed = bytes;
            for (unsigned k = 1 + random() % 3; k > 0; --k)
                changed[random() % changed.size()] = static_cast<char>(random());
            check(name, changed);
        }
        // Digits of numbers, which leave the file well formed: most sit in the head.
        for (int i = 0; i < 60; ++i) {
            std::string changed = bytes;
            const std::size_t span = i % 2 == 0 ? std::min<std::size_t>(changed.size(), 400) : changed.size();
            std::size_t at = random() % span;
            while (at < changed.size() && (changed[at] < '0' || changed[at] > '9'))
                ++at;
            if (at < changed.size())
                changed.replace(at, 1, i % 3 == 0 ? "98765432109" : std::to_string(random() % 10));
            check(name, changed);
        }
    }
    EXPECT_GT(refused, 1000);
    EXPECT_GT(kept, 100);
}

class RealMeshes : public testing::Test
{
protected:
    vo::Result<Mesh> read(const std::string& name)
    {
        const char* folder = std::getenv("VOLUMIZER_TEST_DATA");
        const std::string path = std::string(folder ? folder : "") + "/" + name;
        if (!std::filesystem::exists(path)) return vo::Failure{""};
        return vo::readMesh(path);
    }
    static std::pair<double, double> range(const MeshField& field)
    {
        const auto [low, high] = std::minmax_element(field.values.begin(), field.values.end());
        return {*low, *high};
    }
    static double volume(const Mesh& mesh)
    {
        const vo::SplitMesh split = vo::splitMesh(mesh);
        double sum = 0;
        for (const auto& t : split.tetras)
            sum += volumeOf(split, t);
        return sum;
    }
};

TEST_F(RealMeshes, flowRoundAPost)
{
    const auto mesh = read("snapshot/vtkdata/post.vtk");
    if (!mesh && mesh.failure().text.empty()) GTEST_SKIP() << "post.vtk is not there";
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), 2288u);
    EXPECT_EQ(mesh->cellCount(), 8750u);
    EXPECT_EQ(mesh->counts.text(), "");
    ASSERT_EQ(mesh->pointFields.at(0).name, "Pressure");
    EXPECT_NEAR(range(mesh->pointFields[0]).first, 0.355, 5e-4);
    EXPECT_NEAR(range(mesh->pointFields[0]).second, 1.641, 5e-4);
    EXPECT_NEAR(volume(*mesh), 27.795, 5e-4);
}

TEST_F(RealMeshes, mixedWindingIsTurnedRound)
{
    const auto mesh = read("snapshot/vtkdata/tetraMesh.vtk");
    if (!mesh && mesh.failure().text.empty()) GTEST_SKIP() << "tetraMesh.vtk is not there";
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), 55u);
    EXPECT_EQ(mesh->cellCount(), 160u);
    EXPECT_GT(mesh->counts.inverted, 0);
}

TEST_F(RealMeshes, fireOfHexahedra)
{
    const auto mesh = read("packaged/mayavi2/fire_ug.vtu");
    if (!mesh && mesh.failure().text.empty()) GTEST_SKIP() << "fire_ug.vtu is not there";
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), 12323u);
    EXPECT_EQ(mesh->counts.inFile, 10462);
    EXPECT_EQ(mesh->cellCount(), 10462u) << mesh->counts.text();
    EXPECT_EQ(mesh->pointFields.at(0).name, "t");
    EXPECT_NEAR(range(mesh->pointFields[0]).first, 298, 1);
    EXPECT_NEAR(range(mesh->pointFields[0]).second, 692, 1);
    EXPECT_EQ(mesh->pointFields.at(1).components, 3);
}

TEST_F(RealMeshes, fireThatShipsIsThatOfItsSource)
{
    const std::string path = VOLUMIZER_SOURCE_DIR "/data/meshes/fire.vtu";
    EXPECT_LT(std::filesystem::file_size(path), 300'000u);
    const auto mesh = vo::readMesh(path);
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), 12323u);
    EXPECT_EQ(mesh->cellCount(), 10462u);
    EXPECT_EQ(mesh->counts.skipped(), 0) << mesh->counts.text();
    ASSERT_EQ(mesh->pointFields.size(), 1u);
    EXPECT_EQ(mesh->pointFields[0].name, "t");
    EXPECT_NEAR(range(mesh->pointFields[0]).first, 298, 1);
    EXPECT_NEAR(range(mesh->pointFields[0]).second, 692, 1);
    const auto source = read("packaged/mayavi2/fire_ug.vtu");
    if (!source && source.failure().text.empty()) GTEST_SKIP() << "fire_ug.vtu is not there";
    ASSERT_TRUE(source) << source.failure().text;
    EXPECT_EQ(mesh->points, source->points);
    EXPECT_EQ(mesh->corners, source->corners);
    EXPECT_EQ(mesh->pointFields[0].values, source->pointFields.at(0).values);
}

TEST_F(RealMeshes, viewOfTetrahedra)
{
    const auto mesh = read("packaged/gmsh-doc/view3.pos.gz");
    if (!mesh && mesh.failure().text.empty()) GTEST_SKIP() << "view3.pos.gz is not there";
    ASSERT_TRUE(mesh) << mesh.failure().text;
    EXPECT_EQ(mesh->points.size(), 562u);
    EXPECT_EQ(mesh->cellCount(), 2504u);
    EXPECT_EQ(mesh->counts.text(), "");
    EXPECT_NEAR(range(mesh->pointFields.at(0)).first, -0.018, 5e-4);
    EXPECT_NEAR(range(mesh->pointFields[0]).second, 2.234, 5e-4);
    EXPECT_NEAR(volume(*mesh), 2 * 2 * 1, 1) << "of a box with a hole";
}

} // namespace
