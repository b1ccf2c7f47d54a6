#include "x3d/node_declarations.h"

namespace vo {
namespace {

constexpr std::string_view kCore = R"(
abstract X3DNode
  SFNode [in,out] metadata NULL <X3DMetadataObject>
abstract X3DChildNode : X3DNode
abstract X3DMetadataObject
abstract X3DBoundedObject
  SFVec3f [] bboxCenter 0 0 0
  SFVec3f [] bboxSize -1 -1 -1 [0,inf)|-1
  @4.0 SFBool [in,out] bboxDisplay FALSE
  @4.0 SFBool [in,out] visible TRUE
abstract X3DUrlObject
  MFString [in,out] url []
  @4.0 SFString [in,out] description ""
  @4.0 SFBool [in,out] load TRUE
  @4.0 SFTime [in,out] autoRefresh 0 [0,inf)
  @4.0 SFTime [in,out] autoRefreshTimeLimit 3600 [0,inf)
abstract X3DBindableNode : X3DChildNode
  SFBool [in] set_bind
  SFTime [out] bindTime
  SFBool [out] isBound
abstract X3DSensorNode : X3DChildNode
  @4.0 SFString [in,out] description ""
  SFBool [in,out] enabled TRUE
  SFBool [out] isActive
abstract X3DInfoNode : X3DChildNode

abstract MetadataValue : X3DNode X3DMetadataObject
  SFString [in,out] name ""
  SFString [in,out] reference ""
node MetadataBoolean@iso : MetadataValue | Core 1 | metadata
  MFBool [in,out] value []
node MetadataDouble : MetadataValue | Core 1 | metadata
  MFDouble [in,out] value []
node MetadataFloat : MetadataValue | Core 1 | metadata
  MFFloat [in,out] value []
node MetadataInteger : MetadataValue | Core 1 | metadata
  MFInt32 [in,out] value []
node MetadataSet : MetadataValue | Core 1 | metadata
  MFNode [in,out] value [] <X3DMetadataObject>
node MetadataString : MetadataValue | Core 1 | metadata
  MFString [in,out] value []
node WorldInfo : X3DInfoNode | Core 1 | children
  @3 MFString [] info []
  @4.0 MFString [in,out] info []
  @3 SFString [] title ""
  @4.0 SFString [in,out] title ""
)";

constexpr std::string_view kGrouping = R"(
abstract X3DGroupingNode : X3DChildNode X3DBoundedObject
  MFNode [in] addChildren <X3DChildNode>
  MFNode [in] removeChildren <X3DChildNode>
  MFNode [in,out] children [] <X3DChildNode>
node Group : X3DGroupingNode | Grouping 1 | children
node Transform : X3DGroupingNode | Grouping 1 | children
  SFVec3f [in,out] center 0 0 0
  SFRotation [in,out] rotation 0 0 1 0
  SFVec3f [in,out] scale 1 1 1
  SFRotation [in,out] scaleOrientation 0 0 1 0
  SFVec3f [in,out] translation 0 0 0
node StaticGroup : X3DChildNode X3DBoundedObject | Grouping 3 | children
  MFNode [] children [] <X3DChildNode>
node Anchor : X3DGroupingNode X3DUrlObject | Networking 2 | children
  SFString [in,out] description ""
  MFString [in,out] parameter []
node Collision : X3DGroupingNode | Navigation 2 | children
  @4.0 SFString [in,out] description ""
  SFBool [in,out] enabled TRUE
  SFNode [] proxy NULL <X3DChildNode>
  SFTime [out] collideTime
  SFBool [out] isActive
node Switch : X3DGroupingNode | Grouping 2 | children
  SFInt32 [in,out] whichChoice -1 [-1,inf)
node LOD : X3DGroupingNode | Navigation 2 | children
  SFVec3f [] center 0 0 0
  SFBool [] forceTransitions FALSE
  MFFloat [] range [] [0,inf)
  SFInt32 [out] level_changed
node Inline : X3DChildNode X3DBoundedObject X3DUrlObject | Networking 2 | children
  SFBool [in,out] load TRUE
  @4.0 SFBool [in,out] global FALSE
node ClipPlane : X3DChildNode | Rendering 5 | children
  SFBool [in,out] enabled TRUE
  SFVec4f [in,out] plane 0 1 0 0
)";

