#pragma once

#include "gl.h"

#include "volume_view/camera.h"

/// What the vogl programs set by fixed functions, in a compatibility and in a core context alike: OpenGL's
/// own state in the first, voState's in the second.
namespace vo {

/// Whether the current context lacks the fixed functions.
bool isCoreContext();

void loadProjection(const ViewVolume& view);
void loadModelView(const Model& model, const Orientation& orientation, const ViewVolume& view);

/// Any other matrices.
void loadMatrices(const GLdouble modelMatrix[16], const GLdouble projMatrix[16]);

/// What glGetDoublev gives for GL_MODELVIEW_MATRIX and GL_PROJECTION_MATRIX.
void getMatrices(GLdouble modelMatrix[16], GLdouble projMatrix[16]);

/// Moves the texture coordinates of what is drawn next.
void setTextureShift(double s, double t, double r);

/// The colour of what is drawn next.
void setColor(float red, float green, float blue, float alpha);

} // namespace vo
