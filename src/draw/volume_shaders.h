#pragma once

namespace vo {

// Texts of the programs that draw volumes; volume_programs.cpp puts them together.

// Of slices, and of triangles that cover the picture.
extern const char* const kSliceVertexShader;
extern const char* const kPictureVertexShader;

/// What styles may use (style/glsl_chain.h), beside the lights.
extern const char* const kStylePreamble;
/// Samples at places, with or without normals. WHOLE_RAYS: no places come from vertices; OWN_PLACES: they are
/// not those of the box.
extern const char* const kSampleFunctions;
/// Surfaces of values.
extern const char* const kSurfaceFunctions;
/// Rays of pixels through a box, CLIP_PLANES of which cut it.
extern const char* const kRayFunctions;
/// Ways of rays through planes; with LEAPS they go on beyond blocks in which nothing is seen.
extern const char* const kWalkFunctions;
/// Of a projection, after opacityOf().
extern const char* const kProjectedSample;
/// How samples of a ray become one, with TYPE.
extern const char* const kJoinFunctions;

// Main functions.
extern const char* const kSamplesMain;
extern const char* const kSurfacesMain;
extern const char* const kPlaneSamplesMain;
extern const char* const kMarchedSamplesMain;
extern const char* const kCrossingFunctions; ///< of the next two
extern const char* const kMarchedSurfacesMain;
extern const char* const kNextSurfaceMain;
extern const char* const kProjectionMain;

} // namespace vo