constexpr std::string_view kNavigation = R"(
abstract X3DViewpointNode : X3DBindableNode
  SFVec3f [in,out] centerOfRotation 0 0 0
  SFString [in,out] description ""
  SFBool [in,out] jump TRUE
  SFRotation [in,out] orientation 0 0 1 0
  SFVec3f [in,out] position 0 0 10
  SFBool [in,out] retainUserOffsets FALSE
  @4.0 SFFloat [in,out] farDistance -1 (0,inf)|-1
  @4.0 SFFloat [in,out] nearDistance -1 (0,inf)|-1
  @4.0 SFNode [in,out] navigationInfo NULL <NavigationInfo>
  @4.0 SFBool [in,out] viewAll FALSE
node Viewpoint : X3DViewpointNode | Navigation 1 | children
  SFFloat [in,out] fieldOfView 0.785398 (0,pi)
node OrthoViewpoint : X3DViewpointNode | Navigation 3 | children
  @3 MFFloat [in,out] fieldOfView -1 -1 1 1
  @4.0 SFVec4f [in,out] fieldOfView -1 -1 1 1
node NavigationInfo : X3DBindableNode | Navigation 1 | children
  MFFloat [in,out] avatarSize 0.25 1.6 0.75 [0,inf)
  SFBool [in,out] headlight TRUE
  SFFloat [in,out] speed 1 [0,inf)
  SFTime [in,out] transitionTime 1 [0,inf)
  MFString [in,out] transitionType "LINEAR"
  MFString [in,out] type "EXAMINE" "ANY"
  SFFloat [in,out] visibilityLimit 0 [0,inf)
  SFBool [out] transitionComplete
node Background : X3DBindableNode | EnvironmentalEffects 1 | children
  MFFloat [in,out] groundAngle [] [0,pi/2]
  MFColor [in,out] groundColor []
  MFFloat [in,out] skyAngle [] [0,pi]
  MFColor [in,out] skyColor 0 0 0
  SFFloat [in,out] transparency 0 [0,1]
  MFString [in,out] backUrl []
  MFString [in,out] bottomUrl []
  MFString [in,out] frontUrl []
  MFString [in,out] leftUrl []
  MFString [in,out] rightUrl []
  MFString [in,out] topUrl []
)";

constexpr std::string_view kLighting = R"(
abstract X3DLightNode : X3DChildNode
  SFFloat [in,out] ambientIntensity 0 [0,1]
  SFColor [in,out] color 1 1 1
  SFFloat [in,out] intensity 1 [0,inf)
  SFBool [in,out] on TRUE
  @4.0 SFFloat [in,out] shadowIntensity 1 [0,1]
  @4.0 SFBool [in,out] shadows FALSE
node DirectionalLight : X3DLightNode | Lighting 1 | children
  SFVec3f [in,out] direction 0 0 -1
  SFBool [in,out] global FALSE
node PointLight : X3DLightNode | Lighting 2 | children
  SFVec3f [in,out] attenuation 1 0 0 [0,inf)
  SFBool [in,out] global TRUE
  SFVec3f [in,out] location 0 0 0
  SFFloat [in,out] radius 100 [0,inf)
node SpotLight : X3DLightNode | Lighting 2 | children
  SFVec3f [in,out] attenuation 1 0 0 [0,inf)
  @2005 SFFloat [in,out] beamWidth 1.570796 (0,pi/2]
  @3.3 SFFloat [in,out] beamWidth 0.785398 (0,pi/2]
  @4.0 SFFloat [in,out] beamWidth 0.589049 (0,pi/2]
  @2005 SFFloat [in,out] cutOffAngle 0.785398 (0,pi/2]
  @iso SFFloat [in,out] cutOffAngle 1.570796 (0,pi/2]
  SFVec3f [in,out] direction 0 0 -1
  SFBool [in,out] global TRUE
  SFVec3f [in,out] location 0 0 0
  SFFloat [in,out] radius 100 [0,inf)
)";

