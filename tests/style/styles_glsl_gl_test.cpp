// The GLSL of the styles against the reference: each pixel of a small picture is one sample.

#include "offscreen/offscreen.h"
#include "style/glsl_chain.h"
#include "style/texel_list.h"
#include "style_cases.h"

#include <glm/gtc/type_ptr.hpp>
#include <gtest/gtest.h>

namespace vo::test {
namespace {

constexpr int kSamples = 1000;

constexpr const char* kVertexText = R"(#version 330 core
void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }
)";

// What glsl_chain.h promises to styles.
constexpr const char* kPreamble = R"(#version 330 core
struct StyleSample { vec4 voxel; vec3 place, position, V, n; float gradient; };
struct StyleLight { int kind; vec3 color; float intensity, ambientIntensity; vec3 position, direction, attenuation;
                    float radius, beamWidth, cutOffAngle; };
const int kMostLights = 8;
uniform int lightCount;
uniform StyleLight lights[kMostLights];
vec4 styleTexture(sampler3D map, vec3 place) { return textureLod(map, place, 0.0); }
uniform sampler3D stackedTables;
)";

constexpr const char* kMain = R"(
uniform sampler2D samples;
layout(location = 0) out vec4 fragment;
vec4 row(int number) { return texelFetch(samples, ivec2(int(gl_FragCoord.x), number), 0); }
void main()
{
    vec4 place = row(2);
    StyleSample s = StyleSample(row(1), place.xyz, row(3).xyz, row(4).xyz, row(5).xyz, place.w);
    fragment = chainToTest(row(0), s);
}
)";

constexpr int kRows = 6;

/// Rows of the texture that kMain reads.
std::vector<glm::vec4> texelsOf(const std::vector<ReferenceSample>& samples)
{
    std::vector<glm::vec4> texels(samples.size() * kRows);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const ReferenceSample& s = samples[i];
        const std::array<glm::dvec4, kRows> rows{glm::dvec4(s.Cv, s.Ov),
                                                 s.voxel,
                                                 glm::dvec4(s.place, s.gradient),
                                                 glm::dvec4(s.position, 0.0),
                                                 glm::dvec4(s.V, 0.0),
                                                 glm::dvec4(s.n, 0.0)};
        for (std::size_t row = 0; row < kRows; ++row)
            texels[row * samples.size() + i] = glm::vec4(rows[row]);
    }
    return texels;
}

class StylesInGlsl : public testing::Test
{
protected:
    void SetUp() override
    {
        OffscreenRequest request;
        request.profile = OffscreenProfile::Core;
        request.width = kSamples;
        request.height = 1;
        request.floatColor = true;
        std::string whyNot;
        context_ = openOffscreen(request, &whyNot);
        ASSERT_TRUE(context_) << whyNot;
        GLuint vertexArray = 0;
        gl().GenVertexArrays(1, &vertexArray);
        gl().BindVertexArray(vertexArray);
        sendSamples(caseSamples());
    }

    const GladGLContext& gl() const { return context_->gl(); }
    std::vector<glm::vec4> drawn(const StyleCase& styleCase, GlslChain chain = {});

private:
    void sendSamples(const std::vector<ReferenceSample>& samples);
    GLuint shader(GLenum kind, const std::string& text);
    GLuint program(const GlslChain& chain);
    void bindTexture(int unit, const VoxelTexture& texture);
    void setUniform(GLuint program, const GlslChain::Uniform& uniform);
    void setLights(GLuint program, const std::vector<StyleLight>& lights);

    std::unique_ptr<OffscreenContext> context_;
};

void StylesInGlsl::sendSamples(const std::vector<ReferenceSample>& samples)
{
    const std::vector<glm::vec4> texels = texelsOf(samples);
    GLuint texture = 0;
    gl().GenTextures(1, &texture);
    gl().BindTexture(GL_TEXTURE_2D, texture);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl().TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    gl().TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(samples.size()), kRows, 0, GL_RGBA,
                    GL_FLOAT, texels.data());
}

GLuint StylesInGlsl::shader(GLenum kind, const std::string& text)
{
    const GLuint name = gl().CreateShader(kind);
    const char* const lines = text.c_str();
    gl().ShaderSource(name, 1, &lines, nullptr);
    gl().CompileShader(name);
    std::array<char, 4096> words{};
    gl().GetShaderInfoLog(name, words.size(), nullptr, words.data());
    GLint compiled = 0;
    gl().GetShaderiv(name, GL_COMPILE_STATUS, &compiled);
    EXPECT_TRUE(compiled) << words.data() << text;
    return name;
}

GLuint StylesInGlsl::program(const GlslChain& chain)
{
    const GLuint name = gl().CreateProgram();
    const GLuint vertex = shader(GL_VERTEX_SHADER, kVertexText);
    const GLuint fragment =
        shader(GL_FRAGMENT_SHADER, kPreamble + std::string(kFirstColorGlsl) + kListPlaceGlsl +
                                       chain.declarations() + chain.functions() + kMain);
    for (const GLuint each : {vertex, fragment}) {
        gl().AttachShader(name, each);
        gl().DeleteShader(each);
    }
    gl().LinkProgram(name);
    GLint linked = 0;
    gl().GetProgramiv(name, GL_LINK_STATUS, &linked);
    EXPECT_TRUE(linked);
    return name;
}

