#pragma once

#include "demos/common/offscreen/offscreen.h"

#include "support/reference.h"

#include <vo/Volumizer.h>

#include <memory>
#include <vector>

namespace vo::test {

/// How the library is asked to draw a Scene.
struct DrawOptions
{
    int bricks = 1;                          ///< a side; the volume's sizes need not divide
    bool utility = false;                    ///< drawUtility instead of the guide's own loops
    voEngine engine = voEngineScope::SLICES; ///< of drawUtility
    bool explicitTexCoords = false;          ///< T3F_V3F and xfmVox2TexCoords instead of texgen
    voDataType dataType = voDataTypeScope::UNSIGNED_BYTE;
    voExternalFormatType externalFormat =
        voExternalFormatTypeScope::DEFAULT; ///< from the channels of the field
    voInternalFormatType internalFormat = voInternalFormatTypeScope::DEFAULT;
};

/// A volume and everything that the guide's programs make for it; draws a Scene into the current framebuffer.
class SceneDrawing
{
public:
    SceneDrawing(const OffscreenContext& context, const Scene& scene, const DrawOptions& options);
    ~SceneDrawing();
    SceneDrawing(const SceneDrawing&) = delete;
    SceneDrawing& operator=(const SceneDrawing&) = delete;

    /// Sets matrices, colour and blending as the scene says, clears, and draws.
    void draw();
    /// The same with another view.
    void draw(const View& view);
    /// The same in another context, which is current.
    void drawIn(const OffscreenContext& other);

    voBrickSetCollection& volume() { return *volume_; }
    voIndexedTetraSet& tetras() { return *tetras_; }

private:
    void makeVolume();
    void makeGeometry();
    void makeTable();
    void setState(const View& view);
    void drawLoops(const View& view);

    const OffscreenContext* context_;
    Scene scene_;
    DrawOptions options_;
    bool core_ = false;
    std::unique_ptr<voBrickSetCollection> volume_;
    std::vector<float> vertices_;
    std::vector<int> indices_;
    std::unique_ptr<voIndexedTetraSet> tetras_;
    std::unique_ptr<voVertexData> sharedVertices_;
    std::vector<std::vector<std::unique_ptr<voIndexedFaceSet>>> faceSets_;
    std::vector<std::vector<voIndexedFaceSet*>> faceSetRows_;
    std::vector<voIndexedFaceSet**> faceSetArray_;
    std::unique_ptr<voLookupTable> table_;
    std::unique_ptr<voDrawActionCache> cache_; ///< where drawUtility cannot be told the surfaces otherwise
    int maxSamples_ = 0;
};

/// A scene drawn once into the 32-bit float framebuffer of `context`: four floats a pixel, rows from the
/// bottom.
std::vector<float> drawnPicture(const OffscreenContext& context, const Scene& scene,
                                const DrawOptions& options = {});

/// A context with a float framebuffer of the scene's size; the test fails when there is none.
std::unique_ptr<OffscreenContext> openFor(const Scene& scene, OffscreenProfile profile,
                                          bool floatColor = true);

} // namespace vo::test