constexpr std::string_view kShape = R"(
abstract X3DShapeNode : X3DChildNode X3DBoundedObject
  SFNode [in,out] appearance NULL <X3DAppearanceNode>
  @4.0 SFBool [in,out] castShadow TRUE
  SFNode [in,out] geometry NULL <X3DGeometryNode>
node Shape : X3DShapeNode | Shape 1 | children
abstract X3DAppearanceNode : X3DNode
abstract X3DAppearanceChildNode : X3DNode
abstract AcousticProperties
abstract FillProperties
abstract LineProperties
abstract PointProperties
abstract X3DShaderNode
node Appearance : X3DAppearanceNode | Shape 1 | appearance
  @4.0 SFNode [in,out] acousticProperties NULL <AcousticProperties>
  @4.0 SFFloat [in,out] alphaCutoff 0.5 [0,1]
  @4.0 SFString [in,out] alphaMode "AUTO" {AUTO OPAQUE MASK BLEND}
  @4.0 SFNode [in,out] backMaterial NULL <X3DMaterialNode>
  SFNode [in,out] fillProperties NULL <FillProperties>
  SFNode [in,out] lineProperties NULL <LineProperties>
  SFNode [in,out] material NULL <X3DMaterialNode>
  @4.0 SFNode [in,out] pointProperties NULL <PointProperties>
  MFNode [in,out] shaders [] <X3DShaderNode>
  SFNode [in,out] texture NULL <X3DTextureNode>
  SFNode [in,out] textureTransform NULL <X3DTextureTransformNode>
abstract X3DMaterialNode : X3DAppearanceChildNode
node Material : X3DMaterialNode | Shape 1 | material
  SFFloat [in,out] ambientIntensity 0.2 [0,1]
  SFColor [in,out] diffuseColor 0.8 0.8 0.8
  SFColor [in,out] emissiveColor 0 0 0
  SFFloat [in,out] shininess 0.2 [0,1]
  SFColor [in,out] specularColor 0 0 0
  SFFloat [in,out] transparency 0 [0,1]
  @4.0 SFNode [in,out] ambientTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] ambientTextureMapping ""
  @4.0 SFNode [in,out] diffuseTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] diffuseTextureMapping ""
  @4.0 SFNode [in,out] emissiveTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] emissiveTextureMapping ""
  @4.0 SFFloat [in,out] normalScale 1 [0,inf)
  @4.0 SFNode [in,out] normalTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] normalTextureMapping ""
  @4.0 SFFloat [in,out] occlusionStrength 1 [0,1]
  @4.0 SFNode [in,out] occlusionTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] occlusionTextureMapping ""
  @4.0 SFNode [in,out] shininessTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] shininessTextureMapping ""
  @4.0 SFNode [in,out] specularTexture NULL <X3DSingleTextureNode>
  @4.0 SFString [in,out] specularTextureMapping ""
)";

constexpr std::string_view kGeometry = R"(
abstract X3DGeometryNode : X3DNode
abstract X3DGeometricPropertyNode : X3DNode
abstract X3DVertexAttributeNode
abstract FogCoordinate
abstract Tangent
node Box : X3DGeometryNode | Geometry3D 1 | geometry
  SFVec3f [] size 2 2 2 (0,inf)
  SFBool [] solid TRUE
node Cone : X3DGeometryNode | Geometry3D 1 | geometry
  SFBool [in,out] bottom TRUE
  SFFloat [] bottomRadius 1 (0,inf)
  SFFloat [] height 2 (0,inf)
  SFBool [in,out] side TRUE
  SFBool [] solid TRUE
node Cylinder : X3DGeometryNode | Geometry3D 1 | geometry
  SFBool [in,out] bottom TRUE
  SFFloat [] height 2 (0,inf)
  SFFloat [] radius 1 (0,inf)
  SFBool [in,out] side TRUE
  SFBool [] solid TRUE
  SFBool [in,out] top TRUE
node Sphere : X3DGeometryNode | Geometry3D 1 | geometry
  SFFloat [] radius 1 (0,inf)
  SFBool [] solid TRUE