void StylesInGlsl::bindTexture(int unit, const VoxelTexture& texture)
{
    ASSERT_EQ(texture.kind, TexelKind::float32);
    constexpr std::array kInternal{GL_R32F, GL_RG32F, GL_RGB32F, GL_RGBA32F};
    constexpr std::array kFormats{GL_RED, GL_RG, GL_RGB, GL_RGBA};
    constexpr std::array kWraps{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R};
    const auto channels = static_cast<std::size_t>(texture.components - 1);
    GLuint name = 0;
    gl().GenTextures(1, &name);
    gl().ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl().BindTexture(GL_TEXTURE_3D, name);
    const GLint filter = texture.nearest ? GL_NEAREST : GL_LINEAR;
    gl().TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, filter);
    gl().TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, filter);
    gl().TexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAX_LEVEL, 0);
    for (std::size_t axis = 0; axis < 3; ++axis)
        gl().TexParameteri(GL_TEXTURE_3D, static_cast<GLenum>(kWraps[axis]),
                           texture.repeats[axis] ? GL_REPEAT : GL_CLAMP_TO_EDGE);
    gl().PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl().TexImage3D(GL_TEXTURE_3D, 0, kInternal[channels], texture.size.x, texture.size.y, texture.size.z, 0,
                    static_cast<GLenum>(kFormats[channels]), GL_FLOAT, texture.texels.data());
}

void StylesInGlsl::setUniform(GLuint program, const GlslChain::Uniform& uniform)
{
    const GLint at = gl().GetUniformLocation(program, uniform.name.c_str());
    struct Setter
    {
        const GladGLContext& gl;
        GLint at;
        void operator()(int value) const { gl.Uniform1i(at, value); }
        void operator()(float value) const { gl.Uniform1f(at, value); }
        void operator()(const glm::vec2& value) const { gl.Uniform2fv(at, 1, glm::value_ptr(value)); }
        void operator()(const glm::vec3& value) const { gl.Uniform3fv(at, 1, glm::value_ptr(value)); }
        void operator()(const glm::vec4& value) const { gl.Uniform4fv(at, 1, glm::value_ptr(value)); }
    };
    std::visit(Setter{gl(), at}, uniform.value);
}

void StylesInGlsl::setLights(GLuint program, const std::vector<StyleLight>& lights)
{
    setUniform(program, {"lightCount", static_cast<int>(lights.size())});
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const StyleLight& light = lights[i];
        const std::string name = "lights[" + std::to_string(i) + "].";
        setUniform(program, {name + "kind", static_cast<int>(light.kind)});
        setUniform(program, {name + "color", light.color});
        setUniform(program, {name + "intensity", light.intensity});
        setUniform(program, {name + "ambientIntensity", light.ambientIntensity});
        setUniform(program, {name + "position", light.position});
        setUniform(program, {name + "direction", light.direction});
        setUniform(program, {name + "attenuation", light.attenuation});
        setUniform(program, {name + "radius", light.radius});
        setUniform(program, {name + "beamWidth", light.beamWidth});
        setUniform(program, {name + "cutOffAngle", light.cutOffAngle});
    }
}

std::vector<glm::vec4> StylesInGlsl::drawn(const StyleCase& styleCase, GlslChain chain)
{
    for (const auto& style : styleCase.chain())
        style->write(chain);
    chain.endFunction("chainToTest");
    const GLuint name = program(chain);
    gl().UseProgram(name);
    for (const GlslChain::Uniform& uniform : chain.uniforms())
        setUniform(name, uniform);
    setLights(name, styleCase.surroundings.lights);
    int unit = 1; // 0 has the samples
    for (const GlslChain::Texture& texture : chain.textures()) {
        bindTexture(unit, *texture.texture);
        setUniform(name, {texture.name, unit++});
    }
    if (chain.tableStack() && !chain.tableStack()->empty()) {
        bindTexture(unit, chain.tableStack()->texture());
        setUniform(name, {"stackedTables", unit});
    }
    gl().DrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_EQ(gl().GetError(), GLenum{GL_NO_ERROR});
    const std::vector<float> floats = context_->readFloats();
    std::vector<glm::vec4> colors;
    for (std::size_t i = 0; i < floats.size(); i += 4)
        colors.push_back(glm::make_vec4(floats.data() + i));
    gl().UseProgram(0);
    gl().DeleteProgram(name);
    return colors;
}

TEST_F(StylesInGlsl, agreeWithTheReferenceSampleBySample)
{
    const std::vector<ReferenceSample> samples = caseSamples();
    ASSERT_EQ(samples.size(), static_cast<std::size_t>(kSamples));
    for (const StyleCase& styleCase : styleCases()) {
        const double likeness = psnr(referenceColors(styleCase, samples), drawn(styleCase));
        EXPECT_GT(likeness, 80.0) << styleCase.name;
    }
}

/// Tables that no style asks for lie before and behind those of each style.
TEST_F(StylesInGlsl, agreeWithTheReferenceWhereTablesAreStacked)
{
    const std::vector<ReferenceSample> samples = caseSamples();
    int stacked = 0;
    for (const StyleCase& styleCase : styleCases()) {
        const auto tables = std::make_shared<TableStack>();
        GlslChain unused(tables);
        const auto addOther = [&] {
            auto other = std::make_shared<VoxelTexture>();
            other->size = {3, 100, 1};
            other->kind = TexelKind::float32;
            other->texels.assign(300 * sizeof(float), std::byte{0x45});
            tables->write(unused, other, 1, "");
        };
        addOther();
        for (const auto& style : styleCase.chain()) {
            GlslChain first(tables);
            style->write(first);
        }
        stacked += static_cast<int>(tables->serials().size()) - 1;
        addOther();
        const double likeness =
            psnr(referenceColors(styleCase, samples), drawn(styleCase, GlslChain(tables)));
        EXPECT_GT(likeness, 80.0) << styleCase.name;
    }
    EXPECT_GT(stacked, 5);
}

} // namespace
} // namespace vo::test
