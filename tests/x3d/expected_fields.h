#pragma once

#include <string_view>

/// What the documents say of nodes and fields, written down apart from the library's own table: a node on a
/// line of its own, then "field type access default" of each of its fields but metadata. Events have no
/// default. Several texts together are one edition.
namespace expected {

/// The proposal of 2005, whole; its OctTree is a bounded object.
constexpr std::string_view kProposal2005 = R"(
VolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle SFNode [in,out] NULL
  voxels MFNode [in,out] []
SegmentedVolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle MFNode [in,out] []
  segmentEnabled MFBool [in,out] []
  segmentedVoxels SFNode [in,out] NULL
OctTree
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  highRes MFNode [in,out] []
  lowRes SFNode [in,out] NULL
  lowResActive SFBool [out] -
  center SFVec3f [] 0 0 0
  range SFFloat [] 20
OpacityMapVolumeStyle
  enabled SFBool [in,out] TRUE
  transferFunction SFNode [in,out] NULL
BoundaryEnhancementVolumeStyle
  enabled SFBool [in,out] TRUE
  contribution SFFloat [in,out] 0.2
  gradientColor SFColorRGBA [in,out] 0 0 0 1
  surfaceNormals SFNode [in,out] NULL
  transferFunction SFNode [in,out] NULL
  retainedOpacity SFFloat [in,out] 1
  boundaryOpacity SFFloat [in,out] 0
  opacityFactor SFFloat [in,out] 1
CartoonVolumeStyle
  enabled SFBool [in,out] TRUE
  surfaceNormals SFNode [in,out] NULL
  parallelColor SFColorRGBA [in,out] 0 0 0 1
  orthogonalColor SFColorRGBA [in,out] 1 1 1 1
  colorSteps SFInt32 [in,out] 4
CompositeVolumeStyle
  enabled SFBool [in,out] TRUE
  ordered SFBool [in,out] FALSE
  styles MFNode [in,out] []
EdgeEnhancementVolumeStyle
  contribution SFFloat [in,out] 0.2
  edgeColor SFColorRGBA [in,out] 0 0 0 1
  enabled SFBool [in,out] TRUE
  gradientThreshold SFFloat [in,out] 0.4
  surfaceNormals SFNode [in,out] NULL
ISOSurfaceVolumeStyle
  enabled SFBool [in,out] TRUE
  lighting SFBool [in,out] FALSE
  surfaceNormals SFNode [in,out] NULL
  shadows SFBool [in,out] FALSE
SilhouetteEnhancementVolumeStyle
  enabled SFBool [in,out] TRUE
  surfaceNormals SFNode [in,out] NULL
  silhouetteFactor SFFloat [in,out] 0.5
StippleVolumeStyle
  distanceFactor SFFloat [in,out] 1
  enabled SFBool [in,out] TRUE
  interiorFactor SFFloat [in,out] 1
  lightingFactor SFFloat [in,out] 1
  gradientThreshold SFFloat [in,out] 0.4
  gradientRetainedOpacity SFFloat [in,out] 1
  gradientBoundaryOpacity SFFloat [in,out] 0
  gradientOpacityFactor SFFloat [in,out] 1
  silhouetteRetainedOpacity SFFloat [in,out] 1
  silhouetteBoundaryOpacity SFFloat [in,out] 0
  silhouetteOpacityFactor SFFloat [in,out] 1
  resolutionFactor SFFloat [in,out] 1
ToneMappedVolumeStyle
  coolColor SFColorRGBA [in,out] 0 0 1 0
  enabled SFBool [in,out] TRUE
  surfaceNormals SFNode [in,out] NULL
  warmColor SFColorRGBA [in,out] 1 1 0 0
)";

/// The styles of ISO, which 3.3 and 4.0 have alike.
constexpr std::string_view kIsoStyles = R"(
OpacityMapVolumeStyle
  enabled SFBool [in,out] TRUE
  transferFunction SFNode [in,out] NULL