abstract X3DComposedGeometryNode : X3DGeometryNode
  MFNode [in,out] attrib [] <X3DVertexAttributeNode>
  SFNode [in,out] color NULL <X3DColorNode>
  SFNode [in,out] coord NULL <X3DCoordinateNode>
  SFNode [in,out] fogCoord NULL <FogCoordinate>
  SFNode [in,out] normal NULL <X3DNormalNode>
  SFNode [in,out] texCoord NULL <X3DTextureCoordinateNode>
  @4.0 SFNode [in,out] tangent NULL <Tangent>
  SFBool [] ccw TRUE
  SFBool [] colorPerVertex TRUE
  SFBool [] normalPerVertex TRUE
  SFBool [] solid TRUE
node IndexedFaceSet : X3DComposedGeometryNode | Geometry3D 2 | geometry
  MFInt32 [in] set_colorIndex
  MFInt32 [in] set_coordIndex
  MFInt32 [in] set_normalIndex
  MFInt32 [in] set_texCoordIndex
  MFInt32 [] colorIndex [] [-1,inf)
  SFBool [] convex TRUE
  MFInt32 [] coordIndex [] [-1,inf)
  SFFloat [] creaseAngle 0 [0,inf)
  MFInt32 [] normalIndex [] [-1,inf)
  MFInt32 [] texCoordIndex [] [-1,inf)
node IndexedTriangleSet : X3DComposedGeometryNode | Rendering 3 | geometry
  MFInt32 [in] set_index
  MFInt32 [] index [] [0,inf)
abstract X3DColorNode : X3DGeometricPropertyNode
node Color : X3DColorNode | Rendering 1 | color
  MFColor [in,out] color []
node ColorRGBA : X3DColorNode | Rendering 1 | color
  MFColorRGBA [in,out] color []
abstract X3DCoordinateNode : X3DGeometricPropertyNode
node Coordinate : X3DCoordinateNode | Rendering 1 | coord
  MFVec3f [in,out] point []
abstract X3DNormalNode : X3DGeometricPropertyNode
node Normal : X3DNormalNode | Rendering 1 | normal
  MFVec3f [in,out] vector []
abstract X3DTextureCoordinateNode : X3DGeometricPropertyNode
node TextureCoordinate : X3DTextureCoordinateNode | Texturing 1 | texCoord
  @4.0 SFString [in,out] mapping ""
  MFVec2f [in,out] point []
)";

constexpr std::string_view kTexturing = R"(
abstract X3DTextureNode : X3DAppearanceChildNode
  @4.0 SFString [in,out] description ""
abstract X3DSingleTextureNode : X3DTextureNode
abstract X3DTexture2DNode : X3DSingleTextureNode
  SFBool [] repeatS TRUE
  SFBool [] repeatT TRUE
  SFNode [] textureProperties NULL <TextureProperties>
node ImageTexture : X3DTexture2DNode X3DUrlObject | Texturing 1 | texture
node PixelTexture : X3DTexture2DNode | Texturing 1 | texture
  SFImage [in,out] image 0 0 0
abstract X3DTexture3DNode : X3DSingleTextureNode
  SFBool [] repeatS FALSE
  SFBool [] repeatT FALSE
  SFBool [] repeatR FALSE
  SFNode [] textureProperties NULL <TextureProperties>
node ComposedTexture3D : X3DTexture3DNode | Texturing3D 1 | texture
  MFNode [in,out] texture [] <X3DTexture2DNode>
node ImageTexture3D : X3DTexture3DNode X3DUrlObject | Texturing3D 2 | texture
node ImageTextureAtlas : X3DTexture3DNode X3DUrlObject | Texturing3D 1 | texture
  SFInt32 [in,out] numberOfSlices 0 [0,inf)
  SFInt32 [in,out] slicesOverX 0 [0,inf)
  SFInt32 [in,out] slicesOverY 0 [0,inf)
  SFInt32 [in,out] channel 0
  SFString [in,out] crossOrigin ""
  SFBool [in,out] flipY FALSE
  SFBool [in,out] hideChildren TRUE
  SFInt32 [in,out] origChannelCount 0
  SFBool [in,out] scale TRUE
node PixelTexture3D : X3DTexture3DNode | Texturing3D 1 | texture
  MFInt32 [in,out] image 0 0 0 0
