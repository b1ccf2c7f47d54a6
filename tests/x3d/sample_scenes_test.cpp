// The scenes of data/scenes, one for each style and volume node, whose pictures are in docs/x3d.md.

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include <vo/x3d/View.h>

namespace {

const std::filesystem::path kFolder = std::filesystem::path(VOLUMIZER_SOURCE_DIR) / "data/scenes";

std::vector<std::filesystem::path> sceneFiles()
{
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder))
        if (entry.path().extension() == ".x3d") files.push_back(entry.path());
    return files;
}

bool read(voX3DScene& scene, const std::filesystem::path& file)
{
    scene.allowFolder((kFolder / "../volumes").c_str());
    return scene.read(file.c_str());
}

void addTypes(const voX3DNode& node, std::set<std::string>& types)
{
    types.insert(node.getTypeName());
    for (int i = 0; i < node.getFieldCount(); ++i) {
        const char* const field = node.getFieldName(i);
        const auto type = node.getFieldType(field);
        if (type != voX3DScope::SF_NODE && type != voX3DScope::MF_NODE) continue;
        for (int k = 0; k < node.getCount(field); ++k)
            addTypes(node.getNode(field, k), types);
    }
}

TEST(SampleScenes, areDrawnWithoutAMessageAndHaveTheirPicture)
{
    constexpr int kSize = 48;
    for (const auto& file : sceneFiles()) {
        voX3DScene scene;
        ASSERT_TRUE(read(scene, file)) << file;
        scene.check();
        voX3DView view(scene);
        view.setSize(kSize, kSize);
        std::vector<float> picture(4 * kSize * kSize);
        ASSERT_TRUE(view.picture(picture.data())) << file;
        for (int i = 0; i < scene.getMessageCount(); ++i)
            ADD_FAILURE() << scene.getMessage(i);
        // The sky is seen in a corner.
        double most = 0;
        for (std::size_t i = 0; i < picture.size(); ++i)
            most = std::max(most, double(std::abs(picture[i] - picture[i % 4])));
        EXPECT_GT(most, 0.1) << file;
        const auto shown = kFolder / "../../docs/pictures/x3d" / (file.stem().string() + ".png");
        EXPECT_TRUE(std::filesystem::exists(shown)) << shown << ": ./dev pictures draws it";
    }
}

TEST(SampleScenes, haveEveryStyleAndEveryVolumeNode)
{
    std::set<std::string> types;
    for (const auto& file : sceneFiles()) {
        voX3DScene scene;
        ASSERT_TRUE(read(scene, file)) << file;
        for (int i = 0; i < scene.getRootCount(); ++i)
            addTypes(scene.getRoot(i), types);
    }
    for (const char* const type :
         {"VolumeData", "SegmentedVolumeData", "IsoSurfaceVolumeData", "OctTree", "ImageTextureAtlas",
          "OpacityMapVolumeStyle", "BoundaryEnhancementVolumeStyle", "CartoonVolumeStyle",
          "ComposedVolumeStyle", "CompositeVolumeStyle", "EdgeEnhancementVolumeStyle",
          "ISOSurfaceVolumeStyle", "SilhouetteEnhancementVolumeStyle", "StippleVolumeStyle",
          "ToneMappedVolumeStyle", "BlendedVolumeStyle", "ProjectionVolumeStyle", "ShadedVolumeStyle"})
        EXPECT_TRUE(types.contains(type)) << type;
}

} // namespace
