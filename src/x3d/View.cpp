#include <vo/x3d/View.h>

#include "x3d/face.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "cast/pick_scene.h"
#include "x3d/node_values.h"
#include "x3d/scene_painter.h"
#include "x3d/view_session.h"

struct voX3DView::Private
{
    voX3DScene& face;
    std::unique_ptr<vo::ViewSession> kept;
    vo::ViewRequest request;
    vo::ScenePainter painter;

    explicit Private(voX3DScene& scene) : face(scene) {}

    /// What it keeps of the scene that is there now; of one that was read since, nothing yet.
    vo::ViewSession& session(const std::shared_ptr<vo::Scene>& scene)
    {
        if (!kept || kept->scene() != scene) {
            request.viewpoint = nullptr;
            kept = std::make_unique<vo::ViewSession>(scene);
        }
        return *kept;
    }
};

namespace vo {
namespace {

glm::dmat4 rigidMatrixOf(const GLdouble* numbers, const char* name)
{
    const glm::dmat4 matrix = givenMatrix(numbers, name);
    const glm::dmat3 axes(matrix), square = axes * glm::transpose(axes);
    double off = 0;
    for (int i = 0; i < 3; ++i)
        off = std::max(off, glm::length(square[i] - glm::dmat3(1.0)[i]));
    const bool isAffine = glm::row(matrix, 3) == glm::dvec4(0, 0, 0, 1);
    if (off > 1e-4 || glm::determinant(axes) < 0 || !isAffine)
        badValue(std::string(name) + " is no rigid motion");
    return matrix;
}

void copyMatrix(const glm::dmat4& matrix, GLdouble* numbers)
{
    std::copy_n(glm::value_ptr(matrix), 16, numbers);
}

/// Whether a viewpoint has this name, description or number from 1.
bool isCalled(const Node& viewpoint, std::size_t number, std::string_view name)
{
    return viewpoint.name == name || stringOf(viewpoint, "description") == name ||
           std::to_string(number) == name;
}

template <typename Vector>
void copyVector(const Vector& from, float* to)
{
    for (int i = 0; i < 3; ++i)
        to[i] = static_cast<float>(from[i]);
}

voX3DPick::Kind kindOf(SceneHit::Kind kind)
{
    switch (kind) {
    case SceneHit::Kind::nothing: break;
    case SceneHit::Kind::surface: return voX3DPick::SURFACE;
    case SceneHit::Kind::bounds: return voX3DPick::BOUNDS;
    case SceneHit::Kind::voxel: return voX3DPick::VOXEL;
    }
    return voX3DPick::NOTHING;
}

/// Numbers as a field of this row holds them.
FieldValue valueOf(const FieldRow& row, const double* numbers, int count)
{
    if (count < 0 || (count > 0 && !numbers)) badValue("there are no numbers");
    const std::vector<double> all(numbers, numbers + count);
    switch (shapeOf(row.type).storage) {
    case Storage::doubles: return all;
    case Storage::floats: return std::vector<float>(all.begin(), all.end());
    case Storage::integers: break;
    default: badValue(row.name + " takes no numbers");
    }
    std::vector<std::int32_t> integers;
    for (const double number : all) {
        if (!(std::abs(number) <= 2147483647.0)) badValue(row.name + ": expected whole numbers of 32 bits");
        integers.push_back(static_cast<std::int32_t>(number));
    }
    return integers;
}

} // namespace
} // namespace vo

using namespace vo;

voX3DPick::voX3DPick() : kind(NOTHING), opacity(0), depth(HUGE_VAL)
{
    for (float* const each : {world, local, textureCoordinate, normal})
        std::fill_n(each, 3, 0.0f);
}

voX3DView::voX3DView(voX3DScene& scene) : d(new Private(scene)) {}

voX3DView::~voX3DView()
{
    delete d;
}

void voX3DView::setSize(int width, int height)
{
    guarded("setSize", [&] {
        ScenePainter::checkSize(width, height);
        d->request.width = width;
        d->request.height = height;
    });
}

int voX3DView::getWidth() const
{
    return d->request.width;
}

int voX3DView::getHeight() const
{
    return d->request.height;
}

int voX3DView::getViewpointCount()
{
    return guardedAnswer("getViewpointCount", 0, [&] {
        return static_cast<int>(d->session(d->face.d->scene).view().viewpoints().size());
    });
}

voX3DNode voX3DView::getViewpoint(int index)
{
    return guardedAnswer("getViewpoint", voX3DNode(), [&] {
        const auto viewpoints = d->session(d->face.d->scene).view().viewpoints();
        return d->face.handle(const_cast<Node*>(elementOf(viewpoints, index)));
    });
}

void voX3DView::setViewpoint(const voX3DNode& viewpoint)
{
    guarded("setViewpoint", [&] {
        const Node* node = nullptr;
        if (!viewpoint.isNull()) {
            node = static_cast<const Node*>(d->face.own(viewpoint));
            if (!isOf(node, "X3DViewpointNode")) badValue(node->typeName() + " is no viewpoint");
        }
        d->session(d->face.d->scene);
        d->request.viewpoint = node;
        d->request.camera.reset();
    });
}

voBool voX3DView::setViewpoint(const char* name)
{
    return !guarded("setViewpoint", [&] {
        const std::string_view wanted = &required(name, "name");
        const auto viewpoints = d->session(d->face.d->scene).view().viewpoints();
        for (std::size_t i = 0; i < viewpoints.size(); ++i) {
            if (!isCalled(*viewpoints[i], i + 1, wanted)) continue;
            d->request.viewpoint = viewpoints[i];
            d->request.camera.reset();
            return;
        }
        badValue("the scene has no viewpoint \"" + std::string(wanted) + "\"");
    });
}

