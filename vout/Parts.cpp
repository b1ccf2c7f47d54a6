#include <vo/utParts.h>

#include "legacy/report.h"

#include "vout/part_slices.h"
#include "vout/transform_mesh.h"

#include <vo/State.h>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

struct Part
{
    voIndexedTetraSet* tetras;
    voInterleavedArrayType format;
    voBrickSetCollection* volume;
    glm::dmat4 matrix{1};
    std::optional<glm::vec4> color;
    voLookupTable* table = nullptr;
    bool visible = true;

    // Of the frame.
    vo::TetraMesh placed;
    vo::PartSlices slices;

    voInterleavedArrayType placedFormat() const { return vo::placedFormat(format, color.has_value()); }
    bool isStack() const { return volume->getInterpolationType() == voInterpolationTypeScope::_2D; }
    voBrickSet* bricks() const { return volume->getCurrentBrickSet(); }
};

/// What a program asks of a frame.
struct PartsRequest
{
    GLdouble* model;
    GLdouble* projection;
    voSamplingMode mode;
    voSamplingSpace space;
    float* period;
    int maxSamples;
};

void requireMatrix(const GLdouble* matrix, const char* name)
{
    required(matrix, name);
    const double volume = glm::determinant(glm::make_mat4(matrix));
    if (volume == 0 || !std::isfinite(volume)) badValue(std::string(name) + " is singular");
}

void check(const PartsRequest& request)
{
    requireMatrix(request.model, "modelMatrix");
    requireMatrix(request.projection, "projMatrix");
    if (request.mode < voSamplingModeScope::DEFAULT - 1 || request.mode > voSamplingModeScope::SPHERICAL)
        vo::badEnum("voSamplingMode has no value " + std::to_string(request.mode));
    if (request.space < voSamplingSpaceScope::DEFAULT - 1 || request.space > voSamplingSpaceScope::PRIMITIVE)
        vo::badEnum("voSamplingSpace has no value " + std::to_string(request.space));
    if (request.space == voSamplingSpaceScope::PRIMITIVE)
        vo::unsupported("in PRIMITIVE space parts have no planes in common");
    for (int axis = 0; request.period && axis < 3; ++axis)
        if (!(request.period[axis] > 0) || !std::isfinite(request.period[axis]))
            badValue("a sampling period is not above 0");
    if (request.maxSamples < 1)
        badValue("at most " + std::to_string(request.maxSamples) + " samples, 1 or more are needed");
}

/// The axis across the slices of a stack.
int axisAcross(voPlaneOrientation orientation)
{
    return orientation == voPlaneOrientationScope::YZ ? 0 : orientation == voPlaneOrientationScope::XZ ? 1 : 2;
}

void requireUpright(const Part& part, int axis)
{
    for (int other = 0; other < 3; ++other)
        if (other != axis && std::abs(part.matrix[other][axis]) > 1e-9 * std::abs(part.matrix[axis][axis]))
            vo::unsupported("a matrix tilts the slices of a stack");
}

/// Takes texturing, tables and the step of samples from one part to the next, and leaves them off.
class DrawingState
{
public:
    DrawingState() = default;
    DrawingState(const DrawingState&) = delete;
    DrawingState& operator=(const DrawingState&) = delete;
    ~DrawingState()
    {
        noTable_.disable();
        noTableBefore_.disable();
        if (texturing_ != kNone) voAppearanceActions::textureDisable(texturing_);
        voState::resetSampling();
    }

    void use(const Part& part)
    {
        if (&part == part_) return;
        part_ = &part;
        useTexturing(part.volume->getInterpolationType());
        const bool isBefore = part.table && part.table->getType() == voLookupTableTypeScope::PRE_INTERPOLATION;
        if (!part.table || isBefore) noTable_.disable();
        if (!part.table || !isBefore) noTableBefore_.disable();
        if (part.table) part.table->enable();
    }

private:
    static constexpr voInterpolationType kNone = voInterpolationTypeScope::DEFAULT;

    void useTexturing(voInterpolationType type)
    {
        if (type == texturing_) return;
        if (texturing_ != kNone) voAppearanceActions::textureDisable(texturing_);
        voAppearanceActions::textureEnable(type);
        voAppearanceActions::texgenDisable();
        texturing_ = type;
    }