node TextureProperties : X3DNode | Texturing 2 | textureProperties
  SFFloat [in,out] anisotropicDegree 1 [1,inf)
  SFColorRGBA [in,out] borderColor 0 0 0 0
  SFInt32 [in,out] borderWidth 0 [0,1]
  SFString [in,out] boundaryModeS "REPEAT" {CLAMP CLAMP_TO_EDGE CLAMP_TO_BOUNDARY MIRRORED_REPEAT REPEAT}
  SFString [in,out] boundaryModeT "REPEAT" {CLAMP CLAMP_TO_EDGE CLAMP_TO_BOUNDARY MIRRORED_REPEAT REPEAT}
  SFString [in,out] boundaryModeR "REPEAT" {CLAMP CLAMP_TO_EDGE CLAMP_TO_BOUNDARY MIRRORED_REPEAT REPEAT}
  SFString [in,out] magnificationFilter "FASTEST" {AVG_PIXEL DEFAULT FASTEST NEAREST_PIXEL NICEST}
  SFString [in,out] minificationFilter "FASTEST" {AVG_PIXEL AVG_PIXEL_AVG_MIPMAP AVG_PIXEL_NEAREST_MIPMAP DEFAULT FASTEST NEAREST_PIXEL NEAREST_PIXEL_AVG_MIPMAP NEAREST_PIXEL_NEAREST_MIPMAP NICEST}
  SFString [in,out] textureCompression "FASTEST" {DEFAULT FASTEST HIGH LOW MEDIUM NICEST}
  SFFloat [in,out] texturePriority 0 [0,1]
  SFBool [] generateMipMaps FALSE
abstract X3DTextureTransformNode : X3DAppearanceChildNode
node TextureTransform : X3DTextureTransformNode | Texturing 1 | textureTransform
  SFVec2f [in,out] center 0 0
  @4.0 SFString [in,out] mapping ""
  SFFloat [in,out] rotation 0
  SFVec2f [in,out] scale 1 1
  SFVec2f [in,out] translation 0 0
)";

constexpr std::string_view kAnimation = R"(
node TimeSensor : X3DSensorNode | Time 1 | children
  SFTime [in,out] cycleInterval 1 (0,inf)
  SFBool [in,out] loop FALSE
  SFTime [in,out] pauseTime 0
  SFTime [in,out] resumeTime 0
  SFTime [in,out] startTime 0
  SFTime [in,out] stopTime 0
  SFTime [out] cycleTime
  SFTime [out] elapsedTime
  SFFloat [out] fraction_changed
  SFBool [out] isPaused
  SFTime [out] time
node TouchSensor : X3DSensorNode | PointingDeviceSensor 1 | children
  SFString [in,out] description ""
  SFVec3f [out] hitNormal_changed
  SFVec3f [out] hitPoint_changed
  SFVec2f [out] hitTexCoord_changed
  SFBool [out] isOver
  SFTime [out] touchTime
abstract X3DInterpolatorNode : X3DChildNode
  SFFloat [in] set_fraction
  MFFloat [in,out] key []
node ColorInterpolator : X3DInterpolatorNode | Interpolation 1 | children
  MFColor [in,out] keyValue []
  SFColor [out] value_changed
node OrientationInterpolator : X3DInterpolatorNode | Interpolation 1 | children
  MFRotation [in,out] keyValue []
  SFRotation [out] value_changed
node PositionInterpolator : X3DInterpolatorNode | Interpolation 1 | children
  MFVec3f [in,out] keyValue []
  SFVec3f [out] value_changed
node ScalarInterpolator : X3DInterpolatorNode | Interpolation 1 | children
  MFFloat [in,out] keyValue []
  SFFloat [out] value_changed
)";

constexpr std::string_view kVolumes = R"(
abstract X3DVolumeDataNode : X3DChildNode X3DBoundedObject
  @2005 SFVec3f [in,out] dimensions 1 1 1 [0,inf)
  @iso SFVec3f [in,out] dimensions 1 1 1 (0,inf)
node VolumeData : X3DVolumeDataNode | VolumeRendering 1 | children
  SFNode [in,out] renderStyle NULL <X3DVolumeRenderStyleNode>
  @2005 MFNode [in,out] voxels [] <X3DTexture3DNode>
  @iso SFNode [in,out] voxels NULL <X3DTexture3DNode>
