#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "x3d/scene.h"

namespace vo {

/// What files may ask of a reader at most.
struct SceneLimits
{
    /// Nodes below each other.
    int depth = 200;
    /// Nodes in all files.
    std::size_t nodes = 4'000'000;
    /// Messages that are kept.
    std::size_t messages = 1000;
    /// Bytes of text, decompressed, in all files.
    std::int64_t bytes = std::int64_t(1) << 28;
    /// Files of Inline nodes, and how many of them inside each other.
    int inlines = 1000;
    int inlineDepth = 20;
};

/// Reads a scene in XML or ClassicVRML, told apart by its content, compressed by gzip or not, and what its
/// Inline nodes name: files below its own folder and what scene.folders allows. What is wrong or unknown
/// becomes messages of the scene and is left out. False where there is no scene at all: then the last message
/// says why.
bool readScene(Scene& scene, const std::string& path, const SceneLimits& limits = {});

/// The same from memory; `name` stands in messages. Files are looked for in scene.folders alone.
bool readSceneText(Scene& scene, std::string_view text, const std::string& name,
                   const SceneLimits& limits = {});

} // namespace vo
