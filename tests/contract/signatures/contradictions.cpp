// C: where the guide disagrees with itself, both spellings.

#include <vo/Volumizer.h>
#include <vo/CompatNames.h>

#include "rows.h"

namespace DIALECT {

static void values()
{
    ROW(C1);
    voInterpolationType unset = (voInterpolationType)-1;
    is(unset);
    ROW(C2);
    static int fromZero[voInterleavedArrayTypeScope::V3F == 0 ? 1 : -1];
    is(fromZero);
    ROW(C3);
    voDataType packed = voDataTypeScope::INT_8_8_8_8_EXT;
    packed = voDataTypeScope::INT_10_10_10_2_EXT;
    packed = voDataTypeScope::SHORT;
    is(packed);
    ROW(C4);
    voInternalFormatType format = voInternalFormatTypeScope::RGB88_EXT;
    format = voInternalFormatTypeScope::RGB84_EXT;
    format = voInternalFormatTypeScope::RGB44_EXT;
    is(format);
    ROW(C5);
    is(voOptimizeVolumeTypeScope::BEST == voOptimizeVolumeTypeScope::BEST_PERFORMANCE);
    ROW(C6);
    is(voError::NO_ERROR == voErrorTypeScope::NO_ERROR);
    ROW(C8);
    is(INTENSITY == voExternalFormatTypeScope::INTENSITY && _DATA_TYPE_FLOAT == voDataTypeScope::FLOAT &&
       _SAMPLE_OVER_OBJECT == voSamplingSpaceScope::OBJECT);
}

static void names()
{
    ROW(C9);
    voTextureLookupPost post(voInternalFormatTypeScope::RGBA8_EXT, 256, voExternalFormatTypeScope::RGBA,
                             voDataTypeScope::FLOAT);
    voLookupTablePost* same = &post;
    same->set(voTextureLookup::LINEAR, 195, 50);
    same->set(voLookupTable::LINEAR, 195, 50);
    ROW(C10);
    voIndexedFaceSet aFaceSet(4, 3, 5);
    voIndexedFaceSetIterator iter(&aFaceSet);
    is(iter.done() == iter.doneP());
    ROW(C11);
    ROW(C12);
    voTexture3DActions* appearance = NULL;
    Texture3DActions* sameAppearance = appearance;
    voAppearanceActions* sameAgain = sameAppearance;
    is(sameAgain);
    voGeometryAction* geometry = NULL;
    voGeometryActions* sameGeometry = geometry;
    is(sameGeometry);
    voGeometryActions::voSortAction* sort = NULL;
    voSortAction* sameSort = sort;
    is(sameSort);
    voFaceSet* faces = &aFaceSet;
    is(faces);
}

static void overloads()
{
    ROW(C13);
    is<int (*)(voIndexedTetraSet*, voBrickSet*, GLdouble[16], GLdouble[16], voSamplingMode, voSamplingSpace,
               int&, float[3], voIndexedFaceSet***)>(&voGeometryAction::polygonize);
    ROW(C14);
    is<int (*)(voVertexData*, voInterleavedArrayType, float*, int, voIndexedFaceSet*)>(
        &voAppearanceActions::clip);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&voAppearanceActions::sample);
    is<int (*)(voVertexData*, float[3], float[3], voIndexedFaceSet*)>(&clip);
    ROW(C15);
    is<void (*)(voIndexedFaceSet*, GLenum, voInterleavedArrayType)>(&voGeometryActions::draw);
    ROW(C16);
    ROW(C17);
    is<voPlaneOrientation (*)(GLdouble[16], GLdouble[16], int)>(&findClosestAxisIndex);
}

static void volumes()
{
    ROW(C18);
    ROW(C19);
    ROW(C20);
    voBrickSetCollection volume(
        9, 7, 5, 9, 7, 5, voPartialBrickTypeScope::TRUNCATE, 1, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    voBrickSetCollection* aVolume = &volume;
    ROW(C21);
    voBrick* aBrick = aVolume->currentBrickSet->getBrick(0);
    if (aVolume->interpolationType == voInterpolationTypeScope::_2D) aBrick = NULL;
    ROW(C22);
    const voInterpolationType constant = voInterpolationTypeScope::DEFAULT;
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    int x = 8, y = 8, z = 8;
    voAppearanceActions::getBestParameters(constant, voRenderingModeScope::COLOR, voDataTypeScope::FLOAT,
                                           voExternalFormatTypeScope::RGBA, internalFormat, externalFormat, x,
                                           y, z);
    ROW(C23);
    unsigned char* vdata = (unsigned char*)voTexture3DActions::dataAlloc(aBrick);
    ROW(C24);
    float loValue = -1.0, hiValue = -1.0;
    voAppearanceActions::dataScaleRange(aBrick, loValue, hiValue);
    voAppearanceActions::dataScaleRange(aBrick, -1, -1);
    ROW(C25);
    voAppearanceActions::dataConvert(aBrick, vdata, _DATA_TYPE_UNSIGNED_BYTE);
    Texture3DActions::dataConvert(aBrick, vdata, INTENSITY);
    ROW(C26);
    voLookupTablePre enumerated(LUMINANCE8_ALPHA8_EXT, 256, LUMINANCE_ALPHA, _DATA_TYPE_FLOAT);
    voLookupTablePre constants(GL_LUMINANCE8_ALPHA8, 256, GL_LUMINANCE_ALPHA, GL_FLOAT);
}

void contradictions()
{
    values();
    names();
    overloads();
    volumes();
    ROW(C27);
    is<voIndexedTetraSet* (voutGeometry::*)()>(&voutGeometry::tessellate);
    is<voIndexedTetraSet* (voutGeometry::*)()>(&voutGeometry::tesselate);
    ROW(C28);
    voutIndexedTetraFaceStrip strip(4, 3, 4);
    ROW(C34);
    is<int (*)(voIndexedTetraSet*, voInterleavedArrayType, voBrickSetCollection*, voDrawActionCache*,
               voSamplingSpace, float[3], voDecorationFlags)>(&voGeometryActions::drawUtility);
    ROW(C35);
    voExternalFormatType twoChannels = voExternalFormatTypeScope::LUMINANCE_ALPHA;
    is(twoChannels);
    ROW(C36);
    voIndexedFaceSet* single = new voIndexedFaceSet(1000, 3, 5000);
    delete single;
    ROW(C37);
    voLookupTablePre pre(RGBA8_EXT, 256, RGBA, _DATA_TYPE_FLOAT);
    voLookupTablePost post(RGBA8_EXT, 256, RGBA, _DATA_TYPE_FLOAT);
}

} // namespace DIALECT
