// Names that belong to applications: programs that descend from SGI's samples define them beside the face.
// ROW(B9) ROW(C7) of tests/contract/checklist.txt.

#define _GEOMETRY_
#define _voAppearance_h_
#define _voStatus_h_
// A macro of some platforms; it survives the headers, and they survive it.
#define NO_ERROR 30

class voGeometry
{
public:
    int tetras;
};
class voAppearance
{
public:
    int bricks;
};
class voAppearanceElement : public voAppearance
{
};
class voStatus
{
public:
    enum Code { OKAY };
};

#include <vo/Volumizer.h>

// The loaders of the guide (pages 40, 146) and what they call.
int myGetVolumeSizesIfl(char*, int& x, int&, int&, voExternalFormatType&, voDataType&)
{
    return x = 0;
}
int myReadBrickIfl(char*, void*, int, int, int, int, int, int, int, int, int)
{
    return 0;
}
int getTile()
{
    return 0;
}

int reservedNames()
{
    voGeometry geometry = {1};
    voAppearanceElement appearance;
    appearance.bricks = 2;
    voStatus::Code status = voStatus::OKAY;
    voIndexedTetraSet tetras(4, 3, 4);
    return geometry.tetras + appearance.bricks + status + tetras.getVertexData()->getCount() + getTile() +
           NO_ERROR;
}