BoundaryEnhancementVolumeStyle
  enabled SFBool [in,out] TRUE
  retainedOpacity SFFloat [in,out] 0.2
  boundaryOpacity SFFloat [in,out] 0.9
  opacityFactor SFFloat [in,out] 2
CartoonVolumeStyle
  enabled SFBool [in,out] TRUE
  colorSteps SFInt32 [in,out] 4
  orthogonalColor SFColorRGBA [in,out] 1 1 1 1
  parallelColor SFColorRGBA [in,out] 0 0 0 1
  surfaceNormals SFNode [in,out] NULL
ComposedVolumeStyle
  enabled SFBool [in,out] TRUE
  renderStyle MFNode [in,out] []
EdgeEnhancementVolumeStyle
  enabled SFBool [in,out] TRUE
  edgeColor SFColorRGBA [in,out] 0 0 0 1
  gradientThreshold SFFloat [in,out] 0.4
  surfaceNormals SFNode [in,out] NULL
SilhouetteEnhancementVolumeStyle
  enabled SFBool [in,out] TRUE
  silhouetteRetainedOpacity SFFloat [in,out] 1
  silhouetteBoundaryOpacity SFFloat [in,out] 0
  silhouetteSharpness SFFloat [in,out] 0.5
  surfaceNormals SFNode [in,out] NULL
ToneMappedVolumeStyle
  enabled SFBool [in,out] TRUE
  coolColor SFColorRGBA [in,out] 0 0 1 0
  warmColor SFColorRGBA [in,out] 1 1 0 0
  surfaceNormals SFNode [in,out] NULL
BlendedVolumeStyle
  enabled SFBool [in,out] TRUE
  renderStyle SFNode [in,out] NULL
  voxels SFNode [in,out] NULL
  weightConstant1 SFFloat [in,out] 0.5
  weightConstant2 SFFloat [in,out] 0.5
  weightFunction1 SFString [in,out] "CONSTANT"
  weightFunction2 SFString [in,out] "CONSTANT"
  weightTransferFunction1 SFNode [in,out] NULL
  weightTransferFunction2 SFNode [in,out] NULL
ProjectionVolumeStyle
  enabled SFBool [in,out] TRUE
  type SFString [in,out] "MAX"
  intensityThreshold SFFloat [in,out] 0
ShadedVolumeStyle
  enabled SFBool [in,out] TRUE
  lighting SFBool [in,out] FALSE
  shadows SFBool [in,out] FALSE
  phaseFunction SFString [] "Henyey-Greenstein"
  material SFNode [in,out] NULL
  surfaceNormals SFNode [in,out] NULL
)";

constexpr std::string_view kIsoData33 = R"(
VolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle SFNode [in,out] NULL
  voxels SFNode [in,out] NULL
SegmentedVolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle MFNode [in,out] []
  segmentEnabled MFBool [in,out] []
  segmentIdentifiers SFNode [in,out] NULL
  voxels SFNode [in,out] NULL
IsoSurfaceVolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxSize SFVec3f [] -1 -1 -1
  contourStepSize SFFloat [in,out] 0
  gradients SFNode [in,out] NULL
  renderStyle MFNode [in,out] []
  surfaceTolerance SFFloat [in,out] 0
  surfaceValues MFFloat [in,out] []
  voxels SFNode [in,out] NULL
)";

constexpr std::string_view kIsoData40 = R"(
VolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle SFNode [in,out] NULL
  visible SFBool [in,out] TRUE
  voxels SFNode [in,out] NULL
SegmentedVolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  renderStyle MFNode [in,out] []
  segmentEnabled MFBool [in,out] []
  segmentIdentifiers SFNode [in,out] NULL
  visible SFBool [in,out] TRUE
  voxels SFNode [in,out] NULL
