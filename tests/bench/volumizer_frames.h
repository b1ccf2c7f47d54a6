#pragma once

#include "bench_scene.h"

#include "offscreen/offscreen.h"

#include <vo/Volumizer.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace bench {

struct FrameOptions
{
    Scene scene;
    std::string folder; ///< of volumes
    int bricksPerAxis = 1;
    bool newTables = false; ///< every frame has a table of its own
    bool perLength = true;  ///< opacities per length, else per slice
};

/// A scene drawn by drawUtility, into floats without a window.
class VolumizerFrames
{
public:
    explicit VolumizerFrames(const FrameOptions& options);

    /// Nearly the same opacities; a table of another content.
    void changeTable(int number);
    /// Returns when the frame is done.
    void draw(double turn);
    std::vector<float> picture();
    /// What was drawn last.
    std::vector<float> pixels() const { return context_->readFloats(); }
    /// Fragments that `drawing` makes.
    double countFragments(const std::function<void()>& drawing);

    /// Who drew all frames so far: "cast", "slices" or "both".
    std::string engine() const;

    const GladGLContext& gl() const { return context_->gl(); }
    std::string renderer() const { return context_->description(); }

private:
    void makeVolume(const Volume& voxels);
    void makeTetras();
    void setState();

    FrameOptions options_;
    std::unique_ptr<vo::OffscreenContext> context_;
    std::unique_ptr<voBrickSetCollection> volume_;
    std::vector<float> vertices_;
    std::vector<int> indices_;
    std::unique_ptr<voIndexedTetraSet> tetras_;
    Table entries_{};
    std::unique_ptr<voLookupTablePost> table_;
};

} // namespace bench
