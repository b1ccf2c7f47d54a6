// No guard: included once a dialect, with DIALECT as its name. What the guide's chapters 3, 6, 7 and 8 print,
// in functions that give their results to chapters_gl_test.cpp; pages are the guide's. Volumes are cubes of
// one byte a voxel, read by the myReadBrickIfl of the test.

class voLookupTable;

namespace DIALECT {

// Chapter 3, in the order of a program.

/// Pages 36 to 44: a volume of size^3 voxels from a file of one channel, in bricks of brickSize^3, overlap 1.
/// The external format is the one suggested, or the given one if that is not DEFAULT.
voBrickSetCollection* readVolume(char* dataFileName, int size, int brickSize, voInterpolationType type,
                                 voExternalFormatType wanted);
/// Page 43: the same brick through a buffer of the program, and in place.
void convertThroughBuffer(char* fileName, voBrick* brick);
void convertInPlace(char* fileName, voBrick* brick);
/// Page 40: memory of the program in a brick's hands.
void lendMemory(voBrick* brick, unsigned char* memory);
/// Pages 41 and 147: a brick from raw images.
int readRaw(char** fileNames, voBrick* brick, int size);
/// Pages 45 to 47: the cube of five tetrahedra.
voIndexedTetraSet* makeCube(int size);
/// Pages 50 to 58: polygonizes with the matrices of OpenGL, sorts and draws. Returns the number of planes.
int drawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume,
               voInterleavedArrayType interleavedArrayFormat, int maxSamplesNumber, float samplingRate);
/// Pages 61 and 62: a table of 256 entries, entry j is 0.5 j / 256; loaded and enabled.
voLookupTable* enableTable(float* lookupEntries);
/// The same as a ramp; it replaces the entries.
void rampInstead(voLookupTable* aLookupTable);
/// Page 62: the table that the library suggests, of the preferred type.
voLookupTable* suggestedTable(voBrickSetCollection* aVolume, float* lookupEntries,
                              voLookupTableType preferred);
/// Pages 63 and 64: tests for an error after a call that fails, and through a handler; each returns what was
/// printed.
const char* testForError();
const char* handleError();
/// Page 65.
void cleanUp(voBrickSetCollection* aVolume, voIndexedTetraSet* aTetraSet);

// Chapter 6.

/// Pages 106 to 108: face sets that share vertices, filled, traversed, emptied, deleted. Writes the lines of
/// the loop that prints, and the numbers of vertices after filling and after emptying.
void useFaceSets(char* printed, int* vertexCounts);
/// Pages 109 and 110: a cube of 128 with a colour at each vertex.
voIndexedTetraSet* makeColouredCube();
/// Page 121: the plane z = height and a square at that height, cut to bricks; their areas.
void crossSections(voBrickSet* aBrickSet, float height, float* planeArea, float* polygonArea);
/// Pages 126 and 127: the voxels under a pixel in a set, or in one brick if there is one. Returns how many,
/// nearest first.
int pickVoxels(int x, int y, int windowSize, voIndexedTetraSet* tetraSet, voBrickSet* aBrickSet,
               voBrick* aBrick, unsigned char* voxels, float* positions);
void findCamera(GLdouble modelMatrix[16], GLdouble projMatrix[16], double eyePos[3], double viewDir[4],
                double onlyViewDir[3]);

// Chapter 7.

/// Pages 134, 135 and 144: allocated, read, converted and scaled, brick by brick.
void initializeVoxels(char* fileName, voBrickSet* aBrickSet, float loValue, float hiValue);
/// Pages 139 to 141: draws polygons with generated coordinates, rewritten ones, or a texture matrix.
void drawGenerated(voBrickSetCollection* aVolume, voIndexedFaceSet*** aPolygonSetArray, int samplesNumber,
                   voInterleavedArrayType interleavedArrayFormat);
void drawThroughTextureMatrix(voBrick* aBrick, voIndexedFaceSet* aFaceSet);
/// Page 136: interleaves two bricks, and says whether they were before and are after.
int interleave(voTexture3D* aBrick1, voTexture3D* aBrick2, int* before, int* after);
/// Page 141: sets sizes and gets them in both ways.
void brickSizes(voBrick* aBrick, int* sixInts, float* position, float* size);
/// Page 142.
void suggestBrickSizes(int xVolumeSize, int yVolumeSize, int zVolumeSize, int* sizes);
void drawOutline(voBrick* brick);
/// Page 143.
void selectStack(voBrickSetCollection* aBrickSetCollection, GLdouble modelMatrix[16],
                 GLdouble projMatrix[16]);
/// Page 145.
void loadAndBind(voTexture3D* aTexture3D);

// Chapter 8.

/// Pages 150 and 151: draws by a procedure of the program's own, plane by plane and tetrahedron by
/// tetrahedron.
void customDraw(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume);
/// Page 151: the sum of the bricks' origins along z, each times its place in the order of drawing from 1 on.
int visitInOrder(voBrickSetCollection* aVolume, GLdouble modelMatrix[16], GLdouble projMatrix[16]);
/// Pages 152 to 154: a plane cut with a tetrahedron, then with a brick's clip box.
void sliceAndClip(float planeEquation[4], float tetraVerts[4][3], voBrick* aBrick,
                  voIndexedFaceSet* aFaceSet);
/// Page 153: the same by the positive sides of ten planes.
void clipToTenPlanes(voVertexData* polygonVerts, float* planes, voIndexedFaceSet* aFaceSet);
/// Page 155.
void selectClosest(voBrickSetCollection* aVolume, GLdouble modelMatrix[16], GLdouble projMatrix[16]);
/// Page 156.
void drawWithMode(voIndexedFaceSet* aFaceSet, GLenum mode);
/// Page 151.
float projectedArea(voIndexedFaceSet* aFaceSet, GLdouble modelMatrix[16], GLdouble projMatrix[16],
                    GLint viewport[4]);

} // namespace DIALECT