IsoSurfaceVolumeData
  dimensions SFVec3f [in,out] 1 1 1
  bboxCenter SFVec3f [] 0 0 0
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  contourStepSize SFFloat [in,out] 0
  gradients SFNode [in,out] NULL
  renderStyle MFNode [in,out] []
  surfaceTolerance SFFloat [in,out] 0
  surfaceValues MFFloat [in,out] []
  visible SFBool [in,out] TRUE
  voxels SFNode [in,out] NULL
)";

/// What is round the volumes, in 4.0.
constexpr std::string_view kRound40 = R"(
Transform
  translation SFVec3f [in,out] 0 0 0
  rotation SFRotation [in,out] 0 0 1 0
  scale SFVec3f [in,out] 1 1 1
  scaleOrientation SFRotation [in,out] 0 0 1 0
  center SFVec3f [in,out] 0 0 0
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
Group
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
StaticGroup
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  children MFNode [] []
Anchor
  description SFString [in,out] ""
  load SFBool [in,out] TRUE
  parameter MFString [in,out] []
  url MFString [in,out] []
  autoRefresh SFTime [in,out] 0
  autoRefreshTimeLimit SFTime [in,out] 3600
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
Collision
  description SFString [in,out] ""
  enabled SFBool [in,out] TRUE
  proxy SFNode [] NULL
  isActive SFBool [out] -
  collideTime SFTime [out] -
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
Switch
  whichChoice SFInt32 [in,out] -1
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
LOD
  forceTransitions SFBool [] FALSE
  center SFVec3f [] 0 0 0
  range MFFloat [] []
  level_changed SFInt32 [out] -
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  addChildren MFNode [in] -
  removeChildren MFNode [in] -
  children MFNode [in,out] []
Viewpoint
  set_bind SFBool [in] -
  description SFString [in,out] ""
  position SFVec3f [in,out] 0 0 10
  orientation SFRotation [in,out] 0 0 1 0
  centerOfRotation SFVec3f [in,out] 0 0 0
  fieldOfView SFFloat [in,out] 0.785398
  nearDistance SFFloat [in,out] -1
  farDistance SFFloat [in,out] -1
  viewAll SFBool [in,out] FALSE
  jump SFBool [in,out] TRUE
  retainUserOffsets SFBool [in,out] FALSE
  isBound SFBool [out] -
  bindTime SFTime [out] -
  navigationInfo SFNode [in,out] NULL
OrthoViewpoint
  set_bind SFBool [in] -
  description SFString [in,out] ""
  position SFVec3f [in,out] 0 0 10
  orientation SFRotation [in,out] 0 0 1 0
  centerOfRotation SFVec3f [in,out] 0 0 0
  fieldOfView SFVec4f [in,out] -1 -1 1 1
  nearDistance SFFloat [in,out] -1
  farDistance SFFloat [in,out] -1
  viewAll SFBool [in,out] FALSE
  jump SFBool [in,out] TRUE
  retainUserOffsets SFBool [in,out] FALSE
  isBound SFBool [out] -
  bindTime SFTime [out] -
  navigationInfo SFNode [in,out] NULL
NavigationInfo
  set_bind SFBool [in] -
  type MFString [in,out] "EXAMINE" "ANY"
  avatarSize MFFloat [in,out] 0.25 1.6 0.75
  speed SFFloat [in,out] 1
  headlight SFBool [in,out] TRUE
  visibilityLimit SFFloat [in,out] 0
  transitionType MFString [in,out] "LINEAR"
  transitionTime SFTime [in,out] 1
  transitionComplete SFBool [out] -
  isBound SFBool [out] -
  bindTime SFTime [out] -
Background
  set_bind SFBool [in] -
  frontUrl MFString [in,out] []
  backUrl MFString [in,out] []
  leftUrl MFString [in,out] []
  rightUrl MFString [in,out] []
  topUrl MFString [in,out] []
  bottomUrl MFString [in,out] []
  skyAngle MFFloat [in,out] []
  skyColor MFColor [in,out] 0 0 0
  groundAngle MFFloat [in,out] []
  groundColor MFColor [in,out] []
  transparency SFFloat [in,out] 0
  isBound SFBool [out] -
  bindTime SFTime [out] -
