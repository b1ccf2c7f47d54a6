// What a program's own volume keeps from picture to picture: nothing is sent to OpenGL again while only the
// camera moves, whatever changes is seen, and nothing stays behind.

#include "program_volume.h" // before headers that name OpenGL's own

#include <array>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace {

using namespace program_volume;

using Names = std::set<GLuint>;

/// All objects of OpenGL that the context has. Drivers give small numbers.
std::map<std::string, Names> objectsOf(const GladGLContext& gl)
{
    const std::pair<const char*, std::function<GLboolean(GLuint)>> kinds[] = {
        {"textures", gl.IsTexture},
        {"buffers", gl.IsBuffer},
        {"vertex arrays", gl.IsVertexArray},
        {"framebuffers", gl.IsFramebuffer},
        {"renderbuffers", gl.IsRenderbuffer},
        {"programs", gl.IsProgram},
        {"shaders", gl.IsShader},
        {"samplers", gl.IsSampler},
        {"queries", gl.IsQuery},
    };
    std::map<std::string, Names> found;
    for (const auto& [kind, is] : kinds)
        for (GLuint name = 1; name < 4096; ++name)
            if (is(name)) found[kind].insert(name);
    return found;
}

/// The middle of the volume, 8 x 3 x 3 voxels of it, of which shadows are soon there; lit, with shadows,
/// after a map of 4 texels.
struct ShadedMiddle
{
    ShadedMiddle()
    {
        setImage(0xffff);
        map.setNode("transferFunction", pixels);
        shaded.setInt("lighting", 1);
        shaded.setInt("shadows", 1);
        const voX3DNode steps[] = {map, shaded};
        chain.setNodes("renderStyle", steps, 2);
    }

    void setImage(int last)
    {
        const int image[] = {4, 1, 2, 0xff00, 0xff60, 0xc0a0, last};
        pixels.setInts("image", image, 7);
    }

    std::unique_ptr<voX3DStyledVolume> in(const voX3DNode& style)
    {
        return std::make_unique<voX3DStyledVolume>(scene, style, &voxels.bricks, &tetras);
    }

    /// Lit along x alone.
    std::unique_ptr<voX3DStyledVolume> lit()
    {
        auto volume = in(chain);
        volume->setHeadlight(VO_FALSE);
        volume->addLight(-1, 0, 0, 1);
        return volume;
    }

    Voxels voxels;
    float corners[24] = {0, 2, 2, 8, 2, 2, 0, 5, 2, 8, 5, 2, 0, 2, 5, 8, 2, 5, 0, 5, 5, 8, 5, 5};
    int indices[20] = {0, 3, 5, 6, 1, 3, 5, 0, 2, 3, 0, 6, 4, 5, 6, 0, 7, 3, 6, 5};
    voIndexedTetraSet tetras{corners, 8, 3, indices, 20};
    voX3DScene scene;
    voX3DNode pixels = scene.createNode("PixelTexture"), map = scene.createNode("OpacityMapVolumeStyle"),
              shaded = scene.createNode("ShadedVolumeStyle"), chain = scene.createNode("ComposedVolumeStyle");
};

class StyledVolumeCache : public ProgramScreen
{
protected:
    /// The textures of three dimensions that have so many texels along x, and are not among `before`.
    Names texturesOf(int width, const Names& before = {})
    {
        const Names all = objectsOf(gl())["textures"];
        Names found;
        for (const GLuint name : all) {
            GLint texels = 0;
            gl().BindTexture(GL_TEXTURE_3D, name);
            if (gl().GetError() != GL_NO_ERROR) continue; // of other dimensions
            gl().GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &texels);
            if (texels == width && !before.contains(name)) found.insert(name);
        }
        gl().BindTexture(GL_TEXTURE_3D, 0);
        return found;
    }

    /// Makes all texels of a texture 0, so that whoever does not send it anew draws with zeros.
    void spoil(GLuint name)
    {
        GLint size[3];
        gl().BindTexture(GL_TEXTURE_3D, name);
        gl().GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_WIDTH, &size[0]);
        gl().GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_HEIGHT, &size[1]);
        gl().GetTexLevelParameteriv(GL_TEXTURE_3D, 0, GL_TEXTURE_DEPTH, &size[2]);
        const std::vector<unsigned char> zeros(std::size_t(size[0]) * std::size_t(size[1]) *
                                               std::size_t(size[2]) * 4);
        gl().TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, 0, size[0], size[1], size[2], GL_RGBA, GL_UNSIGNED_BYTE,
                           zeros.data());
        gl().BindTexture(GL_TEXTURE_3D, 0);
        ASSERT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
    }

    std::vector<float> sliced(voX3DStyledVolume& volume, const glm::dmat4& model)
    {
        context_->clear();
        return drawn(volume, model, projection_, voEngineScope::SLICES);
    }

    /// The sum of one channel.
    static double total(const std::vector<float>& picture, std::size_t channel)
    {
        double sum = 0.0;
        for (std::size_t i = channel; i < picture.size(); i += 4)
            sum += static_cast<double>(picture[i]);
        return sum;
    }

    const glm::dmat4 projection_ = glm::ortho(-8.0, 8.0, -8.0, 8.0, 1.0, 30.0);
    const glm::dmat4 aside_ = glm::translate(glm::dmat4(1.0), glm::dvec3(1.5, 0.5, 0.2)) * turned();
    const glm::dmat4 round_ = glm::rotate(turned(), 0.4, glm::dvec3(0.0, 1.0, 0.0));
};

