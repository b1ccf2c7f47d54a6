#pragma once

#include "appearance/cell_range_store.h"
#include "cast/cast_picture.h"
#include "cast/fill_polygons.h"
#include "cast/ray_cast.h"
#include "core/volume_size.h"
#include "draw/platform_context.h"
#include "lookup/table.h"

#include <glad/gl.h>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace vo {

/// What a driver needs done differently. Each flag is explained where it is set.
struct DriverQuirks
{
    /// 8-bit textures are filtered with 8-bit arithmetic: store them with 16 bits.
    bool filters8BitTexturesCoarsely = false;
    /// Textures of floats are filtered with weights as exact as floats: tables need no mixing in the shader.
    bool filtersFloatTexturesExactly = false;
    /// OpenGL runs on the processor: what we compute there ourselves costs less than what we draw.
    bool drawsOnProcessor = false;
};

/// A table as it stands now; load() replaces the entries and gives them a new serial number.
struct TableSlot
{
    Table table;
    std::uint64_t serial = 0; ///< 0: never loaded
};

/// Who draws frames: slices through OpenGL, or the CPU engine.
enum class Engine { slices, cast };

/// automatic: the CPU engine where OpenGL runs on the processor too.
enum class EngineChoice { automatic, slices, cast };

enum class TableKind { preInterpolation, postInterpolation };

/// A texture object and what it was made from.
struct ResidentTexture
{
    GLuint name = 0;
    GLenum target = GL_TEXTURE_3D;
    std::uint64_t version = 0;     ///< of the voxels
    std::uint64_t tableSerial = 0; ///< of the pre-interpolation table, 0 without
    bool oneChannel = false;       ///< answers with one channel, in red
    bool hasAlpha = true;          ///< in the sense of GL_REPLACE
};

/// A linked program and where its uniforms are (-1: not used).
struct Program
{
    GLuint name = 0;
    GLint clipFromObject = -1;
    GLint eyeFromObject = -1;
    GLint textureMatrix = -1;
    GLint currentColor = -1;
    GLint texgenPlanes = -1;
    GLint clipPlanes = -1;
    GLint viewer = -1;
    GLint sampleGauge = -1;
    GLint voxels = -1;
    GLint table = -1;
};

/// The program that takes all samples of a pixel at once, and where its uniforms are.
struct MarchProgram
{
    GLuint name = 0;
    GLint rectangle = -1;
    GLint middle = -1;
    GLint last = -1;
    GLint textureBase = -1;
    GLint textureStep = -1;
    GLint sampleBase = -1;
    GLint sampleStep = -1;
    GLint bounds = -1;
    GLint boundCount = -1;
    GLint upperBelongsElsewhere = -1;
    GLint currentColor = -1;
    GLint sampleGauge = -1;
    GLint cellSide = -1;
    GLint cellCount = -1;
    GLint alphaFrom = -1;
    GLint voxels = -1;
    GLint table = -1;
    GLint cells = -1;
};

/// The program that draws a finished picture.
struct PictureProgram
{
    GLuint name = 0;
    GLint rectangle = -1;
    GLint picture = -1;
    GLint alphas = -1;
    GLint corner = -1;
    GLint alphaFrom = -1;
};

/// Texels of a finished picture.
struct PictureTexture
{
    GLuint name = 0;
    int width = 0;
    int height = 0;
};

/// What a program of the core profile sets through voState, and what both profiles keep beside OpenGL's own
/// state.
struct ContextState
{
    glm::dmat4 model{1.0};
    glm::dmat4 projection{1.0};
    glm::dmat4 texture{1.0};
    glm::vec4 color{1.0f};
    std::array<glm::dvec4, 8> clipPlanes{};

    // Used in core contexts alone; in a compatibility context OpenGL has this state.
    GLenum enabledTarget = 0; ///< 0, GL_TEXTURE_2D or GL_TEXTURE_3D
    bool texgen = false;
    std::array<glm::vec4, 3> texgenPlanes{glm::vec4(1, 0, 0, 0), glm::vec4(0, 1, 0, 0),
                                          glm::vec4(0, 0, 1, 0)};