DirectionalLight
  global SFBool [in,out] FALSE
  on SFBool [in,out] TRUE
  color SFColor [in,out] 1 1 1
  intensity SFFloat [in,out] 1
  ambientIntensity SFFloat [in,out] 0
  direction SFVec3f [in,out] 0 0 -1
  shadows SFBool [in,out] FALSE
  shadowIntensity SFFloat [in,out] 1
PointLight
  global SFBool [in,out] TRUE
  on SFBool [in,out] TRUE
  color SFColor [in,out] 1 1 1
  intensity SFFloat [in,out] 1
  ambientIntensity SFFloat [in,out] 0
  attenuation SFVec3f [in,out] 1 0 0
  location SFVec3f [in,out] 0 0 0
  radius SFFloat [in,out] 100
  shadows SFBool [in,out] FALSE
  shadowIntensity SFFloat [in,out] 1
SpotLight
  global SFBool [in,out] TRUE
  on SFBool [in,out] TRUE
  color SFColor [in,out] 1 1 1
  intensity SFFloat [in,out] 1
  ambientIntensity SFFloat [in,out] 0
  attenuation SFVec3f [in,out] 1 0 0
  location SFVec3f [in,out] 0 0 0
  direction SFVec3f [in,out] 0 0 -1
  radius SFFloat [in,out] 100
  beamWidth SFFloat [in,out] 0.589049
  cutOffAngle SFFloat [in,out] 1.570796
  shadows SFBool [in,out] FALSE
  shadowIntensity SFFloat [in,out] 1
Shape
  castShadow SFBool [in,out] TRUE
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
  appearance SFNode [in,out] NULL
  geometry SFNode [in,out] NULL
Appearance
  alphaMode SFString [in,out] "AUTO"
  alphaCutoff SFFloat [in,out] 0.5
  acousticProperties SFNode [in,out] NULL
  pointProperties SFNode [in,out] NULL
  lineProperties SFNode [in,out] NULL
  fillProperties SFNode [in,out] NULL
  material SFNode [in,out] NULL
  backMaterial SFNode [in,out] NULL
  texture SFNode [in,out] NULL
  textureTransform SFNode [in,out] NULL
  shaders MFNode [in,out] []
Box
  size SFVec3f [] 2 2 2
  solid SFBool [] TRUE
Sphere
  radius SFFloat [] 1
  solid SFBool [] TRUE
Cylinder
  top SFBool [in,out] TRUE
  side SFBool [in,out] TRUE
  bottom SFBool [in,out] TRUE
  height SFFloat [] 2
  radius SFFloat [] 1
  solid SFBool [] TRUE
Cone
  side SFBool [in,out] TRUE
  bottom SFBool [in,out] TRUE
  height SFFloat [] 2
  bottomRadius SFFloat [] 1
  solid SFBool [] TRUE
IndexedFaceSet
  set_colorIndex MFInt32 [in] -
  set_texCoordIndex MFInt32 [in] -
  set_normalIndex MFInt32 [in] -
  set_coordIndex MFInt32 [in] -
  solid SFBool [] TRUE
  ccw SFBool [] TRUE
  convex SFBool [] TRUE
  creaseAngle SFFloat [] 0
  colorPerVertex SFBool [] TRUE
  normalPerVertex SFBool [] TRUE
  colorIndex MFInt32 [] []
  texCoordIndex MFInt32 [] []
  normalIndex MFInt32 [] []
  coordIndex MFInt32 [] []
  attrib MFNode [in,out] []
  tangent SFNode [in,out] NULL
  fogCoord SFNode [in,out] NULL
  color SFNode [in,out] NULL
  texCoord SFNode [in,out] NULL
  normal SFNode [in,out] NULL
  coord SFNode [in,out] NULL
