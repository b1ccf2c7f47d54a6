#include "draw/volume_programs.h"

#include "cast/padded_voxels.h"
#include "draw/ray_hits.h"
#include "draw/scene_programs.h"
#include "draw/volume_shaders.h"
#include "style/surface_normals.h"
#include "style/texel_list.h"

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
    ivec3 size = textureSize(identifiers, 0);
    ivec3 texel = clamp(ivec3(floor(place * vec3(size))), ivec3(0), size - 1);
    int id = int(texelFetch(identifiers, texel, 0)[)" +
           std::to_string(volume.segments->component) + R"(] * identifierScale + 0.5);
    if (id < 0 || id >= chainsGiven) return chainBeyond;
    return int(floor(texelFetch(chainTable, listPlace(id), 0).r + 0.5));
}
)";
}

/// `float opacityOf(int chain, vec4 color, StyleSample s)`: of a projected sample. Chains without styles are
/// of one kind, so that their numbers follow each other.
std::string opacityOfText(const StyledVolume& volume, const std::vector<int>& numberOf)
{
    constexpr std::array kVoxelOpacities{"1.0", "s.voxel.g", "1.0", "s.voxel.a"};
    const std::string ofVoxel = kVoxelOpacities.at(static_cast<std::size_t>(volume.voxels->components) - 1);
    std::string text = "float opacityOf(int chain, vec4 color, StyleSample s)\n{\n";
    const auto isEmpty = [](const StyleChain& chain) { return chain.empty(); };
    if (const auto first = std::ranges::find_if(volume.chains, isEmpty); first != volume.chains.end()) {
        const int begin = numberOf[static_cast<std::size_t>(first - volume.chains.begin())];
        const auto count = std::ranges::count_if(volume.chains, isEmpty);
        text += "    if (chain >= " + std::to_string(begin) + " && chain < " + std::to_string(begin + count) +
                ") return " + ofVoxel + ";\n";
    }
    return text + "    return color.a;\n}\n";
}

/// `int chainOfSurface[]`.
std::string surfaceChainsText(const IsoSurfaces& surfaces, const std::vector<int>& numberOf)
{
    std::string numbers;
    for (std::size_t i = 0; i < surfaces.values.size(); ++i)
        numbers += (i == 0 ? "" : ", ") + std::to_string(numberOf[std::min(i, numberOf.size() - 1)]);
    return "const int chainOfSurface[SURFACES] = int[SURFACES](" + numbers + ");\n";
}

// Of those that do not use it, the driver knows nothing.
constexpr const char* kChainTextures = "uniform sampler3D chainNumbers, stackedTables;\n";

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
std::string mainText(const StyledVolume& volume, const ProgramRequest& request,
                     const std::vector<int>& numberOf)
{
    const std::string chainAt = chainAtText(volume);
    const std::string surfaces =
        volume.surfaces ? surfaceChainsText(*volume.surfaces, numberOf) + kSurfaceFunctions : "";
    const std::string projected =
        isProjected(volume) ? chainAt + opacityOfText(volume, numberOf) + kProjectedSample : "";
    const std::string reached = request.part == RayReach::whole ? "" : kReachedGlsl;
    switch (request.way) {
    case VolumeWay::slices: return volume.surfaces ? surfaces + kSurfacesMain : chainAt + kSamplesMain;
    case VolumeWay::rays: break;
    case VolumeWay::projectedRays:
        return reached + kRayFunctions + projected + kJoinFunctions + kProjectionMain;
    case VolumeWay::planeSamples: return projected + kPlaneSamplesMain;
    }
    const std::string walk = reached + kRayFunctions + kWalkFunctions;
    if (!volume.surfaces) return walk + chainAt + kMarchedSamplesMain;
    const std::string crossings = walk + surfaces + kCrossingFunctions;
    if (request.part == RayReach::nextHit) return crossings + kNextSurfaceMain;
    return crossings + kMarchedSurfacesMain;
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
    if (request.part == RayReach::betweenHits) text += define("BETWEEN_HITS");
    if (request.part == RayReach::nextHit) text += define("NEXT_HIT");
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
                   define("firstColor firstColor" + components);
    if (surfaces) definitions += define("SURFACES", volume.surfaces->values.size());
    if (surfaces || needsNormal(chains)) definitions += define("NEEDS_NORMAL");
    if (keepsClear(chains)) definitions += define("KEEPS_CLEAR");
    if (chains.size() > 1) program.chains = GlslChain(std::make_shared<TableStack>());
    ChainFunctions functions = writeChains(program.chains, chains);
    if (surfaces)
        definitions +=
            define("SURFACE_NORMAL " + SurfaceNormals(volume.surfaces->gradients).write(program.chains));
    program.fragmentText = definitions + lightDeclarations(volume.surroundings.lights.size()) +
                           clipPlaneDeclarations(volume.clipPlanes.size()) + kStylePreamble +
                           kFirstColorGlsl + kListPlaceGlsl + kChainTextures + program.chains.declarations() +
                           program.chains.functions() + functions.text + kSampleFunctions +
                           mainText(volume, request, functions.numberOf);
    program.chainNumberOf = std::move(functions.numberOf);
    program.chainRows = std::move(functions.rows);
    return program;
}

} // namespace vo