node SegmentedVolumeData : X3DVolumeDataNode | VolumeRendering 3/2 | children
  @2005 SFVec3f [in,out] dimensions 1 1 1 (0,inf)
  MFNode [in,out] renderStyle [] <X3DVolumeRenderStyleNode>
  MFBool [in,out] segmentEnabled []
  @2005 SFNode [in,out] segmentedVoxels NULL <X3DTexture3DNode>
  @iso SFNode [in,out] voxels NULL <X3DTexture3DNode>
  @iso SFNode [in,out] segmentIdentifiers NULL <X3DTexture3DNode>
node IsoSurfaceVolumeData@iso : X3DVolumeDataNode | VolumeRendering 2 | children
  SFFloat [in,out] contourStepSize 0
  SFNode [in,out] gradients NULL <X3DTexture3DNode>
  MFNode [in,out] renderStyle [] <X3DVolumeRenderStyleNode>
  SFFloat [in,out] surfaceTolerance 0 [0,inf)
  MFFloat [in,out] surfaceValues [] ~[0,1]
  SFNode [in,out] voxels NULL <X3DTexture3DNode>
node OctTree@2005 : X3DChildNode X3DBoundedObject | VolumeRendering 1 | children
  MFNode [in,out] highRes [] <X3DChildNode>
  SFNode [in,out] lowRes NULL <X3DGroupingNode X3DShapeNode X3DVolumeDataNode>
  SFBool [out] lowResActive
  SFVec3f [] center 0 0 0
  SFFloat [] range 20 [0,inf)
)";

constexpr std::string_view kStyles = R"(
abstract X3DVolumeRenderStyleNode : X3DNode
  SFBool [in,out] enabled TRUE
abstract X3DComposableVolumeRenderStyleNode : X3DVolumeRenderStyleNode
abstract ShadableStyle : X3DComposableVolumeRenderStyleNode
  SFNode [in,out] surfaceNormals NULL <X3DTexture3DNode>
node OpacityMapVolumeStyle : X3DComposableVolumeRenderStyleNode | VolumeRendering 1 | renderStyle
  SFNode [in,out] transferFunction NULL <X3DTexture2DNode X3DTexture3DNode>
node BoundaryEnhancementVolumeStyle : X3DComposableVolumeRenderStyleNode | VolumeRendering 2 | renderStyle
  @2005 SFFloat [in,out] retainedOpacity 1 [0,1]
  @iso SFFloat [in,out] retainedOpacity 0.2 [0,1]
  @2005 SFFloat [in,out] boundaryOpacity 0 [0,inf)
  @iso SFFloat [in,out] boundaryOpacity 0.9 [0,1]
  @2005 SFFloat [in,out] opacityFactor 1 [0,inf)
  @iso SFFloat [in,out] opacityFactor 2 [1,inf)
  @2005 SFFloat [in,out] contribution 0.2 [0,1]
  @2005 SFColorRGBA [in,out] gradientColor 0 0 0 1
  @2005 SFNode [in,out] surfaceNormals NULL <X3DTexture3DNode>
  @2005 SFNode [in,out] transferFunction NULL <X3DTexture2DNode X3DTexture3DNode>
node CartoonVolumeStyle : ShadableStyle | VolumeRendering 3 | renderStyle
  SFColorRGBA [in,out] parallelColor 0 0 0 1
  SFColorRGBA [in,out] orthogonalColor 1 1 1 1
  SFInt32 [in,out] colorSteps 4 [1,64]
node ComposedVolumeStyle@iso CompositeVolumeStyle@2005 : X3DComposableVolumeRenderStyleNode | VolumeRendering 2/3 | renderStyle
  @iso MFNode [in,out] renderStyle [] <X3DComposableVolumeRenderStyleNode>
  @2005 MFNode [in,out] styles=renderStyle [] <X3DVolumeRenderStyleNode>
  @2005 SFBool [in,out] ordered FALSE