IndexedTriangleSet
  set_index MFInt32 [in] -
  solid SFBool [] TRUE
  ccw SFBool [] TRUE
  colorPerVertex SFBool [] TRUE
  normalPerVertex SFBool [] TRUE
  index MFInt32 [] []
  attrib MFNode [in,out] []
  tangent SFNode [in,out] NULL
  fogCoord SFNode [in,out] NULL
  color SFNode [in,out] NULL
  texCoord SFNode [in,out] NULL
  normal SFNode [in,out] NULL
  coord SFNode [in,out] NULL
Coordinate
  point MFVec3f [in,out] []
Color
  color MFColor [in,out] []
ColorRGBA
  color MFColorRGBA [in,out] []
Normal
  vector MFVec3f [in,out] []
TextureCoordinate
  mapping SFString [in,out] ""
  point MFVec2f [in,out] []
TextureTransform
  mapping SFString [in,out] ""
  translation SFVec2f [in,out] 0 0
  rotation SFFloat [in,out] 0
  scale SFVec2f [in,out] 1 1
  center SFVec2f [in,out] 0 0
Material
  ambientIntensity SFFloat [in,out] 0.2
  ambientTextureMapping SFString [in,out] ""
  ambientTexture SFNode [in,out] NULL
  diffuseColor SFColor [in,out] 0.8 0.8 0.8
  diffuseTextureMapping SFString [in,out] ""
  diffuseTexture SFNode [in,out] NULL
  specularColor SFColor [in,out] 0 0 0
  specularTextureMapping SFString [in,out] ""
  specularTexture SFNode [in,out] NULL
  emissiveColor SFColor [in,out] 0 0 0
  emissiveTextureMapping SFString [in,out] ""
  emissiveTexture SFNode [in,out] NULL
  shininess SFFloat [in,out] 0.2
  shininessTextureMapping SFString [in,out] ""
  shininessTexture SFNode [in,out] NULL
  occlusionStrength SFFloat [in,out] 1
  occlusionTextureMapping SFString [in,out] ""
  occlusionTexture SFNode [in,out] NULL
  normalScale SFFloat [in,out] 1
  normalTextureMapping SFString [in,out] ""
  normalTexture SFNode [in,out] NULL
  transparency SFFloat [in,out] 0
ClipPlane
  enabled SFBool [in,out] TRUE
  plane SFVec4f [in,out] 0 1 0 0
Inline
  description SFString [in,out] ""
  global SFBool [in,out] FALSE
  load SFBool [in,out] TRUE
  url MFString [in,out] []
  autoRefresh SFTime [in,out] 0
  autoRefreshTimeLimit SFTime [in,out] 3600
  visible SFBool [in,out] TRUE
  bboxDisplay SFBool [in,out] FALSE
  bboxSize SFVec3f [] -1 -1 -1
  bboxCenter SFVec3f [] 0 0 0
TimeSensor
  description SFString [in,out] ""
  enabled SFBool [in,out] TRUE
  cycleInterval SFTime [in,out] 1
  loop SFBool [in,out] FALSE
  startTime SFTime [in,out] 0
  resumeTime SFTime [in,out] 0
  pauseTime SFTime [in,out] 0
  stopTime SFTime [in,out] 0
  isPaused SFBool [out] -
  isActive SFBool [out] -
  cycleTime SFTime [out] -
  elapsedTime SFTime [out] -
  fraction_changed SFFloat [out] -
  time SFTime [out] -
ScalarInterpolator
  set_fraction SFFloat [in] -
  key MFFloat [in,out] []
  keyValue MFFloat [in,out] []
  value_changed SFFloat [out] -
PositionInterpolator
  set_fraction SFFloat [in] -
  key MFFloat [in,out] []
  keyValue MFVec3f [in,out] []
  value_changed SFVec3f [out] -
OrientationInterpolator
  set_fraction SFFloat [in] -
  key MFFloat [in,out] []
  keyValue MFRotation [in,out] []
  value_changed SFRotation [out] -
