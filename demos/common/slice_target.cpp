#include "slice_target.h"

#include "matrices.h"

namespace vo {

SliceTarget::SliceTarget(int width, int height)
    : width_(width), height_(height), square_(4, getValuesPerVertex(voInterleavedArrayTypeScope::T3F_V3F), 5)
{
    gl->GenTextures(1, &texture_);
    gl->BindTexture(GL_TEXTURE_2D, texture_);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA16, width, height, 0, GL_RGBA, GL_UNSIGNED_SHORT, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl->TexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->GenFramebuffers(1, &framebuffer_);
    bind();
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    end();
}

SliceTarget::~SliceTarget()
{
    gl->DeleteFramebuffers(1, &framebuffer_);
    gl->DeleteTextures(1, &texture_);
}

void SliceTarget::bind()
{
    gl->GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawnBefore_);
    gl->GetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &readBefore_);
    gl->BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
}

void SliceTarget::begin()
{
    bind();
    gl->ClearColor(0, 0, 0, 0);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

void SliceTarget::end()
{
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(drawnBefore_));
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(readBefore_));
}

void SliceTarget::draw(double depth)
{
    const float z = float(depth);
    float corners[] = {0, 0, 0, -1, -1, z, 1, 0, 0, 1,  -1, z, //
                       1, 1, 0, 1,  1,  z, 0, 1, 0, -1, 1,  z};
    GLdouble model[16], projection[16];
    getMatrices(model, projection);
    const GLdouble identity[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    loadMatrices(identity, identity);
    setColor(1, 1, 1, 1);
    voAppearanceActions::textureEnable(voInterpolationTypeScope::_2D);
    gl->BindTexture(GL_TEXTURE_2D, texture_);
    square_.empty();
    square_.appendPoly(corners, 4);
    voGeometryActions::draw(&square_, voInterleavedArrayTypeScope::T3F_V3F);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    voAppearanceActions::textureDisable(voInterpolationTypeScope::_2D);
    loadMatrices(model, projection);
}

} // namespace vo