    std::shared_ptr<TableSlot> activeTables[2]; ///< by TableKind

    EngineChoice engine = EngineChoice::automatic;

    double unitLength = 0.0; ///< over which alpha is an opacity; 0: over a slice
    /// Of the face sets that the program draws itself (sampleGauge); nothing: their alpha is that of a slice.
    std::optional<glm::dmat3> sampleGauge;
};

/// Everything that belongs to one OpenGL context: its functions, its objects, its state.
class ContextRecord
{
public:
    explicit ContextRecord(const PlatformContext& platform, std::uint64_t serial);

    GladGLContext gl{};
    bool core = false; ///< core profile: no fixed-function state
    DriverQuirks quirks;
    int max3dSize = 0;
    int max2dSize = 0;

    ContextState state;
    std::unordered_map<std::uint64_t, ResidentTexture> textures; ///< by texture id
    std::unordered_map<GLuint, std::uint64_t> textureIds;        ///< by OpenGL's name
    std::map<unsigned, Program> programs;                        ///< by ProgramVariant::key
    GLuint vertexArray = 0;
    GLuint vertexBuffer = 0;
    GLuint indexBuffer = 0;
    std::uint64_t sentVertices = 0; ///< serial of what both buffers hold, 0: of none
    GLuint tableTexture = 0;
    std::uint64_t tableTextureSerial = 0;
    std::uint64_t downloads = 0; ///< textures sent so far

    std::map<unsigned, MarchProgram> marchPrograms; ///< by what march_samples.cpp makes of a variant
    GLuint cellTexture = 0;                         ///< distances between cells
    std::uint64_t cellTextureSerial = 0;

    PictureProgram pictureProgram;
    PictureTexture pictureColor;
    PictureTexture pictureAlpha;
    GLuint pictureVertexArray = 0; ///< without attributes, for march_samples.cpp too

    CellRangeStore cellRanges; ///< of bricks, by texture id
    RayCaster rayCaster;
    PolygonFiller polygonFiller;
    CastPicture picture;                        ///< of the last frame that was cast
    std::vector<float> depths;                  ///< of what is there, while a frame is cast
    std::array<std::uint64_t, 2> framesDrawn{}; ///< by Engine
    std::string whySlices;                      ///< the last reason told

    /// True when this record was made for the context that is current now.
    bool ownsCurrentContext() const;
    bool usable() const { return usable_; }
    /// Why the context cannot be used; empty when it can.
    const std::string& failure() const { return failure_; }
    void* handle() const { return handle_; }

    // What other threads ask of this context; done when it is current next, under the registry's lock.
    std::vector<std::uint64_t> doomedTextures; ///< ids
    std::vector<std::shared_ptr<TableSlot>> retiredTables;

private:
    void* handle_;
    std::uint64_t serial_;
    GLuint marker_ = 0; ///< a buffer of serial_ bytes: tells a new context at an old handle
    bool usable_ = false;
    std::string failure_;
};

/// The table of a kind that is active and loaded; nullptr without.
const TableSlot* activeTable(const ContextRecord& context, TableKind kind);

/// The record of the context that is current in this thread, made if need be, with everything that was put
/// off until now done; nullptr without a context. A context older than OpenGL 3.3 gives a record that is not
/// usable().
ContextRecord* currentContext();

/// Waits until OpenGL has done all that it was asked for.
void waitForOpenGl(const ContextRecord& context);

/// Deletes the texture objects of `textureId` in every context: now where it is current, else when it is
/// next.
void forgetTexture(std::uint64_t textureId);

/// Switches a table on (or, with an empty slot, its kind off) in the current context; without one, in the
/// context that is used next.
void activateTable(TableKind kind, std::shared_ptr<TableSlot> slot);
/// Switches it off wherever it is on.
void retireTable(const std::shared_ptr<TableSlot>& slot);

} // namespace vo
