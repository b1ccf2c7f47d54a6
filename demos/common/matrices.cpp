#include "matrices.h"

#include <vo/State.h>

#include <algorithm>

namespace vo {
namespace {

/// OpenGL keeps its matrices in single precision: the same is done where it keeps none, so that both kinds of
/// context show the same picture.
Matrix singlePrecision(Matrix matrix)
{
    for (double& value : matrix)
        value = double(float(value));
    return matrix;
}

} // namespace

bool isCoreContext()
{
    GLint mask = 0;
    gl->GetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    return mask & GL_CONTEXT_CORE_PROFILE_BIT;
}

void loadProjection(const ViewVolume& view)
{
    if (isCoreContext()) {
        voState::setProjectionMatrix(singlePrecision(projectionMatrix(view)).data());
        return;
    }
    gl->MatrixMode(GL_PROJECTION);
    gl->LoadIdentity();
    if (view.distance == 0) {
        gl->Ortho(-view.halfWidth, view.halfWidth, -view.halfHeight, view.halfHeight, view.nearDistance,
                  view.farDistance);
    } else {
        const double shrink = view.nearDistance / view.distance;
        gl->Frustum(-view.halfWidth * shrink, view.halfWidth * shrink, -view.halfHeight * shrink,
                    view.halfHeight * shrink, view.nearDistance, view.farDistance);
    }
    gl->MatrixMode(GL_MODELVIEW);
}

void loadModelView(const Model& model, const Orientation& orientation, const ViewVolume& view)
{
    if (isCoreContext()) {
        voState::setModelMatrix(singlePrecision(modelViewMatrix(model, orientation, view)).data());
        return;
    }
    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadIdentity();
    gl->Translated(0, 0, -view.distance);
    gl->Rotated(-orientation.latitude - 90, 1, 0, 0);
    gl->Rotated(-orientation.longitude, 0, 0, 1);
    gl->Scaled(model.scale[0], model.scale[1], model.scale[2]);
    gl->Translated(-model.size[0] / 2, -model.size[1] / 2, -model.size[2] / 2);
}

void loadMatrices(const GLdouble modelMatrix[16], const GLdouble projMatrix[16])
{
    if (isCoreContext()) {
        Matrix model, projection;
        std::copy_n(modelMatrix, 16, model.begin());
        std::copy_n(projMatrix, 16, projection.begin());
        voState::setModelMatrix(singlePrecision(model).data());
        voState::setProjectionMatrix(singlePrecision(projection).data());
        return;
    }
    gl->MatrixMode(GL_PROJECTION);
    gl->LoadMatrixd(projMatrix);
    gl->MatrixMode(GL_MODELVIEW);
    gl->LoadMatrixd(modelMatrix);
}

void getMatrices(GLdouble modelMatrix[16], GLdouble projMatrix[16])
{
    if (isCoreContext()) {
        voState::getModelMatrix(modelMatrix);
        voState::getProjectionMatrix(projMatrix);
        return;
    }
    gl->GetDoublev(GL_MODELVIEW_MATRIX, modelMatrix);
    gl->GetDoublev(GL_PROJECTION_MATRIX, projMatrix);
}

void setTextureShift(double s, double t, double r)
{
    const Matrix shift{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, s, t, r, 1};
    if (isCoreContext()) {
        voState::setTextureMatrix(singlePrecision(shift).data());
        return;
    }
    gl->MatrixMode(GL_TEXTURE);
    gl->LoadMatrixd(shift.data());
    gl->MatrixMode(GL_MODELVIEW);
}

void setColor(float red, float green, float blue, float alpha)
{
    if (isCoreContext()) {
        voState::setColor(red, green, blue, alpha);
    } else {
        gl->Color4f(red, green, blue, alpha);
    }
}

} // namespace vo
