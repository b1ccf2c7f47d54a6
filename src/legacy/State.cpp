#include "legacy/inside.h"

#include "legacy/enums.h"
#include "legacy/report.h"

#include <vo/State.h>

#include "polygonize/line_of_sight.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

using vo::badValue;
using vo::guarded;
using vo::required;

namespace {

void setMatrix(const char* action, glm::dmat4 vo::ContextState::*member, const GLdouble* matrix)
{
    guarded(action, [&] {
        if (!matrix) badValue("the matrix is NULL");
        vo::requireContext().state.*member = glm::make_mat4(matrix);
    });
}

void getMatrix(const char* action, glm::dmat4 vo::ContextState::*member, GLdouble* matrix)
{
    guarded(action, [&] {
        if (!matrix) badValue("the matrix is NULL");
        const glm::dmat4& value = vo::requireContext().state.*member;
        std::copy_n(glm::value_ptr(value), 16, matrix);
    });
}

} // namespace

void voState::setModelMatrix(const GLdouble matrix[16])
{
    setMatrix("voState::setModelMatrix", &vo::ContextState::model, matrix);
}

void voState::setProjectionMatrix(const GLdouble matrix[16])
{
    setMatrix("voState::setProjectionMatrix", &vo::ContextState::projection, matrix);
}

void voState::setTextureMatrix(const GLdouble matrix[16])
{
    setMatrix("voState::setTextureMatrix", &vo::ContextState::texture, matrix);
}

void voState::getModelMatrix(GLdouble matrix[16])
{
    getMatrix("voState::getModelMatrix", &vo::ContextState::model, matrix);
}

void voState::getProjectionMatrix(GLdouble matrix[16])
{
    getMatrix("voState::getProjectionMatrix", &vo::ContextState::projection, matrix);
}

void voState::getTextureMatrix(GLdouble matrix[16])
{
    getMatrix("voState::getTextureMatrix", &vo::ContextState::texture, matrix);
}

void voState::setColor(float red, float green, float blue, float alpha)
{
    guarded("voState::setColor", [&] { vo::requireContext().state.color = {red, green, blue, alpha}; });
}

void voState::setClipPlane(int index, const GLdouble plane[4])
{
    guarded("voState::setClipPlane", [&] {
        if (index < 0 || index > 7) badValue("clip plane " + std::to_string(index) + " is outside 0 to 7");
        if (!plane) badValue("the plane is NULL");
        vo::requireContext().state.clipPlanes[static_cast<std::size_t>(index)] = glm::make_vec4(plane);
    });
}

void voState::setGetProcAddress(GetProcAddress getProcAddress)
{
    vo::setGetGlFunction(getProcAddress);
}

void voState::setUnitLength(double length)
{
    guarded("voState::setUnitLength", [&] {
        if (!(length >= 0) || std::isinf(length))
            badValue("the unit length is " + std::to_string(length) + ", 0 or more is needed");
        vo::requireContext().state.unitLength = length;
    });
}

void voState::setSampling(voIndexedTetraSet* tetraSet, voBrickSet* brickSet, GLdouble modelMatrix[16],
                          GLdouble projMatrix[16], voSamplingMode samplingMode, voSamplingSpace samplingSpace,
                          float samplingPeriod[3], int maxSamplesNumber)
{
    guarded("voState::setSampling", [&] {
        const vo::TetraView tetras = vo::tetraView(required(tetraSet, "tetraSet"));
        const voBrickSet& set = required(brickSet, "brickSet");
        const vo::SamplingRequest sampling = vo::samplingRequest(samplingMode, samplingSpace, samplingPeriod,
                                                                 maxSamplesNumber, set.getOrientation());
        if (sampling.space == vo::SamplingSpace::primitive)
            vo::unsupported("opacity per length needs samples of one distance, which PRIMITIVE has not");
        const vo::Camera camera = vo::cameraOf(modelMatrix, projMatrix);
        vo::requireContext().state.sampleGauge = vo::sampleGauge(tetras, camera, sampling);
    });
}

void voState::resetSampling()
{
    guarded("voState::resetSampling", [] { vo::requireContext().state.sampleGauge.reset(); });
}

void voState::setEngine(voEngine engine)
{
    guarded("voState::setEngine",
            [&] { vo::requireContext().state.engine = vo::engineChoiceOf(static_cast<int>(engine)); });
}

long voState::getFramesDrawn(voEngine engine)
{
    long count = 0;
    guarded("voState::getFramesDrawn", [&] {
        const vo::EngineChoice wanted = vo::engineChoiceOf(static_cast<int>(engine));
        const auto& [slices, cast] = vo::requireContext().framesDrawn;
        if (wanted != vo::EngineChoice::cast) count += static_cast<long>(slices);
        if (wanted != vo::EngineChoice::slices) count += static_cast<long>(cast);
    });
    return count;
}
