#include "draw/shading.h"

#include "draw/scoped_state.h"

namespace vo {

namespace {

bool isAffine(const glm::mat4& m)
{
    return m[0][3] == 0.0f && m[1][3] == 0.0f && m[2][3] == 0.0f && m[3][3] == 1.0f;
}

const TableSlot* postTable(const ContextRecord& context)
{
    return activeTable(context, TableKind::postInterpolation);
}

} // namespace

ProgramVariant variantFor(const ContextRecord& context, const DrawState& state, const RecordLayout& layout)
{
    ProgramVariant variant;
    variant.texturing = state.texturing;
    variant.vertexColor = layout.color >= 0;
    variant.flat = state.flat;
    variant.clipDistances = state.clipPlaneCount;
    variant.opacityPerLength = state.opacityPerLength;
    if (state.texturing == Texturing::none) return variant;
    variant.texgen = state.texgen;
    variant.projectiveTexture = !isAffine(state.textureMatrix);
    const bool table = postTable(context) != nullptr;
    variant.lookup = !table ? Lookup::none : state.oneChannel ? Lookup::byRed : Lookup::perComponent;
    variant.filteredLookup = table && context.quirks.filtersFloatTexturesExactly;
    if (state.replace)
        variant.environment = state.textureHasAlpha || table ? TextureEnvironment::replace
                                                             : TextureEnvironment::replaceColorOnly;
    return variant;
}

void bindTable(ContextRecord& context, const DrawState& state)
{
    const TableSlot* slot = postTable(context);
    const GladGLContext& gl = context.gl;
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(state.tableUnit));
    if (context.tableTexture == 0) gl.GenTextures(1, &context.tableTexture);
    gl.BindTexture(GL_TEXTURE_1D, context.tableTexture);
    if (context.tableTextureSerial != slot->serial) {
        const ScopedUploadState scope(gl, context.core);
        gl.TexImage1D(GL_TEXTURE_1D, 0, GL_RGBA32F, slot->table.size(), 0, GL_RGBA, GL_FLOAT,
                      slot->table.rgba.data());
        const GLint filter = context.quirks.filtersFloatTexturesExactly ? GL_LINEAR : GL_NEAREST;
        gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MIN_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAG_FILTER, filter);
        gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl.TexParameteri(GL_TEXTURE_1D, GL_TEXTURE_MAX_LEVEL, 0);
        context.tableTextureSerial = slot->serial;
    }
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(state.voxelUnit));
}

} // namespace vo
