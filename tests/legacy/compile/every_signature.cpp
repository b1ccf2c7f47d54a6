// Every signature of the face, exactly as the guide prints it or as its programs use it; page numbers are the
// guide's. C++98, so that it compiles in every dialect; EVERY_SIGNATURE is the name of the one function here.

#include <vo/GeometryActions.h>
#include <vo/AppearanceActions.h>
#include <vo/LookupTable.h>
#include <vo/utPerfMeter.h>
#include <vo/Error.h>

#include <sstream>

namespace {

int signatures = 0;

// Naming a function as a pointer of an exact type compiles only when that very signature exists.
template <class T>
void is(T)
{
    ++signatures;
}

template <class T>
void isPrintableAsInt(T value)
{
    char text[16];
    sprintf(text, "%d", (int)value);
    switch ((int)value) {
    default: ++signatures;
    }
}

void myHandler(void) {}

void basics()
{
    voBool flag = VO_TRUE;
    flag = VO_FALSE;
    flag = 1 < 2;
    is(flag);
    is<const char* (*)()>(&voVersion);
    static int cubeIndices[] = {
        0, 2, 5, 7, 3, 2, 0, 7, 1, 2, 5, 0, 2, 7, 6, 5, 5, 4, 0, 7,
    };
    enum { tetraCount = sizeof(cubeIndices) / (VO_TETRA_VERTICES * sizeof(cubeIndices[0])) };
    is((int)tetraCount);
    is(cubeIndices);
    GLdouble d = 0;
    GLenum e = 0;
    GLboolean b = GL_TRUE;
    is(d);
    is(e);
    is(b);
}

void enumerations()
{
    isPrintableAsInt(voInterpolationTypeScope::DEFAULT);
    isPrintableAsInt(voRenderingModeScope::COLOR);
    isPrintableAsInt(voDataTypeScope::UNSIGNED_INT_10_10_10_2_EXT);
    isPrintableAsInt(voInternalFormatTypeScope::DUAL_LUMINANCE_ALPHA8_SGIS);
    isPrintableAsInt(voExternalFormatTypeScope::ABGR_EXT);
    isPrintableAsInt(voPartialBrickTypeScope::AUGMENT_TIGHT);
    isPrintableAsInt(voOptimizeVolumeTypeScope::BEST);
    isPrintableAsInt(voPlaneOrientationScope::YZ);
    isPrintableAsInt(voSamplingModeScope::BEST_PERFORMANCE);
    isPrintableAsInt(voSamplingSpaceScope::PRIMITIVE);
    isPrintableAsInt(voInterleavedArrayTypeScope::USER_V3F);
    isPrintableAsInt(voErrorTypeScope::UNSUPPORTED);
    isPrintableAsInt(voLookupTableTypeScope::PRE_INTERPOLATION);
    isPrintableAsInt(voLookupTableShapeScope::LINEAR);
    isPrintableAsInt(voDecorationFlagsScope::ALL);
    // The global name is the type of the nested values.
    voInterpolationType interpolation = (voInterpolationType)2;
    voOptimizeVolumeType optimize = (voOptimizeVolumeType)(int)(voOptimizeVolumeTypeScope::INTERLEAVE |
                                                                voOptimizeVolumeTypeScope::TEXTURE_OBJECTS);
    voDataType data = voDataTypeScope::DEFAULT;
    is(interpolation);
    is(optimize);
    is(data);
}

void errors()
{
    is<voErrorType (*)()>(&voError::getErrorNumber);
    is<const char* (*)()>(&voError::getErrorString);
    is<void (*)(voErrorType)>(&voError::setErrorNumber);
    is<void (*)(int)>(&voError::setErrorNumber);
    is<void (*)(const char*)>(&voError::setErrorString);
    is<void (*(*)(void (*)(void)))(void)>(&voError::setErrorHandler);
    is<void (*)()>(&voError::callErrorHandler);
    is<void (*)(int)>(&voError::setDebugLevel);
    is<void (*)(FILE*)>(&voError::setDebugStream);
    is<void (*)(std::ostream&)>(&voError::setDebugStream);
    // Pages 63 and 64.
    void (*previous)(void) = voError::setErrorHandler(myHandler);
    if (voError::getErrorNumber() != voError::NO_ERROR)
        fprintf(stderr, "voError %s\n", voError::getErrorString());
    if (voError::getErrorNumber() != voErrorTypeScope::NO_ERROR)
        fprintf(stderr, "OpenGL Volumizer error %d: %s\n", voError::getErrorNumber(),
                voError::getErrorString());
    voError::setErrorHandler(previous);
}

void geometry()
{
    float values[8 * 3] = {0};
    int entries[4] = {0, 1, 2, 3};
    // Pages 47, 104.
    voVertexData own(4, 3), borrowed(8, 3, values);
    own.empty();
    is<float* (voVertexData::*)(int)>(&voVertexData::operator[]);
    is<int (voVertexData::*)() const>(&voVertexData::getCount);
    is<void (voVertexData::*)(int)>(&voVertexData::setCount);
    is<int (voVertexData::*)() const>(&voVertexData::getCountMax);
    is<int (voVertexData::*)() const>(&voVertexData::getValuesPerVertex);
    is<float* (voVertexData::*)()>(&voVertexData::getDataPtr);
    voIndices ownIndices(4), borrowedIndices(4, entries);
    is<int& (voIndices::*)(int)>(&voIndices::operator[]);
    is<void (voIndices::*)()>(&voIndices::empty);
    // Pages 105 to 110.
    voIndexedFaceSet faces(10, 3, 40), sharing(&own, boundFaceCount(5)),
        *noRoom = new voIndexedFaceSet(&own, 0);
    delete noRoom;
    faces.appendPoly(values, 3);
    faces.appendPoly(NULL, 3);
    voIndexedSet* set = &faces;
    is<void (voIndexedSet::*)()>(&voIndexedSet::empty);
    is<float* (voIndexedSet::*)(int)>(&voIndexedSet::operator[]);
    voVertexData* vertices = set->getVertexData();
    voIndices* indices = set->getIndices();
    is(vertices);
    is(indices);
    voIndexedFaceSetIterator iter(&faces);
    for (; !iter.doneP(); iter.nextPrimitive())
        while (float* vertex = iter.nextVertex())
            is(vertex);
    is(iter.done());
    voIndexedTetraSet data(values, 8, 3, entries, 4);
    voIndexedTetraSet room(8, 3, 20);
    voIndexedTetraSet parts(&borrowed, &borrowedIndices);
    voIndexedTetraSetIterator tetras(&data);
    (*room.getVertexData())[7][2] = 1;
    (*room.getIndices())[19] = 7;
    room.getVertexData()->setCount(8);
    room.getIndices()->setCount(20);
    voIndexedFaceSetPtrPtr* aPolygonSetArray = new voIndexedFaceSetPtrPtr[2];
    aPolygonSetArray[0] = new voIndexedFaceSetPtr[3];
    delete[] aPolygonSetArray[0];
    delete[] aPolygonSetArray;
    voFaceSet* alias = &faces;
    is(alias);
    is<int (*)(int)>(&boundFaceCount);
    is<voBool (*)(voInterleavedArrayType)>(&hasTextureComponent);
    is<int (*)(voInterleavedArrayType)>(&getValuesPerVertex);
}

void geometryActions()
{
    typedef voGeometryActions A;
    // Pages 79 and 50.
    is<int (*)(voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, GLdouble[16], GLdouble[16],
               voSamplingMode, voSamplingSpace, float[3], int, int&, voIndexedFaceSet***)>(&A::polygonize);
    is<int (*)(voIndexedTetraSet*, voBrickSet*, GLdouble[16], GLdouble[16], voSamplingMode, voSamplingSpace,
               int&, float[3], voIndexedFaceSet***)>(&A::polygonize);
    // Page 121.
    is<int (*)(float[4], voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)>(&A::polygonizeMPR);
    is<int (*)(voVertexData*, voBrickSet*, voIndexedFaceSet***, voInterleavedArrayType)>(&A::polygonizeMPR);
    // Pages 150 to 154.
    is<int (*)(float[4][3], float[4], voVertexData*)>(&A::sample);
    is<int (*)(voVertexData*, voInterleavedArrayType, float[3], float[3], voIndexedFaceSet*)>(&A::clip);
    is<int (*)(voVertexData*, float[3], float[3], voIndexedFaceSet*)>(&A::clip);
    is<int (*)(voVertexData*, voInterleavedArrayType, float*, int, voIndexedFaceSet*)>(&A::clip);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&sample);
    is<int (*)(voVertexData*, float[3], float[3], voIndexedFaceSet*)>(&clip);
    // Pages 58, 78, 140, 142, 156, 160.
    is<void (*)(voIndexedFaceSet*, voInterleavedArrayType)>(&A::draw);
    is<void (*)(voIndexedFaceSet*, GLenum, voInterleavedArrayType)>(&A::draw);
    is<void (*)(voIndexedTetraSet*, voInterleavedArrayType)>(&A::draw);
    is<void (*)(voIndexedTetraSet*, GLenum, voInterleavedArrayType)>(&A::draw);
    is<void (*)(voBrick*)>(&A::draw);
    is<void (*)(voBrickSet*)>(&A::draw);
    is<int (*)(voIndexedTetraSet*, voInterleavedArrayType, voBrickSetCollection*, voDrawActionCache*,
               voSamplingSpace, float[3], voDecorationFlags)>(&A::drawUtility);
    // Pages 126 and 127.
    is<voBool (*)(int[2], int[4], voIndexedTetraSet*, voBrickSet*, voInterleavedArrayType, GLdouble[16],
                  GLdouble[16], float[3], voBool, voVertexData*, void*)>(&A::pick);
    is<voBool (*)(int[2], int[4], voIndexedTetraSet*, voBrick*, voInterleavedArrayType, GLdouble[16],
                  GLdouble[16], float[3], voBool, voVertexData*, void*)>(&A::pick);
    is<void (*)(double[3], double[4], GLdouble[16], GLdouble[16])>(&A::findCameraPosition);
    is<void (*)(double[3], GLdouble[16], GLdouble[16])>(&A::findViewDirection);
    // Pages 143, 151, 154.
    is<voPlaneOrientation (*)(GLdouble[16], GLdouble[16], int)>(&A::findClosestAxisIndex);
    is<voPlaneOrientation (*)(GLdouble[16], GLdouble[16], int)>(&findClosestAxisIndex);
    is<float (*)(voIndexedFaceSet*, GLdouble[16], GLdouble[16], GLint[4])>(&A::findProjectedArea);
    // Pages 56, 98, 115.
    GLdouble matrix[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    voBrickSetCollection volume(
        8, 8, 8, 8, 8, 8, voPartialBrickTypeScope::TRUNCATE, 1, voInternalFormatTypeScope::INTENSITY8_EXT,
        voExternalFormatTypeScope::LUMINANCE, voDataTypeScope::UNSIGNED_BYTE, voInterpolationTypeScope::_3D);
    voSortAction aSortAction(volume.getCurrentBrickSet(), matrix, matrix);
    int brickSortedNo = aSortAction[0];
    is(brickSortedNo);
    voGeometryActions::voSortAction nested(volume.getCurrentBrickSet(), matrix, matrix);
    voIndexedTetraSet tetras(8, 3, 20);
    voDrawActionCache cache(&tetras, &volume, 256, voSamplingModeScope::VIEWPORT_ALIGNED,
                            tetras.getVertexData()->getValuesPerVertex(), 250000);
    cache.setThreshold(2);
    voCache* base = &cache;
    is(base);
    voGeometryAction* renamed = NULL;
    is(renamed);
}

void appearance()
{
    is<void (voBrick::*)(float, float, float, float, float, float)>(&voBrick::setBrickSizes);
    is<void (voBrick::*)(int&, int&, int&, int&, int&, int&) const>(&voBrick::getBrickSizes);
    is<void (voBrick::*)(float*, float*) const>(&voBrick::getBrickSizes);
    is<void (voBrick::*)(float*, float*) const>(&voBrick::getClipBrickSizes);
    is<void* (voTexture3D::*)() const>(&voTexture3D::getDataPtr);
    is<void (voTexture3D::*)(void*)>(&voTexture3D::setDataPtr);
    is<voInternalFormatType (voTexture3D::*)() const>(&voTexture3D::getInternalFormat);
    is<voExternalFormatType (voTexture3D::*)() const>(&voTexture3D::getExternalFormat);
    is<voDataType (voTexture3D::*)() const>(&voTexture3D::getDataType);
    is<int (voBrickSet::*)() const>(&voBrickSet::getBrickCount);
    is<voBrick* (voBrickSet::*)(int) const>(&voBrickSet::getBrick);
    is<void (voBrickSet::*)(int&, int&, int&) const>(&voBrickSet::getVolumeSizes);
    is<voPlaneOrientation (voBrickSet::*)() const>(&voBrickSet::getOrientation);
    is<voBrick* (voBrickSetIterator::*)()>(&voBrickSetIterator::operator());
    is<voBrickSet* (voBrickSetCollectionIterator::*)()>(&voBrickSetCollectionIterator::operator());
    is<void (voBrickSetCollection::*)(voPlaneOrientation)>(&voBrickSetCollection::setCurrentBrickSet);
    is<voBrickSet* (voBrickSetCollection::*)() const>(&voBrickSetCollection::getCurrentBrickSet);
    is<voInterpolationType (voBrickSetCollection::*)() const>(&voBrickSetCollection::getInterpolationType);
    is<void (voBrickSetCollection::*)(voBool)>(&voBrickSetCollection::setDirtyFlag);
    is<voBrickSet * voBrickSetCollection::*>(&voBrickSetCollection::currentBrickSet);
    is<voInterpolationType voBrickSetCollection::*>(&voBrickSetCollection::interpolationType);
}

void appearanceActions()
{
    typedef voAppearanceActions A;
    is<int (*)(voInterpolationType&, voRenderingMode, voDataType, voExternalFormatType, voInternalFormatType&,
               voExternalFormatType&, int&, int&, int&)>(&A::getBestParameters);
    is<void* (*)(voTexture3D*)>(&A::dataAlloc);
    is<void* (*)(voBrickSet*)>(&A::dataAlloc);
    is<void (*)(voTexture3D*)>(&A::dataFree);
    is<void (*)(voBrickSet*)>(&A::dataFree);
    is<int (*)(voTexture3D*, float&, float&)>(&A::dataScaleRange);
    is<int (*)(voTexture3D*, void*, voExternalFormatType)>(&A::dataConvert);
    is<int (*)(voTexture3D*, void*, voDataType)>(&A::dataConvert);
    is<int (*)(voBrickSetCollection*)>(&A::volumeMakeTransposed);
    is<int (*)(voBrickSetCollection*, int)>(&A::volumeOptimize);
    is<int (*)(voBrickSetCollection*)>(&A::volumeUnoptimize);
    is<int (*)(voTexture3D*, voTexture3D*)>(&A::textureInterleave);
    is<voBool (*)(voTexture3D*, voTexture3D*)>(&A::cliqueTest);
    is<void (*)(voInterpolationType)>(&A::textureEnable);
    is<void (*)(voInterpolationType)>(&A::textureDisable);
    is<void (*)()>(&A::texgenEnable);
    is<void (*)()>(&A::texgenDisable);
    is<void (*)(voBrick*)>(&A::texgenSetEquation);
    is<int (*)(voTexture3D*)>(&A::textureBind);
    is<int (*)(voTexture3D*)>(&A::textureLoad);
    is<void (*)(voBrick*, float*)>(&A::textureMakeMatrix);
    is<void (*)(voBrick*, voIndexedFaceSet*, voInterleavedArrayType, voPlaneOrientation)>(
        &A::xfmVox2TexCoords);
    is<void (*)(voBrickSet*, int, voIndexedFaceSet***, voInterleavedArrayType)>(&A::xfmVox2TexCoords);
    is<int (*)(voVertexData*, voInterleavedArrayType, float[3], float[3], voIndexedFaceSet*)>(&A::clip);
    is<int (*)(voVertexData*, voInterleavedArrayType, float*, int, voIndexedFaceSet*)>(&A::clip);
    is<int (*)(float[4][3], float[4], voVertexData*)>(&A::sample);
    voTexture3DActions* oneName = NULL;
    Texture3DActions* otherName = oneName;
    is(otherName);
    voInternalFormatType internalFormat;
    voExternalFormatType externalFormat;
    int xBrickSize = 8, yBrickSize = 8, zBrickSize = 8;
    voAppearanceActions::getBestParameters(voInterpolationTypeScope::_3D, voRenderingModeScope::MONOCHROME,
                                           voDataTypeScope::UNSIGNED_BYTE,
                                           voExternalFormatTypeScope::INTENSITY, internalFormat,
                                           externalFormat, xBrickSize, yBrickSize, zBrickSize);
    voBrick brick(internalFormat, externalFormat, voDataTypeScope::UNSIGNED_BYTE);
    voAppearanceActions::dataScaleRange(&brick, -1, -1);
    voAppearanceActions::dataScaleRange(&brick, -1.0, -1.0);
    (void)voAppearanceActions::dataAlloc(&brick);
}

void lookup()
{
    // Page 61.
    static float lookupEntries[2 * 256];
    voTextureLookupPost* aLookupTable = new voTextureLookupPost(
        voInternalFormatTypeScope::LUMINANCE8_ALPHA8_EXT, 256, voExternalFormatTypeScope::LUMINANCE_ALPHA,
        voDataTypeScope::FLOAT, lookupEntries);
    for (int j1 = 0; j1 < 256; j1++)
        lookupEntries[2 * j1] = lookupEntries[2 * j1 + 1] = 0.5 * (float)j1 / 256.0;
    aLookupTable->load();
    aLookupTable->enable();
    aLookupTable->set(voTextureLookup::LINEAR, 195, 50);
    aLookupTable->set(voLookupTableShapeScope::LINEAR, 195, 50);
    aLookupTable->disable();
    voLookupTable* base = aLookupTable;
    delete base;
    voInternalFormatType internalFormat = voInternalFormatTypeScope::RGBA8_EXT;
    voExternalFormatType externalFormat = voExternalFormatTypeScope::RGBA;
    voDataType dataType = voDataTypeScope::FLOAT;
    voLookupTablePre pre(internalFormat, 256, externalFormat, dataType);
    voLookupTablePost post(internalFormat, 256, externalFormat, dataType, NULL);
    voLookupTablePre gl(GL_RGBA8, 256, GL_RGBA, GL_FLOAT, lookupEntries);
    is<voLookupTableType (voLookupTable::*)() const>(&voLookupTable::getType);
    is<int (*)(voBrickSetCollection*, voRenderingMode, int, voLookupTableType&, voInternalFormatType&,
               voExternalFormatType&, voDataType&)>(&voLookupTable::getBestParameters);
}

void timers()
{
    voutTimer timer;
    timer.start();
    timer.stop();
    std::ostringstream out;
    out << timer;
    is<std::ostream& (*)(std::ostream&, const voutTimer&)>(&operator<<);
}

} // namespace

/// The number of signatures that were there.
int EVERY_SIGNATURE()
{
    signatures = 0;
    basics();
    enumerations();
    errors();
    geometry();
    geometryActions();
    appearance();
    appearanceActions();
    lookup();
    timers();
    return signatures;
}
