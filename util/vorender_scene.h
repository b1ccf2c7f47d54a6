#pragma once

#include "vorender_volume.h"

#include "volume_view/lookup_file.h"

#include "cast/cast_request.h"

#include <array>
#include <optional>

namespace vo {

/// A volume with its table and its place: what pictures of all views share.
class VolumeScene
{
public:
    /// Refuses, as voglBasic does, what would take minutes. `table`: that of -lutFile.
    static Result<VolumeScene> make(LoadedVolume volume, const Options& options,
                                    const std::optional<LookupFile>& table);

    const LoadedVolume& volume() const { return volume_; }
    const Options& options() const { return options_; }

private:
    friend class SceneView;
    VolumeScene(LoadedVolume volume, const Options& options) : volume_(std::move(volume)), options_(options)
    {
    }
    void makeTable(const std::optional<LookupFile>& file);
    void makeCorners();

    LoadedVolume volume_;
    Options options_;
    std::array<float, 3> scale_{1, 1, 1};
    std::optional<Table> table_;
    std::array<float, 24> corners_{};
    int maxSamples_ = 1;
};

/// One view of a scene, for the engine. The scene has to outlive it.
class SceneView
{
public:
    /// The view of the options, turned by `degrees` more about the volume's z axis.
    SceneView(const VolumeScene& scene, double degrees);
    SceneView(const SceneView&) = delete;
    SceneView& operator=(const SceneView&) = delete;

    const CastRequest& request() const { return request_; }

private:
    void setMatrices(const VolumeScene& scene, double degrees);
    void setSampling(const VolumeScene& scene);
    void setBrick(const VolumeScene& scene);

    Box clipBox_;
    CastBrick brick_;
    CastRequest request_;
};

} // namespace vo