INSTANTIATE_TEST_SUITE_P(Profiles, StyledVolumeCache, vo::test::kBothProfiles, vo::test::profileName);

TEST_P(StyledVolumeCache, nothingIsSentAgainWhileOnlyTheCameraMoves)
{
    ShadedMiddle middle;
    const auto lit = middle.lit();
    voX3DStyledVolume& volume = *lit;
    EXPECT_GT(total(sliced(volume, turned()), 3), 10.0);
    const Names all = objectsOf(gl())["textures"];
    const std::map<int, const char*> kinds{{kVoxels, "voxels"}, {4, "transfer function"}, {128, "shadows"}};
    for (const auto& [width, kind] : kinds)
        EXPECT_EQ(texturesOf(width).size(), 1u) << kind;
    // Shadows are of lights, which go with the eye: a turn makes new ones, a shift does not.
    spoil(*texturesOf(128).begin());
    const std::vector<float> dark = sliced(volume, aside_);
    EXPECT_LT(total(dark, 0), 1e-3) << "in the shadow of what was spoilt";
    EXPECT_GT(total(dark, 3), 10.0);
    EXPECT_EQ(objectsOf(gl())["textures"], all);
    EXPECT_GT(total(sliced(volume, round_), 0), 1.0);
    for (const int width : {4, kVoxels}) {
        const Names found = texturesOf(width);
        ASSERT_EQ(found.size(), 1u) << kinds.at(width);
        spoil(*found.begin());
        EXPECT_LT(total(sliced(volume, aside_), 3), 1e-3) << kinds.at(width);
        EXPECT_LT(total(sliced(volume, round_), 3), 1e-3) << kinds.at(width);
        // What stands in their place is sent.
        if (width == 4)
            middle.setImage(0xfffe);
        else
            volume.update();
        EXPECT_GT(total(sliced(volume, aside_), 3), 10.0) << kinds.at(width);
    }
}

/// One thing that a program changes in what it has given.
struct Change
{
    const char* what;
    std::function<void(voX3DStyledVolume&)> make;
};

TEST_P(StyledVolumeCache, whatIsChangedShowsInTheNextPicture)
{
    ShadedMiddle middle;
    bool isLitFromAbove = false;
    const auto made = [&] {
        auto volume = middle.lit();
        if (isLitFromAbove) volume->addLight(0, -1, 0, 0.5f);
        return volume;
    };
    const Change changes[] = {
        {"a field of a style", [&](auto&) { middle.shaded.setInt("shadows", 0); }},
        {"shadows", [&](auto&) { middle.shaded.setInt("shadows", 1); }},
        {"pixels of a texture", [&](auto&) { middle.setImage(0xff80); }},
        {"a step of the chain", [&](auto&) { middle.map.setNode("transferFunction", voX3DNode()); }},
        {"voxels",
         [&](auto& volume) {
             std::fill_n(middle.voxels.values.begin() + 200, 100, static_cast<unsigned char>(250));
             volume.update();
         }},
        {"a light",
         [&](auto& volume) {
             volume.addLight(0, -1, 0, 0.5f);
             isLitFromAbove = true;
         }},
    };
    const auto kept = made();
    const auto pictureOf = [&](voX3DStyledVolume& volume, voEngine engine) {
        context_->clear();
        return drawn(volume, turned(), projection_, engine);
    };
    std::array<std::vector<float>, 2> before{pictureOf(*kept, kEngines[0]), pictureOf(*kept, kEngines[1])};
    for (const Change& change : changes) {
        change.make(*kept);
        const auto fresh = made();
        for (std::size_t i = 0; i < 2; ++i) {
            const std::vector<float> now = pictureOf(*kept, kEngines[i]);
            EXPECT_NE(now, before[i]) << change.what << ", engine " << kEngines[i];
            EXPECT_EQ(now, pictureOf(*fresh, kEngines[i])) << change.what << ", engine " << kEngines[i];
            before[i] = now;
        }
    }
}

TEST_P(StyledVolumeCache, noObjectsStayBehind)
{
    ShadedMiddle middle;
    const voX3DNode styles[] = {voX3DNode(), middle.chain, middle.scene.createNode("ProjectionVolumeStyle")};
    const auto before = objectsOf(gl());
    for (const voX3DNode& style : styles)
        for (const bool isReleased : {false, true}) {
            auto volume = middle.in(style);
            for (const voEngine engine : kEngines) {
                sliced(*volume, turned());
                drawn(*volume, turned(), projection_, engine);
            }
            EXPECT_GT(objectsOf(gl())["textures"].size(), 1u);
            if (isReleased)
                volume->releaseDrawing();
            else
                volume.reset();
            EXPECT_EQ(objectsOf(gl()), before) << (isReleased ? "released" : "destroyed");
            EXPECT_EQ(gl().GetError(), GLenum(GL_NO_ERROR));
        }
}

} // namespace