ColorInterpolator
  set_fraction SFFloat [in] -
  key MFFloat [in,out] []
  keyValue MFColor [in,out] []
  value_changed SFColor [out] -
TouchSensor
  description SFString [in,out] ""
  enabled SFBool [in,out] TRUE
  hitTexCoord_changed SFVec2f [out] -
  hitNormal_changed SFVec3f [out] -
  hitPoint_changed SFVec3f [out] -
  isOver SFBool [out] -
  isActive SFBool [out] -
  touchTime SFTime [out] -
ImageTexture3D
  description SFString [in,out] ""
  load SFBool [in,out] TRUE
  url MFString [in,out] []
  autoRefresh SFTime [in,out] 0
  autoRefreshTimeLimit SFTime [in,out] 3600
  repeatS SFBool [] FALSE
  repeatT SFBool [] FALSE
  repeatR SFBool [] FALSE
  textureProperties SFNode [] NULL
ImageTextureAtlas
  description SFString [in,out] ""
  load SFBool [in,out] TRUE
  url MFString [in,out] []
  autoRefresh SFTime [in,out] 0
  autoRefreshTimeLimit SFTime [in,out] 3600
  repeatS SFBool [] FALSE
  repeatT SFBool [] FALSE
  repeatR SFBool [] FALSE
  textureProperties SFNode [] NULL
  numberOfSlices SFInt32 [in,out] 0
  slicesOverX SFInt32 [in,out] 0
  slicesOverY SFInt32 [in,out] 0
  hideChildren SFBool [in,out] TRUE
  scale SFBool [in,out] TRUE
  crossOrigin SFString [in,out] ""
  flipY SFBool [in,out] FALSE
  origChannelCount SFInt32 [in,out] 0
  channel SFInt32 [in,out] 0
PixelTexture3D
  description SFString [in,out] ""
  image MFInt32 [in,out] 0 0 0 0
  repeatS SFBool [] FALSE
  repeatT SFBool [] FALSE
  repeatR SFBool [] FALSE
  textureProperties SFNode [] NULL
ComposedTexture3D
  description SFString [in,out] ""
  repeatS SFBool [] FALSE
  repeatT SFBool [] FALSE
  repeatR SFBool [] FALSE
  textureProperties SFNode [] NULL
  texture MFNode [in,out] []
ImageTexture
  description SFString [in,out] ""
  load SFBool [in,out] TRUE
  url MFString [in,out] []
  autoRefresh SFTime [in,out] 0
  autoRefreshTimeLimit SFTime [in,out] 3600
  repeatS SFBool [] TRUE
  repeatT SFBool [] TRUE
  textureProperties SFNode [] NULL
PixelTexture
  description SFString [in,out] ""
  image SFImage [in,out] 0 0 0
  repeatS SFBool [] TRUE
  repeatT SFBool [] TRUE
  textureProperties SFNode [] NULL
TextureProperties
  borderColor SFColorRGBA [in,out] 0 0 0 0
  borderWidth SFInt32 [in,out] 0
  anisotropicDegree SFFloat [in,out] 1
  generateMipMaps SFBool [] FALSE
  minificationFilter SFString [in,out] "FASTEST"
  magnificationFilter SFString [in,out] "FASTEST"
  boundaryModeS SFString [in,out] "REPEAT"
  boundaryModeT SFString [in,out] "REPEAT"
  boundaryModeR SFString [in,out] "REPEAT"
  textureCompression SFString [in,out] "FASTEST"
  texturePriority SFFloat [in,out] 0
WorldInfo
  title SFString [in,out] ""
  info MFString [in,out] []
MetadataBoolean
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFBool [in,out] []
MetadataDouble
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFDouble [in,out] []
MetadataFloat
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFFloat [in,out] []
MetadataInteger
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFInt32 [in,out] []
MetadataSet
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFNode [in,out] []
MetadataString
  name SFString [in,out] ""
  reference SFString [in,out] ""
  value MFString [in,out] []
)";

} // namespace expected
