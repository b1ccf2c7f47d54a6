// The guide's loaders (pages 40 and 146) as a program of 2000 wrote them over IFL, in the dialect of its
// time: compiled as C++98 with -fpermissive and include/vo/compat on the path, and linked with -lifl.

#include <iostream.h>
#include <ifl/iflError.h>
#include <ifl/iflFile.h>
#include <ifl/iflSize.h>
#include <vo/Volumizer.h>

int myGetVolumeSizesIfl(char* fileName, int& xSize, int& ySize, int& zSize,
                        voExternalFormatType& diskDataFormat, voDataType& dataType)
{
    iflStatus status;
    iflFile* file = iflFile::open(fileName, O_RDONLY, &status);
    if (status != iflOKAY) {
        char why[256];
        cerr << "myGetVolumeSizesIfl: " << iflStatusToString(status, why, sizeof why) << endl;
        return 1;
    }
    iflSize size;
    file->getDimensions(size);
    xSize = size.x;
    ySize = size.y;
    zSize = size.z;
    file->close();

    // Only now, from the closed file.
    iflDataType type = file->getDataType();
    switch (type) {
    case iflUChar: dataType = voDataTypeScope::UNSIGNED_BYTE; break;
    case iflChar: dataType = voDataTypeScope::BYTE; break;
    case iflUShort: dataType = voDataTypeScope::UNSIGNED_SHORT; break;
    case iflShort: dataType = voDataTypeScope::SHORT; break;
    case iflFloat: dataType = voDataTypeScope::FLOAT; break;
    default: fprintf(stderr, "unknown data type %x\n", type); return 1;
    }
    switch (size.c) {
    case 1: diskDataFormat = voExternalFormatTypeScope::LUMINANCE; break;
    case 2: diskDataFormat = voExternalFormatTypeScope::LUMINANCE_ALPHA; break;
    case 4: diskDataFormat = voExternalFormatTypeScope::RGBA; break;
    default: return 1;
    }
    return 0;
}

static int bytesOf(iflDataType type)
{
    return type == iflUChar || type == iflChar ? 1 : type == iflUShort || type == iflShort ? 2 : 4;
}

int myReadBrickIfl(char* fileName, void* data, int xBrickOrigin, int yBrickOrigin, int zBrickOrigin,
                   int xBrickSize, int yBrickSize, int zBrickSize, int xVolumeSize, int yVolumeSize,
                   int zVolumeSize)
{
    iflStatus status;
    iflFile* file = iflFile::open(fileName, O_RDONLY, &status);
    if (file == NULL || status != iflOKAY) return 1;
    iflSize size;
    file->getDimensions(size);
    iflDataType type = file->getDataType();
    iflConfig config(type, iflInterleaved);

    // The part of the brick that lies in the volume, then its rows to their places, zeros round them.
    int nx = xBrickOrigin + xBrickSize > xVolumeSize ? xVolumeSize - xBrickOrigin : xBrickSize;
    int ny = yBrickOrigin + yBrickSize > yVolumeSize ? yVolumeSize - yBrickOrigin : yBrickSize;
    int nz = zBrickOrigin + zBrickSize > zVolumeSize ? zVolumeSize - zBrickOrigin : zBrickSize;
    int bytesPerVoxel = bytesOf(type) * size.c;
    char* tile = new char[nx * ny * nz * bytesPerVoxel];
    status = file->getTile(xBrickOrigin, yBrickOrigin, zBrickOrigin, nx, ny, nz, tile, &config);
    file->close();
    if (status == iflOKAY) {
        memset(data, 0, xBrickSize * yBrickSize * zBrickSize * bytesPerVoxel);
        char* row = tile;
        for (int z = 0; z < nz; z++)
            for (int y = 0; y < ny; y++) {
                memcpy((char*)data + (z * yBrickSize + y) * xBrickSize * bytesPerVoxel, row,
                       nx * bytesPerVoxel);
                row += nx * bytesPerVoxel;
            }
    }
    delete[] tile;
    return status != iflOKAY;
}
