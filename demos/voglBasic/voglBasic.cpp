// voglBasic: a volume from a file, drawn in grey or colour through a table, with 2D or 3D textures.
#include "voglMain.h"

#include "voglFrame.h"
#include "voglLookup.h"
#include "voglVolume.h"

const VoglProgram voglProgram = {
    .purpose = "Draws a volume in a window; with -output, or where there is no display, into a picture.",
    .example = "head.tif -color -lutFile brain.lut -view 0 180 -output head.png",
};

static VoglVolume volume;
static VoglPolygons* polygons;

voBrickSetCollection* my_InitAppearance(int, char** argv)
{
    volume = voglReadVolume(argv[0], voglOpenBlended(argv[0], argv[1]));
    return volume.bricks;
}

voIndexedTetraSet* my_InitGeometry(voBrickSetCollection*)
{
    voIndexedTetraSet* aTetraSet = voglBox(volume);
    polygons = new VoglPolygons(aTetraSet, volume, voInterleavedArrayTypeScope::V3F);
    return aTetraSet;
}

void my_InitGfx(voIndexedTetraSet*, voBrickSetCollection*)
{
    voglInitTextures(volume);
}

void my_DrawVolume(voIndexedTetraSet* aTetraSet, voBrickSetCollection* aVolume)
{
    voglDrawFrame(aTetraSet, aVolume, *polygons);
}

void my_Cleanup(voIndexedTetraSet* aTetraSet, voBrickSetCollection*)
{
    delete polygons;
    delete aTetraSet;
    deleteLookupTable();
    voglFreeVolume(volume);
}
