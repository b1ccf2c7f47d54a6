#pragma once

#include <set>

#include <vo/x3d/Scene.h>

#include "vox3d_options.h"

namespace vo {

/// Whether the content of a file is that of a scene: false where it can be no scene that is read.
bool isScene(const std::string& path);

/// Makes the scene of a volume: its node with the file as its voxels, the style of the options, a viewpoint,
/// and a light where the style takes one. Its urls are absolute paths. Options that change nothing, and those
/// that leave nothing to be seen, are told: then the answer is VolumeScene::toldEmpty.
enum class VolumeScene { seen, toldEmpty };
Result<VolumeScene> makeVolumeScene(voX3DScene& scene, const Vox3dOptions& options);

/// Lets the urls of a scene that makeVolumeScene made begin at the folder of the file that it is written to.
/// The folders outside of that, which who reads it must allow.
std::set<std::string> makeUrlsRelative(voX3DScene& scene, const std::string& output);

} // namespace vo
