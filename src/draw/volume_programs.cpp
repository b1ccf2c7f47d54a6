#include "draw/volume_programs.h"

#include "cast/padded_voxels.h"
#include "draw/scene_programs.h"
#include "draw/volume_shaders.h"
#include "style/surface_normals.h"

#include <algorithm>
#include <array>
#include <string>

namespace vo {

namespace {

bool needsNormal(std::span<const StyleChain> chains)
{
    return std::ranges::any_of(chains, [](const StyleChain& chain) {
        return std::ranges::any_of(chain, [](const auto& style) { return style->needsNormal(); });
    });
}

/// How many styles at the front of a chain read no normal.
std::ptrdiff_t countWithoutNormals(const StyleChain& chain)
{
    return std::ranges::find_if(chain, [](const auto& style) { return style->needsNormal(); }) -
           chain.begin();
}

/// Whether what is clear without normals is so with them.
bool keepsClear(std::span<const StyleChain> chains)
{
    return std::ranges::all_of(chains, [](const StyleChain& chain) {
        return std::all_of(chain.begin() + countWithoutNormals(chain), chain.end(),
                           [](const auto& style) { return style->keepsClear() && !style->replacesColor(); });
    });
}

/// Writes `vec4 withoutNormals(int chain, vec4 color, StyleSample s)` for the styles at the front of chains,
/// withNormals for those from the first on that reads one, and chainOf for both.
std::string writeChains(GlslChain& glsl, std::span<const StyleChain> chains)
{
    constexpr const char* kParameters = "(int chain, vec4 color, StyleSample s)\n{\n";
    std::string without = std::string("vec4 withoutNormals") + kParameters;
    std::string with = std::string("vec4 withNormals") + kParameters;
    for (std::size_t i = 0; i < chains.size(); ++i) {
        const auto writePart = [&](auto from, auto to, const std::string& name, std::string& choice) {
            std::for_each(from, to, [&glsl](const auto& style) { style->write(glsl); });
            glsl.endFunction(name);
            choice += "    if (chain == " + std::to_string(i) + ") return " + name + "(color, s);\n";
        };
        const std::string number = std::to_string(i);
        const auto middle = chains[i].begin() + countWithoutNormals(chains[i]);
        writePart(chains[i].begin(), middle, "front" + number, without);
        writePart(middle, chains[i].end(), "rest" + number, with);
    }
    constexpr const char* kEnd = "    return color;\n}\n";
    return without + kEnd + with + kEnd + "vec4 chainOf" + kParameters +
           "    return withNormals(chain, withoutNormals(chain, color, s), s);\n}\n";
}

/// `int chainAt(vec3 place)`: which chain a place has, or -1.
std::string chainAtText(const StyledVolume& volume)
{
    if (!volume.segments || volume.surfaces) return "int chainAt(vec3 place) { return 0; }\n";
    return R"(
uniform sampler3D identifiers, chainTable;
uniform float identifierScale;
uniform int chainsGiven, chainBeyond;
int chainAt(vec3 place)
{
    ivec3 size = textureSize(identifiers, 0), width = textureSize(chainTable, 0);
    ivec3 texel = clamp(ivec3(floor(place * vec3(size))), ivec3(0), size - 1);
    int id = int(texelFetch(identifiers, texel, 0)[)" +
           std::to_string(volume.segments->component) + R"(] * identifierScale + 0.5);
    if (id >= chainsGiven) return chainBeyond;
    return int(floor(texelFetch(chainTable, ivec3(id % width.x, id / width.x, 0), 0).r + 0.5));
}
)";
}

/// `float opacityOf(int chain, vec4 color, StyleSample s)`: of a projected sample.
std::string opacityOfText(const StyledVolume& volume)
{
    constexpr std::array kVoxelOpacities{"1.0", "s.voxel.g", "1.0", "s.voxel.a"};
    const std::string ofVoxel = kVoxelOpacities.at(static_cast<std::size_t>(volume.voxels->components) - 1);
    std::string text = "float opacityOf(int chain, vec4 color, StyleSample s)\n{\n";
    for (std::size_t i = 0; i < volume.chains.size(); ++i)
        if (volume.chains[i].empty())
            text += "    if (chain == " + std::to_string(i) + ") return " + ofVoxel + ";\n";
    return text + "    return color.a;\n}\n";
}

std::string define(const std::string& what)
{
    return "#define " + what + "\n";
}

std::string define(const std::string& what, std::size_t number)
{
    return define(what + " " + std::to_string(number));
}

bool takesWholeRays(VolumeWay way)
{
    return way == VolumeWay::rays || way == VolumeWay::projectedRays;
}

/// The functions and the main function that a way needs, after those of the chains.
std::string mainText(const StyledVolume& volume, VolumeWay way)
{
    const std::string chainAt = chainAtText(volume);
    switch (way) {
    case VolumeWay::slices:
        return volume.surfaces ? std::string(kSurfaceFunctions) + kSurfacesMain : chainAt + kSamplesMain;
    case VolumeWay::rays: break;
    case VolumeWay::projectedRays:
        return kRayFunctions + chainAt + opacityOfText(volume) + kJoinFunctions + kProjectionMain;
    case VolumeWay::planeSamples: return chainAt + opacityOfText(volume) + kPlaneSamplesMain;
    }
    const std::string walk = std::string(kRayFunctions) + kLeapFunctions;
    return volume.surfaces ? walk + kSurfaceFunctions + kMarchedSurfacesMain
                           : walk + chainAt + kMarchedSamplesMain;
}

/// Of what the main functions ask about.
std::string wayDefinitions(const StyledVolume& volume, const ProgramRequest& request)
{
    std::string text;
    if (takesWholeRays(request.way))
        text += define("WHOLE_RAYS") + define("CLIP_PLANES", volume.clipPlanes.size());
    if (request.way == VolumeWay::projectedRays)
        text += define("TYPE", static_cast<std::size_t>(volume.projection->type));
    if (request.mergedLater) text += define("MERGED_LATER");
    if (request.way != VolumeWay::rays) return text;
    text +=
        define("BLOCK_SHIFT", PaddedVoxels::kBlockShift) +
        define("CELL_SHIFT " + std::to_string(PaddedVoxels::kPadding - (volume.voxels->nearest ? 0.0 : 0.5)));
    return request.leaps ? text + define("LEAPS") : text;
}

} // namespace

bool isProjected(const StyledVolume& volume)
{
    return volume.projection && !volume.surfaces;
}

VolumeProgram volumeProgram(const StyledVolume& volume, const ProgramRequest& request)
{
    VolumeProgram program;
    const bool surfaces = volume.surfaces.has_value();
    std::vector<StyleChain> chains = surfaces ? volume.surfaces->chains : volume.chains;
    std::ranges::transform(chains, chains.begin(), effectiveChain);
    std::string definitions = "#version 330 core\n";
    if (volume.tetras) definitions += define("OWN_PLACES");
    program.vertexText =
        definitions + (takesWholeRays(request.way) ? kPictureVertexShader : kSliceVertexShader);
    const std::string components = std::to_string(volume.voxels->components);
    definitions += wayDefinitions(volume, request) + define("COMPONENTS " + components) +
                   define("firstColor firstColor" + components) + define("CHAINS", chains.size());
    if (surfaces) definitions += define("SURFACES", volume.surfaces->values.size());
    if (surfaces || needsNormal(chains)) definitions += define("NEEDS_NORMAL");
    if (keepsClear(chains)) definitions += define("KEEPS_CLEAR");
    const std::string choice = writeChains(program.chains, chains);
    if (surfaces)
        definitions +=
            define("SURFACE_NORMAL " + SurfaceNormals(volume.surfaces->gradients).write(program.chains));
    program.fragmentText = definitions + lightDeclarations(volume.surroundings.lights.size()) +
                           clipPlaneDeclarations(volume.clipPlanes.size()) + kStylePreamble +
                           kFirstColorGlsl + program.chains.declarations() + program.chains.functions() +
                           choice + kSampleFunctions + mainText(volume, request.way);
    return program;
}

} // namespace vo