    const Part* part_ = nullptr;
    voInterpolationType texturing_ = kNone;
    // Any table switches its kind off.
    voLookupTablePost noTable_{voInternalFormatTypeScope::RGBA8_EXT, 2, voExternalFormatTypeScope::RGBA,
                               voDataTypeScope::FLOAT};
    voLookupTablePre noTableBefore_{voInternalFormatTypeScope::RGBA8_EXT, 2, voExternalFormatTypeScope::RGBA,
                                    voDataTypeScope::FLOAT};
};

/// A mesh as the arguments of a set on its own arrays.
class SetOn
{
public:
    explicit SetOn(vo::TetraMesh& mesh)
        : set_(mesh.records.data(), static_cast<int>(mesh.vertexCount()), mesh.values, mesh.tetras.data(),
               static_cast<int>(mesh.tetras.size()))
    {
    }
    voIndexedTetraSet* get() { return &set_; }

private:
    voIndexedTetraSet set_;
};

/// The tetrahedra of a mesh appended to another of the same records.
void append(const vo::TetraMesh& mesh, vo::TetraMesh& all)
{
    const auto first = static_cast<int>(all.vertexCount());
    all.records.insert(all.records.end(), mesh.records.begin(), mesh.records.end());
    for (const int vertex : mesh.tetras)
        all.tetras.push_back(first + vertex);
}

/// The positions alone, behind `front` values in front of them.
vo::TetraMesh positionsOf(const vo::TetraMesh& mesh, const std::vector<float>& front = {})
{
    vo::TetraMesh positions;
    positions.values = static_cast<int>(front.size()) + 3;
    positions.tetras = mesh.tetras;
    for (int vertex = 0; vertex < static_cast<int>(mesh.vertexCount()); ++vertex) {
        const float* end = mesh.record(vertex) + mesh.values;
        positions.records.insert(positions.records.end(), front.begin(), front.end());
        positions.records.insert(positions.records.end(), end - 3, end);
    }
    return positions;
}

/// One frame. Each step answers false where an error was reported.
class PartsFrame
{
public:
    PartsFrame(const std::vector<std::unique_ptr<Part>>& parts, const PartsRequest& request) : request_(request)
    {
        for (const auto& part : parts) {
            if (!part->visible) continue;
            part->placed = vo::placed(vo::meshOf(*part->tetras), part->format, part->matrix, part->color);
            if (!part->placed.tetras.empty()) visible_.push_back(part.get());
        }
        for (const Part* part : visible_)
            append(positionsOf(part->placed), all_);
    }

    bool draw()
    {
        if (visible_.empty()) return true;
        chooseStacks();
        if (!polygonize()) return false;
        return drawPlanes();
    }

private:
    void chooseStacks();
    bool polygonize();
    bool polygonizePlanes();
    bool polygonizeShells();
    bool drawPlanes();

    PartsRequest request_;
    std::vector<Part*> visible_;
    vo::TetraMesh all_; ///< the positions of all, which decide where the surfaces lie
    voBrickSet* oriented_ = nullptr; ///< bricks of a stack, if there are any, which say what it is across
    int planes_ = 0;
};

/// Of each stack the slices that lie most across the view, in the space of all.
void PartsFrame::chooseStacks()
{
    oriented_ = visible_[0]->bricks();
    if (std::none_of(visible_.begin(), visible_.end(), [](const Part* part) { return part->isStack(); })) return;
    request_.mode = voSamplingModeScope::AXIS_ALIGNED;
    const voPlaneOrientation orientation =
        voGeometryActions::findClosestAxisIndex(request_.model, request_.projection, request_.mode);
    for (const Part* part : visible_) {
        if (!part->isStack()) continue;
        requireUpright(*part, axisAcross(orientation));
        part->volume->setCurrentBrickSet(orientation);
        oriented_ = part->bricks();
    }
}

bool PartsFrame::polygonize()
{
    double eye[3], direction[4];
    voGeometryActions::findCameraPosition(eye, direction, request_.model, request_.projection);
    const bool shells = request_.mode == voSamplingModeScope::SPHERICAL && direction[3] != 0;
    if (!(shells ? polygonizeShells() : polygonizePlanes())) return false;
    for (Part* part : visible_)
        voAppearanceActions::xfmVox2TexCoords(part->bricks(), planes_, part->slices.sets(), part->placedFormat());
    return true;
}

bool PartsFrame::polygonizePlanes()
{
    SetOn all(all_);
    voSamplingPlaneSet planes(all.get(), oriented_, request_.model, request_.projection, request_.mode,
                              request_.space, request_.period, request_.maxSamples);
    const int count = planes.getSurfaceCount();
    for (Part* part : visible_) {
        SetOn set(part->placed);
        part->slices.fit(part->bricks()->getBrickCount(), count, part->placed.values);
        if (voGeometryActions::polygonize(set.get(), part->bricks(), part->placedFormat(), &planes, count, planes_,
                                          part->slices.sets()))
            return false;
    }
    return true;
}