void voX3DView::setCamera(const GLdouble eyeFromWorld[16], const GLdouble projection[16])
{
    guarded("setCamera", [&] {
        d->request.camera = {rigidMatrixOf(eyeFromWorld, "eyeFromWorld"),
                             givenMatrix(projection, "projection")};
    });
}

voBool voX3DView::getCamera(GLdouble eyeFromWorld[16], GLdouble projection[16])
{
    return !guarded("getCamera", [&] {
        const StyledScene scene = d->session(d->face.d->scene).styledScene(d->request);
        copyMatrix(scene.eyeFromWorld, &required(eyeFromWorld, "eyeFromWorld"));
        copyMatrix(scene.clipFromEye, &required(projection, "projection"));
    });
}

voBool voX3DView::getBounds(double center[3], double& radius)
{
    return guardedAnswer<voBool>("getBounds", VO_FALSE, [&] {
        required(center, "center");
        const SceneBounds bounds = boundsOf(d->session(d->face.d->scene).styledScene(d->request));
        if (bounds.radius < 0) return VO_FALSE;
        for (int i = 0; i < 3; ++i)
            center[i] = bounds.center[i];
        radius = bounds.radius;
        return VO_TRUE;
    });
}

void voX3DView::setHeadlight(voBool on)
{
    d->request.headlight = on;
}

void voX3DView::setSampling(double edges)
{
    guarded("setSampling", [&] { d->request.sampling = samplingOf(edges); });
}

void voX3DView::setTime(double seconds)
{
    guarded("setTime", [&] {
        if (!std::isfinite(seconds)) badValue("expected a time, found what is no number");
        d->session(d->face.d->scene).events().setTime(seconds);
    });
}

double voX3DView::getTime() const
{
    return d->kept ? d->kept->events().time() : 0.0;
}

voBool voX3DView::isAnimated() const
{
    return d->kept && d->kept->events().isRunning();
}

double voX3DView::getCycle()
{
    return guardedAnswer("getCycle", 0.0, [&] {
        double longest = 0;
        for (const auto& node : d->face.d->scene->nodes()) {
            if (!isOf(node.get(), "TimeSensor") || !boolOf(*node, "enabled")) continue;
            const auto seconds = [&](const char* field) {
                return std::get<std::vector<double>>(node->value(*node->field(field))).front();
            };
            const double start = boolOf(*node, "loop") ? 0 : seconds("startTime");
            if (boolOf(*node, "loop") || start > 0)
                longest = std::max(longest, start + seconds("cycleInterval"));
        }
        return longest;
    });
}

voBool voX3DView::draw(voEngine engine)
{
    return !guarded("draw", [&] {
        d->painter.draw(engine, [&] { return d->session(d->face.d->scene).styledScene(d->request); });
    });
}

void voX3DView::releaseDrawing()
{
    d->painter.releaseDrawing();
}

voBool voX3DView::picture(float* rgba, int threads)
{
    return !guarded("picture", [&] {
        d->painter.picture(rgba, threads,
                           [&] { return d->session(d->face.d->scene).styledScene(d->request); });
    });
}

voBool voX3DView::pick(int x, int y, float threshold, voX3DPick& hit)
{
    hit = voX3DPick();
    return guardedAnswer<voBool>("pick", VO_FALSE, [&] {
        if (std::isnan(threshold)) badValue("expected an opacity, found what is no number");
        const SceneHit found =
            pickScene(d->session(d->face.d->scene).styledScene(d->request), x + 0.5, y + 0.5, threshold);
        if (found.kind == SceneHit::Kind::nothing) return VO_FALSE;
        hit.kind = kindOf(found.kind);
        hit.node = d->face.handle(const_cast<Node*>(d->session(d->face.d->scene).view().nodeOf(found.id)));
        copyVector(found.world, hit.world);
        copyVector(found.local, hit.local);
        copyVector(found.place, hit.textureCoordinate);
        copyVector(found.normal, hit.normal);
        hit.opacity = found.opacity;
        hit.depth = found.depth;
        return VO_TRUE;
    });
}

voBool voX3DView::movePointer(int x, int y, float threshold)
{
    return guardedAnswer<voBool>("movePointer", VO_FALSE, [&] {
        if (std::isnan(threshold)) badValue("expected an opacity, found what is no number");
        const SceneHit found =
            pickScene(d->session(d->face.d->scene).styledScene(d->request), x + 0.5, y + 0.5, threshold);
        std::optional<PointedPlace> place;
        if (found.kind != SceneHit::Kind::nothing)
            place = {d->session(d->face.d->scene).view().pathOf(found.id), found.world, found.normal,
                     glm::vec2(found.place)};
        return d->session(d->face.d->scene).pointer().move(place) ? VO_TRUE : VO_FALSE;
    });
}

void voX3DView::pressPointer()
{
    guarded("pressPointer", [&] { d->session(d->face.d->scene).pointer().press(); });
}

void voX3DView::releasePointer()
{
    guarded("releasePointer", [&] { d->session(d->face.d->scene).pointer().release(); });
}

void voX3DView::send(const voX3DNode& node, const char* field, const double* values, int numbers)
{
    guarded("send", [&] {
        Node& to = *static_cast<Node*>(d->face.own(node));
        const FieldRow* const row = eventRow(to, &required(field, "field"), false);
        if (!row || !isInput(row->access))
            badValue(to.typeName() + " has no field \"" + field + "\" that takes events");
        const FieldValue value = valueOf(*row, values, numbers);
        if (const auto against = objection(*row, value))
            badValue(to.typeName() + "." + row->name + ": " + *against);
        d->session(d->face.d->scene).events().receive(to, *row, value);
    });
}