node EdgeEnhancementVolumeStyle : ShadableStyle | VolumeRendering 2 | renderStyle
  SFColorRGBA [in,out] edgeColor 0 0 0 1
  @2005 SFFloat [in,out] gradientThreshold 0.4 [0,pi/2]
  @iso SFFloat [in,out] gradientThreshold 0.4 [0,pi]
  @2005 SFFloat [in,out] contribution 0.2 [0,1]
node ISOSurfaceVolumeStyle@2005 ISOVolumeStyle@2005 : ShadableStyle | VolumeRendering 3 | renderStyle
  SFBool [in,out] lighting FALSE
  SFBool [in,out] shadows FALSE
node ShadedVolumeStyle@iso : ShadableStyle | VolumeRendering 3 | renderStyle
  SFBool [in,out] lighting FALSE
  SFBool [in,out] shadows FALSE
  SFNode [in,out] material NULL <X3DMaterialNode>
  SFString [] phaseFunction "Henyey-Greenstein" {Henyey-Greenstein NONE}
node ProjectionVolumeStyle@iso : X3DVolumeRenderStyleNode | VolumeRendering 2 | renderStyle
  SFString [in,out] type "MAX" {MAX MIN AVERAGE}
  SFFloat [in,out] intensityThreshold 0 [0,inf) ~[0,1]
node SilhouetteEnhancementVolumeStyle : ShadableStyle | VolumeRendering 3/2 | renderStyle
  @iso SFFloat [in,out] silhouetteSharpness 0.5 [0,inf)
  @2005 SFFloat [in,out] silhouetteFactor=silhouetteSharpness 0.5 [0,inf)
  @iso SFFloat [in,out] silhouetteRetainedOpacity 1 [0,1]
  @iso SFFloat [in,out] silhouetteBoundaryOpacity 0 [0,1]
node StippleVolumeStyle@2005 : X3DComposableVolumeRenderStyleNode | VolumeRendering 3 | renderStyle
  SFFloat [in,out] distanceFactor 1 [0,inf)
  SFFloat [in,out] interiorFactor 1 [0,inf)
  SFFloat [in,out] lightingFactor 1 [0,inf)
  SFFloat [in,out] gradientThreshold 0.4 [0,pi/2]
  SFFloat [in,out] gradientRetainedOpacity 1 [0,1]
  SFFloat [in,out] gradientBoundaryOpacity 0 [0,inf)
  SFFloat [in,out] gradientOpacityFactor 1 [0,inf)
  SFFloat [in,out] silhouetteRetainedOpacity 1 [0,1]
  SFFloat [in,out] silhouetteBoundaryOpacity 0 [0,inf)
  SFFloat [in,out] silhouetteOpacityFactor 1 [0,inf)
  SFFloat [in,out] resolutionFactor 1 [0,inf)
node ToneMappedVolumeStyle : ShadableStyle | VolumeRendering 3/2 | renderStyle
  SFColorRGBA [in,out] coolColor 0 0 1 0
  SFColorRGBA [in,out] warmColor 1 1 0 0
node BlendedVolumeStyle@iso : X3DComposableVolumeRenderStyleNode | VolumeRendering 3 | renderStyle
  SFNode [in,out] renderStyle NULL <X3DComposableVolumeRenderStyleNode>
  SFNode [in,out] voxels NULL <X3DTexture3DNode>
  SFFloat [in,out] weightConstant1 0.5 [0,1]
  SFFloat [in,out] weightConstant2 0.5 [0,1]
  SFString [in,out] weightFunction1 "CONSTANT" {CONSTANT ALPHA0 ALPHA1 ONE_MINUS_ALPHA0 ONE_MINUS_ALPHA1 TABLE}
  SFString [in,out] weightFunction2 "CONSTANT" {CONSTANT ALPHA0 ALPHA1 ONE_MINUS_ALPHA0 ONE_MINUS_ALPHA1 TABLE}
  SFNode [in,out] weightTransferFunction1 NULL <X3DTexture2DNode>
  SFNode [in,out] weightTransferFunction2 NULL <X3DTexture2DNode>
)";

} // namespace

std::array<std::string_view, 10> nodeDeclarations()
{
    return {kCore,     kGrouping,  kNavigation, kLighting, kShape,
            kGeometry, kTexturing, kAnimation,  kVolumes,  kStyles};
}

} // namespace vo