/// Where shells lie depends on the tetrahedra: each part is cut together with all others, whose voxel coordinates are
/// outside of its volume.
bool PartsFrame::polygonizeShells()
{
    for (Part* part : visible_) {
        vo::TetraMesh together = part->placed;
        const std::vector<float> outside(static_cast<std::size_t>(together.values) - 3, -1.0f);
        for (const Part* other : visible_)
            if (other != part) append(positionsOf(other->placed, outside), together);
        SetOn set(together);
        part->slices.fit(part->bricks()->getBrickCount(), request_.maxSamples, together.values);
        if (voGeometryActions::polygonize(set.get(), part->bricks(), part->placedFormat(), request_.model,
                                          request_.projection, request_.mode, request_.space, request_.period,
                                          request_.maxSamples, planes_, part->slices.sets()))
            return false;
    }
    return true;
}

bool PartsFrame::drawPlanes()
{
    SetOn all(all_);
    DrawingState state;
    voState::setSampling(all.get(), oriented_, request_.model, request_.projection, request_.mode,
                         request_.space, request_.period, request_.maxSamples);
    for (int plane = 0; plane < planes_; ++plane)
        for (const Part* part : visible_)
            for (int brick = 0; brick < part->bricks()->getBrickCount(); ++brick) {
                voIndexedFaceSet* polygons = part->slices.of(brick, plane);
                if (polygons->getIndices()->getCount() == 0) continue;
                state.use(*part);
                if (voAppearanceActions::textureBind(part->bricks()->getBrick(brick))) return false;
                voGeometryActions::draw(polygons, part->placedFormat());
            }
    return true;
}

} // namespace

struct voutParts::Private
{
    std::vector<std::unique_ptr<Part>> parts;

    Part& at(int part)
    {
        if (part < 0 || static_cast<std::size_t>(part) >= parts.size())
            badValue("part " + std::to_string(part) + " of " + std::to_string(parts.size()));
        return *parts[static_cast<std::size_t>(part)];
    }
};

voutParts::voutParts() : d(new Private)
{
}

voutParts::~voutParts()
{
    delete d;
}

int voutParts::add(voIndexedTetraSet* tetraSet, voInterleavedArrayType format, voBrickSetCollection* volume)
{
    const auto number = static_cast<int>(d->parts.size());
    const int failed = guarded("voutParts::add", [&] {
        Part part;
        part.tetras = &required(tetraSet, "tetraSet");
        part.volume = &required(volume, "volume");
        part.format = format;
        vo::placed(vo::meshOf(*tetraSet), format, part.matrix); // or it would be refused at every frame
        d->parts.push_back(std::make_unique<Part>(std::move(part)));
    });
    return failed ? -1 : number;
}

int voutParts::getCount() const
{
    return static_cast<int>(d->parts.size());
}

void voutParts::setMatrix(int part, const GLdouble matrix[16])
{
    guarded("voutParts::setMatrix",
            [&] { d->at(part).matrix = matrix ? vo::affineMatrix(matrix) : glm::dmat4(1); });
}

void voutParts::setColor(int part, float red, float green, float blue, float alpha)
{
    guarded("voutParts::setColor", [&] { d->at(part).color = glm::vec4(red, green, blue, alpha); });
}

void voutParts::resetColor(int part)
{
    guarded("voutParts::resetColor", [&] { d->at(part).color.reset(); });
}

void voutParts::setLookupTable(int part, voLookupTable* table)
{
    guarded("voutParts::setLookupTable", [&] { d->at(part).table = table; });
}

void voutParts::setVisible(int part, voBool visible)
{
    guarded("voutParts::setVisible", [&] { d->at(part).visible = visible != VO_FALSE; });
}

int voutParts::draw(GLdouble modelMatrix[16], GLdouble projMatrix[16], voSamplingMode samplingMode,
                    voSamplingSpace samplingSpace, float samplingPeriod[3], int maxSamplesNumber)
{
    bool drawn = false;
    const int failed = guarded("voutParts::draw", [&] {
        const PartsRequest request{modelMatrix,   projMatrix,     samplingMode,
                                   samplingSpace, samplingPeriod, maxSamplesNumber};
        check(request);
        drawn = PartsFrame(d->parts, request).draw();
    });
    return failed || !drawn;
}
